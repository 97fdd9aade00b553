//! The coarse wing with effects: a run, static points, what it shows.

use super::wing_with;
use aero::{Corrections, Flow};
use coupling::Mount;
use faer::Mat;
use faer::linalg::solvers::Solve;
use maneuver::effects::{Active, Effect, Flown, Inputs, Model, Parameter, Stimulus, fly, library};
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

/// The effect at a share of its plausible size.
pub fn plausible(effect: &Arc<dyn Effect>, share: f64) -> Active {
    let size = |p: &Parameter| if p.upper > 0.0 { share * p.plausible } else { -share * p.plausible };
    Active::new(effect.clone(), &effect.parameters().iter().map(size).collect::<Vec<f64>>())
}

/// Standard deviation of the noise of [`Recording::with_noise`], N and N m.
const NOISE: f64 = 0.05;
/// Step of the fit's differences, in plausible sizes.
const STEP: f64 = 1e-3;

/// A small campaign: a run and static points without wind and at two airspeeds, the controls moved one after the other.
pub struct Recording {
    parts: Vec<(ReducedOrderModel, Model, Stimulus)>,
}

impl Recording {
    /// Of the coarse wing.
    pub fn new() -> Self {
        let parts = [0.0, 20.0, 34.0].into_iter().flat_map(|v_m_s| {
            let rom = rom(v_m_s);
            let plain = Model::new(&rom, &[], None);
            let mut stimuli = [run(rom.controls.len()), points(rom.controls.len())];
            for (c, control) in stimuli[0].inputs.controls_rad.iter_mut().enumerate() {
                control.rotate_right(25 * c);
            }
            for (c, control) in stimuli[1].inputs.controls_rad.iter_mut().enumerate() {
                control.iter_mut().enumerate().for_each(|(i, delta)| *delta *= f64::from(u8::from(i == c)));
            }
            stimuli.map(|stimulus| (rom.clone(), plain.clone(), stimulus))
        });
        Self { parts: parts.collect() }
    }

    /// Names of the controls.
    pub fn controls(&self) -> &[String] {
        &self.parts[0].0.controls
    }

    /// All loads with effects, one after the other.
    pub fn flown(&self, effects: &[Active]) -> Vec<f64> {
        let one = |(rom, plain, stimulus): &(ReducedOrderModel, Model, Stimulus)| {
            fly(rom, &Model::new(rom, effects, Some(plain)), effects, stimulus).loads.concat()
        };
        self.parts.iter().flat_map(one).collect()
    }

    /// The same with noise that is nearly normal: sums of twelve uniform numbers (Numerical Recipes' generator).
    #[expect(clippy::unused_self, reason = "the noise is that of every case")]
    pub fn with_noise(&self, loads: &[f64]) -> Vec<f64> {
        let mut state = 1_u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
        };
        loads.iter().map(|load| load + NOISE * (0..12).map(|_| uniform()).sum::<f64>()).collect()
    }

    /// A sum of squares over the noise's variance.
    #[expect(clippy::unused_self, reason = "the noise is that of every case")]
    pub fn in_noise(&self, square: f64) -> f64 {
        square / (NOISE * NOISE)
    }

    /// Least squares of an effect's values from a start, by Levenberg and Marquardt.
    pub fn fit(&self, effect: &Arc<dyn Effect>, measured: &[f64], start: &[f64]) -> Active {
        let parameters = effect.parameters();
        let k = parameters.len();
        let residual = |active: &Active| -> Vec<f64> {
            measured.iter().zip(self.flown(std::slice::from_ref(active))).map(|(m, f)| m - f).collect()
        };
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let moved = |from: &Active, steps: &dyn Fn(usize) -> f64| {
            let values = from.values.iter().zip(&parameters).enumerate();
            let values: Vec<f64> = values.map(|(j, (v, p))| v + steps(j) * p.plausible).collect();
            Active::new(effect.clone(), &values)
        };
        let mut at = Active::new(effect.clone(), start);
        let mut r = residual(&at);
        let mut damping = 1e-3;
        for _ in 0..40 {
            let column = |which: usize| -> Vec<f64> {
                let inward =
                    if at.values[which] + STEP * parameters[which].plausible > parameters[which].upper {
                        -STEP
                    } else {
                        STEP
                    };
                let next = residual(&moved(&at, &|j| if j == which { inward } else { 0.0 }));
                r.iter().zip(next).map(|(before, after)| (before - after) / inward).collect()
            };
            let columns: Vec<Vec<f64>> = (0..k).map(column).collect();
            let before = dot(&r, &r);
            let mut done = true;
            while damping < 1e8 {
                let normal = Mat::from_fn(k, k, |i, j| {
                    dot(&columns[i], &columns[j]) * if i == j { 1.0 + damping } else { 1.0 }
                        + if i == j { 1e-12 } else { 0.0 }
                });
                let right = Mat::from_fn(k, 1, |i, _| dot(&columns[i], &r));
                let step = normal.partial_piv_lu().solve(&right);
                let next = moved(&at, &|j| step[(j, 0)]);
                let after = residual(&next);
                if dot(&after, &after) < before {
                    done = dot(&after, &after) > (1.0 - 1e-9) * before;
                    (at, r) = (next, after);
                    damping *= 0.1;
                    break;
                }
                damping *= 10.0;
            }
            if done {
                break;
            }
        }
        at
    }
}
