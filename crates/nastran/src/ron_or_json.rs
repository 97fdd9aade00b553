//! Which of the two forms a file has, RON or JSON: its ending says it, and a folder has one of them.

use crate::source::InputError;
use std::path::{Path, PathBuf};

/// Whether a file is read as JSON: if its name ends in `.json`.
pub fn is_json(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"))
}

/// The file that a folder is known by: `NAME.ron`, or `NAME.json` if that is there instead; none if neither is.
///
/// # Errors
/// If both are there.
pub fn in_folder(folder: &Path, name: &str) -> Result<Option<PathBuf>, InputError> {
    let [ron, json] = ["ron", "json"].map(|ending| folder.join(format!("{name}.{ending}")));
    if ron.is_file() && json.is_file() {
        let message = format!("there is {name}.json beside it, and which of the two counts is not clear");
        return Err(InputError::in_file(&ron, message).with_help("keep one of them"));
    }
    Ok([ron, json].into_iter().find(|path| path.is_file()))
}

/// The same, `NAME.ron` if neither is there: for who reads it next and so says that it is missing.
///
/// # Errors
/// If both are there.
pub fn expected_in(folder: &Path, name: &str) -> Result<PathBuf, InputError> {
    Ok(in_folder(folder, name)?.unwrap_or_else(|| folder.join(format!("{name}.ron"))))
}
