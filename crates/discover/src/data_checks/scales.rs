//! Channels that are so many times as large in some runs as in runs like them: another unit, another range of the amplifier.
//!
//! No effect makes one load of a run several times what runs of its kind have of it and leaves its shape: a run is named if its
//! gain is far from the middle of all others with wind and more than half of its own kind do not have it, too.

use super::defect::{Defect, DefectKind};
use super::record::{Pair, Record};
use crate::rules::ScaleRules;
use crate::statistics::{dot, median};
use coupling::{ByLoad, Load};
use rayon::prelude::*;

/// Channels scaled in single runs.
pub(super) fn by_run(rules: &ScaleRules, records: &[Record]) -> Vec<Defect> {
    let runs: Vec<&Record> = records.iter().filter(|record| !record.steady && record.v_m_s > 0.0).collect();
    let gains_of = |record: &&Record| ByLoad::from_fn(|c| gain(rules, record, c));
    let gains: Vec<ByLoad<Option<f64>>> = runs.par_iter().map(gains_of).collect();
    let runs: Vec<Scaled<'_>> = runs.into_iter().zip(gains).collect();
    let mut all = Vec::new();
    for run @ (record, _) in &runs {
        let factors: Vec<(Load, f64)> =
            Load::ALL.into_iter().filter_map(|c| Some((c, factor(rules, &runs, run, c)?))).collect();
        // loads that are all larger alike are an airspeed's or an angle's
        if factors.len() == Load::ALL.len() {
            continue;
        }
        for (c, factor) in factors {
            let (channel, name) = (c.column(), &record.name);
            all.push(Defect {
                kind: DefectKind::Scaled,
                run: Some(name.clone()),
                channel: Some(channel.into()),
                sentence: format!(
                    "{channel} of {name} is {} times what {channel} is in other runs: look at its unit and its amplifier",
                    said(factor)
                ),
            });
        }
    }
    all
}

/// To three digits, without the zeros of a float.
fn said(factor: f64) -> String {
    if factor >= 10.0 { format!("{factor:.0}") } else { format!("{factor:.2}") }
}

/// A run with its gains.
type Scaled<'a> = (&'a Record, ByLoad<Option<f64>>);

/// By what a channel is larger or smaller than in other runs, if it is by much.
fn factor(rules: &ScaleRules, runs: &[Scaled<'_>], (record, own): &Scaled<'_>, c: Load) -> Option<f64> {
    let own = own[c]?;
    let others = |like: &dyn Fn(&Record) -> bool| -> Vec<f64> {
        let others = runs.iter().filter(|(other, _)| other.name != record.name && like(other));
        others.filter_map(|(_, gains)| gains[c]).collect()
    };
    let everywhere = others(&|_| true);
    let kind = others(&|other| other.maneuver.same_kind(&record.maneuver));
    let ratio = own / median(everywhere.clone()).filter(|_| everywhere.len() >= rules.peers)?;
    let far = |ratio: f64| ratio.max(1.0 / ratio) >= rules.least_factor;
    let alike = kind.iter().filter(|other| !far(own / **other)).count();
    (far(ratio) && 2 * alike <= kind.len()).then_some(ratio)
}

/// The gain of a channel whose shape is the simulation's.
fn gain(rules: &ScaleRules, record: &Record, c: Load) -> Option<f64> {
    let pair: Pair = record.signal(c)?;
    let gain = pair.gain(record.sigma[c]).filter(|gain| *gain > 0.0)?;
    let powers = dot(&pair.simulated, &pair.simulated) / dot(&pair.measured, &pair.measured);
    (gain * powers.sqrt() > rules.alike).then_some(gain)
}
