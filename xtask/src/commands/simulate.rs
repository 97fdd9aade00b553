//! `simulate`: measured runs flown again, with and without corrections, beside what was measured; and declared
//! maneuvers.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use aero::{Corrections, Flow};
use calibrate::Campaign;
use maneuver::{DeflectionAt, Rig, RigError, RigSettings, Run, Simulated, simulate_commanded};
use nastran::InputError;
use rayon::prelude::*;
use report::{Figure, Panel, Series, Style};
use serde_json::{Value, json};

use crate::args::{Common, SimulateArgs};
use crate::commands::simulate_maneuvers;
use crate::corrections::{CorrectedWing, campaign_path, corrected_wing, corrections_at};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::{progress, show};

impl From<RigError> for Failure {
    fn from(error: RigError) -> Self {
        match error {
            RigError::Coupling(coupling) => coupling.into(),
            RigError::Modes(modes) => Self::computation(modes),
        }
    }
}

/// A run or a maneuver flown with both models.
pub(crate) struct Flown {
    /// Its file.
    pub(crate) file: PathBuf,
    /// What moved, and what was measured.
    pub(crate) run: Run,
    /// Theory.
    pub(crate) initial: Simulated,
    /// With corrections of loads and deflections.
    pub(crate) updated: Simulated,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

/// Runs the command.
pub(crate) fn run(args: &SimulateArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let folder = campaign_path(args.campaign.as_deref());
    let files = if args.run.is_empty() && args.maneuver.is_empty() {
        listed_runs(&folder)?
    } else {
        args.run.clone()
    };
    refuse_twins(&files.iter().chain(&args.maneuver).cloned().collect::<Vec<_>>())?;
    let runs =
        files.iter().map(|file| Ok((file, Run::read(file)?))).collect::<Result<Vec<_>, InputError>>()?;
    let rho_kg_m3 = if runs.is_empty() { 0.0 } else { Campaign::read(&folder)?.rho_kg_m3 };
    let corrected =
        corrected_wing(args.wing.as_deref(), args.corrections.as_deref(), args.campaign.as_deref(), common)?;
    let maneuvers = simulate_maneuvers::read(&args.maneuver, &corrected)?;
    let settings = settings(&corrected);
    let rig = Rig::new(&corrected.wing, settings.clone())?;
    let bar = progress::bar(common, runs.len(), "flying runs");
    let mut flown = runs
        .into_par_iter()
        .map(|(file, run)| {
            let flown = fly(file, run, &rig, &corrected, rho_kg_m3);
            bar.inc(1);
            flown
        })
        .collect::<Result<Vec<_>, Failure>>()?;
    bar.finish_and_clear();
    flown.extend(simulate_maneuvers::fly(maneuvers, &rig, &settings, &corrected)?);
    for remark in
        flown.iter().flat_map(|flown| flown.remarks.iter().map(move |r| format!("{}: {r}", flown.run.name)))
    {
        show::note(&remark);
    }
    let seconds = start.elapsed().as_secs_f64();
    let result = json!({
        "command": "simulate",
        "corrections": corrected.origin,
        "deflection_correction": !corrected.file.deflection.is_empty(),
        "modes": rig.omega_rad_s().len(),
        "runs": flown.iter().map(run_result).collect::<Vec<_>>(),
        "seconds": seconds,
    });
    let out = write(&common.out("simulate"), &flown, &result)?;
    show::summary(common, &summary(&flown, &out, seconds));
    show::json(common, &result)
}

/// The runs of a campaign.
fn listed_runs(folder: &Path) -> Result<Vec<PathBuf>, InputError> {
    let listed_in = folder.join("campaign.ron");
    let runs = Campaign::read(folder)?.runs;
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
    let file = &corrected.file;
    let mut settings = RigSettings::new(file.damping_ratio, file.pitch_axis_x());
    if let (Some(planform), Some((system, _))) = (file.planform(), &corrected.wing.structure) {
        let node = |(name, grid): (String, u32)| system.node_index(grid).map(|node| (name, node));
        settings.sensors = planform.sensor_grids().into_iter().filter_map(node).collect();
    }
    settings
}

/// Flies a run with the initial and the updated model.
fn fly(
    file: &Path,
    run: Run,
    rig: &Rig<'_>,
    corrected: &CorrectedWing,
    rho_kg_m3: f64,
) -> Result<Flown, Failure> {
    let flow = Flow { v_m_s: run.v_m_s, rho_kg_m3 };
    let neutral = Corrections::neutral(corrected.wing.correctable.len());
    let (corrections, deflection) = at_airspeed(file, run.v_m_s, corrected)?;
    let beyond = run.controls_rad.iter().filter_map(|(name, commanded)| deflection.beyond(name, commanded));
    let remarks = beyond.map(|beyond| beyond.to_string()).collect();
    let simulate = |corrections: &Corrections, deflection: &DeflectionAt| -> Result<Simulated, Failure> {
        Ok(simulate_commanded(&run, &rig.at(flow, corrections)?, deflection, file)?)
    };
    let initial = simulate(&neutral, &DeflectionAt::default())?;
    let updated = simulate(&corrections, &deflection)?;
    Ok(Flown { file: file.to_path_buf(), initial, updated, run, remarks })
}

/// The corrections of loads and of deflections at the airspeed of a file; none without wind.
pub(crate) fn at_airspeed(
    file: &Path,
    v_m_s: f64,
    corrected: &CorrectedWing,
) -> Result<(Corrections, DeflectionAt), InputError> {
    if v_m_s == 0.0 {
        return Ok((Corrections::neutral(corrected.wing.correctable.len()), DeflectionAt::default()));
    }
    let corrections = corrections_at(&corrected.schedule, v_m_s).map_err(|refused| {
        InputError::in_file(file, refused.message)
            .with_help("calibrate at this airspeed, or leave this file out")
    })?;
    Ok((corrections, simulate_maneuvers::deflection_at(file, v_m_s, corrected)?))
}

fn write(out: &Path, flown: &[Flown], result: &Value) -> Result<PathBuf, Failure> {
    let folder = ResultFolder::begin(out)?;
    for flight in flown {
        folder.write_text(&format!("{}.csv", flight.run.name), &flight.updated.history.to_csv())?;
        let figure = figure(flight).svg().map_err(Failure::computation)?;
        folder.write_text(&format!("{}.svg", flight.run.name), &figure)?;
    }
    folder.write_json("result.json", result)?;
    folder.commit()
}

fn run_result(flown: &Flown) -> Value {
    let channels =
        |values: Option<[f64; 3]>| values.map(|v| json!({ "Fz_N": v[0], "Mx_Nm": v[1], "My_Nm": v[2] }));
    json!({
        "file": flown.file.display().to_string(),
        "V_m_s": flown.run.v_m_s,
        "samples": flown.run.len(),
        "residual_rms": { "initial": channels(flown.initial.residual_rms), "updated": channels(flown.updated.residual_rms) },
        "remarks": flown.remarks,
        "raw_percent": { "initial": channels(flown.initial.residual_percent), "updated": channels(flown.updated.residual_percent) },
    })
}

/// Loads measured, initial and updated, and what moved the wing.
fn figure(flown: &Flown) -> Figure {
    let t_s = &flown.run.t_s;
    let mut panels = Vec::new();
    for (c, (name, label)) in
        [("Fz_N", "Fz (N)"), ("Mx_Nm", "Mx (N m)"), ("My_Nm", "My (N m)")].into_iter().enumerate()
    {
        let of = |simulated: &Simulated| simulated.history.get(name).unwrap_or(&[]).to_vec();
        // the measurement first, so that its noise covers neither model
        let measured = flown.run.loads.as_ref().map(|loads| loads[c].clone());
        let mut series: Vec<Series> = measured
            .map(|values| Series::new("measured", t_s.clone(), values, Style::Line))
            .into_iter()
            .collect();
        series.push(Series::new("initial", t_s.clone(), of(&flown.initial), Style::DashedLine));
        series.push(Series::new("updated", t_s.clone(), of(&flown.updated), Style::Line));
        panels.push(Panel {
            title: String::new(),
            x_label: "time (s)".into(),
            y_label: label.into(),
            series,
        });
    }
    let alpha: Vec<f64> = flown.run.alpha_rad.iter().map(|alpha| alpha.to_degrees()).collect();
    let mut inputs = vec![Series::new("angle of attack", t_s.clone(), alpha, Style::Line)];
    for (name, values) in &flown.run.controls_rad {
        let degrees: Vec<f64> = values.iter().map(|delta| delta.to_degrees()).collect();
        if degrees.iter().any(|delta| *delta != 0.0) {
            inputs.push(Series::new(format!("{name} aileron, commanded"), t_s.clone(), degrees, Style::Line));
        }
    }
    panels.push(Panel {
        title: String::new(),
        x_label: "time (s)".into(),
        y_label: "angle (deg)".into(),
        series: inputs,
    });
    Figure { title: format!("{} at {:.1} m/s", flown.run.name, flown.run.v_m_s), panels, columns: 2 }
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
            simulated.residual_rms.map_or_else(|| largest_change(simulated, c), |rms| rms[c])
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
    format!("{text}\n{seconds:.2} s; results in {}\n", out.display())
}

/// Farthest that a load goes from its first sample.
fn largest_change(simulated: &Simulated, channel: usize) -> f64 {
    let values = simulated.history.get(["Fz_N", "Mx_Nm", "My_Nm"][channel]).unwrap_or(&[]);
    values.iter().map(|value| (value - values[0]).abs()).fold(0.0, f64::max)
}
