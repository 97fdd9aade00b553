//! Runs that are late or early against runs like them, by cross-correlation with the simulation.

use super::defect::{Defect, DefectKind};
use super::record::Record;
use crate::rules::TimingRules;
use crate::statistics::{dot, median};
use coupling::Load;
use rayon::prelude::*;

/// See the module.
pub(super) fn lags(rules: &TimingRules, records: &[Record]) -> Vec<Defect> {
    let all: Vec<Option<f64>> = records.par_iter().map(|record| lag_s(rules, record)).collect();
    let peers = |i: usize, like: &dyn Fn(&Record) -> bool| -> Vec<f64> {
        (0..records.len()).filter(|&j| j != i && like(&records[j])).filter_map(|j| all[j]).collect()
    };
    let mut found = Vec::new();
    for (i, record) in records.iter().enumerate() {
        let Some(lag) = all[i] else { continue };
        let mut others = peers(i, &|other| other.maneuver == record.maneuver);
        if others.len() < rules.peers {
            others = peers(i, &|other| other.maneuver.same_kind(&record.maneuver));
        }
        if others.len() < rules.peers {
            continue;
        }
        let Some(usual) = median(others.clone()) else { continue };
        let spread = median(others.iter().map(|other| (other - usual).abs()).collect()).unwrap_or(0.0);
        let late = lag - usual;
        // what every repeat of a maneuver does is the wing's doing (a servo that cannot turn faster), not a record's
        let repeated =
            repeats(records, i).any(|j| all[j].is_some_and(|other| (other - lag).abs() < rules.agree_s));
        if !repeated && late.abs() > least_s(rules, record).max(rules.spreads * spread) {
            let (name, word) = (&record.name, if late > 0.0 { "late" } else { "early" });
            found.push(Defect {
                kind: DefectKind::Lag,
                run: Some(name.clone()),
                channel: None,
                sentence: format!("{name} is {:.0} ms {word} against runs like it", 1e3 * late.abs()),
            });
        }
    }
    found
}

/// Other records of the same condition.
fn repeats(records: &[Record], i: usize) -> impl Iterator<Item = usize> + '_ {
    let first = |j: usize| records[j].repeat_of.unwrap_or(j);
    (0..records.len()).filter(move |&j| j != i && first(j) == first(i))
}

fn least_s(rules: &TimingRules, record: &Record) -> f64 {
    let frequency_hz = record.maneuver.kind().and_then(|kind| kind.frequency_hz);
    frequency_hz.map_or(rules.least_s, |hz| rules.least_s.max(rules.least_turns / hz))
}

/// Lag of the measurement on which the channels agree, s.
fn lag_s(rules: &TimingRules, record: &Record) -> Option<f64> {
    if record.steady {
        return None;
    }
    let lags: Vec<f64> = Load::ALL
        .into_iter()
        .filter_map(|c| {
            let pair = record.about_mean(c)?;
            pair.gain(record.sigma[c])?;
            best_lag_s(rules, &pair.measured, &pair.simulated, record.time_step_s)
        })
        .collect();
    let usual = median(lags.clone())?;
    (lags.len() > 1 && lags.iter().all(|lag| (lag - usual).abs() < rules.agree_s)).then_some(usual)
}

/// The shift at which two records look most alike, between samples by a parabola.
pub(super) fn best_lag_s(rules: &TimingRules, late: &[f64], early: &[f64], time_step_s: f64) -> Option<f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let longest = (rules.longest_s / time_step_s).round() as usize;
    let n = late.len().min(early.len());
    if n < 4 * longest {
        return None;
    }
    // ends are compared only where both are inside
    let inner = &early[longest..n - longest];
    let at = |shift: usize| {
        let shifted = &late[shift..shift + inner.len()];
        dot(shifted, inner) / (dot(shifted, shifted) * dot(inner, inner)).sqrt()
    };
    let values: Vec<f64> = (0..=2 * longest).map(at).collect();
    let best = (1..2 * longest).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    let [before, here, after] = [values[best - 1], values[best], values[best + 1]];
    let bend = before - 2.0 * here + after;
    if here < rules.alike || bend >= 0.0 {
        return None;
    }
    let between = 0.5 * (before - after) / bend;
    Some((best as f64 - longest as f64 + between.clamp(-0.5, 0.5)) * time_step_s)
}
