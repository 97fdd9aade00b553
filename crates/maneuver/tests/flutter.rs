//! Laws of flutter and divergence: both methods agree where they solve the same equations; branches keep their identity.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be computed must fail")]

use crate::common::{uneven, wing_with};
use aero::{DlmSettings, DoubletLattice, Flow};
use faer::linalg::solvers::Solve;
use faer::{Mat, Scale, c64};
use maneuver::flutter::{
    Aeroelastic, FlutterError, FormulaForces, GafTable, GeneralisedForces, ScheduledForces,
    flutter_of_state_space, incidence_of_motion,
};
use maneuver::{AirModel, Rig, RigSettings};
use std::f64::consts::TAU;

const RHO: f64 = 1.225;

fn speeds(low: f64, high: f64, count: u32) -> Vec<Flow> {
    let step = (high - low) / f64::from(count - 1);
    (0..count).map(|i| Flow { v_m_s: low + step * f64::from(i), rho_kg_m3: RHO }).collect()
}

/// Air without memory on three coordinates: Q = q0 + i kappa q1, with a flutter and a divergence.
fn quasi_steady(kappa: f64) -> Mat<c64> {
    let q0 = [[0.02, 3.0, 0.3], [-0.4, 0.6, 0.2], [0.1, -0.3, 0.4]];
    let q1 = [[-1.0, -0.3, 0.1], [-0.2, -0.8, 0.1], [0.05, 0.1, -0.6]];
    Mat::from_fn(3, 3, |i, j| c64::new(q0[i][j], kappa * q1[i][j]))
}

const OMEGA: [f64; 3] = [10.0, 17.0, 40.0];

fn formula() -> FormulaForces<fn(f64) -> Mat<c64>> {
    FormulaForces { size: 3, range: (0.0, 1e4), formula: quasi_steady }
}

/// The same as x' = A x.
fn companion(flow: Flow) -> Mat<f64> {
    let (q, v) = (flow.dynamic_pressure_pa(), flow.v_m_s);
    let forces = quasi_steady(1.0);
    Mat::from_fn(6, 6, |i, j| match (i < 3, j < 3) {
        (true, _) => f64::from(u8::from(j == i + 3)),
        (false, true) => q * forces[(i - 3, j)].re - if i - 3 == j { OMEGA[j].powi(2) } else { 0.0 },
        (false, false) => q / v * forces[(i - 3, j - 3)].im - if i == j { 0.02 * OMEGA[j - 3] } else { 0.0 },
    })
}

#[test]
fn in_air_without_memory_the_roots_of_pk_are_the_eigenvalues() {
    let forces = formula();
    let system = Aeroelastic::of_modes(&OMEGA, 0.01, &forces).unwrap();
    let flows = speeds(1.0, 20.0, 39);
    let pk = system.pk(&flows).unwrap();
    assert!(pk.lost.is_empty(), "{:?}", pk.lost);
    for (place, flow) in flows.iter().enumerate() {
        let eigenvalues = companion(*flow).eigenvalues().unwrap();
        for branch in &pk.branches {
            let p = branch[place].p;
            let off = eigenvalues.iter().map(|value| (value - p).norm()).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-8 * p.norm().max(1.0), "{} m/s: {p} off by {off:e}", flow.v_m_s);
        }
        // no two branches on one root
        for (i, a) in pk.branches.iter().enumerate() {
            assert!(pk.branches[..i].iter().all(|b| (a[place].p - b[place].p).norm() > 1e-6));
        }
    }
    let state_space = flutter_of_state_space::<FlutterError>(&flows, |flow| Ok(companion(flow))).unwrap();
    let (a, b) = (pk.flutter().unwrap(), state_space.flutter().unwrap());
    assert!((a.flow.v_m_s / b.flow.v_m_s - 1.0).abs() < 1e-8, "{a:?} {b:?}");
    assert!((a.omega_rad_s / b.omega_rad_s - 1.0).abs() < 1e-6, "{a:?} {b:?}");
    assert_eq!(
        pk.crossings.len(),
        state_space.crossings.len(),
        "{:?} {:?}",
        pk.crossings,
        state_space.crossings
    );
}

#[test]
fn at_divergence_a_real_root_is_zero() {
    let forces = formula();
    let system = Aeroelastic::of_modes(&OMEGA, 0.01, &forces).unwrap();
    let q = system.divergence_pressure(0.0).unwrap().unwrap();
    let v = (2.0 * q / RHO).sqrt();
    let from_speeds = system.divergence_speed(RHO, &[1.0, 10.0, 100.0]).unwrap().unwrap();
    assert!((from_speeds / v - 1.0).abs() < 1e-9);
    let a = companion(Flow { v_m_s: v, rho_kg_m3: RHO });
    let least = a.eigenvalues().unwrap().iter().map(|value| value.norm()).fold(f64::INFINITY, f64::min);
    assert!(least < 1e-9, "{least:e}");
    let below = companion(Flow { v_m_s: 0.99 * v, rho_kg_m3: RHO });
    let steady = below.partial_piv_lu().solve(Mat::<f64>::identity(6, 6));
    assert!(steady.norm_max().is_finite());
}

#[test]
fn a_coarser_list_of_airspeeds_finds_the_same_flutter() {
    let forces = formula();
    let system = Aeroelastic::of_modes(&OMEGA, 0.01, &forces).unwrap();
    let fine = *system.pk(&speeds(1.0, 20.0, 77)).unwrap().flutter().unwrap();
    for count in [2, 3, 8] {
        let coarse = *system.pk(&speeds(1.0, 20.0, count)).unwrap().flutter().unwrap();
        assert!((coarse.flow.v_m_s / fine.flow.v_m_s - 1.0).abs() < 1e-9, "{count}: {coarse:?} {fine:?}");
        assert_eq!(coarse.branch, fine.branch);
    }
}

#[test]
fn without_coupling_modes_that_cross_in_frequency_keep_their_identity() {
    // the first stiffens with dynamic pressure, the second softens; they meet and pass
    let forces = FormulaForces {
        size: 2,
        range: (0.0, 1e4),
        formula: |kappa: f64| {
            Mat::from_fn(2, 2, |i, j| match (i, j) {
                (0, 0) => c64::new(-2.0, -0.1 * kappa),
                (1, 1) => c64::new(1.0, -0.2 * kappa),
                _ => c64::default(),
            })
        },
    };
    let system = Aeroelastic::of_modes(&[10.0, 14.0], 0.0, &forces).unwrap();
    let flows = speeds(1.0, 14.0, 14);
    let curves = system.pk(&flows).unwrap();
    for (place, flow) in flows.iter().enumerate() {
        let q = flow.dynamic_pressure_pa();
        for (branch, (squared, damping)) in [(100.0 + 2.0 * q, 0.1), (196.0 - q, 0.2)].into_iter().enumerate()
        {
            let rate: f64 = -0.5 * q / flow.v_m_s * damping;
            let p = curves.branches[branch][place].p;
            assert!((p.re - rate).abs() < 1e-9, "{p} {rate}");
            assert!((p.norm_sqr() - squared).abs() < 1e-6, "{p} {squared}");
        }
    }
}

#[test]
fn tables_do_not_extrapolate_and_frequencies_beyond_them_are_marked() {
    let kappa = [0.0, 0.1, 0.5, 1.0, 2.0];
    let table = GafTable::new(kappa.to_vec(), kappa.iter().map(|k| quasi_steady(*k)).collect()).unwrap();
    assert!(matches!(table.at(2.1, 10.0), Err(FlutterError::OutsideTable { .. })));
    let system = Aeroelastic::of_modes(&OMEGA, 0.01, &table).unwrap();
    // omega/V of the third mode is 4 at 10 m/s and 2 at 20 m/s
    let curves = system.pk(&speeds(9.0, 30.0, 22)).unwrap();
    assert!(curves.branches[2][0].beyond_table);
    assert!(!curves.branches[0][0].beyond_table);
}

/// Two modes that nothing damps but the air: on the first that is round-off, which changes its sign with the airspeed.
#[test]
fn a_mode_on_which_no_air_acts_does_not_flutter_by_round_off() {
    let formula = |kappa: f64| {
        let noise = 1e-22 * (40.0 * kappa).sin();
        Mat::from_fn(2, 2, |i, j| match (i, j) {
            (0, 0) => c64::new(0.0, noise * kappa),
            (1, 1) => c64::new(0.0, 1e-3 * (kappa - 2.0) * kappa),
            _ => c64::default(),
        })
    };
    let forces = FormulaForces { size: 2, range: (0.0, 1e4), formula };
    let system = Aeroelastic::of_modes(&[10.0, 30.0], 0.0, &forces).unwrap();
    let flows = speeds(5.0, 25.0, 41);
    let (pk, complete) = (system.pk(&flows).unwrap(), system.pk_complete(&flows).unwrap());
    let signs = pk.branches[0].iter().map(|root| root.p.re > 0.0);
    assert!(signs.clone().any(|grows| grows) && signs.clone().any(|grows| !grows), "no round-off to be told");
    // the second grows above kappa = 2, that is below 15 m/s
    for (crossings, branches) in [(&pk.crossings, 2), (&complete.crossings, complete.branches.len())] {
        let [one] = crossings[..] else { panic!("{crossings:?}") };
        assert!((one.flow.v_m_s - 15.0).abs() < 1e-5 && !one.unstable && branches == 2, "{one:?}");
    }
    assert!(pk.branches[0].iter().all(|root| !root.is_growing()) && pk.branches[1][0].is_growing());
}

/// Matched points have a table for each airspeed, with frequencies of its own.
#[test]
fn tables_of_a_schedule_hold_their_own_ends() {
    let table = |kappa: &[f64]| {
        let q = |k: &f64| quasi_steady(*k) * Scale(c64::from(1.0 + k * k));
        GafTable::new(kappa.to_vec(), kappa.iter().map(q).collect()).unwrap()
    };
    let (long, short) = (table(&[0.0, 1.0, 4.0]), table(&[0.0, 2.0]));
    let forces = ScheduledForces::new(vec![(10.0, long.clone()), (20.0, short.clone())]).unwrap();
    assert_eq!(forces.range(), (0.0, 2.0));
    let near = |v: f64, kappa: f64, beyond: bool, wanted: &dyn Fn(usize, usize) -> c64| {
        let split = forces.split(kappa, v).unwrap();
        assert_eq!(split.beyond, beyond, "{v} m/s, {kappa}");
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let found = c64::new(split.real[(i, j)], split.damping[(i, j)]);
            assert!((found - wanted(i, j)).norm() < 1e-9, "{v} m/s, {kappa}: {found}");
        }
    };
    let of = |table: &GafTable, kappa: f64| {
        let q = table.at(kappa, 0.0).unwrap();
        move |i: usize, j: usize| c64::new(q[(i, j)].re, q[(i, j)].im / kappa)
    };
    near(5.0, 3.0, false, &of(&long, 3.0));
    near(10.0, 3.0, false, &of(&long, 3.0));
    near(20.0, 3.0, true, &of(&short, 2.0));
    near(25.0, 5.0, true, &of(&short, 2.0));
    near(10.0, 5.0, true, &of(&long, 4.0));
    let (one, other) = (of(&long, 3.0), of(&short, 2.0));
    near(250_f64.sqrt(), 3.0, true, &|i, j| 0.5 * (one(i, j) + other(i, j)));
    let roots =
        Aeroelastic::of_modes(&OMEGA, 0.01, &forces).unwrap().pk_complete(&speeds(6.0, 24.0, 7)).unwrap();
    assert!(roots.branches.iter().any(|branch| branch.roots.iter().any(|root| root.beyond_table)));
}

#[test]
fn bad_input_is_refused_with_a_sentence() {
    let forces = formula();
    let system = Aeroelastic::of_modes(&OMEGA, 0.01, &forces).unwrap();
    assert!(system.pk(&[]).is_err());
    assert!(system.pk(&[Flow { v_m_s: 0.0, rho_kg_m3: RHO }]).is_err());
    assert!(system.pk(&[Flow { v_m_s: 1.0, rho_kg_m3: f64::NAN }]).is_err());
    assert!(Aeroelastic::of_modes(&OMEGA[..2], 0.01, &forces).is_err());
    let free = Aeroelastic::of_modes(&[0.0, 1.0, 2.0], 0.0, &forces).unwrap();
    assert!(free.pk(&speeds(1.0, 2.0, 2)).is_err());
    assert!(GafTable::new(vec![0.0, -1.0], vec![quasi_steady(0.0), quasi_steady(1.0)]).is_err());
    assert!(ScheduledForces::new(Vec::new()).is_err());
}

#[test]
fn tables_of_a_schedule_are_mixed_as_their_corrections_are() {
    let table = |factor: f64| {
        let kappa = vec![0.0, 1.0, 2.0];
        let q = kappa.iter().map(|k| quasi_steady(*k) * faer::Scale(c64::from(factor))).collect();
        GafTable::new(kappa, q).unwrap()
    };
    let forces = ScheduledForces::new(vec![(10.0, table(1.0)), (20.0, table(2.0))]).unwrap();
    for (v, factor) in [(5.0, 1.0), (10.0, 1.0), (15.0, 1.0 + 125.0 / 300.0), (20.0, 2.0), (30.0, 2.0)] {
        let off = forces.at(0.7, v).unwrap() - quasi_steady(0.7) * faer::Scale(c64::from(factor));
        assert!(off.norm_max() < 1e-12, "{v}");
    }
}

/// The wing's state matrix beside p-k with forces of the same air without memory. What is left is what the truncated modes
/// do statically in the one and not in the other; it fades with their number.
#[test]
fn the_wing_flutters_alike_by_both_methods() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let doublets = DoubletLattice::new(&wing.lattice, wing.plane, 0.0, &DlmSettings::default()).unwrap();
    let still = doublets.at(0.0).unwrap();
    let flows = speeds(10.0, 200.0, 20);
    let difference = |modes: usize| {
        let air = AirModel::QuasiSteady;
        let settings =
            RigSettings { modes, air, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
        let rig = Rig::new(&wing, settings).unwrap();
        let motion = rig.box_motion();
        let kappa = [0.0, 1.0, 300.0];
        let q = kappa.map(|kappa| {
            let w = incidence_of_motion(&wing.lattice, motion.as_ref(), kappa);
            let cp = still.pressures(w.as_ref());
            wing.integration.corrected(&padded).weighed(motion.transpose(), cp.as_ref())
        });
        let table = GafTable::new(kappa.to_vec(), q.to_vec()).unwrap();
        let system = Aeroelastic::of_modes(rig.omega_rad_s(), file.damping_ratio, &table).unwrap();
        let pk = *system.pk(&flows).unwrap().flutter().unwrap();
        let matrix = |flow: Flow| Ok::<_, FlutterError>(rig.at(flow, &corrections).unwrap().a);
        let eigen = *flutter_of_state_space(&flows, matrix).unwrap().flutter().unwrap();
        println!(
            "{modes} modes: p-k {:.4} m/s {:.3} Hz, state matrix {:.4} m/s {:.3} Hz",
            pk.flow.v_m_s,
            pk.omega_rad_s / TAU,
            eigen.flow.v_m_s,
            eigen.omega_rad_s / TAU
        );
        pk.flow.v_m_s / eigen.flow.v_m_s - 1.0
    };
    let (few, many) = (difference(12).abs(), difference(40).abs());
    assert!(few < 1e-3 && many < 1e-4, "{few:e} {many:e}");
}

#[test]
fn in_unsteady_air_the_state_matrix_flutters_as_p_k_on_the_doublet_lattice_does() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let padded = wing.padded(&corrections).unwrap();
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let doublets = DoubletLattice::new(&wing.lattice, wing.plane, 0.0, &DlmSettings::default()).unwrap();
    let half_chord_m = 0.5 * rig.air().chord_m;
    let kappa: Vec<f64> = [0.0, 0.02, 0.06, 0.12, 0.2, 0.3, 0.42, 0.55, 0.7, 0.9, 1.15, 1.5, 2.0]
        .map(|k| k / half_chord_m)
        .to_vec();
    let pressures = rig.mode_pressures(&doublets, &kappa).unwrap();
    let table = rig.gaf_table(&pressures, &padded).unwrap();
    let system = Aeroelastic::of_modes(rig.omega_rad_s(), file.damping_ratio, &table).unwrap();
    let flows = speeds(10.0, 200.0, 20);
    let pk = *system.pk(&flows).unwrap().flutter().unwrap();
    let matrix = |flow: Flow| Ok::<_, FlutterError>(rig.at(flow, &corrections).unwrap().a);
    let eigen = *flutter_of_state_space(&flows, matrix).unwrap().flutter().unwrap();
    // the rational function is within 1 % of the lattice; flutter is where much cancels
    let [v, f] = [pk.flow.v_m_s / eigen.flow.v_m_s - 1.0, pk.omega_rad_s / eigen.omega_rad_s - 1.0];
    assert!(v.abs() < 0.01 && f.abs() < 0.01, "{v:e} {f:e} at {} m/s", pk.flow.v_m_s);
}

/// Air that answers the momentary incidence alone has no force but in step with it: the forces of a motion at rest, and of its speed in
/// proportion to the frequency.
#[test]
fn without_its_unsteady_part_air_answers_displacement_and_speed_and_nothing_else() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let doublets = DoubletLattice::new(&wing.lattice, wing.plane, 0.0, &DlmSettings::default()).unwrap();
    let kappa = [0.0, 1.0, 2.0, 4.0];
    let pressures = rig.mode_pressures(&doublets, &kappa).unwrap();
    let corrections = wing.padded(&uneven(&wing)).unwrap();
    let forces = |factor: f64| {
        let table = rig.gaf_table(&pressures.with_unsteady(factor), &corrections).unwrap();
        kappa.map(|kappa| table.at(kappa, 30.0).unwrap())
    };
    let [steady, half, whole] = [0.0, 0.5, 1.0].map(forces);
    let size = steady[0].norm_max();
    for (k, kappa) in kappa.into_iter().enumerate().skip(1) {
        let per_speed = Scale(c64::new(0.0, -1.0 / kappa)) * (&steady[k] - &steady[0]);
        let first = Scale(c64::new(0.0, -1.0)) * (&steady[1] - &steady[0]);
        assert!((per_speed - &first).norm_max() < 1e-10 * size, "omega/V = {kappa}");
        let between = Scale(c64::from(0.5)) * (&steady[k] + &whole[k]);
        assert!((between - &half[k]).norm_max() < 1e-12 * size, "the factor is no proportion");
        // lift lags and apparent mass: far more than rounding
        assert!((&whole[k] - &steady[k]).norm_max() > 1e-2 * size, "omega/V = {kappa}");
        assert!(
            first.norm_max() > 0.0 && max_imaginary(&first) < 1e-10 * size,
            "a force out of step with the speed"
        );
    }
    assert!((&whole[0] - &steady[0]).norm_max() < 1e-12 * size, "the steady limit stays");
}

fn max_imaginary(matrix: &Mat<c64>) -> f64 {
    (0..matrix.ncols())
        .flat_map(|j| (0..matrix.nrows()).map(move |i| matrix[(i, j)].im.abs()))
        .fold(0.0, f64::max)
}

/// Numbers between -1 and 1 from a seed (Knuth's MMIX).
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
    }
}

/// Closely spaced modes that air without memory couples strongly, followed in two long legs: a step that lands on the next mode's root
/// would leave two branches on one.
#[test]
fn branches_followed_in_long_legs_stay_on_roots_of_their_own() {
    let omega = [10.0, 11.0, 12.5, 14.0];
    let n = omega.len();
    for seed in 0..40 {
        let mut next = numbers(seed);
        let coupling: Vec<[f64; 2]> = (0..n * n).map(|_| [0.6 * next(), 0.5 * next()]).collect();
        let entry = |i: usize, j: usize| {
            let [real, rate] = coupling[n * i + j];
            if i == j { [real, -1.5 + rate] } else { [real, rate] }
        };
        let forces = FormulaForces {
            size: n,
            range: (0.0, 1e4),
            formula: |kappa: f64| Mat::from_fn(n, n, |i, j| c64::new(entry(i, j)[0], kappa * entry(i, j)[1])),
        };
        let system = Aeroelastic::of_modes(&omega, 0.01, &forces).unwrap();
        let flows = speeds(1.0, 9.0, 3);
        let curves = system.pk(&flows).unwrap();
        assert!(curves.lost.is_empty(), "seed {seed}: {:?}", curves.lost);
        for (place, flow) in flows.iter().enumerate() {
            let (q, v) = (flow.dynamic_pressure_pa(), flow.v_m_s);
            let a = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
                (true, _) => f64::from(u8::from(j == i + n)),
                (false, true) => q * entry(i - n, j)[0] - if i - n == j { omega[j].powi(2) } else { 0.0 },
                (false, false) => {
                    q / v * entry(i - n, j - n)[1] - if i == j { 0.02 * omega[j - n] } else { 0.0 }
                }
            });
            let eigenvalues = a.eigenvalues().unwrap();
            let roots: Vec<c64> = curves.branches.iter().map(|branch| branch[place].p).collect();
            for (i, p) in roots.iter().enumerate() {
                let off = eigenvalues.iter().map(|value| (value - p).norm()).fold(f64::INFINITY, f64::min);
                assert!(off < 1e-9, "seed {seed}, {v} m/s: {p} is {off:e} from an eigenvalue");
                let shared = roots[..i].iter().any(|other| (*other - p).norm() < 1e-6);
                assert!(!shared, "seed {seed}, {v} m/s: two branches on {p}");
            }
        }
    }
}
