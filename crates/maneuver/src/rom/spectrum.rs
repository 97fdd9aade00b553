//! Histories by Fourier transform: the responses of a [`ReducedOrderModel`](super::ReducedOrderModel) on a grid of
//! frequencies, between them by cubic interpolation, times the spectrum of what drives it.
//!
//! A record is continued beyond its end: its drives go back to their first value and wait until the wing is at rest
//! again. A causal system does not see that before the record ends, so within the record the periodic answer is the
//! answer from rest. Drives are band limited between samples (their continuation is smooth).

use super::driven::{Driven, Period, SECOND, transform};
use super::{Constants, ReducedOrderModel};
use crate::periodic::{RETURN_S, steps};
use faer::{Mat, c64};
use fourier::fast_length;
use pulp::{Arch, Simd, WithSimd};
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

    /// Adds what steady drives make of some outputs (rows of the response), sample by sample.
    pub fn add_steady(&self, drives: &[&Driven], rows: &[usize], sums: &mut [Vec<f64>]) {
        for (row, sums) in rows.iter().zip(sums) {
            for drive in drives {
                let response = self.responses[0][(*row, drive.column)].re;
                sums.iter_mut().zip(drive.values()).for_each(|(sum, value)| *sum += response * value);
            }
        }
    }

    /// The same of drives that begin at rest, all of one length and time step.
    pub fn add_flown(&self, drives: &[&Driven], time_step_s: f64, rows: &[usize], sums: &mut [Vec<f64>]) {
        let samples = drives.iter().map(|drive| drive.values().len()).max().unwrap_or(0);
        if samples == 0 {
            return;
        }
        let first = &self.responses[0];
        for (row, sums) in rows.iter().zip(sums.iter_mut()) {
            let start: f64 = drives.iter().map(|d| first[(*row, d.column)].re * d.values()[0]).sum();
            for sum in sums {
                *sum += start;
            }
        }
        let moving: Vec<&Driven> = drives.iter().copied().filter(|drive| drive.moves()).collect();
        if moving.is_empty() {
            return;
        }
        let length = fast_length(samples + steps(RETURN_S + self.rest_s, time_step_s));
        let weights = self.weights_of_bins(length, time_step_s);
        transform(&moving, Period { length, bins: weights.len(), time_step_s });
        let scale = 1.0 / length as f64;
        for (pair, both) in sums.chunks_mut(2).zip(self.answered(&moving, rows, &weights, length)) {
            // what differs from the first sample, as the record begins at rest
            for (is_second, sums) in pair.iter_mut().enumerate() {
                let of = |both: &c64| if is_second == 1 { both.im } else { both.re };
                sums.iter_mut().zip(&both).for_each(|(sum, both)| *sum += scale * of(both));
            }
        }
    }

    /// Outputs behind their first samples and times the number of samples, two real ones in one: the second is the imaginary part.
    fn answered(
        &self,
        drives: &[&Driven],
        rows: &[usize],
        weights: &[Weights],
        length: usize,
    ) -> Vec<Vec<c64>> {
        let mut outputs = vec![vec![c64::new(0.0, 0.0); length]; rows.len().div_ceil(2)];
        let picked = Picked::new(self, drives, rows);
        Arch::new().dispatch(Answering { picked, weights, drives, rows: rows.len(), outputs: &mut outputs });
        for both in &mut outputs {
            fourier::backward(both);
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

/// Responses of some outputs by some drives, frequency by frequency: drive by drive the real parts of the outputs, then the imaginary ones.
struct Picked {
    values: Vec<f64>,
    /// Numbers a frequency.
    width: usize,
}

impl Picked {
    fn new(table: &ResponseTable, drives: &[&Driven], rows: &[usize]) -> Self {
        let width = 2 * rows.len() * drives.len();
        let mut values = Vec::with_capacity(width * table.responses.len());
        for responses in table.responses.iter() {
            for drive in drives {
                let column = responses.col_as_slice(drive.column);
                values.extend(rows.iter().map(|row| column[*row].re));
                values.extend(rows.iter().map(|row| column[*row].im));
            }
        }
        Self { values, width }
    }
}

/// Spectra of outputs, two real ones in one.
struct Answering<'a> {
    picked: Picked,
    weights: &'a [Weights],
    drives: &'a [&'a Driven],
    rows: usize,
    outputs: &'a mut [Vec<c64>],
}

impl WithSimd for Answering<'_> {
    type Output = ();

    #[expect(clippy::inline_always, reason = "vector instructions are those of what calls it")]
    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        let Self { picked: Picked { values, width }, weights, drives, rows, outputs } = self;
        let (mut between, mut sums) = (vec![0.0; width], vec![0.0; 2 * rows]);
        for (bin, weights) in weights.iter().enumerate() {
            let [a, b, c, d] = weights.map(|(frequency, _)| &values[frequency * width..][..width]);
            let by = weights.map(|(_, weight)| weight);
            for ((((between, a), b), c), d) in between.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                *between = by[0] * a + by[1] * b + by[2] * c + by[3] * d;
            }
            sums.fill(0.0);
            let (re, im) = sums.split_at_mut(rows);
            for (response, drive) in between.chunks_exact(2 * rows).zip(drives) {
                let drive = drive.spectrum()[bin];
                let (own_re, own_im) = response.split_at(rows);
                for ((re, im), (own_re, own_im)) in re.iter_mut().zip(&mut *im).zip(own_re.iter().zip(own_im))
                {
                    *re += own_re * drive.re - own_im * drive.im;
                    *im += own_re * drive.im + own_im * drive.re;
                }
            }
            for (both, (re, im)) in outputs.iter_mut().zip(re.chunks(2).zip(im.chunks(2))) {
                let length = both.len();
                let a = c64::new(re[0], im[0]);
                let b = c64::new(re.get(1).copied().unwrap_or(0.0), im.get(1).copied().unwrap_or(0.0));
                if bin == 0 || 2 * bin == length {
                    both[bin] = c64::new(a.re, b.re);
                } else {
                    both[bin] = a + SECOND * b;
                    both[length - bin] = a.conj() + SECOND * b.conj();
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
