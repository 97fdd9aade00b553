//! What the search finds where nothing is missing, on campaigns without effect ([`crate::null_campaigns`]): thresholds and floors.

use crate::null_key::NullKey;
use maneuver::effects::Effect;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Thresholds of evidence by effect and form, and what the misfit is without effects.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NullDistribution {
    /// What it belongs to.
    pub key: NullKey,
    /// By `name form`.
    pub evidence: BTreeMap<String, f64>,
    /// The part of them that differences in model form may account for. Files of earlier versions have none; their key says that
    /// they were made by other rules.
    #[serde(default)]
    pub model_form: f64,
    /// Chi square a row where nothing is missing, mean.
    pub misfit: f64,
    /// Above this something is missing.
    pub misfit_limit: f64,
    /// Gap where nothing is missing: training, held out.
    pub floor: [f64; 2],
}

impl Default for NullDistribution {
    fn default() -> Self {
        Self {
            key: NullKey::default(),
            evidence: BTreeMap::new(),
            model_form: 0.0,
            misfit: 1.0,
            misfit_limit: 1.5,
            floor: [1.0; 2],
        }
    }
}

/// As thresholds are listed: name and form.
pub(crate) fn label(effect: &Arc<dyn Effect>) -> String {
    format!("{} {}", effect.spec().name, effect.form())
}

impl NullDistribution {
    /// Thresholds as if null campaigns had found nothing at all, where differences in model form account for so much.
    pub fn bare(library: &[Arc<dyn Effect>], model_form: f64) -> Self {
        let evidence = library.iter().map(|effect| (label(effect), model_form)).collect();
        Self { evidence, model_form, ..Self::default() }
    }

    /// Threshold of an effect in a form; none is high enough for one that no null campaign was searched for.
    pub fn threshold(&self, effect: &Arc<dyn Effect>) -> f64 {
        self.evidence.get(&label(effect)).copied().unwrap_or(f64::INFINITY)
    }

    /// Whether it is of this key and has every effect of a library.
    pub fn serves(&self, key: &NullKey, library: &[Arc<dyn Effect>]) -> bool {
        self.key == *key && library.iter().all(|effect| self.evidence.contains_key(&label(effect)))
    }
}
