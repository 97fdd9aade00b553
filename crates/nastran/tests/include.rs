//! INCLUDE: relative to the including file, in quotes or not, once and not in a circle.

use nastran::{InputError, read_deck};
use std::path::PathBuf;

/// A folder of its own for each test, emptied at the start.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::remove_dir_all(&folder).ok();
    for (file, text) in files {
        let path = folder.join(file);
        std::fs::create_dir_all(path.parent().expect("files are in the folder"))
            .expect("the folder is writable");
        std::fs::write(path, text).expect("the folder is writable");
    }
    folder
}

fn message(folder: &std::path::Path, error: &InputError) -> String {
    let text = format!("{}: {}", error.span.as_ref().expect("a place"), error.message);
    text.replace(&folder.display().to_string(), "DIR").replace('\\', "/")
}

#[test]
fn files_are_relative_to_the_file_that_includes_them() {
    let folder = folder(
        "relative",
        &[
            ("main.bdf", "SOL 101\nBEGIN BULK\nGRID,1\nINCLUDE 'parts/a.bdf'\nGRID,4\n"),
            ("parts/a.bdf", "GRID,2\ninclude \"b.b\n  df\" $ two lines\n"),
            ("parts/b.bdf", "GRID,3\nINCLUDE = c.bdf $ no quotes\n"),
            ("parts/c.bdf", "$ nothing\n"),
        ],
    );
    let deck = read_deck(&folder.join("main.bdf")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(deck.grids.keys().copied().collect::<Vec<_>>(), [1, 2, 3, 4]);
    assert!(deck.grids[&3].span.to_string().ends_with("parts/b.bdf:1:1"));
}

#[test]
fn enddata_in_an_included_file_ends_the_deck() {
    let folder =
        folder("enddata", &[("main.bdf", "INCLUDE 'a.bdf'\nGRID,2\n"), ("a.bdf", "GRID,1\nENDDATA\n")]);
    assert_eq!(read_deck(&folder.join("main.bdf")).expect("a good deck").grids.len(), 1);
}

#[test]
fn a_file_that_includes_itself_by_detours_is_refused() {
    let folder = folder(
        "circle",
        &[("main.bdf", "INCLUDE 'a.bdf'\n"), ("a.bdf", "$\nINCLUDE '../circle/main.bdf'\n")],
    );
    let error = read_deck(&folder.join("main.bdf")).unwrap_err();
    assert_eq!(
        message(&folder, &error),
        "DIR/a.bdf:2:1: DIR/../circle/main.bdf is read twice; first: DIR/main.bdf"
    );
}

#[test]
fn a_missing_file_blames_the_include() {
    let folder = folder("missing", &[("main.bdf", "GRID,1\nINCLUDE 'nowhere.bdf'\n")]);
    let error = read_deck(&folder.join("main.bdf")).unwrap_err();
    assert_eq!(
        message(&folder, &error),
        "DIR/main.bdf:2:1: the included file DIR/nowhere.bdf does not exist"
    );
    let error = read_deck(&folder.join("other.bdf")).unwrap_err();
    assert_eq!(message(&folder, &error), "DIR/other.bdf: the file does not exist");
}

#[test]
fn numbers_given_twice_name_both_files() {
    let folder = folder("twice", &[("main.bdf", "GRID,1\nINCLUDE 'a.bdf'\n"), ("a.bdf", "\nGRID,1,,.5\n")]);
    let error = read_deck(&folder.join("main.bdf")).unwrap_err();
    assert_eq!(
        message(&folder, &error),
        "DIR/a.bdf:2:6: GRID 1 is given twice; the number or name is taken since DIR/main.bdf:1:1"
    );
}

#[test]
fn includes_without_a_name_or_an_end_are_refused() {
    for (text, expected) in [
        ("INCLUDE\n", "t.bdf:1:1: INCLUDE without a file name"),
        ("INCLUDE ''\n", "t.bdf:1:1: INCLUDE without a file name"),
        ("INCLUDE 'a\nb\n", "t.bdf:1:1: the quoted file name of INCLUDE does not end"),
    ] {
        let error = nastran::parse_deck("t.bdf", text).unwrap_err();
        assert_eq!(format!("{}: {}", error.span.expect("a place"), error.message), expected);
    }
}
