//! A copy of the repository whose crate has its mutants behind switches, built once.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use wingroot::failure::Failure;

use super::listed::Mutant;
use super::switched::{SWITCH, asked_for, switched};
use crate::repository;

/// A crate's test programs with the mutants that could be put behind switches.
pub(super) struct Built {
    /// Test programs, as `cargo test` would run them.
    pub(super) programs: Vec<PathBuf>,
    /// Where they run: the crate's folder in the copy.
    pub(super) folder: PathBuf,
    /// Numbers of the mutants that are in them.
    pub(super) inside: BTreeSet<usize>,
}

/// Copies the tree, puts the mutants in and builds; those that do not compile are taken out again.
///
/// # Errors
/// If files cannot be copied, or what is left without the mutants that do not compile does not compile.
pub(super) fn built(name: &str, mutants: &[Mutant]) -> Result<Built, Failure> {
    let tree = repository::path("target/mutants/tree");
    copied(&tree)?;
    let mut inside: BTreeSet<usize> = (0..mutants.len()).collect();
    loop {
        let texts = written(&tree, name, mutants, &mut inside)?;
        let (programs, errors) = compiled(&tree, name)?;
        if errors.is_empty() {
            let folder = tree.join("crates").join(name);
            return Ok(Built { programs, folder, inside });
        }
        let asked = errors.iter().flat_map(|error| {
            texts.get(&error.file).map_or(Vec::new(), |text| asked_for(text, &error.lines))
        });
        let taken: BTreeSet<usize> = asked.collect();
        if taken.is_disjoint(&inside) {
            let said: Vec<&str> = errors.iter().map(|error| error.said.as_str()).collect();
            return Err(Failure::Computation(format!(
                "{name} with switches does not compile:\n{}",
                said.join("\n")
            )));
        }
        inside.retain(|number| !taken.contains(number));
    }
}

/// What git knows of, or would take, written only where it differs: what is compiled stays.
fn copied(tree: &Path) -> Result<(), Failure> {
    let listed = Command::new("git")
        .current_dir(repository::path("."))
        .args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"])
        .output()
        .map_err(text_of)?;
    let listed = String::from_utf8_lossy(&listed.stdout);
    let there: BTreeSet<PathBuf> = listed
        .split_terminator('\0')
        .filter(|name| repository::path(name).is_file())
        .map(|name| tree.join(name))
        .collect();
    remove_others(&tree.join("crates"), &there)?;
    for name in listed.split_terminator('\0') {
        if let Ok(bytes) = std::fs::read(repository::path(name)) {
            write(&tree.join(name), &bytes)?;
        }
    }
    Ok(())
}

/// Removes sources of an earlier copy that are gone: a module found in two places does not compile.
fn remove_others(folder: &Path, there: &BTreeSet<PathBuf>) -> Result<(), Failure> {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            remove_others(&path, there)?;
        } else if path.extension().is_some_and(|ending| ending == "rs") && !there.contains(&path) {
            std::fs::remove_file(&path).map_err(text_of)?;
        }
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if std::fs::read(path).is_ok_and(|there| there == bytes) {
        return Ok(());
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(text_of)?;
    }
    std::fs::write(path, bytes).map_err(text_of)
}

/// Writes the crate's files with switches; leaves out of `inside` what has no place. Texts by name of the file.
fn written(
    tree: &Path,
    name: &str,
    mutants: &[Mutant],
    inside: &mut BTreeSet<usize>,
) -> Result<BTreeMap<String, String>, Failure> {
    let root = format!("crates/{name}/src/lib.rs");
    let mut files: BTreeMap<&str, Vec<(usize, &Mutant)>> = BTreeMap::from([(root.as_str(), Vec::new())]);
    for (number, mutant) in mutants.iter().enumerate() {
        let of_file = files.entry(&mutant.file).or_default();
        if inside.contains(&number) {
            of_file.push((number, mutant));
        }
    }
    inside.clear();
    let mut texts = BTreeMap::new();
    for (file, mutants) in files {
        let text = nastran::read_text(&repository::path(file))?;
        let (mut text, found) = switched(&text, &mutants).map_err(text_of)?;
        inside.extend(found);
        if file == root {
            text.push_str(SWITCH);
        }
        write(&tree.join(file), text.as_bytes())?;
        texts.insert(file.to_owned(), text);
    }
    Ok(texts)
}

/// Something that the compiler refuses.
struct Refused {
    file: String,
    /// Lines from zero.
    lines: std::ops::Range<usize>,
    said: String,
}

/// Builds the crate's tests: their programs, or what is refused.
fn compiled(tree: &Path, name: &str) -> Result<(Vec<PathBuf>, Vec<Refused>), Failure> {
    let target = std::path::absolute(repository::path("target/mutants/build")).map_err(text_of)?;
    let output = Command::new("cargo")
        .current_dir(tree)
        .args(["build", "--package", &format!("wingroot-{name}"), "--tests", "--keep-going"])
        .args(["--message-format=json", "--quiet", "--profile", "mutants"])
        .env("CARGO_TARGET_DIR", target)
        .output()
        .map_err(text_of)?;
    let lines = String::from_utf8_lossy(&output.stdout).into_owned();
    let messages: Vec<Value> = lines.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    let programs = messages.iter().filter_map(|message| message["executable"].as_str().map(PathBuf::from));
    let refused: Vec<Refused> = messages.iter().flat_map(refused).collect();
    if refused.is_empty() && !output.status.success() {
        return Err(Failure::Computation(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    Ok((programs.collect(), refused))
}

/// Where an error of the compiler stands.
fn refused(message: &Value) -> Vec<Refused> {
    let message = &message["message"];
    if message["level"] != "error" {
        return Vec::new();
    }
    let said = message["rendered"].as_str().unwrap_or_default();
    let line = |span: &Value, key: &str| span[key].as_u64().map(|line| usize::try_from(line).unwrap_or(0));
    let spans = message["spans"].as_array().into_iter().flatten().filter(|span| span["is_primary"] == true);
    spans
        .map(written_at)
        .filter_map(|span| {
            Some(Refused {
                file: span["file_name"].as_str()?.to_owned(),
                lines: line(span, "line_start")? - 1..line(span, "line_end")?,
                said: said.to_owned(),
            })
        })
        .collect()
}

/// Where the source says what a compiler's span is about: the call of a macro, not what it stands for.
fn written_at(span: &Value) -> &Value {
    let call = &span["expansion"]["span"];
    if call.is_null() { span } else { written_at(call) }
}

fn text_of(error: impl std::fmt::Display) -> Failure {
    Failure::Computation(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn an_error_in_a_macro_is_where_the_macro_is_called() {
        let place =
            |file: &str, line: u32| json!({ "file_name": file, "line_start": line, "line_end": line });
        let mut inside = place("library/alloc/src/macros.rs", 40);
        inside["is_primary"] = json!(true);
        inside["expansion"] = json!({ "span": place("crates/coupling/src/readings.rs", 92) });
        let message = json!({ "message": { "level": "error", "rendered": "not Copy", "spans": [inside] } });
        let found = refused(&message);
        assert_eq!(found.len(), 1);
        assert_eq!(
            (found[0].file.as_str(), found[0].lines.clone()),
            ("crates/coupling/src/readings.rs", 91..92)
        );
    }
}
