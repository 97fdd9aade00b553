//! The deflection correction identified from measured doublets (paper 1, Eq. 10): the scale K of a commanded doublet that makes
//! the linear simulation follow the measured loads best, over the whole doublet and all three loads at once.
//!
//! The simulation is linear in the deflection, so one flight with the commanded doublet (K = 1) and one without give the
//! response x of each channel, and measured minus the flight without is `y = K x + constant + error`. Both pass the
//! zero-phase filter S of `simulate`. With weights `w = 1/sigma²`,
//! ```text
//! K = sum_c w_c x_cᵀ y_c / sum_c w_c x_cᵀ x_c              (x without its mean: the constant is the trim's)
//! variance, noise:     sum_c w_c² sigma_c² |S x_c|² / (sum_c w_c x_cᵀ x_c)²
//! variance, residuals: Bartlett's sum of the scores w_c x_c r_c over lags up to a fifth of a second, same denominator
//! ```
//! The first is exact for white noise of the declared size and counts the filter's correlation; the second also sees
//! what the model cannot follow and the noise of the measured angle. The larger of the two is taken.

use crate::history::TimeHistory;
use crate::motion::{Doublet, Record};
use crate::rig_model::{Motion, RigModel};
use crate::run::Run;
use crate::simulate::motion_of;
use crate::smoothing::zero_phase;
use aero::flow::same_airspeed;
use coupling::wing_file::{DeflectionRow, DeflectionTable, OutsideAirspeeds};
use coupling::{ByLoad, Load};
use nastran::InputError;
use std::path::Path;

/// Longest lag of correlated residuals, s.
const LAG_S: f64 = 0.2;
/// Deflections that differ by less than this share are one.
const SAME_DEFLECTION: f64 = 0.02;

/// The doublet that a run is.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredDoublet {
    /// The control surface that moves.
    pub control: String,
    /// Height of the commanded doublet, rad.
    pub commanded_rad: f64,
}

/// One run's contribution to a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct DoubletFit {
    /// What moved.
    pub doublet: MeasuredDoublet,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Equivalent over commanded deflection.
    pub factor: f64,
    /// One standard error of it.
    pub standard_error: f64,
    /// The part of it that the declared noise alone leaves; none without declared noise.
    pub noise_error: Option<f64>,
    /// Root mean square of the filtered residuals over sigma, all channels, trim removed: with K = 1 and as fitted; none
    /// without declared noise.
    pub gap: Option<[f64; 2]>,
    /// `sum w xᵀx`, by which runs are pooled.
    information: f64,
}

/// K of one control surface, airspeed and deflection: one run or several repeats.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedFactor {
    /// The control surface.
    pub control: String,
    /// Mean airspeed, m/s.
    pub v_m_s: f64,
    /// Commanded deflection, rad.
    pub commanded_rad: f64,
    /// Equivalent over commanded deflection.
    pub factor: f64,
    /// One standard error of it.
    pub standard_error: f64,
    /// Number of runs.
    pub runs: usize,
}

/// The doublet of a run in which one control surface alone goes to plus and minus one height; none for other runs.
pub fn doublet_of(run: &Run) -> Option<MeasuredDoublet> {
    let moved = |values: &[f64]| values.iter().any(|delta| *delta != 0.0);
    let mut moving = run.controls_rad.iter().filter(|(_, values)| moved(values));
    let (control, values) = moving.next().filter(|_| run.v_m_s > 0.0)?;
    if moving.next().is_some() {
        return None;
    }
    let record = Record { values, time_step_s: run.time_step_s, is_angle: false };
    Doublet::fits(&record)
        .then(|| MeasuredDoublet { control: control.clone(), commanded_rad: record.height() })
}

/// Fits K to a run that is a doublet. `sigma`: one standard deviation of a sample of Fz, Mx, My as declared; without it
/// the channels are weighted by their residuals.
///
/// # Errors
/// A run without loads, that is no doublet, or whose control surface the wing does not have or does nothing.
pub fn fit_doublet(
    run: &Run,
    model: &RigModel,
    sigma: Option<ByLoad<f64>>,
    file: &Path,
) -> Result<DoubletFit, InputError> {
    let refuse =
        |message: &str| Err(InputError::in_file(file, message).with_help("leave this run out of the fit"));
    let Some(doublet) = doublet_of(run) else {
        return refuse("this run is no doublet of one control surface");
    };
    let Some(measured) = &run.loads else { return refuse("this run has no measured loads") };
    let motion = motion_of(run, model, file)?;
    let still = motion.controls_rad.iter().map(|values| vec![0.0; values.len()]).collect();
    let unmoved = model.fly(&Motion { controls_rad: still, ..motion.clone() });
    let moved = model.fly(&motion);
    let channel = |c: usize| {
        let of = |history: &TimeHistory| history.get(Load::ALL[c].column()).unwrap_or(&[]).to_vec();
        let (with, without) = (of(&moved), of(&unmoved));
        let x = with.iter().zip(&without).map(|(a, b)| a - b).collect::<Vec<f64>>();
        let y = measured[c].iter().zip(&without).map(|(m, b)| m - b).collect::<Vec<f64>>();
        let filtered = |values: &[f64]| centred(zero_phase(values, run.time_step_s, model.cutoff_hz));
        Channel { x: filtered(&x), y: filtered(&y) }
    };
    let channels = [channel(0), channel(1), channel(2)];
    if channels.iter().all(|channel| dot(&channel.x, &channel.x) == 0.0) {
        return refuse("the control surface does nothing in the model");
    }
    let weights =
        sigma.map_or_else(|| residual_weights(&channels), |sigma| sigma.map(|s| 1.0 / (s * s)).to_array());
    let (factor, information) = scale(&channels, weights);
    let filter = |values: &[f64]| zero_phase(values, run.time_step_s, model.cutoff_hz);
    let noise_error = sigma.map(ByLoad::to_array).map(|sigma| {
        let part = |c: usize| {
            let through = centred(filter(&channels[c].x));
            (weights[c] * sigma[c]).powi(2) * dot(&through, &through)
        };
        (0..3).map(part).sum::<f64>().sqrt() / information
    });
    let residual_error = bartlett(&channels, weights, factor, LAG_S / run.time_step_s).sqrt() / information;
    let gap_at = |factor: f64| {
        let squares = (0..3).map(|c| weights[c] * channels[c].squares(factor)).sum::<f64>();
        (squares / (3 * run.len()) as f64).sqrt()
    };
    Ok(DoubletFit {
        doublet,
        v_m_s: run.v_m_s,
        factor,
        standard_error: noise_error.unwrap_or(0.0).max(residual_error),
        noise_error,
        gap: sigma.map(|_| [gap_at(1.0), gap_at(factor)]),
        information,
    })
}

/// Response of the model to the commanded doublet, and what was measured: filtered, without their means.
struct Channel {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Channel {
    fn squares(&self, factor: f64) -> f64 {
        self.x.iter().zip(&self.y).map(|(x, y)| (y - factor * x).powi(2)).sum()
    }
}

fn centred(mut values: Vec<f64>) -> Vec<f64> {
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    for value in &mut values {
        *value -= mean;
    }
    values
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// K and `sum w xᵀx`.
fn scale(channels: &[Channel; 3], weights: [f64; 3]) -> (f64, f64) {
    let sum = |of: &dyn Fn(&Channel) -> f64| (0..3).map(|c| weights[c] * of(&channels[c])).sum::<f64>();
    let information = sum(&|channel| dot(&channel.x, &channel.x));
    (sum(&|channel| dot(&channel.x, &channel.y)) / information, information)
}

/// One over the variance of the residuals that a first fit leaves.
fn residual_weights(channels: &[Channel; 3]) -> [f64; 3] {
    let count = channels[0].y.len().max(1) as f64;
    let inverse = |variance: f64| if variance > 0.0 { 1.0 / variance } else { 1.0 };
    let first: [f64; 3] = std::array::from_fn(|c| inverse(dot(&channels[c].y, &channels[c].y) / count));
    let (factor, _) = scale(channels, first);
    std::array::from_fn(|c| inverse(channels[c].squares(factor) / count))
}

/// Variance of the sum of the scores if they are correlated up to some lag (Newey and West 1987).
fn bartlett(channels: &[Channel; 3], weights: [f64; 3], factor: f64, lag: f64) -> f64 {
    let count = channels[0].x.len();
    let score = |i: usize| {
        (0..3)
            .map(|c| weights[c] * channels[c].x[i] * (channels[c].y[i] - factor * channels[c].x[i]))
            .sum::<f64>()
    };
    let scores: Vec<f64> = (0..count).map(score).collect();
    let mut variance = dot(&scores, &scores);
    for distance in (1..count).take_while(|&distance| (distance as f64) < lag) {
        let share = 1.0 - distance as f64 / lag;
        variance += 2.0 * share * dot(&scores[distance..], &scores[..count - distance]);
    }
    variance.max(0.0)
}

/// Repeats pooled by their information, ordered by control surface (as they first come), airspeed and deflection.
pub fn pooled(fits: &[DoubletFit]) -> Vec<FittedFactor> {
    let same = |a: f64, b: f64| (a - b).abs() <= SAME_DEFLECTION * a.abs().max(b.abs());
    let mut groups: Vec<Vec<&DoubletFit>> = Vec::new();
    for fit in fits {
        let belongs = |group: &&mut Vec<&DoubletFit>| {
            let first = group[0];
            first.doublet.control == fit.doublet.control
                && same_airspeed(first.v_m_s, fit.v_m_s)
                && same(first.doublet.commanded_rad, fit.doublet.commanded_rad)
        };
        match groups.iter_mut().find(belongs) {
            Some(group) => group.push(fit),
            None => groups.push(vec![fit]),
        }
    }
    let mut all: Vec<FittedFactor> = groups.iter().map(|group| pool(group)).collect();
    let place = |control: &str| fits.iter().position(|fit| fit.doublet.control == control);
    all.sort_by(|a, b| {
        (place(&a.control).cmp(&place(&b.control)))
            .then(a.v_m_s.total_cmp(&b.v_m_s))
            .then(a.commanded_rad.total_cmp(&b.commanded_rad))
    });
    all
}

fn pool(group: &[&DoubletFit]) -> FittedFactor {
    let count = group.len() as f64;
    let information: f64 = group.iter().map(|fit| fit.information).sum();
    let weighted = |of: &dyn Fn(&DoubletFit) -> f64| group.iter().map(|fit| of(fit)).sum::<f64>();
    let factor = weighted(&|fit| fit.information * fit.factor) / information;
    let variance = weighted(&|fit| (fit.information * fit.standard_error).powi(2)) / information.powi(2);
    // Repeats that scatter more than their errors say: the larger is believed.
    let scatter = weighted(&|fit| (fit.information * (fit.factor - factor)).powi(2)) / information.powi(2);
    let scatter = if group.len() > 1 { scatter * count / (count - 1.0) } else { 0.0 };
    FittedFactor {
        control: group[0].doublet.control.clone(),
        v_m_s: weighted(&|fit| fit.v_m_s) / count,
        commanded_rad: weighted(&|fit| fit.doublet.commanded_rad) / count,
        factor,
        standard_error: variance.max(scatter).sqrt(),
        runs: group.len(),
    }
}

/// Tables for a wing's file: odd, airspeeds outside refused, equivalents with five decimals of a degree.
///
/// # Errors
/// A factor below zero or above five: not what a deflection correction can be.
pub fn tables(factors: &[FittedFactor]) -> Result<Vec<DeflectionTable>, InputError> {
    let mut all: Vec<DeflectionTable> = Vec::new();
    for fitted in factors {
        if !(0.0..=5.0).contains(&fitted.factor) {
            let message = format!(
                "the doublets of {} at {:.1} m/s and {:.1} degrees give K = {:.3} +- {:.3}",
                fitted.control,
                fitted.v_m_s,
                fitted.commanded_rad.to_degrees(),
                fitted.factor,
                fitted.standard_error
            );
            return Err(InputError::general(message).with_help(
                "look at these runs: a sign or a column may be wrong, or the deflection too small to see",
            ));
        }
        let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
        let commanded_deg = rounded(fitted.commanded_rad.to_degrees(), 1e5);
        let equivalent_deg = rounded(fitted.factor * fitted.commanded_rad.to_degrees(), 1e5);
        let v_m_s = rounded(fitted.v_m_s, 1e3);
        if all.last().is_none_or(|table| table.control != fitted.control) {
            all.push(DeflectionTable {
                control: fitted.control.clone(),
                odd: true,
                outside: OutsideAirspeeds::Refuse,
                rows: Vec::new(),
            });
        }
        let Some(table) = all.last_mut() else { continue };
        if table.rows.last().is_none_or(|row| !same_airspeed(row.v_m_s, v_m_s)) {
            let row = DeflectionRow {
                v_m_s,
                commanded_deg: Vec::new(),
                equivalent_deg: Some(Vec::new()),
                factor: None,
            };
            table.rows.push(row);
        }
        if let Some(row) = table.rows.last_mut() {
            row.commanded_deg.push(commanded_deg);
            row.equivalent_deg.get_or_insert_default().push(equivalent_deg);
        }
    }
    Ok(all)
}

/// Root mean square of measured minus simulated changes of Fz, Mx, My (filtered, without their means: what a deflection
/// correction can be blamed for); none if the run has no loads.
pub fn change_rms(run: &Run, simulated: &TimeHistory, cutoff_hz: f64) -> Option<ByLoad<f64>> {
    let measured = run.loads.as_ref()?;
    let rms = |load: Load| {
        let of_model = simulated.get(load.column()).unwrap_or(&[]);
        let off: Vec<f64> = measured[load as usize].iter().zip(of_model).map(|(m, s)| m - s).collect();
        let off = centred(zero_phase(&off, run.time_step_s, cutoff_hz));
        (dot(&off, &off) / off.len().max(1) as f64).sqrt()
    };
    Some(ByLoad::from_fn(rms))
}

/// Root mean square residual over sigma, all channels of all runs; runs count by their samples.
pub fn gap(runs: &[(usize, ByLoad<f64>)], sigma: ByLoad<f64>) -> f64 {
    let samples: usize = runs.iter().map(|(samples, _)| samples).sum();
    let squares: f64 = runs
        .iter()
        .map(|(samples, rms)| {
            *samples as f64 * Load::ALL.iter().map(|&load| (rms[load] / sigma[load]).powi(2)).sum::<f64>()
        })
        .sum();
    (squares / (3 * samples.max(1)) as f64).sqrt()
}

/// The gap that white noise alone leaves behind the zero-phase filter.
pub fn noise_gap(time_step_s: f64, cutoff_hz: f64) -> f64 {
    let mut impulse = vec![0.0; 801];
    impulse[400] = 1.0;
    let answer = zero_phase(&impulse, time_step_s, cutoff_hz);
    dot(&answer, &answer).sqrt()
}

#[cfg(test)]
mod tests;
