//! Free decay after a short pitch pulse: the first bending's frequency and damping read off the root bending moment.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::wing_with;
use aero::{Corrections, Flow};
use coupling::ElasticWing;
use maneuver::motion::{About, OneMinusCosine, Signal};
use maneuver::{AirModel, Motion, Rig, RigSettings, Smooth};
use std::f64::consts::PI;

const STEP_S: f64 = 0.001;

/// Root bending after a 4 Hz pitch pulse that ends at 0.25 s, counted from where it started and returns to.
fn ringing(rig: &Rig<'_>, wing: &ElasticWing, v_m_s: f64, samples: usize) -> Vec<f64> {
    let pulse = About(0.02, OneMinusCosine::new(0.03, 4.0, 0.0));
    let of = |f: &dyn Fn(f64) -> f64| (0..samples).map(|i| f(i as f64 * STEP_S)).collect::<Vec<f64>>();
    let motion = Motion {
        time_step_s: STEP_S,
        alpha: Smooth {
            value: of(&|t| pulse.at(t)),
            rate: of(&|t| pulse.rate(t)),
            second: of(&|t| pulse.second(t)),
        },
        controls_rad: Vec::new(),
    };
    let neutral = Corrections::neutral(wing.correctable.len());
    let model = rig.at(Flow { v_m_s, rho_kg_m3: 1.225 }, &neutral).unwrap();
    let mx = model.fly(&motion).get("Mx_Nm").unwrap().to_vec();
    mx.iter().map(|value| value - mx[0]).collect()
}

/// Damped frequency (rad/s) and damping ratio from the zeros and the extremes between them, in a window of time.
fn frequency_and_damping(signal: &[f64], window_s: std::ops::Range<f64>) -> (f64, f64) {
    let inside = |i: &usize| window_s.contains(&(*i as f64 * STEP_S));
    let zeros: Vec<f64> = (1..signal.len())
        .filter(inside)
        .filter(|&i| signal[i - 1] * signal[i] < 0.0)
        .map(|i| (i as f64 - signal[i] / (signal[i] - signal[i - 1])) * STEP_S)
        .collect();
    let half_periods = (zeros.len() - 1) as f64;
    let omega = PI * half_periods / (zeros[zeros.len() - 1] - zeros[0]);
    let extreme = |from_s: f64, to_s: f64| {
        let between = |i: usize| (from_s..to_s).contains(&(i as f64 * STEP_S));
        (0..signal.len()).filter(|i| between(*i)).fold(0.0, |m: f64, i| m.max(signal[i].abs()))
    };
    let first = extreme(zeros[0], zeros[1]);
    let last = extreme(zeros[zeros.len() - 2], zeros[zeros.len() - 1]);
    let decrement = (first / last).ln() / (half_periods - 1.0) / PI;
    (omega, decrement / decrement.hypot(1.0))
}

#[test]
fn wind_off_the_wing_rings_at_its_first_frequency_with_its_own_damping() {
    // x = e^(-z w t) cos(wd t): half a period apart, extremes fall by e^(-pi z / sqrt(1 - z²))
    let (file, wing) = wing_with(|_| ());
    let omega = structure::normal_modes(&wing.structure.as_ref().unwrap().0, 1).unwrap().omega_rad_s[0];
    for damping_ratio in [0.01, file.damping_ratio, 0.05] {
        let rig = Rig::new(
            &wing,
            RigSettings {
                air: AirModel::QuasiSteady,
                ..RigSettings::new(damping_ratio, file.pitch_axis_x())
            },
        )
        .unwrap();
        // after 1.5 s nothing is left of the second bending
        let (rings_at, damping) = frequency_and_damping(&ringing(&rig, &wing, 0.0, 4000), 1.5..4.0);
        let expected = omega * (1.0 - damping_ratio * damping_ratio).sqrt();
        assert!((rings_at / expected - 1.0).abs() < 1e-3, "{rings_at} {expected}");
        assert!((damping / damping_ratio - 1.0).abs() < 1e-2, "{damping} {damping_ratio}");
    }
}

#[test]
fn wind_makes_the_wing_ring_down_faster_and_the_faster_the_more() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    // what is left between 0.5 and 0.8 s, as a share of the largest
    let left = |v_m_s: f64| {
        let signal = ringing(&rig, &wing, v_m_s, 800);
        let largest =
            |range: std::ops::Range<usize>| signal[range].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        largest(500..800) / largest(0..500)
    };
    let shares = [0.0, 10.0, 20.0, 40.0].map(left);
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "{shares:?}");
}

#[test]
fn without_input_nothing_moves() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    for v_m_s in [0.0, 30.0] {
        let model = rig.at(Flow { v_m_s, rho_kg_m3: 1.225 }, &neutral).unwrap();
        let still = vec![0.0; 400];
        let alpha = Smooth { value: vec![0.03; 400], rate: still.clone(), second: still };
        let history = model.fly(&Motion { time_step_s: 0.005, alpha, controls_rad: Vec::new() });
        for channel in history.channels.iter().filter(|channel| channel.name.ends_with("_N")) {
            let first = channel.values[0];
            let drift = channel.values.iter().fold(0.0, |m: f64, v| m.max((v - first).abs()));
            assert!(drift < 1e-8 * first.abs().max(1.0), "{} at {v_m_s} m/s: {drift:e}", channel.name);
        }
    }
}
