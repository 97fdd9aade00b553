//! `discover`: where simulation and measurements disagree, which effect the model lacks, the wing with it, and the gap
//! before and after.

use std::path::{Path, PathBuf};
use std::time::Instant;

use calibrate::{Campaign, Settings, Use, calibrate};
use discover::analysis::{DiscoverError, Prepared, Report, Rigs};
use discover::bank::{Thresholds, key};
use discover::data::Dataset;
use discover::gate::{Defect, defects};
use discover::next::{Advice, advise};
use discover::numerics::OtherLattice;
use discover::simulator::Simulator;
use maneuver::effects::Flown;
use nastran::InputError;

use crate::args::{Common, DiscoverArgs};
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
    pub(crate) limits: &'a Thresholds,
    /// Where the thresholds come from.
    pub(crate) bank: String,
    /// What was found.
    pub(crate) report: Report,
    /// Experiments that would separate what is left open, the best first.
    pub(crate) advice: Vec<Advice>,
    /// Fingerprint of the data.
    pub(crate) data_hash: String,
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
    let corrected = if own { without_held_out(corrected, &campaign)? } else { corrected };
    let lattice = OtherLattice::of(&corrected.file, &corrected.wing);
    let rigs = Rigs::new(&corrected.file, &corrected.wing, lattice.as_ref())?;
    let prepared = Prepared::new(&rigs, &corrected.schedule, &campaign, own)?;
    let out = common.out("discover");
    if let Some(found) = faults(&prepared) {
        return refuse(&found, &out, common, start.elapsed().as_secs_f64());
    }
    let seed = common.seed.unwrap_or(1);
    let (limits, bank) = thresholds(args, &corrected, &prepared, common, seed)?;
    let report = prepared.search(&limits, seed);
    let open = report.outcome.found.iter().position(|found| !found.rivals.is_empty());
    let advice = match open {
        Some(open) => advise(&rigs, &corrected.schedule, &prepared, (&report.outcome.found, open))?,
        None => Vec::new(),
    };
    let data_hash = data_hash(&campaign)?;
    let mut found = Discovered {
        corrected: &corrected,
        campaign: &campaign,
        prepared: &prepared,
        limits: &limits,
        bank,
        report,
        advice,
        data_hash,
    };
    if own && !found.report.level.effects.is_empty() {
        calibrated_again(&mut found, &rigs)?;
    }
    let seconds = start.elapsed().as_secs_f64();
    let result = discover_results::json(&found, &discover_located::json(&found), seconds);
    let results = ResultFolder::begin(&out)?;
    corrected.note_inputs(&results)?;
    results.input("campaign", &campaign.folder)?;
    write_wing(&found, &results)?;
    results.write_json("result.json", &result)?;
    results.write_text("null_bank.ron", &nastran::ron_file::to_text(&limits)?)?;
    results.write_text("map.csv", &discover_located::map_csv(&found))?;
    discover_figures::write(&found, &results)?;
    results.commit()?;
    show::summary(common, &discover_results::summary(&found, &out, seconds));
    show::json(common, &result)
}

/// An airspeed that is held out leaves its static points out of the calibration, too.
fn without_held_out(corrected: CorrectedWing, campaign: &Campaign) -> Result<CorrectedWing, Failure> {
    let held_out = held_out_points(&Dataset::read(campaign, &corrected.wing)?);
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
fn held_out_points(data: &Dataset) -> Vec<usize> {
    let groups = data.statics.iter().filter(|group| group.usage == Use::Holdout);
    groups.flat_map(|group| group.points.iter().copied()).collect()
}

fn leave_out(campaign: &mut Campaign, points: &[usize]) {
    let mut place = 0..;
    campaign.points.retain(|_| place.next().is_some_and(|place| !points.contains(&place)));
}

/// Data defects, judged before anything is searched.
pub(crate) fn faults(prepared: &Prepared) -> Option<Vec<Defect>> {
    let (data, simulator) = (&prepared.data, &prepared.simulator);
    let all: Vec<usize> = (0..data.statics.len() + data.runs.len()).collect();
    let flown: Vec<Flown> = simulator.fly(&simulator.models(&[], None), &[], &all);
    let sigma: Vec<[f64; 3]> = data
        .statics
        .iter()
        .map(|_| prepared.noise.point)
        .chain(
            data.runs.iter().map(|run| std::array::from_fn(|c| prepared.noise.sigma(run.airspeed, c, 1.0))),
        )
        .collect();
    let found = defects(data, &flown, &sigma);
    (!found.is_empty()).then_some(found)
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

/// From the given or shipped bank if it belongs to this wing and campaign, else from campaigns without effect, made now.
fn thresholds(
    args: &DiscoverArgs,
    corrected: &CorrectedWing,
    prepared: &Prepared,
    common: &Common,
    seed: u64,
) -> Result<(Thresholds, String), Failure> {
    let wanted = key(&corrected.file.hash, &prepared.data);
    let given = args.bank.clone();
    let shipped = paths::in_repository("data/tuflex/null_bank.ron");
    let last = paths::in_repository("out/discover/null_bank.ron");
    if let Some(path) = &given {
        let bank: Thresholds = nastran::ron_file::read(path)?;
        if bank.key != wanted {
            let message = "this bank of null campaigns belongs to another wing or campaign";
            return Err(InputError::in_file(path, message)
                .with_help("leave --bank out to have it made for this one")
                .into());
        }
        return Ok((bank, path.display().to_string()));
    }
    for path in [shipped, last] {
        let bank: Option<Thresholds> = nastran::ron_file::read(&path).ok();
        if let Some(bank) = bank.filter(|bank| bank.key == wanted) {
            return Ok((bank, path.display().to_string()));
        }
    }
    if !common.quiet {
        show::note("no bank of null campaigns for this wing and campaign: made now (a minute or so)");
    }
    let mut bank = prepared.thresholds(seed);
    bank.key = wanted;
    Ok((bank, "made now".to_owned()))
}

/// The wing with the effects, and its corrections calibrated again with them in the model.
fn write_wing(found: &Discovered<'_>, results: &ResultFolder) -> Result<(), Failure> {
    let corrected = found.corrected;
    let rewritten = corrected.file.with_effects(discover_results::effects(found))?;
    results.write_text("wing.ron", &rewritten.text)?;
    for (name, from) in &rewritten.beside {
        results.write_text(name, &nastran::read_text(from)?)?;
    }
    let wing = coupling::WingFile::read(&results.path().join("wing.ron"))?;
    let campaign = without_effects(found);
    let calibration = calibrate(&corrected.wing, &campaign, &Settings::of_wing(&corrected.file.correction))?;
    results.write_text("corrections.ron", &schedule(&wing, &calibration).to_ron())
}

/// The gap after: with corrections calibrated again with the effects in the model, as later steps have them.
fn calibrated_again(found: &mut Discovered<'_>, rigs: &Rigs<'_>) -> Result<(), Failure> {
    let corrected = found.corrected;
    let settings = Settings::of_wing(&corrected.file.correction);
    let again = calibrate(&corrected.wing, &without_effects(found), &settings)?;
    let simulator = Simulator::new(&rigs.own, &schedule(&corrected.file, &again), &found.prepared.data)
        .map_err(DiscoverError::from)?;
    let after = found.prepared.gaps_of(&simulator, &found.report.level.effects);
    for (gaps, after) in found.report.gaps.iter_mut().zip(after) {
        gaps[1] = after;
    }
    Ok(())
}

/// The campaign with what the effects do to the static points taken off: what is left is for the corrections.
fn without_effects(found: &Discovered<'_>) -> Campaign {
    let mut campaign = found.campaign.clone();
    let (prepared, level) = (found.prepared, &found.report.level);
    let simulator = &prepared.simulator;
    let groups: Vec<usize> = (0..prepared.data.statics.len()).collect();
    let with = simulator.fly(&level.models, &level.effects, &groups);
    let plain = simulator.fly(&simulator.models(&[], None), &[], &groups);
    for (group, (with, plain)) in prepared.data.statics.iter().zip(with.iter().zip(&plain)) {
        for (i, &point) in group.points.iter().enumerate() {
            for (c, load) in campaign.points[point].loads.iter_mut().enumerate() {
                if let Some(load) = load {
                    *load -= with.loads[c][i] - plain.loads[c][i];
                }
            }
        }
    }
    leave_out(&mut campaign, &held_out_points(&prepared.data));
    campaign
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
