//! The flutter command, run as a user runs it, on the measured Pazy wing.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

#[test]
fn both_methods_and_models_are_in_the_result_and_agree_on_divergence() {
    let out = std::env::temp_dir().join(format!("wingroot-flutter-{}", std::process::id()));
    let folder = out.to_string_lossy().into_owned();
    let arguments =
        ["flutter", "--wing", "data/pazy/wing.ron", "--campaign", "data/pazy/tip_5deg", "--to", "120"];
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .args(["--out", &folder, "--json"])
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    for model in ["initial", "updated"] {
        for method in ["state_matrix", "p_k"] {
            let numbers = &result[model][method];
            let flutter = numbers["flutter_speed_m_s"].as_f64();
            let said = numbers["remarks"].as_array().is_some_and(|remarks| {
                remarks
                    .iter()
                    .any(|remark| remark.as_str().is_some_and(|text| text.starts_with("no flutter")))
            });
            assert_eq!(flutter.is_none(), said, "{model} {method}: {numbers}");
            assert_eq!(flutter.is_some(), numbers["flutter_frequency_hz"].is_number());
            assert!(out.join(format!("{model}_{method}.csv")).is_file());
        }
        assert!(out.join(format!("{model}.svg")).is_file());
        let divergence = |method: &str| result[model][method]["divergence_speed_m_s"].as_f64();
        let (exact, modal) = (divergence("state_matrix"), divergence("p_k"));
        let (exact, modal) =
            (exact.expect("a straight wing diverges"), modal.expect("with twenty modes too"));
        assert!((modal / exact - 1.0).abs() < 1e-3, "{model}: {exact} {modal}");
    }
    std::fs::remove_dir_all(&out).expect("our own folder");
}
