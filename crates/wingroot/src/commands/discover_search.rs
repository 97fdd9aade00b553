//! One campaign of `discover` searched and written, by itself or as one of many.

use std::path::{Path, PathBuf};
use std::time::Instant;

use calibrate::{Campaign, Schedule};
use coupling::WingFile;
use discover::analysis::{Prepared, Rigs};
use discover::data_checks::Defect;
use discover::finding::{Finding, Sources};
use discover::null_distribution::NullDistribution;
use discover::recalibration::recalibrated;
use discover::result::DiscoverResult;
use nastran::InputError;

use crate::commands::{discover_figures, discover_results};
use crate::common::Common;
use crate::corrections::CorrectedWing;
use crate::ensemble::write_corrections;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// The search starts from a wing without effects.
pub(crate) fn check_without_effects(file: &WingFile) -> Result<(), InputError> {
    if file.effects.is_empty() {
        return Ok(());
    }
    let message = "the wing has effects already; the search starts from a wing without them";
    Err(InputError::in_field(&file.path, "effects", message)
        .with_help("take the list of effects out of a copy of the wing's file"))
}

/// A campaign that is ready to be searched, and what it is searched with.
pub(crate) struct Searched<'a> {
    pub(crate) corrected: &'a CorrectedWing,
    pub(crate) rigs: &'a Rigs<'a>,
    pub(crate) campaign: &'a Campaign,
    pub(crate) prepared: &'a Prepared,
    /// Thresholds, and where they come from in words.
    pub(crate) nulls: &'a (NullDistribution, String),
}

impl Searched<'_> {
    /// Searches, and writes what is found into a folder of results; the result, and the table for people.
    pub(crate) fn written(
        &self,
        out: &Path,
        common: &Common,
        start: Instant,
    ) -> Result<(DiscoverResult, String), Failure> {
        let Self { corrected, rigs, campaign, prepared, nulls: (nulls, nulls_from) } = self;
        let mut finding = Finding::search(prepared, nulls, seed(common));
        finding.look_further(rigs, &corrected.schedule)?;
        let sources = Sources {
            corrections: corrected.origin.clone(),
            null_distribution: nulls_from.clone(),
            data_hash: data_hash(campaign)?,
        };
        if !finding.report.current.effects.is_empty() {
            let effects = &finding.report.current.effects;
            let again = recalibrated(rigs, campaign, prepared, effects, |left| corrected.calibrated(left))?;
            finding.recalibrate(again);
        }
        let seconds = start.elapsed().as_secs_f64();
        let result = finding.result(&sources, true, seconds);
        let results = ResultFolder::begin(out)?;
        corrected.note_inputs(&results)?;
        results.input("campaign", &campaign.folder)?;
        write_wing(&finding, corrected, &sources.data_hash, &results)?;
        results.write_json("result.json", &result)?;
        results.write_text("null_distribution.ron", &nastran::ron_file::to_text(nulls)?)?;
        let map = result.search.as_ref().and_then(|search| search.map.as_deref());
        results.write_text("map.csv", &discover_results::map_csv(map.unwrap_or_default()))?;
        discover_figures::write(&finding, &results)?;
        results.commit()?;
        let text = discover_results::summary(&finding, &result, out);
        Ok((result, text))
    }
}

pub(crate) fn seed(common: &Common) -> u64 {
    common.seed.unwrap_or(1)
}

/// What is said of data at fault, written beside the place of a good result.
pub(crate) fn refuse(faults: Vec<Defect>, out: &Path, seconds: f64) -> Result<DiscoverResult, Failure> {
    let result = DiscoverResult::at_fault(faults, None, seconds);
    let results = ResultFolder::begin(out)?;
    results.write_json("result.json", &result)?;
    results.commit_incomplete()?;
    Ok(result)
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
    let wing = WingFile::read(&results.path().join(name))?;
    let again = finding.recalibrated.as_ref().map(|again| &again.schedule);
    let Schedule { sets, unconverged, .. } = again.unwrap_or(&corrected.schedule).clone();
    // effects may be of the structure and its surfaces, and were found with those as given
    let schedule = Schedule { wing: wing.name, wing_hash: wing.hash, sets, found: None, unconverged };
    write_corrections(results, corrected, schedule, &[])
}

fn data_hash(campaign: &Campaign) -> Result<String, InputError> {
    let mut files = vec![campaign.path.clone(), campaign.folder.join("static.csv")];
    files.extend(campaign.runs.iter().map(|run| campaign.folder.join(&run.file)));
    let texts = files.iter().filter(|file| file.is_file()).map(|file: &PathBuf| nastran::read_text(file));
    Ok(coupling::wing_file::fingerprint(&texts.collect::<Result<Vec<_>, _>>()?.concat()))
}
