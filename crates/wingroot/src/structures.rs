//! The structure a command works on: a wing's or a deck's, named by the options of several commands.

use std::path::{Path, PathBuf};

use coupling::{Mount, WingFile};
use nastran::{BulkData, InputError, Psolid, SolidPoints, SolidShear};
use structure::{MassForm, Model, Reduced, System};

use crate::failure::Failure;
use crate::{paths, show};

/// A structure with the cards it comes from.
#[derive(Debug)]
pub struct Structure {
    /// What reports call it.
    pub name: String,
    /// The file it comes from.
    pub path: PathBuf,
    /// The cards.
    pub bulk: BulkData,
    /// The elements.
    pub model: Model,
    /// The matrices.
    pub system: System,
}

impl Structure {
    /// The structure of a deck if one is named, else of a wing (as it is held in the tunnel).
    ///
    /// # Errors
    /// If a file is wrong, or there is no structure in it.
    pub fn read(wing: Option<&Path>, deck: Option<&Path>) -> Result<Self, Failure> {
        Self::read_in(wing, deck, None)
    }

    /// As [`Structure::read`], a deck under the boundary conditions of a subcase.
    ///
    /// # Errors
    /// As [`Structure::read`]; if a deck's subcases differ in boundary conditions and none is named.
    pub fn read_in(wing: Option<&Path>, deck: Option<&Path>, subcase: Option<u32>) -> Result<Self, Failure> {
        let (name, path, bulk) = if let Some(deck) = deck {
            let name = deck.file_name().map(|name| name.to_string_lossy().into_owned());
            (name.unwrap_or_default(), deck.to_path_buf(), nastran::read_deck(deck)?)
        } else {
            let path = paths::wing(wing)?;
            let file = WingFile::read(&path)?;
            let bulk = file.bulk(Mount::Tunnel)?;
            (file.name, path, bulk)
        };
        Self::of_cards(name, path, bulk, deck.is_some().then_some(subcase))
    }

    /// The structure of cards that have been read: a wing's, or a deck's under the boundary conditions of a subcase or of the only ones.
    ///
    /// # Errors
    /// As [`Structure::read_in`].
    pub fn of_cards(
        name: String,
        path: PathBuf,
        bulk: BulkData,
        deck: Option<Option<u32>>,
    ) -> Result<Self, Failure> {
        if bulk.grids.is_empty() {
            let error = InputError::in_file(&path, "there is no structure: no grid point");
            return Err(error.with_help("a rigid wing has neither modes nor a deck of its structure").into());
        }
        if let Some(cards) = bulk.unread_cards() {
            show::note(&format!("cards that are not read: {cards}"));
        }
        let model = match deck {
            Some(subcase) => Model::from_deck(&bulk, subcase),
            None => Model::from_bulk(&bulk),
        };
        let model = model.map_err(|error| error.or_in(&path))?;
        if model.elements().next().is_none() {
            let error = InputError::in_file(&path, "there is no structure: no element");
            return Err(error.with_help("a structure has beams, shells, springs or masses").into());
        }
        let system = System::assemble(&model).map_err(|error| error.or_in(&path))?;
        if deck.is_some() {
            say_what_was_assumed(&bulk, &model, &system);
        }
        Ok(Self { name, path, bulk, model, system })
    }

    /// The structure as a deck wants its modes computed: reduced as ASET and OMIT say, which is said.
    ///
    /// # Errors
    /// If motions that are left out meet no stiffness.
    pub(crate) fn reduced(self, subcase: Option<u32>) -> Result<Self, Failure> {
        let Reduced { system, remark } =
            structure::reduced(&*self.bulk.bounded(subcase)?, self.system).map_err(Failure::computation)?;
        if let Some(remark) = remark {
            show::note(&remark);
        }
        Ok(Self { system, ..self })
    }
}

/// That a trim, whose loads act on all motions, follows no ASET and OMIT.
pub(crate) fn unreduced_remark(bulk: &BulkData) -> Option<String> {
    (!bulk.analysis_sets.is_empty())
        .then(|| "trims do not follow ASET, OMIT and QSET: weight and air act on all motions".to_owned())
}

/// Which motions AUTOSPC holds.
pub(crate) fn held_remark(held: &[(u32, u8)]) -> Option<String> {
    /// How many motions are named.
    const SHOWN: usize = 8;
    let named = held.iter().take(SHOWN).map(|(grid, component)| format!("GRID {grid} component {component}"));
    let named = named.collect::<Vec<_>>().join(", ");
    let (count, more) = (held.len(), held.len().saturating_sub(SHOWN));
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    (count > 0).then(|| {
        format!("AUTOSPC holds {count} motion(s) without stiffness, and their masses and loads with them: {named}{more}")
    })
}

/// Which solids have bubble functions although their PSOLID asks for reduced shear without them.
pub(crate) fn solid_remark(bulk: &BulkData) -> Option<String> {
    let asks = |solid: &&Psolid| {
        solid.shear == SolidShear::Reduced && matches!(solid.points, SolidPoints::Two | SolidPoints::Three)
    };
    let has_bubbles = |solid: &Psolid| {
        let mut elements = bulk.solids.values().filter(|element| element.property == solid.id);
        elements.any(|element| element.grids.len() > 4 && element.midsides.iter().all(Option::is_none))
    };
    let asking = bulk.solid_properties.values().filter(asks).filter(|solid| has_bubbles(solid));
    let ids: Vec<String> = asking.map(|solid| solid.id.to_string()).collect();
    (!ids.is_empty()).then(|| {
        format!(
            "PSOLID {}: reduced shear without bubble functions (IN = TWO or THREE) is not there; CHEXA and CPENTA have them, as by \
             default, and bend more easily than Nastran's",
            ids.join(", ")
        )
    })
}

/// What a deck leaves to its reader, as it was read.
fn say_what_was_assumed(bulk: &BulkData, model: &Model, system: &System) {
    show::note(match model.mass_form {
        MassForm::Lumped => {
            "masses of elements are lumped, Nastran's default (PARAM,COUPMASS,1 makes them consistent)"
        }
        MassForm::Consistent => "masses of elements are consistent, as PARAM COUPMASS says",
    });
    let (shells, solids) = (bulk.shell_remark(), solid_remark(bulk));
    bulk.remarks().iter().chain(&shells).chain(&solids).for_each(|remark| show::note(remark));
    if let Some(first) = bulk.air_errors.first() {
        show::note(&format!(
            "cards of the air are left aside, {} of them not read as they stand, the first: {first}",
            bulk.air_errors.len()
        ));
    }
    if let Some(remark) = held_remark(system.auto_held()) {
        show::note(&remark);
    }
}
