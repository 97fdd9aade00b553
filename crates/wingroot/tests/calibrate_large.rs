//! `calibrate` of a wing that bends far, as a user runs it: tip deflections of other codes up to a third of the semispan, and a
//! campaign of the virtual wind tunnel on such a wing.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// Semispan, m.
const SEMISPAN_M: f64 = 0.55;

fn read(name: &str) -> String {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    std::fs::read_to_string(data.join(name)).expect("a shipped file")
}

/// A folder with the wing of `data/pazy` on few boxes with large deflections.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-calibrate-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let wing = read("pazy/wing.ron");
    let wing = wing.replace("chordwise: 18, spanwise: 36", "chordwise: 4, spanwise: 12");
    let wing = wing.replace("    name: \"Pazy wing\",", "    name: \"Pazy wing\",\n    geometry: Nonlinear,");
    std::fs::write(folder.join("wing.ron"), wing).expect("a file");
    std::fs::write(folder.join("beam_distribution.csv"), read("pazy/beam_distribution.csv")).expect("a file");
    folder
}

/// The published sweep (tip in percent of the semispan) as a campaign in a folder.
fn published(folder: &Path) {
    std::fs::create_dir_all(folder.join("campaign")).expect("a folder");
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
}

fn wingroot(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.current_dir(folder).args(arguments).output().expect("the command starts")
}

fn calibrate(folder: &Path, more: &[&str]) -> Output {
    wingroot(folder, &[&["calibrate", "--wing", "wing.ron", "--campaign", "campaign"], more].concat())
}

fn result(output: &Output) -> Value {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("nothing but JSON")
}

/// By how much a lift factor changes up to the largest deflection, and its uncertainty.
fn change(lift: &Value) -> (f64, f64) {
    let of = |key: &str| lift["change_up_to_largest_deflection"][key].as_f64().expect("a trend");
    (of("value"), of("sigma"))
}

#[test]
fn the_lift_of_a_wing_that_bends_far_is_one_number_and_linear_theory_stands_beside() {
    let folder = folder("published");
    published(&folder);
    let result = result(&calibrate(&folder, &["--out", "out", "--json"]));
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

/// Static cases to 28 % of the semispan; another lattice is the truth. A generator's data, not measurements.
const TUNNEL: &str = r#"Tunnel(
    name: "a wing that bends far",
    wing: "wing.ron",
    seed: 5,
    rho_kg_m3: 1.225,
    curvature: false,
    truth: (mesh: Some((chordwise: 5, strips: [15], fairing_strips: 0))),
    statics: (
        airspeeds_m_s: [15.0, 30.0, 45.0],
        angles_deg: [-1.0, 1.0, 3.0, 5.0, 6.0],
        blocks: (replicates: [("day", 2)], offset_sigma: (fz_N: 0.0, mx_Nm: 0.0, my_Nm: 0.0)),
        tilt_deg: [0.0, 4.0],
        tip_z_sigma_m: 0.0002,
    ),
    noise: (
        sample: (fz_N: 0.05, mx_Nm: 0.02, my_Nm: 0.005),
        static_point: (fz_N: 0.02, mx_Nm: 0.005, my_Nm: 0.001),
    ),
)"#;

/// Root loads that bend over the angle are fitted to their noise, which straight lines miss by thirty times that; one lift factor
/// serves all deflections, and with small ones it does not.
#[test]
fn loads_that_bend_over_the_angle_are_met_to_their_noise_by_the_bent_wing_alone() {
    let folder = folder("tunnel");
    std::fs::write(folder.join("tunnel.ron"), TUNNEL).expect("a file");
    let made = wingroot(&folder, &["tunnel", "--out", "campaign"]);
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let readme = std::fs::read_to_string(folder.join("campaign/README.md")).expect("a README");
    assert!(readme.contains("have small deflections"), "the tables of a bent truth say what is beside it");
    let path = folder.join("campaign/campaign.ron");
    let campaign = std::fs::read_to_string(&path).expect("a campaign");
    let with_tip = campaign
        .replace("my_Nm: 0.001)", "my_Nm: 0.001, tip_z_m: 0.0002)")
        .replace("    static_cases", "    tip: FreeZero,\n    static_cases");
    std::fs::write(&path, &with_tip).expect("a file");
    let each = result(&calibrate(&folder, &["--out", "each", "--json"]));
    for airspeed in each["airspeeds"].as_array().expect("a list") {
        let of = |key: &str| airspeed[key].as_f64().expect("a number");
        assert!(of("objective_after") < 1.2 * of("noise_floor"), "{airspeed}");
        assert!(of("line_floor") < 1.2 * of("noise_floor"), "{airspeed}");
    }
    std::fs::write(&path, with_tip.replace("    static_cases", "    sets: Common,\n    static_cases"))
        .expect("a file");
    let common = result(&calibrate(&folder, &["--out", "common", "--json"]));
    let (large, sigma_large) = change(&common["common"]["lift_factor"]);
    let (small, sigma_small) = change(&common["lift_factors_with_small_deflections"][0]);
    assert!(large.abs() < 0.01 && large.abs() < 2.0 * sigma_large, "{large} +- {sigma_large}");
    assert!(small < -2.0 * sigma_small, "{small} +- {sigma_small} with small deflections");
    let wing = std::fs::read_to_string(folder.join("wing.ron")).expect("a wing");
    std::fs::write(folder.join("wing.ron"), wing.replace("    geometry: Nonlinear,\n", "")).expect("a file");
    std::fs::write(&path, &campaign).expect("a file");
    // Status 3: at one airspeed not even the line is reached.
    let small = calibrate(&folder, &["--out", "small", "--json"]);
    let small: Value = serde_json::from_slice(&small.stdout).expect("nothing but JSON");
    let fastest = &small["airspeeds"][2];
    let of = |key: &str| fastest[key].as_f64().expect("a number");
    assert!(of("objective_after") > 20.0 * of("noise_floor"), "{fastest}");
    let curved = TUNNEL.replace("curvature: false", "curvature: true");
    std::fs::write(folder.join("tunnel.ron"), curved).expect("a file");
    std::fs::write(folder.join("wing.ron"), wing).expect("a file");
    let refused = wingroot(&folder, &["tunnel", "--out", "curved"]);
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(refused.status.code() == Some(2) && said.contains("of small deflections"), "{said}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
