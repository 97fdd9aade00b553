//! Commands that go over many cases, as `prepare`, `merge` and `status` name them.

use clap::Subcommand;
use nastran::InputError;

use crate::args::Common;
use crate::commands::discover::{self, DiscoverArgs};
use crate::commands::fullaircraft;
use crate::commands::fullaircraft_prepared::FullaircraftArgs;
use crate::commands::hidden::{self, HiddenArgs};
use crate::commands::loads::{self, LoadsArgs};
use crate::failure::Failure;
use crate::sweep::estimate::{Estimate, Slot};
use crate::sweep::{Stage, SweepArgs};

/// A sweep: the command that computes its cases, with the same options.
#[derive(Debug, Clone, Subcommand)]
pub(crate) enum Swept {
    /// The grid of flight cases of `fullaircraft --cases`
    Fullaircraft(FullaircraftArgs),
    /// The cases of a plan of design loads
    Loads(LoadsArgs),
    /// The null campaigns of `discover`
    Discover(DiscoverArgs),
    /// The blind benchmark of `discover`
    Hidden(HiddenArgs),
}

impl Swept {
    /// Runs the command with another task.
    pub(crate) fn run(&self, stage: Stage, common: &Common) -> Result<(), Failure> {
        self.run_with(&|sweep: &SweepArgs| SweepArgs { stage, ..sweep.clone() }, common)
    }

    /// A few cases computed, and what the others will take.
    pub(crate) fn estimate(&self, common: &Common) -> Result<Estimate, Failure> {
        let slot = Slot::default();
        let common = Common { json: false, quiet: true, ..common.clone() };
        let sweep =
            |sweep: &SweepArgs| SweepArgs { stage: Stage::Estimate, estimate: slot.clone(), ..sweep.clone() };
        self.run_with(&sweep, &common)?;
        slot.take().ok_or_else(|| Failure::computation("no case could be computed for an estimate"))
    }

    fn run_with(&self, sweep: &dyn Fn(&SweepArgs) -> SweepArgs, common: &Common) -> Result<(), Failure> {
        match self {
            Self::Fullaircraft(args) if args.cases.is_none() => {
                let error =
                    InputError::general("`fullaircraft` goes over many cases with --cases FILE.ron only");
                Err(error.with_help("name the file of the cases").into())
            }
            Self::Fullaircraft(args) => {
                fullaircraft::run(&FullaircraftArgs { sweep: sweep(&args.sweep), ..args.clone() }, common)
            }
            Self::Loads(args) if args.matrix_only || args.from.is_some() => {
                let error = InputError::general("with these options `loads` flies no case");
                Err(error.with_help("leave out --matrix-only and --from").into())
            }
            Self::Loads(args) => loads::run(&LoadsArgs { sweep: sweep(&args.sweep), ..args.clone() }, common),
            Self::Discover(args) => {
                discover::run(&DiscoverArgs { sweep: sweep(&args.sweep), ..args.clone() }, common)
            }
            Self::Hidden(args) => {
                hidden::run(&HiddenArgs { sweep: sweep(&args.sweep), ..args.clone() }, common)
            }
        }
    }

    /// The folder of results.
    pub(crate) fn results(&self) -> &'static str {
        match self {
            Self::Fullaircraft(args) => args.results(),
            Self::Loads(args) => args.results(),
            Self::Discover(_) => "discover",
            Self::Hidden(args) => args.truth.folder(),
        }
    }
}
