//! `merge`: the results of a sweep, from what its parts kept.

use clap::Args;

use crate::args::Common;
use crate::commands::swept::Swept;
use crate::failure::Failure;
use crate::sweep::Stage;

/// Options of `merge`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  wingroot merge fullaircraft --cases data/tuflex/cases.ron
  wingroot merge hidden --cases 600 --seed 2000000

Refuses parts of another state of an input or of another program, and names cases that are missing with the lines
that compute them. The files are those of one process, byte for byte on one type of processor.")]
pub struct MergeArgs {
    /// The sweep: the command that computes it, with its options
    #[command(subcommand)]
    pub(crate) what: Swept,
}

/// Runs the command.
pub(crate) fn run(args: &MergeArgs, common: &Common) -> Result<(), Failure> {
    args.what.run(Stage::Merge, common)
}
