//! Flutter of the Pazy wing about its bent state, root at 3 degrees: onset and offset of the hump beside the test (Drachinsky et al.,
//! AIAA J., 2022) and UM/NAST (Riso and Cesnik, J. Aircraft, 2023).

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::Corrections;
use coupling::{LargeWing, Mount, WingFile};
use maneuver::flutter::{BentFlutter, BentSweep};
use serde_json::Value;
use std::path::{Path, PathBuf};

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data")
}

/// The measured wing without weight at a root angle.
fn swept(alpha_deg: f64, airspeeds: &[f64]) -> BentSweep {
    let file = WingFile::read(&data().join("pazy/wing.ron")).unwrap();
    let wing = LargeWing::from_bulk(&file, &file.bulk(Mount::Tunnel).unwrap()).unwrap().weightless().unwrap();
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    let task = BentFlutter {
        wing: &wing,
        alpha_rad: alpha_deg.to_radians(),
        rho_kg_m3: 1.225,
        modes: 7,
        damping_ratio: 0.0,
    };
    task.over(airspeeds, &|_| neutral.clone()).unwrap()
}

#[test]
fn the_hump_of_the_bent_wing_begins_and_ends_as_measured() {
    let sweep = swept(3.0, &[20.0, 40.0, 46.0, 50.0, 54.0, 58.0, 62.0]);
    let text = std::fs::read_to_string(data().join("published/nl_pazy__flutter_deformed_aoa3.json")).unwrap();
    let published: Value = serde_json::from_str(&text).unwrap();
    let measured = |name: &str| published["expected"]["measured_aoa3"][name].as_f64().unwrap();
    let [onset, offset] = sweep.crossings.as_slice() else { panic!("not one hump: {:?}", sweep.crossings) };
    assert!(onset.unstable && !offset.unstable && onset.branch == offset.branch, "{:?}", sweep.crossings);
    let off = |own: f64, name: &str| (own / measured(name) - 1.0).abs();
    assert!(off(onset.v_m_s, "onset_m_s") < 0.05, "onset at {} m/s", onset.v_m_s);
    assert!(off(offset.v_m_s, "offset_m_s") < 0.06, "offset at {} m/s", offset.v_m_s);
    assert!(off(onset.frequency_hz, "onset_hz") < 0.07, "onset with {} Hz", onset.frequency_hz);
    assert!(off(offset.frequency_hz, "offset_hz") < 0.07, "offset with {} Hz", offset.frequency_hz);
}
