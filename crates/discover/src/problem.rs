//! Residuals in units of what is known to be uncertain.
//!
//! `r = N⁻¹ T (y - f)`: cosine coefficients of measured minus simulated loads over their noise, then freed from what a run
//! may be off by without any effect (T): an offset, a gain of its mean and of its motion, a shift in time, and a share of
//! every effect found already (its form is never exact). The unit is therefore the run, not the sample. What all runs
//! share (calibrated parameters, corrections, numerics) are further columns G with unit normal amplitudes:
//! `r' (I + G G')⁻¹ r`.

use crate::data::Dataset;
use crate::noise::Noise;
use crate::transform::{HIGHEST_HZ, cosines, count, frequency_hz};
use calibrate::Use;
use faer::linalg::matmul::matmul;
use faer::linalg::solvers::Solve;
use faer::{Accum, Mat, MatRef, Par, Side};
use maneuver::effects::Flown;

/// Tolerance of a run: gain of its mean, gain of its motion, time shift in s.
const RUN: [f64; 3] = [0.01, 0.03, 0.004];
/// A record's energy within a band counts as one run if it lasts so long, s: a chirp of 30 s is a dozen runs, one after
/// the other through the frequencies.
const LONG_S: f64 = 3.0;
/// Tolerance of a static group: gain.
const STATIC_GAIN: f64 = 0.01;
/// Tolerance of the form of an effect that was found.
const FORM: f64 = 0.15;

/// One run or static group in the residual.
#[derive(Debug, Clone)]
pub struct Segment {
    /// Its place among the simulator's stimuli.
    pub place: usize,
    /// Its rows.
    pub rows: std::ops::Range<usize>,
    kind: Kind,
    /// What is left of it once it is whitened: one a channel.
    tolerance: Vec<Tolerance>,
}

#[derive(Debug, Clone)]
enum Kind {
    Run { time_step_s: f64, samples: usize, coefficients: usize, sigma: [Vec<f64>; 3] },
    Static { rows: Vec<(usize, usize)>, sigma: [f64; 3] },
}

/// Orthonormal directions and what of them is left.
#[derive(Debug, Clone)]
struct Tolerance {
    rows: std::ops::Range<usize>,
    directions: Mat<f64>,
    taken: Vec<f64>,
}

/// The whitened measurements of the wanted segments.
#[derive(Debug)]
pub struct Problem<'a> {
    data: &'a Dataset,
    /// Static groups first, then runs.
    pub segments: Vec<Segment>,
    measured: Vec<f64>,
    offset: [f64; 3],
}

impl<'a> Problem<'a> {
    /// The segments of a usage.
    pub fn new(data: &'a Dataset, noise: &Noise, usage: Use) -> Self {
        let mut problem = Self { data, segments: Vec::new(), measured: Vec::new(), offset: noise.offset };
        for (place, group) in data.statics.iter().enumerate().filter(|(_, group)| group.usage == usage) {
            let rows: Vec<(usize, usize)> = (0..3)
                .flat_map(|c| (0..group.measured.len()).map(move |i| (c, i)))
                .filter(|&(c, i)| group.measured[i][c].is_some())
                .collect();
            let values: Vec<f64> =
                rows.iter().map(|&(c, i)| group.measured[i][c].unwrap_or(0.0) / noise.point[c]).collect();
            problem.push(place, Kind::Static { rows, sigma: noise.point }, &values);
        }
        let first = data.statics.len();
        for (i, run) in data.runs.iter().enumerate().filter(|(_, run)| run.usage == usage) {
            let (samples, dt) = (run.measured[0].len(), run.stimulus.time_step_s);
            let coefficients = count(samples, dt);
            let sigma = std::array::from_fn(|c| {
                (0..coefficients)
                    .map(|k| noise.sigma(run.airspeed, c, frequency_hz(k, samples, dt)))
                    .collect()
            });
            let kind = Kind::Run { time_step_s: dt, samples, coefficients, sigma };
            let values = kind.whitened(&run.measured);
            problem.push(first + i, kind, &values);
        }
        problem
    }

    fn push(&mut self, place: usize, kind: Kind, values: &[f64]) {
        let from = self.measured.len();
        self.measured.extend_from_slice(values);
        let rows = from..self.measured.len();
        self.segments.push(Segment { place, rows, kind, tolerance: Vec::new() });
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.measured.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.measured.is_empty()
    }

    /// Places of the segments among the simulator's stimuli.
    pub fn places(&self) -> Vec<usize> {
        self.segments.iter().map(|segment| segment.place).collect()
    }

    /// Segments at an airspeed.
    pub fn at_airspeed(&self, airspeed: usize) -> Vec<usize> {
        let statics = self.data.statics.len();
        let of = |place: usize| match place.checked_sub(statics) {
            None => self.data.statics[place].airspeed,
            Some(run) => self.data.runs[run].airspeed,
        };
        (0..self.segments.len()).filter(|s| of(self.segments[*s].place) == airspeed).collect()
    }

    /// Sets the tolerances around a simulation (one entry a segment); `found` are the contributions of effects that were
    /// found, each one entry a segment.
    pub fn set_tolerances(&mut self, simulated: &[Flown], found: &[Vec<Flown>]) {
        for (index, segment) in self.segments.iter_mut().enumerate() {
            let contributions: Vec<&Flown> = found.iter().map(|effect| &effect[index]).collect();
            segment.tolerance = segment.kind.tolerances(
                &simulated[index],
                &contributions,
                self.offset,
                self.data,
                segment.place,
            );
        }
    }

    /// Whitened measured minus simulated loads.
    pub fn residual(&self, simulated: &[Flown]) -> Vec<f64> {
        let mut residual = self.measured.clone();
        for (segment, flown) in self.segments.iter().zip(simulated) {
            let values = segment.kind.whitened(&flown.loads);
            residual[segment.rows.clone()].iter_mut().zip(values).for_each(|(r, s)| *r -= s);
        }
        self.free(&mut residual);
        residual
    }

    /// Whitened change of the simulated loads of some segments (zero elsewhere).
    pub fn change(&self, segments: &[usize], after: &[Flown], before: &[&Flown]) -> Vec<f64> {
        let mut change = vec![0.0; self.len()];
        for ((&index, after), before) in segments.iter().zip(after).zip(before) {
            let segment = &self.segments[index];
            let difference = difference(after, before);
            change[segment.rows.clone()].copy_from_slice(&segment.kind.whitened(&difference.loads));
        }
        self.free(&mut change);
        change
    }

    /// Takes out what a run may be off by.
    fn free(&self, values: &mut [f64]) {
        for segment in &self.segments {
            let own = &mut values[segment.rows.clone()];
            for tolerance in &segment.tolerance {
                let part = &mut own[tolerance.rows.clone()];
                for (j, taken) in tolerance.taken.iter().enumerate() {
                    let direction = tolerance.directions.col_as_slice(j);
                    let share: f64 = direction.iter().zip(part.iter()).map(|(d, p)| d * p).sum();
                    part.iter_mut().zip(direction).for_each(|(p, d)| *p -= taken * share * d);
                }
            }
        }
    }
}

/// A column cut into bands of so many Hz, where the record is long enough that a band is a run of its own.
fn in_bands(column: &[f64], length_s: f64) -> Vec<Vec<f64>> {
    let width_hz = (LONG_S / length_s).max(1.0 / HIGHEST_HZ) * HIGHEST_HZ;
    let band = |k: usize| (k as f64 / (2.0 * length_s) / width_hz).floor();
    let last = band(column.len().saturating_sub(1));
    let mut bands = Vec::new();
    let mut at = 0.0;
    while at <= last {
        let cut = column.iter().enumerate().map(|(k, value)| if band(k) == at { *value } else { 0.0 });
        bands.push(cut.collect());
        at += 1.0;
    }
    bands
}

/// Loads of one minus those of the other.
pub fn difference(after: &Flown, before: &Flown) -> Flown {
    let minus = |a: &Vec<f64>, b: &Vec<f64>| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<f64>>();
    Flown {
        loads: std::array::from_fn(|c| minus(&after.loads[c], &before.loads[c])),
        tip_m: minus(&after.tip_m, &before.tip_m),
    }
}

impl Kind {
    fn whitened(&self, loads: &[Vec<f64>; 3]) -> Vec<f64> {
        match self {
            Self::Run { time_step_s, sigma, .. } => (0..3)
                .flat_map(|c| {
                    let all = cosines(&loads[c], *time_step_s);
                    all.into_iter().zip(&sigma[c]).map(|(value, sigma)| value / sigma).collect::<Vec<f64>>()
                })
                .collect(),
            Self::Static { rows, sigma } => rows.iter().map(|&(c, i)| loads[c][i] / sigma[c]).collect(),
        }
    }

    /// Directions by channel.
    fn tolerances(
        &self,
        simulated: &Flown,
        found: &[&Flown],
        offset: [f64; 3],
        data: &Dataset,
        place: usize,
    ) -> Vec<Tolerance> {
        match self {
            Self::Run { time_step_s, samples, coefficients, sigma } => (0..3)
                .map(|c| {
                    let load = &simulated.loads[c];
                    let mean = load.iter().sum::<f64>() / *samples as f64;
                    let moving: Vec<f64> = load.iter().map(|value| RUN[1] * (value - mean)).collect();
                    let later: Vec<f64> = (0..*samples)
                        .map(|i| {
                            let (a, b) = (load[i.saturating_sub(1)], load[(i + 1).min(samples - 1)]);
                            RUN[2] * (b - a) / (2.0 * time_step_s)
                        })
                        .collect();
                    let whitened = |column: &[f64]| -> Vec<f64> {
                        let all = cosines(column, *time_step_s);
                        all.into_iter().zip(&sigma[c]).map(|(value, sigma)| value / sigma).collect()
                    };
                    let still = whitened(&vec![(RUN[0] * mean).hypot(offset[c]); *samples]);
                    let mut columns = vec![still];
                    let form = |flown: &&Flown| {
                        flown.loads[c].iter().map(|value| FORM * value).collect::<Vec<f64>>()
                    };
                    for column in [moving, later].into_iter().chain(found.iter().map(form)) {
                        columns.extend(in_bands(&whitened(&column), *samples as f64 * time_step_s));
                    }
                    Tolerance::new(c * coefficients..(c + 1) * coefficients, &columns)
                })
                .collect(),
            Self::Static { rows, sigma } => (0..3)
                .filter_map(|c| {
                    let from = rows.iter().position(|row| row.0 == c)?;
                    let own: Vec<usize> = rows.iter().filter(|row| row.0 == c).map(|row| row.1).collect();
                    let load = |i: usize| simulated.loads[c][i] / sigma[c];
                    let mut columns: Vec<Vec<f64>> =
                        vec![own.iter().map(|&i| STATIC_GAIN * load(i)).collect()];
                    let group = &data.statics[place];
                    for block in 0..=data.blocks.len() {
                        let of = |i: usize| group.blocks[i].unwrap_or(data.blocks.len()) == block;
                        if own.iter().any(|&i| of(i)) {
                            let column = own.iter().map(|&i| if of(i) { offset[c] / sigma[c] } else { 0.0 });
                            columns.push(column.collect());
                        }
                    }
                    let form =
                        |flown: &&Flown| own.iter().map(|&i| FORM * flown.loads[c][i] / sigma[c]).collect();
                    columns.extend(found.iter().map(form));
                    Some(Tolerance::new(from..from + own.len(), &columns))
                })
                .collect(),
        }
    }
}

impl Tolerance {
    /// `(I + L L')^(-1/2) = I - U diag(1 - 1/sqrt(1 + s²)) U'`, L the columns.
    fn new(rows: std::ops::Range<usize>, columns: &[Vec<f64>]) -> Self {
        let k = columns.len();
        let dot = |i: usize, j: usize| columns[i].iter().zip(&columns[j]).map(|(a, b)| a * b).sum::<f64>();
        let gram = Mat::from_fn(k, k, dot);
        let mut directions = Vec::new();
        let mut taken = Vec::new();
        if let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) {
            for j in 0..k {
                let square = eigen.S()[j];
                if square > 1e-8 {
                    let scale = 1.0 / square.sqrt();
                    let direction: Vec<f64> = (0..rows.len())
                        .map(|row| scale * (0..k).map(|i| columns[i][row] * eigen.U()[(i, j)]).sum::<f64>())
                        .collect();
                    directions.push(direction);
                    taken.push(1.0 - 1.0 / (1.0 + square).sqrt());
                }
            }
        }
        let directions = Mat::from_fn(rows.len(), taken.len(), |row, j| directions[j][row]);
        Self { rows, directions, taken }
    }
}

/// What all runs share: columns with unit normal amplitudes, and the inner product that they leave.
#[derive(Debug, Clone)]
pub struct Shared {
    columns: Mat<f64>,
    inverse: Mat<f64>,
}

impl Shared {
    /// From the columns (each as long as the residual).
    pub fn new(columns: &[Vec<f64>], rows: usize) -> Self {
        let g = Mat::from_fn(rows, columns.len(), |i, j| columns[j][i]);
        let mut a = product(g.as_ref(), g.as_ref());
        for j in 0..a.ncols() {
            a[(j, j)] += 1.0;
        }
        let inverse = match a.llt(Side::Lower) {
            Ok(factor) => factor.solve(Mat::identity(a.nrows(), a.nrows())),
            Err(_) => Mat::identity(a.nrows(), a.nrows()),
        };
        Self { columns: g, inverse }
    }

    /// `X' (I + G G')⁻¹ X`.
    pub fn gram(&self, x: MatRef<'_, f64>) -> Mat<f64> {
        let plain = product(x, x);
        let seen = product(self.columns.as_ref(), x);
        plain - seen.transpose() * (&self.inverse * &seen)
    }

    /// `(I + G G')⁻¹ x`.
    pub fn weighted(&self, x: &[f64]) -> Vec<f64> {
        let column = Mat::from_fn(x.len(), 1, |i, _| x[i]);
        let seen = product(self.columns.as_ref(), column.as_ref());
        let amplitude = &self.inverse * &seen;
        let mut weighted = x.to_vec();
        for j in 0..self.columns.ncols() {
            let by = amplitude[(j, 0)];
            weighted.iter_mut().zip(self.columns.col_as_slice(j)).for_each(|(w, g)| *w -= by * g);
        }
        weighted
    }
}

/// `A' B`, on one thread, so that the result does not depend on their number.
fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.ncols(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a.transpose(), b, 1.0, Par::Seq);
    product
}

/// Root mean square of measured minus simulated loads over the noise, by channel and together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Fz, Mx, My.
    pub by_channel: [f64; 3],
    /// Over all channels.
    pub all: f64,
    /// Root mean square of the residual over that of the variation of the load, per cent, by channel.
    pub raw_percent: [f64; 3],
}

impl Problem<'_> {
    /// The gap of a simulation (one entry a segment), nothing taken out.
    pub fn gap(&self, simulated: &[Flown]) -> Gap {
        let (mut squares, mut counts) = ([0.0; 3], [0_usize; 3]);
        let (mut raw, mut variation) = ([0.0; 3], [0.0; 3]);
        for (segment, flown) in self.segments.iter().zip(simulated) {
            let measured = &self.measured[segment.rows.clone()];
            let simulated = segment.kind.whitened(&flown.loads);
            for (i, (m, s)) in measured.iter().zip(&simulated).enumerate() {
                let (c, sigma, first) = segment.kind.row(i);
                squares[c] += (m - s).powi(2);
                counts[c] += 1;
                raw[c] += (sigma * (m - s)).powi(2);
                // the mean of a run is no variation
                variation[c] += if first { 0.0 } else { (sigma * m).powi(2) };
            }
        }
        let root = |sum: f64, count: usize| (sum / count.max(1) as f64).sqrt();
        Gap {
            by_channel: std::array::from_fn(|c| root(squares[c], counts[c])),
            all: root(squares.iter().sum(), counts.iter().sum()),
            raw_percent: std::array::from_fn(|c| {
                100.0 * (raw[c] / variation[c].max(f64::MIN_POSITIVE)).sqrt()
            }),
        }
    }

    /// The same problem with loads of a simulation and noise in place of the measurements.
    pub fn pretending(&self, simulated: &[Flown], mut normal: impl FnMut() -> f64) -> Self {
        let mut measured = Vec::with_capacity(self.measured.len());
        for (segment, flown) in self.segments.iter().zip(simulated) {
            measured.extend(segment.kind.whitened(&flown.loads).into_iter().map(|value| value + normal()));
        }
        Self { data: self.data, segments: self.segments.clone(), measured, offset: self.offset }
    }
}

impl Kind {
    /// Channel of a row, its noise, and whether it is the mean of a record.
    fn row(&self, i: usize) -> (usize, f64, bool) {
        match self {
            Self::Run { coefficients, sigma, .. } => {
                let (c, k) = (i / coefficients, i % coefficients);
                (c, sigma[c][k], k == 0)
            }
            Self::Static { rows, sigma } => (rows[i].0, sigma[rows[i].0], false),
        }
    }
}
