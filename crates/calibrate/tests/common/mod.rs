//! Campaigns made by the model itself with planted corrections: what calibration must find again is then known.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]
#![allow(dead_code, reason = "each test binary uses its share")]

use aero::{Corrections, Flow};
use calibrate::{Campaign, Noise, Sets, Settings, StaticPoint, TipReading};
use coupling::planform::Planform;
use coupling::wing_file::Source;
use coupling::{ElasticWing, Mount, SteadyCase, SteadyModel, WingFile};
use nastran::Span;
use std::path::{Path, PathBuf};

/// Air density of the campaigns, kg/m3.
pub(crate) const RHO: f64 = 1.225;

/// A shipped wing's file.
pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// The shipped wing on 14 by 6 boxes: same structure, quick to factorise.
pub(crate) fn small_wing() -> ElasticWing {
    wing_with(|planform| {
        planform.boxes.chordwise = 6;
        planform.boxes.spanwise = 14;
        planform.controls.clear();
    })
}

/// The shipped wing with its planform changed.
pub(crate) fn wing_with(change: impl Fn(&mut Planform)) -> ElasticWing {
    wing_of(&file_with(change))
}

pub(crate) fn wing_of(file: &WingFile) -> ElasticWing {
    ElasticWing::from_bulk(file, &file.bulk(Mount::Tunnel).unwrap()).unwrap()
}

/// The shipped beam wing's file with another planform.
pub(crate) fn file_with(change: impl Fn(&mut Planform)) -> WingFile {
    let mut file = WingFile::read(&path("tuflex/wing_beam.ron")).unwrap();
    let Source::Parametric(planform) = &mut file.source else { panic!("the shipped wing is parametric") };
    change(planform);
    file
}

/// Settings that fit the small wing: as many chord strips as boxes.
pub(crate) fn small_settings() -> Settings {
    Settings { chord_strips: 6, ..Settings::default() }
}

/// Corrections of the paper's kind: lift gained at the root and lost at the tip, and a pressure offset.
pub(crate) fn papers_kind(wing: &ElasticWing, offset: f64) -> Corrections {
    let boxes = &wing.correctable;
    let share = |b: usize| (boxes.chord_row[b] as f64 + 0.5) / boxes.chord_rows[b] as f64;
    let linear = |root: f64, tip: f64, b: usize| root + (tip - root) * boxes.y_norm[b];
    Corrections {
        force: (0..boxes.len()).map(|b| linear(1.2 - 0.15 * share(b), 0.6, b)).collect(),
        moment: vec![1.0; boxes.len()],
        pressure_offset: (0..boxes.len()).map(|b| offset * linear(0.4 - 0.2 * share(b), 0.0, b)).collect(),
    }
}

/// A deterministic number in -1..1 for the k-th draw: enough "noise" for tests that need some.
pub(crate) fn draw(k: usize) -> f64 {
    let mut state = (k as u64).wrapping_add(0x9E37_79B9_7F4A_7C15).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    state ^= state >> 29;
    state = state.wrapping_mul(0x94D0_49BB_1331_11EB);
    state ^= state >> 32;
    (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// One row of static cases.
pub(crate) fn row(v_m_s: f64, alpha_rad: f64, loads: [f64; 3], block: Option<&str>) -> StaticPoint {
    StaticPoint {
        v_m_s,
        alpha_rad,
        loads: loads.map(Some),
        block: block.map(str::to_owned),
        controls_rad: Vec::new(),
        tip_z_m: None,
        sensors: Vec::new(),
        span: Span::generated("test"),
    }
}

/// Loads of a wing at angles in degrees.
pub(crate) fn loads(
    wing: &ElasticWing,
    v_m_s: f64,
    alphas_deg: &[f64],
    corrections: &Corrections,
) -> Vec<[f64; 3]> {
    let flow = Flow { v_m_s, rho_kg_m3: RHO };
    let cases: Vec<SteadyCase> = alphas_deg.iter().map(|a| SteadyCase::new(flow, a.to_radians())).collect();
    wing.root_loads(&cases, corrections).unwrap().into_iter().map(coupling::RootLoads::to_array).collect()
}

/// A campaign of rows.
pub(crate) fn campaign(points: Vec<StaticPoint>, noise: Option<Noise>) -> Campaign {
    Campaign {
        path: std::path::PathBuf::new(),
        name: "made by the model itself".into(),
        folder: PathBuf::from("test"),
        rho_kg_m3: RHO,
        noise,
        channels: [true; 3],
        tip: TipReading::Unused,
        sets: Sets::EachAirspeed,
        sensors: Vec::new(),
        points,
        columns: nastran::table::ColumnNames::new(),
        runs: Vec::new(),
    }
}
