//! All files of a result folder, those in folders below it too.

use std::collections::BTreeMap;
use std::path::Path;

/// Their bytes by their paths inside the folder.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in std::fs::read_dir(folder).expect("a result folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() {
            all.extend(
                files(&entry.path()).into_iter().map(|(below, bytes)| (format!("{name}/{below}"), bytes)),
            );
        } else {
            all.insert(name, std::fs::read(entry.path()).expect("a file"));
        }
    }
    all
}
