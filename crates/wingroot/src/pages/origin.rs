//! What was run, and the fingerprints of what was read.

use std::path::{Path, PathBuf};

use nastran::InputError;
use report::page::Input;

use crate::fingerprint::Fingerprint;
use crate::paths;
use crate::sweep::lines::of_all_cases;

/// Options that say where results go and how, not what they are.
const WHERE: [&str; 2] = ["--out", "--threads"];
const HOW: [&str; 2] = ["--json", "--quiet"];

/// A file or folder as an input; files of a folder count with their names, in their order.
///
/// # Errors
/// If it cannot be read.
pub fn input(what: &str, path: &Path) -> Result<Input, InputError> {
    // the folder of a bare file name
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    let refused = |path: &Path, error: &std::io::Error| {
        InputError::in_file(path, format!("cannot be read for its fingerprint: {error}"))
    };
    let mut print = Fingerprint::default();
    if path.is_dir() {
        let entries = std::fs::read_dir(path).map_err(|e| refused(path, &e))?;
        let mut files: Vec<PathBuf> =
            entries.flatten().map(|entry| entry.path()).filter(|p| p.is_file()).collect();
        files.sort();
        for file in files {
            let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            print = print.with(name.as_bytes()).with(&std::fs::read(&file).map_err(|e| refused(&file, &e))?);
        }
    } else {
        print = print.with(&std::fs::read(path).map_err(|e| refused(path, &e))?);
    }
    Ok(Input { what: what.into(), path: shown(path), fingerprint: print.to_string() })
}

/// The path from the folder where one works, if it is below it.
fn shown(path: &Path) -> String {
    let here = std::env::current_dir().unwrap_or_default();
    path.strip_prefix(&here).unwrap_or(path).display().to_string()
}

/// The line that was run, without what does not change results, and the version.
pub(super) fn lines() -> Vec<(String, String)> {
    let mut words = vec!["wingroot".to_owned()];
    let mut skip = false;
    let given = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    for word in of_all_cases(given) {
        let name = word.split('=').next().unwrap_or_default();
        if skip || HOW.contains(&name) {
            skip = false;
        } else if WHERE.contains(&name) {
            skip = !word.contains('=');
        } else {
            words.push(if word.contains(' ') { format!("'{word}'") } else { word });
        }
    }
    let mut lines = vec![
        ("Command".into(), words.join(" ")),
        ("Version".into(), format!("wingroot {}", crate::version::VERSION)),
    ];
    lines.extend(paths::taken().into_iter().map(|taken| ("Taken without being named".into(), taken)));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fingerprint_changes_with_any_file_of_a_folder() {
        let folder = std::env::temp_dir().join(format!("wingroot-origin-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("a.csv"), "1").unwrap();
        let of = || input("campaign", &folder).unwrap().fingerprint;
        let first = of();
        std::fs::write(folder.join("b.csv"), "2").unwrap();
        let second = of();
        std::fs::write(folder.join("b.csv"), "3").unwrap();
        let third = of();
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(first != second && second != third && first != third);
        assert!(input("campaign", &folder).is_err());
    }
}
