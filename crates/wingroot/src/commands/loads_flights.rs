//! Flying a plan's cases: an aircraft for each state of loading, groups of cases on all threads, finished cases kept.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;
use std::time;

use fullaircraft::cases::file::Action;
use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::cost::cost;
pub(crate) use fullaircraft::design_loads::cost::is_in_time;
use fullaircraft::design_loads::fly::{Nodal, PlanFlight};
use fullaircraft::design_loads::instants::{FlownCase, FlownInstant};
use fullaircraft::{CasesFile, NodalLoads, Station};
use loads::matrix::{Action as Planned, Case, Status};
use loads::select::Instant;
use loads::select::file::Model;
use loads::{Air, Design, Matrix};
use rayon::prelude::*;

use crate::args::Common;
use crate::commands::fullaircraft_draws::{Draws, Flies};
use crate::commands::fullaircraft_prepared::Prepared;
use crate::commands::loads_states::{Frame, Loaded, States};
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::progress;
use crate::store::{Inputs, Shared, Store, Told};
use crate::sweep::split::Weighed;

/// A plan ready to be flown.
pub(crate) struct Flights<'a> {
    pub(crate) plan: &'a CasesFile,
    pub(crate) design: &'a Design,
    pub(crate) matrix: &'a Matrix,
    pub(crate) stations: Vec<Station>,
    /// Numbers of the grids, in the order of the nodes.
    pub(crate) grids: Vec<u32>,
    pub(crate) maneuvers: Vec<Action>,
    /// What is finished.
    pub(crate) store: Store,
    /// The aircraft in each state of loading.
    pub(crate) states: States<'a>,
    /// What all cases share, where it is kept.
    pub(crate) shared: &'a Shared,
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

/// What is done with a flown case, what gives its nodal loads at an instant, and what it took, s.
type Each<'e> = dyn Fn(&Case, FlownCase, &Nodal<'_>, f64) -> Result<(), Failure> + Sync + 'e;

/// Cases of one aircraft that share altitude and airspeed, and the version they are flown with: one of both models, or beyond them a wing of
/// the ensemble.
type Group<'m> = (usize, Vec<&'m Case>);

/// A plan and what it asks for.
pub(crate) struct FromPlan<'a> {
    pub(crate) plan: &'a CasesFile,
    pub(crate) design: &'a Design,
    pub(crate) maneuvers: Vec<Action>,
    pub(crate) matrix: &'a Matrix,
}

impl<'a> Flights<'a> {
    /// The cases of the plan's matrix and what is finished of them beside `target`.
    pub(crate) fn new(
        prepared: &'a Prepared,
        planned: FromPlan<'a>,
        target: &Path,
        shared: &'a Shared,
    ) -> Result<Self, Failure> {
        let FromPlan { plan, design, maneuvers, matrix } = planned;
        let base = &prepared.aircraft;
        let stations = base.loads_stations(plan)?;
        let depends = base.inputs_of_cases(&prepared.corrections, plan);
        let depends = depends.iter().fold(Inputs::default(), |all, (name, text)| all.with(name, text));
        let ensemble = Some(&prepared.wing).filter(|wing| wing.ensemble.is_some());
        let draws = Draws::new(ensemble, &base.file, shared);
        let depends = draws.inputs().iter().fold(depends, |all, text| all.with("ensemble", text));
        let found = prepared.wing.schedule.found.as_ref().map(|found| format!("{found:?}"));
        let depends = found.iter().fold(depends, |all, text| all.with("found", text));
        let inputs = depends.with("design", &format!("{design:?} {maneuvers:?}"));
        let store = Store::beside(target, inputs)?;
        let states = States::new(prepared, &design.masses, draws, shared);
        let grids = base.free.node_ids().to_vec();
        Ok(Self { plan, design, matrix, stations, grids, maneuvers, store, states, shared })
    }

    /// Numbers of all planned cases with both models and the wings of the ensemble: place in the matrix, and how many matrices before.
    fn numbers(&self) -> impl Iterator<Item = usize> {
        let count = self.matrix.cases.len();
        let planned = |place: &usize| self.matrix.cases[*place].status == Status::Planned;
        let versions = MODELS.len() + self.states.draws.count();
        (0..versions)
            .flat_map(move |version| (0..count).filter(planned).map(move |place| version * count + place))
    }

    /// Which model it is flown with (beyond the two a wing of the ensemble), and the case.
    fn case(&self, number: usize) -> (usize, &'a Case) {
        let count = self.matrix.cases.len();
        (number / count, &self.matrix.cases[number % count])
    }

    /// The aircraft that flies a case.
    pub(crate) fn frame(&self, number: usize) -> Frame {
        let (version, case) = self.case(number);
        self.frame_of(version, case)
    }

    /// The aircraft that flies a case of a version: of both models that as given and as found, beyond them one of the ensemble.
    fn frame_of(&self, version: usize, case: &Case) -> Frame {
        let flies = match version.checked_sub(MODELS.len()) {
            Some(draw) => Flies::Draw(draw),
            None if version > 0 && self.states.found.is_some() => Flies::Found,
            None => Flies::Given,
        };
        Frame { flies, mass: case.mass }
    }

    /// What a case is called in the store: in words, and all that is flown.
    pub(crate) fn part(&self, number: usize) -> String {
        let (version, case) = self.case(number);
        let Case { number, mass, h_m, v_m_s, n_z, action, condition, .. } = case;
        let draw = || format!("draw {}", version + 1 - MODELS.len());
        let model = MODELS.get(version).map_or_else(draw, ToString::to_string);
        let mass = &self.design.masses[*mass].name;
        format!("{model} {number} {condition}, {mass}, {h_m:?} m, {v_m_s:?} m/s, n {n_z:?}: {action:?}")
    }

    /// All cases with what they cost and share. Gusts of one direction are flown together: the worst gradients depend on all of them.
    pub(crate) fn row(&self) -> Vec<Weighed> {
        let print = |text: String| Fingerprint::default().with(text.as_bytes());
        let weighed = |number: usize| {
            let (model, case) = self.case(number);
            let Case { h_m, v_m_s, mass, action, .. } = case;
            let hash = Store::hash(&self.part(number));
            let frame = print(format!("{:?} {:?}", self.frame(number).flies, self.design.masses[*mass]));
            let group = print(format!("{frame} {model} {h_m:?} {v_m_s:?}"));
            let unit = match action {
                Planned::Discrete { direction, .. } => print(format!("{group} {direction:?}")),
                _ => hash,
            };
            let is_late = is_in_time(case, &self.maneuvers);
            Weighed { frame, is_late, group, unit, hash, cost: cost(case, &self.maneuvers), number }
        };
        self.numbers().map(weighed).collect()
    }

    /// Flies those cases of a sorted row that are not finished; each is kept as soon as it is there. How many were finished before.
    pub(crate) fn fly(&self, row: &[Weighed], common: &Common) -> Result<usize, Failure> {
        let is_finished = |case: &Weighed| self.store.has(&self.part(case.number));
        let units = row.chunk_by(|a, b| a.unit == b.unit);
        let missing: Vec<&Weighed> = units.filter(|unit| !unit.iter().all(is_finished)).flatten().collect();
        let key = |number: usize| {
            let (version, case) = self.case(number);
            (version, case.number)
        };
        let numbers: BTreeMap<(usize, usize), usize> =
            missing.iter().map(|case| (key(case.number), case.number)).collect();
        let mut cases: Vec<(usize, &Case)> = missing.iter().map(|case| self.case(case.number)).collect();
        cases.sort_by_key(|(model, case)| (case.number, *model));
        let bar = progress::bar(common, cases.len(), "cases");
        self.each(&cases, true, &|case, flown, _, seconds| {
            let number = numbers.get(&(flown.model, case.number)).copied();
            let part = number.map(|number| self.part(number)).ok_or_else(|| unknown(case.number))?;
            if !self.store.has(&part) {
                let told = Told { part, seconds: Some(seconds), failed: flown.refused.clone() };
                self.store.put_told(&told, &flown)?;
            }
            bar.inc(1);
            Ok(())
        })?;
        progress::end(&bar);
        Ok(row.len() - missing.len())
    }

    /// All finished cases of both models, read once, and the sorted hashes of cases that are not finished, those of the ensemble's wings
    /// among them.
    pub(crate) fn finished(&self) -> (Flown, Vec<Fingerprint>) {
        let (mut cases, mut missing) = (Vec::new(), Vec::new());
        for number in self.numbers() {
            let part = self.part(number);
            if self.case(number).0 >= MODELS.len() {
                missing.extend((!self.store.has(&part)).then(|| Store::hash(&part)));
            } else if let Some(case) = self.store.get::<FlownCase>(&part) {
                cases.push(case);
            } else {
                missing.push(Store::hash(&part));
            }
        }
        cases.sort_by_key(|case| (case.model, case.number));
        missing.sort_unstable();
        (Flown { cases }, missing)
    }

    /// All cases of a wing of the ensemble as if they were the updated model's, once they are finished.
    pub(crate) fn of_draw(&self, draw: usize) -> Result<Flown, Failure> {
        let own = |number: &usize| self.frame(*number).flies == Flies::Draw(draw);
        let as_updated = |case: FlownCase| FlownCase { model: MODELS.len() - 1, ..case };
        let cases = self.numbers().filter(own).map(|number| self.read(number).map(as_updated));
        Ok(Flown { cases: cases.collect::<Result<Vec<FlownCase>, Failure>>()? })
    }

    fn read(&self, number: usize) -> Result<FlownCase, Failure> {
        let part = self.part(number);
        let lost = || Failure::Computation(format!("{part}: can no longer be read: run again"));
        self.store.get::<FlownCase>(&part).ok_or_else(lost)
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
        self.each(&cases, false, &|case, flown, loads, _| {
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

    /// Flies cases with models, aircraft by aircraft and its groups side by side; worst gradients are searched for if asked to.
    fn each(&self, cases: &[(usize, &Case)], search: bool, done: &Each<'_>) -> Result<(), Failure> {
        let mut frames: BTreeMap<Frame, Vec<Group<'_>>> = BTreeMap::new();
        for (version, case) in cases {
            let same = |group: &&mut Group<'_>| {
                let first = group.1[0];
                group.0 == *version && (first.h_m, first.v_m_s) == (case.h_m, case.v_m_s)
            };
            let groups = frames.entry(self.frame_of(*version, case)).or_default();
            match groups.iter_mut().find(same) {
                Some(group) => group.1.push(case),
                None => groups.push((*version, vec![case])),
            }
        }
        frames.into_iter().try_for_each(|(frame, groups)| {
            let moves =
                groups.iter().flat_map(|group| &group.1).any(|case| is_in_time(case, &self.maneuvers));
            self.states.with(frame, moves, |loaded| {
                self.plan.check_names(loaded.tools)?;
                groups.par_iter().try_for_each(|group| self.fly_group(loaded, group, search, done))
            })
        })
    }

    fn fly_group(
        &self,
        loaded: &Loaded<'_>,
        (version, cases): &Group<'_>,
        search: bool,
        done: &Each<'_>,
    ) -> Result<(), Failure> {
        let first = cases[0];
        let Loaded { tools, air, corrections } = *loaded;
        let model = match version {
            0 => tools.aircraft.uncorrected(),
            _ => tools.aircraft.with_corrections(corrections)?,
        };
        let model = model.in_air(Air::at(first.h_m).rho_kg_m3);
        let flight = PlanFlight { tools, air, stations: &self.stations, maneuvers: &self.maneuvers, search };
        let mut since = time::Instant::now();
        flight.fly(&model, *version, cases, &mut |flown: FlownCase, loads| {
            let case = cases.iter().find(|case| case.number == flown.number).unwrap_or(&first);
            done(case, flown, loads, since.elapsed().as_secs_f64())?;
            since = time::Instant::now();
            Ok(())
        })
    }
}

fn unknown(number: usize) -> Failure {
    Failure::Computation(format!("case {number} was flown and nobody asked for it"))
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
