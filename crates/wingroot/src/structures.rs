//! The structure a command works on: a wing's or a deck's, named by the options of several commands.

use std::path::{Path, PathBuf};

use coupling::{Mount, WingFile};
use nastran::{BulkData, InputError};
use structure::{Model, System};

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
        let (name, path, bulk) = if let Some(deck) = deck {
            let name = deck.file_name().map(|name| name.to_string_lossy().into_owned());
            (name.unwrap_or_default(), deck.to_path_buf(), nastran::read_deck(deck)?)
        } else {
            let path = paths::wing(wing)?;
            let file = WingFile::read(&path)?;
            let bulk = file.bulk(Mount::Tunnel)?;
            (file.name, path, bulk)
        };
        if bulk.grids.is_empty() {
            let error = InputError::in_file(&path, "there is no structure: no grid point");
            return Err(error.with_help("a rigid wing has neither modes nor a deck of its structure").into());
        }
        if let Some(cards) = bulk.unread_cards() {
            show::note(&format!("cards that are not read: {cards}"));
        }
        let model = Model::from_bulk(&bulk).map_err(|error| error.or_in(&path))?;
        if model.elements().next().is_none() {
            let error = InputError::in_file(&path, "there is no structure: no element");
            return Err(error.with_help("a structure has beams, shells, springs or masses").into());
        }
        let system = System::assemble(&model).map_err(|error| error.or_in(&path))?;
        Ok(Self { name, path, bulk, model, system })
    }
}
