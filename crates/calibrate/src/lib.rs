#![doc = include_str!("../README.md")]

pub mod basis;
mod blocks;
pub mod bounds;
pub mod calibration;
pub mod campaign;
pub mod checks;
pub mod common;
mod cone_program;
mod deflected;
pub mod ensemble;
pub mod fit;
pub mod identifiability;
pub mod left_out;
pub mod lift_factor;
pub mod member;
pub mod objective;
pub mod posterior;
pub mod schedule;
pub mod sensors;
pub mod settings;
pub mod statics;
#[cfg(test)]
mod tests;
mod tip_zero;

pub use calibration::{AirspeedCalibration, Calibration, WeightTare, calibrate};
pub use campaign::{Campaign, CampaignFile, Noise, RunEntry, Sets, StaticPoint, TipReading, Use};
pub use checks::{Finding, Weight};
pub use common::CommonCalibration;
pub use ensemble::Ensemble;
pub use fit::{Ending, Fit};
pub use identifiability::{ByFamily, Identifiability};
pub use lift_factor::LiftFactor;
pub use member::{CorrectionSet, Member};
pub use objective::{LineFit, Nonlinearity};
pub use schedule::Schedule;
pub use sensors::{DeadWeight, Reading, Sensor, Zero};
pub use settings::Settings;
pub use statics::{AirspeedData, StaticData};

/// Half of a 90 % interval of a Gaussian in standard deviations.
pub(crate) const HALF_90: f64 = 1.644_853_627;
