//! The RON file of a selection: which cases go to stress, and how.

use nastran::{InputError, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A load at a station.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize, JsonSchema)]
pub enum Load {
    /// Force aft, N.
    Fx,
    /// Force to the right, N.
    Fy,
    /// Force up, N.
    Fz,
    /// Moment about the axis aft, N m: right tip up is positive.
    Mx,
    /// Moment about the axis to the right, N m: nose up is positive.
    My,
    /// Moment about the axis up, N m.
    Mz,
}

impl Load {
    /// All six, in the order of a station's components.
    pub const ALL: [Self; 6] = [Self::Fx, Self::Fy, Self::Fz, Self::Mx, Self::My, Self::Mz];

    /// Its place among a station's six components.
    pub fn place(self) -> usize {
        self as usize
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        ["Fx", "Fy", "Fz", "Mx", "My", "Mz"][self.place()]
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        if self.place() < 3 { "N" } else { "N m" }
    }
}

/// A rule by which cases are taken.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Policy {
    /// Both ends of these loads at each station.
    Envelope {
        /// Loads.
        #[serde(default = "three_loads")]
        loads: Vec<Load>,
        /// Stations; left out: all.
        #[serde(default)]
        stations: Vec<String>,
    },
    /// The corners of the convex hull of pairs of loads at each station.
    Hull {
        /// Pairs.
        #[serde(default = "three_pairs")]
        pairs: Vec<(Load, Load)>,
        /// Stations; left out: all.
        #[serde(default)]
        stations: Vec<String>,
    },
    /// All whose load is within so many percent of an end, of the end's size.
    Within {
        /// Percent of the end's size.
        percent: f64,
        /// Loads.
        #[serde(default = "three_loads")]
        loads: Vec<Load>,
        /// Stations; left out: all.
        #[serde(default)]
        stations: Vec<String>,
    },
    /// The cases with the largest and smallest values, so many at each end.
    Top {
        /// How many.
        n: usize,
        /// Loads.
        #[serde(default = "three_loads")]
        loads: Vec<Load>,
        /// Stations; left out: all.
        #[serde(default)]
        stations: Vec<String>,
    },
    /// The cases with the highest scores: the largest of weight times |load| over the allowable.
    Score {
        /// How many.
        n: usize,
        /// What counts.
        weights: Vec<Weight>,
    },
    /// These cases, whatever they drive.
    Always {
        /// Numbers.
        cases: Vec<usize>,
        /// Why.
        because: String,
    },
    /// Not these cases: the next in line takes their place.
    Never {
        /// Numbers.
        cases: Vec<usize>,
        /// Why.
        because: String,
    },
}

/// What a load at a station counts in a score.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Weight {
    /// Station.
    pub station: String,
    /// Load.
    pub load: Load,
    /// Allowable, N or N m.
    pub allowable: f64,
    /// Weight.
    #[serde(default = "one")]
    pub weight: f64,
}

/// Where loads are put for stress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
pub enum ExportAt {
    /// At the grids of the structure.
    #[default]
    Grids,
    /// At the stations' points: each carries the difference to the next outboard.
    Stations,
}

/// A part of the loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
pub enum Component {
    /// Loads of the air.
    Air,
    /// Mass times acceleration and gravity.
    Inertia,
    /// Thrust.
    Thrust,
    /// Their sum.
    Net,
}

/// How selected cases are written.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// Where.
    #[serde(default)]
    pub at: ExportAt,
    /// What.
    #[serde(default = "net")]
    pub components: Vec<Component>,
    /// Factor of ultimate loads: a column and a comment; cards are limit loads.
    #[serde(default = "one")]
    pub factor: f64,
}

impl Default for Export {
    fn default() -> Self {
        Self { at: ExportAt::Grids, components: net(), factor: 1.0 }
    }
}

/// Which of the two models count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize, JsonSchema)]
pub enum Model {
    /// As theory has it.
    Initial,
    /// With the corrections.
    Updated,
}

impl Model {
    /// Its name in results.
    pub fn name(self) -> &'static str {
        if self == Self::Initial { "initial" } else { "updated" }
    }
}

/// A selection as its file describes it.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Select")]
pub struct SelectFile {
    /// Rules; what any of them takes is selected.
    pub policies: Vec<Policy>,
    /// Whether a load of the left wing and its image on the right are one.
    #[serde(default)]
    pub mirror: bool,
    /// The most cases.
    #[serde(default)]
    pub at_most: Option<usize>,
    /// Models that count.
    #[serde(default = "updated")]
    pub models: Vec<Model>,
    /// How they are written.
    #[serde(default)]
    pub export: Export,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
}

impl Default for SelectFile {
    /// Ends and hulls of Fz, Mx and My at all stations, of the updated model.
    fn default() -> Self {
        Self {
            policies: vec![
                Policy::Envelope { loads: three_loads(), stations: Vec::new() },
                Policy::Hull { pairs: three_pairs(), stations: Vec::new() },
            ],
            mirror: false,
            at_most: None,
            models: updated(),
            export: Export::default(),
            path: PathBuf::new(),
        }
    }
}

impl SelectFile {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// If it cannot be read, a number makes no sense, or nothing could be selected by it.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let mut file: Self = ron_file::read(path)?;
        file.path = path.to_path_buf();
        file.check()?;
        Ok(file)
    }

    fn check(&self) -> Result<(), InputError> {
        let wrong = |field: &str, message: &str, help: &str| {
            Err(InputError::in_field(&self.path, field, message).with_help(help))
        };
        if !self.policies.iter().any(Policy::takes) {
            return wrong("policies", "no policy takes a case", "give `Envelope()`, for instance");
        }
        if self.at_most == Some(0) {
            return wrong(
                "at_most",
                "at most no case is no selection",
                "give a number above zero, or leave it out",
            );
        }
        if self.models.is_empty() {
            return wrong("models", "no model counts", "give [Updated], [Initial] or both");
        }
        if self.export.components.is_empty() || !(self.export.factor.is_finite() && self.export.factor > 0.0)
        {
            return wrong(
                "export",
                "an export needs a component and a factor above zero",
                "left out, both have a value",
            );
        }
        for policy in &self.policies {
            match policy {
                Policy::Within { percent, .. } if !(0.0..=100.0).contains(percent) => {
                    return wrong("percent", "this is no percentage", "expected a number from 0 to 100");
                }
                Policy::Top { n: 0, .. } | Policy::Score { n: 0, .. } => {
                    return wrong("n", "no case would be taken", "expected a number above zero");
                }
                Policy::Score { weights, .. }
                    if weights.iter().any(|w| !(w.allowable > 0.0 && w.weight > 0.0)) =>
                {
                    return wrong(
                        "weights",
                        "an allowable or a weight is not above zero",
                        "expected numbers above zero",
                    );
                }
                Policy::Hull { pairs, .. } if pairs.iter().any(|(a, b)| a == b) => {
                    return wrong(
                        "pairs",
                        "a pair has the same load twice",
                        "expected pairs such as (Fz, Mx)",
                    );
                }
                _ => {}
            }
        }
        Ok(())
    }
}

impl Policy {
    fn takes(&self) -> bool {
        !matches!(self, Self::Never { .. })
    }
}

fn three_loads() -> Vec<Load> {
    vec![Load::Fz, Load::Mx, Load::My]
}

fn three_pairs() -> Vec<(Load, Load)> {
    vec![(Load::Fz, Load::Mx), (Load::Mx, Load::My), (Load::Fz, Load::My)]
}

fn net() -> Vec<Component> {
    vec![Component::Net]
}

fn updated() -> Vec<Model> {
    vec![Model::Updated]
}

fn one() -> f64 {
    1.0
}
