//! What a search for something missing answers, of terms of a response surface here and of effects of a wing in `discover`:
//! the kind of answer, the gap before and after, and the limit that campaigns with nothing missing set.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The kind of answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VerdictKind {
    /// What is missing is named.
    Effects,
    /// What is missing is named, with rivals that the data cannot tell from it.
    Ambiguous,
    /// The model explains the data.
    #[default]
    None,
    /// Something is missing that no candidate explains.
    Unknown,
    /// The data are at fault.
    DataDefect,
}

impl VerdictKind {
    /// As results have it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Effects => "effects",
            Self::Ambiguous => "ambiguous",
            Self::None => "none",
            Self::Unknown => "unknown",
            Self::DataDefect => "data_defect",
        }
    }
}

/// Root mean square of what a model leaves, in standard deviations of the noise.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Gap {
    /// With the model as given.
    #[schemars(with = "Option<f64>")]
    pub before: f64,
    /// With what was named.
    #[schemars(with = "Option<f64>")]
    pub after: f64,
    /// Where nothing is missing.
    #[schemars(with = "Option<f64>")]
    pub floor: f64,
}

impl Gap {
    /// Whether it shrank, and to at most so many times what is left where nothing is missing.
    pub fn is_closed(&self, times: f64) -> bool {
        self.after < self.before && self.after <= times * self.floor
    }
}

/// Mean and standard deviation (of a sample) of what campaigns with nothing missing show: a limit is so many deviations above
/// the mean.
pub fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let count = values.len().max(1) as f64;
    let mean = values.iter().sum::<f64>() / count;
    let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
    (mean, square.sqrt())
}
