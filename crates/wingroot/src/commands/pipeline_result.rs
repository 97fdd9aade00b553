//! `result.json` of `pipeline`: those of its steps.

use std::collections::BTreeMap;

use crate::commands::fullaircraft::FullaircraftResult;
use discover::result::DiscoverResult;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

use super::calibrate_result::CalibrateResult;
use super::deflection_result::DeflectionResult;
use super::simulate_result::SimulateResult;

/// The steps one after the other.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PipelineResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Wall clock.
    pub(crate) seconds: f64,
    /// Wall clock of each step, s.
    pub(crate) steps: BTreeMap<String, f64>,
    /// Figures of the paper with their curves.
    pub(crate) figures: Vec<PaperFigure>,
    /// Runs that `discover` held out, before and after.
    pub(crate) held_out_runs: Vec<HeldOutRun>,
    /// Of `calibrate`.
    #[schemars(with = "CalibrateResult")]
    pub(crate) calibrate: Value,
    /// Of `deflection`.
    #[schemars(with = "DeflectionResult")]
    pub(crate) deflection: Value,
    /// Of `simulate`.
    #[schemars(with = "SimulateResult")]
    pub(crate) simulate: Value,
    /// Of `discover`.
    #[schemars(with = "DiscoverResult")]
    pub(crate) discover: Value,
    /// Of `fullaircraft`.
    #[schemars(with = "FullaircraftResult")]
    pub(crate) fullaircraft: Value,
}

/// A run that `discover` held out.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct HeldOutRun {
    /// Its name.
    pub(crate) run: String,
    /// Root mean squares of measured less simulated loads (`Fz_N`, `Mx_Nm`, `My_Nm`) before.
    pub(crate) before: BTreeMap<String, f64>,
    /// The same after.
    pub(crate) after: BTreeMap<String, f64>,
}

/// A figure of the paper.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PaperFigure {
    /// Its number.
    pub(crate) figure: u32,
    /// What it shows.
    pub(crate) shows: String,
    /// The picture.
    pub(crate) picture: String,
    /// Its curves as CSV.
    pub(crate) curves: String,
}
