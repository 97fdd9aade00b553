//! Channels whose labels are exchanged or whose sign is flipped: in all data, in all runs, or in one run and not in others.
//!
//! Everywhere: the channels are compared in shape alone, each with one free positive gain, so that no gain, slope or
//! dynamic pressure that is wrong in all runs looks like an exchange. In one run: against the simulation times the gain
//! that the other runs have.

use super::defect::{Defect, DefectKind};
use super::record::{Pair, Record};
use crate::rules::LabelRules;
use crate::statistics::{dot, median};
use coupling::Load::{Fz, Mx, My};
use coupling::{ByLoad, Load};

/// Which channel's measurement stands in the place of Fz, Mx, My.
const ORDERS: [ByLoad<Load>; 5] = {
    const fn order(fz: Load, mx: Load, my: Load) -> ByLoad<Load> {
        ByLoad { fz, mx, my }
    }
    [order(Mx, Fz, My), order(My, Mx, Fz), order(Fz, My, Mx), order(Mx, My, Fz), order(My, Fz, Mx)]
};
/// As the labels say.
const AS_LABELLED: ByLoad<Load> = ByLoad { fz: Fz, mx: Mx, my: My };

/// Exchanged or flipped in all data, or in all runs and not in the static points.
pub(super) fn everywhere(rules: &LabelRules, records: &[Record]) -> Vec<Defect> {
    let windy = |steady: bool| -> Vec<&Record> {
        records.iter().filter(|record| record.v_m_s > 0.0 && record.steady == steady).collect()
    };
    let (points, mut judged) = (windy(true), windy(false));
    let runs = !judged.is_empty();
    if !runs {
        judged.clone_from(&points);
    }
    let flipped = ByLoad::from_fn(|c| flipped_in(rules, &judged, c));
    let as_flipped = shapes_left(&judged, AS_LABELLED, flipped);
    let own = shapes_left(&judged, AS_LABELLED, NOT_FLIPPED);
    let best = ORDERS.map(|order| (shapes_left(&judged, order, NOT_FLIPPED), order));
    let best = best.iter().min_by(|a, b| a.0.total_cmp(&b.0)).copied().unwrap_or((own, AS_LABELLED));
    // two channels that stand in each other's place may go against their simulations, both of them: what leaves less is it
    let two_flipped = Load::ALL.into_iter().filter(|&c| flipped[c]).count() == 2;
    if own > rules.wrong && (best.0 < rules.explains_all * own || two_flipped && best.0 < as_flipped) {
        let of_points = |order| shapes_left(&points, order, NOT_FLIPPED);
        let in_points = of_points(best.1) * rules.explains_all <= of_points(AS_LABELLED);
        return vec![exchanged(None, best.1, all_of(runs, in_points))];
    }
    let sign = |c: Load| sign_everywhere(c, all_of(runs, flipped_in(rules, &points, c)));
    Load::ALL.into_iter().filter(|&c| flipped[c]).map(sign).collect()
}

/// Nothing flipped.
const NOT_FLIPPED: ByLoad<bool> = ByLoad { fz: false, mx: false, my: false };

/// Where a fault is, in words.
fn all_of(runs: bool, points: bool) -> &'static str {
    if runs && !points { "all runs and not in the static points" } else { "all data" }
}

fn sign_everywhere(c: Load, place: &str) -> Defect {
    let channel = c.column();
    Defect {
        kind: DefectKind::SignFlipped,
        run: None,
        channel: Some(channel.into()),
        sentence: format!("{channel} has the opposite sign in {place}: it is minus what the wing does"),
    }
}

/// Whether the loads go against the simulation in three quarters of the records, at rest and in motion.
fn flipped_in(rules: &LabelRules, records: &[&Record], c: Load) -> bool {
    let of = |pair: Option<Pair>, record: &Record| pair.and_then(|pair| correlation(&pair, record.sigma[c]));
    let whole: Vec<f64> = records.iter().filter_map(|r| of(r.channels[c].clone(), r)).collect();
    let moving: Vec<f64> = records.iter().filter_map(|r| of(r.about_mean(c), r)).collect();
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

/// Share of the motion's loads that channels in an order leave, each with one gain for all records, positive unless it is
/// flipped.
fn shapes_left(records: &[&Record], order: ByLoad<Load>, flipped: ByLoad<bool>) -> f64 {
    let mut left = 0.0;
    for c in Load::ALL {
        let (mut mm, mut ms, mut ss) = (0.0, 0.0, 0.0);
        for record in records {
            let (Some(own), Some(other)) = (record.about_mean(c), record.about_mean(order[c])) else {
                continue;
            };
            let power = dot(&own.simulated, &own.simulated);
            if own.gain(record.sigma[c]).is_none() {
                continue;
            }
            mm += dot(&other.measured, &other.measured) / power;
            ms += dot(&other.measured, &own.simulated) / power;
            ss += 1.0;
        }
        if ss > 0.0 && mm > 0.0 {
            let as_said = if flipped[c] { ms < 0.0 } else { ms > 0.0 };
            left += if as_said { 1.0 - ms * ms / (ss * mm) } else { 1.0 };
        }
    }
    left
}

/// Exchanged or flipped in single runs or static groups.
pub(super) fn by_run(rules: &LabelRules, records: &[Record]) -> Vec<Defect> {
    let mut all = Vec::new();
    for record in records {
        let gains: ByLoad<Option<f64>> = ByLoad::from_fn(|c| peers_gain(records, record, c));
        if let Some(order) = exchanged_in(rules, record, gains) {
            all.push(exchanged(Some(&record.name), order, &record.name));
            continue;
        }
        for c in Load::ALL {
            let (Some(pair), Some(gain)) = (record.signal(c), gains[c]) else { continue };
            let left = |sign: f64| misfit(&pair.measured, &pair.simulated, sign * gain);
            if pair.gain(record.sigma[c]).is_some() && left(-1.0) < rules.explains * left(1.0) {
                let (channel, name) = (c.column(), &record.name);
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
fn peers_gain(records: &[Record], record: &Record, c: Load) -> Option<f64> {
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

fn exchanged_in(rules: &LabelRules, record: &Record, gains: ByLoad<Option<f64>>) -> Option<ByLoad<Load>> {
    let signals: ByLoad<Option<Pair>> = ByLoad::from_fn(|c| record.signal(c));
    let left = |order: ByLoad<Load>| -> Option<f64> {
        let mut sum = 0.0;
        for c in Load::ALL {
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
    let own = left(AS_LABELLED)?;
    let each = ORDERS.iter().filter_map(|order| left(*order).map(|left| (left, *order)));
    let (least, order) = each.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (least < rules.explains * own && own > rules.wrong).then_some(order)
}

fn exchanged(run: Option<&str>, order: ByLoad<Load>, place: &str) -> Defect {
    let moved: Vec<String> = Load::ALL
        .into_iter()
        .filter(|&c| order[c] != c)
        .map(|c| format!("what is called {} is {}", order[c].column(), c.column()))
        .collect();
    Defect {
        kind: DefectKind::SwappedChannels,
        run: run.map(str::to_owned),
        channel: Load::ALL.into_iter().find(|&c| order[c] != c).map(|c| c.column().into()),
        sentence: format!("labels of channels are exchanged in {place}: {}", moved.join(", ")),
    }
}
