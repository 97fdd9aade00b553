//! A kind of motion is one file and one line of a list: nothing else in the sources knows its name.

use maneuver::motion::KINDS;
use std::path::{Path, PathBuf};

/// Files that may name a kind beside its own: the list; what asks for an experiment; what fits measured doublets; the format
/// of an aircraft's file, which has one doublet and one chirp; and the blind truth, which has formulas of its own.
const MAY: [&str; 6] = [
    "crates/maneuver/src/motion/mod.rs",
    "crates/discover/src/next/menu.rs",
    "crates/maneuver/src/deflection_fit.rs",
    "crates/fullaircraft/src/aircraft/file.rs",
    "crates/hidden/src",
    "xtask/src/commands/bench_chirp.rs",
];

/// All but tests (`small` aircraft are theirs), which may fly what they like.
fn sources(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.file_stem().is_some_and(|stem| stem == "tests" || stem == "small") {
            continue;
        }
        if path.is_dir() {
            sources(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            into.push(path);
        }
    }
}

/// Whether code (no comment) has the name as a whole word.
fn names(text: &str, kind: &str) -> bool {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let mut words = code.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.any(|word| word == kind)
}

#[test]
fn a_kind_of_motion_is_named_in_its_file_and_in_the_list() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    // the second program reads maneuver files with formulas of its own
    let own = |folder: &std::fs::DirEntry| folder.file_name() != "truth";
    for folder in std::fs::read_dir(root.join("crates")).expect("crates").flatten().filter(own) {
        sources(&folder.path().join("src"), &mut files);
    }
    sources(&root.join("xtask/src"), &mut files);
    assert!(files.len() > 200, "all sources are looked at");
    // a step of a fit and a triangle of a mesh are other things
    for kind in KINDS.iter().filter(|kind| !["Step", "Triangle"].contains(kind)) {
        let mut own = Vec::new();
        for file in &files {
            let place =
                file.strip_prefix(&root).expect("below the root").to_string_lossy().replace('\\', "/");
            let text = std::fs::read_to_string(file).expect("a source");
            if names(&text, kind) && !MAY.iter().any(|may| place.starts_with(may)) {
                own.push(place);
            }
        }
        assert_eq!(own.len(), 1, "{kind}: {own:?}");
        assert!(own[0].starts_with("crates/maneuver/src/motion/"), "{kind}: {own:?}");
    }
}
