//! The worked examples of CONTRIBUTING.md fit the sources: every list line finds its place, and with `RUN_SLOW_TESTS` a copy of the
//! sources with all of them compiles and keeps the house rules.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a block of the document does to the sources.
enum Step {
    NewFile { path: String, text: String },
    Line { path: String, anchor: String, instead: bool, text: String },
}

fn steps(document: &str) -> Vec<Step> {
    let blocks = document.split("\n```rust\n").skip(1).filter_map(|rest| rest.split("\n```").next());
    let step = |block: &str| {
        let (head, text) = block.split_once('\n').expect("a block has a head");
        if let Some(path) = head.strip_prefix("// new file: ") {
            return Step::NewFile { path: path.to_owned(), text: format!("{text}\n") };
        }
        let (path, place) = head
            .strip_prefix("// in ")
            .and_then(|head| head.split_once(", "))
            .unwrap_or_else(|| panic!("`{head}` says neither `// new file:` nor `// in FILE, after:`"));
        let (word, anchor) = place.split_once(": ").expect("a place");
        assert!(["after", "instead of"].contains(&word), "{head}");
        Step::Line {
            path: path.to_owned(),
            anchor: anchor.to_owned(),
            instead: word == "instead of",
            text: text.to_owned(),
        }
    };
    blocks.map(step).collect()
}

/// The text with the step done; fails unless the anchor is exactly one line of it.
fn with_line(text: &str, path: &str, anchor: &str, instead: bool, added: &str) -> String {
    let count = text.lines().filter(|line| *line == anchor).count();
    assert_eq!(count, 1, "CONTRIBUTING.md names `{anchor}` of {path}, which is {count} of its lines");
    let mut out = String::new();
    for line in text.lines() {
        if line != anchor || !instead {
            let _ = writeln!(out, "{line}");
        }
        if line == anchor {
            let _ = writeln!(out, "{added}");
        }
    }
    out
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn document() -> String {
    fs::read_to_string(repository().join("CONTRIBUTING.md")).expect("the document")
}

fn apply(root: &Path, steps: &[Step]) {
    for step in steps {
        match step {
            Step::NewFile { path, text } => {
                assert!(!root.join(path).exists(), "{path} is there already");
                fs::write(root.join(path), text).expect("the folder of a new file is there");
            }
            Step::Line { path, anchor, instead, text } => {
                let before = fs::read_to_string(root.join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
                fs::write(root.join(path), with_line(&before, path, anchor, *instead, text))
                    .expect("written");
            }
        }
    }
}

/// Copies what git tracks or would track of a folder, without results.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder").flatten() {
        let name = entry.file_name();
        let hidden = name.to_string_lossy().starts_with('.') && name != ".cargo";
        if hidden || name == "target" || name == "out" {
            continue;
        }
        if entry.path().is_dir() {
            copy(&entry.path(), &to.join(name));
        } else {
            fs::copy(entry.path(), to.join(name)).expect("a file is copied");
        }
    }
}

#[test]
fn every_worked_example_finds_its_place() {
    let steps = steps(&document());
    let new = steps.iter().filter(|step| matches!(step, Step::NewFile { .. })).count();
    assert!(new >= 5, "an element (card and element), an effect, a maneuver, a command: {new} new files");
    for step in &steps {
        match step {
            Step::NewFile { path, .. } => {
                assert!(!repository().join(path).exists(), "{path} is there already");
            }
            Step::Line { path, anchor, instead, text } => {
                let before =
                    fs::read_to_string(repository().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
                assert!(with_line(&before, path, anchor, *instead, text).contains(text));
            }
        }
    }
}

#[test]
fn a_copy_with_all_worked_examples_compiles() {
    if std::env::var_os("RUN_SLOW_TESTS").is_none() {
        println!("skipped: RUN_SLOW_TESTS=1 compiles a copy of the sources with the worked examples");
        return;
    }
    let root = std::env::temp_dir().join(format!("wingroot-contributing-{}", std::process::id()));
    copy(&repository(), &root);
    apply(&root, &steps(&document()));
    // beside what lints have checked of the dependencies; flags of the compiler would have all of those checked again
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("it is below the target folder");
    let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["check", "--offline", "--workspace"])
        .env("CARGO_TARGET_DIR", target)
        .current_dir(&root)
        .output()
        .expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && !said.contains("warning"), "{said}");
    fs::remove_dir_all(&root).expect("the copy");
}

#[test]
#[should_panic(expected = "which is 0 of its lines")]
fn a_line_that_is_gone_is_found() {
    with_line("one\ntwo\n", "list.rs", "three", false, "four");
}
