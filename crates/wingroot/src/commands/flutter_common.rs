//! What `flutter` with small and with large deflections share: reach, reduced frequencies, the numbers of a method.

use maneuver::flutter::{Crossing, FlutterCurves};

use super::flutter_result::{MethodResult, MethodSpeeds, StabilityChange};

/// Highest airspeed if nothing is said, m/s.
pub(super) const HIGHEST: f64 = 100.0;
/// Reduced frequencies of the doublet lattice, omega c/(2V) with the mean chord.
pub(super) const REDUCED: [f64; 18] =
    [0.0, 0.005, 0.01, 0.02, 0.04, 0.06, 0.09, 0.13, 0.18, 0.24, 0.32, 0.42, 0.55, 0.7, 0.9, 1.15, 1.5, 2.0];

/// Numbers of one method; a sentence where there is none.
pub(super) fn method(curves: &FlutterCurves, divergence: Option<f64>, highest: f64) -> MethodResult {
    let flutter = curves.flutter();
    let none = |what: &str| format!("no {what} below {highest} m/s");
    let mut remarks: Vec<String> = curves.lost.iter().map(ToString::to_string).collect();
    if flutter.is_none() {
        remarks.push(none("flutter"));
    }
    if divergence.is_none() {
        remarks.push(none("divergence"));
    }
    if flutter.is_some_and(|crossing| crossing.beyond_table) {
        remarks
            .push("the flutter frequency is beyond the doublet lattice's table (k = 2): a hint only".into());
    }
    let change = |crossing: &Crossing| StabilityChange {
        v_m_s: crossing.flow.v_m_s,
        frequency_hz: crossing.frequency_hz(),
        mode: crossing.branch + 1,
        becomes: if crossing.unstable { "unstable" } else { "stable" },
    };
    MethodResult {
        speeds: MethodSpeeds::new(&curves.crossings, divergence),
        changes_of_stability: curves.crossings.iter().map(change).collect(),
        remarks,
    }
}
