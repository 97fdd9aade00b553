//! `fullaircraft --deck`, run as a user runs it on HA144A: its published trim in result.json, and refusals by exit status.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// `fullaircraft --deck`, from the root of the repository.
fn trimmed(deck: &Path, out: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["fullaircraft", "--json", "--deck"])
        .arg(deck)
        .arg("--out")
        .arg(out)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts")
}

#[test]
fn the_deck_s_subcases_are_trimmed_as_published() {
    let out = std::env::temp_dir().join(format!("wingroot-deck-trim-{}", std::process::id()));
    let output = trimmed(Path::new("data/published/decks/ha144a_fsw.bdf"), &out);
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
    let output = trimmed(Path::new("data/tuflex/cases.ron"), &out);
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
}

/// MSC's HA144B: dynamic pressures of antisymmetric divergence (psi) at Mach 0, asked for without a trim.
#[test]
fn a_deck_that_asks_for_divergence_alone_has_its_dynamic_pressures_as_printed() {
    let base = std::env::temp_dir().join(format!("wingroot-deck-diverg-{}", std::process::id()));
    std::fs::create_dir_all(&base).expect("a temporary folder");
    let decks = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks");
    std::fs::copy(decks.join("bah_wing.inc"), base.join("bah_wing.inc")).expect("a deck of ours");
    let deck = std::fs::read_to_string(decks.join("ha144b_bah_roll.bdf")).expect("a deck of ours");
    let run = |text: &str| {
        let path = base.join("diverg.bdf");
        std::fs::write(&path, text).expect("a temporary file");
        trimmed(&path, &base.join("out"))
    };
    let asks = deck.replace("TRIM = 1", "DIVERG = 9").replace("TRIM = 2", "DIVERG = 10");
    let cards = "DIVERG,9,5,0.\nDIVERG,10,,0.,.5\nENDDATA";
    let output = run(&asks.replace("ENDDATA", cards));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    assert_eq!(result["subcases"], serde_json::json!([]));
    let q = |at: usize| -> Vec<f64> {
        serde_json::from_value(result["divergences"][at]["q"].clone()).expect("pressures")
    };
    for (ours, printed) in q(0).into_iter().zip([23.7347, 111.8315, 367.5739, 874.0095, 3028.89]) {
        assert!((ours / printed - 1.0).abs() < 3e-6, "{ours} {printed}");
    }
    assert_eq!((q(0).len(), q(1)), (5, vec![q(0)[0]]));
    // air that is compressed lifts more
    let compressed = &result["divergences"][2];
    assert_eq!((compressed["subcase"].as_u64(), compressed["mach"].as_f64()), (Some(2), Some(0.5)));
    assert!(q(2)[0] < q(1)[0], "{} {}", q(2)[0], q(1)[0]);
    let html = std::fs::read_to_string(base.join("out/report.html")).expect("a page");
    assert!(html.contains("What DIVERG asks for."));
    let refused = run(&asks.replace("ENDDATA", "DIVERG,9,many,0.\nENDDATA"));
    assert_eq!(refused.status.code(), Some(2));
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(said.contains("NROOT") && said.contains("diverg.bdf:"), "{said}");
    let refused = run(&asks);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        String::from_utf8_lossy(&refused.stderr).contains("SUBCASE 1 selects DIVERG 9, which is not there")
    );
    std::fs::remove_dir_all(&base).expect("our own folder");
}

/// Each subcase has the support it names: the angle of the grid that is supported, as alone in the deck.
#[test]
fn subcases_that_differ_in_the_supported_grid_alone_are_trimmed_each_with_its_own() {
    let base = std::env::temp_dir().join(format!("wingroot-deck-suport1-{}", std::process::id()));
    std::fs::create_dir_all(&base).expect("a temporary folder");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
    let deck = std::fs::read_to_string(path).expect("a deck of ours");
    let deck = deck.replace("SUPORT,90,35", "SUPORT1,1,90,35\nSUPORT1,2,99,35");
    let angles = |subcases: &str| -> Vec<f64> {
        let path = base.join("two.bdf");
        let text = deck.replace("SUBCASE 1\n  TRIM = 1\nSUBCASE 2\n  TRIM = 2\n", subcases);
        assert_ne!(text, deck);
        std::fs::write(&path, text).expect("a temporary file");
        let output = trimmed(&path, &base.join("out"));
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
        let all = result["subcases"].as_array().expect("subcases");
        all.iter().map(|case| case["values"]["ANGLEA"].as_f64().expect("an angle")).collect()
    };
    let subcase = |support: u32| format!("SUBCASE {support}\n  TRIM = 2\n  SUPORT1 = {support}\n");
    let [first, second] = [1, 2].map(|support| angles(&subcase(support))[0]);
    assert!((first - second).abs() > 1e-3 * first.abs(), "{first} {second}");
    assert_eq!(angles(&(subcase(1) + &subcase(2))), [first, second]);
    std::fs::remove_dir_all(&base).expect("our own folder");
}
