//! Flutter of the Pazy wing about its bent state, root at 3 degrees: onset and offset of the hump beside the test (Drachinsky et al.,
//! AIAA J., 2022) and UM/NAST (Riso and Cesnik, J. Aircraft, 2023).

use aero::{Corrections, Flow};
use coupling::{LargeWing, Mount, SteadyCase, WingFile};
use maneuver::flutter::{crossings, flutter_of_bent_wing};
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::Path;

#[test]
fn the_hump_of_the_bent_wing_begins_and_ends_as_measured() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let file = WingFile::read(&data.join("pazy/wing.ron")).unwrap();
    let wing = LargeWing::from_bulk(&file, &file.bulk(Mount::Tunnel).unwrap()).unwrap().weightless().unwrap();
    let case = |v_m_s: f64| SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, 3.0_f64.to_radians());
    let cases: Vec<SteadyCase> =
        [20.0, 40.0, 44.0, 46.0, 48.0, 50.0, 52.0, 54.0, 56.0, 58.0, 60.0].map(case).to_vec();
    let neutral = vec![Corrections::neutral(wing.elastic.correctable.len()); cases.len()];
    let points = flutter_of_bent_wing(&wing, &cases, &neutral, 7, 0.0).unwrap();
    for point in &points {
        let roots: Vec<String> = point
            .roots
            .iter()
            .map(|root| format!("{:.2} Hz {:+.4}", root.im / TAU, 2.0 * root.re / root.im))
            .collect();
        let natural: Vec<String> =
            point.omega_rad_s.iter().map(|omega| format!("{:.2}", omega / TAU)).collect();
        println!(
            "{} m/s: tip {:.2} %, natural {}; {}",
            point.case.flow.v_m_s,
            point.state.tip_m.z / 0.0055,
            natural.join(" "),
            roots.join(", ")
        );
    }
    let found = crossings(&points);
    for crossing in &found {
        println!("{crossing:?}");
    }
    let text = std::fs::read_to_string(data.join("published/nl_pazy__flutter_deformed_aoa3.json")).unwrap();
    let published: Value = serde_json::from_str(&text).unwrap();
    let measured = |name: &str| published["expected"]["measured_aoa3"][name].as_f64().unwrap();
    let [onset, offset] = found.as_slice() else { panic!("not one hump: {found:?}") };
    assert!(onset.unstable && !offset.unstable, "{found:?}");
    let off = |own: f64, name: &str| (own / measured(name) - 1.0).abs();
    assert!(off(onset.v_m_s, "onset_m_s") < 0.05, "onset at {} m/s", onset.v_m_s);
    assert!(off(offset.v_m_s, "offset_m_s") < 0.06, "offset at {} m/s", offset.v_m_s);
    assert!(off(onset.frequency_hz, "onset_hz") < 0.07, "onset with {} Hz", onset.frequency_hz);
    assert!(off(offset.frequency_hz, "offset_hz") < 0.07, "offset with {} Hz", offset.frequency_hz);
}
