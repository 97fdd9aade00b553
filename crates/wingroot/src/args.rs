//! Options that several commands have.

mod response;

pub use response::ResponseArgs;

use std::path::PathBuf;

use clap::Args;
use nastran::InputError;

use crate::paths;

/// Options of every command.
#[derive(Debug, Clone, Default, Args)]
pub struct Common {
    /// Folder for the results [default: out/NAME of the current folder]; earlier results there are replaced once all new
    /// ones are complete
    #[arg(long, global = true, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print result.json to standard output, and nothing else there
    #[arg(long, global = true)]
    pub json: bool,
    /// No progress and no summary
    #[arg(long, global = true)]
    pub quiet: bool,
    /// Number of threads [default: all processors]
    #[arg(long, global = true, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    /// Seed of whatever is random
    #[arg(long, global = true, value_name = "N")]
    pub seed: Option<u64>,
}

impl Common {
    /// The folder for the results of a command.
    pub fn out(&self, command: &str) -> PathBuf {
        self.out.clone().unwrap_or_else(|| paths::results(command))
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(number @ 1..=1024) => Ok(number),
        _ => Err("expected a number from 1 to 1024".into()),
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
}
