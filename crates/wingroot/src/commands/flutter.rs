//! `flutter`: flutter and divergence speeds of the wing, initial beside updated: eigenvalues of the simulations' state matrix
//! over airspeed, and p-k roots on the doublet lattice.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use aero::{Corrections, DlmSettings, DoubletLattice, Flow};
use calibrate::{Campaign, Schedule};
use coupling::{Geometry, WingFile};
use faer::Mat;
use maneuver::flutter::{
    Aeroelastic, Crossing, FlutterCurves, FlutterError, ModePressures, ScheduledForces, changes_of_stability,
    first_divergence, flutter_of_state_space,
};
use maneuver::{AirModel, Rig, RigSettings, SharedAir};
use nastran::InputError;
use report::Table;
use serde_json::Value;

use super::flutter_bent::{self, Asked, BentArgs};
use super::flutter_common::{HIGHEST, REDUCED, method};
use super::flutter_deck;
use super::flutter_figures::{self, Stability};
use crate::args::{Common, Given, airspeed};
use crate::commands::flutter_result::{FlutterResult, MethodSpeeds, StabilityResult, StabilitySpeeds};
use crate::commands::result_parts::as_json;
use crate::corrections::{CorrectedWing, corrected_wing};
use crate::ensemble::{Intervals, intervals_of};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Options of `flutter`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot flutter
  wingroot flutter --wing my_wing/wing.ron --campaign my_wing/campaign --to 60
  wingroot flutter --wing my_wing/wing.ron --nonlinear --alpha 3,5 --to 70
  wingroot flutter --deck my_aircraft.bdf")]
pub struct FlutterArgs {
    /// Wing, measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
    /// A Nastran deck instead of a wing: flutter as SOL 145 of it asks (FLUTTER, FLFACT, MKAERO1, MKAERO2), in its own units; or a study
    /// (.ron) of decks that lack something for it
    #[arg(long, value_name = "FILE", conflicts_with_all = ["wing", "campaign", "corrections", "accept_unconverged", "no_intervals", "to",
        "nonlinear", "alpha", "step", "density"])]
    pub(crate) deck: Option<PathBuf>,
    /// The subcase of the deck [default: all that select a FLUTTER]
    #[arg(long, value_name = "N", requires = "deck")]
    pub(crate) subcase: Option<u32>,
    /// Highest airspeed looked at, m/s [default: 100, up to which air is nearly incompressible]
    #[arg(long, value_name = "V", value_parser = airspeed)]
    pub(crate) to: Option<f64>,
    /// Large deflections.
    #[command(flatten)]
    pub(crate) bent: BentArgs,
}

/// Airspeeds looked at.
const SPEEDS: u32 = 100;
impl From<FlutterError> for Failure {
    fn from(error: FlutterError) -> Self {
        Self::computation(error)
    }
}

/// What no structure or correction changes.
struct Air {
    /// Of p-k.
    doublets: DoubletLattice,
    /// Of the rigs' state matrices.
    of_rigs: Option<Arc<SharedAir>>,
}

impl Air {
    fn of(corrected: &CorrectedWing) -> Result<Self, Failure> {
        let CorrectedWing { wing, ensemble, .. } = corrected;
        let doublets = DoubletLattice::new(&wing.lattice, wing.plane, 0.0, &DlmSettings::default())
            .map_err(Failure::computation)?;
        let doublets = if ensemble.is_some() { doublets.keeping_factors() } else { doublets };
        Ok(Self { doublets, of_rigs: corrected.shared_air(wing, AirModel::default())? })
    }
}

/// Everything both models share.
struct Task<'a> {
    corrected: &'a CorrectedWing,
    rig: Rig<'a>,
    pressures: ModePressures,
    rho_kg_m3: f64,
    speeds: Vec<f64>,
}

/// Runs the command.
pub(crate) fn run(args: &FlutterArgs, common: &Common) -> Result<(), Failure> {
    if let Some(deck) = &args.deck {
        return flutter_deck::run(deck, args.subcase, common);
    }
    let path = args.given.measured.wing_path()?;
    if args.bent.nonlinear || WingFile::read(&path)?.geometry == Geometry::Nonlinear {
        let asked = Asked { given: &args.given, bent: &args.bent, to: args.to };
        return flutter_bent::run(&asked, common);
    }
    args.bent.refuse()?;
    let start = Instant::now();
    let campaign = Campaign::read(&args.given.measured.campaign_path()?)?;
    let corrected = corrected_wing(&args.given)?;
    if corrected.wing.structure.is_none() {
        return Err(InputError::in_file(&corrected.file.path, "a rigid wing neither flutters nor diverges")
            .with_help("give the wing a structure")
            .into());
    }
    let highest = args.to.unwrap_or(HIGHEST);
    let air = Air::of(&corrected)?;
    let speeds: Vec<f64> = (1..=SPEEDS).map(|i| highest * f64::from(i) / f64::from(SPEEDS)).collect();
    let task = Task::new(&corrected, &air, campaign.rho_kg_m3, speeds)?;
    let neutral = Corrections::neutral(corrected.wing.correctable.len());
    let found = corrected.found()?;
    let of = |found| Task::new(found, &air, task.rho_kg_m3, task.speeds.clone());
    let of_found = found.as_ref().map(of).transpose()?;
    let updated = of_found.as_ref().unwrap_or(&task);
    let initial = task.stability("initial", &|_| neutral.clone(), &[(0.0, neutral.clone())])?;
    let models = [initial, updated.updated()?];
    let off = corrected.file.correction.prior.unsteady;
    let spread = updated.spread(&corrected, &air, &models[1], off)?;
    let result = FlutterResult {
        intervals_90: corrected.intervals_from().map(|from| Intervals { from, of_updated: spread }),
        ..task.result(&models, start.elapsed().as_secs_f64())
    };
    let told = intervals_told(&result, off);
    let result = as_json(&result)?;
    let folder = ResultFolder::begin(&common.out("flutter"))?;
    corrected.note_inputs(&folder)?;
    folder.input("campaign", &campaign.folder)?;
    for model in &models {
        for (method, curves) in [("state_matrix", &model.state_matrix), ("p_k", &model.p_k)] {
            folder.write_text(&format!("{}_{method}.csv", model.name), &flutter_figures::csv(curves))?;
        }
        folder.write_figure(model.name, flutter_figures::CAPTION, flutter_figures::figure(model))?;
    }
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let mut text = task.summary(&models) + &told;
    let _ = write!(text, "{:.1} s; results in {}", start.elapsed().as_secs_f64(), out.display());
    show::summary(common, &text);
    show::json(common, &result)
}

/// Intervals of the updated wing's speeds, for the console; where a wing of the ensemble has no such speed there is none.
fn intervals_told(result: &FlutterResult, unsteady: f64) -> String {
    let Some(Intervals { from, of_updated }) = &result.intervals_90 else {
        return "no intervals: no ensemble.ron of `calibrate` beside the corrections\n".to_owned();
    };
    let of = |(what, place, found): (&str, &str, Option<f64>)| {
        found?;
        let ends = of_updated.pointer(place);
        let end = |i: usize| ends.and_then(|ends| ends.get(i)).and_then(Value::as_f64);
        Some(match (end(0), end(1)) {
            (Some(low), Some(high)) => format!("{what} {low:.1} to {high:.1} m/s"),
            _ => format!("{what}: not all of them have it below {} m/s", result.highest_airspeed_m_s),
        })
    };
    let p_k = &result.updated.p_k;
    let each = [
        ("flutter", "/p_k/flutter_speed_m_s", p_k.speeds.flutter_speed_m_s),
        ("divergence", "/p_k/divergence_speed_m_s", p_k.speeds.divergence_speed_m_s),
    ];
    let told: Vec<String> = each.into_iter().filter_map(of).collect();
    if told.is_empty() {
        return String::new();
    }
    format!(
        "updated, 90 % intervals of p-k by {from} (corrections, stiffness, control surfaces) and {:.0} % of the air's unsteady part (correction.prior.unsteady): {}\n",
        100.0 * unsteady,
        told.join(", ")
    )
}

/// Area over span.
fn mean_chord_m(corrected: &CorrectedWing) -> f64 {
    let boxes = &corrected.wing.lattice.boxes;
    let area: f64 = boxes.iter().map(aero::AeroBox::area_m2).sum();
    let ys = || boxes.iter().flat_map(|panel| panel.corners.iter().map(|corner| corner.y));
    area / (ys().fold(f64::NEG_INFINITY, f64::max) - ys().fold(f64::INFINITY, f64::min))
}

fn sets(schedule: &Schedule) -> Vec<(f64, Corrections)> {
    schedule.sets.iter().map(|set| (set.v_m_s, set.corrections.clone())).collect()
}

impl<'a> Task<'a> {
    /// A wing's modes, and the pressures of them.
    fn new(
        corrected: &'a CorrectedWing,
        air: &Air,
        rho_kg_m3: f64,
        speeds: Vec<f64>,
    ) -> Result<Self, Failure> {
        let rig = corrected.rig(&RigSettings::of_wing(&corrected.file), air.of_rigs.as_deref())?;
        let kappa = REDUCED.map(|k| 2.0 * k / mean_chord_m(corrected));
        Ok(Self { pressures: rig.mode_pressures(&air.doublets, &kappa)?, corrected, rig, rho_kg_m3, speeds })
    }

    /// The wing with its corrections.
    fn updated(&self) -> Result<Stability, Failure> {
        let schedule = &self.corrected.schedule;
        self.stability("updated", &|v| schedule.at_or_nearest(v).0, &sets(schedule))
    }

    /// Speeds of the wing with its corrections, without curves of the state matrix.
    fn speeds(&self) -> Result<StabilitySpeeds, Failure> {
        let schedule = &self.corrected.schedule;
        let at = |v: f64| schedule.at_or_nearest(v).0;
        let (elastic, below) = self.below_divergence(&at)?;
        let changes = changes_of_stability(&below, |flow| self.state_matrix(flow, &at))?;
        let (p_k, modal) = self.p_k(&sets(schedule), &self.pressures)?;
        Ok(StabilitySpeeds::new(
            MethodSpeeds::new(&changes, elastic),
            MethodSpeeds::new(&p_k.crossings, modal),
        ))
    }

    /// Intervals of `updated`, the stability of this wing: from every wing of the ensemble of `corrected`, and from the air's unsteady part, which
    /// may be `off` by a share of it in p-k; the state matrix has its rational function as it was fitted.
    fn spread(
        &self,
        corrected: &CorrectedWing,
        air: &Air,
        updated: &Stability,
        off: f64,
    ) -> Result<Value, Failure> {
        let members = corrected.with_each(|member| {
            let task = Task::new(member, air, self.rho_kg_m3, self.speeds.clone())?;
            as_json(&task.speeds()?)
        })?;
        let StabilityResult { state_matrix, p_k, .. } = self.of_model(updated);
        let factors = if members.is_empty() { &[][..] } else { &[1.0 - off, 1.0 + off] };
        let of_factor = |factor: &f64| {
            let pressures = self.pressures.with_unsteady(*factor);
            let (p_k, modal) = self.p_k(&sets(&self.corrected.schedule), &pressures)?;
            as_json(&StabilitySpeeds::new(state_matrix.speeds, MethodSpeeds::new(&p_k.crossings, modal)))
        };
        let unsteady = factors.iter().map(of_factor).collect::<Result<_, Failure>>()?;
        let value = as_json(&StabilitySpeeds::new(state_matrix.speeds, p_k.speeds))?;
        Ok(intervals_of(&value, &[members, unsteady]))
    }

    /// The numbers of a model.
    fn of_model(&self, model: &Stability) -> StabilityResult {
        let state_matrix = method(&model.state_matrix, model.divergence[0], self.highest());
        let p_k = method(&model.p_k, model.divergence[1], self.highest());
        let speeds = StabilitySpeeds::new(state_matrix.speeds, p_k.speeds);
        StabilityResult { state_matrix, p_k, p_k_over_state_matrix: speeds.p_k_over_state_matrix }
    }

    fn flow(&self, v_m_s: f64) -> Flow {
        Flow { v_m_s, rho_kg_m3: self.rho_kg_m3 }
    }

    /// Both methods with corrections by airspeed, which the p-k solution mixes between `sets` as `at` does.
    fn stability(
        &self,
        name: &'static str,
        at: &dyn Fn(f64) -> Corrections,
        sets: &[(f64, Corrections)],
    ) -> Result<Stability, Failure> {
        let (elastic, below) = self.below_divergence(at)?;
        let state_matrix = flutter_of_state_space(&below, |flow| self.state_matrix(flow, at))?;
        let (p_k, modal) = self.p_k(sets, &self.pressures)?;
        Ok(Stability { name, state_matrix, p_k, divergence: [elastic, modal] })
    }

    /// Divergence speed of the flexible wing, and the flows below it: the rig refuses those beyond.
    fn below_divergence(&self, at: &dyn Fn(f64) -> Corrections) -> Result<(Option<f64>, Vec<Flow>), Failure> {
        let wing = &self.corrected.wing;
        let elastic = first_divergence(&self.speeds, |v| wing.divergence_speed(self.rho_kg_m3, &at(v)))?;
        let below = |v: &&f64| elastic.is_none_or(|limit| **v < limit);
        Ok((elastic, self.speeds.iter().filter(below).map(|v| self.flow(*v)).collect()))
    }

    fn state_matrix(&self, flow: Flow, at: &dyn Fn(f64) -> Corrections) -> Result<Mat<f64>, Failure> {
        Ok(self.rig.at(flow, &at(flow.v_m_s))?.a)
    }

    /// p-k with corrections by airspeed, and the divergence speed of the kept modes.
    fn p_k(
        &self,
        sets: &[(f64, Corrections)],
        pressures: &ModePressures,
    ) -> Result<(FlutterCurves, Option<f64>), Failure> {
        let table = |(v_m_s, corrections): &(f64, Corrections)| -> Result<_, Failure> {
            let padded = self.corrected.wing.padded(corrections)?;
            Ok((*v_m_s, self.rig.gaf_table(pressures, &padded)?))
        };
        let forces = ScheduledForces::new(sets.iter().map(table).collect::<Result<_, _>>()?)?;
        let damping = self.corrected.file.damping_ratio;
        let system = Aeroelastic::of_modes(self.rig.omega_rad_s(), damping, &forces)?;
        let all: Vec<Flow> = self.speeds.iter().map(|v| self.flow(*v)).collect();
        Ok((system.pk(&all)?, system.divergence_speed(self.rho_kg_m3, &self.speeds)?))
    }

    fn highest(&self) -> f64 {
        self.speeds[self.speeds.len() - 1]
    }

    fn result(&self, models: &[Stability; 2], seconds: f64) -> FlutterResult {
        let [initial, updated] = models.each_ref().map(|model| self.of_model(model));
        FlutterResult {
            command: "flutter",
            corrections: self.corrected.origin.clone(),
            corrections_held_outside_m_s: self.calibrated(),
            highest_airspeed_m_s: self.highest(),
            air_density_kg_m3: self.rho_kg_m3,
            modes: self.rig.omega_rad_s().len(),
            initial,
            updated,
            intervals_90: None,
            seconds,
        }
    }

    /// First and last airspeed of the corrections.
    fn calibrated(&self) -> [f64; 2] {
        let sets = &self.corrected.schedule.sets;
        [sets[0].v_m_s, sets[sets.len() - 1].v_m_s]
    }

    fn summary(&self, models: &[Stability]) -> String {
        let mut table =
            Table::new(&["model", "method", "flutter (m/s)", "frequency (Hz)", "divergence (m/s)"]);
        let number = |value: Option<f64>| value.map_or_else(|| "none".into(), |value| format!("{value:.3}"));
        for model in models {
            let methods = [("state matrix", &model.state_matrix), ("p-k, doublet lattice", &model.p_k)];
            for ((method, curves), divergence) in methods.into_iter().zip(model.divergence) {
                let flutter = curves.flutter();
                table.row(vec![
                    model.name.to_string(),
                    method.to_string(),
                    number(flutter.map(|crossing| crossing.flow.v_m_s)),
                    number(flutter.map(Crossing::frequency_hz)),
                    number(divergence),
                ]);
            }
        }
        let mut text = format!("{table}up to {} m/s at {} kg/m3\n", self.highest(), self.rho_kg_m3);
        for model in models {
            if let Some(ratio) = self.of_model(model).p_k_over_state_matrix {
                let _ = writeln!(
                    text,
                    "{}: p-k flutters {:+.2} % from the state matrix",
                    model.name,
                    100.0 * (ratio - 1.0)
                );
            }
            for lost in model.p_k.lost.iter().chain(&model.state_matrix.lost) {
                let _ = writeln!(text, "{}: {lost}", model.name);
            }
        }
        let [slow, fast] = self.calibrated();
        if self.highest() > fast {
            let _ = writeln!(
                text,
                "corrections were found from {slow} to {fast} m/s; outside, those of the nearest end are held"
            );
        }
        text
    }
}
