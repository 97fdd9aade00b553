//! Channels that stand still or end at a value while the load moves, and single samples far off.
//!
//! Samples that are equal to a small part of the noise show that the channel did not measure: noise never rests.

use super::defect::{Defect, DefectKind};
use super::record::{Pair, Record};
use crate::rules::SampleRules;
use crate::statistics::median;
use coupling::Load;

/// Stuck and clipped channels.
pub(super) fn flat(rules: &SampleRules, records: &[Record]) -> Vec<Defect> {
    let mut found = Vec::new();
    for record in records.iter().filter(|record| !record.steady) {
        for c in Load::ALL {
            let Some(pair) = &record.channels[c] else { continue };
            if let Some((kind, what)) = flat_in(rules, pair, record.sigma[c]) {
                let (channel, name) = (c.column(), &record.name);
                let sentence = format!("{channel} of {name} {what}");
                found.push(Defect { kind, run: Some(name.clone()), channel: Some(channel.into()), sentence });
            }
        }
    }
    found
}

fn range(values: &[f64]) -> (f64, f64) {
    values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
}

fn flat_in(rules: &SampleRules, pair: &Pair, sigma: f64) -> Option<(DefectKind, String)> {
    let (low, high) = range(&pair.measured);
    let stretches: Vec<(usize, usize)> = stretches(&pair.measured, rules.flat * sigma)
        .into_iter()
        .filter(|(from, to)| to - from >= rules.shortest_flat)
        .collect();
    let moves = |inside: &[&(usize, usize)]| {
        let all: Vec<f64> =
            inside.iter().flat_map(|(from, to)| pair.simulated[*from..*to].iter().copied()).collect();
        let (least, most) = range(&all);
        most - least > rules.moves * sigma
    };
    let longest = stretches.iter().filter(|stretch| moves(&[stretch])).max_by_key(|(from, to)| to - from);
    if let Some((from, to)) = longest
        && (to - from) as f64 > rules.stuck * pair.measured.len() as f64
    {
        return Some((
            DefectKind::Stuck,
            format!("is stuck at {:.4} while the load moves", pair.measured[*from]),
        ));
    }
    for (value, word) in [(low, "smallest"), (high, "largest")] {
        // a filter after clipping swings past the end by a little
        let near = |&&(from, to): &&(usize, usize)| {
            (pair.measured[from..to].iter().sum::<f64>() / (to - from) as f64 - value).abs()
                < rules.near_end * (high - low)
        };
        let there: Vec<&(usize, usize)> = stretches.iter().filter(near).collect();
        let samples: usize = there.iter().map(|(from, to)| to - from).sum();
        if samples >= rules.clipped && moves(&there) {
            let what = format!("is clipped: {samples} samples stand at its {word} value {value:.3}");
            return Some((DefectKind::Clipped, what));
        }
    }
    None
}

/// Longest stretches from left to right that span less than a width.
fn stretches(values: &[f64], width: f64) -> Vec<(usize, usize)> {
    let (mut all, mut from) = (Vec::new(), 0);
    while from < values.len() {
        let (mut low, mut high, mut to) = (values[from], values[from], from + 1);
        while to < values.len() {
            (low, high) = (low.min(values[to]), high.max(values[to]));
            if high - low > width {
                break;
            }
            to += 1;
        }
        all.push((from, to));
        from = to;
    }
    all
}

/// The most that a sample stands out of its neighbours: height in the channel's unit, and where.
struct Spike {
    height: f64,
    usual: f64,
    at: usize,
    narrow: bool,
}

/// Single samples far off.
pub(super) fn spikes(rules: &SampleRules, records: &[Record]) -> Vec<Defect> {
    let mut found = Vec::new();
    for c in Load::ALL {
        let channel = c.column();
        let all: Vec<Option<Spike>> = records.iter().map(|record| spike(rules, record, c)).collect();
        let like = |i: usize| {
            (0..records.len()).filter(move |&j| records[j].maneuver.same_kind(&records[i].maneuver))
        };
        let far: Vec<bool> = (0..records.len())
            .map(|i| {
                let peers =
                    like(i).filter(|&j| j != i).filter_map(|j| all[j].as_ref().map(|spike| spike.height));
                let usual = median(peers.collect()).unwrap_or(0.0);
                all[i].as_ref().is_some_and(|spike| {
                    let usual = usual.max(spike.usual);
                    spike.narrow
                        && spike.height > rules.spike * records[i].sigma[c]
                        && spike.height > rules.spike_over_others * usual
                })
            })
            .collect();
        for (i, record) in records.iter().enumerate().filter(|(i, _)| far[*i]) {
            let Some(spike) = &all[i] else { continue };
            let again = |other: &Spike, dt: f64| {
                (other.at as f64 * dt - spike.at as f64 * record.time_step_s).abs() < rules.same_instant_s
                    && other.height > rules.common * spike.height
            };
            let shown = |j: usize| all[j].as_ref().is_some_and(|other| again(other, records[j].time_step_s));
            if like(i).any(|j| j != i && shown(j)) {
                continue;
            }
            let name = &record.name;
            let sentence = format!(
                "{channel} of {name} has samples far off at {:.2} s: by {:.0} times the noise",
                spike.at as f64 * record.time_step_s,
                spike.height / record.sigma[c]
            );
            let run = Some(name.clone());
            found.push(Defect { kind: DefectKind::Spikes, run, channel: Some(channel.into()), sentence });
        }
    }
    found
}

fn spike(rules: &SampleRules, record: &Record, c: Load) -> Option<Spike> {
    let pair = record.channels[c]
        .as_ref()
        .filter(|pair| !record.steady && pair.measured.len() > 30 * rules.narrow)?;
    // a control that does half of what the model thinks leaves edges; the run's own gain takes them off
    let gain = record.about_mean(c)?.gain(record.sigma[c]).unwrap_or(1.0);
    let residual: Vec<f64> = pair.measured.iter().zip(&pair.simulated).map(|(m, s)| m - gain * s).collect();
    let n = residual.len();
    // where a control jumps, models and loads are rough
    let out = |i: usize| {
        let out = (residual[i] - 0.5 * (residual[i - rules.narrow] + residual[i + rules.narrow])).abs();
        if record.edges[i] { 0.0 } else { out }
    };
    let outs: Vec<f64> = (rules.narrow..n - rules.narrow).map(out).collect();
    let k = (0..outs.len()).max_by(|&a, &b| outs[a].total_cmp(&outs[b]))?;
    let mut sorted = outs.clone();
    sorted.sort_by(f64::total_cmp);
    let narrow = (0..outs.len())
        .filter(|&j| (2 * rules.narrow..=4 * rules.narrow).contains(&j.abs_diff(k)))
        .all(|j| outs[j] < rules.beside_narrow * outs[k]);
    let usual = sorted[sorted.len() * rules.usual_percent / 100];
    Some(Spike { height: outs[k], usual, at: k + rules.narrow, narrow })
}
