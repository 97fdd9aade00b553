//! `response --missing` as a user runs it: a term hidden from the published equations, nothing hidden, a table of one's own,
//! and what is wrong.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-missing-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.args(["response", "--missing"]).args(arguments);
    command.args(["--quiet", "--out"]).arg(folder.join("out")).current_dir(folder);
    command.output().expect("the command starts")
}

fn result(folder: &Path, arguments: &[&str]) -> Value {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(folder.join("out/result.json")).expect("a result");
    serde_json::from_str(&text).expect("JSON")
}

fn complaint(folder: &Path, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    assert_eq!(output.status.code(), Some(2));
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn shipped() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav").display().to_string()
}

#[test]
fn on_the_shipped_runs_the_hidden_propeller_term_is_named_and_the_gap_closes() {
    let folder = folder("propeller");
    let result = result(&folder, &["--data", &shipped(), "--hide", "n^2/q"]);
    assert_eq!(result["verdict"], "effects");
    let effects = result["effects"].as_array().expect("a list");
    assert_eq!(effects.len(), 1);
    assert_eq!(effects[0]["name"], "n_krpm^2/q_Pa");
    assert_eq!(effects[0]["channel"], "CD");
    let parameter = &effects[0]["parameters"]["n_krpm^2/q_Pa"];
    let (value, sigma) = (parameter["value"].as_f64(), parameter["sigma"].as_f64());
    // Eq. 13 of paper 2
    assert!((value.expect("a number") + 0.042_488).abs() < 4.0 * sigma.expect("a number"));
    let gap = &result["gap"]["holdout"];
    let number = |name: &str| gap[name].as_f64().expect("a number");
    assert!(number("before") > 4.0 && number("after") < 1.3, "{gap}");
    assert!(folder.join("out/candidates.csv").is_file() && folder.join("out/families.csv").is_file());
}

#[test]
fn on_the_shipped_runs_nothing_is_missing_if_nothing_is_hidden() {
    let folder = folder("nothing");
    let result = result(&folder, &["--data", &shipped()]);
    assert_eq!(result["verdict"], "none", "{}", result["effects"]);
    assert_eq!(result["effects"].as_array().map(Vec::len), Some(0));
    assert_eq!(result["responses"].as_array().map(Vec::len), Some(13));
}

#[test]
fn in_a_table_of_ones_own_offsets_of_days_are_named_and_what_is_not_said_is_asked_for() {
    let folder = folder("own");
    let mut text = String::from("day,A,B,CL\n");
    for (k, (day, offset)) in [("mon", 0.1), ("tue", -0.1)].into_iter().enumerate() {
        for i in 0..7_u32 {
            for j in 0..3_u32 {
                let (a, b) = (2.0 * f64::from(i) - 4.0, 5.0 * f64::from(j));
                let scatter = 0.01 * (f64::from(i * 31 + j * 17) * 2.3 + k as f64 * 4.1).sin();
                let cl = 0.3 + 0.1 * a + 0.01 * a * b + offset + scatter;
                let _ = writeln!(text, "{day},{a},{b},{cl:.5}");
            }
        }
    }
    std::fs::write(folder.join("mine.csv"), text).expect("a file");
    let columns = ["--data", "mine.csv", "--factors", "A,B", "--responses", "CL", "--blocks", "day"];
    let with = |more: &[&'static str]| [&columns[..], more].concat();
    let answer = result(&folder, &with(&["--model", "A,B,A*B"]));
    assert_eq!(answer["verdict"], "effects");
    assert_eq!(answer["effects"][0]["name"], "day");
    assert_eq!(answer["effects"][0]["kind"], "block");
    let offset = answer["effects"][0]["parameters"]["mon"]["value"].as_f64().expect("an offset");
    assert!((offset - 0.1).abs() < 0.01, "{offset}");
    let product = result(&folder, &with(&["--model", "A,B,day"]));
    assert_eq!(product["effects"][0]["name"], "A*B");
    assert!(complaint(&folder, &with(&[])).contains("--model"));
    assert!(complaint(&folder, &with(&["--model", "A,C"])).contains("which is no factor of mine.csv"));
    assert!(complaint(&folder, &with(&["--model", "A", "--hide", "B"])).contains("no model has `B`"));
}
