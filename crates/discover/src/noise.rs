//! Pure error: what repeated measurements differ by, or what was stated.
//!
//! Repeats are compared after the simulation is taken off, as their angles are never quite the same. Per channel and band
//! of frequencies the mean square of half the difference estimates the noise; where the campaign states its noise, the
//! larger counts. Differences of means estimate the offset of a run. A load that runs lack has infinite noise: it
//! has no weight.

use crate::data::Dataset;
use crate::transform::{cosines, frequency_hz};
use calibrate::Use;
use coupling::{ByLoad, Load};
use maneuver::effects::Flown;

/// Why the noise is not known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the noise is not known: {nothing_repeats}, and campaign.ron states none of {load}")]
pub struct NoiseUnknown {
    /// What was looked for in vain.
    nothing_repeats: &'static str,
    /// The load.
    load: &'static str,
}

/// See the module. Channels are Fz, Mx, My.
#[derive(Debug, Clone, PartialEq)]
pub struct Noise {
    /// Upper ends of the bands, Hz.
    pub bands_hz: [f64; 5],
    /// Standard deviation of a cosine coefficient by airspeed, channel and band.
    pub run: Vec<[[f64; 5]; 3]>,
    /// Of the offset of a run, and of a block of static points.
    pub offset: ByLoad<f64>,
    /// Of a static point.
    pub point: ByLoad<f64>,
    /// How many pairs of runs were compared.
    pub pairs: usize,
}

impl Noise {
    /// Estimates the noise of a data set; `simulated` are its runs as the model flies them, in its order.
    ///
    /// # Errors
    /// If there are neither repeats nor stated noise.
    pub fn new(data: &Dataset, simulated: &[Flown]) -> Result<Self, NoiseUnknown> {
        let rules = &data.rules.noise;
        let band = |frequency_hz: f64| band(&rules.bands_hz, frequency_hz);
        let pairs = pairs(data);
        let scatter = static_scatter(data);
        let largest = ByLoad::from_fn(|load| scatter.within[load].max(scatter.between[load]));
        check_known(data, pairs.is_empty(), largest)?;
        let mut sums = vec![[[(0.0, 0_usize); 5]; 3]; data.airspeeds_m_s.len()];
        let mut offsets = [(0.0, 0_usize); 3];
        for &(a, b) in &pairs {
            let run = &data.runs[a];
            for c in 0..3 {
                let values = half_difference(data, simulated, (a, b), c);
                let (samples, dt) = (run.measured[c].len(), run.stimulus.time_step_s);
                for (k, value) in values.iter().enumerate() {
                    if k == 0 {
                        offsets[c].0 += value * value / samples as f64;
                        offsets[c].1 += 1;
                    } else {
                        let sum = &mut sums[run.airspeed][c][band(frequency_hz(k, samples, dt))];
                        *sum = (sum.0 + value * value, sum.1 + 1);
                    }
                }
            }
        }
        let stated_point =
            |load: Load| data.stated.map(|stated| stated.point[load]).filter(|sigma| *sigma > 0.0);
        let offset = ByLoad::from_fn(|load| {
            let c = load as usize;
            let runs = if offsets[c].1 > 0 { (offsets[c].0 / offsets[c].1 as f64).sqrt() } else { 0.0 };
            runs.max(scatter.between[load]).max(stated_point(load).unwrap_or(rules.least_offset))
        });
        let point =
            ByLoad::from_fn(|load| scatter.within[load].max(stated_point(load).unwrap_or(offset[load])));
        let decimation = decimation(data);
        let stated =
            data.stated.map(|stated| stated.sample.map(|sigma| sigma * sigma / decimation).to_array());
        let variance = |v: usize, c: usize, b: usize| {
            let at = sums[v][c][b];
            let pooled = sums.iter().map(|s| s[c][b]).fold((0.0, 0), |a, s| (a.0 + s.0, a.1 + s.1));
            let estimate =
                [at, pooled].into_iter().find(|s| s.1 >= rules.enough_coefficients).map(|s| s.0 / s.1 as f64);
            let all = sums.iter().flat_map(|s| s[c]).fold((0.0, 0), |a, s| (a.0 + s.0, a.1 + s.1));
            let estimate = estimate.or((all.1 > 0).then(|| all.0 / all.1 as f64));
            let variance = estimate.unwrap_or(0.0).max(stated.map_or(0.0, |s| s[c]));
            // without runs an experiment that is planned has at least a static point's
            let least = if data.runs.is_empty() { point[Load::ALL[c]].powi(2) } else { f64::MIN_POSITIVE };
            let there = if data.runs.is_empty() { data.static_loads()[c] } else { data.run_loads[c] };
            if there { variance.max(least) } else { f64::INFINITY }
        };
        let run = (0..data.airspeeds_m_s.len())
            .map(|v| std::array::from_fn(|c| std::array::from_fn(|b| variance(v, c, b).sqrt())))
            .collect();
        Ok(Self { bands_hz: rules.bands_hz, run, offset, point, pairs: pairs.len() })
    }

    /// Standard deviation of a coefficient.
    pub fn sigma(&self, airspeed: usize, channel: usize, frequency_hz: f64) -> f64 {
        self.run[airspeed][channel][band(&self.bands_hz, frequency_hz)]
    }
}

/// Cosine coefficients of what a run and its repeat differ by in a load (its place), the simulation taken off, over the root of two.
pub(crate) fn half_difference(
    data: &Dataset,
    simulated: &[Flown],
    (first, repeat): (usize, usize),
    load: usize,
) -> Vec<f64> {
    let residual = |i: usize, k: usize| data.runs[i].measured[load][k] - simulated[i].loads[load][k];
    let samples = data.runs[first].measured[load].len();
    let difference: Vec<f64> =
        (0..samples).map(|k| (residual(first, k) - residual(repeat, k)) / std::f64::consts::SQRT_2).collect();
    cosines(&difference, data.runs[first].stimulus.time_step_s, data.rules.data.highest_hz)
}

/// Training runs that repeat another: the first, and the repeat.
pub(crate) fn pairs(data: &Dataset) -> Vec<(usize, usize)> {
    let repeats = data.runs.iter().enumerate().filter_map(|(i, run)| run.repeat_of.map(|first| (first, i)));
    repeats
        .filter(|&(a, b)| {
            let (first, second) = (&data.runs[a], &data.runs[b]);
            [first, second].iter().all(|run| run.usage == Use::Train)
                && first.measured[0].len() == second.measured[0].len()
        })
        .collect()
}

/// Samples of a file to one that is used, at most, in the training runs.
pub(crate) fn decimation(data: &Dataset) -> f64 {
    let training = data.runs.iter().filter(|run| run.usage == Use::Train);
    training.map(|run| run.decimation).max().unwrap_or(1) as f64
}

/// The band of a frequency.
pub(crate) fn band(bands_hz: &[f64], frequency_hz: f64) -> usize {
    bands_hz.iter().position(|end| frequency_hz < *end).unwrap_or(bands_hz.len() - 1)
}

/// Standard deviations of repeated static points.
struct Scatter {
    /// Within blocks.
    within: ByLoad<f64>,
    /// Between blocks.
    between: ByLoad<f64>,
}

/// Scatter of repeated static points.
fn static_scatter(data: &Dataset) -> Scatter {
    let same_angle_rad = data.rules.noise.same_angle_rad;
    let (mut within, mut between) = ([(0.0, 0_usize); 3], [(0.0, 0_usize); 3]);
    for group in data.statics.iter().filter(|group| group.usage == Use::Train) {
        if data.airspeeds_m_s[group.airspeed] == 0.0 {
            continue;
        }
        let alphas = &group.stimulus.inputs.alpha.value;
        for c in 0..3 {
            let reading = |i: usize| group.measured[i][c];
            let mut done = vec![false; alphas.len()];
            for i in 0..alphas.len() {
                let same =
                    |j: &usize| (alphas[*j] - alphas[i]).abs() < same_angle_rad && reading(*j).is_some();
                let twins: Vec<usize> = (i..alphas.len()).filter(same).filter(|j| !done[*j]).collect();
                for &j in &twins {
                    done[j] = true;
                }
                let mut means = Vec::new();
                let mut blocks: Vec<Option<usize>> = twins.iter().map(|j| group.blocks[*j]).collect();
                blocks.dedup();
                for block in blocks {
                    let values: Vec<f64> = twins
                        .iter()
                        .filter(|j| group.blocks[**j] == block)
                        .filter_map(|j| reading(*j))
                        .collect();
                    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
                    if values.len() > 1 {
                        within[c].0 += values.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
                        within[c].1 += values.len() - 1;
                    }
                    means.push(mean);
                }
                if means.len() > 1 {
                    let mean = means.iter().sum::<f64>() / means.len() as f64;
                    between[c].0 += means.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
                    between[c].1 += means.len() - 1;
                }
            }
        }
    }
    let root = |(sum, count): (f64, usize)| if count > 0 { (sum / count as f64).sqrt() } else { 0.0 };
    let of = |sums: [(f64, usize); 3]| ByLoad::from_array(sums.map(root));
    Scatter { within: of(within), between: of(between) }
}

/// Every load of the runs needs a repeated run or stated noise; without runs, every load of the static points repeated
/// points or stated noise.
fn check_known(data: &Dataset, no_pairs: bool, scatter: ByLoad<f64>) -> Result<(), NoiseUnknown> {
    let stated = |c: usize, of_points: bool| {
        data.stated.is_some_and(|stated| {
            let sigma = if of_points { stated.point } else { stated.sample };
            sigma[Load::ALL[c]] > 0.0
        })
    };
    let (there, of_points) =
        if data.runs.is_empty() { (data.static_loads(), true) } else { (data.run_loads, false) };
    let repeated = |c: usize| if of_points { scatter[Load::ALL[c]] > 0.0 } else { !no_pairs };
    let nothing_repeats =
        if of_points { "no static point repeats another" } else { "no training run repeats another" };
    match (0..3).find(|&c| there[c] && !repeated(c) && !stated(c, of_points)) {
        Some(c) => Err(NoiseUnknown { nothing_repeats, load: crate::channels::LOADS[c] }),
        None => Ok(()),
    }
}
