//! `fullaircraft --deck`, run as a user runs it on HA144A: its published trim in result.json, and refusals by exit status.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn wingroot(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts")
}

#[test]
fn the_deck_s_subcases_are_trimmed_as_published() {
    let out = std::env::temp_dir().join(format!("wingroot-deck-trim-{}", std::process::id()));
    let folder = out.to_string_lossy().into_owned();
    let deck = "data/published/decks/ha144a_fsw.bdf";
    let output = wingroot(&["fullaircraft", "--deck", deck, "--out", &folder, "--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    // MSC.Nastran Aeroelastic Analysis User's Guide, HA144A: angles of trim at 40 and 1200 psf
    for (at, alpha, elevator) in [(0, 0.169_191_0, 0.492_456_7), (1, 1.373_015e-3, 1.932_495e-2)] {
        let values = &result["subcases"][at]["values"];
        for (name, expected) in [("ANGLEA", alpha), ("ELEV", elevator)] {
            let value: f64 = values[name].as_f64().expect("a number");
            assert!((value / expected - 1.0).abs() < 2e-6, "{name}: {value} {expected}");
        }
    }
    assert!(out.join("boxes_trim_1.csv").is_file() && out.join("boxes_trim_2.csv").is_file());
    std::fs::remove_dir_all(&out).expect("our own folder");
    let output = wingroot(&["fullaircraft", "--deck", "data/tuflex/cases.ron", "--out", &folder]);
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
}
