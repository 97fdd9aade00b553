//! Options of `discover` and of its blind benchmark.

use std::path::PathBuf;

use clap::Args;

/// Options of `hidden`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask hidden --cases 20
  cargo xtask hidden --cases 600 --seed 2000000

Seeds below 1000000 are for development, below 2000000 for thresholds, from there for tests. Verdicts are
kept in out/hidden.cases and answers in out/hidden.sealed, so that a run that was stopped goes on; remove both to begin anew,
as after a change of `discover`.")]
pub struct HiddenArgs {
    /// Number of cases
    #[arg(long, value_name = "N", default_value_t = 40)]
    pub cases: usize,
    /// Calibrate each case on its own static points, as a user does (track B), instead of effect-free ones
    #[arg(long)]
    pub own_static_points: bool,
    /// Judge no case, score those that were judged before
    #[arg(long)]
    pub finished: bool,
}

/// Options of `discover`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask discover
  cargo xtask discover --wing my/wing.ron --campaign my/measured

Static points and training runs are searched for effects that the model lacks; held-out runs only judge. Defects of the data
stop the search (exit status 3). Written: wing.ron (the wing with the effects), corrections.ron (calibrated again with
them), null_distribution.ron (log Bayes factors where no effect is missing), runs/NAME.csv and .svg of held-out runs, result.json.")]
pub struct DiscoverArgs {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// The folder of measurements [default: data/tuflex/measured]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
    /// Corrections found with other data than this campaign's [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
    /// Whether `corrections` come from this campaign's own static points all the same: the pipeline's do
    #[arg(skip)]
    pub own_corrections: bool,
    /// A null distribution (null_distribution.ron of an earlier run) [default: the shipped or last one if of the same wing and
    /// campaign, else made first]
    #[arg(long, value_name = "FILE")]
    pub null_distribution: Option<PathBuf>,
    /// What `null_distribution` was called before
    #[arg(long, value_name = "FILE", hide = true, conflicts_with = "null_distribution")]
    pub bank: Option<PathBuf>,
}
