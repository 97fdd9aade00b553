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
use discover::null_distribution::NullDistribution;
use discover::recalibration::{recalibrated, without_held_out};
use discover::result::DiscoverResult;
use discover::rules::Rules;
use nastran::InputError;
use nastran::ron_or_json::expected_in;

use crate::args::{Common, Given};
use crate::commands::{discover_figures, discover_results};
use crate::corrections::{CorrectedWing, corrected_wing};
use crate::ensemble::write_corrections;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::paths::folder_of;
use crate::store::Store;
use crate::{kept_nulls, show};

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
        return refuse(faults, &out, common, start.elapsed().as_secs_f64());
    }
    let seed = common.seed.unwrap_or(1);
    let (nulls, nulls_from) = null_distribution(args, &corrected, &prepared, common, seed)?;
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

/// Data at fault end the command with status 3; what was found is written all the same.
fn refuse(faults: Vec<Defect>, out: &Path, common: &Common, seconds: f64) -> Result<(), Failure> {
    let sentences: Vec<String> = faults.iter().map(|defect| defect.sentence.clone()).collect();
    let result = DiscoverResult::at_fault(faults, None, seconds);
    let results = ResultFolder::begin(out)?;
    results.write_json("result.json", &result)?;
    results.commit_incomplete()?;
    show::json(common, &result)?;
    Err(Failure::Computation(format!("the data are at fault: {}", sentences.join("; "))))
}

/// The given or shipped one if it belongs to this wing and campaign, else from campaigns without effect, made now.
fn null_distribution(
    args: &DiscoverArgs,
    corrected: &CorrectedWing,
    prepared: &Prepared,
    common: &Common,
    seed: u64,
) -> Result<(NullDistribution, String), Failure> {
    let wanted = prepared.null_key(&corrected.file.hash, &corrected.schedule);
    let serves = |nulls: &NullDistribution| nulls.serves(&wanted, &prepared.library);
    if args.bank.is_some() && !common.quiet {
        show::note("--bank is called --null-distribution now; the old name is read for one version");
    }
    let given = args.null_distribution.as_ref().or(args.bank.as_ref());
    let beside = expected_in(folder_of(&corrected.file.path), "null_distribution")?;
    let last = crate::common::results("discover").join("null_distribution.ron");
    if let Some(path) = given {
        let nulls: NullDistribution = nastran::ron_file::read(path)?;
        if !serves(&nulls) {
            let differs = nulls.key.differs_in(&wanted);
            let of = if differs.is_empty() {
                "lacks effects of the library".to_owned()
            } else {
                format!("does not fit; what differs: {}", differs.join(", "))
            };
            let message = format!("this null distribution {of}");
            return Err(InputError::in_file(path, message)
                .with_help("leave --null-distribution out to have it made for this one")
                .into());
        }
        return Ok((nulls, path.display().to_string()));
    }
    for path in [beside, last] {
        let nulls: Option<NullDistribution> = nastran::ron_file::read(&path).ok();
        if let Some(nulls) = nulls.filter(serves) {
            return Ok((nulls, path.display().to_string()));
        }
    }
    if !common.quiet {
        show::note(
            "no null distribution for this wing, campaign and library of effects: made now (a minute or so)",
        );
    }
    let store = Store::beside(&common.out("discover"), &format!("null campaigns {seed} {wanted:?}"))?;
    let mut nulls = kept_nulls::null_distribution(prepared, seed, store, common);
    nulls.key = wanted;
    Ok((nulls, "made now".to_owned()))
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
