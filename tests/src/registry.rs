//! Every published case: which function computes it, or why it is not compared.

use crate::cases;
use crate::row::{Row, Verdict};
use serde_json::Value;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// A case of `data/published` that is computed.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// File name without `.json`.
    pub file: &'static str,
    /// From the file's content to rows. May panic where the file is not what it should be: [`compute`] turns that
    /// into words.
    pub run: fn(&Value) -> Vec<Row>,
}

/// A case that is computed, with its result.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// File name without `.json`.
    pub file: String,
    /// Source as the file gives it.
    pub source: String,
    /// The rows, or why there are none.
    pub rows: Result<Vec<Row>, String>,
}

impl Outcome {
    /// Whether every row is met, known or recorded.
    pub fn is_good(&self) -> bool {
        self.rows
            .as_ref()
            .is_ok_and(|rows| !rows.is_empty() && rows.iter().all(|row| row.verdict() != Verdict::NotMet))
    }
}

/// Every case that is computed. A new file of cases has its line here.
pub fn cases() -> impl Iterator<Item = &'static Case> {
    [
        cases::vlm::CASES,
        cases::wings::CASES,
        cases::divergence::CASES,
        cases::plates::CASES,
        cases::shells::CASES,
        cases::solids::CASES,
        cases::pagano::CASES,
        cases::vibrations::CASES,
        cases::laminates::CASES,
        cases::dlm::CASES,
        cases::unsteady2d::CASES,
        cases::gusts::CASES,
        cases::gust_bah::CASES,
        cases::flutter_plate::CASES,
        cases::flutter_decks::CASES,
        cases::flutter_strips::CASES,
        cases::flutter_wings::CASES,
        cases::trim::CASES,
    ]
    .into_iter()
    .flatten()
}

/// Files of `data/published` that are not compared, and why.
pub const LISTED: &[(&str, &str)] = &[
    ("trim__freedlm", "its deck is named, but not in the file"),
    ("fem__cquad4_stiffness", "compared in crates/structure/tests/prints_of_nastran.rs, entry by entry"),
    (
        "nl_beam__bathe_bolourchi_45",
        "compared in crates/structure/tests/large_deflections.rs at every load of the table",
    ),
    (
        "nl_beam__elastica_end_shear",
        "compared in crates/structure/tests/large_deflections.rs at every load of the table",
    ),
    (
        "nl_pazy__static_torsion_skin0",
        "compared in crates/structure/tests/large_pazy.rs at every load of the table",
    ),
    (
        "nl_pazy__flutter_deformed_aoa3",
        "compared in crates/maneuver/tests/bent_flutter.rs: the measured onset and offset at 3 degrees",
    ),
    (
        "nl_pazy__modes_deformed_skin0_to26pct",
        "compared in crates/coupling/tests/large_motion.rs at every rise of the tip of the beam",
    ),
    (
        "nl_pazy__static_aeroelastic_aoa5",
        "compared in crates/coupling/tests/large_pazy.rs: without skin at seven airspeeds, with skin the wing of data/pazy",
    ),
    (
        "nl_shell__sze_3_1_end_shear",
        "compared in crates/structure/tests/large_shells.rs at every load of the table",
    ),
    (
        "nl_shell__sze_3_2_end_moment",
        "compared in crates/structure/tests/large_shells.rs at every load of the table",
    ),
    (
        "nl_shell__sze_3_3_slit_annulus",
        "compared in crates/structure/tests/large_shells.rs at every load of the table",
    ),
    (
        "nl_shell__sze_3_5_pull_out",
        "compared in crates/structure/tests/large_curved_shells.rs to half of the load, where the cylinder snaps through",
    ),
    (
        "nl_shell__sze_3_7_semi_cylinder",
        "compared in crates/structure/tests/large_curved_shells.rs: five loads, with RUN_SLOW_TESTS every one",
    ),
    (
        "nl_pazy__static_bending_skin1",
        "compared in crates/structure/tests/large_pazy.rs: the codes' equivalent beam with skin",
    ),
    (
        "nl_pazy__flutter_onset_over_angle",
        "compared in crates/maneuver/tests/bent_wings.rs at 3, 5 and 7 degrees with RUN_SLOW_TESTS",
    ),
    (
        "nl_pazy__swept10",
        "compared in crates/maneuver/tests/bent_wings.rs with RUN_SLOW_TESTS: shape and onset",
    ),
    (
        "nl_hale__patil_flutter",
        "compared in crates/maneuver/tests/bent_wings.rs: flutter over the tip, and over the root angle with RUN_SLOW_TESTS",
    ),
    (
        "flutter__pazy_sol145_NO_tipmass",
        "the finite element model of the wing with its skin is not in the file, only the deck's name; `cargo xtask flutter` \
         gives the flutter of the beam in data/pazy, which is fitted to the measured wing",
    ),
    ("flutter__agard445_zona6", "neither mode shapes nor a structure are in the file, only frequencies"),
    (
        "flutter_measured__agard445_low",
        "neither mode shapes nor a structure are in the file, only frequencies",
    ),
    (
        "flutter__ha145b",
        "compared in crates/fullaircraft/tests/handbook.rs: modes, air forces, speeds of flutter",
    ),
    (
        "flutter__goland_pknl",
        "compared in crates/fullaircraft/tests/deck_beyond.rs: every printed root, most of them beyond the deck's frequencies",
    ),
    ("flutter__ha145e_k", "compared in crates/fullaircraft/tests/handbook.rs: K-method curves of the plate"),
    (
        "gust__bah_aileron_response",
        "compared in crates/fullaircraft/tests/handbook.rs: motions over frequency",
    ),
    ("trim__ha144b_roll", "compared in crates/fullaircraft/tests/handbook.rs: rate of roll and derivatives"),
    ("gust__fmondsp_gust", "the glider's deck is not in the file, only its name"),
    ("fem__ha144ds_modes", "the deck of the half model is not in the file, only its frequencies"),
    (
        "fem_measured__tang_dowell_modes",
        "mass and inertia of the slender body at the tip, and the place of the mass axis, are not in the file",
    ),
    ("pazy__pazy_flutter_onset_aoa3", "needs modes about the deformed wing (the case's own note)"),
    (
        "pazy__pazy_gvt",
        "compared in tests/published_pazy.rs, which fits a wing to it first; not a row of this table",
    ),
    (
        "pazy__pazy_static_aeroelastic_aoa3",
        "compared in tests/published_pazy.rs, which fits a wing to it first; not a row of this table",
    ),
    (
        "pazy__pazy_static_aeroelastic_aoa5",
        "compared in tests/published_pazy.rs, which fits a wing to it first; not a row of this table",
    ),
    (
        "pazy__pazy_static_bending_skin1",
        "compared in tests/published_pazy.rs, which fits a wing to it first; not a row of this table",
    ),
    (
        "pazy__pazy_static_torsion_skin1",
        "compared in tests/published_pazy.rs, which fits a wing to it first; not a row of this table",
    ),
];

/// Reads a case from a folder and computes it.
pub fn compute(folder: &Path, case: &Case) -> Outcome {
    let path = folder.join(format!("{}.json", case.file));
    let read = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()));
    let value: Result<Value, String> = read
        .and_then(|text| serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display())));
    let source = value.as_ref().ok().and_then(|value| value["source"].as_str()).unwrap_or_default().into();
    let rows = value.and_then(|value| {
        catch_unwind(AssertUnwindSafe(|| (case.run)(&value))).map_err(|panic| {
            let text = panic.downcast_ref::<String>().cloned();
            let text = text.or_else(|| panic.downcast_ref::<&str>().map(ToString::to_string));
            format!("{}: {}", case.file, text.unwrap_or_else(|| "the computation broke off".into()))
        })
    });
    Outcome { file: case.file.into(), source, rows }
}

/// Computes a registered case and fails if a row is not met: the body of a named test.
///
/// # Panics
/// If no case is registered under that name, it cannot be computed, or a row is not met.
#[track_caller]
pub fn check(file: &str) {
    let case = cases().find(|case| case.file == file);
    let case = case.unwrap_or_else(|| panic!("{file} is not registered (tests/src/registry.rs)"));
    let outcome = compute(&crate::data("published"), case);
    let rows = outcome.rows.unwrap_or_else(|message| panic!("{message}"));
    assert!(!rows.is_empty(), "{file}: nothing was compared");
    let bad: Vec<String> = rows
        .iter()
        .filter(|row| row.verdict() == Verdict::NotMet)
        .map(|row| {
            format!(
                "{}: {} beside {} ({:+.3e}, {:+.3} %), tolerance {}, {:?}",
                row.quantity,
                row.ours,
                row.reference,
                row.difference(),
                100.0 * row.relative_difference(),
                row.tolerance_text(),
                row.tolerance
            )
        })
        .collect();
    assert!(bad.is_empty(), "{file}: {} of {} rows\n{}", bad.len(), rows.len(), bad.join("\n"));
}
