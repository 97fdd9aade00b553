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

/// Goland's wing, a uniform cantilever: bending and torsion functions of a clamped beam as coordinates, displacement
/// down first.
pub struct Goland {
    /// Span of the half, m.
    pub length: f64,
    /// Chord, m.
    pub chord: f64,
    /// Elastic axis aft of the leading edge, share of the chord.
    pub axis: f64,
    mass: f64,
    static_moment: f64,
    inertia: f64,
    bending: f64,
    torsion: f64,
    /// Functions of each kind.
    pub count: usize,
}

impl Goland {
    /// From a case's file; `about_cg` reads the inertia as one about the centre of gravity.
    pub fn new(inputs: &Value, about_cg: bool, count: usize) -> Self {
        let input = |name: &str| number(&inputs[name]);
        let (chord, mass) = (input("c"), input("m"));
        let arm = (input("CG_frac") - input("EA_frac")) * chord;
        let shift = if about_cg { mass * arm * arm } else { 0.0 };
        Self {
            length: input("L"),
            chord,
            axis: input("EA_frac"),
            mass,
            static_moment: mass * arm,
            inertia: input("I_alpha") + shift,
            bending: input("EI"),
            torsion: input("GJ"),
            count,
        }
    }

    /// Value of function `i` of all 2 `count` at `y`: bending functions first. Both kinds are normalised so that the
    /// square's mean over the span is one.
    pub fn function(&self, i: usize, y: f64) -> f64 {
        if i < self.count {
            cantilever(i, y / self.length)
        } else {
            2.0_f64.sqrt() * (torsion_number(i - self.count) * y / self.length).sin()
        }
    }

    /// Integral over the span of the product of functions i and j.
    fn overlap(&self, i: usize, j: usize) -> f64 {
        if (i < self.count) == (j < self.count) {
            return if i == j { self.length } else { 0.0 };
        }
        let n = 2000;
        let step = self.length / f64::from(n);
        // Simpson's rule
        let sum: f64 = (0..=n)
            .map(|k| {
                let weight = if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                let y = step * f64::from(k);
                weight * self.function(i, y) * self.function(j, y)
            })
            .sum();
        sum * step / 3.0
    }

    /// Mass and stiffness.
    pub fn matrices(&self) -> [Mat<f64>; 2] {
        let (n, length) = (self.count, self.length);
        let mass = Mat::from_fn(2 * n, 2 * n, |i, j| {
            self.overlap(i, j)
                * match (i < n, j < n) {
                    (true, true) => self.mass,
                    (false, false) => self.inertia,
                    _ => self.static_moment,
                }
        });
        let stiffness = Mat::from_fn(2 * n, 2 * n, |i, j| match (i == j, i < n) {
            (false, _) => 0.0,
            (true, true) => self.bending * length * (CLAMPED_FREE[i] / length).powi(4),
            (true, false) => self.torsion * length * (torsion_number(i - n) / length).powi(2),
        });
        [mass, stiffness]
    }

    /// Theodorsen's forces on every strip.
    fn strips(&self) -> impl Fn(f64) -> Mat<faer::c64> + use<> {
        let n = self.count;
        let overlap = Mat::from_fn(2 * n, 2 * n, |i, j| self.overlap(i, j));
        let (b, a) = (0.5 * self.chord, 2.0 * self.axis - 1.0);
        move |kappa| {
            let section = strip_forces(kappa, b, a);
            let kind = |i: usize| usize::from(i >= n);
            Mat::from_fn(2 * n, 2 * n, |i, j| section[(kind(i), kind(j))] * overlap[(i, j)])
        }
    }
}

/// Roots of cos x cosh x = -1.
const CLAMPED_FREE: [f64; 5] = [
    1.875_104_068_711_961,
    4.694_091_132_974_175,
    7.854_757_438_237_613,
    10.995_540_734_875_467,
    14.137_168_391_046_47,
];

fn torsion_number(i: usize) -> f64 {
    (i as f64 + 0.5) * PI
}

/// Bending function of a clamped beam of length one.
fn cantilever(i: usize, y: f64) -> f64 {
    let beta = CLAMPED_FREE[i];
    let ratio = (beta.cos() + beta.cosh()) / (beta.sin() + beta.sinh());
    let x = beta * y;
    x.cosh() - x.cos() - ratio * (x.sinh() - x.sin())
}

/// Natural frequencies of matrices, rad/s, ascending.
///
/// # Panics
/// If the eigenvalues do not converge.
pub fn natural_rad_s(mass: &Mat<f64>, stiffness: &Mat<f64>) -> Vec<f64> {
    let ratio = faer::linalg::solvers::Solve::solve(&mass.partial_piv_lu(), stiffness);
    let mut omega: Vec<f64> =
        ratio.eigenvalues().expect("symmetric").iter().map(|value| value.re.sqrt()).collect();
    omega.sort_by(f64::total_cmp);
    omega
}

/// Strip theory: both conventions of the inertia and both densities of the case.
pub fn goland_strips(case: &Value) -> Vec<Row> {
    let rel = number(&case["tolerance"]["strip_rel"]);
    let mut rows = Vec::new();
    for (about_cg, name) in [(false, "strip_I_EA"), (true, "strip_I_CG")] {
        let wing = Goland::new(&case["inputs"], about_cg, 5);
        let [mass, stiffness] = wing.matrices();
        if !about_cg {
            for (i, want) in crate::numbers(&case["expected"]["natural_rad_s"]).into_iter().enumerate() {
                let ours = natural_rad_s(&mass, &stiffness)[i];
                rows.push(Row::relative(format!("natural frequency {} (rad/s)", i + 1), ours, want, rel));
            }
        }
        let forces = FormulaForces { size: 10, range: (0.0, 1000.0), formula: wing.strips() };
        for (density, rho) in [("rho_1p225", 1.225), ("rho_1p02", 1.02)] {
            let want = &case["expected"][name][density];
            let at = speeds(10.0, 200.0, 39, rho);
            let flutter = first_flutter(mass.clone(), stiffness.clone(), &forces, &at);
            let row = |what: &str, ours: f64, key: &str| {
                Row::relative(format!("{name} {density} {what}"), ours, number(&want[key]), rel)
            };
            rows.push(row("flutter speed (m/s)", flutter.flow.v_m_s, "V"));
            rows.push(row("flutter frequency (rad/s)", flutter.omega_rad_s, "omega"));
        }
    }
    rows
}
