//! `calibrate` of a wing that bends far, as a user runs it: tip deflections of other codes up to a third of the semispan.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// Semispan, m.
const SEMISPAN_M: f64 = 0.55;

/// The wing of `data/pazy` on few boxes with large deflections, and the published sweep (tip in percent of the semispan) as a
/// campaign.
fn folder() -> PathBuf {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let folder = std::env::temp_dir().join(format!("wingroot-calibrate-large-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("campaign")).expect("a folder");
    let read = |name: &str| std::fs::read_to_string(data.join(name)).expect("a shipped file");
    let wing = read("pazy/wing.ron");
    let wing = wing.replace("chordwise: 18, spanwise: 36", "chordwise: 4, spanwise: 12");
    let wing = wing.replace("    name: \"Pazy wing\",", "    name: \"Pazy wing\",\n    geometry: Nonlinear,");
    std::fs::write(folder.join("wing.ron"), wing).expect("a file");
    std::fs::copy(data.join("pazy/beam_distribution.csv"), folder.join("beam_distribution.csv"))
        .expect("a copy");
    let campaign = read("pazy/tip_5deg/campaign.ron").replace("rho_kg_m3: 1.136", "rho_kg_m3: 1.225");
    std::fs::write(folder.join("campaign/campaign.ron"), campaign).expect("a file");
    let case: Value =
        serde_json::from_str(&read("published/nl_pazy__static_aeroelastic_aoa5.json")).expect("JSON");
    let rows = case["expected"]["skin1_UMNAST_VLM_zyx"].as_array().expect("rows");
    let number = |row: &Value, at: usize| row[at].as_f64().expect("a number");
    let mut text = String::from("V_m_s,alpha_deg,tip_z_m\n");
    for row in rows.iter().filter(|row| (7.0..=50.0).contains(&number(row, 0))) {
        let tip_m = 0.01 * number(row, 1) * SEMISPAN_M;
        writeln!(text, "{},5,{tip_m}", number(row, 0)).expect("text");
    }
    std::fs::write(folder.join("campaign/static.csv"), text).expect("a file");
    folder
}

fn calibrate(folder: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.current_dir(folder).args(["calibrate", "--wing", "wing.ron", "--campaign", "campaign"]);
    command.args(more).output().expect("the command starts")
}

#[test]
fn the_lift_of_a_wing_that_bends_far_is_one_number_and_linear_theory_stands_beside() {
    let folder = folder();
    let output = calibrate(&folder, &["--out", "out", "--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).expect("nothing but JSON");
    let change = |lift: &Value| {
        let of = |key: &str| lift["change_up_to_largest_deflection"][key].as_f64().expect("a trend");
        (of("value"), of("sigma"))
    };
    let (large, sigma_large) = change(&result["common"]["lift_factor"]);
    let (small, sigma_small) = change(&result["lift_factors_with_small_deflections"][0]);
    assert!(small < -3.0 * sigma_small, "{small} +- {sigma_small} with small deflections");
    assert!(large.abs() < 2.0 * sigma_large, "{large} +- {sigma_large} with large deflections");
    assert_eq!(result["predictions"], Value::Array(Vec::new()));
    let page = std::fs::read_to_string(folder.join("out/report.html")).expect("a page");
    assert!(page.contains("trend of the lift"), "the page says both");
    let refused = calibrate(&folder, &["--next", "tip"]);
    let said = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(said.contains("small deflections only"), "{said}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
