//! Measured minus simulated in units of pure error: cosine coefficients of runs, points of static groups.

use super::maneuver::Maneuver;
use crate::data::Dataset;
use crate::rules::Rules;
use crate::transform::{count, first_cosines, frequency_hz};
use calibrate::Use;
use coupling::{ByLoad, Load};
use maneuver::effects::{Flown, Stimulus};
use rayon::prelude::*;
use std::sync::Arc;

/// Pure error.
pub struct PureError<'a> {
    /// Standard deviation of a cosine coefficient by airspeed's place, channel and frequency in Hz.
    pub coefficient: &'a (dyn Fn(usize, usize, f64) -> f64 + Sync),
    /// Of a static point.
    pub point: ByLoad<f64>,
    /// Degrees of freedom of these estimates, where they are estimates.
    pub degrees_of_freedom: Option<f64>,
}

/// A run or a static group.
#[derive(Debug, Clone)]
pub struct Unit {
    /// Name of the run or of the static group.
    pub name: String,
    /// What it is.
    pub maneuver: Maneuver,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Place in the order static groups, runs.
    pub place: usize,
    /// The unit it repeats, by place.
    pub repeat_of: Option<usize>,
    /// What drove it.
    pub stimulus: Stimulus,
    /// Frequency of each row, Hz; zero for static points.
    pub frequency_hz: Vec<f64>,
    /// Weight by row and channel: what residuals and regressors are multiplied by.
    pub weight: [Vec<f64>; 3],
    /// Weighted residuals; empty for a channel that the unit lacks. The first row of a run is its mean, weighted as one
    /// sample: offsets of a day are about as large as that.
    pub rows: [Vec<f64>; 3],
    /// Residuals as histories or points, N and N m.
    pub residual: [Vec<f64>; 3],
}

impl Unit {
    /// Series of the unit as its rows, without a channel's weights.
    pub fn rows_of(&self, series: &[&[f64]]) -> Vec<Vec<f64>> {
        if self.stimulus.steady {
            return series.iter().map(|values| values.to_vec()).collect();
        }
        first_cosines(series, self.frequency_hz.len())
    }
}

/// See the module.
#[derive(Debug, Clone)]
pub struct Residuals {
    /// What decides.
    pub rules: Arc<Rules>,
    /// Static groups, then runs; those wanted.
    pub units: Vec<Unit>,
    /// Names of the controls.
    pub controls: Vec<String>,
    /// Of the pure error, where it is estimated.
    pub degrees_of_freedom: Option<f64>,
}

impl Residuals {
    /// `simulated`: static groups, then runs; `only`: training or held-out data, or all.
    pub fn new(
        data: &Dataset,
        simulated: &[Flown],
        error: &PureError<'_>,
        controls: &[String],
        only: Option<Use>,
    ) -> Self {
        let wanted = |usage: Use| only.is_none_or(|only| only == usage);
        let statics = data.statics.len();
        let groups = (0..statics).filter(|&i| wanted(data.statics[i].usage));
        let runs = (0..data.runs.len()).filter(|&i| wanted(data.runs[i].usage)).map(|i| i + statics);
        let places: Vec<usize> = groups.chain(runs).collect();
        let unit = |&place: &usize| match place.checked_sub(statics) {
            None => group(data, place, &simulated[place], error),
            Some(run) => of_run(data, run, &simulated[place], error),
        };
        let units = places.par_iter().map(unit).collect();
        Self {
            rules: Arc::clone(&data.rules),
            units,
            controls: controls.to_vec(),
            degrees_of_freedom: error.degrees_of_freedom,
        }
    }
}

fn of_run(data: &Dataset, i: usize, simulated: &Flown, error: &PureError<'_>) -> Unit {
    let run = &data.runs[i];
    let (samples, dt) = (run.measured[0].len(), run.stimulus.time_step_s);
    let v_m_s = data.airspeeds_m_s[run.airspeed];
    let residual: [Vec<f64>; 3] = std::array::from_fn(|c| {
        let difference = run.measured[c].iter().zip(&simulated.loads[c]).map(|(m, s)| m - s);
        if data.run_loads[c] { difference.collect() } else { Vec::new() }
    });
    let hz: Vec<f64> =
        (0..count(samples, dt, data.rules.data.highest_hz)).map(|k| frequency_hz(k, samples, dt)).collect();
    let mut present = first_cosines(
        &residual.iter().filter(|values| !values.is_empty()).map(Vec::as_slice).collect::<Vec<_>>(),
        hz.len(),
    )
    .into_iter();
    let coefficients = residual
        .each_ref()
        .map(|values| if values.is_empty() { Vec::new() } else { present.next().unwrap_or_default() });
    let weight: [Vec<f64>; 3] = std::array::from_fn(|c| {
        let of = |(k, hz): (usize, &f64)| {
            let one = (error.coefficient)(run.airspeed, c, *hz).recip();
            if k == 0 { one / (samples as f64).sqrt() } else { one }
        };
        hz.iter().enumerate().map(of).collect()
    });
    let rows = std::array::from_fn(|c| coefficients[c].iter().zip(&weight[c]).map(|(r, w)| r * w).collect());
    Unit {
        name: run.name.clone(),
        maneuver: Maneuver::of(&data.rules.locate, &run.stimulus, v_m_s),
        v_m_s,
        place: i + data.statics.len(),
        repeat_of: run.repeat_of.map(|first| first + data.statics.len()),
        stimulus: run.stimulus.clone(),
        frequency_hz: hz,
        weight,
        rows,
        residual,
    }
}

fn group(data: &Dataset, i: usize, simulated: &Flown, error: &PureError<'_>) -> Unit {
    let group = &data.statics[i];
    let v_m_s = data.airspeeds_m_s[group.airspeed];
    let points = group.measured.len();
    let has = |c: usize| group.measured.iter().any(|loads| loads[c].is_some());
    let at = |c: usize, p: usize| group.measured[p][c].map_or(0.0, |load| load - simulated.loads[c][p]);
    let residual: [Vec<f64>; 3] =
        std::array::from_fn(|c| if has(c) { (0..points).map(|p| at(c, p)).collect() } else { Vec::new() });
    // a point that lacks the channel has no weight
    let weight: [Vec<f64>; 3] = std::array::from_fn(|c| {
        let one =
            |p: usize| if group.measured[p][c].is_some() { error.point[Load::ALL[c]].recip() } else { 0.0 };
        (0..points).map(one).collect()
    });
    Unit {
        name: format!("static points at {v_m_s} m/s"),
        maneuver: Maneuver::of(&data.rules.locate, &group.stimulus, v_m_s),
        v_m_s,
        place: i,
        repeat_of: None,
        stimulus: group.stimulus.clone(),
        frequency_hz: vec![0.0; points],
        rows: std::array::from_fn(|c| residual[c].iter().zip(&weight[c]).map(|(r, w)| r * w).collect()),
        weight,
        residual,
    }
}
