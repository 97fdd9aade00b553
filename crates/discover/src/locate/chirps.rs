//! How the residual of a chirp goes with its input: linearly, with harmonics, again in a repeat, or not at all.
//!
//! In windows of a few turns the residual is split by least squares, one after the other, into what goes with delta and
//! its rate (linear: a transfer function that is wrong), with their products of second and third order (harmonics), and
//! the rest. What two repeats leave in common is no noise.

use super::map::band;
use super::regressors::squares_left;
use super::residuals::{Residuals, Unit};
use crate::rules::LocateRules;

/// One chirp and channel in a band.
#[derive(Debug, Clone, PartialEq)]
pub struct ChirpCell {
    /// The run.
    pub run: String,
    /// Channel.
    pub channel: &'static str,
    /// Place in [`crate::rules::LocateRules`] of the input's frequency.
    pub band: usize,
    /// Share of the residual's power that is linear in the input: its coherence.
    pub linear: f64,
    /// Share with twice the input's frequency (and its mean).
    pub second: f64,
    /// Share with three times the input's frequency (and once more the input's).
    pub third: f64,
    /// The linear share that noise alone would have.
    pub by_chance: f64,
    /// Coherence with the residual of a repeat: the share that is no noise; none without a repeat.
    pub repeats: Option<f64>,
}

/// Sums over windows of one band.
#[derive(Clone, Copy, Default)]
struct Sums {
    total: f64,
    left: [f64; 3],
    chance: f64,
    products: [f64; 3],
}

/// All chirps.
pub fn chirps(residuals: &Residuals) -> Vec<ChirpCell> {
    let mut cells = Vec::new();
    for unit in &residuals.units {
        let Some(control) = unit.maneuver.swept_control() else { continue };
        let same = |other: &&Unit| unit.repeat_of == Some(other.place) || other.repeat_of == Some(unit.place);
        let repeat = residuals.units.iter().find(same);
        for (c, channel) in crate::channels::LOADS.into_iter().enumerate() {
            let sums = sums(&residuals.rules.locate, unit, repeat, control, c);
            for (band, sums) in sums.into_iter().enumerate().filter(|(_, sums)| sums.total > 0.0) {
                let share = |from: f64, to: f64| ((from - to) / sums.total).max(0.0);
                let [ab, aa, bb] = sums.products;
                cells.push(ChirpCell {
                    run: unit.name.clone(),
                    channel,
                    band,
                    linear: share(sums.total, sums.left[0]),
                    second: share(sums.left[0], sums.left[1]),
                    third: share(sums.left[1], sums.left[2]),
                    by_chance: sums.chance / sums.total,
                    repeats: (aa > 0.0 && bb > 0.0).then(|| ab * ab / (aa * bb)),
                });
            }
        }
    }
    cells
}

fn sums(rules: &LocateRules, unit: &Unit, repeat: Option<&Unit>, control: usize, c: usize) -> Vec<Sums> {
    let dt = unit.stimulus.time_step_s;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of samples")]
    let length = ((rules.window_s / dt).round() as usize).max(rules.window_samples);
    let delta = &unit.stimulus.inputs.controls_rad[control];
    let mut all = vec![Sums::default(); rules.bands_hz.len()];
    let mut from = 0;
    while from + length <= delta.len() {
        let inside = from..from + length;
        from += length;
        let d = &delta[inside.clone()];
        let turns = d.windows(2).filter(|pair| pair[0] < 0.0 && pair[1] >= 0.0).count() as f64;
        if turns < 1.0 {
            continue;
        }
        let rate: Vec<f64> = (0..length)
            .map(|i| {
                let (before, after) = (i.saturating_sub(1), (i + 1).min(length - 1));
                (d[after] - d[before]) / (after - before) as f64
            })
            .collect();
        let times = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect::<Vec<f64>>();
        let squares = [times(d, d), times(d, &rate)];
        let cubes = [times(&squares[0], d), times(&squares[0], &rate)];
        let columns = [&[vec![1.0; length], d.to_vec(), rate][..], &squares, &cubes].concat();
        let residual = &unit.residual[c][inside.clone()];
        let left = squares_left(&columns, residual, [1, 3, 5, 7]);
        let sums = &mut all[band(&rules.bands_hz, turns / (length as f64 * dt))];
        sums.total += left[0];
        sums.chance += 2.0 / (length - 1) as f64 * left[0];
        (0..3).for_each(|k| sums.left[k] += left[k + 1]);
        if let Some(other) = repeat.and_then(|repeat| repeat.residual[c].get(inside)) {
            let off = |values: &[f64]| {
                let mean = crate::statistics::mean(values);
                values.iter().map(|value| value - mean).collect::<Vec<f64>>()
            };
            let (a, b) = (off(residual), off(other));
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let new = [dot(&a, &b), dot(&a, &a), dot(&b, &b)];
            sums.products.iter_mut().zip(new).for_each(|(sum, new)| *sum += new);
        }
    }
    all
}
