//! A deck taken apart: its cards without those that a study gives, and the study beside them.

use fullaircraft::study::{Aim, Deck, MassTerms, Study};
use nastran::BulkData;
use std::path::PathBuf;

/// A folder of its own with the cards of a deck but for some, as `part.bdf`.
pub(crate) struct Apart(pub(crate) PathBuf);

impl Apart {
    /// Of a deck; `given` are the beginnings of the cards that are left out, with the lines that continue them.
    pub(crate) fn new(name: &str, deck: &str, given: &[&str]) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot_apart_{}_{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let (_, bulk) = deck.split_once("BEGIN BULK\n").expect("bulk data");
        let mut is_kept = true;
        let kept = bulk.lines().filter(|line| {
            if !line.starts_with(',') {
                is_kept = *line != "ENDDATA" && !given.iter().any(|start| line.starts_with(start));
            }
            is_kept
        });
        let kept: Vec<&str> = kept.collect();
        assert!(kept.len() < bulk.lines().count(), "nothing was taken out");
        std::fs::write(folder.join("part.bdf"), kept.join("\n") + "\n").expect("cards");
        Self(folder)
    }

    /// What a study makes of the cards, or why it does not.
    pub(crate) fn deck(&self, study: &str, aim: Aim, terms: Option<&MassTerms>) -> Result<Deck, String> {
        let path = self.0.join("study.ron");
        std::fs::write(&path, study).expect("a study");
        let deck = Study::read(&path).and_then(|study| study.deck(&path, aim, terms));
        deck.map_err(|error| error.to_string())
    }

    /// The cards and case control that a right study becomes.
    pub(crate) fn bulk(&self, study: &str, aim: Aim, terms: Option<&MassTerms>) -> BulkData {
        let deck = self.deck(study, aim, terms).unwrap_or_else(|error| panic!("{error}"));
        assert!(deck.bulk.air_errors.is_empty(), "{:?}\n{}", deck.bulk.air_errors, deck.text);
        assert!(deck.bulk.unknown.is_empty(), "{:?}", deck.bulk.unknown);
        deck.bulk
    }

    /// Changes a text in the cards.
    pub(crate) fn change(&self, from: &str, to: &str) {
        let path = self.0.join("part.bdf");
        let text = std::fs::read_to_string(&path).expect("cards");
        assert!(text.contains(from), "{from}");
        std::fs::write(&path, text.replace(from, to)).expect("cards");
    }
}

impl Drop for Apart {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
