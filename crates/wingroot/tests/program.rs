//! The program by itself: a copied binary in an empty folder, without the repository and without cargo.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::{Mutex, PoisonError};

/// Held while a copy is written and while a program is started: a process that another test starts meanwhile inherits
/// the file that is open for writing, and the kernel runs no program that somebody has open so ("text file busy").
static COPY_OR_START: Mutex<()> = Mutex::new(());

/// A folder for one test with a copy of the program.
fn copied(name: &str) -> PathBuf {
    let _alone = COPY_OR_START.lock().unwrap_or_else(PoisonError::into_inner);
    let folder = std::env::temp_dir().join(format!("wingroot-program-{name}-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    std::fs::copy(env!("CARGO_BIN_EXE_wingroot"), folder.join("wingroot")).expect("a copy");
    folder
}

/// Runs the copy in a folder below its own, with nothing of this machine in its environment.
fn run(program: &Path, folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).env_clear();
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let started = {
        let _alone = COPY_OR_START.lock().unwrap_or_else(PoisonError::into_inner);
        command.spawn().expect("the program starts")
    };
    started.wait_with_output().expect("the program ends")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Names of what is in a folder.
fn entries(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder").flatten();
    let mut names: Vec<String> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_new_wing_is_calibrated_searched_and_flown_and_all_results_are_below_it() {
    let base = copied("story");
    let program = base.join("wingroot");
    assert!(run(&program, &base, &["new", "my_wing"]).status.success());
    let wing = base.join("my_wing");
    for command in ["calibrate", "discover", "fullaircraft"] {
        let output = run(&program, &wing, &[command]);
        assert!(output.status.success(), "{command}: {}", said(&output));
        // what was not named is said first
        let first = said(&output).lines().next().unwrap_or_default().to_owned();
        let expected = if command == "fullaircraft" { "note: aircraft: " } else { "note: wing: wing.ron" };
        assert!(first.starts_with(expected), "{command}: {first}");
        let page =
            std::fs::read_to_string(wing.join("out").join(command).join("report.html")).expect("a page");
        assert!(page.contains("Taken without being named"), "{command}");
    }
    assert_eq!(entries(&base), ["my_wing", "wingroot"]);
    assert_eq!(entries(&wing.join("out")), ["calibrate", "discover", "fullaircraft"]);
    std::fs::remove_dir_all(&base).expect("a temporary folder");
}

#[test]
fn every_example_is_unpacked_and_its_first_command_runs() {
    let base = copied("examples");
    let program = base.join("wingroot");
    for (example, command) in [
        ("weber_brebner", &["calibrate"][..]),
        ("pazy", &["calibrate", "--campaign", "tip_5deg"]),
        ("mav", &["response"]),
        ("tuflex", &["modes", "--wing", "wing_beam.ron"]),
    ] {
        assert!(run(&program, &base, &["new", example, "--example", example]).status.success());
        let output = run(&program, &base.join(example), command);
        assert!(output.status.success(), "{example}: {}", said(&output));
    }
    std::fs::remove_dir_all(&base).expect("a temporary folder");
}

#[test]
fn nobody_elses_data_is_taken() {
    let base = copied("defaults");
    let program = base.join("wingroot");
    for (command, missing) in [
        ("calibrate", "no wing given"),
        ("simulate", "no wing given"),
        ("discover", "no wing given"),
        ("flutter", "no wing given"),
        ("modes", "no wing given"),
        ("pipeline", "no wing given"),
        ("fullaircraft", "no aircraft given"),
        ("tunnel", "no runs given"),
        ("response", "no data given"),
        ("free", "no rig given"),
    ] {
        let output = run(&program, &base, &[command]);
        assert_eq!(output.status.code(), Some(2), "{command}: {}", said(&output));
        assert!(said(&output).contains(missing) && said(&output).contains("hint: "), "{}", said(&output));
    }
    // a wing without measurements beside it
    assert!(run(&program, &base, &["new", "w"]).status.success());
    std::fs::rename(base.join("w/campaign"), base.join("w/elsewhere")).expect("renamed");
    let output = run(&program, &base, &["calibrate", "--wing", "w/wing.ron"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("there is w/elsewhere"), "{}", said(&output));
    assert_eq!(entries(&base), ["w", "wingroot"]);
    std::fs::remove_dir_all(&base).expect("a temporary folder");
}

#[test]
fn completions_manual_pages_and_the_version_are_there() {
    let base = copied("manual");
    let program = base.join("wingroot");
    let text =
        |arguments: &[&str]| String::from_utf8_lossy(&run(&program, &base, arguments).stdout).into_owned();
    assert!(text(&["--version"]).contains("commit "), "{}", text(&["--version"]));
    for (shell, word) in
        [("bash", "_wingroot()"), ("zsh", "#compdef wingroot"), ("fish", "complete -c wingroot")]
    {
        let script = text(&["completions", shell]);
        assert!(script.contains(word) && script.contains("accept-unconverged"), "{shell}");
    }
    assert!(run(&program, &base, &["man", "man1"]).status.success());
    let pages = entries(&base.join("man1"));
    assert!(pages.contains(&"wingroot.1".to_owned()) && pages.contains(&"wingroot-calibrate.1".to_owned()));
    std::fs::remove_dir_all(&base).expect("a temporary folder");
}
