//! Flies cases of a plan that share a state of loading, an altitude and an airspeed, with one model: one factorisation for the
//! trims, one linearisation for everything that is flown in time.

use crate::aircraft::file::FlightPoint;
use crate::cases::file::Action as Own;
use crate::design_loads::instants::{FlownCase, FlownInstant, driving};
use crate::error::AircraftError;
use crate::flight::air::FlightAir;
use crate::flight::drive::Drive;
use crate::flight::gust::Gust;
use crate::flight::loads::{FlightLoads, FlownLoads, LoadedTrim};
use crate::stations::nodal::{Component, NodalLoads};
use crate::stations::places::Station;
use crate::trim::case::{TrimAt, TrimTools};
use crate::trim::maneuvers::Steady;
use crate::trim::model::FlightModel;
use loads::design::Direction;
use loads::matrix::{Action, Case};
use maneuver::motion::{MotionSpec, sampled};

/// Time step of flights, s.
pub const TIME_STEP_S: f64 = 0.002;
/// How long a flight goes on when the gust has passed, s.
const AFTER_S: f64 = 0.8;
/// Gusts flown side by side.
const TOGETHER: usize = 8;

/// What is done with a case that was flown: the case and its instants, and what gives nodal loads at a time, s.
pub type Done<'d, E> = dyn FnMut(FlownCase, &dyn Fn(f64) -> Option<NodalLoads>) -> Result<(), E> + 'd;

/// Everything that cases of one state of loading are flown with.
#[derive(Debug)]
pub struct PlanFlight<'a> {
    /// Variables of trims.
    pub tools: &'a TrimTools<'a>,
    /// Its unsteady air, if anything is flown in time.
    pub air: Option<&'a FlightAir>,
    /// Stations.
    pub stations: &'a [Station],
    /// The plan's own maneuvers, in the order of the matrix' conditions.
    pub maneuvers: &'a [Own],
}

impl PlanFlight<'_> {
    /// Flies cases at one altitude and airspeed with `model` (number `which` of the two), in that altitude's air. `done` gets each, and
    /// may stop the rest.
    ///
    /// # Errors
    /// Unknown names, and what `done` says. What cannot be trimmed is a result.
    pub fn fly<E: From<AircraftError>>(
        &self,
        model: &FlightModel<'_>,
        which: usize,
        cases: &[&Case],
        done: &mut Done<'_, E>,
    ) -> Result<(), E> {
        let Some(first) = cases.first() else { return Ok(()) };
        let none = |_: f64| None;
        let at = match self.tools.at(model, first.v_m_s) {
            Ok(at) => at,
            Err(error) => {
                return cases.iter().try_for_each(|case| done(refused(case, which, &error), &none));
            }
        };
        let (trims, moving): (Vec<&Case>, Vec<&Case>) =
            cases.iter().copied().partition(|case| self.steady(case).is_some());
        for case in trims {
            let steady = self.steady(case).unwrap_or(Steady::Level);
            match self.trim(&at, case.number, which, &steady) {
                Ok((flown, loads)) => done(flown, &|t_s| (t_s <= 0.0).then(|| loads.clone()))?,
                Err(error @ AircraftError::NotTrimmable { .. }) => done(refused(case, which, &error), &none)?,
                Err(error) => return Err(error.into()),
            }
        }
        self.fly_in_time(model, &at, which, &moving, done)
    }

    /// The trim that a case is, if it is one.
    fn steady(&self, case: &Case) -> Option<Steady> {
        match case.action {
            Action::Trim => Some(Steady::Pull { load_factor: case.n_z }),
            Action::Condition(place) => match &self.maneuvers[place] {
                Own::Steady(steady) => Some(steady.clone()),
                Own::Motion(_) => None,
            },
            _ => None,
        }
    }

    fn trim(
        &self,
        at: &TrimAt<'_>,
        number: usize,
        which: usize,
        steady: &Steady,
    ) -> Result<(FlownCase, NodalLoads), AircraftError> {
        let aircraft = self.tools.aircraft;
        let balanced = at.solve(&steady.case(&aircraft.file, at.v_m_s()))?;
        let loads = at.nodal_loads(&balanced);
        let points = aircraft.free.points();
        let parts = Component::ALL.map(|component| loads.of(component));
        let sums = |station: &Station| std::array::from_fn(|part| station.sums(points, &parts[part]));
        let instant = FlownInstant {
            t_s: 0.0,
            tips_m: at.tip_deflection_m(&balanced),
            loads: self.stations.iter().map(sums).collect(),
        };
        Ok((FlownCase { number, model: which, refused: None, instants: vec![instant] }, loads))
    }

    fn fly_in_time<E: From<AircraftError>>(
        &self,
        model: &FlightModel<'_>,
        at: &TrimAt<'_>,
        which: usize,
        cases: &[&Case],
        done: &mut Done<'_, E>,
    ) -> Result<(), E> {
        let Some(air) = self.air.filter(|_| !cases.is_empty()) else { return Ok(()) };
        let aircraft = self.tools.aircraft;
        let v_m_s = at.v_m_s();
        let level = at.solve(&Steady::Level.case(&aircraft.file, v_m_s));
        let level = match level {
            Ok(level) => level,
            Err(error @ AircraftError::NotTrimmable { .. }) => {
                return cases.iter().try_for_each(|case| done(refused(case, which, &error), &|_| None));
            }
            Err(error) => return Err(error.into()),
        };
        let trimmed = at.trimmed(&level, &FlightPoint { v_m_s, load_factor: 1.0, pitch_rate_deg_s: 0.0 });
        let drives = self.drives(cases)?;
        let names: Vec<String> = drives.iter().map(|drive| drive.name.clone()).collect();
        let steady = at.nodal_loads(&level);
        let trim = LoadedTrim { model, air, trimmed: &trimmed, steady, drives };
        let flight = FlightLoads::new(trim, self.stations.to_vec(), TIME_STEP_S)?;
        let cases = self.stable(&flight, which, cases, done)?;
        let cases = &cases;
        for case in cases {
            if let Some(motion) = self.motion(case) {
                let place = names.iter().position(|name| Some(name.as_str()) == motion.control());
                let samples = count(self.duration_s(case, v_m_s));
                let mut commands = vec![Vec::new(); names.len()];
                if let Some(place) = place {
                    commands[place] = sampled(motion.kind(), TIME_STEP_S, samples);
                }
                self.give(&flight.fly(None, &commands, samples), samples, (case.number, which), done)?;
            }
        }
        let mut gusts: Vec<(&Case, Gust)> =
            cases.iter().filter_map(|case| Some((*case, gust(case)?))).collect();
        gusts.sort_by(|a, b| a.1.length_m.total_cmp(&b.1.length_m));
        for together in gusts.chunks(TOGETHER) {
            let longest_m = together.iter().map(|(_, gust)| gust.length_m).fold(0.0, f64::max);
            let samples = count(longest_m / v_m_s + AFTER_S);
            let all: Vec<Gust> = together.iter().map(|(_, gust)| *gust).collect();
            for ((case, _), flown) in together.iter().zip(flight.fly_gusts(&all, samples)) {
                // what counts of a flight does not depend on what is flown beside it
                let own = count(self.duration_s(case, v_m_s));
                self.give(&flown, own, (case.number, which), done)?;
            }
        }
        Ok(())
    }

    /// Hands over a flight by the instants that can drive a load.
    fn give<E: From<AircraftError>>(
        &self,
        flown: &FlownLoads<'_>,
        samples: usize,
        (number, which): (usize, usize),
        done: &mut Done<'_, E>,
    ) -> Result<(), E> {
        let driving = driving(flown, self.stations.len(), samples);
        let of = |sample: &usize| FlownInstant::of(flown, self.stations.len(), *sample);
        let instants = driving.iter().map(of).collect();
        let case = FlownCase { number, model: which, refused: None, instants };
        done(case.if_finite(), &|t_s| {
            let at = flown.t_s.iter().position(|known| (known - t_s).abs() < 0.5 * TIME_STEP_S)?;
            Some(flown.nodal_loads(at))
        })
    }

    /// Cases but those with a motion that doubles while they are flown: their loads are those of the time flown, and are refused.
    fn stable<'c, E: From<AircraftError>>(
        &self,
        flight: &FlightLoads<'_>,
        which: usize,
        cases: &[&'c Case],
        done: &mut Done<'_, E>,
    ) -> Result<Vec<&'c Case>, E> {
        let Some(doubling_s) = flight.doubling_s() else { return Ok(cases.to_vec()) };
        let (stable, unstable): (Vec<&Case>, Vec<&Case>) =
            cases.iter().partition(|case| doubling_s > self.duration_s(case, flight.v_m_s()));
        let why = format!(
            "level flight is unstable with this mass, a motion doubles in {doubling_s:.2} s: loads would grow with the time flown (an \
             aircraft that is stabilised needs its control laws)"
        );
        for case in unstable {
            let refused = FlownCase {
                number: case.number,
                model: which,
                refused: Some(why.clone()),
                instants: Vec::new(),
            };
            done(refused, &|_| None)?;
        }
        Ok(stable)
    }

    /// How long a case is flown in time, s.
    fn duration_s(&self, case: &Case, v_m_s: f64) -> f64 {
        let moved_s = self.motion(case).map_or(0.0, MotionSpec::record_s);
        gust(case).map_or(moved_s, |gust| gust.length_m / v_m_s) + AFTER_S
    }

    fn motion(&self, case: &Case) -> Option<&MotionSpec> {
        let Action::Condition(place) = case.action else { return None };
        if let Own::Motion(motion) = &self.maneuvers[place] { Some(motion) } else { None }
    }

    /// What moves in the cases, each once.
    fn drives(&self, cases: &[&Case]) -> Result<Vec<Drive>, AircraftError> {
        let mut drives: Vec<Drive> = Vec::new();
        for name in cases.iter().filter_map(|case| self.motion(case)?.control()) {
            if drives.iter().all(|drive| drive.name != name) {
                drives.push(self.tools.aircraft.drive(name)?);
            }
        }
        Ok(drives)
    }
}

/// The gust of a case; vertical ones alone are flown.
fn gust(case: &Case) -> Option<Gust> {
    let Action::Discrete { gradient_m, direction, u_ds_m_s } = case.action else { return None };
    let up = match direction {
        Direction::Up => 1.0,
        Direction::Down => -1.0,
        Direction::Lateral => return None,
    };
    Some(Gust { velocity_m_s: up * u_ds_m_s, length_m: 2.0 * gradient_m, start_s: 0.0 })
}

/// Why a case is of a kind that is not flown, if it is.
pub fn unflown(case: &Case) -> Option<&'static str> {
    match case.action {
        Action::Turbulence { .. } => Some("continuous turbulence is not flown"),
        Action::Discrete { direction: Direction::Lateral, .. } => Some("lateral gusts are not flown"),
        _ => None,
    }
}

fn refused(case: &Case, which: usize, error: &AircraftError) -> FlownCase {
    FlownCase { number: case.number, model: which, refused: Some(error.to_string()), instants: Vec::new() }
}

/// Samples of a duration.
fn count(duration_s: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "files allow 0 to 600 s")]
    let steps = (duration_s / TIME_STEP_S).ceil() as usize;
    steps + 1
}

impl FlownCase {
    /// The case, or a refusal if one of its loads is not finite.
    fn if_finite(self) -> Self {
        let finite =
            |instant: &FlownInstant| instant.loads.iter().flatten().flatten().all(|load| load.is_finite());
        if self.instants.iter().all(finite) {
            return self;
        }
        let refused = Some("its loads are not finite: a motion grows beyond all numbers".to_owned());
        Self { refused, instants: Vec::new(), ..self }
    }
}
