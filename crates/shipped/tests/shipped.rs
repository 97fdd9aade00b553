//! What the program carries is what the repository's `data` holds.

use std::path::Path;

use shipped::EXAMPLES;

fn count(folder: &Path) -> usize {
    let entries = std::fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path());
    entries
        .filter(|path| !path.ends_with("made_with"))
        .map(|path| if path.is_dir() { count(&path) } else { 1 })
        .sum()
}

#[test]
fn every_example_is_its_folder_file_by_file() {
    for example in EXAMPLES {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(example.name);
        let files = example.files().expect("a sound archive");
        for (name, bytes) in &files {
            let here = std::fs::read(folder.join(name)).expect("the file of the repository");
            assert!(&here == bytes, "{}: {}", example.name, name.display());
        }
        assert_eq!(files.len(), count(&folder), "{}: files", example.name);
    }
}

#[test]
fn every_packed_folder_is_listed() {
    let script = include_str!("../build.rs");
    let packed: Vec<&str> = script.split('"').filter_map(|word| word.strip_prefix("data/")).collect();
    assert_eq!(packed.len(), EXAMPLES.len());
    assert!(EXAMPLES.iter().all(|example| packed.contains(&example.name)));
}
