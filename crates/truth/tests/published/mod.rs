//! Published cases of `data/published`.

use std::path::Path;

/// A case by the name of its file.
pub(crate) fn case(folder: &Path, name: &str) -> serde_json::Value {
    let path = folder.join(format!("{name}.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
