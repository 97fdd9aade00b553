//! `discover --campaigns`: every campaign in a folder on one wing. What does not depend on the campaign is set up once, and
//! thresholds serve all campaigns of one design.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use calibrate::Campaign;
use discover::analysis::{Prepared, Rigs};
use discover::data::Dataset;
use discover::model_form::LatticeVariant;
use discover::null_distribution::NullDistribution;
use discover::null_key::NullKey;
use discover::recalibration::without_held_out;
use discover::result::DiscoverResult;
use discover::rules::Rules;
use discover::verdict::VerdictKind;
use nastran::InputError;
use nastran::ron_or_json::in_folder;

use crate::args::{Common, Given};
use crate::commands::discover_campaigns_result::{CampaignVerdict, CampaignsResult};
use crate::commands::discover_nulls::{beside_or_last, made_now};
use crate::commands::discover_search::{Searched, check_without_effects, refuse, seed};
use crate::corrections::{CorrectedWing, as_given, corrected_wing, wing_without_corrections};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Name of the command, and of its folder of results.
const COMMAND: &str = "discover --campaigns";
const FOLDER: &str = "discover_campaigns";
/// Ending of the folder with the results of each campaign.
const EACH: &str = "each";

/// Runs the command.
pub(crate) fn run(given: &Given, folder: &Path, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    // all are read before any is searched: a fault in the last one need not wait for the others
    let campaigns = campaigns_in(folder)?;
    let own = given.corrections.is_none();
    let mut corrected = if own { wing_without_corrections(given)? } else { corrected_wing(given)? };
    as_given(&corrected.schedule);
    check_without_effects(&corrected.file)?;
    let rules = Rules::default();
    let lattice = LatticeVariant::of(&corrected.file, &corrected.wing, &rules.variants);
    let rigs = Rigs::new(&corrected.file, &corrected.wing, lattice.as_ref(), rules)?;
    let out = common.out(FOLDER);
    let mut made = Vec::new();
    let mut verdicts = Vec::new();
    for (place, (name, campaign)) in campaigns.iter().enumerate() {
        show::note(&format!("{name}: campaign {} of {}", place + 1, campaigns.len()));
        let begun = Instant::now();
        let each = out.with_extension(EACH).join(name);
        let one = One { name, campaign, own, out: &each, begun };
        let calibrated =
            if own { calibration(&corrected, &rigs, given, campaign).map(Some) } else { Ok(None) };
        let result = match calibrated {
            Ok(schedule) => {
                if let Some(schedule) = schedule {
                    corrected.schedule = schedule;
                    "calibrated from the campaign's own static points".clone_into(&mut corrected.origin);
                }
                one.searched(&corrected, &rigs, &mut made, common)
            }
            Err(failure) => Err(failure),
        };
        let seconds = begun.elapsed().as_secs_f64();
        // what is wrong with one campaign stops no other
        let result = result.unwrap_or_else(|failure| {
            DiscoverResult::at_fault(Vec::new(), Some(failure.to_string()), seconds)
        });
        verdicts.push(CampaignVerdict::new(name.clone(), &result));
    }
    let seconds = start.elapsed().as_secs_f64();
    let result = CampaignsResult { command: COMMAND.to_owned(), campaigns: verdicts, seconds };
    let results = ResultFolder::begin(&out)?;
    corrected.note_inputs(&results)?;
    results.input("campaigns", folder)?;
    results.write_text("campaigns.csv", &csv(&result.campaigns))?;
    results.write_json("result.json", &result)?;
    results.commit()?;
    show::summary(common, &summary(&result, &out));
    show::json(common, &result)?;
    at_fault(&result.campaigns)
}

/// The campaigns in a folder by the names of their folders, in the order of the alphabet.
fn campaigns_in(folder: &Path) -> Result<Vec<(String, Campaign)>, InputError> {
    let entries = std::fs::read_dir(folder).map_err(|error| {
        InputError::in_file(folder, format!("the folder of campaigns cannot be read: {error}"))
    })?;
    let mut folders: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    folders.sort();
    let mut campaigns = Vec::new();
    for path in folders.into_iter().filter(|path| path.is_dir()) {
        if in_folder(&path, "campaign")?.is_some() {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            campaigns.push((name, Campaign::read(&path)?));
        }
    }
    if campaigns.is_empty() {
        return Err(InputError::in_file(folder, "no folder in here has a campaign.ron")
            .with_help("--campaigns names the folder above the campaigns; --campaign names a single one"));
    }
    Ok(campaigns)
}

/// Corrections from a campaign's own static points, but for those of airspeeds that are held out.
fn calibration(
    corrected: &CorrectedWing,
    rigs: &Rigs<'_>,
    given: &Given,
    campaign: &Campaign,
) -> Result<calibrate::Schedule, Failure> {
    let data = Dataset::read(campaign, &corrected.wing, &rigs.rules)?;
    let kept = without_held_out(campaign, &data);
    corrected.calibrated_for(given, kept.as_ref().unwrap_or(campaign))
}

/// One campaign on its way.
struct One<'a> {
    name: &'a str,
    campaign: &'a Campaign,
    own: bool,
    out: &'a Path,
    begun: Instant,
}

/// Thresholds of a campaign of this run.
struct Made {
    name: String,
    nulls: NullDistribution,
    data: Dataset,
}

impl One<'_> {
    fn searched(
        &self,
        corrected: &CorrectedWing,
        rigs: &Rigs<'_>,
        made: &mut Vec<Made>,
        common: &Common,
    ) -> Result<DiscoverResult, Failure> {
        let Self { campaign, own, out, begun, .. } = *self;
        let prepared = Prepared::new(rigs, &corrected.schedule, campaign, own)?;
        let faults = prepared.defects();
        if !faults.is_empty() {
            return refuse(faults, out, begun.elapsed().as_secs_f64());
        }
        let key = prepared.null_key(&corrected.file.hash, &corrected.schedule);
        let nulls = self.null_distribution(key, corrected, &prepared, made, common)?;
        let searched = Searched { corrected, rigs, campaign, prepared: &prepared, nulls: &nulls };
        Ok(searched.written(out, common, begun)?.0)
    }

    /// Those of an earlier campaign of the same design if wing, corrections and stated noise are the same, those that stand beside the
    /// wing if they are of this campaign, else made now.
    fn null_distribution(
        &self,
        key: NullKey,
        corrected: &CorrectedWing,
        prepared: &Prepared,
        made: &mut Vec<Made>,
        common: &Common,
    ) -> Result<(NullDistribution, String), Failure> {
        let serves = |made: &&Made| {
            let design = NullKey { design: made.nulls.key.design.clone(), ..key.clone() };
            // without a statement the noise is each campaign's own
            prepared.data.stated.is_some()
                && made.nulls.serves(&design, &prepared.library)
                && prepared.data.has_design_of(&made.data)
        };
        if let Some(made) = made.iter().find(serves) {
            return Ok((made.nulls.clone(), format!("that of {}, which has the same design", made.name)));
        }
        let is_own = |nulls: &NullDistribution| nulls.serves(&key, &prepared.library);
        let (nulls, from) = match beside_or_last(&corrected.file, &is_own)? {
            Some(found) => found,
            None => (made_now(key, prepared, seed(common), self.out, common)?, "made now".to_owned()),
        };
        made.push(Made { name: self.name.to_owned(), nulls: nulls.clone(), data: prepared.data.clone() });
        Ok((nulls, from))
    }
}

/// Status 3 if data are at fault or could not be searched, once everything else is done and written.
fn at_fault(campaigns: &[CampaignVerdict]) -> Result<(), Failure> {
    let is_at_fault = |one: &&CampaignVerdict| one.verdict == VerdictKind::DataDefect;
    let said: Vec<String> =
        campaigns.iter().filter(is_at_fault).map(|one| format!("{}: {}", one.name, one.sentence)).collect();
    if said.is_empty() {
        return Ok(());
    }
    let of = campaigns.len();
    Err(Failure::Computation(format!(
        "{} of {of} campaigns were not searched: {}",
        said.len(),
        said.join("; ")
    )))
}

/// A number in a cell; nothing where there is none.
fn cell(value: Option<f64>) -> String {
    value.filter(|value| value.is_finite()).map_or_else(String::new, |value| format!("{value:.4}"))
}

fn csv(campaigns: &[CampaignVerdict]) -> String {
    let mut text = String::from(
        "campaign,verdict,effects,confidence,gap_before,gap_after,held_out_gap_before,held_out_gap_after,seconds\n",
    );
    for one in campaigns {
        let gap = |of: fn(&discover::result::StatedGaps) -> f64| cell(one.gap.as_ref().map(of));
        let confidence: Vec<String> =
            one.effects.iter().map(|effect| format!("{:.3}", effect.confidence)).collect();
        let _ = writeln!(
            text,
            "\"{}\",{},\"{}\",\"{}\",{},{},{},{},{:.1}",
            one.name.replace('"', "\"\""),
            one.verdict.word(),
            one.effects_in_words(),
            confidence.join(" + "),
            gap(|gap| gap.training.before),
            gap(|gap| gap.training.after),
            gap(|gap| gap.holdout.before),
            gap(|gap| gap.holdout.after),
            one.seconds
        );
    }
    text
}

fn summary(result: &CampaignsResult, out: &Path) -> String {
    let mut table = report::Table::new(&["campaign", "verdict", "effects", "gap held out", "s"]);
    for one in &result.campaigns {
        let gap = one.gap.map(|gap| if gap.holdout.before.is_finite() { gap.holdout } else { gap.training });
        let gap = gap.map_or_else(String::new, |gap| format!("{:.1} -> {:.1}", gap.before, gap.after));
        table.row([
            one.name.clone(),
            one.verdict.word().to_owned(),
            one.effects_in_words(),
            gap,
            format!("{:.1}", one.seconds),
        ]);
    }
    let (count, seconds) = (result.campaigns.len(), result.seconds);
    format!(
        "{table}\n{count} campaigns, {seconds:.0} s; results in {}, each campaign's in {}\n",
        out.display(),
        out.with_extension(EACH).display()
    )
}
