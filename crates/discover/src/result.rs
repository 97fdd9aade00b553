//! What `discover` answers, as its `result.json` has it: written by the command, read by its page and by the blind benchmark.
//!
//! Unknown keys are tolerated, and a number that is none is written as null.

use crate::consistency::Share;
use crate::data_checks::Defect;
use crate::detection_limit::DetectionLimit;
use crate::gap::Gap;
use crate::locate::Located;
use crate::next::Advice;
use crate::spectral_lines::SpectralLine;
use crate::stated_noise::NoiseBand;
use crate::verdict::VerdictKind;
use coupling::ByLoad;
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;

/// Null is read as no number.
fn number<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(from)?.unwrap_or(f64::NAN))
}

/// A fitted value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Estimate {
    /// Value.
    #[serde(deserialize_with = "number")]
    #[schemars(with = "Option<f64>")]
    pub value: f64,
    /// One standard deviation.
    #[serde(default)]
    pub sigma: Option<f64>,
}

/// A named effect.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct NamedEffect {
    /// Name.
    pub name: String,
    /// Its form.
    pub form: String,
    /// What it is, in words.
    pub title: String,
    /// Stated probability that it is right.
    pub confidence: Option<f64>,
    /// What it may be instead.
    pub confused_with: Vec<String>,
    /// Logarithm of the Bayes factor.
    pub log_bayes_factor: Option<f64>,
    /// Whether it belongs to the wing and flies with it.
    pub stays_with_the_wing: bool,
    /// Parameters by name with unit.
    pub parameters: BTreeMap<String, Estimate>,
    /// Its size from single parts of the data.
    pub parts: Vec<Share>,
}

/// Before and after the effects.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BeforeAfter<T> {
    /// Without them.
    pub before: T,
    /// With them.
    pub after: T,
}

/// A held-out run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct HeldOutRun {
    /// Its name.
    pub run: String,
    /// The training run that moved in the same way at the same airspeed, if there is one.
    pub repeats: Option<String>,
    /// Root mean square of measured minus simulated loads over the noise.
    pub gap: BeforeAfter<f64>,
    /// Numbers that it is the root mean square of.
    pub rows: usize,
}

/// The gap of training or held-out data; without numbers where there are no such data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StatedGap {
    /// Without the effects.
    #[serde(deserialize_with = "number")]
    #[schemars(with = "Option<f64>")]
    pub before: f64,
    /// With them.
    #[serde(deserialize_with = "number")]
    #[schemars(with = "Option<f64>")]
    pub after: f64,
    /// Where nothing is missing.
    #[serde(deserialize_with = "number")]
    #[schemars(with = "Option<f64>")]
    pub floor: f64,
    /// By load; null for a load that the campaign lacks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by_channel: Option<BeforeAfter<ByLoad<Option<f64>>>>,
    /// Residual over the load's variation, per cent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub raw_percent: Option<BeforeAfter<ByLoad<Option<f64>>>>,
}

impl Default for StatedGap {
    fn default() -> Self {
        let none = f64::NAN;
        Self { before: none, after: none, floor: none, by_channel: None, raw_percent: None }
    }
}

impl StatedGap {
    /// Of gaps before and after, of a campaign that has some of the loads.
    pub fn new([before, after]: [Gap; 2], floor: f64, has: [bool; 3]) -> Self {
        let there = |values: ByLoad<f64>| ByLoad::from_fn(|load| has[load as usize].then_some(values[load]));
        let of = |values: fn(&Gap) -> ByLoad<f64>| {
            Some(BeforeAfter { before: there(values(&before)), after: there(values(&after)) })
        };
        Self {
            before: before.all,
            after: after.all,
            floor,
            by_channel: of(|gap| gap.by_channel),
            raw_percent: of(|gap| gap.raw_percent),
        }
    }
}

/// Gaps of the training and of the held-out data.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct StatedGaps {
    /// Training data.
    pub training: StatedGap,
    /// Held-out data.
    pub holdout: StatedGap,
}

/// Chi square a row of the training data.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Misfit {
    /// Without effects.
    pub before: f64,
    /// With them.
    pub after: f64,
    /// Where nothing is missing.
    pub nothing_missing: f64,
    /// Above this something is missing.
    pub limit: f64,
}

/// An effect that was weighed, and what it needs.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Candidate {
    /// Name, and form if it has several.
    pub name: String,
    /// Logarithm of the Bayes factor.
    pub log_bayes_factor: f64,
    /// What it needs to be named.
    pub threshold: f64,
}

/// A cell of the residual's map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MapCell {
    /// Channel.
    pub channel: String,
    /// Kind of maneuver, in words.
    pub maneuver: String,
    /// From this frequency, Hz...
    pub from_hz: f64,
    /// ... to this.
    pub to_hz: f64,
    /// Mean square of the residual over that of pure error, without effects.
    pub before: f64,
    /// With them.
    #[serde(deserialize_with = "number")]
    #[schemars(with = "Option<f64>")]
    pub after: f64,
    /// What it stays below 99 times in a hundred where there is nothing but pure error.
    pub limit: f64,
    /// Number of coefficients or points.
    #[serde(skip)]
    pub rows: usize,
    /// Number of runs or static groups.
    #[serde(skip)]
    pub units: usize,
}

/// See the module.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DiscoverResult {
    /// Name of the command.
    #[serde(default)]
    pub command: String,
    /// The kind of answer.
    pub verdict: VerdictKind,
    /// Named effects, the surest first.
    #[serde(default)]
    pub effects: Vec<NamedEffect>,
    /// Faults of the data, which end the command.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub defects: Vec<Defect>,
    /// Why a campaign was not read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
    /// Time it took, s.
    #[serde(default)]
    pub seconds: Option<f64>,
    /// What the search says; none where the data are at fault.
    #[serde(flatten)]
    pub search: Option<SearchResult>,
}

/// What a search says.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct SearchResult {
    /// The verdict in words.
    pub sentence: String,
    /// What the residual goes with before any effect.
    pub located: Vec<Located>,
    /// What would tell more.
    pub next_experiment: Option<String>,
    /// Experiments that would separate what is left open, the best first.
    pub experiments: Vec<Advice>,
    /// Gaps.
    pub gap: Option<StatedGaps>,
    /// Held-out runs one by one, and which of them repeat a training maneuver.
    pub held_out_runs: Vec<HeldOutRun>,
    /// Whether the held-out gap closed.
    pub success: bool,
    /// Whether the training data come nearer with the effects.
    pub supported: bool,
    /// What was measured and is not used.
    pub not_used: Vec<String>,
    /// Chi square a row.
    pub misfit: Misfit,
    /// The best candidate that was not named.
    pub not_named: Option<Candidate>,
    /// Candidates before any effect, by falling evidence.
    pub candidates: Vec<Candidate>,
    /// Sizes that would have been named, where nothing is.
    pub detection_limits: Vec<DetectionLimit>,
    /// What the search did, step by step.
    #[serde(rename = "search")]
    pub steps: Vec<String>,
    /// Lines that do not repeat from run to run.
    pub spectral_lines: Vec<SpectralLine>,
    /// Where repeats differ by more than the noise that the campaign states.
    pub noise_beyond_stated: Vec<NoiseBand>,
    /// Where the corrections come from.
    pub corrections: String,
    /// Where the null distribution comes from.
    pub null_distribution: String,
    /// Fingerprint of the data.
    pub data_hash: String,
    /// How training and held-out runs were divided, if the campaign does not say it.
    pub split: Option<String>,
    /// Pairs of runs that tell the noise.
    pub repeated_pairs: usize,
    /// How often the campaign was flown.
    pub model_runs: Option<usize>,
    /// Where the residual is, before and after.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<Vec<MapCell>>,
}

impl DiscoverResult {
    /// Of data at fault: the defects, or why they were not read.
    pub fn at_fault(defects: Vec<Defect>, refused: Option<String>, seconds: f64) -> Self {
        Self {
            command: "discover".to_owned(),
            verdict: VerdictKind::DataDefect,
            effects: Vec::new(),
            defects,
            refused,
            seconds: Some(seconds),
            search: None,
        }
    }

    /// From the text of a `result.json`; `path` is for the error's message.
    ///
    /// # Errors
    /// Text that is no JSON, or lacks a verdict.
    pub fn from_json(text: &str, path: &std::path::Path) -> Result<Self, nastran::InputError> {
        serde_json::from_str(text).map_err(|error| {
            nastran::InputError::in_file(path, format!("this is no result of `discover`: {error}"))
                .with_help("give the result.json that `wingroot discover` wrote")
        })
    }

    /// Gaps of training and held-out data.
    pub fn gap(&self) -> Option<StatedGaps> {
        self.search.as_ref()?.gap
    }

    /// Names that are claimed, the surest first.
    pub fn names(&self) -> Vec<&str> {
        match self.verdict {
            VerdictKind::Effects | VerdictKind::Ambiguous => {
                self.effects.iter().map(|effect| effect.name.as_str()).collect()
            }
            VerdictKind::None | VerdictKind::Unknown | VerdictKind::DataDefect => Vec::new(),
        }
    }

    /// The names and what they may be instead, each once.
    pub fn set(&self) -> Vec<&str> {
        let mut set = self.names();
        if set.is_empty() {
            return set;
        }
        for rival in self.effects.iter().flat_map(|effect| &effect.confused_with) {
            if !set.contains(&rival.as_str()) {
                set.push(rival);
            }
        }
        set
    }
}
