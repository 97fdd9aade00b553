//! Options that several commands have.

mod response;

pub(crate) use response::ResponseArgs;

use std::path::PathBuf;

use clap::Args;

use crate::paths;

/// Options of every command.
#[derive(Debug, Clone, Default, Args)]
pub struct Common {
    /// Folder for the results [default: out/NAME]; replaced as a whole once all results are complete
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
        self.out.clone().unwrap_or_else(|| paths::in_repository(&format!("out/{command}")))
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(number @ 1..=1024) => Ok(number),
        _ => Err("expected a number from 1 to 1024".into()),
    }
}

/// A wing with measurements of it and its corrections.
#[derive(Debug, Clone, Default, Args)]
pub struct Given {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// The folder of measurements [default: data/tuflex/measured]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
    /// Corrections from `calibrate` [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
}
