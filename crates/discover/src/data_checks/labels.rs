//! Channels whose labels are exchanged or whose sign is flipped: in all data, or in one run and not in others.
//!
//! Everywhere: the channels are compared in shape alone, each with one free positive gain, so that no gain, slope or
//! dynamic pressure that is wrong in all runs looks like an exchange. In one run: against the simulation times the gain
//! that the other runs have.

use super::defect::{Defect, DefectKind};
use super::record::{Pair, Record};
use crate::channels::LOADS;
use crate::rules::LabelRules;
use crate::statistics::{dot, median};

/// Which channel's measurement stands in the place of Fz, Mx, My.
const ORDERS: [[usize; 3]; 5] = [[1, 0, 2], [2, 1, 0], [0, 2, 1], [1, 2, 0], [2, 0, 1]];

/// Exchanged or flipped in all data.
pub(super) fn everywhere(rules: &LabelRules, records: &[Record]) -> Vec<Defect> {
    let flipped: Vec<Defect> =
        (0..3).filter(|&c| flipped_everywhere(rules, records, c)).map(sign_everywhere).collect();
    if !flipped.is_empty() && !exchange_explains(rules, records) {
        return flipped;
    }
    let own = shapes_left(records, [0, 1, 2]);
    let best = ORDERS.map(|order| (shapes_left(records, order), order));
    let best = best.iter().min_by(|a, b| a.0.total_cmp(&b.0)).copied().unwrap_or((own, [0, 1, 2]));
    if best.0 < rules.explains_all * own && own > rules.wrong {
        vec![exchanged(None, best.1)]
    } else {
        Vec::new()
    }
}

fn exchange_explains(rules: &LabelRules, records: &[Record]) -> bool {
    let own = shapes_left(records, [0, 1, 2]);
    ORDERS.iter().any(|order| shapes_left(records, *order) < rules.explains_all * own)
}

fn sign_everywhere(c: usize) -> Defect {
    let channel = LOADS[c];
    Defect {
        kind: DefectKind::SignFlipped,
        run: None,
        channel: Some(channel.into()),
        sentence: format!("{channel} has the opposite sign in all data: it is minus what the wing does"),
    }
}

/// Whether the loads go against the simulation in three quarters of all records, at rest and in motion.
fn flipped_everywhere(rules: &LabelRules, records: &[Record], c: usize) -> bool {
    let windy = || records.iter().filter(|record| record.v_m_s > 0.0);
    let of = |pair: Option<Pair>, record: &Record| pair.and_then(|pair| correlation(&pair, record.sigma[c]));
    let whole: Vec<f64> = windy().filter_map(|r| of(r.channels[c].clone(), r)).collect();
    let moving: Vec<f64> = windy().filter_map(|r| of(r.about_mean(c), r)).collect();
    let against = |values: &[f64]| {
        let count = values.iter().filter(|value| **value < -rules.against).count();
        !values.is_empty() && 4 * count >= 3 * values.len()
    };
    against(&whole) && (moving.is_empty() || against(&moving))
}

fn correlation(pair: &Pair, sigma: f64) -> Option<f64> {
    let gain = pair.gain(sigma)?;
    let powers = dot(&pair.simulated, &pair.simulated) / dot(&pair.measured, &pair.measured);
    Some(gain * powers.sqrt())
}

/// Share of the motion's loads that channels in an order leave, each with one positive gain for all records.
fn shapes_left(records: &[Record], order: [usize; 3]) -> f64 {
    let mut left = 0.0;
    for (c, from) in order.into_iter().enumerate() {
        let (mut mm, mut ms, mut ss) = (0.0, 0.0, 0.0);
        for record in records.iter().filter(|record| record.v_m_s > 0.0) {
            let (Some(own), Some(other)) = (record.about_mean(c), record.about_mean(from)) else { continue };
            let power = dot(&own.simulated, &own.simulated);
            if own.gain(record.sigma[c]).is_none() {
                continue;
            }
            mm += dot(&other.measured, &other.measured) / power;
            ms += dot(&other.measured, &own.simulated) / power;
            ss += 1.0;
        }
        if ss > 0.0 && mm > 0.0 {
            left += if ms > 0.0 { 1.0 - ms * ms / (ss * mm) } else { 1.0 };
        }
    }
    left
}

/// Exchanged or flipped in single runs or static groups.
pub(super) fn by_run(rules: &LabelRules, records: &[Record]) -> Vec<Defect> {
    let mut all = Vec::new();
    for record in records {
        let gains: [Option<f64>; 3] = std::array::from_fn(|c| peers_gain(records, record, c));
        if let Some(order) = exchanged_in(rules, record, gains) {
            all.push(exchanged(Some(&record.name), order));
            continue;
        }
        for (c, gain) in gains.into_iter().enumerate() {
            let (Some(pair), Some(gain)) = (record.signal(c), gain) else { continue };
            let left = |sign: f64| misfit(&pair.measured, &pair.simulated, sign * gain);
            if pair.gain(record.sigma[c]).is_some() && left(-1.0) < rules.explains * left(1.0) {
                let (channel, name) = (LOADS[c], &record.name);
                let sentence =
                    format!("{channel} of {name} has the opposite sign of {channel} in runs like it");
                let run = Some(name.clone());
                all.push(Defect {
                    kind: DefectKind::SignFlipped,
                    run,
                    channel: Some(channel.into()),
                    sentence,
                });
            }
        }
    }
    all
}

/// The middle gain of other records of this kind, or of all with wind; none unless it is positive.
fn peers_gain(records: &[Record], record: &Record, c: usize) -> Option<f64> {
    let gains = |like: &dyn Fn(&Record) -> bool| -> Vec<f64> {
        let others = records.iter().filter(|other| other.name != record.name && like(other));
        others.filter_map(|other| other.signal(c)?.gain(other.sigma[c])).collect()
    };
    let mut found = gains(&|other| other.maneuver.same_kind(&record.maneuver));
    if found.len() < 2 && record.v_m_s > 0.0 {
        found = gains(&|other| other.v_m_s > 0.0);
    }
    (found.len() >= 2).then(|| median(found)).flatten().filter(|gain| *gain > 0.0)
}

fn misfit(measured: &[f64], simulated: &[f64], gain: f64) -> f64 {
    measured.iter().zip(simulated).map(|(m, s)| (m - gain * s).powi(2)).sum()
}

fn exchanged_in(rules: &LabelRules, record: &Record, gains: [Option<f64>; 3]) -> Option<[usize; 3]> {
    let signals: [Option<Pair>; 3] = std::array::from_fn(|c| record.signal(c));
    let left = |order: [usize; 3]| -> Option<f64> {
        let mut sum = 0.0;
        for c in 0..3 {
            let own = signals[c].as_ref();
            if own.is_none() && order[c] == c {
                continue;
            }
            let (own, other, gain) = (own?, signals[order[c]].as_ref()?, gains[c]?);
            let floor = own.simulated.len() as f64 * record.sigma[c].powi(2);
            let power = gain * gain * dot(&own.simulated, &own.simulated) + floor;
            sum += misfit(&other.measured, &own.simulated, gain) / power;
        }
        Some(sum)
    };
    let own = left([0, 1, 2])?;
    let each = ORDERS.iter().filter_map(|order| left(*order).map(|left| (left, *order)));
    let (least, order) = each.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (least < rules.explains * own && own > rules.wrong).then_some(order)
}

fn exchanged(run: Option<&str>, order: [usize; 3]) -> Defect {
    let moved: Vec<String> = (0..3)
        .filter(|&c| order[c] != c)
        .map(|c| format!("what is called {} is {}", LOADS[order[c]], LOADS[c]))
        .collect();
    let place = run.map_or_else(|| "all data".to_owned(), str::to_owned);
    Defect {
        kind: DefectKind::SwappedChannels,
        run: run.map(str::to_owned),
        channel: (0..3).find(|&c| order[c] != c).map(|c| LOADS[c].into()),
        sentence: format!("labels of channels are exchanged in {place}: {}", moved.join(", ")),
    }
}
