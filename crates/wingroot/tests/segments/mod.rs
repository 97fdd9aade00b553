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
