//! Schemas and files: what is shipped and what commands write fits the schema of its kind, what is wrong does not; and a wing in
//! JSON is the wing in RON.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::ron_to_json::converted;
use jsonschema::Validator;
use serde_json::{Value, json};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-schemas-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    folder
}

/// Runs a command that must end well; its standard output.
fn run(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot")).args(arguments).output().expect("it starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

fn schema(name: &str) -> Value {
    serde_json::from_str(&run(&["schema", name])).expect("JSON")
}

fn validator(name: &str) -> Validator {
    jsonschema::draft202012::new(&schema(name)).expect("a schema")
}

fn faults(validator: &Validator, value: &Value) -> Vec<String> {
    validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

/// All files of a folder and below.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// Every shipped input with the name of its schema and its JSON form.
fn shipped() -> Vec<(PathBuf, &'static str, Value)> {
    let is_ron = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "ron");
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a shipped file");
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let kinds = [
            "wing",
            "campaign",
            "aircraft",
            "cases",
            "select",
            "tunnel",
            "response",
            "null_distribution",
            "flight",
            "rig",
        ];
        let kind = kinds.into_iter().find(|kind| name.starts_with(kind)).unwrap_or("maneuver");
        // a plan of design loads is a grid of cases with more fields
        let kind = if name.starts_with("loads") { "cases" } else { kind };
        (path, kind, converted(&text))
    };
    files(&data("")).into_iter().filter(is_ron).map(read).collect()
}

/// What does not depend on the clock and on where files are.
fn lasting(mut result: Value) -> Value {
    if let Value::Object(entries) = &mut result {
        entries.remove("seconds");
    }
    result
}

#[test]
fn every_shipped_input_fits_its_schema_and_a_wrong_key_does_not() {
    let all = shipped();
    assert!(all.len() > 20, "{} files", all.len());
    for (path, kind, value) in all {
        let schema = validator(kind);
        assert_eq!(faults(&schema, &value), Vec::<String>::new(), "{}", path.display());
        let mut wrong = value.clone();
        wrong["nmae"] = json!("x");
        assert!(!schema.is_valid(&wrong), "{}: a key too many", path.display());
        for key in value.as_object().expect("fields").keys() {
            let mut wrong = value.clone();
            wrong[key] = json!({ "of": "another kind" });
            assert!(!schema.is_valid(&wrong), "{}: {key} of another type", path.display());
        }
    }
}

/// Fields without description, of a schema and all in it.
fn undescribed(value: &Value, path: &str, found: &mut Vec<String>) {
    let Value::Object(entries) = value else {
        if let Value::Array(all) = value {
            for value in all {
                undescribed(value, path, found);
            }
        }
        return;
    };
    for (name, field) in entries.get("properties").and_then(Value::as_object).into_iter().flatten() {
        // The name of a choice is described where its fields are.
        let choice = name.starts_with(char::is_uppercase)
            && entries.get("additionalProperties") == Some(&json!(false));
        if field.is_object() && field.get("description").is_none() && !choice {
            found.push(format!("{path}.{name}"));
        }
    }
    for (name, value) in entries {
        let path = format!("{path}.{name}");
        match value {
            // Here the keys are names of fields and types.
            Value::Object(named) if name == "properties" || name == "$defs" => {
                named.iter().for_each(|(name, value)| undescribed(value, &format!("{path}.{name}"), found));
            }
            _ => undescribed(value, &path, found),
        }
    }
}

#[test]
fn every_field_of_every_schema_is_described() {
    let mut found = Vec::new();
    for line in run(&["schema"]).lines() {
        let name = line.split_whitespace().next().expect("a name");
        undescribed(&schema(name), name, &mut found);
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_schema_of_a_motion_is_what_is_read() {
    let schema = validator("maneuver");
    let with = |motion: Value| json!({ "V_m_s": 30.0, "sample_rate_hz": 100.0, "length_s": 1.0, "motions": [motion] });
    for right in [
        json!({ "Doublet": { "of": "inner", "height_deg": 1, "frequency_hz": 2 } }),
        json!({ "Doublet": { "control": "inner", "deflection_deg": 1, "frequency_hz": 2 } }),
        json!({ "OneMinusCosine": { "to_deg": 1, "frequency_hz": 2 } }),
        json!({ "FromFile": { "file": "own.csv" } }),
    ] {
        assert_eq!(faults(&schema, &with(right)), Vec::<String>::new());
    }
    for wrong in [
        json!({ "Doublet": { "height_deg": 1, "frequency_hz": 2 } }),
        json!({ "Doublet": { "of": "inner", "frequency_hz": 2 } }),
        json!({ "Doublet": { "of": "inner", "height_deg": 1, "frequency_hz": 2, "duration_s": 1 } }),
        json!({ "FromFile": { "file": "own.csv", "of": "inner" } }),
        json!({ "Dublet": { "of": "inner", "height_deg": 1, "frequency_hz": 2 } }),
    ] {
        assert!(!schema.is_valid(&with(wrong.clone())), "{wrong}");
    }
}

/// The shipped wing of one's own with all its RON files as JSON.
fn own_wing_in_json(folder: &Path) {
    let from = data("own_wing");
    for path in files(&from) {
        let to = folder.join(path.strip_prefix(&from).expect("below"));
        std::fs::create_dir_all(to.parent().expect("a folder")).expect("a temporary folder");
        if path.extension().is_some_and(|ending| ending == "ron") {
            let text = converted(&std::fs::read_to_string(&path).expect("text")).to_string();
            std::fs::write(to.with_extension("json"), text.replace(".ron\"", ".json\""))
                .expect("a temporary file");
        } else {
            std::fs::copy(&path, &to).expect("a temporary file");
        }
    }
}

#[test]
fn a_wing_in_json_gives_the_bits_of_the_same_in_ron() {
    let folder = folder("bits");
    own_wing_in_json(&folder);
    let at = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let ron = data("own_wing/wing.ron").to_string_lossy().into_owned();
    let calibrate = |wing: &str, out: &str| {
        let result = run(&["calibrate", "--wing", wing, "--json", "--numbers-only", "--quiet", "--out", out]);
        lasting(serde_json::from_str(&result).expect("JSON"))
    };
    let result = calibrate(&at("wing.json"), &at("out_json"));
    assert_eq!(result, calibrate(&ron, &at("out_ron")));
    // The wing that `deflection` writes is JSON, too, and is read again.
    let corrections = at("out_json/corrections.ron");
    run(&[
        "deflection",
        "--wing",
        &at("wing.json"),
        "--corrections",
        &corrections,
        "--quiet",
        "--out",
        &at("deflection"),
    ]);
    let written = std::fs::read_to_string(at("deflection/wing.json")).expect("a wing in JSON");
    let written: Value = serde_json::from_str(&written).expect("JSON");
    assert_eq!(faults(&validator("wing"), &written), Vec::<String>::new());
    assert!(!written["deflection"].as_array().expect("tables").is_empty());
    run(&["modes", "--wing", &at("deflection/wing.json"), "--count", "2", "--quiet", "--out", &at("modes")]);
    std::fs::remove_dir_all(folder).expect("it was made above");
}

/// Runs a command into a folder below `folder`; what is wrong with its result.
fn faults_of_result(folder: &Path, schema: &str, arguments: &[&str]) -> Vec<String> {
    let out = folder.join(schema);
    run(&[arguments, &["--quiet", "--numbers-only", "--out", &out.to_string_lossy()]].concat());
    faults_in(&out, schema)
}

/// What is wrong with the result of a folder; one with a key too many must be refused.
pub(crate) fn faults_in(out: &Path, schema: &str) -> Vec<String> {
    let text = std::fs::read_to_string(out.join("result.json")).expect("a result");
    let result: Value = serde_json::from_str(&text).expect("JSON");
    let schema = validator(schema);
    let mut wrong = result.clone();
    wrong["command"] = json!(1);
    assert!(!schema.is_valid(&wrong), "{}", out.display());
    faults(&schema, &result)
}

#[test]
fn every_result_fits_its_schema() {
    let folder = folder("results");
    let path = |file: &Path| file.to_string_lossy().into_owned();
    let own = |file: &str| path(&data("own_wing").join(file));
    let made = |file: &str| path(&folder.join(file));
    let (wing, corrections) = (own("wing.ron"), made("calibrate_result/corrections.ron"));
    let (aircraft, tunnel, mav) = (own("aircraft.ron"), own("made_with/tunnel.ron"), path(&data("mav")));
    let measured = "Measured(modes: [(frequency_hz: 9.0, sigma_hz: 0.1)], regions: [(name: \"all\", y_m: (0.0, 9.0), fit: [Stiffness])])";
    std::fs::write(made("measured.ron"), measured).expect("a temporary file");
    let cases =
        "Cases(name: \"few\", airspeeds_V_m_s: [20.0], load_factors: [2.0], maneuvers: [Level, Pull])";
    std::fs::write(made("cases.ron"), cases).expect("a temporary file");
    let field = (-3..=3)
        .flat_map(|y: i32| (0..3).map(move |x| format!("{x},{y},{}\n", 0.1 * f64::from(y.abs() * (x + 1)))));
    std::fs::write(made("field.csv"), format!("x_mm,y_mm,w_mm\n{}", field.collect::<String>()))
        .expect("a file");
    let with = ["--wing", &wing, "--corrections", &corrections];
    let [deck, gust] =
        ["ha144a_fsw.bdf", "bah_gust.bdf"].map(|name| path(&data("published/decks").join(name)));
    let flight = path(&data("weber_brebner/flight.ron"));
    let commands: [(&str, Vec<&str>); 16] = [
        ("calibrate_result", vec!["calibrate", "--wing", &wing]),
        ("simulate_result", [&["simulate"], &with[..]].concat()),
        ("deflection_result", [&["deflection"], &with[..]].concat()),
        ("flightloads_result", vec!["flightloads", "--measured", &flight]),
        // with intervals: `ensemble.rs`
        ("flutter_result", [&["flutter", "--no-intervals", "--to", "20"], &with[..]].concat()),
        ("modes_result", vec!["modes", "--wing", &wing]),
        ("modes_measured_result", vec!["modes", "--wing", &wing, "--measured", "measured.ron"]),
        ("deck_result", [&["deck"], &with[..]].concat()),
        ("tunnel_result", vec!["tunnel", "--runs", &tunnel]),
        ("fullaircraft_result", [&["fullaircraft", "--aircraft", &aircraft], &with[..]].concat()),
        (
            "fullaircraft_cases_result",
            [&["fullaircraft", "--cases", "cases.ron", "--aircraft", &aircraft], &with[..]].concat(),
        ),
        ("fullaircraft_deck_result", vec!["fullaircraft", "--deck", &deck]),
        ("gust_result", vec!["gust", "--deck", &gust]),
        ("response_result", vec!["response", "--data", &mav]),
        ("response_missing_result", vec!["response", "--missing", "--hide", "q*delta", "--data", &mav]),
        ("response_displacement_result", vec!["response", "--displacement", "field.csv"]),
    ];
    for (schema, arguments) in commands {
        let named = |argument: &&str| {
            if ["measured.ron", "cases.ron", "field.csv"].contains(argument) {
                made(argument)
            } else {
                (*argument).to_owned()
            }
        };
        let arguments: Vec<String> = arguments.iter().map(named).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        assert_eq!(faults_of_result(&folder, schema, &arguments), Vec::<String>::new(), "{schema}");
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

/// What the README's first command writes, read where its own tests have it written.
#[test]
fn results_of_the_pipeline_fit_their_schemas() {
    for step in ["pipeline", "discover"] {
        let out = crate::pipeline::out().join(step);
        assert_eq!(faults_in(&out, &format!("{step}_result")), Vec::<String>::new(), "{step}");
    }
}

/// The blind benchmark takes minutes; that which its own test runs is read.
#[test]
fn the_result_of_the_blind_benchmark_fits_its_schema() {
    if !crate::slow::runs("reads what the blind benchmark writes") {
        return;
    }
    assert_eq!(faults_in(crate::hidden_killed::whole(), "hidden_result"), Vec::<String>::new());
}

#[test]
fn a_folder_with_both_forms_of_a_file_is_refused_and_a_fault_in_json_is_shown_at_its_place() {
    let folder = folder("both");
    let refused = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        let output = command.args(arguments).current_dir(&folder).output().expect("it starts");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let wing = std::fs::read_to_string(data("own_wing/wing.ron")).expect("a wing");
    let json = serde_json::to_string_pretty(&converted(&wing)).expect("JSON");
    for file in ["section.dat", "beam.csv"] {
        std::fs::copy(data("own_wing").join(file), folder.join(file)).expect("a temporary file");
    }
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).expect("a temporary file");
    write("wing.ron", &wing);
    write("wing.json", &json);
    let said = refused(&["modes"]);
    assert!(said.contains("wing.ron: there is wing.json beside it"), "{said}");
    std::fs::remove_file(folder.join("wing.ron")).expect("it was made above");
    let line_of =
        |text: &str, what: &str| 1 + text.lines().position(|line| line.contains(what)).expect("a line");
    // Met while parsing, and by a check behind it.
    for (right, wrong, hint) in [
        ("\"semispan_m\":", "\"semispan\":", "did you mean \"semispan_m\"?"),
        ("\"chord_strips\": ", "\"chord_strips\": 7", "a chord strip is one or several rows"),
    ] {
        let text = json.replace(right, wrong);
        write("wing.json", &text);
        let said = refused(&["modes"]);
        let place = format!("wing.json:{}:", line_of(&text, wrong));
        assert!(said.contains(&place) && said.contains(hint), "{place} {said}");
    }
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn a_schema_that_is_not_there_is_refused_with_the_one_that_was_meant() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    let output = command.args(["schema", "wig"]).output().expect("it starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("did you mean wing?"));
}
