//! Histories by Fourier transform: the responses of a [`ReducedOrderModel`](super::ReducedOrderModel) on a grid of
//! frequencies, between them by cubic interpolation, times the spectrum of what drives it.
//!
//! A record is continued beyond its end: its drives go back to their first value and wait until the wing is at rest
//! again. A causal system does not see that before the record ends, so within the record the periodic answer is the
//! answer from rest. Drives are band limited between samples (their continuation is smooth).

use super::{Constants, ReducedOrderModel};
use crate::periodic::{RETURN_S, continued, steps};
use faer::{Mat, c64};
use fourier::fast_length;
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::rc::Rc;
use std::sync::Arc;

use super::change::Change;

/// Highest frequency of the grid, Hz: as far as the smoothing of inputs lets anything through.
const HIGHEST_HZ: f64 = 25.0;
/// Above the grid responses fade to nothing over this share of its highest frequency.
const FADE: f64 = 0.2;
/// How long the wing then has to come to rest, s: with and without a stream, which damps it.
const REST_S: [f64; 2] = [5.0, 20.0];

/// Places in the table and their weights at the frequency of a bin.
type Weights = [(usize, f64); 4];

/// As many weights are kept: the runs of a campaign have few lengths, and where each has its own, memory does not grow with them.
const MOST_KEPT: usize = 64;

/// Length, time step and grid of frequencies, the last two by their bits.
type BinsOf = (usize, u64, Vec<u64>);

thread_local! {
    /// Weights of all bins.
    static WEIGHTS: RefCell<HashMap<BinsOf, Rc<[Weights]>>> = RefCell::new(HashMap::new());
}

/// Responses of a rig at the frequencies of the grid, and at rest.
#[derive(Debug, Clone)]
pub struct ResponseTable {
    /// Frequencies, Hz, ascending from zero.
    pub frequencies_hz: Vec<f64>,
    /// Outputs by drives.
    pub responses: Arc<[Mat<c64>]>,
    /// Outputs by the constants of the wing itself.
    pub rest: Vec<f64>,
    rest_s: f64,
}

impl ResponseTable {
    /// Computes the table; `everything` includes lifts and heights of zones.
    pub fn new(rig: &ReducedOrderModel, change: &Change, constants: &Constants, everything: bool) -> Self {
        let wind = rig.flow.v_m_s > 0.0;
        let frequencies_hz = grid(wind);
        let omegas: Vec<f64> = frequencies_hz.iter().map(|f| TAU * f).collect();
        Self {
            responses: rig.responses(change, &omegas, everything).into(),
            rest: rig.at_rest(change, constants, everything),
            rest_s: REST_S[usize::from(!wind)],
            frequencies_hz,
        }
    }

    /// Adds what steady drives (column of the response, values) make of some outputs (rows of it), sample by sample.
    pub fn add_steady(&self, drives: &[(usize, &[f64])], rows: &[usize], sums: &mut [Vec<f64>]) {
        for (row, sums) in rows.iter().zip(sums) {
            for (column, values) in drives {
                let response = self.responses[0][(*row, *column)].re;
                sums.iter_mut().zip(*values).for_each(|(sum, value)| *sum += response * value);
            }
        }
    }

    /// The same of drives that begin at rest, all of one length and time step.
    pub fn add_flown(
        &self,
        drives: &[(usize, &[f64])],
        time_step_s: f64,
        rows: &[usize],
        sums: &mut [Vec<f64>],
    ) {
        let Some(samples) = drives.iter().map(|(_, values)| values.len()).max() else { return };
        let length = fast_length(samples + steps(RETURN_S + self.rest_s, time_step_s));
        let moving: Vec<&(usize, &[f64])> =
            drives.iter().filter(|(_, values)| values.iter().any(|value| *value != values[0])).collect();
        let spectra: Vec<Vec<c64>> = moving
            .chunks(2)
            .flat_map(|pair| {
                let mut both = vec![c64::new(0.0, 0.0); length];
                for (one, (_, values)) in [ONE, SECOND].into_iter().zip(pair) {
                    let values = continued(values, length, time_step_s);
                    both.iter_mut().zip(values).for_each(|(both, value)| *both += one * value);
                }
                fourier::forward(&mut both);
                parted(&both, pair.len())
            })
            .collect();
        let columns: Vec<usize> = moving.iter().map(|(column, _)| *column).collect();
        let mut outputs = self.answered(&columns, &spectra, rows, length, time_step_s);
        for both in &mut outputs {
            fourier::backward(both);
        }
        let scale = 1.0 / length as f64;
        let first = &self.responses[0];
        for (k, (row, sums)) in rows.iter().zip(sums).enumerate() {
            let start: f64 = drives.iter().map(|(column, v)| first[(*row, *column)].re * v[0]).sum();
            let is_second = k % 2 == 1;
            for (sum, both) in sums.iter_mut().zip(&outputs[k / 2]) {
                // what differs from the first sample, as the record begins at rest
                *sum += start + scale * if is_second { both.im } else { both.re };
            }
        }
    }

    /// Spectra of outputs, two real ones in one: the second is the imaginary part.
    fn answered(
        &self,
        columns: &[usize],
        spectra: &[Vec<c64>],
        rows: &[usize],
        length: usize,
        time_step_s: f64,
    ) -> Vec<Vec<c64>> {
        let zero = c64::new(0.0, 0.0);
        let mut outputs = vec![vec![zero; length]; rows.len().div_ceil(2)];
        let (mut sums, mut between) = (vec![zero; rows.len()], vec![zero; rows.len()]);
        for (bin, weights) in self.weights_of_bins(length, time_step_s).iter().enumerate() {
            sums.fill(zero);
            for (column, spectrum) in columns.iter().zip(spectra) {
                between.fill(zero);
                for &(k, weight) in weights {
                    let responses = self.responses[k].col_as_slice(*column);
                    between.iter_mut().zip(rows).for_each(|(sum, row)| *sum += responses[*row] * weight);
                }
                let drive = spectrum[bin];
                sums.iter_mut().zip(&between).for_each(|(sum, h)| *sum += h * drive);
            }
            for (pair, both) in sums.chunks(2).zip(&mut outputs) {
                let (a, b) = (pair[0], pair.get(1).copied().unwrap_or(zero));
                if bin == 0 || 2 * bin == length {
                    both[bin] = c64::new(a.re, b.re);
                } else {
                    both[bin] = a + SECOND * b;
                    both[length - bin] = a.conj() + SECOND * b.conj();
                }
            }
        }
        outputs
    }

    /// Weights by bin of a spectrum, to the end of the grid or of the spectrum's first half.
    fn weights_of_bins(&self, length: usize, time_step_s: f64) -> Rc<[Weights]> {
        let all = || {
            let at = |bin: usize| self.weights(bin as f64 / (length as f64 * time_step_s));
            (0..=length / 2).map_while(at).collect()
        };
        let grid = self.frequencies_hz.iter().map(|f| f.to_bits()).collect();
        let key = (length, time_step_s.to_bits(), grid);
        WEIGHTS.with_borrow_mut(|known| {
            if known.len() == MOST_KEPT && !known.contains_key(&key) {
                known.clear();
            }
            Rc::clone(known.entry(key).or_insert_with(all))
        })
    }

    /// Those at a frequency; none above the grid.
    fn weights(&self, frequency_hz: f64) -> Option<Weights> {
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

/// What the first and the second of two real records count in the complex one that holds both.
const ONE: c64 = c64::new(1.0, 0.0);
/// See above.
const SECOND: c64 = c64::new(0.0, 1.0);

/// The spectra of one or two real records from that of both in one, to half its length: that of a real record is its own
/// mirror image, conjugate.
fn parted(both: &[c64], count: usize) -> Vec<Vec<c64>> {
    let length = both.len();
    let mirrored = |bin: usize| both[(length - bin) % length].conj();
    let first = |bin: usize| 0.5 * (both[bin] + mirrored(bin));
    let second = |bin: usize| c64::new(0.0, -0.5) * (both[bin] - mirrored(bin));
    let bins = 0..=length / 2;
    match count {
        1 => vec![both[bins].to_vec()],
        _ => vec![bins.clone().map(first).collect(), bins.map(second).collect()],
    }
}

#[cfg(test)]
mod tests;
