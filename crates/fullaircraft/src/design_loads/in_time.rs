//! Cases that begin in level flight and move: one linearisation for all of them an axis of gusts.

use crate::aircraft::file::FlightPoint;
use crate::cases::file::Action as Own;
use crate::design_loads::fly::{Done, Nodal, PlanFlight, refused};
use crate::design_loads::instants::{FlownCase, FlownInstant, driving};
use crate::design_loads::search::{gust, searched};
use crate::error::AircraftError;
use crate::flight::drive::Drive;
use crate::flight::gust::{Gust, GustAxis};
use crate::flight::loads::{FlightLoads, FlownLoads, LoadedTrim};
use crate::stations::nodal::{Component, NodalLoads};
use crate::trim::case::TrimAt;
use crate::trim::maneuvers::Steady;
use crate::trim::model::FlightModel;
use loads::design::{Attitude, Direction};
use loads::matrix::{Action, Case};
use maneuver::motion::{MotionSpec, sampled};

/// Time step of flights, s.
pub const TIME_STEP_S: f64 = 0.002;
/// How long a flight goes on when the gust has passed, s.
pub(super) const AFTER_S: f64 = 0.8;
/// Gusts flown side by side.
const TOGETHER: usize = 8;

/// What the flight of a gust is given to, with its gradient, m.
type Each<'e, E> = dyn FnMut(FlownCase, &FlownLoads<'_>, f64) -> Result<(), E> + 'e;

/// A linearised flight and the cases that are flown with it.
pub(super) struct InTime<'f> {
    pub(super) plan: &'f PlanFlight<'f>,
    pub(super) flight: &'f FlightLoads<'f>,
    pub(super) axis: GustAxis,
    pub(super) which: usize,
    /// Highest frequency that the air is known at, Hz.
    pub(super) highest_hz: f64,
    /// Names of the drives.
    drives: Vec<String>,
}

impl PlanFlight<'_> {
    /// Flies cases that move.
    pub(super) fn fly_in_time<E: From<AircraftError>>(
        &self,
        model: &FlightModel<'_>,
        at: &TrimAt<'_>,
        which: usize,
        cases: &[&Case],
        done: &mut Done<'_, E>,
    ) -> Result<(), E> {
        let Some(air) = self.air.filter(|_| !cases.is_empty()) else { return Ok(()) };
        let v_m_s = at.v_m_s();
        let level = match at.solve(&Steady::Level.case(&self.tools.aircraft.file, v_m_s)) {
            Ok(level) => level,
            Err(error @ AircraftError::NotTrimmable { .. }) => {
                return cases.iter().try_for_each(|case| done(refused(case, which, &error), &|_| None));
            }
            Err(error) => return Err(error.into()),
        };
        let trimmed = at.trimmed(&level, &FlightPoint { v_m_s, load_factor: 1.0, pitch_rate_deg_s: 0.0 });
        for axis in [GustAxis::Vertical, GustAxis::Lateral] {
            let own: Vec<&Case> = cases.iter().copied().filter(|case| axis_of(case) == axis).collect();
            if own.is_empty() {
                continue;
            }
            let drives = self.drives(axis)?;
            let names = drives.iter().map(|drive| drive.name.clone()).collect();
            let steady = at.nodal_loads(&level);
            let trim = LoadedTrim { model, air, trimmed: &trimmed, steady, drives, axis };
            let flight = FlightLoads::new(trim, self.stations.to_vec(), TIME_STEP_S)?;
            let highest_hz = air.highest_hz(v_m_s);
            InTime { plan: self, flight: &flight, axis, which, highest_hz, drives: names }.fly(&own, done)?;
        }
        Ok(())
    }

    /// What moves in any motion of the plan, each once: which cases are flown together changes no digit of a flight.
    fn drives(&self, axis: GustAxis) -> Result<Vec<Drive>, AircraftError> {
        let mut drives: Vec<Drive> = Vec::new();
        let motions = self.maneuvers.iter().filter_map(|own| match own {
            Own::Motion(motion) if axis == GustAxis::Vertical => motion.control(),
            _ => None,
        });
        for name in motions {
            if drives.iter().all(|drive| drive.name != name) {
                drives.push(self.tools.aircraft.drive(name)?);
            }
        }
        Ok(drives)
    }

    fn motion(&self, case: &Case) -> Option<&MotionSpec> {
        let Action::Condition(place) = case.action else { return None };
        if let Own::Motion(motion) = &self.maneuvers[place] { Some(motion) } else { None }
    }
}

impl InTime<'_> {
    fn fly<E: From<AircraftError>>(&self, cases: &[&Case], done: &mut Done<'_, E>) -> Result<(), E> {
        let timed = self.stable(cases, done)?;
        let (rough, timed): (Vec<&Case>, Vec<&Case>) =
            timed.iter().partition(|case| matches!(case.action, Action::Turbulence { .. }));
        self.turbulence(&rough, done)?;
        for case in &timed {
            if let Some(motion) = self.plan.motion(case) {
                let place = self.drives.iter().position(|name| Some(name.as_str()) == motion.control());
                let samples = count(self.duration_s(case));
                let mut commands = vec![Vec::new(); self.drives.len()];
                if let Some(place) = place {
                    commands[place] = sampled(motion.kind(), TIME_STEP_S, samples);
                }
                let flown = self.flight.fly(None, &commands, samples);
                done(self.case(&flown, samples, case.number), &|instant| at_time(&flown, instant))?;
            }
        }
        self.gusts(&timed, done)
    }

    /// Flies gusts, those of one direction side by side; families whose worst gradients are searched for together.
    fn gusts<E: From<AircraftError>>(&self, cases: &[&Case], done: &mut Done<'_, E>) -> Result<(), E> {
        for direction in [Direction::Up, Direction::Down, Direction::Lateral] {
            let own = |case: &&&Case| matches!(case.action, Action::Discrete { direction: own, .. } if own == direction);
            let is_searched = |case: &&Case| {
                self.plan.search && matches!(case.action, Action::Discrete { refine: true, .. })
            };
            let (family, single): (Vec<&Case>, Vec<&Case>) =
                cases.iter().filter(own).copied().partition(is_searched);
            self.single(&single, done)?;
            let all = &mut |gusts: &[(usize, Gust)]| -> Result<Vec<(FlownCase, f64)>, E> {
                let mut flown = Vec::new();
                self.fly_gusts(gusts, &mut |case, _, gradient_m| {
                    flown.push((case, gradient_m));
                    Ok::<(), E>(())
                })?;
                Ok(flown)
            };
            for flown in searched(&family, self.axis, all)? {
                done(flown, &|_| None)?;
            }
        }
        Ok(())
    }

    /// Flies gusts whose gradients stay as they are.
    fn single<E: From<AircraftError>>(&self, cases: &[&Case], done: &mut Done<'_, E>) -> Result<(), E> {
        let gusts: Vec<(usize, Gust)> =
            cases.iter().filter_map(|case| Some((case.number, gust(case, None)?))).collect();
        self.fly_gusts(&gusts, &mut |flown_case, flown, _| {
            let of = cases.iter().find(|case| case.number == flown_case.number);
            let nodal: &Nodal<'_> = &|instant| {
                if instant.gradient_m.is_none() {
                    return at_time(flown, instant);
                }
                let found = gust(of?, instant.gradient_m)?;
                let samples = count(found.length_m / self.flight.v_m_s() + AFTER_S);
                at_time(&self.flight.fly(Some(found), &[], samples), instant)
            };
            done(flown_case, nodal)
        })
    }

    /// Flies gusts side by side, each with the number of its case.
    fn fly_gusts<E>(&self, gusts: &[(usize, Gust)], each: &mut Each<'_, E>) -> Result<(), E> {
        let v_m_s = self.flight.v_m_s();
        let mut sorted = gusts.to_vec();
        sorted.sort_by(|a, b| a.1.length_m.total_cmp(&b.1.length_m));
        for together in sorted.chunks(TOGETHER) {
            let longest_m = together.iter().map(|(_, gust)| gust.length_m).fold(0.0, f64::max);
            let samples = count(longest_m / v_m_s + AFTER_S);
            let all: Vec<Gust> = together.iter().map(|(_, gust)| *gust).collect();
            for ((number, gust), flown) in together.iter().zip(self.flight.fly_gusts(&all, samples)) {
                // what counts of a flight does not depend on what is flown beside it
                let case = self.case(&flown, count(gust.length_m / v_m_s + AFTER_S), *number);
                each(case, &flown, gust.length_m / 2.0)?;
            }
        }
        Ok(())
    }

    /// A flight by the instants that can drive a load.
    fn case(&self, flown: &FlownLoads<'_>, samples: usize, number: usize) -> FlownCase {
        let stations = self.plan.stations.len();
        let net = |station: usize, sample: usize| flown.at_station(station, Component::Net, sample);
        let driving = driving(&net, stations, samples.min(flown.t_s.len()), self.axis);
        let instants = driving.iter().map(|sample| FlownInstant::of(flown, stations, *sample)).collect();
        FlownCase { number, model: self.which, instants, ..FlownCase::default() }.if_finite()
    }

    /// Cases but those with a motion that doubles while they are flown: their loads are those of the time flown, and are refused; so
    /// are those of turbulence that lasts as long as the longest gust, unless airspeed and attitude are held there.
    fn stable<'c, E: From<AircraftError>>(
        &self,
        cases: &[&'c Case],
        done: &mut Done<'_, E>,
    ) -> Result<Vec<&'c Case>, E> {
        let Some(doubling_s) = self.flight.doubling_s() else { return Ok(cases.to_vec()) };
        let (stable, unstable): (Vec<&Case>, Vec<&Case>) =
            cases.iter().partition(|case| doubling_s > self.duration_s(case));
        for case in unstable {
            done(refused(case, self.which, &unstable_words(doubling_s)), &|_| None)?;
        }
        Ok(stable)
    }

    /// How long an aircraft flies a case, s: in turbulence as long as in the longest gust, and for no time where it is held.
    fn duration_s(&self, case: &Case) -> f64 {
        let flown_m = match case.action {
            Action::Turbulence { attitude: Attitude::Held, .. } => return 0.0,
            Action::Turbulence { longest_gradient_m, .. } => Some(2.0 * longest_gradient_m),
            _ => gust(case, None).map(|gust| gust.length_m),
        };
        let moved_s = self.plan.motion(case).map_or(0.0, MotionSpec::record_s);
        flown_m.map_or(moved_s, |flown_m| flown_m / self.flight.v_m_s()) + AFTER_S
    }
}

/// Why an unstable flight is refused.
pub(super) fn unstable_words(doubling_s: f64) -> String {
    format!(
        "level flight is unstable with this mass, a motion doubles in {doubling_s:.2} s: loads would grow with the time flown (an \
         aircraft that is stabilised needs its control laws)"
    )
}

/// Which way the air of a case's gusts moves.
pub fn axis_of(case: &Case) -> GustAxis {
    match case.action {
        Action::Discrete { direction: Direction::Lateral, .. }
        | Action::Turbulence { direction: Direction::Lateral, .. } => GustAxis::Lateral,
        _ => GustAxis::Vertical,
    }
}

fn at_time(flown: &FlownLoads<'_>, instant: &FlownInstant) -> Option<NodalLoads> {
    let at = flown.t_s.iter().position(|known| (known - instant.t_s).abs() < 0.5 * TIME_STEP_S)?;
    Some(flown.nodal_loads(at))
}

/// Samples of a duration.
fn count(duration_s: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "files allow 0 to 600 s")]
    let steps = (duration_s / TIME_STEP_S).ceil() as usize;
    steps + 1
}

impl FlownCase {
    /// The case, or a refusal if one of its loads is not finite.
    pub(super) fn if_finite(self) -> Self {
        let finite =
            |instant: &FlownInstant| instant.loads.iter().flatten().flatten().all(|load| load.is_finite());
        if self.instants.iter().all(finite) {
            return self;
        }
        let refused = Some("its loads are not finite: a motion grows beyond all numbers".to_owned());
        Self { refused, instants: Vec::new(), ..self }
    }
}
