//! Files of a crate that take names from each other in a circle cannot be read one after the other: few may, each for a
//! reason.

use std::collections::{BTreeMap, BTreeSet};

use super::complaint::Complaint;
use super::modules::Modules;
use super::parsed::Source;

/// The most circles in the whole workspace.
const MOST: usize = 9;
/// Circles that may be, by their files, and why.
const MAY: &[(&[&str], &str)] = &[
    (
        &[
            "crates/calibrate/src/calibration.rs",
            "crates/calibrate/src/checks/trust.rs",
            "crates/calibrate/src/common.rs",
            "crates/calibrate/src/left_out.rs",
        ],
        "a calibration holds one set for all airspeeds, what was left out, and whether small deflections say the same: all \
         calibrate again",
    ),
    (
        &[
            "crates/coupling/src/planform/beam.rs",
            "crates/coupling/src/planform/check.rs",
            "crates/coupling/src/planform/mod.rs",
            "crates/coupling/src/planform/panels.rs",
            "crates/coupling/src/planform/point_mass.rs",
            "crates/coupling/src/planform/shell/settings.rs",
            "crates/coupling/src/planform/structure.rs",
        ],
        "the planform of a wing's file, whose parts are placed on it and checked against it",
    ),
    (
        &[
            "crates/coupling/src/planform/shell/laminates.rs",
            "crates/coupling/src/planform/shell/mesh.rs",
            "crates/coupling/src/planform/shell/mod.rs",
        ],
        "laminates are given by zones of the mesh, and the mesh is divided where laminates change",
    ),
    (
        &[
            "crates/maneuver/src/assemble.rs",
            "crates/maneuver/src/operators.rs",
            "crates/maneuver/src/rig.rs",
            "crates/maneuver/src/state_space.rs",
        ],
        "a rig is assembled from operators in the order of its own rows",
    ),
    (
        &["crates/maneuver/src/maneuver_file.rs", "crates/maneuver/src/maneuver_file/check.rs"],
        "a file and what is wrong with it",
    ),
    (
        &["crates/maneuver/src/motion/mod.rs", "crates/maneuver/src/motion/schema.rs"],
        "the list of kinds gives the schema of each, with what every kind has beside its own fields",
    ),
    (
        &["crates/structure/src/beam.rs", "crates/structure/src/beam_mass.rs"],
        "stiffness and mass of one element",
    ),
    (
        &["crates/tunnel/src/curvature.rs", "crates/tunnel/src/truth.rs"],
        "the truth is curved, and the curvature is found with the truth without it",
    ),
];

/// Complaints about circles that have no reason, and about reasons that have no circle.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let circles = all(sources);
    let mut complaints = Vec::new();
    for circle in &circles {
        let files: Vec<&str> = circle.iter().map(String::as_str).collect();
        if !MAY.iter().any(|(may, _)| *may == files) {
            let others = files[1..].join(", ");
            complaints.push(Complaint::new(files[0], format!("takes names in a circle with {others}")));
        }
    }
    let gone = |files: &[&str]| !circles.iter().any(|circle| circle == files);
    for (files, _) in MAY.iter().filter(|(files, _)| gone(files)) {
        complaints.push(Complaint::new(files[0], "has a reason for a circle that is no more"));
    }
    if circles.len() > MOST {
        complaints
            .push(Complaint::new("crates", format!("{} circles of files, at most {MOST}", circles.len())));
    }
    complaints
}

/// The circles of all crates, each with its files sorted.
pub fn all(sources: &[Source]) -> Vec<Vec<String>> {
    let folder =
        |source: &Source| source.name.split_once("/src/").map(|(package, _)| format!("{package}/src/"));
    let folders: BTreeSet<String> = sources.iter().filter_map(folder).collect();
    folders.iter().flat_map(|folder| circles(&Modules::of(sources, folder).taken())).collect()
}

/// Sets of files each of which reaches every other.
fn circles(taken: &BTreeMap<&str, BTreeSet<&str>>) -> Vec<Vec<String>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> =
        taken.keys().map(|file| (*file, reach(taken, file))).collect();
    let mut circles = BTreeSet::new();
    for (file, others) in &reached {
        let circle: Vec<String> =
            others.iter().filter(|other| reached[*other].contains(file)).map(ToString::to_string).collect();
        if circle.len() > 1 {
            circles.insert(circle);
        }
    }
    circles.into_iter().collect()
}

fn reach<'a>(taken: &BTreeMap<&'a str, BTreeSet<&'a str>>, from: &'a str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&str> = vec![from];
    while let Some(file) = open.pop() {
        open.extend(taken[file].iter().copied().filter(|next| reached.insert(*next)));
    }
    reached
}
