//! `discover`: where simulation and measurements disagree, which effect the model lacks, the wing with it, and the gap
//! before and after.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use calibrate::{Campaign, Schedule, Settings, Use, calibrate};
use discover::analysis::{DiscoverError, Prepared, Report, Rigs};
use discover::data::Dataset;
use discover::data_checks::Defect;
use discover::detection_limit::DetectionLimit;
use discover::model_form::LatticeVariant;
use discover::next::{Advice, advise};
use discover::null_distribution::{NullDistribution, key};
use discover::rules::Rules;
use discover::simulator::Simulator;
use maneuver::effects::Active;
use nastran::InputError;

use crate::args::{Common, DiscoverArgs};
use crate::commands::discover_again::{Again, calibrated};
use crate::commands::{discover_figures, discover_located, discover_results};
use crate::corrections::{CorrectedWing, campaign_path, corrected_wing, schedule};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{paths, show};

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

/// What a run of the command knows at its end.
pub(crate) struct Discovered<'a> {
    /// The wing.
    pub(crate) corrected: &'a CorrectedWing,
    /// The campaign.
    pub(crate) campaign: &'a Campaign,
    /// Data and model.
    pub(crate) prepared: &'a Prepared,
    /// Thresholds.
    pub(crate) limits: &'a NullDistribution,
    /// Where the thresholds come from.
    pub(crate) nulls_from: String,
    /// What was found; the gaps after are with corrections calibrated again where that was done.
    pub(crate) report: Report<'a>,
    /// Corrections calibrated again beside the effects.
    pub(crate) again: Option<Again>,
    /// Whether the corrections are the campaign's own: then what is shown after is with those calibrated again.
    pub(crate) own: bool,
    /// Experiments that would separate what is left open, the best first.
    pub(crate) advice: Vec<Advice>,
    /// What of every effect would have been named, where none is.
    pub(crate) detection_limits: Vec<DetectionLimit>,
    /// Fingerprint of the data.
    pub(crate) data_hash: String,
}

impl Discovered<'_> {
    /// The wing as flown before, without effects.
    pub(crate) fn before(&self) -> (&Simulator, &[Active]) {
        (&self.prepared.simulator, &[])
    }

    /// The wing with the effects as flown after, and the effects.
    pub(crate) fn after(&self) -> (&Simulator, &[Active]) {
        let again = self.again.as_ref().filter(|_| self.own).map(|again| &again.simulator);
        (again.unwrap_or(&self.prepared.simulator), &self.report.current.effects)
    }
}

/// Runs the command.
pub(crate) fn run(args: &DiscoverArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let folder = campaign_path(args.campaign.as_deref());
    let campaign = Campaign::read(&folder)?;
    let corrected =
        corrected_wing(args.wing.as_deref(), args.corrections.as_deref(), args.campaign.as_deref(), common)?;
    if !corrected.file.effects.is_empty() {
        let message = "the wing has effects already; the search starts from a wing without them";
        return Err(InputError::in_field(&corrected.file.path, "effects", message)
            .with_help("take the list of effects out of a copy of the wing's file")
            .into());
    }
    let own = args.corrections.is_none() || args.own_corrections;
    let rules = Rules::default();
    let corrected = if own { without_held_out(corrected, &campaign, &rules)? } else { corrected };
    let lattice = LatticeVariant::of(&corrected.file, &corrected.wing, &rules.variants);
    let rigs = Rigs::new(&corrected.file, &corrected.wing, lattice.as_ref(), rules)?;
    let prepared = Prepared::new(&rigs, &corrected.schedule, &campaign, own)?;
    let out = common.out("discover");
    let faults = prepared.defects();
    if !faults.is_empty() {
        return refuse(&faults, &out, common, start.elapsed().as_secs_f64());
    }
    let seed = common.seed.unwrap_or(1);
    let (limits, nulls_from) = thresholds(args, &corrected, &prepared, common, seed)?;
    let report = prepared.search(&limits, seed);
    let open = report.outcome.found.iter().position(|found| !found.rivals.is_empty());
    let advice = match open {
        Some(open) => advise(&rigs, &corrected.schedule, &prepared, &report.outcome.found, open)?,
        None => Vec::new(),
    };
    let data_hash = data_hash(&campaign)?;
    let mut found = Discovered {
        corrected: &corrected,
        campaign: &campaign,
        prepared: &prepared,
        limits: &limits,
        nulls_from,
        detection_limits: prepared.detection_limits(&report, &limits),
        report,
        again: None,
        own,
        advice,
        data_hash,
    };
    if !found.report.current.effects.is_empty() {
        calibrate_again(&mut found, &rigs)?;
    }
    let seconds = start.elapsed().as_secs_f64();
    let map = discover_located::maps(&found);
    let bands_hz = &prepared.data.rules.locate.bands_hz;
    let mut result = discover_results::json(&found, &discover_located::json(&found), seconds);
    result["map"] = discover_located::map_json(bands_hz, &map).into();
    let results = ResultFolder::begin(&out)?;
    corrected.note_inputs(&results)?;
    results.input("campaign", &campaign.folder)?;
    write_wing(&found, &results)?;
    results.write_json("result.json", &result)?;
    results.write_text("null_distribution.ron", &nastran::ron_file::to_text(&limits)?)?;
    results.write_text("map.csv", &discover_located::map_csv(bands_hz, &map))?;
    discover_figures::write(&found, &results)?;
    results.commit()?;
    show::summary(common, &discover_results::summary(&found, &out, seconds));
    show::json(common, &result)
}

/// An airspeed that is held out leaves its static points out of the calibration, too.
fn without_held_out(
    corrected: CorrectedWing,
    campaign: &Campaign,
    rules: &Rules,
) -> Result<CorrectedWing, Failure> {
    let held_out = held_out_points(&Dataset::read(campaign, &corrected.wing, &Arc::new(rules.clone()))?);
    if held_out.is_empty() {
        return Ok(corrected);
    }
    let mut kept = campaign.clone();
    leave_out(&mut kept, &held_out);
    let calibration = calibrate(&corrected.wing, &kept, &Settings::of_wing(&corrected.file.correction))?;
    Ok(CorrectedWing {
        schedule: schedule(&corrected.file, &calibration),
        origin: "calibrated without the static points of held-out airspeeds".to_owned(),
        ..corrected
    })
}

/// Places of the static points whose airspeed is held out.
pub(crate) fn held_out_points(data: &Dataset) -> Vec<usize> {
    let groups = data.statics.iter().filter(|group| group.usage == Use::Holdout);
    groups.flat_map(|group| group.points.iter().copied()).collect()
}

pub(crate) fn leave_out(campaign: &mut Campaign, points: &[usize]) {
    let mut place = 0..;
    campaign.points.retain(|_| place.next().is_some_and(|place| !points.contains(&place)));
}

/// Data at fault end the command with status 3; what was found is written all the same.
fn refuse(found: &[Defect], out: &Path, common: &Common, seconds: f64) -> Result<(), Failure> {
    let result = discover_results::defects(found, seconds);
    let results = ResultFolder::begin(out)?;
    results.write_json("result.json", &result)?;
    results.commit()?;
    show::json(common, &result)?;
    let sentences: Vec<&str> = found.iter().map(|defect| defect.sentence.as_str()).collect();
    Err(Failure::Computation(format!("the data are at fault: {}", sentences.join("; "))))
}

/// The given or shipped one if it belongs to this wing and campaign, else from campaigns without effect, made now.
fn thresholds(
    args: &DiscoverArgs,
    corrected: &CorrectedWing,
    prepared: &Prepared,
    common: &Common,
    seed: u64,
) -> Result<(NullDistribution, String), Failure> {
    let wanted = key(&corrected.file.hash, &prepared.data);
    if args.bank.is_some() && !common.quiet {
        show::note("--bank is called --null-distribution now; the old name is read for one version");
    }
    let given = args.null_distribution.as_ref().or(args.bank.as_ref());
    let shipped = paths::in_repository("data/tuflex/null_distribution.ron");
    let last = paths::in_repository("out/discover/null_distribution.ron");
    if let Some(path) = given {
        let nulls: NullDistribution = nastran::ron_file::read(path)?;
        if nulls.key != wanted {
            let message = "this null distribution belongs to another wing or campaign";
            return Err(InputError::in_file(path, message)
                .with_help("leave --null-distribution out to have it made for this one")
                .into());
        }
        return Ok((nulls, path.display().to_string()));
    }
    for path in [shipped, last] {
        let nulls: Option<NullDistribution> = nastran::ron_file::read(&path).ok();
        if let Some(nulls) = nulls.filter(|nulls| nulls.key == wanted) {
            return Ok((nulls, path.display().to_string()));
        }
    }
    if !common.quiet {
        show::note("no null distribution for this wing and campaign: made now (a minute or so)");
    }
    let mut nulls = prepared.thresholds(seed);
    nulls.key = wanted;
    Ok((nulls, "made now".to_owned()))
}

/// Calibrates again beside the effects. Where the corrections are the campaign's own, the gap after is the one with these, as
/// later steps have it.
fn calibrate_again(found: &mut Discovered<'_>, rigs: &Rigs<'_>) -> Result<(), Failure> {
    let effects = &found.report.current.effects;
    let again = calibrated((found.corrected, rigs), found.campaign, found.prepared, effects)?;
    if found.own {
        let after = found.prepared.gaps_of(&again.simulator, effects);
        for (gaps, after) in found.report.gaps.iter_mut().zip(after) {
            gaps[1] = after;
        }
    }
    found.again = Some(again);
    Ok(())
}

/// The wing with the effects that the data support, and its corrections calibrated again beside them.
fn write_wing(found: &Discovered<'_>, results: &ResultFolder) -> Result<(), Failure> {
    let supported = discover_results::is_supported(found);
    let effects = if supported { discover_results::effects(found) } else { Vec::new() };
    let rewritten = found.corrected.file.with_effects(effects)?;
    results.write_text("wing.ron", &rewritten.text)?;
    for (name, from) in &rewritten.beside {
        results.write_text(name, &nastran::read_text(from)?)?;
    }
    let wing = coupling::WingFile::read(&results.path().join("wing.ron"))?;
    let again = found.again.as_ref().filter(|_| supported).map(|again| &again.schedule);
    let sets = again.unwrap_or(&found.corrected.schedule).sets.clone();
    results.write_text("corrections.ron", &Schedule { wing: wing.name, wing_hash: wing.hash, sets }.to_ron())
}

fn data_hash(campaign: &Campaign) -> Result<String, InputError> {
    let mut files = vec![campaign.folder.join("campaign.ron"), campaign.folder.join("static.csv")];
    files.extend(campaign.runs.iter().map(|run| campaign.folder.join(&run.file)));
    let texts = files.iter().filter(|file| file.is_file()).map(|file: &PathBuf| nastran::read_text(file));
    Ok(coupling::wing_file::fingerprint(&texts.collect::<Result<Vec<_>, _>>()?.concat()))
}

/// Whether a run judges.
pub(crate) fn is_held_out(usage: Use) -> bool {
    usage == Use::Holdout
}
