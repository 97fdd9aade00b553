//! `cargo xtask validate`, and a command of the program that is handed over.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs a task with its results in a folder of the test's own; the folder and what came of it.
fn run(name: &str, arguments: &[&str]) -> (PathBuf, Output) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.args(arguments).args(["--json", "--out"]).arg(&folder);
    command.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    let output = command.output().expect("the command starts");
    (folder, output)
}

#[test]
fn validate_shows_a_case_and_refuses_a_name_that_is_none() {
    let (folder, output) = run("validate", &["validate", "--only", "vlm__warren12"]);
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((&result["met"], &result["not_met"]), (&4.into(), &0.into()));
    assert!(folder.join("table.txt").is_file());
    let (_, output) = run("validate-none", &["validate", "--only", "nonsense"]);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn a_command_of_the_program_takes_the_shipped_example_and_says_so() {
    let (_, output) = run("modes", &["modes", "--count", "2"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(said.starts_with("note: wing: data/tuflex/wing.ron (the shipped example)"), "{said}");
}
