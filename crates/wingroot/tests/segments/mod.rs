//! What stands in the store of a sweep, read without the program: whole lines of its segments.

use std::collections::BTreeMap;
use std::path::Path;

/// Results of finished cases by hash, of all segments of a folder; a last line without an end is still being written.
pub(crate) fn finished(folder: &Path) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
        if path.extension().is_none_or(|ending| ending != "segment") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a segment is text");
        let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
        for line in whole.lines().skip(1) {
            let parts: Vec<&str> = line.split('\t').collect();
            let &[_, hash, _, bytes, told, result] = &parts[..] else { panic!("{line}") };
            assert_eq!(bytes.parse(), Ok(told.len() + 1 + result.len()), "a line is half-written: {line}");
            all.entry(hash.to_owned()).or_insert_with(|| result.to_owned());
        }
    }
    all
}

/// What each finished case of a store is called, and its result; of a case that is there twice both.
pub(crate) fn told(folder: &Path) -> Vec<(String, serde_json::Value)> {
    let mut all = Vec::new();
    for path in std::fs::read_dir(folder).expect("a store").flatten().map(|entry| entry.path()) {
        if path.extension().is_none_or(|ending| ending != "segment") {
            continue;
        }
        for line in std::fs::read_to_string(&path).expect("a segment is text").lines().skip(1) {
            let parts: Vec<&str> = line.split('\t').collect();
            let json = |at: usize| serde_json::from_str::<serde_json::Value>(parts[at]).expect("JSON");
            all.push((json(4)["part"].as_str().expect("words").to_owned(), json(5)));
        }
    }
    all
}
