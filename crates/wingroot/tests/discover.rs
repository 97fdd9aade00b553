//! `cargo xtask discover` on the shipped campaign, in which a joiner's mass and the ailerons' loss of effectiveness are hidden
//! (`data/tuflex/measured/README.md` says so; the planted numbers below are its).

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use coupling::WingFile;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Runs the command; exit status, standard error and the folder of results.
fn discover(name: &str, more: &[&str]) -> (Option<i32>, String, PathBuf) {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["discover", "--quiet", "--out"])
        .arg(&out)
        .args(if more.contains(&"--wing") { &[][..] } else { &["--wing", "data/tuflex/wing.ron"] })
        .args(more)
        .current_dir(root())
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned(), out)
}

fn result(folder: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("result.json")).unwrap()).unwrap()
}

/// The shipped campaign, searched once for all tests.
fn shipped() -> &'static (PathBuf, Value) {
    static SHIPPED: OnceLock<(PathBuf, Value)> = OnceLock::new();
    SHIPPED.get_or_init(|| {
        let (status, said, out) = discover("discover-shipped", &[]);
        assert_eq!(status, Some(0), "{said}");
        let result = result(&out);
        (out, result)
    })
}

#[test]
fn the_hidden_joiner_and_saturation_are_named_and_nothing_else() {
    let (_, result) = shipped();
    let mut names: Vec<&str> =
        result["effects"].as_array().unwrap().iter().map(|e| e["name"].as_str().unwrap()).collect();
    names.sort_unstable();
    assert_eq!(names, ["ctl_saturation", "joiner_inertia"]);
    assert_eq!(result["verdict"], "effects", "{result:#}");
}

#[test]
fn the_joiner_s_inertia_and_first_moment_are_the_planted_ones() {
    let (_, result) = shipped();
    let joiner =
        result["effects"].as_array().unwrap().iter().find(|e| e["name"] == "joiner_inertia").unwrap();
    let value = |name: &str| joiner["parameters"][name]["value"].as_f64().unwrap();
    // planted: 5 kg, .02 m forward, .15 kg m2 about the pitch axis
    let (inertia, moment) = (value("Iyy_kg_m2"), value("mx_kg_m"));
    assert!((inertia / 0.15 - 1.0).abs() < 0.03, "{inertia}");
    assert!((moment / -0.1 - 1.0).abs() < 0.1, "{moment}");
}

#[test]
fn the_held_out_gap_closes_to_at_most_twice_its_floor() {
    let (_, result) = shipped();
    let gap = |name: &str| result["gap"]["holdout"][name].as_f64().unwrap();
    assert!(gap("after") < 0.6 * gap("before") && gap("after") <= 2.0 * gap("floor"), "{}", result["gap"]);
    assert_eq!(result["success"], true);
}

#[test]
fn the_residual_is_located_in_large_deflections_and_fast_pitch() {
    let (_, result) = shipped();
    let located = result["located"].as_array().unwrap();
    let has = |channel: &str, regressor: &str| {
        located
            .iter()
            .any(|l| l["channel"] == channel && l["regressor"].as_str().unwrap().contains(regressor))
    };
    assert!(has("Fz_N", "delta|delta|") && has("My_Nm", "alpha_ddot"), "{located:#?}");
}

#[test]
fn the_updated_wing_reads_back_with_its_effects_and_new_corrections() {
    let (out, _) = shipped();
    let wing = WingFile::read(&out.join("wing.ron")).unwrap();
    let names: Vec<&str> = wing.effects.iter().map(|effect| effect.name.as_str()).collect();
    assert_eq!(names.len(), 2, "{names:?}");
    let corrections = calibrate::Schedule::read(&out.join("corrections.ron")).unwrap();
    assert_eq!(corrections.wing_hash, wing.hash);
    assert_eq!(corrections.sets.len(), 5);
    assert!(out.join("runs/aoa_4hz_30.svg").is_file() && out.join("map.csv").is_file());
}

#[test]
fn the_shipped_null_distribution_belongs_to_the_shipped_wing_and_campaign_and_has_every_effect() {
    let path = root().join("data/tuflex/null_distribution.ron");
    let nulls: discover::null_distribution::NullDistribution = nastran::ron_file::read(&path).unwrap();
    // what the command was run with, and writes again
    let (out, _) = shipped();
    let used = nastran::ron_file::read(&out.join("null_distribution.ron")).unwrap();
    assert_eq!(nulls, used, "made for {:?}", nulls.key.differs_in(&used.key));
    let result = std::fs::read_to_string(out.join("result.json")).unwrap();
    assert!(result.contains("data/tuflex/null_distribution.ron"), "made anew");
    assert!(nulls.serves(&nulls.key, &maneuver::effects::library(&["any".to_owned()])));
    assert!(nulls.floor.iter().all(|floor| *floor > 1.0), "{nulls:?}");
}

#[test]
fn a_wing_that_has_effects_already_is_refused() {
    let (out, _) = shipped();
    let wing = out.join("wing.ron");
    let (status, said, _) =
        discover("discover-twice", &["--wing", wing.to_str().unwrap(), "--campaign", "data/tuflex/measured"]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("the wing has effects already") && said.contains("hint: "), "{said}");
}

/// A copy of the shipped campaign with one file changed.
fn changed(name: &str, file: &str, change: impl Fn(&str) -> String) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    for entry in std::fs::read_dir(root().join("data/tuflex/measured")).unwrap().flatten() {
        std::fs::copy(entry.path(), folder.join(entry.file_name())).unwrap();
    }
    let path = folder.join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, change(&text)).unwrap();
    folder
}

#[test]
fn a_channel_with_its_sign_flipped_is_a_defect_that_stops_the_search() {
    let flipped = changed("campaign-flipped", "doublet_inner_15_22.csv", |text| {
        let mut lines = text.lines();
        let header = lines.next().unwrap();
        let column = header.split(',').position(|name| name == "My_Nm").unwrap();
        let flip = |line: &str| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            cells[column] = format!("{:.4}", -cells[column].parse::<f64>().unwrap());
            cells.join(",")
        };
        std::iter::once(header.to_owned()).chain(lines.map(flip)).collect::<Vec<_>>().join("\n")
    });
    let (status, said, out) = discover("discover-flipped", &["--campaign", flipped.to_str().unwrap()]);
    assert_eq!(status, Some(3), "{said}");
    assert!(said.contains("doublet_inner_15_22") && said.contains("My"), "{said}");
    // what there is of it stands beside the place of a good result
    assert!(!out.exists());
    let result = result(&out.with_extension("incomplete"));
    assert_eq!(result["verdict"], "data_defect");
    assert_eq!(result["effects"].as_array().unwrap().len(), 0);
}

#[test]
fn without_repeats_and_stated_noise_it_asks_for_the_noise() {
    let silent = changed("campaign-silent", "campaign.ron", |text| {
        let (start, end) = (text.find("    noise: Some((").unwrap(), text.find("    static_cases:").unwrap());
        let silent = format!("{}    noise: None,\n{}", &text[..start], &text[end..]);
        let without: Vec<String> = silent
            .lines()
            .map(|line| match line.find(", repeat_of: ") {
                Some(at) => format!("{}),", &line[..at]),
                None => line.to_owned(),
            })
            .collect();
        without.join("\n")
    });
    let (status, said, _) = discover("discover-silent", &["--campaign", silent.to_str().unwrap()]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("the noise is not known") && said.contains("repeat_of"), "{said}");
}
