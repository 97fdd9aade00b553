//! Structural damping on cards (GE): loss factors of materials, laminates, springs and bushes, by which the stiffness of an element
//! becomes k (1 + i GE) where frequencies are answered. What a deck is scaled, raised or mirrored for has no part in it.

use crate::card::Card;
use crate::real;
use std::collections::BTreeMap;

/// Cards with one loss factor, the field of their number and that of GE.
const SINGLE: [(&str, usize, usize); 9] = [
    ("MAT1", 0, 7),
    ("MAT2", 0, 12),
    ("MAT8", 0, 16),
    ("MAT9", 0, 30),
    ("CELAS2", 0, 6),
    ("PELAS", 0, 2),
    ("PELAS", 4, 6),
    ("PCOMP", 0, 6),
    ("PCOMPG", 0, 6),
];

/// Loss factors of a deck, by the number of what has them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LossFactors {
    /// Of materials.
    pub materials: BTreeMap<u32, f64>,
    /// Of laminates, whose materials' do not count.
    pub laminates: BTreeMap<u32, f64>,
    /// Of PELAS.
    pub spring_properties: BTreeMap<u32, f64>,
    /// Of CELAS2.
    pub springs: BTreeMap<u32, f64>,
    /// Of PBUSH, by direction.
    pub bushes: BTreeMap<u32, [f64; 6]>,
    /// How many cards of which name have one.
    pub counts: BTreeMap<String, usize>,
}

impl LossFactors {
    /// Keeps those of a card.
    pub(super) fn keep(&mut self, card: &Card) {
        let number = |at: usize| card.text(at).parse::<u32>().ok();
        let value = |at: usize| real::parse(card.text(at)).filter(|value| *value != 0.0);
        for (name, id, at) in SINGLE {
            let (true, Some(id), Some(ge)) = (name == card.name, number(id), value(at)) else { continue };
            let of = match name {
                "CELAS2" => &mut self.springs,
                "PELAS" => &mut self.spring_properties,
                "PCOMP" | "PCOMPG" => &mut self.laminates,
                _ => &mut self.materials,
            };
            of.insert(id, ge);
            *self.counts.entry(card.name.clone()).or_default() += 1;
        }
        let row =
            (0..card.len()).find(|at| card.name == "PBUSH" && card.text(*at).eq_ignore_ascii_case("GE"));
        if let (Some(row), Some(id)) = (row, number(0)) {
            let given: [Option<f64>; 6] = std::array::from_fn(|axis| real::parse(card.text(row + 1 + axis)));
            // One alone is that of all directions (QRG, PBUSH, remark 9).
            let others = if given[1..].iter().all(Option::is_none) { given[0] } else { None };
            let all = given.map(|ge| ge.or(others).unwrap_or(0.0));
            if all != [0.0; 6] {
                self.bushes.insert(id, all);
                *self.counts.entry(card.name.clone()).or_default() += 1;
            }
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.counts.is_empty()
    }
}
