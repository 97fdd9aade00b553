//! Flutter with strip theory: a section on two springs, and Goland's wing (data/published/flutter__*.json).
//!
//! Air forces are Theodorsen's closed form; the roots are those of `maneuver::flutter`.

use crate::number;
use crate::registry::Case;
use crate::row::Row;
use crate::theodorsen::strip_forces;
use aero::Flow;
use faer::Mat;
use maneuver::flutter::{Aeroelastic, Crossing, FormulaForces, GeneralisedForces};
use serde_json::Value;
use std::f64::consts::PI;

/// The cases of this file.
pub const CASES: &[Case] = &[Case { file: "flutter__typical_section_theodorsen", run: typical_section }];

/// Airspeeds from `low` to `high` at one density.
pub fn speeds(low: f64, high: f64, count: usize, rho_kg_m3: f64) -> Vec<Flow> {
    let step = (high - low) / (count - 1) as f64;
    (0..count).map(|i| Flow { v_m_s: low + step * i as f64, rho_kg_m3 }).collect()
}

/// The first flutter of an undamped structure.
///
/// # Panics
/// If there is none: the case's file is not what it should be.
pub fn first_flutter(
    mass: Mat<f64>,
    stiffness: Mat<f64>,
    forces: &dyn GeneralisedForces,
    flows: &[Flow],
) -> Crossing {
    let n = mass.nrows();
    let system = Aeroelastic::new(mass, Mat::zeros(n, n), stiffness, forces).expect("matrices of one size");
    let curves = system.pk(flows).unwrap_or_else(|error| panic!("{error}"));
    *curves.flutter().unwrap_or_else(|| panic!("no flutter up to {} m/s", flows[flows.len() - 1].v_m_s))
}

/// Lengths in semi-chords, times in periods of torsion over 2 pi, density one.
fn typical_section(case: &Value) -> Vec<Row> {
    let input = |name: &str| number(&case["inputs"][name]);
    let (a, x, r2, ratio) = (input("a"), input("x_alpha"), input("r2"), input("sigma_wh_over_wtheta"));
    let m = PI * input("mu");
    let entries = |e: [f64; 4]| Mat::from_fn(2, 2, |i, j| m * e[2 * i + j]);
    let forces = FormulaForces { size: 2, range: (0.0, 100.0), formula: |kappa| strip_forces(kappa, 1.0, a) };
    let flutter = first_flutter(
        entries([1.0, x, x, r2]),
        entries([ratio * ratio, 0.0, 0.0, r2]),
        &forces,
        &speeds(0.05, 4.0, 80, 1.0),
    );
    let (want, rel) = (&case["expected"]["flutter"][0], number(&case["tolerance"]["rel"]));
    let v = flutter.flow.v_m_s;
    let row = |what: &str, ours: f64, name: &str| Row::relative(what, ours, number(&want[name]), rel);
    vec![
        row("flutter speed over b omega_theta", v, "V_over_b_wtheta"),
        row("frequency over omega_theta", flutter.omega_rad_s, "omega_over_wtheta"),
        row("reduced frequency", flutter.omega_rad_s / v, "k"),
    ]
}
