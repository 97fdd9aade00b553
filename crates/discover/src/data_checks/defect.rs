//! A fault of the data.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum DefectKind {
    /// Labels of channels exchanged.
    SwappedChannels,
    /// A channel's sign.
    SignFlipped,
    /// A channel is many times what it is in other runs.
    Scaled,
    /// The airspeed is not what the label says.
    WrongAirspeed,
    /// The channel ends at a value beyond which the load went.
    Clipped,
    /// The channel stands still while the load moves.
    Stuck,
    /// The run is late or early.
    Lag,
    /// Single samples far off.
    Spikes,
    /// A repeat that does not repeat.
    Repeat,
}

/// A defect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Defect {
    /// What is wrong.
    pub kind: DefectKind,
    /// Name of the run or of the static points; none if it is so everywhere.
    pub run: Option<String>,
    /// The channel; none if it concerns all of them or several.
    pub channel: Option<Cow<'static, str>>,
    /// One plain sentence.
    pub sentence: String,
}
