//! Flies cases of a plan that share a state of loading, an altitude and an airspeed, with one model: one factorisation for the
//! trims, one linearisation for everything that is flown in time.

use crate::cases::file::Action as Own;
use crate::design_loads::instants::{FlownCase, FlownInstant};
use crate::error::AircraftError;
use crate::flight::air::FlightAir;
use crate::stations::nodal::{Component, NodalLoads};
use crate::stations::places::Station;
use crate::trim::case::{TrimAt, TrimTools};
use crate::trim::maneuvers::Steady;
use crate::trim::model::FlightModel;
use loads::matrix::{Action, Case};

/// What is done with a case that was flown: the case and its instants, and what gives nodal loads of an instant of it (none while
/// gradients are searched for).
pub type Done<'d, E> = dyn FnMut(FlownCase, &Nodal<'_>) -> Result<(), E> + 'd;
/// Nodal loads of an instant of a case.
pub type Nodal<'n> = dyn Fn(&FlownInstant) -> Option<NodalLoads> + 'n;

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
    /// Whether the worst gradients are searched for between the plan's, where it asks for that. The cases flown together must then
    /// have all gradients of a family.
    pub search: bool,
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
        let none = |_: &FlownInstant| None;
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
                Ok((flown, loads)) => done(flown, &|instant| (instant.t_s <= 0.0).then(|| loads.clone()))?,
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
            gradient_m: None,
            limit: None,
            loads: self.stations.iter().map(sums).collect(),
        };
        Ok((FlownCase { number, model: which, instants: vec![instant], ..FlownCase::default() }, loads))
    }
}

/// A case that cannot be flown, with the reason.
pub(super) fn refused(case: &Case, which: usize, error: &impl ToString) -> FlownCase {
    let refused = Some(error.to_string());
    FlownCase { number: case.number, model: which, refused, ..FlownCase::default() }
}
