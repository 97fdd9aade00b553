//! Cycles of runs that were kept from the fit: what the fitted rig predicts beside what was measured.

use crate::campaign::{Kind, Run};
use crate::cycles::{FROM_RAD, Settled, aside, settle};
use crate::fit::Fitted;
use crate::points::Point;
use crate::rig::Rig;
use crate::section::Stream;
use crate::window::{Oscillation, oscillation, strongest};
use rayon::prelude::*;

/// A run beside its prediction.
#[derive(Debug, Clone)]
pub struct Prediction {
    /// The run.
    pub run: Run,
    /// Whether it was kept from the fit.
    pub held_out: bool,
    /// The measured cycle.
    pub measured: Oscillation,
    /// What the rig settles on.
    pub settled: Settled,
}

/// Cycles of all runs that are cycles.
pub fn predictions(rig: &Rig, fitted: &Fitted, runs: &[Run], held_out: &[bool]) -> Vec<Prediction> {
    let cycles = runs.par_iter().zip(held_out).filter(|(run, _)| run.kind == Kind::Cycle);
    let of = |(run, held_out): (&Run, &bool)| {
        let omega = strongest(&run.pitch_rad, run.step_s, [1.0, 8.0]);
        let measured = oscillation(&run.pitch_rad, &run.heave_m, run.step_s, omega, true);
        let stream = Stream { rho_kg_m3: run.rho_kg_m3, v_m_s: run.airspeed_m_s };
        let settled = settle(&fitted.model(rig, run.day), stream, aside(FROM_RAD), omega);
        Prediction { run: run.clone(), held_out: *held_out, measured, settled }
    };
    cycles.map(of).collect()
}

/// How far predictions are from measurements.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Score {
    /// Cycles.
    pub cycles: usize,
    /// Of them, those that the model does not have.
    pub missing: usize,
    /// Root mean square error of the pitch amplitude, as a part of it.
    pub amplitude: f64,
    /// Root mean square error of the frequency, as a part of it.
    pub frequency: f64,
}

/// The score of those predictions that are chosen.
pub fn score<'p>(chosen: impl Iterator<Item = &'p Prediction>) -> Score {
    let mut score = Score::default();
    for Prediction { measured, settled, .. } in chosen {
        score.cycles += 1;
        if let Some(cycle) = &settled.cycle {
            score.amplitude += (cycle.amplitude_rad / measured.amplitude_rad - 1.0).powi(2);
            score.frequency += (cycle.p.im / measured.p.im - 1.0).powi(2);
        } else {
            score.missing += 1;
        }
    }
    let there = (score.cycles - score.missing).max(1) as f64;
    Score {
        amplitude: (score.amplitude / there).sqrt(),
        frequency: (score.frequency / there).sqrt(),
        ..score
    }
}

/// The airspeed (m/s) at which measured oscillations up to an amplitude (rad) neither grow nor decay: where a straight line
/// through their growth over airspeed, each weighed by its amplitude squared, is zero; none if growth does not rise.
pub fn measured_onset_m_s(points: &[Point], largest_rad: f64) -> Option<f64> {
    let small = points.iter().filter(|p| p.kind == Kind::Tap && p.measured.amplitude_rad < largest_rad);
    let [mut sum, mut v, mut g, mut vv, mut vg] = [0.0; 5];
    for point in small {
        let (weight, speed, growth) =
            (point.measured.amplitude_rad.powi(2), point.stream.v_m_s, point.measured.p.re);
        sum += weight;
        v += weight * speed;
        g += weight * growth;
        vv += weight * speed * speed;
        vg += weight * speed * growth;
    }
    let slope = (sum * vg - v * g) / (sum * vv - v * v);
    let onset = (v - g / slope) / sum;
    (slope > 0.0 && onset.is_finite()).then_some(onset)
}
