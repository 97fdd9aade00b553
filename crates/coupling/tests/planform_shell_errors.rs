//! A shell-and-solid wing's file with a slip in it: one sentence with the place, what was found and what is expected.

use coupling::wing_file::WingFile;
use std::path::{Path, PathBuf};

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(file)
}

/// The complaint about the shipped wing with `from` replaced by `to`, and the line it blames.
fn complaint(test: &str, from: &str, to: &str) -> (String, String) {
    let folder = std::env::temp_dir().join(format!("wingroot_shell_{test}_{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    std::fs::copy(data("e214.dat"), folder.join("e214.dat")).expect("the section");
    let text = std::fs::read_to_string(data("wing.ron")).expect("the shipped wing");
    assert!(text.contains(from), "the wing file does not contain {from}");
    let text = text.replacen(from, to, 1);
    let path = folder.join("wing.ron");
    std::fs::write(&path, &text).expect("a temporary file");
    let outcome = WingFile::read(&path);
    std::fs::remove_dir_all(&folder).expect("the folder is ours");
    let error = outcome.err().unwrap_or_else(|| panic!("{test} was accepted")).to_string();
    let line = error.split("wing.ron:").nth(1).and_then(|rest| rest.split(':').next()?.parse::<usize>().ok());
    let blamed = line.and_then(|line| text.lines().nth(line - 1)).unwrap_or_default().to_owned();
    (error, blamed)
}

/// Test's name, what stands in the shipped file, what is put there, part of the complaint, part of the line blamed.
const SLIPS: &[[&str; 5]] = &[
    ["chordwise", "chordwise_per_box: 1", "chordwise_per_box: 0", "chordwise_per_box is 0", "mesh: ("],
    [
        "finest",
        "spanwise_per_strip: 1, chordwise_per_box: 1",
        "spanwise_per_strip: 9, chordwise_per_box: 9",
        "163296 solids",
        "mesh: (",
    ],
    ["edges", "(0.01, 0.97)),", "(0.1, 0.97)),", "edges_over_c is (0.1, 0.97)", "edges_over_c"],
    ["sharp", "(0.01, 0.97)),", "(0.0, 1.0)),", "chords thick at 0.0000", ""],
    [
        "axis",
        "elastic_axis_over_c: 0.38",
        "elastic_axis_over_c: 38.0",
        "elastic_axis_over_c is 38",
        "elastic_axis",
    ],
    ["nu12", "nu12: 0.28", "nu12: 2.8", "the material \"glass UD\" cannot be", "glass UD"],
    ["same_name", "(name: \"glass UD\"", "(name: \"glass cloth\"", "two materials are called", "glass cloth"],
    ["foam", "nu: 0.3,", "nu: 0.5,", "the foam cannot be", "foam:"],
    [
        "unknown",
        "material: \"glass UD\"",
        "material: \"glas UD\"",
        "no material is called \"glas UD\"",
        "glas UD",
    ],
    ["nowhere", "on: [Webs]", "on: []", "ply 4 lies nowhere", "plies:"],
    [
        "no_skin",
        "thickness_m: [(0.0, 0.08e-3), (0.9",
        "thickness_m: [(0.9, 0.08e-3), (0.9",
        "the thickness of ply 2",
        "plies:",
    ],
    ["millimetres", "[(0.0, 0.165e-3)", "[(0.0, 0.165)", "the thickness of ply 1", "plies:"],
    ["band", "centre_over_c: 0.34", "centre_over_c: 0.98", "the band of ply 2 leaves the skin", "plies:"],
    ["band_off", "on: [Upper, Lower], thick", "on: [Webs], thick", "ply 2 has a band off the skin", "plies:"],
    [
        "webs",
        "webs_over_c: [0.333, 0.75]",
        "webs_over_c: [0.333, 0.34]",
        "no separate chord lines",
        "webs_over_c",
    ],
    [
        "edge_web",
        "webs_over_c: [0.333, 0.75]",
        "webs_over_c: [0.0]",
        "no separate chord lines",
        "webs_over_c",
    ],
    ["webless", "webs_over_c: [0.333, 0.75]", "webs_over_c: []", "webs and their plies", "plies:"],
    ["cables", "mass_kg_m: 0.09", "mass_kg_m: -0.09", "mass_kg_m -0.09", "cables"],
    [
        "balance",
        "(1e8, 1e8, 1e8, 1e7, 1e7, 1e7)",
        "(1e8, 1e8, 0.0, 1e7, 1e7, 1e7)",
        "balance_stiffness has 0.0",
        "balance_stiffness",
    ],
    ["mass", "y_m: 1.545", "y_m: 15.45", "servo_outer has y_m 15.45", "servo_outer"],
    ["airfoil", "airfoil: \"e214.dat\",", "", "needs an airfoil", ""],
    ["word", "finish_kg_m2", "finish", "finish_kg_m2", "finish"],
];

#[test]
fn a_slip_is_named_at_its_line() {
    for &[test, from, to, expected, line] in SLIPS {
        let (error, blamed) = complaint(test, from, to);
        assert!(error.contains(expected), "{test}: {error}");
        assert!(blamed.contains(line), "{test}: {error} blames {blamed}");
    }
}

#[test]
fn a_skin_with_a_gap_is_refused() {
    // Both layers of cloth end at 0.9 m: the cap alone is no skin.
    let folder = std::env::temp_dir().join(format!("wingroot_shell_gap_{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    std::fs::copy(data("e214.dat"), folder.join("e214.dat")).expect("the section");
    let text = std::fs::read_to_string(data("wing.ron")).expect("the shipped wing");
    let text = text.replace("(1.8, 0.09e-3)]", "(1.8, 0.0)]");
    let path = folder.join("wing.ron");
    std::fs::write(&path, text).expect("a temporary file");
    let error = WingFile::read(&path).expect_err("the skin has a gap").to_string();
    std::fs::remove_dir_all(&folder).expect("the folder is ours");
    assert!(error.contains("no ply covers Upper at y = 1.800 m"), "{error}");
}
