//! How many elements of each kind a deck has, by the names of their cards.

use crate::cards::BulkData;
use crate::fe_cards::ScalarValue;
use std::collections::BTreeMap;

impl BulkData {
    /// Elements (structural ones, masses, springs, rigid elements) by card name; kinds that do not occur are left
    /// out.
    pub fn element_counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        let mut add = |name, count| {
            if count > 0 {
                *counts.entry(name).or_insert(0) += count;
            }
        };
        for beam in self.beams.values() {
            add(if beam.is_beam { "CBEAM" } else { "CBAR" }, 1);
        }
        for shell in self.shells.values() {
            add(if shell.grids.len() == 3 { "CTRIA3" } else { "CQUAD4" }, 1);
        }
        for solid in self.solids.values() {
            add(solid_name(solid.grids.len()), 1);
        }
        for (element, names) in self
            .springs
            .values()
            .map(|e| (e, ["CELAS1", "CELAS2"]))
            .chain(self.scalar_masses.values().map(|e| (e, ["CMASS1", "CMASS2"])))
        {
            add(names[usize::from(matches!(element.value, ScalarValue::Given(_)))], 1);
        }
        add("CROD", self.rods.len());
        add("CBUSH", self.bushes.len());
        add("GENEL", self.general.len());
        add("CONM1", self.mass_matrices.len());
        add("CONM2", self.masses.len());
        add("RBE2", self.rigid.len());
        add("RBAR", self.rigid_bars.len());
        add("RBE3", self.averages.len());
        counts
    }
}

fn solid_name(grids: usize) -> &'static str {
    match grids {
        4 => "CTETRA",
        6 => "CPENTA",
        _ => "CHEXA",
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn elements_are_counted_by_the_name_of_their_card() {
        let deck = "GRID,1\nGRID,2,,1.\nCBAR,1,1,1,2,0.,0.,1.\nCBEAM,2,1,1,2,0.,0.,1.\nCBEAM,3,1,1,2,0.,0.,1.\n\
                    CONM2,1,2,,1.\nRBE2,9,1,123456,2\n";
        let counts = crate::parse_deck("deck", deck).expect("a deck").element_counts();
        let expected = [("CBAR", 1), ("CBEAM", 2), ("CONM2", 1), ("RBE2", 1)];
        assert_eq!(counts.into_iter().collect::<Vec<_>>(), expected);
    }
}
