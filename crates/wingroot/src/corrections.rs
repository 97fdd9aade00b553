//! A wing with its corrections: from a file, from the last `calibrate` if it was of this wing, or found now.

use std::path::{Path, PathBuf};

use calibrate::posterior::posterior;
use calibrate::{Calibration, Campaign, CorrectionSet, Ensemble, Schedule, Settings, calibrate};
use coupling::{CouplingError, ElasticWing, WingFile};
use nastran::InputError;

use crate::args::{Given, Measured};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::store::Shared;

/// File of an ensemble, beside the corrections that it spreads about.
pub(crate) const ENSEMBLE: &str = "ensemble.ron";
/// Name of a calibration among what processes share.
const CORRECTIONS: &str = "corrections";

impl From<CouplingError> for Failure {
    fn from(error: CouplingError) -> Self {
        match error {
            CouplingError::Input(input) => Self::Input(input),
            other => Self::computation(other),
        }
    }
}

/// A wing, where it was read from, and its corrections by airspeed.
#[derive(Debug)]
pub(crate) struct CorrectedWing {
    /// The wing's file.
    pub(crate) file: WingFile,
    /// The wing as it stands in the tunnel.
    pub(crate) wing: ElasticWing,
    /// Its corrections.
    pub(crate) schedule: Schedule,
    /// Where the corrections come from, in words.
    pub(crate) origin: String,
    /// Wings that are as likely; none where no ensemble stands beside the corrections.
    pub(crate) ensemble: Option<Ensemble>,
}

impl CorrectedWing {
    /// Corrections from a campaign's static points, as the wing's file asks for them.
    ///
    /// # Errors
    /// If the calibration cannot be done.
    pub(crate) fn calibrated(&self, campaign: &Campaign) -> Result<Schedule, Failure> {
        Ok(schedule(&self.file, &calibrated(&self.file, &self.wing, campaign)?))
    }

    /// The same, of a fit that converged or one that is accepted all the same.
    ///
    /// # Errors
    /// As [`calibrated`](Self::calibrated), and if the fit did not converge.
    pub(crate) fn calibrated_for(&self, given: &Given, campaign: &Campaign) -> Result<Schedule, Failure> {
        converged(self.calibrated(campaign)?, given)
    }

    /// Notes the wing and its corrections as inputs.
    ///
    /// # Errors
    /// If they cannot be read again.
    pub(crate) fn note_inputs(&self, folder: &ResultFolder) -> Result<(), Failure> {
        folder.input("wing", &self.file.path)?;
        let origin = Path::new(&self.origin);
        if origin.is_file() { folder.input("corrections", origin) } else { Ok(()) }
    }
}

/// Reads a wing and takes its corrections from `corrections`, or from out/calibrate if they belong to the same
/// wing (hash), or calibrates it now and says so.
///
/// # Errors
/// Bad input, corrections of another wing, or a calibration that cannot be done.
pub(crate) fn corrected_wing(given: &Given) -> Result<CorrectedWing, Failure> {
    corrected_wing_shared(given, &Shared::default())
}

/// The same; a calibration that would be made now is taken from what processes share, or made and left there.
///
/// # Errors
/// As [`corrected_wing`].
pub(crate) fn corrected_wing_shared(given: &Given, shared: &Shared) -> Result<CorrectedWing, Failure> {
    let (file, wing) = ElasticWing::read(&given.measured.wing_path()?)?;
    if let Some(path) = given.corrections.as_deref() {
        let schedule = given.schedule_of(path, &file, &wing)?;
        let ensemble = given.ensemble(path, &schedule)?;
        return Ok(CorrectedWing { file, wing, schedule, origin: path.display().to_string(), ensemble });
    }
    let last = last();
    if let Some(schedule) = of_last(given, &file) {
        check_boxes(&schedule, &wing, &last)?;
        let ensemble = given.ensemble(&last, &schedule)?;
        return Ok(CorrectedWing { file, wing, schedule, origin: last.display().to_string(), ensemble });
    }
    let Wanted { campaign, inputs, origin } = wanted(given, &file)?;
    let schedule = if let Some(kept) = kept(shared, &inputs) {
        kept
    } else {
        crate::show::note(&format!("no corrections of this wing in {}: {origin}", last.display()));
        let schedule = schedule(&file, &calibrated(&file, &wing, &campaign)?);
        shared.put_bytes(CORRECTIONS, &inputs, &serde_json::to_vec(&schedule).map_err(Failure::computation)?);
        schedule
    };
    let schedule = converged(schedule, given)?;
    Ok(CorrectedWing { file, wing, schedule, origin, ensemble: None })
}

/// Reads a wing whose corrections are to be found campaign by campaign; it has none yet.
///
/// # Errors
/// Bad input.
pub(crate) fn wing_without_corrections(given: &Given) -> Result<CorrectedWing, Failure> {
    let (file, wing) = ElasticWing::read(&given.measured.wing_path()?)?;
    let (name, hash) = (file.name.clone(), file.hash.clone());
    let schedule =
        Schedule { wing: name, wing_hash: hash, sets: Vec::new(), found: None, unconverged: Vec::new() };
    Ok(CorrectedWing { file, wing, schedule, origin: String::new(), ensemble: None })
}

/// Corrections that another process calibrated, of a wing that need not be assembled for them.
pub(crate) struct Left {
    /// The wing's file.
    pub(crate) file: WingFile,
    /// Its corrections.
    pub(crate) schedule: Schedule,
    /// Where they come from, in words.
    pub(crate) origin: String,
}

/// What another process has left of the calibration that [`corrected_wing_shared`] would make; none if it would make none.
///
/// # Errors
/// As [`corrected_wing`].
pub(crate) fn left_by_another(given: &Given, shared: &Shared) -> Result<Option<Left>, Failure> {
    let file = WingFile::read(&given.measured.wing_path()?)?;
    if given.corrections.is_some() || of_last(given, &file).is_some() {
        return Ok(None);
    }
    let Wanted { inputs, origin, .. } = wanted(given, &file)?;
    let Some(schedule) = kept(shared, &inputs) else { return Ok(None) };
    Ok(Some(Left { file, schedule: converged(schedule, given)?, origin }))
}

/// A calibration that is wanted.
struct Wanted {
    campaign: Campaign,
    /// What it depends on, as text.
    inputs: String,
    /// Where corrections come from then, in words.
    origin: String,
}

fn wanted(given: &Given, file: &WingFile) -> Result<Wanted, Failure> {
    let measured = Measured { wing: Some(file.path.clone()), ..given.measured.clone() };
    let campaign = Campaign::read(&measured.campaign_path()?)?;
    let inputs = format!("{} {campaign:?}", file.hash);
    let origin = format!("calibrated now from {}", campaign.folder.display());
    Ok(Wanted { campaign, inputs, origin })
}

fn kept(shared: &Shared, inputs: &str) -> Option<Schedule> {
    serde_json::from_slice(&shared.bytes(CORRECTIONS, inputs)?).ok()
}

/// Where the last `calibrate` has written its corrections.
fn last() -> PathBuf {
    crate::common::results("calibrate").join("corrections.ron")
}

/// Those corrections, if they are of this wing.
fn of_last(given: &Given, file: &WingFile) -> Option<Schedule> {
    given.schedule(&last()).ok().filter(|schedule| schedule.wing_hash == file.hash)
}

fn converged(schedule: Schedule, given: &Given) -> Result<Schedule, Failure> {
    if schedule.unconverged.is_empty() || given.accept_unconverged {
        return Ok(schedule);
    }
    let message = format!("the fit did not converge: {}", schedule.unconverged.join(", "));
    Err(Failure::Computation(message + "; --accept-unconverged goes on with it"))
}

/// The ensemble beside corrections; none if there is no such file or it is of other corrections, which is said.
fn ensemble_beside(corrections: &Path, schedule: &Schedule) -> Result<Option<Ensemble>, InputError> {
    let path = corrections.with_file_name(ENSEMBLE);
    if !path.is_file() {
        return Ok(None);
    }
    let ensemble = Ensemble::read(&path, schedule)?;
    if ensemble.wing_hash == schedule.wing_hash
        && ensemble.corrections == coupling::wing_file::fingerprint(&schedule.to_ron())
    {
        return Ok(Some(ensemble));
    }
    crate::show::note(&format!("{} is of other corrections: no intervals", path.display()));
    Ok(None)
}

impl Given {
    /// The ensemble beside corrections, if intervals are wanted.
    fn ensemble(&self, path: &Path, schedule: &Schedule) -> Result<Option<Ensemble>, InputError> {
        if self.no_intervals { Ok(None) } else { ensemble_beside(path, schedule) }
    }

    /// Reads corrections that must be of a wing.
    ///
    /// # Errors
    /// If they cannot be read, or are of another wing or lattice.
    pub(crate) fn schedule_of(
        &self,
        path: &Path,
        file: &WingFile,
        wing: &ElasticWing,
    ) -> Result<Schedule, Failure> {
        let schedule = self.schedule(path)?;
        if schedule.wing_hash != file.hash {
            let message = format!("these corrections belong to another wing than {}", file.path.display());
            let help = "corrections hold for the wing they were found with: calibrate this one, or name the other with --wing";
            return Err(InputError::in_file(path, message).with_help(help).into());
        }
        check_boxes(&schedule, wing, path)?;
        Ok(schedule)
    }

    /// Reads corrections; those of a fit that did not converge only if that was asked for.
    fn schedule(&self, path: &Path) -> Result<Schedule, InputError> {
        if self.accept_unconverged { Schedule::read_unconverged(path) } else { Schedule::read(path) }
    }
}

/// Says that what is computed with corrections has the structure of the wing's file, if they have found another.
pub(crate) fn as_given(schedule: &Schedule) {
    if schedule.found.is_some() {
        crate::show::note(
            "these corrections have found another structure; here it is as the wing's file gives it",
        );
    }
}

/// A calibration as `calibrate` does it: with the mean of what is known where more than root loads was measured.
///
/// # Errors
/// If it cannot be done.
pub(crate) fn calibrated(
    file: &WingFile,
    wing: &ElasticWing,
    campaign: &Campaign,
) -> Result<Calibration, CouplingError> {
    let calibration = calibrate(wing, campaign, &Settings::for_corrections(&file.correction))?;
    if !calibration.data.is_more_than_root_loads() {
        return Ok(calibration);
    }
    let known = posterior(wing, &calibration, &file.correction.prior)?;
    calibration.with_means(wing, &known)
}

/// The corrections of a calibration as a schedule; one set for all airspeeds stands at both ends of their range.
pub fn schedule(file: &WingFile, calibration: &Calibration) -> Schedule {
    let set = |a: &calibrate::AirspeedCalibration| CorrectionSet {
        v_m_s: a.data.v_m_s,
        corrections: a.corrections.clone(),
    };
    let mut sets: Vec<CorrectionSet> = calibration.airspeeds.iter().map(set).collect();
    if let Some(common) = &calibration.common {
        let [slow, fast] = common.v_range_m_s;
        let ends = if slow < fast { vec![slow, fast] } else { vec![fast] };
        let at = |v_m_s| CorrectionSet { v_m_s, corrections: common.corrections.clone() };
        sets.extend(ends.into_iter().map(at));
    }
    let unconverged = calibration.faults();
    let found = calibration.found.clone();
    Schedule { wing: file.name.clone(), wing_hash: file.hash.clone(), sets, found, unconverged }
}

fn check_boxes(schedule: &Schedule, wing: &ElasticWing, path: &Path) -> Result<(), Failure> {
    let (got, expected) = (schedule.sets[0].corrections.len(), wing.correctable.len());
    if let Some(found) = schedule.found.as_ref().filter(|found| found.controls.len() != wing.controls.len()) {
        let (got, expected) = (found.controls.len(), wing.controls.len());
        let message = format!("factors of {got} control surfaces, but the wing has {expected}");
        return Err(InputError::in_field(path, "found", message)
            .with_help("calibrate again: the wing's control surfaces have changed")
            .into());
    }
    if got == expected {
        return Ok(());
    }
    let message =
        format!("{got} corrections an airspeed, but the wing has {expected} boxes (fairing excluded)");
    Err(InputError::in_file(path, message)
        .with_help("calibrate again: the wing's lattice has changed")
        .into())
}
