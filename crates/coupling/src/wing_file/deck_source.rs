//! A wing given as a Nastran deck.

use crate::planform::{Fault, Mount};
use nastran::{BulkData, Caero1, Divisions, InputError, read_deck};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A deck with structure and panels, and what the deck cannot say by itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeckSource {
    /// The deck, relative to the wing file; it may include others.
    pub file: String,
    /// CAERO1 numbers of panels that disturb the flow but are neither measured nor corrected.
    #[serde(default)]
    pub fairing_panels: Vec<u32>,
    /// SET1 with the grids the boxes follow; left out: all grids that follow no other by an RBE2.
    #[serde(default)]
    pub spline_set: Option<u32>,
}

impl DeckSource {
    /// The deck as it is for the tunnel; without constraints, monitor points and fairing for an aircraft.
    pub(super) fn bulk(&self, folder: &Path, mount: Mount) -> Result<BulkData, InputError> {
        let path = folder.join(&self.file);
        let deck = read_deck(&path)?;
        deck.refuse_unread_air()?;
        let mut bulk = deck.bounded(None).map_err(|error| error.or_in(&path))?.into_owned();
        if mount == Mount::Aircraft {
            self.remove_fairing_incidence(&mut bulk);
            bulk.panels.retain(|id, _| !self.fairing_panels.contains(id));
            bulk.constraints.clear();
            bulk.monitors.clear();
        }
        Ok(bulk)
    }

    pub(super) fn spline_grid_ids(&self, bulk: &BulkData) -> Vec<u32> {
        if let Some(set) = self.spline_set {
            return bulk.sets.get(&set).map_or_else(Vec::new, |set| set.ids.clone());
        }
        let is_free = |id: &u32| !bulk.rigid.values().any(|rigid| rigid.dependent.contains(id));
        bulk.grids.keys().copied().filter(is_free).collect()
    }

    /// Checks that what is named is in the deck.
    pub(super) fn check(&self, bulk: &BulkData) -> Result<(), Fault> {
        if let Some(id) = self.fairing_panels.iter().find(|id| !bulk.panels.contains_key(id)) {
            let message = format!("the deck has no CAERO1 {id}");
            return Err(Fault::field("fairing_panels", message, "give numbers of CAERO1 cards"));
        }
        match self.spline_set.filter(|set| !bulk.sets.contains_key(set)) {
            None => Ok(()),
            Some(set) => {
                let message = format!("the deck has no SET1 {set}");
                Err(Fault::field("spline_set", message, "give the number of a SET1 card, or leave it out"))
            }
        }
    }

    /// W2GJ has one row a box in ascending order of panels; rows of panels that go must go with them.
    fn remove_fairing_incidence(&self, bulk: &mut BulkData) {
        let rows_of = |panel: &Caero1| box_count(bulk, panel);
        let stays: Vec<bool> = bulk
            .panels
            .values()
            .flat_map(|panel| std::iter::repeat_n(!self.fairing_panels.contains(&panel.id), rows_of(panel)))
            .collect();
        let Some(incidence) = bulk.matrices.get_mut("W2GJ") else { return };
        for column in &mut incidence.columns {
            let mut row = 0;
            column.retain(|_| {
                row += 1;
                stays.get(row - 1).copied().unwrap_or(true)
            });
        }
        incidence.rows = incidence.columns.first().map_or(0, Vec::len);
    }
}

fn box_count(bulk: &BulkData, panel: &Caero1) -> usize {
    let count = |divisions: Divisions| match divisions {
        Divisions::Equal(number) => number as usize,
        Divisions::Aefact(id) => bulk.factors.get(&id).map_or(0, |list| list.values.len().saturating_sub(1)),
    };
    count(panel.chord_divisions) * count(panel.span_divisions)
}
