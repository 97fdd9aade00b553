//! Times of a run: uniform, ascending, in seconds; or the line where they are not.
//!
//! Accepted are steps from 10 microseconds to 0.1 s, each within 5 % of the usual one, and samples no further than a tenth
//! of a step from where a uniform step puts them. Nothing is resampled: filters and derivatives would answer for it.

use nastran::{InputError, Span};
use std::ops::RangeInclusive;

/// Single time steps may differ by this share: files print few digits (300 Hz with four decimals is 3 % off).
const SAME_STEP: f64 = 0.05;
/// No sample may be further than this share of a step from where a uniform step puts it.
const DRIFT: f64 = 0.1;
/// A step of this many usual ones is a gap.
const GAP: f64 = 1.5;
/// Time steps that runs have, s, a little for rounding: coarser ones miss the modes of a wing, finer ones are no balance's.
const STEPS_S: RangeInclusive<f64> = 1e-5..=0.1001;

/// The uniform time step of at least three samples, s.
pub(super) fn time_step(t_s: &[f64], span: impl Fn(usize) -> Span) -> Result<f64, InputError> {
    let count = t_s.len();
    let pair = |row: usize| (t_s[row - 1], t_s[row], t_s[row] - t_s[row - 1]);
    if let Some(row) = (1..count).find(|&row| pair(row).2 <= 0.0) {
        let (before, here, step) = pair(row);
        return Err(if step == 0.0 {
            InputError::at(&span(row), format!("the time {here:?} s stands twice"))
                .with_help("take the repeated sample out, or write the times with more digits")
        } else {
            InputError::at(
                &span(row),
                format!("time must ascend, here it goes from {before:?} to {here:?} s"),
            )
            .with_help("sort the rows by t_s, or split the file where a recording begins anew")
        });
    }
    let usual = usual_step(t_s);
    if !STEPS_S.contains(&usual) {
        let message = format!("samples are {usual} s apart, and runs have 10 to 100000 samples a second");
        return Err(InputError::at(&span(1), message).with_help(if usual > *STEPS_S.end() {
            "is this in milliseconds? t_s is in seconds"
        } else {
            "is this in minutes or hours? t_s is in seconds"
        }));
    }
    let off = |row: usize| (pair(row).2 - usual).abs();
    if let Some(row) = (1..count).find(|&row| off(row) > SAME_STEP * usual) {
        let (before, here, step) = pair(row);
        return Err(if step > GAP * usual {
            let message = format!(
                "there is a gap of {:.0} samples: time goes from {before:?} to {here:?} s in steps of {usual:.6} s",
                step / usual - 1.0
            );
            InputError::at(&span(row), message).with_help("split the run there, or fill the gap")
        } else {
            let message = format!("the time step changes from {usual:.6} s to {step:.6} s");
            InputError::at(&span(row), message).with_help(
                "a run has one time step throughout, to 5 %: resample it, split it where it changes, or write t_s with \
                 more digits",
            )
        });
    }
    let step = (t_s[count - 1] - t_s[0]) / (count - 1) as f64;
    let off = |row: usize| (t_s[row] - t_s[0] - row as f64 * step).abs();
    match (0..count).max_by(|&a, &b| off(a).total_cmp(&off(b))) {
        Some(row) if off(row) > DRIFT * step => {
            let message = format!(
                "the time step changes: this sample is {:.1} steps off a uniform one",
                off(row) / step
            );
            Err(InputError::at(&span(row), message)
                .with_help("a run has one time step throughout: resample it, or split it where it changes"))
        }
        _ => Ok(step),
    }
}

/// The median step: single wrong ones do not move it.
fn usual_step(t_s: &[f64]) -> f64 {
    let mut steps: Vec<f64> = t_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = steps.len() / 2;
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(t_s: &[f64]) -> String {
        let place = |row: usize| Span::new(&std::sync::Arc::new("a.csv".into()), row + 2, 1, 2);
        time_step(t_s, place).map_or_else(|error| error.to_string(), |step| format!("{step:.6}"))
    }

    #[test]
    fn faults_of_a_time_column_are_told_apart() {
        let uniform: Vec<f64> = (0..9).map(|k| 0.005 * f64::from(k)).collect();
        let with = |row: usize, t_s: f64| {
            let mut changed = uniform.clone();
            changed[row] = t_s;
            said(&changed)
        };
        let scaled = |factor: f64| said(&uniform.iter().map(|t| factor * t).collect::<Vec<_>>());
        assert_eq!(said(&uniform), "0.005000");
        assert_eq!(with(4, 0.0201), "0.005000", "2 % of jitter");
        for (said, expected) in [
            (with(4, 0.015), "a.csv:6:1: the time 0.015 s stands twice"),
            (with(4, 0.014), "a.csv:6:1: time must ascend, here it goes from 0.015 to 0.014 s"),
            (with(4, 0.022), "a.csv:6:1: the time step changes from 0.005000 s to 0.007000 s"),
            (with(1, 0.001), "a.csv:3:1: the time step changes from 0.005000 s to 0.001000 s"),
            (with(8, 0.05), "a.csv:10:1: there is a gap of 2 samples: time goes from 0.035 to 0.05 s"),
            (scaled(1e3), "a.csv:3:1: samples are 5 s apart"),
            (scaled(1e3), "milliseconds"),
            (scaled(1e-5), "hours"),
        ] {
            assert!(said.contains(expected), "{said}");
        }
        let drifting: Vec<f64> = (0..99).map(|k| 0.01 * f64::from(k) * (1.0 + 2e-4 * f64::from(k))).collect();
        assert!(said(&drifting).contains("steps off a uniform one"));
    }
}
