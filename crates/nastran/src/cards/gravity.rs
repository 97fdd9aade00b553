//! Weight (GRAV), and sums of load sets (LOAD).

use super::prelude::*;
use crate::bulk_data::BulkData;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// An acceleration of gravity on all masses (GRAV).
#[derive(Debug, Clone, PartialEq)]
pub struct Gravity {
    /// Load set.
    pub set: u32,
    /// Coordinate system of the vector.
    pub cid: u32,
    /// Scale times vector.
    pub vector: Vector3<f64>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Gravity {
    keyed!(u32, set);
    /// GRAV: SID CID A N1 N2 N3 MB; MB only matters where systems move.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            cid: card.count_or(1, "CID", 0)?,
            vector: card.vector::<Vector3<f64>>(3, ["N1", "N2", "N3"])? * card.real(2, "A")?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.set, self.cid]).real(1.0).reals(&self.vector)
    }

    // Sets keep their numbers.
    raises!(systems: cid);

    // An image has no case control that selects loads.
    no_image!();
}

impl BulkData {
    /// The sets without a LOAD of their own that a set sums, each with its factor; LOAD may sum others (QRG, LOAD, remark 5). A set that is
    /// no sum is itself.
    ///
    /// # Errors
    /// If a sum is part of itself.
    pub fn summed_sets(&self, set: u32) -> Result<Vec<(f64, u32)>, InputError> {
        // Each sum before its parts, however often and however deep it is summed itself.
        let (mut order, mut is_open) = (Vec::new(), BTreeMap::new());
        let mut way = vec![(set, false)];
        while let Some((at, is_done)) = way.pop() {
            let sum = self.load_sums.get(&at);
            if is_done {
                is_open.insert(at, false);
                order.push(at);
                continue;
            }
            match (is_open.get(&at), sum) {
                (Some(true), Some(sum)) => {
                    let message = format!("LOAD {at} is a part of itself");
                    return Err(InputError::at(&sum.span, message)
                        .with_help("a LOAD may sum others, but not in a circle"));
                }
                (Some(_), _) => continue,
                (None, _) => _ = is_open.insert(at, true),
            }
            way.push((at, true));
            let parts = sum.map_or(&[][..], |sum| &sum.parts);
            way.extend(parts.iter().rev().map(|(_, part)| (*part, false)));
        }
        let mut factors: BTreeMap<u32, f64> = [(set, 1.0)].into();
        let mut found = Vec::new();
        for at in order.into_iter().rev() {
            let own = factors.get(&at).copied().unwrap_or(0.0);
            let Some(sum) = self.load_sums.get(&at) else {
                found.push((own, at));
                continue;
            };
            for (factor, part) in &sum.parts {
                *factors.entry(*part).or_default() += own * sum.scale * factor;
            }
        }
        Ok(found)
    }
}

/// A sum of load sets (LOAD).
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSum {
    /// Load set.
    pub set: u32,
    /// Factor of all.
    pub scale: f64,
    /// Factor and set of each.
    pub parts: Vec<(f64, u32)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for LoadSum {
    keyed!(u32, set);
    /// LOAD: SID S S1 L1 S2 L2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (set, scale) = (card.id(0, "SID")?, card.real(1, "S")?);
        let mut parts = Vec::new();
        for at in (2..card.len().max(4)).step_by(2) {
            if at == 2 || !card.text(at).is_empty() || !card.text(at + 1).is_empty() {
                parts.push((card.real(at, "S1")?, card.id(at + 1, "L1")?));
            }
        }
        if parts.iter().any(|(_, other)| *other == set) {
            return Err(card.error(0, format!("LOAD {set} sums itself with others")));
        }
        Ok(vec![Self { set, scale, parts, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.set).real(self.scale);
        self.parts.iter().fold(card, |card, (factor, set)| card.real(*factor).int(*set))
    }

    // Sets keep their numbers.
    keeps_numbers!();

    // An image has no case control that selects loads.
    no_image!();
}
