//! Rules for every source file of ours, and for every manifest.

use std::path::Path;

use super::complaint::{Complaint, files_below, named};
use wingroot::failure::Failure;

/// The most lines a source file may have.
const LINES: usize = 400;
/// Who makes them, or hands the file to who does.
const MAY_NAME_IT: [&str; 5] = [
    "crates/tunnel/",
    "crates/wingroot/src/commands/tunnel.rs",
    "crates/wingroot/src/paths.rs",
    "crates/wingroot/src/schemas.rs",
    "crates/wingroot/tests/",
];
/// The answers of the virtual wind tunnel, which nothing that analyses data may know of.
const TRUTH: &str = concat!("tunnel", ".ron");

/// Complaints about the files in `crates`, `xtask` and `tests`.
///
/// # Errors
/// If a file cannot be read.
pub fn check(root: &Path) -> Result<Vec<Complaint>, Failure> {
    let mut complaints = Vec::new();
    for path in ["crates", "xtask", "tests"].iter().flat_map(|folder| files_below(&root.join(folder))) {
        let name = named(root, &path);
        let kind = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        if !matches!(kind, "rs" | "md" | "toml" | "ron") {
            continue;
        }
        let text = nastran::read_text(&path)?;
        if kind == "rs" {
            complaints.extend(about_source(&name, &text));
        }
        if name.ends_with("/Cargo.toml") && !text.contains("[lints]\nworkspace = true") {
            complaints.push(Complaint::new(&name, "the manifest lacks `[lints] workspace = true`"));
        }
        let may_name_it = MAY_NAME_IT.iter().any(|place| name.starts_with(place));
        if name.starts_with("crates/") && !may_name_it && text.contains(TRUTH) {
            complaints
                .push(Complaint::new(&name, format!("mentions {TRUTH}, the virtual wind tunnel's answers")));
        }
    }
    Ok(complaints)
}

/// Complaints about one source file.
fn about_source(name: &str, text: &str) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    if !(text.starts_with("//!") || text.starts_with("#![doc")) {
        complaints.push(Complaint::new(name, "a file begins with `//!` and says what it is"));
    }
    let count = text.lines().count();
    if count > LINES {
        complaints
            .push(Complaint::new(name, format!("{count} lines; a file has one concept and at most {LINES}")));
    }
    // Tests may print what a reader of a failure wants to see; they stand below the code or in their own folder.
    let prints = name.starts_with("xtask/")
        || name.starts_with("crates/wingroot/")
        || name.ends_with("build.rs")
        || name.starts_with("tests/")
        || name.contains("/tests/");
    let tests_from = text.lines().position(|line| line.starts_with("#[cfg(test)]")).unwrap_or(usize::MAX);
    for (number, line) in text.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//")) {
        let place = format!("{name}:{}", number + 1);
        if line.contains(concat!("#[", "ignore")) {
            complaints
                .push(Complaint::new(&place, "a test that is skipped tests nothing: mend it or remove it"));
        }
        if !prints && number < tests_from && line.contains(concat!("print", "ln!")) {
            complaints.push(Complaint::new(&place, "only wingroot and xtask print"));
        }
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_broken_rule_is_found_with_its_line() {
        let bad = format!(
            "fn main() {{\n    {}\n}}\n{}\n",
            concat!("e", "print", "ln!();"),
            concat!("#[", "ignore]")
        );
        let found: Vec<String> =
            about_source("crates/a/src/b.rs", &bad).into_iter().map(|c| c.place).collect();
        assert_eq!(found, ["crates/a/src/b.rs", "crates/a/src/b.rs:2", "crates/a/src/b.rs:4"]);
        let long = format!("//! Long.\n{}", "\n".repeat(LINES));
        assert_eq!(about_source("tests/tests/c.rs", &long).len(), 1);
        assert!(about_source("crates/a/src/d.rs", "#![doc = \"x\"]\n").is_empty());
    }
}
