//! The table of forces by hand, and which root is the least stable.

use super::*;
use crate::small::{CHORD_M, goland};
use aero::{Flow, MirrorPlane};

/// An equilibrium that never was: its tip.
pub(in crate::flutter) fn state(tip_z_m: f64) -> LargeState {
    LargeState {
        state: structure::nonlinear::State { places: Vec::new(), rotations: Vec::new() },
        forces: Vec::new(),
        lattice: aero::Lattice::default(),
        cp: Vec::new(),
        box_loads: aero::BoxLoads { values: Vec::new() },
        root: coupling::RootLoads { fz_n: 0.0, mx_nm: 0.0, my_nm: 0.0 },
        tip_m: nalgebra::Vector3::new(0.0, 0.0, tip_z_m),
        twist_rad: 0.0,
        iterations: 0,
        gain: 0.0,
    }
}

/// A point with these roots.
pub(in crate::flutter) fn point(v_m_s: f64, tip_z_m: f64, roots: &[Option<c64>]) -> BentPoint {
    BentPoint {
        case: SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, 0.0),
        state: state(tip_z_m),
        omega_rad_s: vec![1.0; roots.len()],
        roots: roots.to_vec(),
        shapes: Mat::zeros(0, 0),
    }
}

#[test]
fn the_least_stable_oscillation_has_the_largest_growth_over_its_frequency() {
    let root = |re: f64, im: f64| Some(c64::new(re, im));
    // growth over frequency -.1 and -.02; a real root that grows is no oscillation
    let (slow, fast) = (root(-1.0, 10.0), root(-2.0, 100.0));
    for roots in [[slow, fast, None, root(5.0, 0.0)], [root(5.0, 0.0), fast, slow, None]] {
        assert_eq!(point(30.0, 0.0, &roots).least_stable(), fast);
    }
    assert_eq!(point(30.0, 0.0, &[root(5.0, 0.0), None]).least_stable(), None);
}

#[test]
fn forces_are_the_work_of_the_boxes_pressures_and_of_the_loads_that_turn() {
    let wing = goland();
    let case = SteadyCase::new(Flow { v_m_s: 60.0, rho_kg_m3: 1.1 }, 0.0);
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    let state = wing.solve(std::slice::from_ref(&case), &neutral).expect("at rest").remove(0);
    let mut motion = wing.small_motion(&case, &neutral, &state, 2).expect("two modes");
    let number = |i: usize, j: usize, seed: f64| (seed + 1.7 * i as f64 + 0.6 * j as f64).sin();
    motion.incidence = Mat::from_fn(8, 2, |i, j| number(i, j, 0.2));
    motion.heave = Mat::from_fn(8, 2, |i, j| number(i, j, 1.1));
    motion.work = Mat::from_fn(2, 8, |i, j| number(i, j, 2.3));
    motion.load_stiffness = Mat::from_fn(2, 2, |i, j| 500.0 * number(i, j, 3.0));
    let found = table(&wing, &motion, &case).expect("a table");
    let (low, high) = super::super::GeneralisedForces::range(&found);
    assert!(low == 0.0 && (high - 2.0 * 1.8 / CHORD_M).abs() < 1e-12, "{high}");
    let plane = MirrorPlane::Symmetric { y_m: 0.0 };
    let doublets = DoubletLattice::new(&motion.lattice, plane, 0.0, &DlmSettings::default()).expect("boxes");
    let q_pa = 0.5 * 1.1 * 3600.0;
    for kappa in [0.0, 2.0 * 0.34 / CHORD_M, high] {
        // cp of w = W x - i kappa H x; R cp + A/q
        let w = Mat::from_fn(8, 2, |j, mode| {
            c64::from(motion.incidence[(j, mode)]) - c64::new(0.0, kappa) * motion.heave[(j, mode)]
        });
        let cp = doublets.at(kappa).expect("solvable").pressures(w.as_ref());
        let ours = super::super::GeneralisedForces::at(&found, kappa, 60.0).expect("in the table");
        for (i, mode) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let mut wanted = c64::from(motion.load_stiffness[(i, mode)] / q_pa);
            for j in 0..8 {
                wanted += cp[(j, mode)] * motion.work[(i, j)];
            }
            assert!((ours[(i, mode)] - wanted).norm() < 1e-9 * wanted.norm(), "{kappa}: {i} {mode}");
        }
    }
}
