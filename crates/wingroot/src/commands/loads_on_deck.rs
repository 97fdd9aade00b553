//! A plan of design loads on a user's deck: what it asks for, and its trims.

use std::path::{Path, PathBuf};

use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::aircraft::maneuvers;
use fullaircraft::design_loads::deck::{DeckFlown, DeckPlan};
use fullaircraft::design_loads::instants::FlownCase;
use fullaircraft::{AircraftError, CasesFile, Station, TrimDeck};
use loads::matrix::{Case, Status};
use loads::{Air, Design, Matrix, matrix};
use nastran::{BulkData, InputError};

use crate::args::Common;
use crate::commands::fullaircraft_deck::say_of_splines;
use crate::commands::loads_plan::design;
use crate::failure::Failure;
use crate::{progress, show};

/// Share by which the plan's mass may differ from the deck's.
const SAME_MASS: f64 = 1e-3;

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
        let bulk = nastran::read_deck(path)?;
        let plan = DeckPlan::new(&bulk, file.deck.unwrap_or_default()).map_err(|error| error.or_in(path))?;
        let air = Air::at(design.altitudes_m[0]);
        let v_m_s = design.speeds.vc * air.true_over_equivalent();
        let deck = plan.at(MODELS.len() - 1, v_m_s / air.sound_m_s).map_err(|error| match error {
            AircraftError::Input(error) => Failure::Input(error.or_in(path)),
            other => other.into(),
        })?;
        if !common.quiet {
            say(&bulk, &deck);
        }
        check_mass(&design, plan.mass_kg(&deck))?;
        let stations = plan.stations(&deck, &file)?;
        let (actions, conditions) = maneuvers(&file, &design)?.into_iter().unzip::<_, _, Vec<_>, Vec<_>>();
        let airframe = plan.airframe(&deck).map_err(|error| error.or_in(path))?;
        let mut matrix = matrix(&design, &airframe, &conditions)?;
        for case in matrix.cases.iter_mut().filter(|case| case.status == Status::Planned) {
            if let Some(why) = DeckPlan::left_out(case, &actions) {
                (case.status, case.why) = (Status::LeftOut, why.to_owned());
            }
        }
        let inputs = vec![("deck", path.to_path_buf()), ("plan", file.path.clone())];
        Ok(Self { file, design, plan, deck, stations, matrix, inputs })
    }

    /// All cases with both models, in the order of models and numbers; each Mach number is assembled once.
    pub(super) fn fly(&self, common: &Common) -> Vec<DeckFlown> {
        let mut cases: Vec<&Case> =
            self.matrix.cases.iter().filter(|case| case.status == Status::Planned).collect();
        cases.sort_by(|a, b| a.mach.total_cmp(&b.mach).then(a.number.cmp(&b.number)));
        let bar = progress::bar(common, MODELS.len() * cases.len(), "cases");
        let mut all = Vec::new();
        for model in 0..MODELS.len() {
            for same in cases.chunk_by(|a, b| a.mach == b.mach) {
                let deck = self.plan.at(model, same[0].mach);
                for case in same {
                    all.push(match &deck {
                        Ok(deck) => self.plan.fly(deck, case, model, &self.stations),
                        Err(error) => refused(case, model, error),
                    });
                    bar.inc(1);
                }
            }
        }
        progress::end(&bar);
        all.sort_by_key(|one| (one.case.model, one.case.number));
        all
    }
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
    say_of_splines(bulk, &deck.loose_boxes);
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
