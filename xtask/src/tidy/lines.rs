//! How many lines of code there are: neither blank nor a comment, in `crates/*/src` and `xtask/src`.

use std::collections::BTreeMap;
use std::path::Path;

use super::complaint::{files_below, named};
use wingroot::failure::Failure;

/// Lines of code by crate.
///
/// # Errors
/// If a file cannot be read.
pub fn count(root: &Path) -> Result<BTreeMap<String, usize>, Failure> {
    let mut counts = BTreeMap::new();
    for path in ["crates", "xtask"].iter().flat_map(|folder| files_below(&root.join(folder))) {
        let name = named(root, &path);
        let Some((package, _)) =
            name.split_once("/src/").filter(|_| path.extension().is_some_and(|e| e == "rs"))
        else {
            continue;
        };
        let package = package.trim_start_matches("crates/").to_owned();
        *counts.entry(package).or_default() += lines_of_code(&nastran::read_text(&path)?);
    }
    Ok(counts)
}

/// Lines of a text that are neither blank nor begin with `//`.
pub fn lines_of_code(text: &str) -> usize {
    text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")).count()
}
