//! What the results of several commands have in common.

use coupling::ByLoad;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

use crate::failure::Failure;

/// A value for each channel; one that is not asked for is left out.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, JsonSchema)]
pub(crate) struct Channels {
    /// Of the force Fz.
    #[serde(rename = "Fz_N", skip_serializing_if = "Option::is_none")]
    pub(crate) fz: Option<f64>,
    /// Of the bending moment Mx.
    #[serde(rename = "Mx_Nm", skip_serializing_if = "Option::is_none")]
    pub(crate) mx: Option<f64>,
    /// Of the torsion moment My.
    #[serde(rename = "My_Nm", skip_serializing_if = "Option::is_none")]
    pub(crate) my: Option<f64>,
    /// Of the tip's height.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) tip_z_m: Option<f64>,
}

impl Channels {
    /// Those that are marked, in the order of the campaign's channels.
    pub(crate) fn of(values: [f64; 4], marked: [bool; 4]) -> Self {
        let at = |c: usize| marked[c].then_some(values[c]);
        Self { fz: at(0), mx: at(1), my: at(2), tip_z_m: at(3) }
    }
}

/// Of the model without and with corrections.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub(crate) struct Models<T> {
    /// Theory.
    pub(crate) initial: T,
    /// With corrections.
    pub(crate) updated: T,
}

/// A result as it is written and printed: keys in the order of the alphabet.
///
/// # Errors
/// If it is no JSON.
pub(crate) fn as_json<T: Serialize>(result: &T) -> Result<Value, Failure> {
    serde_json::to_value(result).map_err(Failure::computation)
}

/// Root loads by name; none where they were not measured.
pub(crate) type Loads = Option<ByLoad<f64>>;
