//! Metrics of stated numbers: confidences and parameters.

use super::judged::Judged;
use super::metric::Metric;
use crate::answer::{TrueEffect, TrueParameter};
use discover::result::{Estimate, NamedEffect};
use std::collections::BTreeMap;

/// Bins of the confidence.
const BINS: usize = 10;
/// Half width of a 90 % interval in standard deviations.
const NINETY: f64 = 1.645;

/// Adds the metrics.
pub(super) fn add(cases: &[Judged<'_>], metrics: &mut BTreeMap<String, Metric>) {
    let stated = confidences(cases);
    let squares: Vec<f64> =
        stated.iter().map(|(p, right)| (p - f64::from(u8::from(*right))).powi(2)).collect();
    metrics.insert("confidence_brier".to_owned(), Metric::mean(&squares));
    metrics.insert("confidence_ece".to_owned(), Metric::number(calibration_error(&stated), stated.len()));
    let n = stated.len();
    let too_high = stated.iter().map(|(p, right)| p - f64::from(u8::from(*right))).sum::<f64>();
    metrics.insert("overconfidence".to_owned(), Metric::number((n > 0).then(|| too_high / n as f64), n));
    for (bin, Bin { stated, hits, names }) in
        bins(&stated).into_iter().enumerate().filter(|(_, bin)| bin.names > 0)
    {
        let mean = Metric::number(Some(stated / names as f64), names);
        metrics.insert(format!("confidence_stated_bin_{bin}"), mean);
        metrics.insert(format!("confidence_right_bin_{bin}"), Metric::share(hits, names));
    }
    let mut errors: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    let (mut inside, mut with_sigma) = (0, 0);
    let finite = |(_, _, estimate): &(&str, &TrueParameter, Estimate)| estimate.value.is_finite();
    for (effect, parameter, estimate) in cases.iter().flat_map(estimates).filter(finite) {
        let error = (estimate.value / parameter.value - 1.0).abs();
        errors.entry(effect).or_default().push(error);
        if let Some(sigma) = estimate.sigma {
            with_sigma += 1;
            inside += usize::from((estimate.value - parameter.value).abs() <= NINETY * sigma);
        }
    }
    let all: Vec<f64> = errors.values().flatten().copied().collect();
    metrics.insert("parameter_error_median".to_owned(), Metric::median(all));
    metrics.insert("parameter_90_coverage".to_owned(), Metric::share(inside, with_sigma));
    for (effect, of_effect) in errors {
        metrics.insert(format!("parameter_error_{effect}"), Metric::median(of_effect));
    }
}

/// Stated confidences of names, with whether they are right.
fn confidences(cases: &[Judged<'_>]) -> Vec<(f64, bool)> {
    let of = |case: &Judged<'_>| -> Vec<(f64, bool)> {
        if !(case.is_null() || case.is_single() || case.is_pair()) || case.verdict.names().is_empty() {
            return Vec::new();
        }
        let stated = case.verdict.effects.iter();
        stated.filter_map(|named| Some((named.confidence?, case.is_right(&named.name)))).collect()
    };
    cases.iter().flat_map(of).collect()
}

/// Names whose stated confidence lies within a tenth.
#[derive(Debug, Clone, Copy, Default)]
struct Bin {
    /// Sum of what was stated.
    stated: f64,
    hits: usize,
    names: usize,
}

/// Stated confidences by tenths; one belongs to the last.
fn bins(stated: &[(f64, bool)]) -> [Bin; BINS] {
    let mut bins = [Bin::default(); BINS];
    for (p, right) in stated {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the bins")]
        let bin = &mut bins[((p.clamp(0.0, 1.0) * BINS as f64) as usize).min(BINS - 1)];
        bin.stated += p;
        bin.hits += usize::from(*right);
        bin.names += 1;
    }
    bins
}

/// Expected calibration error: mean over bins of |hits - confidence|, weighted by their numbers.
fn calibration_error(stated: &[(f64, bool)]) -> Option<f64> {
    let apart = |bin: &Bin| (bin.hits as f64 - bin.stated).abs();
    (!stated.is_empty()).then(|| bins(stated).iter().map(apart).sum::<f64>() / stated.len() as f64)
}

/// Estimated sizes of rightly named effects.
fn estimates<'c>(case: &Judged<'c>) -> Vec<(&'c str, &'c TrueParameter, Estimate)> {
    if case.verdict.names().is_empty() || case.answer.defect.is_some() {
        return Vec::new();
    }
    let matched = |effect: &'c TrueEffect| {
        let named = case.verdict.effects.iter().find(|named| named.name == effect.name);
        named.map(|named| of_effect(effect, named)).unwrap_or_default()
    };
    case.answer.effects.iter().flat_map(matched).collect()
}

/// Sizes with the same name, or the only ones of both.
fn of_effect<'c>(effect: &'c TrueEffect, named: &NamedEffect) -> Vec<(&'c str, &'c TrueParameter, Estimate)> {
    let sizes: Vec<&TrueParameter> =
        effect.parameters.iter().filter(|parameter| parameter.size && parameter.value != 0.0).collect();
    if let ([only], 1) = (sizes.as_slice(), named.parameters.len()) {
        return named.parameters.values().map(|estimate| (effect.name.as_str(), *only, *estimate)).collect();
    }
    let same = |parameter: &&'c TrueParameter| {
        Some((effect.name.as_str(), *parameter, *named.parameters.get(&parameter.name)?))
    };
    sizes.iter().filter_map(same).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn confidences_that_come_true_have_no_calibration_error() {
        let sure = vec![(1.0, true); 5];
        assert_eq!(calibration_error(&sure), Some(0.0));
        // four of five said with .8, one wrong
        let mut right: Vec<(f64, bool)> = vec![(0.8, true); 4];
        right.push((0.8, false));
        assert!(calibration_error(&right).is_some_and(|ece| ece < 1e-12));
        // said with .9, half right: .4 off
        let half = vec![(0.9, true), (0.9, false)];
        assert!(calibration_error(&half).is_some_and(|ece| (ece - 0.4).abs() < 1e-12));
        // bins do not make up for each other, and the last one has its upper end
        let apart = vec![(0.1, true), (0.9, false)];
        assert!(calibration_error(&apart).is_some_and(|ece| (ece - 0.9).abs() < 1e-12));
        assert_eq!(calibration_error(&[(1.0, false)]), Some(1.0));
        assert_eq!(calibration_error(&[]), None);
    }
}
