//! Residuals in units of what is known to be uncertain.
//!
//! `r = N⁻¹ T (y - f)`: cosine coefficients of measured minus simulated loads over their noise, then freed from what a run
//! may be off by without any effect (T): an offset, a gain of its mean and of its motion, a shift in time, and a share of
//! every effect found already (its form is never exact). The unit is therefore the run, not the sample. What all runs
//! share (calibrated parameters, corrections, model form) are further columns G with unit normal amplitudes:
//! `r' (I + G G')⁻¹ r`.

use crate::data::Dataset;
use crate::noise::Noise;
use crate::rules::Rules;
use crate::tolerance::Tolerance;
use crate::transform::{count, first_cosines, frequency_hz};
use calibrate::Use;
use coupling::{ByLoad, Load};
use maneuver::effects::{Flown, Stimulus};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// One run or static group in the residual.
#[derive(Debug, Clone)]
pub struct Segment {
    /// Its place among the simulator's stimuli.
    pub place: usize,
    /// Its rows.
    pub rows: std::ops::Range<usize>,
    pub(crate) kind: Kind,
    /// What is left of it once it is whitened: one a channel.
    tolerance: Vec<Tolerance>,
}

#[derive(Debug, Clone)]
pub(crate) enum Kind {
    /// `repeats` runs as their mean.
    Run {
        time_step_s: f64,
        samples: usize,
        coefficients: usize,
        /// The loads that runs have.
        channels: Vec<usize>,
        sigma: [Vec<f64>; 3],
        repeats: f64,
    },
    Static {
        rows: Vec<(usize, usize)>,
        sigma: ByLoad<f64>,
    },
}

/// The whitened measurements of the wanted segments.
#[derive(Debug, Clone)]
pub struct Problem<'a> {
    pub(crate) data: &'a Dataset,
    /// Static groups first, then runs.
    pub segments: Vec<Segment>,
    pub(crate) measured: Vec<f64>,
    pub(crate) offset: ByLoad<f64>,
}

impl<'a> Problem<'a> {
    /// Static groups and conditions (repeats taken together) of a usage: for searching.
    pub fn of_conditions(data: &'a Dataset, noise: &Noise, usage: Use) -> Self {
        let mut problem = Self::of_statics(data, noise, usage);
        for (i, one) in data.conditions.iter().enumerate().filter(|(_, one)| one.usage == usage) {
            let count = one.runs.len() as f64;
            let kind = Kind::run(data, &one.stimulus, noise, one.airspeed, count);
            let values = kind.whitened(&one.measured);
            problem.push(data.place_of_condition(i), kind, &values);
        }
        problem
    }

    /// Static groups and runs of a usage, every repeat for itself: for the gap.
    pub fn of_runs(data: &'a Dataset, noise: &Noise, usage: Use) -> Self {
        let mut problem = Self::of_statics(data, noise, usage);
        for (i, run) in data.runs.iter().enumerate().filter(|(_, run)| run.usage == usage) {
            let kind = Kind::run(data, &run.stimulus, noise, run.airspeed, 1.0);
            let values = kind.whitened(&run.measured);
            problem.push(data.place_of_run(i), kind, &values);
        }
        problem
    }

    fn of_statics(data: &'a Dataset, noise: &Noise, usage: Use) -> Self {
        let mut problem = Self { data, segments: Vec::new(), measured: Vec::new(), offset: noise.offset };
        for (place, group) in data.statics.iter().enumerate().filter(|(_, group)| group.usage == usage) {
            let rows: Vec<(usize, usize)> = (0..3)
                .flat_map(|c| (0..group.measured.len()).map(move |i| (c, i)))
                .filter(|&(c, i)| group.measured[i][c].is_some())
                .collect();
            let values: Vec<f64> = rows
                .iter()
                .map(|&(c, i)| group.measured[i][c].unwrap_or(0.0) / noise.point[Load::ALL[c]])
                .collect();
            problem.push(place, Kind::Static { rows, sigma: noise.point }, &values);
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

    /// Places of all segments in the problem.
    pub fn all(&self) -> Vec<usize> {
        (0..self.segments.len()).collect()
    }

    /// Segments at an airspeed.
    pub fn at_airspeed(&self, airspeed: usize) -> Vec<usize> {
        let of: Vec<usize> = self.data.stimuli().map(|(airspeed, _)| airspeed).collect();
        (0..self.segments.len()).filter(|s| of[self.segments[*s].place] == airspeed).collect()
    }

    /// Sets the tolerances around a simulation (one entry a segment); `found` are the contributions of effects that were
    /// found, each one entry a segment.
    pub fn set_tolerances(&mut self, simulated: &[Flown], found: &[Vec<Flown>]) {
        let Self { segments, data, offset, .. } = self;
        segments.par_iter_mut().enumerate().for_each(|(index, segment)| {
            let contributions: Vec<&Flown> = found.iter().map(|effect| &effect[index]).collect();
            let bounds = Bounds { offset: *offset, data, place: segment.place };
            segment.tolerance = segment.kind.tolerances(&simulated[index], &contributions, &bounds);
        });
    }

    /// The same where nothing is allowed to runs.
    #[must_use]
    pub(crate) fn without_tolerances(&self) -> Self {
        let mut problem = self.clone();
        for segment in &mut problem.segments {
            segment.tolerance.clear();
        }
        problem
    }

    /// Whitened measured minus simulated loads.
    pub fn residual(&self, simulated: &[Flown]) -> Vec<f64> {
        let loads: Vec<&[Vec<f64>; 3]> = simulated.iter().map(|flown| &flown.loads).collect();
        let whitened = self.whitened(&self.all(), &loads);
        self.freed(self.measured.iter().zip(whitened).map(|(measured, flown)| measured - flown).collect())
    }

    /// Whitened change of the simulated loads of some segments (zero elsewhere), freed from what a run may be off by.
    pub fn change(&self, segments: &[usize], after: &[Flown], before: &[&Flown]) -> Vec<f64> {
        self.freed(self.raw_change(segments, after, before))
    }

    /// The same, not freed.
    pub(crate) fn raw_change(&self, segments: &[usize], after: &[Flown], before: &[&Flown]) -> Vec<f64> {
        let changes: Vec<Flown> =
            after.iter().zip(before).map(|(after, before)| difference(after, before)).collect();
        self.whitened(segments, &changes.iter().map(|change| &change.loads).collect::<Vec<_>>())
    }

    /// Whitened loads of some segments, zero elsewhere. Two records of one length are transformed in one, whichever runs they are of.
    fn whitened(&self, segments: &[usize], loads: &[&[Vec<f64>; 3]]) -> Vec<f64> {
        let mut whitened = vec![0.0; self.len()];
        let mut records: BTreeMap<(usize, usize), Vec<Record<'_>>> = BTreeMap::new();
        for (index, loads) in segments.iter().zip(loads) {
            let Segment { rows, kind, .. } = &self.segments[*index];
            let Kind::Run { samples, coefficients, channels, sigma, .. } = kind else {
                whitened[rows.clone()].copy_from_slice(&kind.whitened(loads));
                continue;
            };
            for (place, c) in channels.iter().enumerate() {
                let (from, values) = (rows.start + place * coefficients, loads[*c].as_slice());
                // what does not change stands beside nothing that does
                if values.iter().any(|value| *value != 0.0) {
                    let record = Record { from, values, sigma: &sigma[*c] };
                    records.entry((*samples, *coefficients)).or_default().push(record);
                }
            }
        }
        for ((_, coefficients), records) in &records {
            let of_pair = |pair: &[Record<'_>]| {
                first_cosines(&pair.iter().map(|record| record.values).collect::<Vec<_>>(), *coefficients)
            };
            let cosines: Vec<Vec<Vec<f64>>> = records.par_chunks(2).with_min_len(4).map(of_pair).collect();
            for (record, cosines) in records.iter().zip(cosines.iter().flatten()) {
                let own = whitened[record.from..].iter_mut().zip(cosines.iter().zip(record.sigma));
                own.for_each(|(own, (value, sigma))| *own = value / sigma);
            }
        }
        whitened
    }

    /// Takes out what a run may be off by.
    pub(crate) fn freed(&self, mut values: Vec<f64>) -> Vec<f64> {
        for segment in &self.segments {
            let own = &mut values[segment.rows.clone()];
            for tolerance in &segment.tolerance {
                tolerance.free(own);
            }
        }
        values
    }
}

/// A channel of a run.
struct Record<'a> {
    /// Its first row.
    from: usize,
    values: &'a [f64],
    /// Of its coefficients.
    sigma: &'a [f64],
}

/// A column cut into bands of frequency, where the record is long enough that a band is a run of its own.
fn in_bands(rules: &Rules, column: &[f64], length_s: f64) -> Vec<Vec<f64>> {
    let highest_hz = rules.data.highest_hz;
    let width_hz = (rules.tolerance.one_run_s / length_s).max(1.0 / highest_hz) * highest_hz;
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

/// What bounds the tolerances of a segment.
struct Bounds<'a> {
    offset: ByLoad<f64>,
    data: &'a Dataset,
    place: usize,
}

impl Kind {
    /// A run, or the mean of several.
    fn run(data: &Dataset, stimulus: &Stimulus, noise: &Noise, airspeed: usize, repeats: f64) -> Self {
        let (samples, dt) = (stimulus.inputs.alpha.value.len(), stimulus.time_step_s);
        let coefficients = count(samples, dt, data.rules.data.highest_hz);
        let sigma = |c: usize| {
            let of = |k: usize| noise.sigma(airspeed, c, frequency_hz(k, samples, dt)) / repeats.sqrt();
            (0..coefficients).map(of).collect()
        };
        let channels = (0..3).filter(|&c| noise.run[airspeed][c][0].is_finite()).collect();
        let sigma = std::array::from_fn(sigma);
        Self::Run { time_step_s: dt, samples, coefficients, channels, sigma, repeats }
    }

    pub(crate) fn whitened(&self, loads: &[Vec<f64>; 3]) -> Vec<f64> {
        match self {
            Self::Run { channels, sigma, coefficients, .. } => {
                let records: Vec<&[f64]> = channels.iter().map(|&c| loads[c].as_slice()).collect();
                let all = first_cosines(&records, *coefficients);
                let sigmas = channels.iter().flat_map(|&c| &sigma[c]);
                all.into_iter().flatten().zip(sigmas).map(|(value, sigma)| value / sigma).collect()
            }
            Self::Static { rows, sigma } => {
                rows.iter().map(|&(c, i)| loads[c][i] / sigma[Load::ALL[c]]).collect()
            }
        }
    }

    /// Directions by channel.
    fn tolerances(&self, simulated: &Flown, found: &[&Flown], bounds: &Bounds<'_>) -> Vec<Tolerance> {
        let Bounds { offset, data, .. } = *bounds;
        let rules = &data.rules.tolerance;
        match self {
            Self::Run { time_step_s, samples, coefficients, channels, sigma, repeats } => channels
                .iter()
                .enumerate()
                .map(|(place, &c)| {
                    let load = &simulated.loads[c];
                    let mean = load.iter().sum::<f64>() / *samples as f64;
                    let moving: Vec<f64> =
                        load.iter().map(|value| rules.run_motion_gain * (value - mean)).collect();
                    let later = |load: &[f64], by_s: f64| -> Vec<f64> {
                        let slope = |i: usize| load[(i + 1).min(samples - 1)] - load[i.saturating_sub(1)];
                        (0..*samples).map(|i| by_s * slope(i) / (2.0 * time_step_s)).collect()
                    };
                    let still = vec![
                        (rules.run_mean_gain * mean).hypot(offset[Load::ALL[c]] / repeats.sqrt());
                        *samples
                    ];
                    let form = |flown: &&Flown| {
                        let own = &flown.loads[c];
                        [
                            own.iter().map(|value| rules.found_gain * value).collect(),
                            later(own, rules.found_shift_s),
                        ]
                    };
                    let mut records = vec![still, moving, later(load, rules.run_shift_s)];
                    records.extend(found.iter().flat_map(form));
                    let records: Vec<&[f64]> = records.iter().map(Vec::as_slice).collect();
                    let mut whitened = first_cosines(&records, *coefficients);
                    for record in &mut whitened {
                        record.iter_mut().zip(&sigma[c]).for_each(|(value, sigma)| *value /= sigma);
                    }
                    let length_s = *samples as f64 * time_step_s;
                    let mut columns = vec![whitened.remove(0)];
                    columns
                        .extend(whitened.iter().flat_map(|column| in_bands(&data.rules, column, length_s)));
                    Tolerance::new(place * coefficients..(place + 1) * coefficients, &columns)
                })
                .collect(),
            Self::Static { rows, sigma } => {
                (0..3).filter_map(|c| static_tolerance(c, rows, sigma, simulated, found, bounds)).collect()
            }
        }
    }
}

/// Directions of a channel of static points.
fn static_tolerance(
    c: usize,
    rows: &[(usize, usize)],
    sigma: &ByLoad<f64>,
    simulated: &Flown,
    found: &[&Flown],
    bounds: &Bounds<'_>,
) -> Option<Tolerance> {
    let Bounds { offset, data, place } = *bounds;
    let rules = &data.rules.tolerance;
    let from = rows.iter().position(|row| row.0 == c)?;
    let own: Vec<usize> = rows.iter().filter(|row| row.0 == c).map(|row| row.1).collect();
    let (offset, sigma) = (offset[Load::ALL[c]], sigma[Load::ALL[c]]);
    let load = |i: usize| simulated.loads[c][i] / sigma;
    let mut columns: Vec<Vec<f64>> = vec![own.iter().map(|&i| rules.static_gain * load(i)).collect()];
    let group = &data.statics[place];
    for block in 0..=data.blocks.len() {
        let of = |i: usize| group.blocks[i].unwrap_or(data.blocks.len()) == block;
        if own.iter().any(|&i| of(i)) {
            let column = own.iter().map(|&i| if of(i) { offset / sigma } else { 0.0 });
            columns.push(column.collect());
        }
    }
    let form = |flown: &&Flown| own.iter().map(|&i| rules.found_gain * flown.loads[c][i] / sigma).collect();
    columns.extend(found.iter().map(form));
    Some(Tolerance::new(from..from + own.len(), &columns))
}
