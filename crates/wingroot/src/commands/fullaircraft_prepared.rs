//! The options of `fullaircraft`, and its aircraft with the corrections and effects of its wing.

use std::path::PathBuf;

use aero::Corrections;
use calibrate::Schedule;
use clap::Args;
use fullaircraft::{Aircraft, AircraftFile};
use nastran::InputError;

use crate::args::{Common, Given, Measured};
use crate::commands::fullaircraft_effects;
use crate::corrections::{CorrectedWing, Left, corrected_wing_shared, left_by_another};
use crate::failure::Failure;
use crate::paths;
use crate::store::Shared;
use crate::sweep::SweepArgs;

/// Options of `fullaircraft`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot fullaircraft
  wingroot fullaircraft --nonlinear
  wingroot fullaircraft --cases data/tuflex/cases.ron
  wingroot fullaircraft --deck data/published/decks/ha144a_fsw.bdf

With --cases: every maneuver of the file at every airspeed, with both models, and the load envelope (cases.csv,
envelope.csv, envelope.svg, result.json in out/fullaircraft_cases). Finished cases are kept beside that folder until all are
done: a run that was stopped goes on where it was when it is started again with the same inputs.")]
pub struct FullaircraftArgs {
    /// The aircraft [default: aircraft.ron beside the wing, or of the current folder]
    #[arg(long, value_name = "FILE")]
    pub(crate) aircraft: Option<PathBuf>,
    /// Wing [default: the one that the aircraft names], measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
    /// A grid of airspeeds, load factors and maneuvers (data/tuflex/cases.ron explains every field)
    #[arg(long, value_name = "FILE.ron")]
    pub(crate) cases: Option<PathBuf>,
    /// Which of the cases
    #[command(flatten)]
    pub(crate) sweep: SweepArgs,
    /// The trims of a whole-aircraft Nastran deck (SOL 144), or of a study (.ron) of decks that lack something for them
    #[arg(long, value_name = "FILE", conflicts_with_all = ["cases", "aircraft", "wing", "campaign", "corrections"])]
    pub(crate) deck: Option<PathBuf>,
    /// Trim, pull-up and push-down of the aircraft that really bends, too [default: as the wing's `geometry` says]
    #[arg(long, conflicts_with_all = ["cases", "deck"])]
    pub(crate) nonlinear: bool,
}

impl FullaircraftArgs {
    /// The folder of results, which differs with what is asked for.
    pub(super) fn results(&self) -> &'static str {
        match (&self.cases, &self.deck) {
            (Some(_), _) => "fullaircraft_cases",
            (None, Some(_)) => "fullaircraft_deck",
            (None, None) => "fullaircraft",
        }
    }
}

/// An aircraft and the corrections it flies with.
pub(crate) struct Prepared {
    /// The aircraft, its structure as given.
    pub(crate) aircraft: Aircraft,
    /// The same with the structure and surfaces that were found, which flies as the updated model; none if they are as given.
    pub(crate) found: Option<Aircraft>,
    /// Corrections of one wing's boxes, of the updated model.
    pub(crate) corrections: Corrections,
    /// Effects of the wing that fly with it.
    pub(crate) effects: fullaircraft_effects::Travelling,
    /// The wing that they are of.
    pub(crate) wing: CorrectedWing,
    /// What was read, for the report.
    pub(crate) inputs: Vec<(&'static str, PathBuf)>,
}

impl Prepared {
    /// The aircraft that flies as the updated model.
    pub(crate) fn updated(&self) -> &Aircraft {
        self.found.as_ref().unwrap_or(&self.aircraft)
    }
}

/// Reads and assembles the aircraft with the corrections of its wing.
pub(crate) fn prepared(args: &FullaircraftArgs, common: &Common) -> Result<Prepared, Failure> {
    prepared_shared(asked(args)?, common, &Shared::default())
}

/// The same; what processes share is taken from there or left there.
pub(crate) fn prepared_for_parts(
    args: &FullaircraftArgs,
    common: &Common,
    shared: &Shared,
) -> Result<Prepared, Failure> {
    prepared_shared(asked(args)?, common, shared)
}

/// What grids of cases are flown with: no effects but those that are in the corrections.
pub(crate) struct PreparedCases {
    /// The aircraft, its structure as given.
    pub(crate) aircraft: Aircraft,
    /// The same with the structure and surfaces that were found, which flies as the updated model; none if they are as given.
    pub(crate) found: Option<Aircraft>,
    /// Corrections of one wing's boxes, of the updated model.
    pub(crate) corrections: Corrections,
    /// Where they come from, in words.
    pub(crate) origin: String,
    /// The wing with its ensemble; none without one.
    pub(crate) ensemble: Option<CorrectedWing>,
    /// What was read, for the report.
    pub(crate) inputs: Vec<(&'static str, PathBuf)>,
}

/// The same aircraft and corrections; what processes share is taken from there or left there.
pub(crate) fn prepared_cases(
    args: &FullaircraftArgs,
    common: &Common,
    shared: &Shared,
) -> Result<PreparedCases, Failure> {
    let asked = asked(args)?;
    // effects join the corrections by the wing as it stands in the tunnel
    let plain = |left: &Left| left.file.effects.is_empty() && left.schedule.found.is_none();
    let left = left_by_another(&asked.given, shared)?.filter(plain);
    let Some(Left { file: wing, schedule, origin }) = left else {
        let Prepared { aircraft, found, corrections, wing, inputs, .. } =
            prepared_shared(asked, common, shared)?;
        let origin = wing.origin.clone();
        let ensemble = Some(wing).filter(|wing| wing.ensemble.is_some());
        return Ok(PreparedCases { aircraft, found, corrections, origin, ensemble, inputs });
    };
    let Asked { file, wing_path, .. } = asked;
    check_airspeed(&schedule, &file, common)?;
    let inputs = vec![("aircraft", file.path.clone()), ("wing", wing_path)];
    let corrections = schedule.nearest(file.correction_airspeed_m_s).corrections.clone();
    let aircraft = Aircraft::kept(file, wing, shared)?;
    Ok(PreparedCases { aircraft, found: None, corrections, origin, ensemble: None, inputs })
}

/// What options ask for.
struct Asked {
    file: AircraftFile,
    given: Given,
    wing_path: PathBuf,
}

fn asked(args: &FullaircraftArgs) -> Result<Asked, Failure> {
    let named = &args.given.measured;
    let file = AircraftFile::read(&paths::aircraft(args.aircraft.as_deref(), named.wing.as_deref())?)?;
    let wing_path = named.wing.clone().unwrap_or_else(|| file.wing_path());
    let measured = Measured { wing: Some(wing_path.clone()), campaign: named.campaign.clone() };
    Ok(Asked { file, given: Given { measured, ..args.given.clone() }, wing_path })
}

fn prepared_shared(asked: Asked, common: &Common, shared: &Shared) -> Result<Prepared, Failure> {
    let Asked { file, given, wing_path } = asked;
    let wing = corrected_wing_shared(&given, shared)?;
    check_airspeed(&wing.schedule, &file, common)?;
    let mut inputs = vec![("aircraft", file.path.clone()), ("wing", wing_path)];
    inputs.extend(Some(("corrections", PathBuf::from(&wing.origin))).filter(|(_, path)| path.is_file()));
    let Some(as_found) = wing.found()? else {
        let Assembled { aircraft, corrections, effects } = assembled(file, &wing, shared)?;
        return Ok(Prepared { aircraft, found: None, corrections, effects, wing, inputs });
    };
    let aircraft = Aircraft::kept(file.clone(), wing.file.clone(), shared)?;
    let Assembled { aircraft: found, corrections, effects } = assembled(file, &as_found, shared)?;
    Ok(Prepared { aircraft, found: Some(found), corrections, effects, wing, inputs })
}

/// Refuses an airspeed of corrections that was not calibrated; says which set stands for one between those that were.
fn check_airspeed(schedule: &Schedule, file: &AircraftFile, common: &Common) -> Result<(), Failure> {
    // The nearest set stands for airspeeds between the calibrated ones, as published (40 m/s for 37 and 42 m/s).
    schedule.at(file.correction_airspeed_m_s).map_err(|refused| {
        InputError::in_field(&file.path, "correction_airspeed_m_s", refused.message)
            .with_help("choose an airspeed within those of the calibration")
    })?;
    let asked = file.correction_airspeed_m_s;
    let nearest_m_s = schedule.nearest(asked).v_m_s;
    if nearest_m_s != asked && !common.quiet {
        crate::show::note(&format!("corrections of {nearest_m_s} m/s, the nearest to {asked} m/s"));
    }
    Ok(())
}

/// An aircraft with what its wing brings.
pub(crate) struct Assembled {
    /// The aircraft.
    pub(crate) aircraft: Aircraft,
    /// Corrections of one wing's boxes.
    pub(crate) corrections: Corrections,
    /// Effects of the wing that fly with it.
    pub(crate) effects: fullaircraft_effects::Travelling,
}

/// The aircraft with a wing in the place of the one it names, and the corrections nearest to the airspeed it asks for.
pub(crate) fn assembled(
    file: AircraftFile,
    wing: &CorrectedWing,
    shared: &Shared,
) -> Result<Assembled, Failure> {
    let mut corrections = wing.schedule.nearest(file.correction_airspeed_m_s).corrections.clone();
    let effects = fullaircraft_effects::travelling(wing, &file, &mut corrections)?;
    let aircraft = Aircraft::kept(file, wing.file.clone(), shared)?;
    Ok(Assembled { aircraft, corrections, effects })
}
