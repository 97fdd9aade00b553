//! `statics` as a user runs it: a deck at large deflections, a wing in steady air.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-statics-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    folder
}

pub(crate) fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.arg("statics").args(arguments).args(["--quiet", "--out"]).arg(folder.join("out"));
    command.current_dir(folder).output().expect("the command starts")
}

fn result(folder: &Path, arguments: &[&str]) -> Value {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(folder.join("out/result.json")).expect("a result");
    serde_json::from_str(&text).expect("JSON")
}

fn published(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).expect("a case")).expect("JSON")
}

/// A cantilever of 16 bars, length 1, E I = 1, under an end force of 4 E I / L^2 (set 20).
fn cantilever(folder: &Path, subcase: &str) {
    use std::fmt::Write as _;
    let mut deck = format!(
        "SOL 106\nCEND\nSPC = 1\n{subcase}BEGIN BULK\nMAT1,1,1.+6,,0.\nPBAR,1,1,1.,1.-6,1.-6,2.-6\nSPC1,1,123456,1\n"
    );
    for grid in 1..=17 {
        let _ = writeln!(deck, "GRID,{grid},,{:.6},0.,0.", f64::from(grid - 1) / 16.0);
    }
    for bar in 1..=16 {
        let _ = writeln!(deck, "CBAR,{bar},1,{bar},{},0.,0.,1.", bar + 1);
    }
    deck.push_str("FORCE,20,17,,4.,0.,0.,1.\nFORCE,30,17,,1.,0.,0.,1.\nENDDATA\n");
    std::fs::write(folder.join("wing.bdf"), deck).expect("a deck");
}

#[test]
fn a_deck_at_large_deflections_is_the_elastica_with_linear_theory_beside_it() {
    let folder = folder("elastica");
    cantilever(&folder, "");
    let result = result(&folder, &["--deck", "wing.bdf", "--load", "20", "--nonlinear", "--steps", "4"]);
    let case = published("nl_beam__elastica_end_shear.json");
    let column = |name: &str| -> Vec<f64> {
        case["expected"][name].as_array().expect("a list").iter().filter_map(Value::as_f64).collect()
    };
    let loads = column("alpha");
    let mut met = 0;
    for step in result["steps"].as_array().expect("steps") {
        let load = 4.0 * step["load_factor"].as_f64().expect("a number");
        let Some(at) = loads.iter().position(|of| (of - load).abs() < 1e-9) else { continue };
        let z = step["displacement_m"][2].as_f64().expect("a number");
        let wanted = column("deflection_over_L")[at];
        assert!((z / wanted - 1.0).abs() < 1.5e-3, "deflection {z} for {wanted} at {load}");
        met += 1;
    }
    assert!(met >= 3, "only {met} loads are in the table");
    let linear = result["linear_displacement_m"][2].as_f64().expect("a number");
    assert!((linear - 4.0 / 3.0).abs() < 1e-6, "linear theory says {linear}, not P L^3 / 3 E I");
    assert!(
        folder.join("out/steps.csv").is_file() && folder.join("out/displacement_over_load.svg").is_file()
    );
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn a_wing_in_steady_air_bends_as_the_codes_say_with_linear_theory_beside_it() {
    let folder = folder("air");
    let wing = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/pazy/wing.ron");
    let wing = wing.to_str().expect("a path");
    let result = result(&folder, &["--wing", wing, "--airspeeds", "50,20", "--nonlinear"]);
    let case = published("nl_pazy__static_aeroelastic_aoa5.json");
    let table = case["expected"]["skin1_UMNAST_VLM_zyx"].as_array().expect("rows");
    let points = result["points"].as_array().expect("points");
    for (point, airspeed) in points.iter().zip([20.0, 50.0]) {
        assert_eq!(point["V_m_s"], airspeed, "airspeeds rise");
        let row = table.iter().find(|row| row[0] == airspeed).expect("the airspeed");
        let wanted = row[1].as_f64().expect("a number");
        let percent = point["large"]["tip_z_m"].as_f64().expect("a number") / 0.0055;
        assert!((percent / wanted - 1.0).abs() < 0.06, "tip at {airspeed} m/s: {percent} for {wanted}");
    }
    let of = |which: &str| points[1][which]["tip_z_m"].as_f64().expect("a number");
    // The codes carry no weight; crates/coupling/tests/large_pazy.rs compares the ratio without it.
    let ratio = of("large") / of("linear");
    assert!(0.85 < ratio && ratio < 0.95, "large over linear {ratio}");
    assert!(folder.join("out/tip_over_airspeed.svg").is_file() && folder.join("out/report.html").is_file());
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn what_cannot_be_is_refused_with_the_last_airspeed_that_was_reached() {
    let folder = folder("refused");
    let wing = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/pazy/wing.ron");
    let wing = wing.to_str().expect("a path");
    let stopped = |arguments: &[&str], status: i32, words: &[&str]| {
        let output = run(&folder, arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {said}");
        assert!(words.iter().all(|word| said.contains(word)), "{arguments:?}: {said}");
    };
    stopped(&[], 2, &["--deck"]);
    stopped(&["--wing", wing, "--alpha", "60"], 2, &["--alpha", "-45 to 45"]);
    stopped(&["--wing", wing, "--density", "0"], 2, &["--density"]);
    stopped(&["--wing", wing, "--deck", "wing.bdf"], 2, &["cannot be used with"]);
    // Its divergence is at 107 m/s by linear theory; the straight wing without lift does not bend away from it.
    let arguments = ["--wing", wing, "--airspeeds", "90,130", "--alpha", "0", "--nonlinear"];
    stopped(&arguments, 3, &["no stable equilibrium", "130.00 m/s", "the last one was at"]);
    std::fs::remove_dir_all(folder).expect("it was made above");
}

/// The cantilever under subcases of its own, E I = 1.
fn with_subcases(folder: &Path, case_control: &str, cards: &str) {
    cantilever(folder, "");
    let deck = std::fs::read_to_string(folder.join("wing.bdf")).expect("a deck");
    let deck = deck.replace("SOL 106\nCEND\nSPC = 1\n", &format!("SOL 101\nCEND\n{case_control}"));
    std::fs::write(folder.join("wing.bdf"), deck.replace("ENDDATA", &format!("{cards}ENDDATA")))
        .expect("a deck");
}

#[test]
fn every_subcase_has_the_loads_and_supports_that_it_selects() {
    let folder = folder("subcases");
    // Both ends held in the second.
    with_subcases(
        &folder,
        "SUBCASE 1\nSPC = 1\nLOAD = 30\nSUBCASE 2\nSPC = 2\nLOAD = 40\nSUBCASE 3\nSPC = 1\nLOAD = 20\n",
        "SPC1,2,123456,1,17\nFORCE,40,9,,1.,0.,0.,1.\n",
    );
    let all = result(&folder, &["--deck", "wing.bdf"]);
    let z = |value: &Value| value["linear_displacement_m"][2].as_f64().expect("a number");
    let further = all["further"].as_array().expect("two more subcases");
    // P L^3/(3 E I), clamped at both ends P L^3/(192 E I).
    for (of, subcase, set, wanted) in
        [(&all, 1, 30, 1.0 / 3.0), (&further[0], 2, 40, 1.0 / 192.0), (&further[1], 3, 20, 4.0 / 3.0)]
    {
        assert_eq!((of["subcase"].as_u64(), of["load_set"].as_u64()), (Some(subcase), Some(set)));
        assert!((z(of) / wanted - 1.0).abs() < 1e-5, "subcase {subcase}: {} for {wanted}", z(of));
    }
    assert!(
        folder.join("out/subcase_3_displacements.csv").is_file()
            && folder.join("out/reactions.csv").is_file()
    );
    let one = result(&folder, &["--deck", "wing.bdf", "--subcase", "2"]);
    assert_eq!((z(&one), one.get("further")), (z(&further[0]), None));
    // A combination is said not to be computed, and the others are.
    with_subcases(
        &folder,
        "SPC = 1\nSUBCASE 1\nLOAD = 30\nSUBCASE 2\nLOAD = 20\nSUBCOM 3\nSUBSEQ = 1.,1.\n",
        "",
    );
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.args(["statics", "--deck", "wing.bdf", "--numbers-only", "--out", "said"]);
    let output = command.current_dir(&folder).output().expect("the command starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.contains("`SUBCOM 3` is not computed"), "{said}");
    // The second is heated beside its load: the tip moves by alpha T L along the beam, and not across.
    with_subcases(
        &folder,
        "SPC = 1\nSUBCASE 1\nLOAD = 30\nSUBCASE 2\nTEMP = 5\nLOAD = 30\n",
        "TEMPD,5,20.\n",
    );
    let path = folder.join("wing.bdf");
    let deck = std::fs::read_to_string(&path).expect("a deck");
    std::fs::write(&path, deck.replace("MAT1,1,1.+6,,0.", "MAT1,1,1.+6,,0.,,1.-4")).expect("a deck");
    let heated = result(&folder, &["--deck", "wing.bdf"]);
    let along = |value: &Value| value["linear_displacement_m"][0].as_f64().expect("a number");
    let second = &heated["further"][0];
    assert!(along(&heated).abs() < 1e-12, "the first subcase selects no temperatures");
    assert!((along(second) / 2e-3 - 1.0).abs() < 1e-9, "the tip moves by {}", along(second));
    assert!((z(second) / z(&heated) - 1.0).abs() < 1e-9);
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn a_motion_that_spc_enforces_is_met_and_its_reaction_is_that_of_the_beam() {
    let folder = folder("enforced");
    // The tip is pushed by 0.3 along the axes of a system turned a quarter: its x is basic z.
    with_subcases(
        &folder,
        "SPC = 3\n",
        "SPCADD,3,1,2\nSPC,2,17,1,.3\nCORD2R,7,,0.,0.,0.,0.,1.,0.\n,0.,0.,1.\n",
    );
    let path = folder.join("wing.bdf");
    let deck = std::fs::read_to_string(&path).expect("a deck");
    let deck =
        deck.replace("GRID,17,,1.000000,0.,0.", "GRID,17,,1.000000,0.,0.,7").replace("FORCE,", "$ FORCE,");
    std::fs::write(&path, deck).expect("a deck");
    let enforced = result(&folder, &["--deck", "wing.bdf"]);
    assert_eq!(enforced["load_set"], 0);
    let z = enforced["displacement_m"][2].as_f64().expect("a number");
    assert!((z - 0.3).abs() < 1e-12, "the tip is at {z}");
    // 3 E I d/L^3 at the tip, the opposite at the root.
    let table = std::fs::read_to_string(folder.join("out/reactions.csv")).expect("reactions");
    let row = |grid: &str| -> Vec<f64> {
        let line = table.lines().find(|line| line.starts_with(grid)).expect("a reaction");
        line.split(',').skip(1).map(|cell| cell.parse().expect("a number")).collect()
    };
    let (root, tip) = (row("1,"), row("17,"));
    assert!((tip[0] / 0.9 - 1.0).abs() < 1e-5, "the tip is pushed by {tip:?}, along its own x");
    assert!((root[2] / -0.9 - 1.0).abs() < 1e-5, "the root gives {root:?}");
    let output = run(&folder, &["--deck", "wing.bdf", "--nonlinear"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("no motions that SPC or SPCD enforces"), "{said}");
    std::fs::remove_dir_all(folder).expect("it was made above");
}

#[test]
fn the_load_of_the_case_control_is_taken_unless_another_is_named() {
    let folder = folder("load");
    let tip = |arguments: &[&str]| {
        let result = result(&folder, &[&["--deck", "wing.bdf"], arguments].concat());
        result["linear_displacement_m"][2].as_f64().expect("a number")
    };
    // P L^3 / 3 E I of P = 1 (set 30) and P = 4 (set 20).
    cantilever(&folder, "LOAD = 30\n");
    assert!((tip(&[]) - 1.0 / 3.0).abs() < 1e-6, "LOAD before the first SUBCASE");
    assert!((tip(&["--load", "20"]) - 4.0 / 3.0).abs() < 1e-6, "--load says more than the deck");
    cantilever(&folder, "SUBCASE 1\nLOAD = 20\nSUBCASE 7\nLOAD = 30\n");
    assert!((tip(&["--subcase", "7"]) - 1.0 / 3.0).abs() < 1e-6, "LOAD of subcase 7");
    std::fs::remove_dir_all(&folder).expect("it was made above");
}

/// Two masses of 2 and 1 kg on a spring of 1000 N/m, pulled apart by 3 N at the second.
fn pulled(folder: &Path, more: &str) {
    let deck = format!(
        "SOL 101\nCEND\nLOAD = 1\nSPC = 1\nBEGIN BULK\n{more}GRID,1,,0.,0.,0.\nGRID,2,,0.,0.,0.\nCELAS2,1,1000.,1,3,2,3\n\
         CONM2,1,1,,2.\nCONM2,2,2,,1.\nSPC1,1,12456,1,2\nSUPORT,1,3\nFORCE,1,2,,3.,0.,0.,1.\nENDDATA\n"
    );
    std::fs::write(folder.join("wing.bdf"), deck).expect("a deck");
}

#[test]
fn a_supported_structure_is_held_or_accelerates_under_its_loads() {
    let folder = folder("relief");
    let moved = || {
        let result = result(&folder, &["--deck", "wing.bdf"]);
        result["displacement_m"][2].as_f64().expect("a number")
    };
    pulled(&folder, "");
    assert!((moved() - 3e-3).abs() < 1e-12, "the SUPORT holds grid 1: 3 N / 1000 N/m");
    pulled(&folder, "PARAM,INREL,-1\n");
    assert!(
        (moved() - 2e-3).abs() < 1e-12,
        "1 m/s^2: 2 N of the 3 go through the spring to the mass of 2 kg"
    );
    let reactions = std::fs::read_to_string(folder.join("out/reactions.csv")).expect("reactions");
    let held: f64 = reactions
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').nth(3)?.parse::<f64>().ok())
        .map(f64::abs)
        .sum();
    assert!(held < 1e-12, "nothing is left for the SUPORT: {reactions}");
    pulled(&folder, "PARAM,INREL,-2\n");
    let output = run(&folder, &["--deck", "wing.bdf"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("PARAM INREL is -2; 0 and -1 are read"));
    std::fs::remove_dir_all(&folder).expect("it was made above");
}

/// MSC.Nastran Quick Reference Guide, PARAM LGDISP: for SOL 106, 129 and 400.
#[test]
fn large_displacements_of_a_linear_solution_are_small() {
    let folder = folder("lgdisp");
    let is_large = |solution: &str| {
        cantilever(&folder, "LOAD = 30\n");
        let deck = std::fs::read_to_string(folder.join("wing.bdf")).expect("a deck");
        let deck = deck.replace("SOL 106", solution).replace("BEGIN BULK\n", "BEGIN BULK\nPARAM,LGDISP,1\n");
        std::fs::write(folder.join("wing.bdf"), deck).expect("a deck");
        result(&folder, &["--deck", "wing.bdf"])["large_deflections"].as_bool().expect("a flag")
    };
    assert_eq!(["SOL 101", "SOL 106"].map(is_large), [false, true]);
    std::fs::remove_dir_all(&folder).expect("it was made above");
}
