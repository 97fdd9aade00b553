//! Unsteady air: how good the rational approximation is, what it keeps exactly, that it is stable, and that time and
//! frequency tell the same story.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{uneven, wing_with};
use aero::{Corrections, Flow};
use coupling::ElasticWing;
use coupling::planform::Planform;
use coupling::supported::restrict;
use faer::{Mat, c64};
use maneuver::air::{
    Accuracy, REDUCED_FREQUENCIES, RationalAir, UnsteadyAir, Weighting, accuracy, worst_by_row,
};
use maneuver::motion::{About, OneMinusCosine, Step};
use maneuver::{AirModel, Motion, Rig, RigModel, RigSettings, SharedAir, Signal, Smooth};
use std::f64::consts::TAU;
use structure::normal_modes;
use structure::unsymmetric::eigenvalues;

/// The shipped beam wing with all its boxes.
fn fine(planform: &mut Planform) {
    planform.boxes.chordwise = 12;
    planform.controls.iter_mut().for_each(|control| control.chord_boxes = 3);
}

fn flow(v_m_s: f64) -> Flow {
    Flow { v_m_s, rho_kg_m3: 1.225 }
}

/// Generalised forces of the first `modes` modes, then root loads, per unit pressure coefficient: rows by boxes.
fn rows(wing: &ElasticWing, modes: usize) -> Mat<f64> {
    let (supported, system) = (wing.supported.as_ref().unwrap(), &wing.structure.as_ref().unwrap().0);
    let shapes = normal_modes(system, modes).unwrap().shapes;
    let shapes = restrict(system.expand(shapes.as_ref()).as_ref(), &supported.s_dofs);
    let motion = &supported.k_displacements() * &shapes;
    Mat::from_fn(modes + 3, wing.lattice.len(), |row, j| {
        let by = |k: usize| if row < modes { motion[(k, row)] } else { wing.root_rows[(row - modes, k)] };
        wing.integration.area(j) * (by(2 * j) + wing.integration.moment_arm(j) * by(2 * j + 1))
    })
}

/// Frequencies in the middle between those of the fit, as omega/V.
fn between(air: &UnsteadyAir) -> Vec<f64> {
    let k = REDUCED_FREQUENCIES;
    let middles = k.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).chain([0.5 * k[0], 1.95]);
    middles.map(|k| 2.0 * k / air.chord_m).collect()
}

#[test]
fn between_the_frequencies_of_the_fit_every_entry_is_close_to_the_doublet_lattice() {
    let (file, wing) = wing_with(fine);
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let air = rig.air();
    let samples: Vec<(f64, Mat<c64>)> =
        between(air).into_iter().map(|kappa| (kappa, air.exact(kappa).unwrap())).collect();
    let rows = rows(&wing, 20);
    let largest = accuracy::largest(rows.as_ref(), samples.iter().map(|(_, cp)| cp));
    let accuracy = Accuracy::at(&air.rational, &samples, rows.as_ref(), largest.as_ref());
    let worst = worst_by_row(&accuracy).into_iter().fold(0.0, f64::max);
    assert!(worst < 0.03, "{worst}");
    let (modes, motions) = (20, accuracy.error.ncols());
    for row in modes..modes + 3 {
        for motion in (0..6).chain(modes..motions) {
            let error = accuracy.error[(row, motion)];
            assert!(error < 0.01, "root load {}, motion {motion}: {error}", row - modes);
        }
    }
}

#[test]
fn the_approximation_is_exact_at_rest_and_that_of_a_sum_is_the_sum_of_approximations() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let air = rig.air();
    let at_rest = air.rational.at(c64::new(0.0, 0.0));
    let steady = wing.pressures(air.columns.still.as_ref());
    for column in 0..steady.ncols() {
        let size = (0..steady.nrows()).map(|j| steady[(j, column)].abs()).fold(0.0, f64::max);
        for j in 0..steady.nrows() {
            let apart = (at_rest[(j, column)] - c64::from(steady[(j, column)])).norm();
            assert!(apart < 1e-12 * size, "{apart:e} of {size}");
        }
    }
    // the sum over all boxes fitted, beside the fit summed over all boxes
    let table = air.table.as_ref().unwrap();
    let ones = Mat::from_fn(1, wing.lattice.len(), |_, j| wing.integration.area(j));
    let mut summed = table.clone();
    for cp in &mut summed.cp {
        let part = |of: fn(c64) -> f64| &ones * Mat::from_fn(cp.nrows(), cp.ncols(), |i, j| of(cp[(i, j)]));
        let (re, im) = (part(|z| z.re), part(|z| z.im));
        *cp = Mat::from_fn(1, re.ncols(), |_, j| c64::new(re[(0, j)], im[(0, j)]));
    }
    let (steady, poles) = (&ones * &air.rational.steady, &air.rational.poles_per_m);
    let of_sum = RationalAir::fit(&summed, steady, poles, Weighting::RIG, |_| false);
    let sum_of = air.rational.mapped(&ones);
    for kappa in between(air) {
        let p = c64::new(0.0, kappa);
        let (a, b) = (of_sum.at(p), sum_of.at(p));
        for motion in 0..a.ncols() {
            // of all that is summed: boxes and terms of the function cancel each other
            let size = terms(&air.rational, p, motion, &ones);
            let share = (a[(0, motion)] - b[(0, motion)]).norm() / size;
            assert!(share < 1e-12, "motion {motion}: {share:e}");
        }
    }
}

/// Sum of the moduli of all boxes' and terms' shares in a load of `rows`.
fn terms(air: &RationalAir, p: c64, motion: usize, rows: &Mat<f64>) -> f64 {
    let of = |part: &Mat<f64>, factor: c64| -> f64 {
        (0..part.nrows()).map(|j| (factor * part[(j, motion)] * rows[(0, j)]).norm()).sum()
    };
    let lags = air.lags.iter().zip(&air.poles_per_m).map(|(lag, pole)| of(lag, p / (p + *pole)));
    of(&air.steady, c64::from(1.0)) + of(&air.rate, p) + of(&air.second, p * p) + lags.sum::<f64>()
}

#[test]
fn from_0_to_10_hz_the_state_space_answers_as_the_doublet_lattice_itself() {
    let (file, wing) = wing_with(fine);
    let corrections = uneven(&wing);
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    for v_m_s in [18.0, 30.0] {
        let model = rig.at(flow(v_m_s), &corrections).unwrap();
        let frequencies = [0.3, 1.0, 2.5, 4.0, 4.7, 6.0, 8.0, 10.0].map(|f_hz| TAU * f_hz);
        let pairs = frequencies.map(|omega| {
            let exact = rig.at_frequency(flow(v_m_s), &corrections, omega).unwrap();
            (model.frequency_response(omega), exact.frequency_response(omega))
        });
        for row in 0..3 {
            for motion in 0..=wing.controls.len() {
                let peak = pairs.iter().map(|(_, exact)| exact[(row, motion)].norm()).fold(0.0, f64::max);
                for ((ours, exact), omega) in pairs.iter().zip(frequencies) {
                    let share = (ours[(row, motion)] - exact[(row, motion)]).norm() / peak;
                    let hz = omega / TAU;
                    assert!(share < 0.005, "{v_m_s} m/s, load {row}, motion {motion}, {hz} Hz: {share}");
                }
            }
        }
    }
}

#[test]
fn no_airspeed_and_no_number_of_modes_makes_the_air_feed_the_wing() {
    let (file, wing) = wing_with(|_| ());
    for modes in [4, 12, 40] {
        let settings = RigSettings { modes, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
        let rig = Rig::new(&wing, settings).unwrap();
        for v_m_s in [0.0, 3.0, 8.0, 15.0, 22.0, 30.0, 40.0, 50.0] {
            let model = rig.at(flow(v_m_s), &Corrections::neutral(wing.correctable.len())).unwrap();
            let values = eigenvalues(model.a.as_ref()).unwrap();
            let largest = values.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max);
            assert!(largest < 0.0, "{modes} modes, {v_m_s} m/s: {largest}");
        }
    }
}

fn pitch(signal: &dyn Signal, time_step_s: f64, samples: usize) -> Motion {
    let of = |value: &dyn Fn(f64) -> f64| (0..samples).map(|i| value(i as f64 * time_step_s)).collect();
    let alpha = Smooth {
        value: of(&|t| signal.at(t)),
        rate: of(&|t| signal.rate(t)),
        second: of(&|t| signal.second(t)),
    };
    Motion { time_step_s, alpha, controls_rad: Vec::new() }
}

/// A swing of small amplitude that is on from the beginning.
struct Swing {
    amplitude: f64,
    omega: f64,
}

impl Signal for Swing {
    fn at(&self, t_s: f64) -> f64 {
        self.amplitude * (self.omega * t_s).sin()
    }

    fn rate(&self, t_s: f64) -> f64 {
        self.amplitude * self.omega * (self.omega * t_s).cos()
    }

    fn second(&self, t_s: f64) -> f64 {
        -self.omega * self.omega * self.at(t_s)
    }
}

/// Amplitude of a channel at a frequency over whole periods, relative to a sine.
fn amplitude(values: &[f64], omega: f64, time_step_s: f64, first: usize) -> c64 {
    let count = (values.len() - first) as f64;
    let sum = values.iter().enumerate().skip(first).fold(c64::new(0.0, 0.0), |sum, (i, value)| {
        sum + c64::new(0.0, -omega * i as f64 * time_step_s).exp() * *value
    });
    // e^(i w t) over i is the sine's partner
    sum * c64::new(0.0, 2.0 / count)
}

#[test]
fn flown_at_a_frequency_the_loads_swing_as_the_systems_own_transfer_function_says() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let model: RigModel = rig.at(flow(30.0), &uneven(&wing)).unwrap();
    // straight lines between samples of a sine lose (w h)²/12 of it: 5e-7 at 4 Hz
    let (time_step_s, small) = (1e-4, 1e-4);
    for f_hz in [0.5_f64, 2.0, 4.0] {
        let omega = TAU * f_hz;
        // 6 s until the beginning is forgotten, then whole periods
        let (first, samples) = (60_000, 60_000 + 40_000);
        let history = model.fly(&pitch(&Swing { amplitude: small, omega }, time_step_s, samples));
        let response = model.frequency_response(omega);
        for (row, name) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().enumerate() {
            let flown = amplitude(history.get(name).unwrap(), omega, time_step_s, first) / small;
            let share = (flown - response[(row, 0)]).norm() / response[(row, 0)].norm();
            assert!(share < 1e-5, "{name} at {f_hz} Hz: {share:e}");
        }
    }
}

#[test]
fn twice_the_modes_change_no_root_load_by_a_hundredth() {
    let (file, wing) = wing_with(|_| ());
    let signal = About(0.02, OneMinusCosine::new(0.06, 4.0, 0.2));
    let fly = |modes: usize| {
        let settings = RigSettings { modes, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
        let rig = Rig::new(&wing, settings).unwrap();
        rig.at(flow(30.0), &uneven(&wing)).unwrap().fly(&pitch(&signal, 0.002, 500))
    };
    for modes in [20, 24] {
        let (few, many) = (fly(modes), fly(2 * modes));
        for name in ["Fz_N", "Mx_Nm", "My_Nm"] {
            let (a, b) = (few.get(name).unwrap(), many.get(name).unwrap());
            let swing = b.iter().fold(0.0, |m: f64, v| m.max((v - b[0]).abs()));
            let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 0.01 * swing, "{name}, {modes} modes: {apart} of {swing}");
        }
    }
}

#[test]
fn a_run_begins_with_the_static_loads() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let history = rig.at(flow(22.0), &corrections).unwrap().fly(&pitch(
        &Step { height: 0.03, start_s: 0.0 },
        0.005,
        40,
    ));
    let case = coupling::SteadyCase::new(flow(22.0), 0.03);
    let steady = wing.at(flow(22.0), &corrections).unwrap().solve(&[case])[0].root.to_array();
    for (name, steady) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().zip(steady) {
        for value in history.get(name).unwrap() {
            assert!((value - steady).abs() < 1e-9 * steady.abs().max(1.0), "{name}: {value} {steady}");
        }
    }
}

#[test]
fn a_shared_lattice_changes_no_bit_and_is_not_asked_for_a_wing_on_another() {
    let (file, wing) = wing_with(fine);
    let (_, coarser) = wing_with(|_| ());
    assert_ne!(wing.lattice, coarser.lattice);
    let settings = RigSettings::new(file.damping_ratio, file.pitch_axis_x());
    let shared = SharedAir::of(&wing, settings.air.doublets().expect("doublets")).unwrap();
    for wing in [&wing, &coarser] {
        let [alone, sharing] =
            [None, Some(&shared)].map(|shared| Rig::in_air(wing, settings.clone(), shared).unwrap());
        let [alone, sharing] = [&alone, &sharing].map(|rig| &rig.air().table.as_ref().unwrap().cp);
        assert_eq!(alone, sharing);
    }
    assert_eq!(AirModel::QuasiSteady.doublets(), None);
}

#[test]
fn in_still_air_the_wing_carries_the_air_of_a_cylinder_around_its_chord() {
    // strip theory: pi rho c²/4 per length moves with the wing; the finite wing carries a little less
    let (file, wing) = wing_with(fine);
    let system = &wing.structure.as_ref().unwrap().0;
    let supported = wing.supported.as_ref().unwrap();
    let modes = normal_modes(system, 1).unwrap();
    let shape = restrict(system.expand(modes.shapes.as_ref()).as_ref(), &supported.s_dofs);
    let motion = &supported.k_displacements() * &shape;
    let surface = &wing.lattice.surfaces;
    let mut mass = 0.0;
    for strip in surface.iter().flat_map(|s| (0..s.spanwise).map(move |i| s.first_box + i * s.chordwise)) {
        let panel = &wing.lattice.boxes[strip];
        let rows =
            surface.iter().find(|s| strip >= s.first_box && strip < s.first_box + s.spanwise * s.chordwise);
        let count = rows.unwrap().chordwise;
        let chord = panel.chord_m() * count as f64;
        let heave = (0..count).map(|i| motion[(2 * (strip + i), 0)]).sum::<f64>() / count as f64;
        mass += 0.25 * std::f64::consts::PI * 1.225 * chord * chord * panel.width_m() * heave * heave;
    }
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let model = rig.at(flow(0.0), &Corrections::neutral(wing.correctable.len())).unwrap();
    let first = eigenvalues(model.a.as_ref())
        .unwrap()
        .iter()
        .map(|z| z.norm())
        .filter(|w| *w > 1.0)
        .fold(f64::MAX, f64::min);
    let carried = (modes.omega_rad_s[0] / first).powi(2) - 1.0;
    assert!(carried > 0.8 * mass && carried < 1.0 * mass, "{carried} of the mode's mass, strips {mass}");
}
