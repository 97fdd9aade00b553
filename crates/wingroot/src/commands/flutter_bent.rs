//! `flutter` with large deflections: p-k about the equilibrium of every airspeed, by angle of attack of the root.

use clap::Args;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::time::Instant;

use aero::{Corrections, DlmSettings, DoubletLattice, Flow};
use calibrate::Campaign;
use coupling::{LargeWing, WingFile};
use maneuver::flutter::{
    Aeroelastic, BentCrossing, BentFlutter, BentFlutterError, BentPoint, BentSweep, ScheduledForces,
};
use maneuver::{Rig, RigSettings};
use nastran::InputError;
use report::Table;

use super::flutter_bent_figures::{self as figures, Angle};
use super::flutter_bent_result::{BentAirspeed, BentChange, BentFlutterResult, RootAngle};
use super::flutter_common::{HIGHEST, REDUCED, method};
use super::flutter_result::MethodResult;
use super::result_parts::as_json;
use crate::args::{Common, Given, airspeed};
use crate::corrections::as_given;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Options of `flutter` for a wing that bends far.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct BentArgs {
    /// Flutter about the equilibrium of every airspeed [default: as the wing's `geometry` says]
    #[arg(long)]
    pub(crate) nonlinear: bool,
    /// With large deflections: angles of attack of the root, deg [default: 1,3,5]
    #[arg(long, value_name = "DEG,DEG", value_delimiter = ',', allow_negative_numbers = true)]
    pub(crate) alpha: Vec<f64>,
    /// With large deflections: airspeeds are this far apart, m/s [default: 2]
    #[arg(long, value_name = "V", value_parser = airspeed)]
    pub(crate) step: Option<f64>,
    /// With large deflections: density of the air, kg/m3 [default: the campaign's; without one 1.225]
    #[arg(long, value_name = "RHO")]
    pub(crate) density: Option<f64>,
}

/// What the command was asked for, of `flutter`'s options.
pub(super) struct Asked<'a> {
    pub(super) given: &'a Given,
    pub(super) bent: &'a BentArgs,
    /// Highest airspeed, m/s.
    pub(super) to: Option<f64>,
}

/// Angles of attack if none are named, degrees.
const ALPHAS_DEG: [f64; 3] = [1.0, 3.0, 5.0];
/// Beyond, the stream is no longer along the wing, degrees.
const STEEPEST_DEG: f64 = 45.0;
/// Airspeeds are so far apart if nothing is said, m/s.
const STEP_M_S: f64 = 2.0;
/// Airspeeds at most.
const MOST: usize = 1000;
/// Of the standard atmosphere at sea level, kg/m3.
const DENSITY: f64 = 1.225;
/// Tangent modes kept: torsion and chordwise bending of slender wings are among them.
const MODES: usize = 10;

impl From<BentFlutterError> for Failure {
    fn from(error: BentFlutterError) -> Self {
        match error {
            BentFlutterError::Coupling(error) => error.into(),
            other => Self::computation(other),
        }
    }
}

impl BentArgs {
    /// Refuses what small deflections have no use for.
    pub(super) fn refuse(&self) -> Result<(), InputError> {
        let named = [
            ("--alpha", !self.alpha.is_empty()),
            ("--step", self.step.is_some()),
            ("--density", self.density.is_some()),
        ];
        let Some((option, _)) = named.into_iter().find(|(_, is_there)| *is_there) else { return Ok(()) };
        let message = format!("{option} is of the wing that bends far, and this one's deflections are small");
        Err(InputError::general(message)
            .with_help("add --nonlinear, or `geometry: Nonlinear` to the wing's file"))
    }
}

/// What is asked for.
struct Task {
    file: WingFile,
    wing: LargeWing,
    /// Corrections by the airspeed they hold at; one neutral set without.
    sets: Vec<(f64, Corrections)>,
    schedule: Option<calibrate::Schedule>,
    rho_kg_m3: f64,
    airspeeds: Vec<f64>,
}

/// Runs the command.
pub(super) fn run(args: &Asked<'_>, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let alphas = alphas(&args.bent.alpha)?;
    let task = Task::of(args)?;
    let linear = task.linear()?;
    let mut angles = Vec::new();
    let total = alphas.len();
    for (done, alpha_deg) in alphas.into_iter().enumerate() {
        tracing::trace!(target: "progress", what = "root angles", done, total);
        angles.push(Angle { alpha_deg, sweep: task.sweep(alpha_deg)? });
    }
    let result = BentFlutterResult {
        command: "flutter",
        wing: task.file.name.clone(),
        corrections: args.given.corrections.as_ref().map(|path| path.display().to_string()),
        highest_airspeed_m_s: task.highest(),
        air_density_kg_m3: task.rho_kg_m3,
        modes: MODES,
        linear,
        root_angles: angles.iter().map(of_angle).collect(),
        seconds: start.elapsed().as_secs_f64(),
    };
    let folder = ResultFolder::begin(&common.out("flutter"))?;
    folder.input("wing", &task.file.path)?;
    if let Some(corrections) = &args.given.corrections {
        folder.input("corrections", corrections)?;
    }
    folder.write_text("roots.csv", &figures::csv(&angles))?;
    for (name, caption, figure) in figures::figures(&angles) {
        folder.write_figure(&name, caption, figure)?;
    }
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let mut text = summary(&result);
    let _ = write!(text, "{:.1} s; results in {}", result.seconds, out.display());
    show::summary(common, &text);
    show::json(common, &json)
}

/// Angles of attack in ascending order, degrees.
fn alphas(named: &[f64]) -> Result<Vec<f64>, InputError> {
    let mut alphas = if named.is_empty() { ALPHAS_DEG.to_vec() } else { named.to_vec() };
    if let Some(wrong) = alphas.iter().find(|alpha| !(-STEEPEST_DEG..=STEEPEST_DEG).contains(*alpha)) {
        let message = format!("--alpha is {wrong}, expected degrees from -{STEEPEST_DEG} to {STEEPEST_DEG}");
        return Err(InputError::general(message));
    }
    alphas.sort_by(f64::total_cmp);
    alphas.dedup();
    Ok(alphas)
}

impl Task {
    fn of(args: &Asked<'_>) -> Result<Self, Failure> {
        let (file, wing) = LargeWing::read(&args.given.measured.wing_path()?)?;
        let (highest, step) = (args.to.unwrap_or(HIGHEST), args.bent.step.unwrap_or(STEP_M_S));
        let Some(count) = (1..=MOST).find(|count| *count as f64 * step > 0.999 * highest) else {
            let message = format!("--step {step} gives more than {MOST} airspeeds up to {highest} m/s");
            return Err(InputError::general(message).with_help("take a longer step").into());
        };
        let airspeeds = (1..=count).map(|i| highest * i as f64 / count as f64).collect();
        let schedule = match &args.given.corrections {
            Some(path) => Some(args.given.schedule_of(path, &file, &wing.elastic)?),
            None => None,
        };
        schedule.iter().for_each(as_given);
        let boxes = wing.elastic.correctable.len();
        let sets = match &schedule {
            Some(schedule) => schedule.sets.iter().map(|set| (set.v_m_s, set.corrections.clone())).collect(),
            None => vec![(0.0, Corrections::neutral(boxes))],
        };
        Ok(Self { rho_kg_m3: density(args)?, file, wing, sets, schedule, airspeeds })
    }

    fn highest(&self) -> f64 {
        self.airspeeds[self.airspeeds.len() - 1]
    }

    fn corrections(&self, v_m_s: f64) -> Corrections {
        let found = self.schedule.as_ref().map(|schedule| schedule.at_or_nearest(v_m_s).0);
        found.unwrap_or_else(|| self.sets[0].1.clone())
    }

    fn sweep(&self, alpha_deg: f64) -> Result<BentSweep, Failure> {
        let bent = BentFlutter {
            wing: &self.wing,
            alpha_rad: alpha_deg.to_radians(),
            rho_kg_m3: self.rho_kg_m3,
            modes: MODES,
            damping_ratio: self.file.damping_ratio,
        };
        Ok(bent.over(&self.airspeeds, &|v_m_s| self.corrections(v_m_s))?)
    }

    /// p-k of the undeformed wing.
    fn linear(&self) -> Result<MethodResult, Failure> {
        let wing = &self.wing.elastic;
        let rig = Rig::new(wing, RigSettings::of_wing(&self.file))?;
        let doublets = DoubletLattice::new(&wing.lattice, wing.plane, 0.0, &DlmSettings::default())
            .map_err(Failure::computation)?;
        let chord_m = wing.correctable.mean_chord_m();
        let pressures = rig.mode_pressures(&doublets, &REDUCED.map(|k| 2.0 * k / chord_m))?;
        let mut tables = Vec::new();
        for (v_m_s, corrections) in &self.sets {
            tables.push((*v_m_s, rig.gaf_table(&pressures, &wing.padded(corrections)?)?));
        }
        let forces = ScheduledForces::new(tables)?;
        let system = Aeroelastic::of_modes(rig.omega_rad_s(), self.file.damping_ratio, &forces)?;
        let flow = |v_m_s: &f64| Flow { v_m_s: *v_m_s, rho_kg_m3: self.rho_kg_m3 };
        let curves = system.pk(&self.airspeeds.iter().map(flow).collect::<Vec<_>>())?;
        let divergence = system.divergence_speed(self.rho_kg_m3, &self.airspeeds)?;
        Ok(method(&curves, divergence, self.highest()))
    }
}

fn of_angle(angle: &Angle) -> RootAngle {
    let sweep = &angle.sweep;
    let mut remarks: Vec<String> = sweep.ended.iter().map(ToString::to_string).collect();
    let is_lost = |mode: &usize| sweep.points.iter().any(|point| point.roots[*mode].is_none());
    let lost: Vec<usize> = (0..MODES).filter(is_lost).collect();
    remarks.extend(lost.iter().map(|mode| format!("mode {} was not followed at all airspeeds", mode + 1)));
    let airspeed = |point: Option<&BentPoint>| point.map_or(0.0, |point| point.case.flow.v_m_s);
    let from_the_start = sweep.is_unstable_from_the_start();
    if from_the_start {
        let lowest = airspeed(sweep.points.first());
        remarks.push(format!(
            "unstable at {lowest} m/s already, the lowest airspeed looked at: take a shorter --step"
        ));
    } else if !sweep.crossings.iter().any(|crossing| crossing.unstable) {
        let reached = airspeed(sweep.points.last());
        let of = if lost.is_empty() { "" } else { " of the modes that were followed" };
        remarks.push(format!("no flutter{of} below {reached} m/s"));
    }
    let point = |point: &BentPoint| BentAirspeed {
        v_m_s: point.case.flow.v_m_s,
        tip_z_m: point.state.tip_m.z,
        tip_twist_deg: point.state.twist_rad.to_degrees(),
        divergence_gain: point.state.gain,
        natural_frequencies_hz: point.omega_rad_s.iter().map(|omega| omega / TAU).collect(),
    };
    let change = |crossing: &BentCrossing| BentChange {
        v_m_s: crossing.v_m_s,
        frequency_hz: crossing.frequency_hz,
        mode: crossing.branch + 1,
        tip_z_m: crossing.tip_z_m,
        becomes: if crossing.unstable { "unstable" } else { "stable" },
    };
    RootAngle {
        alpha_deg: angle.alpha_deg,
        points: sweep.points.iter().map(point).collect(),
        is_unstable_at_lowest_airspeed: from_the_start,
        changes_of_stability: sweep.crossings.iter().map(change).collect(),
        remarks,
    }
}

/// Density as named, of the campaign that is named or stands beside the wing, or at sea level; kg/m3.
fn density(args: &Asked<'_>) -> Result<f64, Failure> {
    if let Some(rho) = args.bent.density {
        if rho > 0.0 && rho <= 100.0 {
            return Ok(rho);
        }
        let message = format!("--density is {rho}, expected a density above 0 and up to 100 kg/m3");
        return Err(InputError::general(message).into());
    }
    match args.given.measured.campaign_path() {
        Ok(folder) => Ok(Campaign::read(&folder)?.rho_kg_m3),
        Err(_) => Ok(DENSITY),
    }
}

fn summary(result: &BentFlutterResult) -> String {
    let mut text = format!(
        "{}, up to {} m/s at {} kg/m3, large deflections\n",
        result.wing, result.highest_airspeed_m_s, result.air_density_kg_m3
    );
    let number = |value: Option<f64>| value.map_or_else(|| "none".into(), |value| format!("{value:.2} m/s"));
    let _ = writeln!(
        text,
        "undeformed: flutter {}, divergence {}",
        number(result.linear.speeds.flutter_speed_m_s),
        number(result.linear.speeds.divergence_speed_m_s)
    );
    let corrections = result.corrections.as_deref().map_or_else(
        || "none: the wing as theory has it; --corrections names those of a calibration".to_owned(),
        |path| format!("{path}, held at the nearest end outside the airspeeds that they were found at"),
    );
    let _ = writeln!(text, "corrections: {corrections}");
    let mut table = Table::new(&["root (deg)", "V (m/s)", "becomes", "frequency (Hz)", "mode", "tip z (m)"]);
    for angle in &result.root_angles {
        for change in &angle.changes_of_stability {
            table.row(vec![
                angle.alpha_deg.to_string(),
                format!("{:.2}", change.v_m_s),
                change.becomes.to_owned(),
                format!("{:.2}", change.frequency_hz),
                change.mode.to_string(),
                format!("{:.4}", change.tip_z_m),
            ]);
        }
    }
    let _ = write!(text, "{table}");
    for angle in &result.root_angles {
        for remark in &angle.remarks {
            let _ = writeln!(text, "root at {} degrees: {remark}", angle.alpha_deg);
        }
    }
    text
}
