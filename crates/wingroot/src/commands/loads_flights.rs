//! Flying a plan's cases: an aircraft for each state of loading, groups of cases on all threads, finished cases kept.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Mutex;

use aero::Corrections;
use fullaircraft::cases::file::Action;
use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::fly::{Nodal, PlanFlight};
use fullaircraft::design_loads::instants::{FlownCase, FlownInstant};
use fullaircraft::{Aircraft, CasesFile, FlightAir, NodalLoads, Station, TrimTools};
use loads::matrix::{Action as Planned, Case, Status};
use loads::select::Instant;
use loads::select::file::Model;
use loads::{Air, Design, Matrix};
use rayon::prelude::*;

use crate::args::Common;
use crate::commands::fullaircraft_prepared::Prepared;
use crate::failure::Failure;
use crate::progress;
use crate::store::{Inputs, Store};

/// A plan ready to be flown.
pub(crate) struct Flights<'a> {
    pub(crate) plan: &'a CasesFile,
    pub(crate) design: &'a Design,
    pub(crate) matrix: &'a Matrix,
    pub(crate) stations: Vec<Station>,
    /// Numbers of the grids, in the order of the nodes.
    pub(crate) grids: Vec<u32>,
    pub(crate) maneuvers: Vec<Action>,
    corrections: &'a Corrections,
    inputs: Inputs,
    /// The aircraft in each state of loading with its unsteady air.
    aircraft: Vec<(Aircraft, Option<FlightAir>)>,
}

/// What came of the cases, in the order of models and numbers.
pub(crate) struct Flown {
    pub(crate) cases: Vec<FlownCase>,
}

/// An instant of a case that is asked for.
pub(crate) struct Wanted<'f> {
    pub(crate) model: usize,
    pub(crate) number: usize,
    /// From zero.
    pub(crate) instant: usize,
    pub(crate) flown: &'f FlownInstant,
}

/// An instant of a case flown again, with what was not kept of the first flight.
pub(crate) struct FlownAgain {
    pub(crate) model: usize,
    pub(crate) number: usize,
    /// From zero.
    pub(crate) instant: usize,
    pub(crate) nodal: NodalLoads,
}

/// What is done with a flown case and what gives its nodal loads at an instant.
type Each<'e> = dyn Fn(&Case, FlownCase, &Nodal<'_>) -> Result<(), Failure> + Sync + 'e;

/// Cases that share a state of loading, altitude and airspeed, and the model they are flown with.
type Group<'m> = (usize, Vec<&'m Case>);

impl<'a> Flights<'a> {
    /// The aircraft in every state of loading.
    pub(crate) fn new(
        prepared: &'a Prepared,
        plan: &'a CasesFile,
        design: &'a Design,
        maneuvers: Vec<Action>,
        matrix: &'a Matrix,
    ) -> Result<Self, Failure> {
        let base = &prepared.aircraft;
        let stations = base.loads_stations(plan)?;
        let in_time = |case: &&Case| case.status == Status::Planned && is_in_time(case, &maneuvers);
        let aircraft = design.masses.iter().enumerate().map(|(mass, loading)| {
            let aircraft = base.loaded(loading)?;
            let moves = matrix.cases.iter().filter(in_time).any(|case| case.mass == mass);
            let air = if moves { Some(FlightAir::new(&aircraft)?) } else { None };
            Ok::<_, Failure>((aircraft, air))
        });
        let aircraft = aircraft.collect::<Result<Vec<_>, _>>()?;
        let depends = base.inputs_of_cases(&prepared.corrections, plan);
        let depends = depends.iter().fold(Inputs::default(), |all, (name, text)| all.with(name, text));
        let inputs = depends.with("design", &format!("{design:?} {maneuvers:?}"));
        let corrections = &prepared.corrections;
        let grids = base.free.node_ids().to_vec();
        Ok(Self { plan, design, matrix, stations, grids, maneuvers, corrections, inputs, aircraft })
    }

    /// Flies what is not finished; each case is kept as soon as it is there.
    pub(crate) fn fly(&self, target: &Path, common: &Common) -> Result<(Flown, Store), Failure> {
        let store = Store::beside(target, self.inputs.clone())?;
        let planned = || self.matrix.cases.iter().filter(|case| case.status == Status::Planned);
        let known: Vec<FlownCase> = planned()
            .flat_map(|case| [0, 1].map(|model| store.get::<FlownCase>(&part(case, model))))
            .flatten()
            .collect();
        let mut finished: BTreeSet<(usize, usize)> =
            known.iter().map(|case| (case.model, case.number)).collect();
        let mut known = known;
        for family in self.families() {
            for model in [0, 1] {
                // what is searched for between gradients depends on all of them
                if !family.iter().all(|number| finished.contains(&(model, *number))) {
                    finished.retain(|(of, number)| *of != model || !family.contains(number));
                }
            }
        }
        known.retain(|case| finished.contains(&(case.model, case.number)));
        let missing: Vec<(usize, &Case)> = planned()
            .flat_map(|case| [(0, case), (1, case)])
            .filter(|(model, case)| !finished.contains(&(*model, case.number)))
            .collect();
        let bar = progress::bar(common, missing.len(), "cases");
        let results = Mutex::new(Vec::new());
        self.each(&missing, true, &|case, flown, _| {
            let kept = store.put(&part(case, flown.model), &flown)?;
            results.lock().map_err(Failure::computation)?.push(kept);
            bar.inc(1);
            Ok(())
        })?;
        progress::end(&bar);
        let mut cases = results.into_inner().map_err(Failure::computation)?;
        cases.extend(known);
        cases.sort_by_key(|case| (case.model, case.number));
        Ok((Flown { cases }, store))
    }

    /// Numbers of the planned gusts whose worst gradients are searched for together.
    fn families(&self) -> Vec<Vec<usize>> {
        let mut families: Vec<(String, Vec<usize>)> = Vec::new();
        for case in self.matrix.cases.iter().filter(|case| case.status == Status::Planned) {
            let Planned::Discrete { direction, refine: true, .. } = case.action else { continue };
            let key = format!("{} {:?} {:?} {direction:?}", case.mass, case.h_m, case.v_m_s);
            match families.iter_mut().find(|family| family.0 == key) {
                Some(family) => family.1.push(case.number),
                None => families.push((key, vec![case.number])),
            }
        }
        families.into_iter().map(|family| family.1).collect()
    }

    /// Instants flown again, in this order.
    pub(crate) fn again(&self, wanted: &[Wanted<'_>]) -> Result<Vec<FlownAgain>, Failure> {
        let mut cases: Vec<(usize, &Case)> = Vec::new();
        for &Wanted { model, number, .. } in wanted {
            if !cases.iter().any(|(m, case)| *m == model && case.number == number) {
                let case = self.matrix.cases.iter().find(|case| case.number == number);
                cases.extend(case.map(|case| (model, case)));
            }
        }
        let found = Mutex::new(Vec::new());
        self.each(&cases, false, &|case, flown, loads| {
            for &Wanted { model, number, instant, flown: first } in wanted {
                if (model, number) == (flown.model, case.number) {
                    let nodal = loads(first).ok_or_else(|| {
                        Failure::Computation(format!("case {number} has no instant {}", instant + 1))
                    })?;
                    let again = FlownAgain { model, number, instant, nodal };
                    found.lock().map_err(Failure::computation)?.push(again);
                }
            }
            Ok(())
        })?;
        let mut found = found.into_inner().map_err(Failure::computation)?;
        let place = |of: &FlownAgain| {
            let same = |want: &Wanted<'_>| {
                (want.model, want.number, want.instant) == (of.model, of.number, of.instant)
            };
            wanted.iter().position(same)
        };
        found.sort_by_key(place);
        Ok(found)
    }

    /// Flies cases with models, groups side by side; worst gradients are searched for if asked to.
    fn each(&self, cases: &[(usize, &Case)], search: bool, done: &Each<'_>) -> Result<(), Failure> {
        let mut groups: Vec<Group<'_>> = Vec::new();
        for (model, case) in cases {
            let same = |group: &&mut Group<'_>| {
                let first = group.1[0];
                group.0 == *model && (first.mass, first.h_m, first.v_m_s) == (case.mass, case.h_m, case.v_m_s)
            };
            match groups.iter_mut().find(same) {
                Some(group) => group.1.push(case),
                None => groups.push((*model, vec![case])),
            }
        }
        let tools = self.aircraft.iter().map(|(aircraft, _)| TrimTools::new(aircraft, &[]));
        let tools = tools.collect::<Result<Vec<_>, _>>()?;
        tools.iter().try_for_each(|tools| self.plan.check_names(tools))?;
        groups.par_iter().try_for_each(|(which, cases)| {
            let first = cases[0];
            let (aircraft, air) = &self.aircraft[first.mass];
            let model = match which {
                0 => aircraft.uncorrected(),
                _ => aircraft.with_corrections(self.corrections)?,
            };
            let model = model.in_air(Air::at(first.h_m).rho_kg_m3);
            let flight = PlanFlight {
                tools: &tools[first.mass],
                air: air.as_ref(),
                stations: &self.stations,
                maneuvers: &self.maneuvers,
                search,
            };
            flight.fly(&model, *which, cases, &mut |flown: FlownCase, loads| {
                let case = cases.iter().find(|case| case.number == flown.number).unwrap_or(&first);
                done(case, flown, loads)
            })
        })
    }
}

/// What a case is called in the store: what is flown, and its number, which its result holds.
fn part(case: &Case, model: usize) -> String {
    let Case { number, mass, h_m, v_m_s, n_z, action, .. } = case;
    format!("{model} {mass} {h_m:?} {v_m_s:?} {n_z:?} {action:?} {number}")
}

/// Whether a case is flown in time.
pub(crate) fn is_in_time(case: &Case, maneuvers: &[Action]) -> bool {
    match case.action {
        Planned::Trim => false,
        Planned::Condition(place) => matches!(maneuvers[place], Action::Motion(_)),
        Planned::Discrete { .. } | Planned::Turbulence { .. } => true,
    }
}

impl Flown {
    /// All instants for a selection.
    pub(crate) fn instants(&self) -> Vec<Instant> {
        let of = |case: &FlownCase| {
            let model = if case.model == 0 { Model::Initial } else { Model::Updated };
            let number = case.number;
            let one = move |(instant, flown): (usize, &_)| {
                let flown: &FlownInstant = flown;
                Instant { model, case: number, instant: instant + 1, loads: flown.net() }
            };
            case.instants.iter().enumerate().map(one).collect::<Vec<_>>()
        };
        self.cases.iter().flat_map(of).collect()
    }

    /// A case flown with a model.
    pub(crate) fn case(&self, model: usize, number: usize) -> Option<&FlownCase> {
        let place = self.cases.binary_search_by_key(&(model, number), |case| (case.model, case.number));
        place.ok().map(|place| &self.cases[place])
    }

    /// Cases that could not be flown: number, model, why.
    pub(crate) fn failed(&self) -> impl Iterator<Item = (usize, String, String)> {
        self.cases
            .iter()
            .filter_map(|case| Some((case.number, MODELS[case.model].to_owned(), case.refused.clone()?)))
    }

    /// Says in the matrix what became of each case: failed if either model could not fly it.
    pub(crate) fn mark(&self, matrix: &mut Matrix) {
        let mut failed: BTreeMap<usize, String> = BTreeMap::new();
        for (number, model, why) in self.failed() {
            failed.entry(number).or_insert(format!("{model}: {why}"));
        }
        for case in matrix.cases.iter_mut().filter(|case| case.status == Status::Planned) {
            case.status = Status::Flown;
            if let Some(why) = failed.remove(&case.number) {
                (case.status, case.why) = (Status::Failed, why);
            }
        }
    }
}
