//! Runs as oscillations at one amplitude each: a steady cycle is one, what follows a blow is one a second.

use crate::campaign::{Kind, Run};
use crate::rig::Scatter;
use crate::section::Stream;
use crate::window::{Oscillation, oscillation, strongest};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// An oscillation with where it was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Name of the run.
    pub run: String,
    /// The day.
    pub day: u32,
    /// What the run is.
    pub kind: Kind,
    /// The stream.
    pub stream: Stream,
    /// What was measured.
    pub measured: Oscillation,
    /// Mean of the pitch about the mean of the day, rad.
    pub mean_rad: f64,
}

/// Frequencies among which an oscillation is looked for, Hz, and length of a window after a blow, s.
const RANGE_HZ: [f64; 2] = [1.0, 8.0];
const WINDOW_S: f64 = 1.0;
/// An oscillation so many times that of turbulence, and what it leaves below this part of it, is one.
const ABOVE_TURBULENCE: f64 = 2.5;
const MOST_LEFT: f64 = 0.035;
/// What is nearer to the amplitude before is the same cycle.
const STEADY: f64 = 0.05;
/// In a window nothing may change by more than this: growth times its length.
const MOST_GROWTH: f64 = 0.45;

/// The oscillations of runs.
pub fn points(runs: &[Run], scatter: &Scatter) -> Vec<Point> {
    let mut points: Vec<Point> = runs.par_iter().flat_map_iter(|run| of_run(run, scatter)).collect();
    let mut days: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
    for point in &points {
        days.entry(point.day).or_default().push(point.mean_rad);
    }
    for point in &mut points {
        let means = &days[&point.day];
        point.mean_rad -= means.iter().sum::<f64>() / means.len() as f64;
    }
    points
}

fn of_run(run: &Run, scatter: &Scatter) -> Vec<Point> {
    let length = match run.kind {
        Kind::Cycle => run.pitch_rad.len(),
        Kind::Tap => {
            (1..run.pitch_rad.len()).find(|k| *k as f64 * run.step_s >= WINDOW_S).unwrap_or(usize::MAX)
        }
    };
    let windows = run.pitch_rad.chunks_exact(length).zip(run.heave_m.chunks_exact(length));
    let seen = windows.filter_map(|(pitch, heave)| {
        let omega = strongest(pitch, run.step_s, RANGE_HZ);
        let measured = oscillation(pitch, heave, run.step_s, omega, run.kind == Kind::Cycle);
        let clear = measured.amplitude_rad > ABOVE_TURBULENCE * scatter.turbulence_rad
            && measured.left_rad < MOST_LEFT * measured.amplitude_rad
            && measured.p.re.abs() * WINDOW_S < MOST_GROWTH;
        (clear || run.kind == Kind::Cycle).then(|| Point {
            run: run.name.clone(),
            day: run.day,
            kind: run.kind,
            stream: Stream { rho_kg_m3: run.rho_kg_m3, v_m_s: run.airspeed_m_s },
            mean_rad: measured.pitch_mean_rad + run.pitch_offset_rad,
            measured,
        })
    });
    // the first window has the blow in it, and the heave that dies at once
    let mut kept: Vec<Point> = Vec::new();
    for point in seen.skip(usize::from(run.kind == Kind::Tap)) {
        // a cycle that is reached says once what it says
        let amplitude = point.measured.amplitude_rad;
        let again = kept.last().is_some_and(|last| {
            (last.measured.amplitude_rad / amplitude - 1.0).abs() < STEADY
                && amplitude > 20.0 * scatter.turbulence_rad
        });
        if !again {
            kept.push(point);
        }
    }
    kept
}
