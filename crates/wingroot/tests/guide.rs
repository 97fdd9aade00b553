//! Every command of docs/guide.md runs, in its order, in a folder that knows nothing of the repository but its data.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A block of commands, and whether it is marked as slow.
struct Block {
    line: usize,
    text: String,
    slow: bool,
}

fn blocks(guide: &str) -> Vec<Block> {
    let mut found: Vec<Block> = Vec::new();
    let (mut inside, mut slow) = (false, false);
    for (number, line) in guide.lines().enumerate() {
        match line {
            "<!-- slow -->" => slow = true,
            "```sh" => {
                found.push(Block { line: number + 1, text: String::new(), slow });
                (inside, slow) = (true, false);
            }
            "```" => inside = false,
            line if inside => {
                let block = found.last_mut().expect("a block was begun");
                block.text.push_str(line);
                block.text.push('\n');
            }
            _ => {}
        }
    }
    found
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn every_command_of_the_guide_runs() {
    if Command::new("sh").args(["-c", "true"]).status().is_err() {
        println!("skipped: there is no sh here");
        return;
    }
    let guide = std::fs::read_to_string(repository().join("docs/guide.md")).expect("the guide");
    let all = blocks(&guide);
    assert!(all.len() >= 6, "the guide has {} blocks of commands", all.len());
    let folder = std::env::temp_dir().join(format!("wingroot-guide-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let with_slow = crate::slow::runs("runs the commands of the guide that take minutes");
    for block in all.iter().filter(|block| with_slow || !block.slow) {
        // `wingroot` is the program that was built with this test.
        let script = format!("set -eu\nwingroot() {{ \"$WINGROOT\" \"$@\"; }}\n{}", block.text);
        let output = Command::new("sh")
            .args(["-c", &script])
            .env("WINGROOT", env!("CARGO_BIN_EXE_wingroot"))
            .current_dir(&folder)
            .output()
            .expect("sh starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "docs/guide.md:{}: {said}", block.line);
        // A deck has cards that are not read; nothing else is worth a warning.
        let warns =
            said.lines().any(|line| line.contains("WARN") && !line.contains("cards that are not read"));
        assert!(!warns, "docs/guide.md:{} warns: {said}", block.line);
    }
    for result in ["calibrate", "calibrate_deck", "simulate_updated", "deck_20"] {
        assert!(folder.join("out/my_wing").join(result).join("result.json").is_file(), "{result}");
    }
    assert_what_the_guide_says(&folder);
    std::fs::remove_dir_all(&folder).expect("the temporary folder");
}

fn json(folder: &Path, name: &str) -> serde_json::Value {
    let path = folder.join("out/my_wing").join(name).join("result.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("a result")).expect("JSON")
}

/// The sentences of the guide that hold numbers.
fn assert_what_the_guide_says(folder: &Path) {
    let calibrated = json(folder, "calibrate");
    let deck = json(folder, "calibrate_deck");
    for (one, other) in calibrated["airspeeds"]
        .as_array()
        .into_iter()
        .flatten()
        .zip(deck["airspeeds"].as_array().into_iter().flatten())
    {
        assert_eq!(one["determined_directions"], 6);
        let undetermined = &one["identifiability"]["undetermined"];
        assert!(
            undetermined.as_array().is_some_and(|list| list.iter().any(|name| name == "moment")),
            "{undetermined}"
        );
        let left_out = |when: &str| one["left_out"][format!("objective_{when}")].as_f64().expect("a number");
        assert!(left_out("after") < 0.2 * left_out("before"), "{one}");
        // The deck is the same wing to the sixteen characters of its fields.
        let before = |result: &serde_json::Value| result["objective_before"].as_f64().expect("a number");
        assert!((before(one) - before(other)).abs() < 1e-5 * before(one), "{one} and {other}");
    }
    let left_out = &json(folder, "deck_20")["left_out"];
    let my = |which: &str| left_out[format!("root_loads_{which}")]["My_Nm"].as_f64().expect("a number");
    let change = (my("carried") / my("complete") - 1.0).abs();
    assert!((1e-4..1e-2).contains(&change), "My changes by {change}");
}

#[test]
fn a_folder_with_something_in_it_is_left_alone() {
    let folder = std::env::temp_dir().join(format!("wingroot-new-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let run = |name: &str| {
        Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(["new", name])
            .current_dir(&folder)
            .output()
            .expect("it starts")
    };
    std::fs::create_dir_all(folder.join("empty")).expect("a folder");
    assert!(run("empty").status.success());
    assert!(folder.join("empty/campaign/static.csv").is_file());
    std::fs::create_dir_all(folder.join("mine")).expect("a folder");
    std::fs::write(folder.join("mine/thesis.txt"), "years of work").expect("a file");
    for name in ["empty", "mine", "mine/thesis.txt"] {
        let refused = run(name);
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(said.contains("no empty folder") && said.contains("hint: "), "{said}");
        assert_eq!(said.lines().count(), 2, "{said}");
    }
    assert_eq!(std::fs::read_dir(folder.join("mine")).expect("a folder").count(), 1);
    std::fs::remove_dir_all(&folder).expect("the temporary folder");
}

#[test]
fn the_example_says_that_it_is_generated() {
    let data = repository().join("data/own_wing");
    for file in ["README.md", "campaign/README.md", "campaign/campaign.ron"] {
        let text = std::fs::read_to_string(data.join(file)).expect("a shipped file").to_lowercase();
        assert!(text.contains("generated"), "{file}");
    }
}
