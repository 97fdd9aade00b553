//! A plan of design loads on a user's deck: what it asks for, and its trims.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::aircraft::maneuvers;
use fullaircraft::design_loads::deck::{DeckFlown, DeckPlan};
use fullaircraft::design_loads::deck_gusts::DeckFlight;
use fullaircraft::design_loads::fly::Nodal;
use fullaircraft::design_loads::instants::FlownCase;
use fullaircraft::study::Aim;
use fullaircraft::{AircraftError, CasesFile, Station, TrimDeck};
use loads::matrix::{Case, Status};
use loads::{Air, Design, Matrix, matrix};
use nastran::{BulkData, InputError};
use rayon::prelude::*;

use crate::args::Common;
use crate::commands::fullaircraft_deck::say_what_is_assumed;
use crate::commands::given_deck::GivenDeck;
use crate::commands::loads_flights::{FlownAgain, Wanted};
use crate::commands::loads_package::lost;
use crate::commands::loads_plan::design;
use crate::commands::loads_tables::case_of;
use crate::failure::Failure;
use crate::structures::unreduced_remark;
use crate::{progress, show};

/// Share by which the plan's mass may differ from the deck's.
const SAME_MASS: f64 = 1e-3;

/// What is done with a case that was flown, and what gives its loads at grids at an instant in a gust.
type Done<'d> = dyn Fn(DeckFlown, &Nodal<'_>) + Sync + 'd;

/// A plan on a deck, flown.
pub(super) struct OnDeck {
    /// The plan's file.
    pub(super) file: CasesFile,
    /// Its design.
    pub(super) design: Design,
    /// The deck with the plan's units.
    pub(super) plan: DeckPlan,
    /// The deck at VC, whose structure is that of all Mach numbers.
    pub(super) deck: TrimDeck,
    /// Stations, in the deck's unit of length.
    pub(super) stations: Vec<Station>,
    /// Cases.
    pub(super) matrix: Matrix,
    /// The deck or study as it was given.
    pub(super) given: GivenDeck,
    /// What was read.
    pub(super) inputs: Vec<(&'static str, PathBuf)>,
}

impl OnDeck {
    /// Reads deck and plan, and makes the matrix.
    ///
    /// # Errors
    /// If either is wrong, or they do not belong together.
    pub(super) fn read(path: &Path, plan: &Path, common: &Common) -> Result<Self, Failure> {
        let file = CasesFile::read(plan)?;
        let design = design(&file)?;
        let given = GivenDeck::read(path, Aim::Trims)?;
        let plan =
            DeckPlan::new(&given.bulk, file.deck.unwrap_or_default()).map_err(|error| error.or_in(path))?;
        let air = Air::at(design.altitudes_m[0]);
        let v_m_s = design.speeds.vc * air.true_over_equivalent();
        let deck = plan.at(MODELS.len() - 1, v_m_s / air.sound_m_s).map_err(|error| match error {
            AircraftError::Input(error) => Failure::Input(error.or_in(path)),
            other => other.into(),
        })?;
        if !common.quiet {
            say(&given.bulk, &deck);
        }
        check_mass(&design, plan.mass_kg(&deck))?;
        let stations = plan.stations(&deck, &file)?;
        let (actions, conditions) = maneuvers(&file, &design)?.into_iter().unzip::<_, _, Vec<_>, Vec<_>>();
        let airframe = plan.airframe(&deck).map_err(|error| error.or_in(path))?;
        let mut matrix = matrix(&design, &airframe, &conditions)?;
        for case in matrix.cases.iter_mut().filter(|case| case.status == Status::Planned) {
            if let Some(why) = plan.left_out(case, &actions) {
                (case.status, case.why) = (Status::LeftOut, why.to_owned());
            }
        }
        if matrix.cases.iter().any(|case| case.status == Status::Planned && DeckPlan::is_in_gusts(case)) {
            plan.check_modes().map_err(|error| error.or_in(path))?;
        }
        let inputs = vec![("deck", path.to_path_buf()), ("plan", file.path.clone())];
        Ok(Self { file, design, plan, deck, stations, matrix, given, inputs })
    }

    /// All cases with both models, in the order of models and numbers; each Mach number is assembled once. Of a deck without corrections
    /// both models are one.
    pub(super) fn fly(&self, common: &Common) -> Vec<DeckFlown> {
        let cases: Vec<&Case> =
            self.matrix.cases.iter().filter(|case| case.status == Status::Planned).collect();
        let models = if self.plan.is_corrected() { 0..MODELS.len() } else { 1..MODELS.len() };
        let all: Vec<(usize, &Case)> =
            models.flat_map(|model| cases.iter().map(move |case| (model, *case))).collect();
        let bar = progress::bar(common, all.len(), "cases");
        let found = Mutex::new(Vec::new());
        self.each(all, false, &|flown: DeckFlown, _: &Nodal<'_>| {
            bar.inc(1);
            let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
            if !self.plan.is_corrected() {
                found.push(DeckFlown { case: FlownCase { model: 0, ..flown.case.clone() }, ..flown.clone() });
            }
            found.push(flown);
        });
        progress::end(&bar);
        let mut all = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        all.sort_by_key(|one| (one.case.model, one.case.number));
        all
    }

    /// Loads at grids of instants in gusts, flown again, in this order; the deck's units.
    ///
    /// # Errors
    /// If an instant is not there.
    pub(super) fn again(&self, wanted: &[Wanted<'_>]) -> Result<Vec<FlownAgain>, Failure> {
        let mut cases: Vec<(usize, &Case)> = Vec::new();
        for Wanted { model, number, .. } in wanted {
            if !cases.iter().any(|(known, case)| (known, case.number) == (model, *number)) {
                cases.extend(case_of(&self.matrix, *number).map(|case| (*model, case)));
            }
        }
        let found = Mutex::new(Vec::new());
        self.each(cases, true, &|flown: DeckFlown, nodal: &Nodal<'_>| {
            let own = wanted
                .iter()
                .filter(|want| (want.model, want.number) == (flown.case.model, flown.case.number));
            let again = own.filter_map(|want| {
                let Wanted { model, number, instant, flown } = *want;
                Some(FlownAgain { model, number, instant, nodal: nodal(flown)? })
            });
            found.lock().unwrap_or_else(PoisonError::into_inner).extend(again);
        });
        let mut found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        let one = |want: &Wanted<'_>| {
            let same = |of: &FlownAgain| {
                (of.model, of.number, of.instant) == (want.model, want.number, want.instant)
            };
            let place = found.iter().position(same).ok_or_else(|| lost(want.number))?;
            Ok(found.swap_remove(place))
        };
        wanted.iter().map(one).collect()
    }

    /// Flies cases with models, those of a model and Mach number with one assembly.
    fn each(&self, mut cases: Vec<(usize, &Case)>, nodal: bool, done: &Done<'_>) {
        let key = |one: &(usize, &Case)| (one.0, one.1.mach, one.1.h_m);
        cases.sort_by(|a, b| {
            let order = key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal);
            order.then(a.1.number.cmp(&b.1.number))
        });
        let groups: Vec<&[(usize, &Case)]> = cases.chunk_by(|a, b| key(a) == key(b)).collect();
        groups.par_iter().for_each(|group| {
            let (model, first) = group[0];
            let none: &Nodal<'_> = &|_| None;
            let deck = match self.plan.at(model, first.mach) {
                Ok(deck) => deck,
                Err(error) => {
                    return group.iter().for_each(|(_, case)| done(refused(case, model, &error), none));
                }
            };
            let (gusts, trims): (Vec<&Case>, Vec<&Case>) =
                group.iter().map(|(_, case)| *case).partition(|case| DeckPlan::is_in_gusts(case));
            for case in trims {
                done(self.plan.fly(&deck, case, model, &self.stations), none);
            }
            let all: Vec<&Case> = self.matrix.cases.iter().filter(|case| is_beside(case, first)).collect();
            let flight =
                DeckFlight { deck: &deck, stations: &self.stations, search: !nodal, nodal, all: &all };
            let flown = self.plan.fly_in_gusts(flight, model, &gusts, &mut |case, nodal| {
                done(DeckFlown { case, ..DeckFlown::default() }, nodal);
                Ok::<(), AircraftError>(())
            });
            // nothing that is done here can fail, and what cannot be flown is a result
            drop(flown);
        });
    }
}

/// Whether a case is a gust that is flown in the flow of another.
fn is_beside(case: &Case, other: &Case) -> bool {
    case.status != Status::LeftOut
        && DeckPlan::is_in_gusts(case)
        && (case.mach, case.h_m) == (other.mach, other.h_m)
}

fn refused(case: &Case, model: usize, error: &AircraftError) -> DeckFlown {
    let refused = Some(error.to_string());
    DeckFlown {
        case: FlownCase { number: case.number, model, refused, ..FlownCase::default() },
        ..DeckFlown::default()
    }
}

/// What of the deck is not read or not as it might be expected.
fn say(bulk: &BulkData, deck: &TrimDeck) {
    if let Some(cards) = bulk.unread_cards() {
        show::note(&format!("these cards are not read, and not in the package's structure: {cards}"));
    }
    say_what_is_assumed(bulk, &deck.loose_boxes, deck.auto_held(), unreduced_remark(bulk));
    if !deck.skipped_monitors.is_empty() {
        show::note(&format!(
            "stations left out (MONPNT3 of a group that is no SET1, MONPNT1 of components made of grids): {}",
            deck.skipped_monitors.join(", ")
        ));
    }
}

/// A deck has one state of loading, and the plan says which.
fn check_mass(design: &Design, mass_kg: f64) -> Result<(), InputError> {
    let wrong = |message: String| {
        InputError::in_field(&design.path, "masses", message)
            .with_help(format!("give masses: [(name: \"deck\", mass_kg: {mass_kg:.4})], and no inertia"))
    };
    let [one] = design.masses.as_slice() else {
        return Err(wrong("a deck has one state of loading, its own".to_owned()));
    };
    let own = [one.x_cg_m, one.z_cg_m, one.ixx_kg_m2, one.iyy_kg_m2, one.izz_kg_m2, one.ixz_kg_m2];
    if own.iter().any(Option::is_some) {
        return Err(wrong("centre of gravity and inertia are those of the deck".to_owned()));
    }
    if (one.mass_kg / mass_kg - 1.0).abs() > SAME_MASS {
        return Err(wrong(format!(
            "the plan's {} kg are not the deck's {mass_kg:.4} kg in the units that the plan gives (`deck`)",
            one.mass_kg
        )));
    }
    Ok(())
}
