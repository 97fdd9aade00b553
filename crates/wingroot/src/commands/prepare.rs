//! `prepare`: what all cases of a sweep share, once.

use clap::Args;

use crate::args::Common;
use crate::commands::swept::Swept;
use crate::failure::Failure;
use crate::sweep::Stage;

/// Options of `prepare`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot prepare fullaircraft --cases data/tuflex/cases.ron
  wingroot prepare loads --plan data/tuflex/loads.ron
  wingroot prepare hidden --cases 600 --seed 2000000

Before many processes take parts of a sweep (--part K/N): checks all input, computes what all cases need.")]
pub struct PrepareArgs {
    /// The sweep: the command that computes it, with its options
    #[command(subcommand)]
    pub(crate) what: Swept,
}

/// Runs the command.
pub(crate) fn run(args: &PrepareArgs, common: &Common) -> Result<(), Failure> {
    args.what.run(Stage::Prepare, common)
}
