//! `discover`: where simulation and measurements disagree, which effect the model lacks, the wing with it, and the gap
//! before and after.

use clap::Args;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use calibrate::Campaign;
use discover::analysis::{DiscoverError, Prepared, Rigs};
use discover::data::Dataset;
use discover::model_form::LatticeVariant;
use discover::recalibration::without_held_out;
use discover::rules::Rules;
use nastran::InputError;

use crate::args::{Common, Given};
use crate::commands::discover_campaigns;
use crate::commands::discover_nulls::Asked;
use crate::commands::discover_search::{Searched, check_without_effects, refuse, seed};
use crate::corrections::{CorrectedWing, as_given, corrected_wing};
use crate::failure::Failure;
use crate::show;
use crate::sweep::{SweepArgs, Task};

/// Options of `discover`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot discover
  wingroot discover --wing my/wing.ron --campaign my/measured
  wingroot discover --wing my/wing.ron --campaigns my/weeks

Static points and training runs are searched for effects that the model lacks; held-out runs only judge. Defects of the data
stop the search (exit status 3). Written: wing.ron (the wing with the effects), corrections.ron (calibrated again with
them), null_distribution.ron (log Bayes factors where no effect is missing), runs/NAME.csv and .svg of held-out runs, result.json.
With --campaigns these go to out/discover_campaigns.each/NAME, and out/discover_campaigns has campaigns.csv and result.json.")]
pub struct DiscoverArgs {
    /// Wing, measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
    /// Search every campaign in a folder, set up once: each is calibrated with its own static points, unless --corrections names others
    #[arg(long, value_name = "DIR", conflicts_with_all = ["campaign", "own_corrections", "null_distribution"])]
    pub(crate) campaigns: Option<PathBuf>,
    /// Whether `corrections` come from this campaign's own static points all the same: the pipeline's and Python's do
    #[arg(long, hide = true, requires = "corrections")]
    pub(crate) own_corrections: bool,
    /// A null distribution (null_distribution.ron of an earlier run) [default: the one beside the wing or the last one if of the same wing and
    /// campaign, else made first]
    #[arg(long, value_name = "FILE")]
    pub(crate) null_distribution: Option<PathBuf>,
    /// What `null_distribution` was called before
    #[arg(long, value_name = "FILE", hide = true, conflicts_with = "null_distribution")]
    pub(crate) bank: Option<PathBuf>,
    /// Which of the null campaigns: a process that has a share of them keeps it for `merge discover`
    #[command(flatten)]
    pub(crate) sweep: SweepArgs,
}

impl From<DiscoverError> for Failure {
    fn from(error: DiscoverError) -> Self {
        match error {
            DiscoverError::Input(input) => Self::Input(input),
            DiscoverError::Noise(unknown) => InputError::general(unknown.to_string())
                .with_help("state the noise in campaign.ron, or name in `repeat_of` which run a run repeats")
                .into(),
            DiscoverError::Simulator(other) => Self::computation(other),
        }
    }
}

/// Runs the command.
pub(crate) fn run(args: &DiscoverArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let task = args.sweep.task_by_parts()?;
    if let Some(folder) = &args.campaigns {
        if task == Task::All {
            return discover_campaigns::run(&args.given, folder, common);
        }
        return Err(InputError::general("--campaigns is no sweep: one process searches all campaigns")
            .with_help("give each process a --campaign of its own")
            .into());
    }
    let folder = args.given.measured.campaign_path()?;
    let campaign = Campaign::read(&folder)?;
    let corrected = corrected_wing(&args.given)?;
    as_given(&corrected.schedule);
    check_without_effects(&corrected.file)?;
    let own = args.given.corrections.is_none() || args.own_corrections;
    let rules = Rules::default();
    let data = Dataset::read(&campaign, &corrected.wing, &Arc::new(rules.clone()))?;
    let corrected = if own { without_held_out_points(corrected, &campaign, &data)? } else { corrected };
    let lattice = LatticeVariant::of(&corrected.file, &corrected.wing, &rules.variants);
    let rigs = Rigs::new(&corrected.file, &corrected.wing, lattice.as_ref(), rules)?;
    let prepared = Prepared::of_data(&rigs, &corrected.schedule, data, own)?;
    let out = common.out("discover");
    let faults = prepared.defects();
    if !faults.is_empty() {
        let said: Vec<String> = faults.iter().map(|defect| defect.sentence.clone()).collect();
        // one process of many writes nothing
        if matches!(task, Task::All | Task::Merge) {
            let result = refuse(faults, &out, start.elapsed().as_secs_f64())?;
            show::json(common, &result)?;
        }
        return Err(Failure::Computation(format!("the data are at fault: {}", said.join("; "))));
    }
    let seed = seed(common);
    if args.bank.is_some() && !common.quiet {
        show::note("--bank is called --null-distribution now; the old name is read for one version");
    }
    let named = args.null_distribution.as_ref().or(args.bank.as_ref());
    let estimate = &args.sweep.estimate;
    let asked = Asked { named, corrected: &corrected, prepared: &prepared, common, seed, start, estimate };
    let Some(nulls) = asked.null_distribution(task)? else { return Ok(()) };
    let (result, text) = Searched {
        corrected: &corrected,
        rigs: &rigs,
        campaign: &campaign,
        prepared: &prepared,
        nulls: &nulls,
    }
    .written(&out, common, start)?;
    show::summary(common, &text);
    show::json(common, &result)
}

/// An airspeed that is held out leaves its static points out of the calibration, too.
fn without_held_out_points(
    corrected: CorrectedWing,
    campaign: &Campaign,
    data: &Dataset,
) -> Result<CorrectedWing, Failure> {
    let Some(kept) = without_held_out(campaign, data) else { return Ok(corrected) };
    Ok(CorrectedWing {
        schedule: corrected.calibrated(&kept)?,
        origin: "calibrated without the static points of held-out airspeeds".to_owned(),
        ensemble: None,
        ..corrected
    })
}
