//! Answers in time: the inverse transform over the frequencies of a deck.

use super::{DynamicAnswer, GustCase, GustDeck, GustLoads};
use faer::{Mat, c64};
use std::f64::consts::{PI, TAU};

/// Answers of a subcase in time.
#[derive(Debug, Clone)]
pub struct TimeAnswer {
    /// Times, s.
    pub times_s: Vec<f64>,
    /// The function that excites, as the deck gives it.
    pub excitation: Vec<f64>,
    /// Amplitudes of the modes, times by modes.
    modal: Mat<f64>,
    /// Their accelerations.
    accelerations: Mat<f64>,
    /// The stations' answers.
    pub stations: Vec<MonitorAnswer>,
    /// What the user should know.
    pub remarks: Vec<String>,
}

/// Loads of a station, a list over time.
#[derive(Debug, Clone)]
pub struct MonitorAnswer {
    /// Its name.
    pub name: String,
    /// Three forces and three moments at each time.
    pub loads: Vec<GustLoads<f64>>,
}

/// Share of the root mean square of an excitation beyond the frequencies that is said.
const SAID: f64 = 0.02;
/// Samples of the excitation for that share.
const SAMPLES: u32 = 20_000;

impl GustDeck {
    /// The answer of a subcase in time; none if it asks for none.
    pub fn in_time(&self, case: &GustCase, answer: &DynamicAnswer) -> Option<TimeAnswer> {
        let times_s = case.times_s.clone()?;
        let signal = if case.gust.is_some() { &case.gust_signal } else { &case.load_signal };
        let waves = Waves::new(&answer.hz, &times_s);
        let n = self.modal.omega_rad_s.len();
        let of_modes = |factor: &dyn Fn(f64) -> f64| {
            let columns: Vec<Vec<f64>> = (0..n)
                .map(|mode| {
                    let lines = answer.modal.iter().zip(&answer.hz);
                    waves.summed(&lines.map(|(x, hz)| x[mode] * factor(TAU * hz)).collect::<Vec<c64>>())
                })
                .collect();
            Mat::from_fn(times_s.len(), n, |i, mode| columns[mode][i])
        };
        let stations = self.stations.iter().enumerate().map(|(at, station)| {
            let row = |part: &dyn Fn(&GustLoads<c64>) -> c64| {
                waves.summed(&answer.stations.iter().map(|all| part(&all[at])).collect::<Vec<c64>>())
            };
            let rows = |of: &dyn Fn(&GustLoads<c64>) -> [c64; 6]| -> Vec<Vec<f64>> {
                (0..6).map(|component| row(&|loads| of(loads)[component])).collect()
            };
            let (inertial, flexible, gust) =
                (rows(&|l| l.inertial), rows(&|l| l.flexible), rows(&|l| l.gust));
            let at = |rows: &[Vec<f64>], i: usize| std::array::from_fn(|component| rows[component][i]);
            let loads = (0..times_s.len()).map(|i| GustLoads {
                inertial: at(&inertial, i),
                flexible: at(&flexible, i),
                gust: at(&gust, i),
            });
            MonitorAnswer { name: station.name.clone(), loads: loads.collect() }
        });
        let stations = stations.collect();
        let value = |t: f64| signal.at(&self.modal.bulk, t);
        Some(TimeAnswer {
            excitation: times_s.iter().map(|t| value(*t)).collect(),
            modal: of_modes(&|_| 1.0),
            accelerations: of_modes(&|omega| -omega * omega),
            stations,
            remarks: remarks(&answer.hz, &answer.excitation, &times_s, &value),
            times_s,
        })
    }
}

impl TimeAnswer {
    /// Displacements and accelerations of a grid at each time, by its shapes ([`GustDeck::shapes_at`]).
    pub fn of_grid(&self, shapes: &Mat<f64>) -> Vec<[[f64; 6]; 2]> {
        let of = |modal: &Mat<f64>, i: usize| -> [f64; 6] {
            std::array::from_fn(|row| (0..modal.ncols()).map(|j| shapes[(row, j)] * modal[(i, j)]).sum())
        };
        (0..self.times_s.len()).map(|i| [of(&self.modal, i), of(&self.accelerations, i)]).collect()
    }
}

/// Waves of the frequencies at the times.
struct Waves {
    /// exp(i omega t) C/pi, times by frequencies.
    factors: Mat<c64>,
}

impl Waves {
    fn new(hz: &[f64], times_s: &[f64]) -> Self {
        let shares = shares(hz);
        let factors = Mat::from_fn(times_s.len(), hz.len(), |i, n| {
            let angle = TAU * hz[n] * times_s[i];
            c64::new(angle.cos(), angle.sin()) * (shares[n] * TAU / PI)
        });
        Self { factors }
    }

    /// The real sum over the frequencies, at each time.
    fn summed(&self, amplitudes: &[c64]) -> Vec<f64> {
        let at = |i: usize| amplitudes.iter().enumerate().map(|(n, y)| (self.factors[(i, n)] * y).re).sum();
        (0..self.factors.nrows()).map(at).collect()
    }
}

/// What each frequency stands for, Hz: half the way to its neighbours, at the ends as far outwards as inwards, but not below zero.
pub(super) fn shares(hz: &[f64]) -> Vec<f64> {
    let last = hz.len() - 1;
    if last == 0 {
        return vec![hz[0]];
    }
    let half = |i: usize| 0.5 * (hz[i + 1] - hz[i]);
    let share = |i: usize| match i {
        0 => half(0) + half(0).min(hz[0]),
        i if i == last => 2.0 * half(last - 1),
        i => half(i - 1) + half(i),
    };
    (0..=last).map(share).collect()
}

/// What frequencies and times leave out of a function.
fn remarks(hz: &[f64], transform: &[c64], times_s: &[f64], value: &dyn Fn(f64) -> f64) -> Vec<String> {
    let mut remarks = Vec::new();
    if hz.len() < 2 {
        return vec!["one frequency makes no answer in time: list more".to_owned()];
    }
    let widest = hz.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let end = times_s.last().copied().unwrap_or(0.0);
    let period = 1.0 / widest;
    if period < end {
        remarks.push(format!(
            "frequencies {widest} Hz apart repeat their answer every {period} s, before the last time {end} s: set them closer"
        ));
    }
    // What of the function the frequencies have, by Parseval's theorem, over one period.
    let step = period / f64::from(SAMPLES);
    let samples: Vec<f64> = (0..SAMPLES).map(|i| value(step * (f64::from(i) + 0.5))).collect();
    let mean = samples.iter().sum::<f64>() / f64::from(SAMPLES);
    let has_rest = hz[0] == 0.0;
    let square = |value: f64| if has_rest { value * value } else { (value - mean).powi(2) };
    let all: f64 = samples.iter().map(|value| square(*value) * step).sum();
    let shares = shares(hz);
    let kept: f64 = transform.iter().zip(&shares).map(|(f, share)| 2.0 * share * f.norm_sqr()).sum();
    let left_out = ((all - kept).max(0.0) / all.max(f64::MIN_POSITIVE)).sqrt();
    if left_out > SAID {
        remarks.push(format!(
            "{:.0} % of the excitation's root mean square lies beyond {} Hz and is left out",
            100.0 * left_out,
            hz[hz.len() - 1]
        ));
    }
    if !has_rest {
        let share = if all > 0.0 { mean.abs() / (all / period).sqrt() } else { 0.0 };
        remarks.push(format!(
            "there is no frequency of zero: answers have no mean over their period of {period:.4} s{}",
            if share > SAID {
                ", but the excitation has one: begin FREQ at zero, or let an opposite gust follow"
            } else {
                ""
            }
        ));
    }
    remarks
}

#[cfg(test)]
mod tests;
