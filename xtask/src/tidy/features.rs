//! What `cargo xtask` and `pip install .` compile is what `cargo test --workspace` compiles: the same features of every library, or
//! cargo compiles it and all above it once more.

use std::collections::BTreeSet;
use std::path::Path;

use super::cargo;
use super::complaint::Complaint;
use wingroot::failure::Failure;

/// Packages that are built alone: the README's first command, the program, the Python package.
const ALONE: [&str; 3] = ["xtask", "wingroot", "wingroot-python"];

/// Complaints about libraries with other features when a package is built alone than among the tests of all.
///
/// # Errors
/// If `cargo tree` does not run.
pub fn check(root: &Path) -> Result<Vec<Complaint>, Failure> {
    let together = libraries(root, &["--workspace", "--edges", "normal,build,dev"])?;
    let mut complaints = Vec::new();
    for package in ALONE {
        let alone = libraries(root, &["--package", package, "--edges", "normal,build"])?;
        complaints.extend(apart(package, &alone, &together));
    }
    Ok(complaints)
}

/// Complaints about what is compiled for one package alone, but not with all others.
fn apart(package: &str, alone: &BTreeSet<String>, together: &BTreeSet<String>) -> Vec<Complaint> {
    let complaint = |library: &String| {
        let features = format!("alone it asks for {library}, with all tests for other features");
        Complaint::new(package, format!("{features}: name them in crates/wingroot/Cargo.toml"))
    };
    alone.difference(together).map(complaint).collect()
}

/// Every library with its version and features.
fn libraries(root: &Path, which: &[&str]) -> Result<BTreeSet<String>, Failure> {
    let every = ["tree", "--offline", "--prefix", "none", "--format", "{p} [{f}]"];
    let said = cargo::said(root, &[&every[..], which].concat())?;
    Ok(String::from_utf8_lossy(&said).lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_with_other_features_is_found() {
        let set = |list: &[&str]| list.iter().map(ToString::to_string).collect::<BTreeSet<String>>();
        let together = set(&["a v1 [std]", "b v2 []", "c v3 []"]);
        assert!(apart("xtask", &set(&["b v2 []"]), &together).is_empty());
        let found = apart("xtask", &set(&["a v1 []", "c v3 []"]), &together);
        assert_eq!(found.len(), 1);
        assert!(found[0].to_string().contains("a v1 []"), "{}", found[0]);
    }
}
