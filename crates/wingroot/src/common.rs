//! Options of every command.

use std::path::{Path, PathBuf};

use clap::Args;

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
    /// No pictures and no report.html: result.json, tables and files for other programs alone (for many small runs)
    #[arg(long, global = true)]
    pub numbers_only: bool,
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
        self.out.clone().unwrap_or_else(|| results(command))
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(number @ 1..=1024) => Ok(number),
        _ => Err("expected a number from 1 to 1024".into()),
    }
}

/// The folder of a command's results below the current folder.
pub fn results(command: &str) -> PathBuf {
    Path::new("out").join(command)
}
