//! `simulate`: measured runs flown again, with and without corrections, beside what was measured; and declared
//! maneuvers.

use clap::Args;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use aero::{Corrections, Flow};
use calibrate::Campaign;
use calibrate::ensemble::interval;
use coupling::ByLoad;
use maneuver::effects::Beside;
use maneuver::{
    DeflectionAt, ManeuverFile, Rig, RigError, RigModel, RigSettings, Run, Simulated, simulate_commanded,
};
use nastran::InputError;
use rayon::prelude::*;

use crate::args::{Common, Given};
use crate::commands::result_parts::{Models as OfModels, as_json};
use crate::commands::simulate_effects::{self, WingEffects};
use crate::commands::simulate_flown::{Band, Flown, at_airspeed};
use crate::commands::simulate_result::{AirResult, RunResult, SimulateResult};
use crate::commands::{simulate_files, simulate_maneuvers};
use crate::corrections::{CorrectedWing, corrected_wing};
use crate::failure::Failure;
use crate::matrices::rig_settings;
use crate::{paths, progress, show};

/// Options of `simulate`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot simulate
  wingroot simulate --run data/tuflex/measured/aoa_2hz_30.csv
  wingroot simulate --maneuver data/tuflex/maneuvers/doublet.ron data/tuflex/maneuvers/chirp.ron
  wingroot simulate --wing out/deflection/wing.ron --corrections out/deflection/corrections.ron

The initial model is theory; the updated one has the corrections, and the wing's deflection correction if its file
has one (commanded deflection, times K(deflection, V), actuator, surface). Deflections in results are commands.")]
pub struct SimulateArgs {
    /// Wing, measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
    /// Runs to simulate [default: all runs of the campaign, unless maneuvers are named]
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub(crate) run: Vec<PathBuf>,
    /// Maneuvers declared in RON to fly (data/tuflex/maneuvers/doublet.ron explains every field)
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub(crate) maneuver: Vec<PathBuf>,
    /// Give the lift of every strip, too: NAME_stations.csv
    #[arg(long)]
    pub(crate) strips: bool,
    /// Switch off an effect of the wing's file (may be repeated)
    #[arg(long, value_name = "EFFECT")]
    pub(crate) without: Vec<String>,
}

impl From<RigError> for Failure {
    fn from(error: RigError) -> Self {
        match error {
            RigError::Coupling(coupling) => coupling.into(),
            RigError::Modes(modes) => Self::computation(modes),
        }
    }
}

/// Runs the command.
pub(crate) fn run(args: &SimulateArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let files = if args.run.is_empty() && args.maneuver.is_empty() {
        listed_runs(&args.given.measured.campaign_path()?)?
    } else {
        args.run.clone()
    };
    refuse_twins(&files.iter().chain(&args.maneuver).cloned().collect::<Vec<_>>())?;
    let campaign = match files.first() {
        Some(file) => Some(Campaign::read(&campaign_of(args, file)?)?),
        None => None,
    };
    let (rho_kg_m3, columns) = campaign.map_or_else(Default::default, |read| (read.rho_kg_m3, read.columns));
    let runs = files
        .iter()
        .map(|file| Ok((file, Run::read_named(file, &columns)?)))
        .collect::<Result<Vec<_>, InputError>>()?;
    let corrected = corrected_wing(&args.given)?;
    let found = corrected.found()?;
    let updated = found.as_ref().unwrap_or(&corrected);
    let effects = simulate_effects::of(updated, &args.without)?;
    let maneuvers = simulate_maneuvers::read(&args.maneuver, &corrected)?;
    let settings = RigSettings { strip_loads: args.strips, ..settings(&corrected) };
    let shared = corrected.shared_air(&corrected.wing, settings.air)?;
    let rig = corrected.rig(&settings, shared.as_deref())?;
    let of_found = found.as_ref().map(|found| found.rig(&settings, shared.as_deref())).transpose()?;
    let rigs = [&rig, of_found.as_ref().unwrap_or(&rig)];
    let bar = progress::bar(common, runs.len(), "flying runs");
    let sortie = Sortie { runs: &runs, maneuvers: &maneuvers, rho_kg_m3, settings: &settings };
    let mut flown = sortie.fly(rigs, updated, &effects, &|| bar.inc(1))?;
    progress::end(&bar);
    let members = corrected.with_each(|member| {
        let rig = member.rig(&settings, shared.as_deref())?;
        let effects = simulate_effects::of(member, &args.without)?;
        let flown = sortie.fly([&rig; 2], member, &effects, &|| ())?;
        Ok(flown.iter().map(|flown| loads_of(&flown.updated)).collect::<Vec<_>>())
    })?;
    for (index, flown) in flown.iter_mut().enumerate() {
        flown.spread =
            spread(&flown.updated, &members.iter().map(|member| &member[index]).collect::<Vec<_>>());
    }
    let of_runs =
        flown.iter().flat_map(|flown| flown.remarks.iter().map(move |r| format!("{}: {r}", flown.run.name)));
    effects.remarks().into_iter().chain(of_runs).for_each(|remark| show::note(&remark));
    let seconds = start.elapsed().as_secs_f64();
    let (effects, without) = effects.result().unzip();
    let result = as_json(&SimulateResult {
        command: "simulate",
        corrections: corrected.origin.clone(),
        deflection_correction: !corrected.file.deflection.is_empty(),
        modes: rig.omega_rad_s().len(),
        air: air_result(&rig),
        runs: flown.iter().map(run_result).collect(),
        intervals_from: corrected.intervals_from(),
        effects,
        without,
        seconds,
    })?;
    let out = simulate_files::write(&common.out("simulate"), &flown, &corrected, &result)?;
    show::summary(common, &summary(&flown, &out, seconds));
    show::json(common, &result)
}

/// What is flown, by whatever wing.
struct Sortie<'a> {
    runs: &'a [(&'a PathBuf, Run)],
    maneuvers: &'a [(ManeuverFile, Vec<String>)],
    rho_kg_m3: f64,
    settings: &'a RigSettings,
}

impl Sortie<'_> {
    /// Flies runs, then maneuvers, with the rigs of the initial and of the updated model.
    fn fly(
        &self,
        rigs: [&Rig<'_>; 2],
        corrected: &CorrectedWing,
        effects: &WingEffects,
        done: &(dyn Fn() + Sync),
    ) -> Result<Vec<Flown>, Failure> {
        let models = models(self.runs, rigs, corrected, effects, self.rho_kg_m3)?;
        let one = |(file, run): &(&PathBuf, Run)| {
            let flown = fly(file, run.clone(), &models, corrected);
            done();
            flown
        };
        let mut flown = self.runs.par_iter().map(one).collect::<Result<Vec<_>, Failure>>()?;
        flown.extend(simulate_maneuvers::fly(self.maneuvers, rigs, self.settings, corrected, effects)?);
        Ok(flown)
    }
}

/// Histories of Fz, Mx, My.
fn loads_of(simulated: &Simulated) -> [Vec<f64>; 3] {
    simulate_files::LOADS.map(|(channel, _)| simulated.history.get(channel).unwrap_or(&[]).to_vec())
}

/// The 90 % interval of each load at each instant; none without wings of an ensemble.
fn spread(updated: &Simulated, members: &[&[Vec<f64>; 3]]) -> Option<[Band; 3]> {
    let of = |c: usize| {
        let band = |(i, value): (usize, &f64)| {
            interval(*value, &members.iter().map(|member| member[c][i]).collect::<Vec<_>>())
        };
        loads_of(updated)[c].iter().enumerate().map(band).collect()
    };
    (!members.is_empty()).then(|| [of(0), of(1), of(2)])
}

/// The campaign that says in which air a run was flown: the one named, else the run's own folder, else the wing's.
fn campaign_of(args: &SimulateArgs, run: &Path) -> Result<PathBuf, InputError> {
    let own = paths::folder_of(run);
    if args.given.measured.campaign.is_none() && paths::is_campaign(own) {
        return Ok(own.to_path_buf());
    }
    args.given.measured.campaign_path()
}

/// The runs of a campaign.
fn listed_runs(folder: &Path) -> Result<Vec<PathBuf>, InputError> {
    let Campaign { runs, path: listed_in, .. } = Campaign::read(folder)?;
    if runs.is_empty() {
        return Err(InputError::in_file(folder, "the campaign has no runs")
            .with_help("list them under `runs` in campaign.ron, or name files with --run or --maneuver"));
    }
    runs.iter().map(|run| nastran::named_file(&listed_in, &run.file)).collect()
}

/// Results are named after their runs, so no two runs may share a name.
fn refuse_twins(files: &[PathBuf]) -> Result<(), InputError> {
    for (index, file) in files.iter().enumerate() {
        if let Some(twin) = files[..index].iter().find(|other| other.file_stem() == file.file_stem()) {
            let message = format!("this run has the same name as {}", twin.display());
            return Err(InputError::in_file(file, message)
                .with_help("results are named after their runs: name each run once, or rename one"));
        }
    }
    Ok(())
}

/// How the rig of a wing is modelled.
pub(crate) fn settings(corrected: &CorrectedWing) -> RigSettings {
    rig_settings(&corrected.file, &corrected.wing)
}

/// What flies at one airspeed.
struct Models {
    v_m_s: f64,
    initial: RigModel,
    updated: RigModel,
    effects: Option<Beside>,
}

/// Initial and updated model at every airspeed of the runs.
fn models(
    runs: &[(&PathBuf, Run)],
    [given, rig]: [&Rig<'_>; 2],
    corrected: &CorrectedWing,
    effects: &WingEffects,
    rho_kg_m3: f64,
) -> Result<Vec<Models>, Failure> {
    let mut first_of: Vec<(&PathBuf, f64)> = Vec::new();
    for (file, run) in runs {
        if !first_of.iter().any(|(_, v_m_s)| *v_m_s == run.v_m_s) {
            first_of.push((file, run.v_m_s));
        }
    }
    let neutral = Corrections::neutral(corrected.wing.correctable.len());
    let at = |(file, v_m_s): (&PathBuf, f64)| {
        let flow = Flow { v_m_s, rho_kg_m3 };
        let (corrections, _) = at_airspeed(file, v_m_s, corrected)?;
        Ok(Models {
            v_m_s,
            initial: given.at(flow, &neutral)?,
            updated: rig.at(flow, &corrections)?,
            effects: effects.at(rig, flow, &corrections)?,
        })
    };
    first_of.into_par_iter().map(at).collect()
}

/// The rational approximation: its poles and how far it is from the doublet lattice at the lattice's own frequencies.
fn air_result(rig: &Rig<'_>) -> Option<AirResult> {
    let fit = rig.air_fit()?;
    let percent = |errors: Vec<(String, f64)>| {
        errors.into_iter().map(|(name, error)| (name, 100.0 * error)).collect::<BTreeMap<_, _>>()
    };
    Some(AirResult {
        reduced_frequencies: fit.reduced_frequencies,
        poles: fit.poles,
        largest_error_percent_by_load: percent(fit.by_row),
        largest_error_percent_by_motion: percent(fit.by_motion),
    })
}

/// Flies a run with the initial and the updated model.
fn fly(file: &Path, run: Run, models: &[Models], corrected: &CorrectedWing) -> Result<Flown, Failure> {
    let Some(model) = models.iter().find(|model| model.v_m_s == run.v_m_s) else {
        return Err(Failure::Computation(format!("no model at {} m/s", run.v_m_s)));
    };
    let (_, deflection) = at_airspeed(file, run.v_m_s, corrected)?;
    let beyond = run.controls_rad.iter().filter_map(|(name, commanded)| deflection.beyond(name, commanded));
    let mut remarks: Vec<String> = beyond.map(|beyond| beyond.to_string()).collect();
    let none = DeflectionAt::default();
    let initial = simulate_commanded(&run, &model.initial, &none, file)?;
    remarks.extend(maneuver::suspicion::of_run(&run, &initial));
    let updated = |deflection: &DeflectionAt| -> Result<Simulated, InputError> {
        let plain = simulate_commanded(&run, &model.updated, deflection, file)?;
        let Some(effects) = &model.effects else { return Ok(plain) };
        simulate_effects::added(effects, plain, &run, file, &model.updated, deflection)
    };
    let moves = run.controls_rad.iter().any(|(_, values)| values.iter().any(|delta| *delta != 0.0));
    let as_commanded = (moves && deflection != none).then(|| updated(&none)).transpose()?;
    let updated = updated(&deflection)?;
    Ok(Flown { file: file.to_path_buf(), initial, updated, as_commanded, run, remarks, spread: None })
}

fn run_result(flown: &Flown) -> RunResult {
    let (initial, updated) = (&flown.initial, &flown.updated);
    // Of a load that never moves there is no part.
    let percent = |values: Option<ByLoad<f64>>| {
        values.map(|values| values.map(|value| value.is_finite().then_some(value)))
    };
    RunResult {
        file: flown.file.display().to_string(),
        v_m_s: flown.run.v_m_s,
        samples: flown.run.len(),
        residual_rms: OfModels { initial: initial.residual_rms, updated: updated.residual_rms },
        remarks: flown.remarks.clone(),
        largest_half_interval_90: flown.spread.as_ref().map(|bands| {
            ByLoad::from_array(
                bands
                    .each_ref()
                    .map(|band| band.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.0, f64::max)),
            )
        }),
        raw_percent: OfModels {
            initial: percent(initial.residual_percent),
            updated: percent(updated.residual_percent),
        },
    }
}

fn summary(flown: &[Flown], out: &Path, seconds: f64) -> String {
    let head = [
        "run",
        "V (m/s)",
        "Fz initial (N)",
        "updated",
        "Mx initial (N m)",
        "updated",
        "My initial (N m)",
        "updated",
    ];
    let mut table = report::Table::new(&head);
    let mut changes = report::Table::new(&head);
    for flight in flown {
        let mut cells = vec![flight.run.name.clone(), format!("{:.1}", flight.run.v_m_s)];
        let of = |simulated: &Simulated, c: usize| {
            let rms = simulated.residual_rms.map(ByLoad::to_array);
            rms.map_or_else(|| largest_change(simulated, c), |rms| rms[c])
        };
        let numbers = (0..3).flat_map(|c| [of(&flight.initial, c), of(&flight.updated, c)]);
        cells.extend(numbers.map(|number| format!("{number:.3}")));
        if flight.run.loads.is_some() {
            table.row(cells)
        } else {
            changes.row(cells)
        };
    }
    let measured = flown.iter().any(|flight| flight.run.loads.is_some());
    let declared = flown.iter().any(|flight| flight.run.loads.is_none());
    let mut text = String::new();
    if measured {
        text = format!("Root mean square of measured minus simulated:\n{table}");
    }
    if declared {
        let _ = write!(text, "Largest change of a simulated load from its beginning:\n{changes}");
    }
    let spread = flown.iter().filter_map(|flight| flight.spread.as_ref());
    let widest = spread.flat_map(|[fz, ..]| fz).map(|[low, high]| 0.5 * (high - low)).reduce(f64::max);
    let _ = match widest {
        Some(widest) => write!(text, "90 % intervals of the loads: shaded, at most ±{widest:.2} N in Fz"),
        None => write!(text, "no intervals: no ensemble.ron of `calibrate` beside the corrections"),
    };
    format!("{text}\n{seconds:.2} s; results in {}\n", out.display())
}

/// Farthest that a load goes from its first sample.
fn largest_change(simulated: &Simulated, channel: usize) -> f64 {
    let values = simulated.history.get(["Fz_N", "Mx_Nm", "My_Nm"][channel]).unwrap_or(&[]);
    values.iter().map(|value| (value - values[0]).abs()).fold(0.0, f64::max)
}
