//! The tests of a package are one program: a file that its list forgets would never run.

use std::path::{Path, PathBuf};

use super::complaint::{Complaint, files_below, named};
use wingroot::failure::Failure;

/// The file that lists them.
const SUITE: &str = "suite.rs";

/// Complaints about files of tests that neither the package's suite lists nor its manifest makes a program of their own.
///
/// # Errors
/// If a manifest or a list cannot be read.
pub fn check(root: &Path) -> Result<Vec<Complaint>, Failure> {
    let mut complaints = Vec::new();
    for manifest in ["crates", "xtask", "tests"]
        .iter()
        .flat_map(|folder| files_below(&root.join(folder)))
        .filter(|path| path.ends_with("Cargo.toml"))
    {
        let folder = manifest.with_file_name("tests");
        let files = of_tests(&folder);
        if files.len() < 2 {
            continue;
        }
        let suite = folder.join(SUITE);
        let list = if suite.exists() { nastran::read_text(&suite)? } else { String::new() };
        let names: Vec<&str> = files.iter().filter_map(|file| file.file_stem()?.to_str()).collect();
        for name in forgotten(&names, &list, &nastran::read_text(&manifest)?) {
            let place = named(root, &folder.join(format!("{name}.rs")));
            complaints
                .push(Complaint::new(place, format!("runs only if {SUITE} beside it has `mod {name};`")));
        }
    }
    Ok(complaints)
}

/// The files directly in a folder of tests.
fn of_tests(folder: &Path) -> Vec<PathBuf> {
    let direct = files_below(folder).into_iter().filter(|path| path.parent() == Some(folder));
    direct.filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

/// Names of files that neither a list of modules nor a manifest's programs have.
fn forgotten<'n>(names: &[&'n str], list: &str, manifest: &str) -> Vec<&'n str> {
    let alone = |name: &str| manifest.contains(&format!("[[test]]\nname = \"{name}\"\n"));
    let listed = |name: &str| list.lines().any(|line| line == format!("mod {name};"));
    names.iter().copied().filter(|name| *name != "suite" && !listed(name) && !alone(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_no_list_has_is_found() {
        let list = "//! Tests.\n\nmod laws;\n// mod old;\n";
        let manifest = "autotests = false\n\n[[test]]\nname = \"alone\"\n\n[lints]\n";
        assert_eq!(forgotten(&["alone", "laws", "old", "suite"], list, manifest), ["old"]);
    }
}
