//! `status`: how far a sweep is.

use clap::Args;

use crate::args::Common;
use crate::commands::swept::Swept;
use crate::failure::Failure;
use crate::sweep::Stage;

/// Options of `status`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot status fullaircraft --cases data/tuflex/cases.ron
  wingroot status hidden --cases 600 --seed 2000000

Finished cases and what the others will take, failures with the option that repeats one alone, the slowest cases.")]
pub struct StatusArgs {
    /// The sweep: the command that computes it, with its options
    #[command(subcommand)]
    pub(crate) what: Swept,
}

/// Runs the command.
pub(crate) fn run(args: &StatusArgs, common: &Common) -> Result<(), Failure> {
    args.what.run(Stage::Status, common)
}
