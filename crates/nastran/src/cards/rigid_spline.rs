//! Grids that follow an elastic line: RSPLINE.

use super::prelude::*;
use super::rigid_body::GridComponents;

/// Grids along a line of which some follow the others as points of an elastic tube do (RSPLINE).
#[derive(Debug, Clone, PartialEq)]
pub struct Rspline {
    /// Identification number.
    pub id: u32,
    /// D/L: diameter of the tube as a share of the length of all segments.
    pub diameter: f64,
    /// The grids in their order, each with the components that follow: none of the first and of the last.
    pub grids: Vec<GridComponents>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Rspline {
    numbered!();
    /// RSPLINE: EID D/L G1 G2 C2 G3 C3 ... Gn; a blank C is none.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (id, diameter) =
            (card.id(0, "EID")?, if card.text(1).is_empty() { 0.1 } else { card.positive(1, "D/L")? });
        let mut grids = vec![(card.id(2, "G1")?, Vec::new())];
        for at in (3..card.len()).step_by(2) {
            let grid = card.id(at, "G")?;
            if grids.iter().any(|(other, _)| *other == grid) {
                return Err(card.error(at, format!("grid {grid} stands twice in RSPLINE {id}")));
            }
            grids.push((grid, card.components(at + 1, "C")?));
        }
        let last = grids.last().filter(|(_, components)| components.is_empty());
        if last.is_none() || grids.len() < 3 || grids.iter().all(|(_, components)| components.is_empty()) {
            let message = format!(
                "RSPLINE {id} does not end with a grid that nothing constrains, or has none between its ends that follows"
            );
            return Err(card
                .error(0, message)
                .with_help("give G1, pairs of a grid and its components, and a last grid"));
        }
        Ok(vec![Rspline { id, diameter, grids, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let Some(((first, _), rest)) = self.grids.split_first() else { return card };
        let card = card.int(self.id).real(self.diameter).int(*first);
        rest.iter().fold(card, |card, (grid, components)| card.int(*grid).digits(components))
    }

    raises!(cards: id, grids);

    own_image!();
}
