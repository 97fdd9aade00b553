//! Bad days: a disk that is full, a command that is killed, a folder that cannot be written, another number of threads.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PROGRAM: &str = env!("CARGO_BIN_EXE_wingroot");

fn data(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name).display().to_string()
}

/// A folder for one test, removed at its end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("wingroot-lost-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("the temporary folder is writable");
        Self(path)
    }

    fn entries(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).expect("the folder exists").flatten();
        let mut names: Vec<String> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn calibrate(folder: &Path, before: &str) -> Output {
    let script =
        format!("{before} exec \"$0\" calibrate --wing \"$1\" --campaign \"$2\" --out result --quiet");
    Command::new("sh")
        .args(["-c", &script, PROGRAM, &data("own_wing/wing.ron"), &data("own_wing/campaign")])
        .current_dir(folder)
        .output()
        .expect("sh starts")
}

/// All files below a folder; of result.json without what the clock says.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() {
            found.extend(
                contents(&entry.path()).into_iter().map(|(inner, text)| (format!("{name}/{inner}"), text)),
            );
            continue;
        }
        let bytes = std::fs::read(entry.path()).expect("a file");
        let bytes = if name == "result.json" {
            let mut result: serde_json::Value = serde_json::from_slice(&bytes).expect("JSON");
            result.as_object_mut().expect("an object").remove("seconds");
            result.to_string().into_bytes()
        } else {
            bytes
        };
        // the list has the fingerprint of result.json, in which the clock is
        if name != "wingroot.files" {
            found.insert(name, bytes);
        }
    }
    found
}

#[test]
fn on_a_full_disk_the_earlier_result_stays_and_the_reason_is_said() {
    let scratch = Scratch::new("full");
    assert!(calibrate(&scratch.0, "").status.success());
    let earlier = contents(&scratch.0.join("result"));
    // No file may grow beyond 8 blocks of 512 bytes, and the system's signal is ignored: writing fails as on a full disk.
    let full = calibrate(&scratch.0, "trap '' XFSZ; ulimit -f 8;");
    let said = String::from_utf8_lossy(&full.stderr).into_owned();
    assert_eq!(full.status.code(), Some(2), "{said}");
    assert!(said.contains("the result cannot be written") && said.contains("hint: "), "{said}");
    assert_eq!(scratch.entries(), ["result"]);
    assert_eq!(contents(&scratch.0.join("result")), earlier);
}

#[test]
fn a_command_that_is_killed_while_it_writes_leaves_the_earlier_result() {
    let scratch = Scratch::new("killed");
    assert!(calibrate(&scratch.0, "").status.success());
    let earlier = contents(&scratch.0.join("result"));
    // The same, and the signal kills.
    let killed = calibrate(&scratch.0, "ulimit -f 8;");
    assert_eq!(killed.status.code(), None, "it was not killed");
    assert_eq!(contents(&scratch.0.join("result")), earlier);
    // What it left is cleared by the next.
    assert!(calibrate(&scratch.0, "").status.success());
    assert_eq!(scratch.entries(), ["result"]);
    assert_eq!(contents(&scratch.0.join("result")), earlier);
}

#[test]
fn where_nothing_can_be_written_nothing_is_and_the_folder_is_named() {
    let scratch = Scratch::new("device");
    let output = Command::new(PROGRAM)
        .args(["calibrate", "--wing", &data("own_wing/wing.ron"), "--campaign", &data("own_wing/campaign")])
        .args(["--out", "/dev/null/result"])
        .current_dir(&scratch.0)
        .output()
        .expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("/dev/null"), "{said}");
    assert!(scratch.entries().is_empty());
}

#[test]
fn results_are_the_same_to_the_byte_on_one_and_two_threads() {
    let scratch = Scratch::new("threads");
    let (wing, campaign) = (data("own_wing/wing.ron"), data("own_wing/campaign"));
    let corrections = scratch.0.join("corrections.ron").display().to_string();
    let of_wing = ["--wing", &wing, "--campaign", &campaign];
    let mav = data("mav");
    let commands: [(&str, Vec<&str>); 3] = [
        ("calibrate", of_wing.to_vec()),
        ("simulate", [&of_wing[..], &["--corrections", &corrections]].concat()),
        ("response", vec!["--data", &mav]),
    ];
    for (command, arguments) in commands {
        let results = ["1", "2"].map(|threads| {
            let out = scratch.0.join(format!("{command}_{threads}"));
            let output = Command::new(PROGRAM)
                .arg(command)
                .args(&arguments)
                .args(["--quiet", "--seed", "7", "--threads", threads, "--out"])
                .arg(&out)
                .output()
                .expect("it starts");
            assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
            assert!(output.stdout.is_empty() && output.stderr.is_empty(), "{command} is not quiet");
            contents(&out)
        });
        assert!(results[0].len() > 2, "{command} wrote {:?}", results[0].keys());
        for (name, text) in &results[0] {
            assert!(results[1].get(name) == Some(text), "{command}: {name} depends on the number of threads");
        }
        assert_eq!(results[0].len(), results[1].len());
        if command == "calibrate" {
            std::fs::copy(scratch.0.join("calibrate_1/corrections.ron"), &corrections)
                .expect("the corrections");
        }
    }
}
