//! `discover`: where simulation and measurements disagree, which effect the model lacks, the wing with it, and the gap
//! before and after.

use clap::Args;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use calibrate::{Campaign, Schedule};
use discover::analysis::{DiscoverError, Prepared, Rigs};
use discover::data::Dataset;
use discover::data_checks::Defect;
use discover::finding::{Finding, Sources};
use discover::model_form::LatticeVariant;
use discover::recalibration::{recalibrated, without_held_out};
use discover::result::DiscoverResult;
use discover::rules::Rules;
use nastran::InputError;

use crate::args::{Common, Given};
use crate::commands::discover_nulls::Asked;
use crate::commands::{discover_figures, discover_results};
use crate::corrections::{CorrectedWing, corrected_wing};
use crate::ensemble::write_corrections;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;
use crate::sweep::{SweepArgs, Task};

/// Options of `discover`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot discover
  wingroot discover --wing my/wing.ron --campaign my/measured

Static points and training runs are searched for effects that the model lacks; held-out runs only judge. Defects of the data
stop the search (exit status 3). Written: wing.ron (the wing with the effects), corrections.ron (calibrated again with
them), null_distribution.ron (log Bayes factors where no effect is missing), runs/NAME.csv and .svg of held-out runs, result.json.")]
pub struct DiscoverArgs {
    /// Wing, measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
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
    let folder = args.given.measured.campaign_path()?;
    let campaign = Campaign::read(&folder)?;
    let corrected = corrected_wing(&args.given)?;
    if !corrected.file.effects.is_empty() {
        let message = "the wing has effects already; the search starts from a wing without them";
        return Err(InputError::in_field(&corrected.file.path, "effects", message)
            .with_help("take the list of effects out of a copy of the wing's file")
            .into());
    }
    let own = args.given.corrections.is_none() || args.own_corrections;
    let rules = Rules::default();
    let corrected = if own { without_held_out_points(corrected, &campaign, &rules)? } else { corrected };
    let lattice = LatticeVariant::of(&corrected.file, &corrected.wing, &rules.variants);
    let rigs = Rigs::new(&corrected.file, &corrected.wing, lattice.as_ref(), rules)?;
    let prepared = Prepared::new(&rigs, &corrected.schedule, &campaign, own)?;
    let out = common.out("discover");
    let faults = prepared.defects();
    if !faults.is_empty() {
        return refuse(faults, task, &out, common, start.elapsed().as_secs_f64());
    }
    let seed = common.seed.unwrap_or(1);
    if args.bank.is_some() && !common.quiet {
        show::note("--bank is called --null-distribution now; the old name is read for one version");
    }
    let named = args.null_distribution.as_ref().or(args.bank.as_ref());
    let estimate = &args.sweep.estimate;
    let asked = Asked { named, corrected: &corrected, prepared: &prepared, common, seed, start, estimate };
    let Some((nulls, nulls_from)) = asked.null_distribution(task)? else { return Ok(()) };
    let mut finding = Finding::search(&prepared, &nulls, seed);
    finding.look_further(&rigs, &corrected.schedule)?;
    let sources = Sources {
        corrections: corrected.origin.clone(),
        null_distribution: nulls_from,
        data_hash: data_hash(&campaign)?,
    };
    if !finding.report.current.effects.is_empty() {
        let effects = &finding.report.current.effects;
        let again = recalibrated(&rigs, &campaign, &prepared, effects, |left| corrected.calibrated(left))?;
        finding.recalibrate(again);
    }
    let seconds = start.elapsed().as_secs_f64();
    let result = finding.result(&sources, true, seconds);
    let results = ResultFolder::begin(&out)?;
    corrected.note_inputs(&results)?;
    results.input("campaign", &campaign.folder)?;
    write_wing(&finding, &corrected, &sources.data_hash, &results)?;
    results.write_json("result.json", &result)?;
    results.write_text("null_distribution.ron", &nastran::ron_file::to_text(&nulls)?)?;
    let map = result.search.as_ref().and_then(|search| search.map.as_deref());
    results.write_text("map.csv", &discover_results::map_csv(map.unwrap_or_default()))?;
    discover_figures::write(&finding, &results)?;
    results.commit()?;
    show::summary(common, &discover_results::summary(&finding, &out, seconds));
    show::json(common, &result)
}

/// An airspeed that is held out leaves its static points out of the calibration, too.
fn without_held_out_points(
    corrected: CorrectedWing,
    campaign: &Campaign,
    rules: &Rules,
) -> Result<CorrectedWing, Failure> {
    let data = Dataset::read(campaign, &corrected.wing, &Arc::new(rules.clone()))?;
    let Some(kept) = without_held_out(campaign, &data) else { return Ok(corrected) };
    Ok(CorrectedWing {
        schedule: corrected.calibrated(&kept)?,
        origin: "calibrated without the static points of held-out airspeeds".to_owned(),
        ensemble: None,
        ..corrected
    })
}

/// Data at fault end the command with status 3; what was found is written all the same, unless this is one process of many.
fn refuse(faults: Vec<Defect>, task: Task, out: &Path, common: &Common, seconds: f64) -> Result<(), Failure> {
    let sentences: Vec<String> = faults.iter().map(|defect| defect.sentence.clone()).collect();
    let failure = Failure::Computation(format!("the data are at fault: {}", sentences.join("; ")));
    if !matches!(task, Task::All | Task::Merge) {
        return Err(failure);
    }
    let result = DiscoverResult::at_fault(faults, None, seconds);
    let results = ResultFolder::begin(out)?;
    results.write_json("result.json", &result)?;
    results.commit_incomplete()?;
    show::json(common, &result)?;
    Err(failure)
}

/// The wing with the effects that the data support, and its corrections calibrated again beside them.
fn write_wing(
    finding: &Finding<'_>,
    corrected: &CorrectedWing,
    data_hash: &str,
    results: &ResultFolder,
) -> Result<(), Failure> {
    let rewritten = corrected.file.with_effects(finding.wing_effects(data_hash))?;
    let name = corrected.file.written_name();
    results.write_text(name, &rewritten.text)?;
    for (name, from) in &rewritten.beside {
        results.write_text(name, &nastran::read_text(from)?)?;
    }
    let wing = coupling::WingFile::read(&results.path().join(name))?;
    let again = finding.recalibrated.as_ref().map(|again| &again.schedule);
    let Schedule { sets, unconverged, .. } = again.unwrap_or(&corrected.schedule).clone();
    let schedule = Schedule { wing: wing.name, wing_hash: wing.hash, sets, unconverged };
    write_corrections(results, corrected, &schedule, &[])
}

fn data_hash(campaign: &Campaign) -> Result<String, InputError> {
    let mut files = vec![campaign.path.clone(), campaign.folder.join("static.csv")];
    files.extend(campaign.runs.iter().map(|run| campaign.folder.join(&run.file)));
    let texts = files.iter().filter(|file| file.is_file()).map(|file: &PathBuf| nastran::read_text(file));
    Ok(coupling::wing_file::fingerprint(&texts.collect::<Result<Vec<_>, _>>()?.concat()))
}
