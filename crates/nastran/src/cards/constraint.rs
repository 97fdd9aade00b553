//! Clamps and constraint equations: SPC1, SPC and MPC, and the unions of their sets, SPCADD and MPCADD.

use super::prelude::*;
use crate::card::FIELDS_PER_LINE;
use crate::motion::{Motion, keeps_sign};

/// Clamped components of grids (SPC1; SPC, where a motion is enforced).
#[derive(Debug, Clone, PartialEq)]
pub struct Spc1 {
    /// Set identification.
    pub set: u32,
    /// Components, digits 1 to 6; none at a scalar point.
    pub components: Vec<u8>,
    /// Grids or scalar points.
    pub grids: Vec<u32>,
    /// Enforced displacement or rotation in the grids' displacement systems (field D of SPC); modes, flutter and trims hold the motion.
    pub enforced: f64,
    /// Where the card stands.
    pub span: Span,
}

/// SPC: SID G1 C1 D1 G2 C2 D2, as the SPC1 that say the same.
fn spc(card: &Card) -> Result<Vec<Spc1>, InputError> {
    card.ends_after(7)?;
    let set = card.id(0, "SID")?;
    let mut all = Vec::new();
    for at in [1, 4] {
        if at > 1 && (at..at + 3).all(|index| card.text(index).is_empty()) {
            continue;
        }
        let (grid, components) = (card.id(at, "G")?, card.components(at + 1, "C")?);
        let enforced = card.real_or(at + 2, "D", 0.0)?;
        all.push(Spc1 { set, components, grids: vec![grid], enforced, span: card.span.clone() });
    }
    Ok(all)
}

impl DeckCard for Spc1 {
    keyed!(u32, set);
    variant!(|card| usize::from(card.enforced != 0.0));
    /// SPC1: SID C G1 G2 ... or G1 THRU G2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        if card.name == "SPC" {
            return spc(card);
        }
        let components = card.components(1, "C")?;
        let grids = card.id_list(2, "G")?;
        Ok(vec![Spc1 { set: card.id(0, "SID")?, components, grids, enforced: 0.0, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        match self.grids.as_slice() {
            [grid] if self.enforced != 0.0 => {
                card.ints([self.set, *grid]).digits(&self.components).real(self.enforced)
            }
            _ => card.int(self.set).digits(&self.components).ints(self.grids.iter().copied()),
        }
    }

    // Sets keep their numbers.
    raises!(cards: grids);

    own_image!();
}

/// A constraint equation (MPC): the sum of coefficient times motion is zero; the first motion is dependent.
#[derive(Debug, Clone, PartialEq)]
pub struct Mpc {
    /// Set identification.
    pub set: u32,
    /// Motion and coefficient.
    pub terms: Vec<(Motion, f64)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mpc {
    keyed!(u32, set);
    /// MPC: SID G1 C1 A1 G2 C2 A2 blank / blank G3 C3 A3 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let set = card.id(0, "SID")?;
        let mut terms = Vec::new();
        for line in (0..card.len().max(2)).step_by(FIELDS_PER_LINE) {
            for at in [line + 1, line + 4] {
                if at == 1 || (at..at + 3).any(|index| !card.text(index).is_empty()) {
                    let motion = card.motion(at, "G", "C")?;
                    if terms.iter().any(|(other, _)| *other == motion) {
                        let message = format!("motion {} of grid {} stands twice in MPC", motion.1, motion.0);
                        return Err(card.error(at, message));
                    }
                    terms.push((motion, card.real(at + 2, "A")?));
                }
            }
            for index in [line + 7, line + 8] {
                if !card.text(index).is_empty() {
                    let message =
                        format!("`{}` stands in a field of MPC that is always empty", card.text(index));
                    return Err(card
                        .error(index, message)
                        .with_help("two terms a line, from the third column on"));
                }
            }
        }
        match terms.first() {
            Some((_, 0.0)) => {
                Err(card.error(3, "the coefficient of the dependent motion (A1) of MPC is zero"))
            }
            _ => Ok(vec![Mpc { set, terms, span: card.span.clone() }]),
        }
    }

    fn write(&self, card: Fields) -> Fields {
        let mut card = card;
        for (line, terms) in self.terms.chunks(2).enumerate() {
            card = card.next_line();
            card = if line == 0 { card.int(self.set) } else { card.blanks(1) };
            card = terms.iter().fold(card, |card, (motion, factor)| card.motion(Some(*motion)).real(*factor));
        }
        card
    }

    // Sets keep their numbers.
    raises!(cards: terms);

    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        for (motion, factor) in &mut self.terms {
            *factor = if keeps_sign(*motion) { *factor } else { minus(*factor) };
        }
        Ok(Some(self))
    }
}

/// The sets that a set unites (SPCADD, MPCADD).
#[derive(Debug, Clone, PartialEq)]
pub struct SetUnion {
    /// Set identification.
    pub set: u32,
    /// The sets it unites.
    pub sets: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for SetUnion {
    keyed!(u32, set);
    /// SID S1 S2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (set, sets) = (card.id(0, "SID")?, card.id_list(1, "S")?);
        if sets.contains(&set) {
            return Err(card.error(0, format!("{} {set} unites itself with others", card.name)));
        }
        Ok(vec![Self { set, sets, span: card.span.clone() }])
    }

    // A selection of the case control's, which is not written.
    not_written!();

    // Sets keep their numbers.
    keeps_numbers!();

    // An image has no case control, so all of its sets apply.
    no_image!();
}
