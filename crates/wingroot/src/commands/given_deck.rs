//! The deck that a command is given: a Nastran deck, or what a study (`.ron`, `.json`) of decks that lack something stands for.

use std::path::{Path, PathBuf};

use fullaircraft::study::{Aim, Deck, MassTerms, Masses, Study, read_terms};
use nastran::BulkData;

use crate::failure::Failure;
use crate::hdf5;
use crate::output::ResultFolder;

/// A deck that was read.
pub(crate) struct GivenDeck {
    /// Its cards and case control.
    pub(crate) bulk: BulkData,
    path: PathBuf,
    /// The text of the deck that a study became.
    study: Option<String>,
}

impl GivenDeck {
    /// Reads a deck, or a study and makes the deck of its section for `aim`.
    ///
    /// # Errors
    /// If a file cannot be read, or the study has no such section or lacks what that needs.
    pub(crate) fn read(path: &Path, aim: Aim) -> Result<Self, Failure> {
        let own = path.to_path_buf();
        if !Study::is_study(path) {
            return Ok(Self { bulk: nastran::read_deck(path)?, path: own, study: None });
        }
        let study = Study::read(path)?;
        let terms = match &study.masses {
            Masses::OfDecks => None,
            Masses::Matrix(file) => Some(mass_terms(&path.parent().unwrap_or(Path::new("")).join(file))?),
        };
        let Deck { text, bulk } = study.deck(path, aim, terms.as_ref())?;
        Ok(Self { bulk, path: own, study: Some(text) })
    }

    /// Names it as an input of a folder of results, with the deck that a study became.
    ///
    /// # Errors
    /// If that cannot be written.
    pub(crate) fn enter(&self, folder: &ResultFolder) -> Result<(), Failure> {
        folder.input("deck", &self.path)?;
        self.leave_study(folder)
    }

    /// Leaves the deck that a study became in a folder of results, for other programs.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(crate) fn leave_study(&self, folder: &ResultFolder) -> Result<(), Failure> {
        self.study.as_ref().map_or(Ok(()), |text| folder.write_text("study.bdf", text))
    }
}

/// A mass matrix by the ending of its name.
fn mass_terms(path: &Path) -> Result<MassTerms, Failure> {
    let is_hdf5 = path.extension().is_some_and(|ending| ending == "h5" || ending == "hdf5");
    Ok(if is_hdf5 { hdf5::mass_matrix(path)? } else { read_terms(path)? })
}
