//! Repeats that differ by far more than noise and offset of a day.

use super::defect::{Defect, DefectKind};
use super::record::Record;
use crate::rules::RepeatRules;
use crate::statistics::{dot, mean, median};
use coupling::Load;

/// See the module; pairs with a run that is `named` already are left out.
pub(super) fn differ(rules: &RepeatRules, records: &[Record], named: &[String]) -> Vec<Defect> {
    let mut found = Vec::new();
    for c in Load::ALL {
        let channel = c.column();
        let pairs: Vec<(usize, usize, f64, f64)> = records
            .iter()
            .enumerate()
            .filter_map(|(i, record)| {
                let first = record.repeat_of?;
                let known = |record: &Record| named.contains(&record.name);
                if known(record) || known(records.get(first)?) {
                    return None;
                }
                let (difference, variation) = difference(&records[first], record, c)?;
                Some((first, i, difference, variation))
            })
            .collect();
        for &(first, second, difference, variation) in &pairs {
            let others = pairs.iter().filter(|pair| pair.1 != second).map(|pair| pair.2).collect();
            let usual = median(others).unwrap_or(0.0);
            if difference > rules.far
                && difference > rules.share * variation
                && difference > rules.beyond_others * usual
            {
                let name = &records[second].name;
                let sentence = format!(
                    "{channel} of {name} differs from {}, which it repeats, by {difference:.0} times the noise",
                    records[first].name
                );
                let run = Some(name.clone());
                found.push(Defect { kind: DefectKind::Repeat, run, channel: Some(channel.into()), sentence });
            }
        }
    }
    found
}

/// Root mean squares in standard deviations of a sample: of the residuals' difference without its mean, of the load.
fn difference(first: &Record, second: &Record, c: Load) -> Option<(f64, f64)> {
    let (a, b) = (first.channels[c].as_ref()?, second.channels[c].as_ref()?);
    if a.measured.len() != b.measured.len() {
        return None;
    }
    let residual = |pair: &super::record::Pair| -> Vec<f64> {
        pair.measured.iter().zip(&pair.simulated).map(|(m, s)| m - s).collect()
    };
    let difference: Vec<f64> = residual(a).iter().zip(residual(b)).map(|(a, b)| a - b).collect();
    let rms = |values: &[f64]| {
        let mean = mean(values);
        let off: Vec<f64> = values.iter().map(|value| value - mean).collect();
        (dot(&off, &off) / off.len() as f64).sqrt()
    };
    Some((
        rms(&difference) / (std::f64::consts::SQRT_2 * second.sigma[c]),
        rms(&b.simulated) / second.sigma[c],
    ))
}
