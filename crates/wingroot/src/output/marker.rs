//! The list of its files that every result folder carries: by it a folder is known as wingroot's, and nothing else in it is
//! ever deleted.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use nastran::InputError;

use crate::failure::Failure;
use crate::fingerprint::Fingerprint;

/// The file that holds the list.
pub const MARKER: &str = "wingroot.files";
/// Its first line, before the version.
const HEADING: &str = "# Files of this result, with fingerprints; written by wingroot";

/// The files of a result with their fingerprints, by their paths inside its folder.
type Files = BTreeMap<String, String>;

/// Writes the list of all files of a folder into it.
///
/// # Errors
/// If the folder cannot be read or written.
pub(super) fn write(folder: &Path) -> Result<(), Failure> {
    let mut text = format!("{HEADING} {}\n", crate::version::VERSION);
    for (name, path) in files_below(folder).map_err(|error| refused(folder, &error))? {
        let fingerprint = Fingerprint::of_file(&path).map_err(|error| refused(&path, &error))?;
        let _ = writeln!(text, "{fingerprint} {name}");
    }
    let path = folder.join(MARKER);
    std::fs::write(&path, text).map_err(|error| refused(&path, &error))
}

/// Refuses a folder in which there is anything that wingroot did not write, or that was changed since.
///
/// # Errors
/// If nothing here may delete what is there.
pub fn check_replaceable(target: &Path) -> Result<(), Failure> {
    let help = "choose a new or empty folder with --out DIR";
    let Ok(mut entries) = std::fs::read_dir(target) else {
        return if target.exists() {
            let error = InputError::in_file(target, "a file stands where the result folder should be");
            Err(error.with_help(help).into())
        } else {
            Ok(())
        };
    };
    if entries.next().is_none() {
        return Ok(());
    }
    let Some(listed) = listed(target) else {
        let message = format!(
            "the folder holds files but no list of a result ({MARKER}), so nothing in it is replaced"
        );
        return Err(InputError::in_file(target, message).with_help(help).into());
    };
    let yours = not_ours(target, &listed).map_err(|error| refused(target, &error))?;
    let Some((first, more)) = yours.split_first() else { return Ok(()) };
    let others = if more.is_empty() { String::new() } else { format!(" and {} more", more.len()) };
    let message = format!(
        "{first}{others} in the result folder is not what wingroot wrote, so nothing in it is replaced"
    );
    let help = format!("move it elsewhere, or {help}");
    Err(InputError::in_file(target, message).with_help(help).into())
}

/// Removes the listed files of a result, and folders that are empty then; what else is there stays.
///
/// # Errors
/// If a file resists.
pub(super) fn remove(folder: &Path) -> std::io::Result<()> {
    for name in listed(folder).unwrap_or_default().keys() {
        match std::fs::remove_file(folder.join(name)) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    let _ = std::fs::remove_file(folder.join(MARKER));
    remove_empty(folder)
}

/// Removes a folder if there is no file below it.
fn remove_empty(folder: &Path) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)?.flatten() {
        if entry.file_type()?.is_dir() {
            remove_empty(&entry.path())?;
        }
    }
    // A folder with something in it stays.
    let _ = std::fs::remove_dir(folder);
    Ok(())
}

/// The list of a folder; none if it has none, or one that is not ours.
fn listed(folder: &Path) -> Option<Files> {
    let text = std::fs::read_to_string(folder.join(MARKER)).ok()?;
    let lines = text.strip_prefix(HEADING)?.lines().skip(1);
    Some(
        lines
            .filter_map(|line| line.split_once(' '))
            .map(|(print, name)| (name.to_owned(), print.to_owned()))
            .collect(),
    )
}

/// Files and empty folders that are not listed, and listed files that were changed.
fn not_ours(folder: &Path, listed: &Files) -> std::io::Result<Vec<String>> {
    let mut yours = Vec::new();
    for (name, path) in files_below(folder)? {
        let same = || {
            listed
                .get(&name)
                .is_some_and(|print| Fingerprint::of_file(&path).is_ok_and(|is| is.to_string() == *print))
        };
        if name != MARKER && !(path.is_file() && same()) {
            yours.push(name);
        }
    }
    Ok(yours)
}

/// All files below a folder, and folders that are empty, with their paths inside it; links are not followed.
fn files_below(folder: &Path) -> std::io::Result<Vec<(String, PathBuf)>> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        let entries = std::fs::read_dir(&next)?.collect::<Result<Vec<_>, _>>()?;
        if entries.is_empty() && next != folder {
            found.push(next.clone());
        }
        for entry in entries {
            if entry.file_type()?.is_dir() { folders.push(entry.path()) } else { found.push(entry.path()) }
        }
    }
    found.sort();
    let inside = |path: PathBuf| {
        let name = path.strip_prefix(folder).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        (name, path)
    };
    Ok(found.into_iter().map(inside).collect())
}

/// A folder or file of results that cannot be written.
pub(super) fn refused(path: &Path, error: &std::io::Error) -> Failure {
    let error = InputError::in_file(path, format!("the result cannot be written: {error}"));
    error.with_help("choose another folder with --out DIR").into()
}
