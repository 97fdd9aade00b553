//! What `discover` answered, as its `result.json` says it.

use nastran::InputError;
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// A number; JSON writes one that is none as null.
fn number<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Ok(Option::<f64>::deserialize(from)?.unwrap_or(f64::NAN))
}

/// The kind of answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum VerdictKind {
    /// Effects are named.
    Effects,
    /// Effects are named, with rivals that the data cannot tell from them.
    Ambiguous,
    /// The model explains the data.
    None,
    /// Something is missing that no effect explains.
    Unknown,
    /// The data are at fault.
    DataDefect,
}

/// An estimate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Value.
    #[serde(deserialize_with = "number")]
    pub value: f64,
    /// One standard deviation.
    #[serde(default)]
    pub sigma: Option<f64>,
}

/// A named effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Named {
    /// Name.
    pub name: String,
    /// Stated probability that it is right.
    #[serde(default)]
    pub confidence: Option<f64>,
    /// What it may be instead.
    #[serde(default)]
    pub confused_with: Vec<String>,
    /// Parameters by name with unit.
    #[serde(default)]
    pub parameters: BTreeMap<String, Estimate>,
}

/// A gap before and after, and the one that remains without any missing effect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Gap {
    /// Before.
    #[serde(deserialize_with = "number")]
    pub before: f64,
    /// After.
    #[serde(deserialize_with = "number")]
    pub after: f64,
    /// Floor.
    #[serde(deserialize_with = "number")]
    pub floor: f64,
}

/// Gaps of the training and of the held-out runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Gaps {
    /// Training runs.
    pub training: Gap,
    /// Held-out runs.
    pub holdout: Gap,
}

/// See the module. What else a result holds is not looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The kind of answer.
    #[serde(rename = "verdict")]
    pub kind: VerdictKind,
    /// Named effects, the surest first.
    #[serde(default)]
    pub effects: Vec<Named>,
    /// Gaps.
    #[serde(default)]
    pub gap: Option<Gaps>,
    /// Time it took, s.
    #[serde(default)]
    pub seconds: Option<f64>,
    /// Simulations of a campaign it took.
    #[serde(default)]
    pub model_runs: Option<f64>,
}

impl Verdict {
    /// From the text of a `result.json`; `path` is for the error's message.
    ///
    /// # Errors
    /// Text that is no JSON, or lacks a verdict.
    pub fn from_json(text: &str, path: &Path) -> Result<Self, InputError> {
        serde_json::from_str(text).map_err(|error| {
            InputError::in_file(path, format!("this is no result of `discover`: {error}"))
                .with_help("give the result.json that `cargo xtask discover` wrote")
        })
    }

    /// Names that are claimed, the surest first.
    pub fn names(&self) -> Vec<&str> {
        match self.kind {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_is_read_with_more_keys_than_are_needed() {
        let text = r#"{ "command": "discover", "verdict": "effects",
            "located": [ {"channel":"My_Nm","regressor":"alpha_ddot","share_of_residual":0.78} ],
            "effects": [ {"name":"joiner_inertia","confidence":0.98,"confused_with":["added_mass"],
                          "parameters":{"Iyy_kg_m2":{"value":0.011,"sigma":0.0004}}} ],
            "next_experiment": "wind-off pitch",
            "gap": {"training":{"before":41.2,"after":11.0,"floor":9.8},
                    "holdout":{"before":39.0,"after":12.1,"floor":10.3}} }"#;
        let unknown_floor = text.replace("10.3", "null");
        let verdict = Verdict::from_json(text, Path::new("result.json")).expect("a result");
        assert_eq!(verdict.set(), ["joiner_inertia", "added_mass"]);
        assert_eq!(verdict.gap.map(|gap| gap.holdout.after), Some(12.1));
        let verdict = Verdict::from_json(&unknown_floor, Path::new("result.json")).expect("a result");
        assert!(verdict.gap.is_some_and(|gap| gap.holdout.floor.is_nan()));
        assert!(Verdict::from_json("{}", Path::new("result.json")).is_err());
    }
}
