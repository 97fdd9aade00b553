//! What a user sees in a real terminal: a pseudo-terminal made by `script` (util-linux); skipped with a notice where there is none.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder with a wing of one's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("terminal-{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    let example = shipped::example("own_wing").expect("it ships");
    example.write(&folder).expect("a folder of our own");
    folder
}

/// What the program draws in a terminal, with its escapes; none if there is no `script`.
fn drawn(folder: &Path, arguments: &str, no_color: bool) -> Option<String> {
    let line = format!("'{}' {arguments}", env!("CARGO_BIN_EXE_wingroot"));
    let mut command = Command::new("script");
    command.args(["-qec", &line, "/dev/null"]).current_dir(folder).env("TERM", "xterm-256color");
    command.env_remove("NO_COLOR").env_remove("CI");
    if no_color {
        command.env("NO_COLOR", "1");
    }
    Some(String::from_utf8_lossy(&command.output().ok()?.stdout).into_owned())
}

#[test]
fn a_bad_input_is_red_in_a_terminal_and_plain_where_no_color_asks_for_it() {
    let folder = folder("bad");
    std::fs::write(folder.join("wing.ron"), "Wing(\n    name: 5,\n)\n").expect("a file");
    let Some(text) = drawn(&folder, "calibrate", false) else {
        println!("skipped: there is no `script` (util-linux) here to make a terminal");
        return;
    };
    // the first line is the program's own, not a complaint of its libraries
    assert!(text.lines().next().is_some_and(|line| line.contains("wing.ron (of this folder)")), "{text}");
    assert!(text.contains("\u{1b}[1m\u{1b}[31merror\u{1b}[0m: wing.ron:2:11"), "{text:?}");
    assert!(!text.contains("ANSI"), "{text}");
    let plain = drawn(&folder, "calibrate", true).unwrap_or_default();
    assert!(plain.contains("error: wing.ron:2:11") && !plain.contains("\u{1b}[31m"), "{plain:?}");
}

#[test]
fn a_long_computation_shows_the_share_done_and_the_time_left() {
    let folder = folder("bars");
    let Some(text) = drawn(&folder, "discover", false) else {
        println!("skipped: there is no `script` (util-linux) here to make a terminal");
        return;
    };
    for what in ["null campaigns", "candidates"] {
        assert!(text.contains(what), "{what}: {text:?}");
    }
    assert!(text.contains(" %  ") && text.contains("left"), "{text:?}");
    assert!(text.contains("results in out/discover"), "{text:?}");
    let quiet = drawn(&folder, "calibrate --quiet", false).unwrap_or_default();
    assert!(quiet.trim().is_empty(), "{quiet:?}");
}
