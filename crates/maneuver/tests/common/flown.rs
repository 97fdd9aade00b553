//! The coarse wing with effects: a run, static points, what it shows.

use super::wing_with;
use aero::{Corrections, Flow};
use coupling::Mount;
use maneuver::effects::{Active, Effect, Flown, Inputs, Model, Stimulus, fly, library};
use maneuver::rom::{ReducedOrderModel, StiffnessParts};
use maneuver::{Rig, RigSettings, Smooth};
use std::sync::Arc;

const DT: f64 = 0.01;

/// Pitch of 5 degrees at 2 Hz with a doublet of every control beside it, at 20 degrees.
pub fn run(controls: usize) -> Stimulus {
    let times: Vec<f64> = (0..=300).map(|i| f64::from(i) * DT).collect();
    let w = std::f64::consts::TAU * 2.0;
    let bell = |t: f64| (-((t - 1.2) / 0.3).powi(2)).exp();
    let of = |value: &dyn Fn(f64) -> f64| times.iter().map(|&t| value(t)).collect::<Vec<f64>>();
    let alpha = Smooth {
        value: of(&|t| 0.05 + 0.09 * bell(t) * (w * t).sin()),
        rate: of(&|t| 0.09 * w * bell(t) * (w * t).cos()),
        second: of(&|t| -0.09 * w * w * bell(t) * (w * t).sin()),
    };
    let delta = of(&|t| 0.35 * bell(t) * (0.5 * w * t).sin());
    let incidence_rad = vec![0.0; times.len()];
    let inputs = Inputs { alpha, incidence_rad, controls_rad: vec![delta; controls] };
    Stimulus { inputs, time_step_s: DT, steady: false, clock_h: 0.5 }
}

/// Static points with every control at .1 rad.
pub fn points(controls: usize) -> Stimulus {
    let value: Vec<f64> = [-4.0_f64, -2.0, 0.0, 4.0, 8.0].iter().map(|a| a.to_radians()).collect();
    let still = vec![0.0; value.len()];
    let controls_rad = vec![vec![0.1; value.len()]; controls];
    let alpha = Smooth { rate: still.clone(), second: still.clone(), value };
    Stimulus {
        inputs: Inputs { alpha, incidence_rad: still, controls_rad },
        time_step_s: DT,
        steady: true,
        clock_h: 0.0,
    }
}

/// What it shows.
pub fn with(rom: &ReducedOrderModel, effects: &[Active], stimulus: &Stimulus) -> Flown {
    fly(rom, &Model::new(rom, effects, None), effects, stimulus)
}

/// Eight modes, no corrections.
pub fn rom(v_m_s: f64) -> ReducedOrderModel {
    let (file, wing) = wing_with(|_| ());
    let settings = RigSettings { modes: 8, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
    let rig = Rig::new(&wing, settings).unwrap();
    let flow = Flow { v_m_s, rho_kg_m3: 1.225 };
    let parts = StiffnessParts::new(&rig, &file.bulk(Mount::Tunnel).unwrap()).unwrap();
    ReducedOrderModel::new(&rig, flow, &Corrections::neutral(wing.correctable.len()), parts.as_ref()).unwrap()
}

/// An effect by its name, the first of its forms.
pub fn effect(rom: &ReducedOrderModel, name: &str) -> Arc<dyn Effect> {
    library(&rom.controls).into_iter().find(|e| e.spec().name == name).unwrap()
}

/// From the smallest to the largest.
pub fn swing(values: &[f64]) -> f64 {
    let largest = values.iter().copied().fold(f64::MIN, f64::max);
    largest - values.iter().copied().fold(f64::MAX, f64::min)
}
