//! No published case is forgotten: each file of data/published is computed or listed with the reason.

use std::collections::BTreeSet;
use validation::registry::{LISTED, cases};

#[test]
fn every_published_case_is_computed_or_listed() {
    let folder = std::fs::read_dir(validation::data("published")).expect("the folder of published cases");
    let files: BTreeSet<String> = folder
        .map(|entry| entry.expect("an entry of the folder").file_name().to_string_lossy().into_owned())
        .filter_map(|name| name.strip_suffix(".json").map(str::to_string))
        .collect();
    let names = cases().map(|case| case.file).chain(LISTED.iter().map(|(file, _)| *file));
    let mut known = BTreeSet::new();
    for name in names {
        assert!(known.insert(name.to_string()), "{name} is there twice");
    }
    assert_eq!(files, known);
}
