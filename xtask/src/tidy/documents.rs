//! Documents that can go stale: ARCHITECTURE.md against the tree, and the origin of every folder of data.

use std::collections::BTreeSet;
use std::path::Path;

use super::complaint::{Complaint, files_below, named};
use super::imports::Package;
use wingroot::failure::Failure;

const ARCHITECTURE: &str = "ARCHITECTURE.md";

/// Complaints about paths that do not exist, crates and libraries that ARCHITECTURE.md passes over, and data
/// without an origin.
///
/// # Errors
/// If ARCHITECTURE.md cannot be read.
pub fn check(root: &Path, packages: &[Package]) -> Result<Vec<Complaint>, Failure> {
    let text = nastran::read_text(&root.join(ARCHITECTURE))?;
    let mut complaints = missing_paths(root, &text);
    for package in packages {
        let mut names: BTreeSet<&String> = package.theirs.iter().collect();
        names.insert(&package.name);
        for name in names.into_iter().filter(|name| !mentions(&text, name)) {
            let message = format!("does not mention `{name}`, which `{}` is or uses", package.name);
            complaints.push(Complaint::new(ARCHITECTURE, message));
        }
    }
    complaints.extend(data_without_origin(root));
    Ok(complaints)
}

fn mentions(text: &str, package: &str) -> bool {
    let folder = format!("`crates/{package}`");
    text.contains(&format!("`{package}`")) || text.contains(&folder)
}

/// Everything in backticks that looks like a path of this repository must exist.
fn missing_paths(root: &Path, text: &str) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let quoted = line.split('`').skip(1).step_by(2);
        for path in quoted.filter(|quoted| is_path(quoted)).filter(|path| !root.join(path).exists()) {
            let place = format!("{ARCHITECTURE}:{}", number + 1);
            complaints.push(Complaint::new(place, format!("`{path}` does not exist")));
        }
    }
    complaints
}

/// Has a slash or a file ending, and nothing that a path has not. `out/` is made by the commands.
fn is_path(text: &str) -> bool {
    let ending = [".md", ".toml", ".ron", ".rs", ".csv"].iter().any(|ending| text.ends_with(ending));
    let plain = text.chars().all(|c| c.is_ascii_alphanumeric() || "/._-".contains(c));
    plain && (text.contains('/') || ending) && !text.starts_with("out/") && text != "/"
}

/// Folders below `data` that hold files but no README.md with their origin.
fn data_without_origin(root: &Path) -> Vec<Complaint> {
    let files = files_below(&root.join("data"));
    let folders: BTreeSet<&Path> = files.iter().filter_map(|file| file.parent()).collect();
    let mut complaints = Vec::new();
    for folder in folders {
        let text = std::fs::read_to_string(folder.join("README.md")).unwrap_or_default().to_lowercase();
        if !(text.contains("source") || text.contains("provenance")) {
            let message = "the folder needs a README.md that names its source or provenance";
            complaints.push(Complaint::new(named(root, folder), message));
        }
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_told_from_code() {
        for path in ["crates/aero", "Cargo.toml", "xtask/src/tidy/mod.rs", ".ci/run"] {
            assert!(is_path(path), "{path}");
        }
        for other in ["cargo xtask", "nastran::BulkData", "out/calibrate", "A^-1", "q S", "K_delta"] {
            assert!(!is_path(other), "{other}");
        }
    }

    #[test]
    fn a_path_that_is_gone_is_found_with_its_line() {
        let root = crate::repository::root();
        let complaints = missing_paths(&root, "See `Cargo.toml`.\nAnd `crates/gone/lib.rs`, not `gone()`.\n");
        assert_eq!(complaints, [Complaint::new("ARCHITECTURE.md:2", "`crates/gone/lib.rs` does not exist")]);
    }
}
