//! Options that several commands have.

mod response;

pub use crate::common::Common;
pub use response::ResponseArgs;

use std::path::PathBuf;

use clap::Args;
use nastran::InputError;

use crate::paths;

/// A whole number above zero, `MOST` at most.
pub(crate) fn whole<const MOST: usize>(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(number) if (1..=MOST).contains(&number) => Ok(number),
        _ => Err(format!("expected a whole number from 1 to {MOST}")),
    }
}

/// An airspeed, m/s.
pub(crate) fn airspeed(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(v_m_s) if calibrate::campaign::AIRSPEEDS_M_S.contains(&v_m_s) => Ok(v_m_s),
        _ => Err("expected an airspeed from 0.1 to 340 m/s".into()),
    }
}

/// A wing and measurements of it.
#[derive(Debug, Clone, Default, Args)]
pub struct Measured {
    /// The wing [default: wing.ron of the current folder]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// The folder of measurements [default: the one beside the wing: campaign, measured, or the wing's own folder]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
}

impl Measured {
    /// The wing's file.
    ///
    /// # Errors
    /// If none is named and none is in the current folder.
    pub fn wing_path(&self) -> Result<PathBuf, InputError> {
        paths::wing(self.wing.as_deref())
    }

    /// The campaign's folder.
    ///
    /// # Errors
    /// If none is named and none is beside the wing.
    pub fn campaign_path(&self) -> Result<PathBuf, InputError> {
        match &self.campaign {
            Some(campaign) => Ok(campaign.clone()),
            None => paths::campaign(None, &self.wing_path()?),
        }
    }
}

/// A wing with measurements of it and its corrections.
#[derive(Debug, Clone, Default, Args)]
pub struct Given {
    /// Wing and measurements.
    #[command(flatten)]
    pub measured: Measured,
    /// Corrections from `calibrate` [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
    /// Take corrections of a fit that stalled or diverged all the same
    #[arg(long)]
    pub accept_unconverged: bool,
    /// Compute with the calibrated wing alone, not with those of ensemble.ron beside the corrections: a third to two thirds of the time
    #[arg(long)]
    pub no_intervals: bool,
}
