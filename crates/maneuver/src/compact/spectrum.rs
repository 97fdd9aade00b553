//! Histories by Fourier transform: the responses of a [`Compact`](super::Compact) rig on a grid of frequencies, between
//! them by cubic interpolation, times the spectrum of what drives it.
//!
//! A record is continued beyond its end: its drives go back to their first value and wait until the wing is at rest
//! again. A causal system does not see that before the record ends, so within the record the periodic answer is the
//! answer from rest. Drives are band limited between samples (their continuation is smooth).

use super::{Compact, Constants};
use faer::{Mat, c64};
use rustfft::FftPlanner;
use std::cell::RefCell;
use std::f64::consts::{PI, TAU};

use super::change::Change;

thread_local! {
    /// Plans are made once a length.
    static PLANNER: RefCell<FftPlanner<f64>> = RefCell::new(FftPlanner::new());
}

/// Highest frequency of the grid, Hz: as far as the smoothing of inputs lets anything through.
const HIGHEST_HZ: f64 = 25.0;
/// Above the grid responses fade to nothing over this share of its highest frequency.
const FADE: f64 = 0.2;
/// How long drives take to return, s.
const RETURN_S: f64 = 1.0;
/// How long the wing then has to come to rest, s: with and without a stream, which damps it.
const REST_S: [f64; 2] = [5.0, 20.0];

/// Responses of a rig at the frequencies of the grid, and at rest.
#[derive(Debug, Clone)]
pub struct ResponseTable {
    /// Frequencies, Hz, ascending from zero.
    pub frequencies_hz: Vec<f64>,
    /// Outputs by drives.
    pub responses: Vec<Mat<c64>>,
    /// Outputs by the constants of the wing itself.
    pub rest: Vec<f64>,
    rest_s: f64,
}

impl ResponseTable {
    /// Computes the table; `everything` includes lifts and heights of zones.
    pub fn new(rig: &Compact, change: &Change, constants: &Constants, everything: bool) -> Self {
        let wind = rig.flow.v_m_s > 0.0;
        let frequencies_hz = grid(wind);
        let omegas: Vec<f64> = frequencies_hz.iter().map(|f| TAU * f).collect();
        Self {
            responses: rig.responses(change, &omegas, everything),
            rest: rig.at_rest(change, constants, everything),
            rest_s: REST_S[usize::from(!wind)],
            frequencies_hz,
        }
    }

    /// Number of outputs.
    pub fn outputs(&self) -> usize {
        self.rest.len()
    }

    /// Steady outputs for every sample of steady drives (column of the response, values).
    pub fn steady(&self, drives: &[(usize, &[f64])], samples: usize) -> Vec<Vec<f64>> {
        let response = &self.responses[0];
        let output = |row: usize| {
            let at = |i: usize| {
                self.rest[row]
                    + drives
                        .iter()
                        .map(|(column, values)| response[(row, *column)].re * values[i])
                        .sum::<f64>()
            };
            (0..samples).map(at).collect()
        };
        (0..self.outputs()).map(output).collect()
    }

    /// Outputs of drives that begin at rest: (column of the response, samples), all of one length and time step.
    pub fn fly(&self, drives: &[(usize, &[f64])], time_step_s: f64) -> Vec<Vec<f64>> {
        let Some(samples) = drives.iter().map(|(_, values)| values.len()).max() else {
            return self.rest.iter().map(|_| Vec::new()).collect();
        };
        let length = fast_length(samples + steps(RETURN_S + self.rest_s, time_step_s));
        let (forward, backward) = PLANNER
            .with_borrow_mut(|planner| (planner.plan_fft_forward(length), planner.plan_fft_inverse(length)));
        let moving: Vec<&(usize, &[f64])> =
            drives.iter().filter(|(_, values)| values.iter().any(|value| *value != values[0])).collect();
        let spectra: Vec<Vec<c64>> = moving
            .iter()
            .map(|(_, values)| {
                let mut spectrum = continued(values, length, time_step_s);
                forward.process(&mut spectrum);
                spectrum
            })
            .collect();
        let bins = length / 2 + 1;
        let columns: Vec<usize> = moving.iter().map(|(column, _)| *column).collect();
        let mut outputs = vec![vec![c64::new(0.0, 0.0); length]; self.outputs()];
        for bin in 0..bins {
            let Some(weights) = self.weights(bin as f64 / (length as f64 * time_step_s)) else { break };
            for (row, output) in outputs.iter_mut().enumerate() {
                let mut sum = c64::new(0.0, 0.0);
                for (column, spectrum) in columns.iter().zip(&spectra) {
                    let mut h = c64::new(0.0, 0.0);
                    for (k, weight) in weights {
                        h += self.responses[k][(row, *column)] * weight;
                    }
                    sum += h * spectrum[bin];
                }
                output[bin] = sum;
                if bin > 0 && 2 * bin < length {
                    output[length - bin] = sum.conj();
                }
            }
        }
        let scale = 1.0 / length as f64;
        let first = &self.responses[0];
        outputs
            .into_iter()
            .enumerate()
            .map(|(row, mut output)| {
                backward.process(&mut output);
                let start = self.rest[row]
                    + drives.iter().map(|(column, v)| first[(row, *column)].re * v[0]).sum::<f64>();
                // what differs from the first sample, as the record begins at rest
                (0..samples).map(|i| start + scale * output[i].re).collect()
            })
            .collect()
    }

    /// Places in the table and their weights at a frequency; none above the grid.
    fn weights(&self, frequency_hz: f64) -> Option<[(usize, f64); 4]> {
        let f = &self.frequencies_hz;
        let last = f.len() - 1;
        let over = (frequency_hz / f[last] - 1.0) / FADE;
        if over >= 1.0 {
            return None;
        }
        if over >= 0.0 {
            let fade = 0.5 * (1.0 + (PI * over).cos());
            return Some([(last, fade), (last, 0.0), (last, 0.0), (last, 0.0)]);
        }
        let right = f.partition_point(|grid| *grid <= frequency_hz).clamp(1, last);
        let first = (right.saturating_sub(2)).min(last - 3);
        let at: [f64; 4] = std::array::from_fn(|k| f[first + k]);
        Some(std::array::from_fn(|k| {
            let others = (0..4).filter(|j| *j != k);
            let weight = others.map(|j| (frequency_hz - at[j]) / (at[k] - at[j])).product();
            (first + k, weight)
        }))
    }
}

/// Finer where the first bending lies; much finer without wind, where only the structure damps it.
fn grid(wind: bool) -> Vec<f64> {
    let steps: &[(f64, f64)] =
        if wind { &[(12.0, 0.2), (HIGHEST_HZ, 0.5)] } else { &[(8.0, 0.05), (12.0, 0.1), (HIGHEST_HZ, 0.2)] };
    let mut grid = vec![0.0];
    for &(to, step) in steps {
        let from = grid[grid.len() - 1];
        grid.extend((1..=steps_between(from, to, step)).map(|k| from + step * k as f64));
    }
    grid
}

fn steps_between(from: f64, to: f64, step: f64) -> usize {
    steps(to - from, step)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive number of steps")]
fn steps(length: f64, step: f64) -> usize {
    (length / step).round() as usize
}

/// The next length that is a product of 2, 3 and 5.
fn fast_length(least: usize) -> usize {
    let smooth = |mut n: usize| {
        for p in [2, 3, 5] {
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        n == 1
    };
    // a power of two lies between any number and its double
    (least..=2 * least).find(|n| n.is_multiple_of(2) && smooth(*n)).unwrap_or(least)
}

/// The change from the first sample, brought back to zero after the last.
fn continued(values: &[f64], length: usize, time_step_s: f64) -> Vec<c64> {
    let (first, last) = (values[0], values[values.len() - 1]);
    let back = steps(RETURN_S, time_step_s).max(1);
    (0..length)
        .map(|i| {
            let value = match i.checked_sub(values.len()) {
                None => values[i] - first,
                Some(beyond) if beyond < back => {
                    (last - first) * 0.5 * (1.0 + (PI * (beyond + 1) as f64 / back as f64).cos())
                }
                Some(_) => 0.0,
            };
            c64::new(value, 0.0)
        })
        .collect()
}
