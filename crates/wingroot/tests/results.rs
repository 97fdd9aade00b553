//! Results appear whole or not at all, and nothing that is no result is ever replaced.

use std::path::{Path, PathBuf};

use wingroot::failure::Failure;
use wingroot::output::ResultFolder;

/// A new folder for one test, removed at its end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("wingroot-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("the temporary folder is writable");
        Self(path)
    }

    fn entries(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).expect("the folder exists");
        let mut names: Vec<String> =
            entries.flatten().map(|e| e.file_name().to_string_lossy().into()).collect();
        names.sort();
        names
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn result(target: &Path, text: &str) -> ResultFolder {
    let folder = ResultFolder::begin(target).expect("the target may be written");
    folder.write_json("result.json", &serde_json::json!({ "command": text })).expect("written");
    folder
}

fn command(target: &Path) -> String {
    let text = std::fs::read_to_string(target.join("result.json")).expect("there is a result");
    let value: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
    value["command"].as_str().unwrap_or_default().to_string()
}

#[test]
fn a_result_appears_only_when_it_is_complete() {
    let scratch = Scratch::new("appears");
    let target = scratch.0.join("deep/calibrate");
    let folder = result(&target, "first");
    folder.write_text("figures/a.svg", "<svg/>").expect("written");
    assert!(!target.exists());
    folder.commit().expect("committed");
    assert_eq!(command(&target), "first");
    assert!(target.join("figures/a.svg").is_file());
}

#[test]
fn an_unfinished_command_leaves_the_earlier_result_and_nothing_else() {
    let scratch = Scratch::new("unfinished");
    let target = scratch.0.join("calibrate");
    result(&target, "first").commit().expect("committed");
    drop(result(&target, "second"));
    assert_eq!(command(&target), "first");
    assert_eq!(scratch.entries(), ["calibrate"]);
    result(&target, "third").commit().expect("committed");
    assert_eq!(command(&target), "third");
    assert_eq!(scratch.entries(), ["calibrate"]);
}

#[test]
fn folders_of_the_user_are_never_replaced() {
    let scratch = Scratch::new("user");
    std::fs::write(scratch.0.join("thesis.txt"), "years of work").expect("written");
    assert!(matches!(ResultFolder::begin(&scratch.0), Err(Failure::Input(_))));
    assert!(matches!(ResultFolder::begin(&scratch.0.join("thesis.txt")), Err(Failure::Input(_))));
    assert_eq!(scratch.entries(), ["thesis.txt"]);
}

#[test]
fn what_a_killed_command_left_is_cleared_and_its_set_aside_result_returns() {
    let scratch = Scratch::new("killed");
    let target = scratch.0.join("simulate");
    result(&target, "first").commit().expect("committed");
    // No process has this number: it is above the largest that Linux gives.
    std::fs::rename(&target, scratch.0.join(".simulate.before-4294967295")).expect("set aside");
    std::fs::create_dir_all(scratch.0.join(".simulate.partial-4294967295")).expect("left over");
    drop(ResultFolder::begin(&target).expect("may be written"));
    if Path::new("/proc/self").exists() {
        assert_eq!(scratch.entries(), ["simulate"]);
        assert_eq!(command(&target), "first");
    }
}

#[test]
fn a_number_that_is_not_finite_is_refused_with_its_key_and_the_earlier_result_stays() {
    let scratch = Scratch::new("finite");
    let target = scratch.0.join("calibrate");
    result(&target, "first").commit().expect("committed");
    let folder = result(&target, "second");
    let broken =
        serde_json::json!({ "command": "second", "airspeeds": [{ "rmse_after": { "Fz_N": f64::NAN } }] });
    match folder.write_json("result.json", &broken) {
        Err(Failure::Computation(message)) => {
            assert!(message.contains("`airspeeds/0/rmse_after/Fz_N`"), "{message}");
        }
        other => panic!("{other:?}"),
    }
    drop(folder);
    assert_eq!(command(&target), "first");
}

/// What is said of a folder that is not replaced.
fn refusal(target: &Path) -> String {
    match ResultFolder::begin(target) {
        Err(Failure::Input(error)) => error.message,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_file_of_the_users_in_an_earlier_result_stops_the_command_before_it_begins() {
    let scratch = Scratch::new("thesis");
    let target = scratch.0.join("calibrate");
    result(&target, "first").commit().expect("committed");
    std::fs::create_dir(target.join("notes")).expect("a folder");
    assert!(refusal(&target).starts_with("notes in the result folder is not what wingroot wrote"));
    std::fs::write(target.join("notes/thesis.txt"), "years of work").expect("written");
    std::fs::write(target.join("plot.py"), "print()").expect("written");
    assert!(refusal(&target).starts_with("notes/thesis.txt and 1 more in the result folder"));
    assert_eq!(command(&target), "first");
    std::fs::remove_dir_all(target.join("notes")).expect("removed");
    std::fs::remove_file(target.join("plot.py")).expect("removed");
    // and so does a change of what wingroot wrote
    std::fs::write(target.join("result.json"), "{}").expect("written");
    assert!(refusal(&target).starts_with("result.json in the result folder is not what wingroot wrote"));
}

#[test]
fn a_folder_with_any_result_json_is_no_result_of_ours() {
    let scratch = Scratch::new("unmarked");
    std::fs::write(scratch.0.join("result.json"), "{}").expect("written");
    std::fs::write(scratch.0.join("thesis.txt"), "years of work").expect("written");
    assert!(refusal(&scratch.0).contains("no list of a result"));
    assert_eq!(scratch.entries(), ["result.json", "thesis.txt"]);
}

#[test]
fn a_file_that_appears_while_the_command_works_survives_it() {
    let scratch = Scratch::new("meanwhile");
    let target = scratch.0.join("calibrate");
    result(&target, "first").commit().expect("committed");
    let second = result(&target, "second");
    std::fs::write(target.join("thesis.txt"), "years of work").expect("written");
    assert!(matches!(second.commit(), Err(Failure::Input(_))));
    assert_eq!(command(&target), "first");
    assert_eq!(std::fs::read_to_string(target.join("thesis.txt")).expect("it is there"), "years of work");
}

#[test]
fn incomplete_results_stand_beside_good_ones_until_the_next_good_ones() {
    let scratch = Scratch::new("incomplete");
    let target = scratch.0.join("calibrate");
    result(&target, "good").commit().expect("committed");
    let beside = result(&target, "stalled").commit_incomplete().expect("committed");
    assert_eq!(beside, scratch.0.join("calibrate.incomplete"));
    assert_eq!((command(&target), command(&beside)), ("good".into(), "stalled".into()));
    result(&target, "stalled again").commit_incomplete().expect("committed");
    assert_eq!((command(&target), command(&beside)), ("good".into(), "stalled again".into()));
    result(&target, "better").commit().expect("committed");
    assert_eq!(command(&target), "better");
    assert_eq!(scratch.entries(), ["calibrate"]);
}
