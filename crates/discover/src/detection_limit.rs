//! The smallest size of every effect that a search would have named: what "nothing is missing" is worth.
//!
//! An effect that is there changes the whitened loads by c, which its fit takes out: where its form is exact its evidence is
//! `(c'c)/(2 phi) - prior/2 - ½ ln(1 + c'c/phi)`. Sizes are flown until this is the threshold, as neither limits nor what runs
//! may be off by let c grow in proportion.

use crate::current_model::CurrentModel;
use crate::null_distribution::NullDistribution;
use crate::setting::Setting;
use crate::trial::{Trial, difference};
use maneuver::effects::Effect;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::sync::Arc;

/// See the module.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DetectionLimit {
    /// Effect.
    pub name: Cow<'static, str>,
    /// Its form.
    pub form: Cow<'static, str>,
    /// Parameter, the others at rest (or where a search begins with them).
    pub parameter: String,
    /// Its value, to a factor of 1.4, with the sign that it can have (positive if either); none if it would not have been
    /// detected within the effect's bounds.
    pub value: Option<f64>,
}

/// Detection limits of all effects beside the current model, every parameter that does something alone.
pub fn detection_limits(
    setting: &Setting<'_>,
    current: &CurrentModel<'_>,
    nulls: &NullDistribution,
) -> Vec<DetectionLimit> {
    let of = |effect: &Arc<dyn Effect>| {
        let search = Search {
            trial: Trial { setting, current, effect, memory: None },
            threshold: nulls.threshold(effect),
            phi: (current.chi2 / current.problem.len() as f64).max(1.0),
        };
        search.all()
    };
    setting.library.par_iter().flat_map_iter(of).collect()
}

/// One effect.
struct Search<'a> {
    trial: Trial<'a>,
    threshold: f64,
    phi: f64,
}

impl Search<'_> {
    fn all(&self) -> Vec<DetectionLimit> {
        let effect = self.trial.effect;
        let parameters = effect.parameters();
        let start = effect.starts().into_iter().next();
        let base: Vec<f64> = match start {
            Some(values) => values.iter().zip(&parameters).map(|(v, p)| v / p.plausible).collect(),
            None => vec![0.0; parameters.len()],
        };
        let mut limits = Vec::new();
        for (k, parameter) in parameters.iter().enumerate() {
            let at = |size: f64| {
                let mut sizes = base.clone();
                sizes[k] = size;
                sizes
            };
            let (sign, bound) =
                if parameter.upper > 0.0 { (1.0, parameter.upper) } else { (-1.0, -parameter.lower) };
            // what acts without this parameter has its size in another, and what does nothing alone has none
            if self.information(&at(0.0)) > 0.0 || self.information(&at(sign)) == 0.0 {
                continue;
            }
            let largest = bound / parameter.plausible;
            let is_detected = |size: f64| self.evidence(&at(sign * size)) >= self.threshold;
            limits.push(DetectionLimit {
                name: effect.spec().name.into(),
                form: effect.form().into(),
                parameter: parameter.name.clone(),
                value: smallest(largest, self.trial.setting.rules().verdict.doublings, is_detected)
                    .map(|size| sign * size * parameter.plausible),
            });
        }
        limits
    }

    fn information(&self, sizes: &[f64]) -> f64 {
        let change = difference(&self.trial.current.extended, &self.trial.point(sizes).residual);
        self.trial.current.shared.norm_of_extended(&change)
    }

    fn evidence(&self, sizes: &[f64]) -> f64 {
        let information = self.information(sizes) / self.phi;
        let prior: f64 = sizes.iter().map(|size| size * size).sum();
        0.5 * (information - prior - information.ln_1p())
    }
}

/// The smallest size that is detected, to a factor of the root of two, from one upwards or downwards.
fn smallest(largest: f64, doublings: usize, is_detected: impl Fn(f64) -> bool) -> Option<f64> {
    let mut size = largest.min(1.0);
    if is_detected(size) {
        for _ in 0..doublings {
            if !is_detected(0.5 * size) {
                break;
            }
            size *= 0.5;
        }
    } else {
        loop {
            if size >= largest {
                return None;
            }
            size = (2.0 * size).min(largest);
            if is_detected(size) {
                break;
            }
        }
    }
    let between = size / std::f64::consts::SQRT_2;
    Some(if is_detected(between) { between } else { size })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_size_is_found_to_a_factor_of_the_root_of_two() {
        for limit in [0.01, 0.3, 0.99, 1.7, 6.0] {
            let size = smallest(8.0, 12, |size| size >= limit).expect("within bounds");
            assert!(size >= limit && size < 1.415 * limit, "{size} for {limit}");
        }
        assert_eq!(smallest(8.0, 12, |size| size >= 9.0), None);
        assert_eq!(smallest(0.5, 12, |size| size >= 0.5), Some(0.5));
    }
}
