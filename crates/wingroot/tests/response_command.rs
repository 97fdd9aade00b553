//! `response` as a user runs it: on the shipped runs, on a CSV of one's own, and on what is wrong.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-response-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.arg("response").args(arguments).args(["--quiet", "--out"]).arg(folder.join("out"));
    command.current_dir(folder).output().expect("the command starts")
}

fn result(folder: &Path, arguments: &[&str]) -> Value {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(folder.join("out/result.json")).expect("a result");
    serde_json::from_str(&text).expect("JSON")
}

fn terms(response: &Value) -> Vec<String> {
    let terms = response["terms"].as_array().expect("a list");
    terms.iter().filter_map(|term| term["term"].as_str()).map(String::from).collect()
}

/// CL = 0.3 + 0.1 A + 0.01 A B, an offset of 0.2 between two days, and a scatter of about 0.01 that no term follows.
fn own_table(folder: &Path) {
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
}

const COLUMNS: [&str; 6] = ["--factors", "A,B", "--responses", "CL", "--blocks", "day"];

#[test]
fn the_shipped_runs_give_every_response_with_tables_and_figures() {
    let folder = folder("shipped");
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav");
    let result = result(&folder, &["--data", data.to_str().expect("a path")]);
    let responses = result["responses"].as_array().expect("a list");
    assert_eq!(responses.len(), 1 + 3 + 3 + 1 + 3 + 2);
    for response in responses {
        let stem = response["data"].as_str().expect("a name").trim_end_matches(".csv");
        let name = format!("{stem}_{}", response["name"].as_str().expect("a name"));
        for ending in ["_terms.csv", "_curve.csv", "_points.csv", ".svg"] {
            assert!(folder.join("out").join(name.clone() + ending).is_file(), "{name}{ending}");
        }
        for key in ["r2", "pse", "points", "sigma0_squared", "adjusted_r2", "bic", "leave_one_out"] {
            assert!(response[key].is_number(), "{name}: {key}");
        }
        let r2 = response["r2"].as_f64().expect("a number");
        assert!((0.9..1.0).contains(&r2), "{name}: {r2}");
        assert!(response["terms"][0]["standard_error"].as_f64().expect("a number") > 0.0);
        assert!(response["tests"]["lack_of_fit"]["p_value"].is_number(), "{name}");
        // the chosen size is the lowest of the curve
        let curve = response["curve"].as_array().expect("a list");
        let lowest = curve.iter().filter_map(|step| step["pse"].as_f64()).fold(f64::INFINITY, f64::min);
        assert!((lowest - response["pse"].as_f64().expect("a number")).abs() <= 1e-12 * lowest);
    }
    let moment = &responses[3];
    let mut published = [
        "1",
        "q_Pa",
        "delta_deg",
        "alpha_deg",
        "q_Pa*delta_deg",
        "q_Pa^2",
        "delta_deg^2",
        "q_Pa*delta_deg^2",
    ];
    published.sort_unstable();
    let mut found = terms(moment);
    found.sort_unstable();
    assert_eq!(found, published, "Eq. 7");
    for figure in [9, 10, 11, 12] {
        assert!(folder.join(format!("out/fig_{figure}.svg")).is_file());
    }
    assert!(folder.join("out/negative_elevator_effects.svg").is_file());
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn a_table_of_ones_own_is_analysed_by_its_column_names() {
    let folder = folder("own");
    own_table(&folder);
    let data = ["--data", "mine.csv"];
    let by_names = result(&folder, &[&data[..], &COLUMNS[..]].concat());
    let response = &by_names["responses"][0];
    assert_eq!(terms(response), ["1", "A", "B", "A*B"]);
    for (term, value) in [(0, 0.3), (1, 0.1), (2, 0.0), (3, 0.01)] {
        let got = response["terms"][term]["coefficient"].as_f64().expect("a number");
        let error = response["terms"][term]["standard_error"].as_f64().expect("a number");
        assert!((got - value).abs() < 4.0 * error, "{term}: {got} +- {error}");
    }
    assert!(response["tests"]["blocks"]["share_of_pure_error"].as_f64().expect("a number") > 0.9);
    let offset = response["block_offsets"][0]["offset"].as_f64().expect("a number");
    assert!((offset - 0.1).abs() < 0.01, "{offset}");
    // the folder instead of the file, and a RON file instead of options, say the same
    let by_folder = result(&folder, &[&["--data", "."], &COLUMNS[..]].concat());
    std::fs::write(
        folder.join("response.ron"),
        "Response(tables: [(data: \"mine.csv\", factors: [\"A\", \"B\"], responses: [\"CL\"], blocks: [\"day\"])])",
    )
    .expect("a file");
    let by_file = result(&folder, &["--data", "."]);
    assert_eq!(by_names["responses"], by_folder["responses"]);
    assert_eq!(by_names["responses"], by_file["responses"]);
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn options_change_the_candidates_the_blocks_and_the_penalty() {
    let folder = folder("options");
    own_table(&folder);
    let with = |more: &[&str]| {
        let all = [&["--data", "mine.csv"], &COLUMNS[..], more].concat();
        result(&folder, &all)["responses"][0].clone()
    };
    assert_eq!(with(&["--order", "1"])["candidates"].as_array().expect("a list").len(), 3);
    let named = with(&["--terms", "A,A^3,B*A"]);
    assert_eq!(named["candidates"], serde_json::json!(["1", "A", "A^3", "B*A"]));
    assert_eq!(with(&["--order", "3"])["candidates_left_out"][0]["term"], "B^3");
    // offsets of 0.1 and -0.1 have a standard deviation of 0.2 / sqrt(2)
    let random = with(&["--blocking", "random"])["tests"]["random_blocks"]["between"].as_f64();
    assert!((random.expect("a number") - 0.1414).abs() < 0.01);
    let ignored = with(&["--blocking", "ignored"]);
    assert!(ignored["error_standard_deviation"].as_f64().expect("a number") > 0.09);
    assert_eq!(terms(&with(&["--least-t", "1000"])), ["1"]);
    for search in ["best", "stepwise", "ranked"] {
        assert_eq!(terms(&with(&["--search", search])), ["1", "A", "B", "A*B"], "{search}");
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn what_is_wrong_is_named_with_its_place_and_nothing_is_written() {
    let folder = folder("wrong");
    own_table(&folder);
    let good = std::fs::read_to_string(folder.join("mine.csv")).expect("a file");
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).expect("a file");
    write("text.csv", &good.replacen("tue,-4,5,", "tue,-4,five,", 1));
    let constant: Vec<String> = good
        .lines()
        .enumerate()
        .map(|(k, line)| {
            let mut cells: Vec<&str> = line.split(',').collect();
            if k > 0 {
                cells[2] = "5";
            }
            cells.join(",")
        })
        .collect();
    write("constant.csv", &constant.join("\n"));
    write("few.csv", "day,A,B,CL\nmon,1,1,0\ntue,2,1,3\nmon,3,2,4\ntue,4,5,2\n");
    write(
        "field.ron",
        "Response(tables: [(data: \"mine.csv\", factors: [\"A\"], responses: [\"CL\"], ordre: 2)])",
    );
    write(
        "term.ron",
        "Response(tables: [(data: \"mine.csv\", factors: [\"A\"], responses: [\"CL\"],\n  terms: [\"A*Z\"])])",
    );
    let named = |file: &'static str, more: &[&'static str]| [&["--data", file], &COLUMNS[..], more].concat();
    for (arguments, parts) in [
        (named("text.csv", &[]), vec!["text.csv:24:8", "`five`", "`B`"]),
        (named("constant.csv", &[]), vec!["constant.csv:2:", "the factor `B` is 5 at all points"]),
        (named("few.csv", &["--terms", "A,B,A^2"]), vec!["few.csv", "4 points", "5 terms"]),
        (named("mine.csv", &["--terms", "B,B^2,B^3"]), vec!["mine.csv", "`B^3`", "`B`, `B^2`"]),
        (named("mine.csv", &["--terms", "A/B"]), vec!["mine.csv:2:8", "`A/B`", "inf"]),
        (named("mine.csv", &["--level", "95"]), vec!["the level is 95"]),
        (vec!["--data", "mine.csv"], vec!["mine.csv", "--factors"]),
        (vec!["--data", "field.ron"], vec!["field.ron:1:", "`ordre`", "`order`"]),
        (vec!["--data", "term.ron"], vec!["term.ron:2:11", "`A*Z`", "`Z`"]),
        (vec!["--data", "mine.csv", "--factors", "A,C", "--responses", "CL"], vec!["mine.csv:1", "`C`"]),
    ] {
        let output = run(&folder, &arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        for part in parts {
            assert!(message.contains(part), "{arguments:?}: `{message}` does not say `{part}`");
        }
        assert!(!folder.join("out").exists(), "{arguments:?}");
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn points_of_ones_own_are_predicted_and_those_beyond_the_data_are_marked() {
    let folder = folder("at");
    own_table(&folder);
    std::fs::write(folder.join("at.csv"), "A,B,remark\n2,5,inside\n8,10,corner\n30,10,far\n")
        .expect("a file");
    let result = result(&folder, &[&["--data", "mine.csv", "--at", "at.csv"], &COLUMNS[..]].concat());
    let points = result["at"][0]["points"].as_array().expect("a list");
    let number = |point: usize, key: &str| points[point][key].as_f64().expect("a number");
    for (point, (a, b)) in [(2.0, 5.0), (8.0, 10.0), (30.0, 10.0)].into_iter().enumerate() {
        let truth = 0.3 + 0.1 * a + 0.01 * a * b;
        let error = number(point, "standard_error");
        assert!((number(point, "value") - truth).abs() < 4.0 * error, "{point}");
        let width = |key: &str| {
            points[point][key][1].as_f64().unwrap_or(0.0) - points[point][key][0].as_f64().unwrap_or(0.0)
        };
        assert!(width("reading_interval") > width("mean_interval") && width("mean_interval") > 0.0);
        assert_eq!(points[point]["beyond_data"], Value::Bool(point == 2));
    }
    assert!(number(2, "standard_error") > 3.0 * number(0, "standard_error"));
    assert!(folder.join("out/mine_CL_at.csv").is_file());
    std::fs::write(folder.join("at.csv"), "A\n2\n").expect("a file");
    let output = run(&folder, &[&["--data", "mine.csv", "--at", "at.csv"], &COLUMNS[..]].concat());
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("at.csv:1") && message.contains("`B`"), "{message}");
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn the_ratio_of_a_displacement_field_is_that_of_its_sides() {
    let folder = folder("displacement");
    let mut text = String::from("x_mm,y_mm,w_mm\n");
    for (x, y) in (0..10).flat_map(|i| (-7..8).map(move |j| (10 * i, 10 * j))) {
        let _ = writeln!(text, "{x},{y},{}", 1.0 + 0.003 * f64::from(y));
    }
    std::fs::write(folder.join("field.csv"), text).expect("a file");
    let result = result(&folder, &["--displacement", "field.csv"]);
    // sides 7 -+ 0.03 (1 + ... + 7), and half of the middle row to either
    let want = (7.5 - 0.84) / (7.5 + 0.84);
    let got = result["fields"][0]["ratio"].as_f64().expect("a number");
    assert!((got - want).abs() < 1e-12, "{got}");
    assert_eq!(result["fields"][0]["beyond_the_rigid_wing"], true);
    assert_eq!(result["rigid"]["mean"], 0.956);
    // a rigid wing as asymmetric as the field leaves nothing of it
    let arguments = ["--displacement", "field.csv", "--rigid", "field.csv", "field.csv"];
    let beside = self::result(&folder, &arguments);
    assert_eq!(beside["fields"][0]["beyond_the_rigid_wing"], false);
    let output = run(&folder, &["--displacement", "field.csv", "--centre-y-mm", "500"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("field.csv: no point of the left half"));
    std::fs::remove_dir_all(folder).expect("it was made above");
}
