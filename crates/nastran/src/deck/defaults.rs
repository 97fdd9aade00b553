//! Cards that give other cards' defaults: GRDSET for GRID, BAROR for CBAR, BEAMOR for CBEAM.
//!
//! They may stand anywhere in a deck, so grids are completed when all is read, and elements with a blank that a default can
//! fill wait until then. A zero that is written is no blank.

use crate::bulk_data::BulkData;
use crate::card::Card;
use crate::source::InputError;

/// Fields of GRID that GRDSET gives: CP, CD, PS.
const GRID_FIELDS: [usize; 3] = [1, 5, 6];

/// Fields of the orientation of CBAR and CBEAM.
const ORIENTATION: [usize; 3] = [4, 5, 6];

/// OFFT of CBAR and CBEAM.
const OFFT: usize = 7;

/// What is known of defaults while a deck is read.
#[derive(Debug, Default)]
pub(crate) struct Defaults {
    grid: Option<Card>,
    bar: Option<Card>,
    beam: Option<Card>,
    /// Grids with blanks among [`GRID_FIELDS`].
    blank: Vec<(u32, [bool; 3])>,
    /// Elements with blanks.
    waiting: Vec<Card>,
}

impl Defaults {
    /// Keeps cards that give defaults or wait for them; gives all others back.
    pub(crate) fn take(&mut self, card: Card) -> Result<Option<Card>, InputError> {
        let place = match card.name.as_str() {
            "GRDSET" => &mut self.grid,
            "BAROR" => &mut self.bar,
            "BEAMOR" => &mut self.beam,
            "GRID" => {
                let blank = GRID_FIELDS.map(|field| card.text(field).is_empty());
                if blank != [false; 3] {
                    self.blank.push((card.id(0, "ID")?, blank));
                }
                return Ok(Some(card));
            }
            "CBAR" | "CBEAM" => {
                let is_blank = |field: usize| card.text(field).is_empty();
                if is_blank(1) || is_blank(OFFT) || ORIENTATION.into_iter().all(is_blank) {
                    self.waiting.push(card);
                    return Ok(None);
                }
                return Ok(Some(card));
            }
            _ => return Ok(Some(card)),
        };
        if let Some(first) = place {
            return Err(card.twice(&card.name, &first.span));
        }
        *place = Some(card);
        Ok(None)
    }

    /// Completes the grids with blanks.
    pub(crate) fn grids(&self, deck: &mut BulkData) -> Result<(), InputError> {
        let Some(card) = &self.grid else { return Ok(()) };
        let (cp, cd) = (card.count_or(1, "CP", 0)?, card.count_or(5, "CD", 0)?);
        let ps = card.components(6, "PS")?;
        for (id, [cp_blank, cd_blank, ps_blank]) in &self.blank {
            let Some(grid) = deck.grids.get_mut(id) else { continue };
            if *cp_blank {
                grid.cp = cp;
            }
            if *cd_blank {
                grid.cd = cd;
            }
            if *ps_blank {
                grid.ps.clone_from(&ps);
            }
        }
        Ok(())
    }

    /// The elements that waited, completed.
    pub(crate) fn elements(&mut self) -> Vec<Card> {
        let mut waiting = std::mem::take(&mut self.waiting);
        for card in &mut waiting {
            let defaults = if card.name == "CBAR" { &self.bar } else { &self.beam };
            let Some(defaults) = defaults else { continue };
            let is_plain = ORIENTATION.into_iter().all(|field| card.text(field).is_empty());
            card.fill(1, defaults);
            card.fill(OFFT, defaults);
            if is_plain {
                for field in ORIENTATION {
                    card.fill(field, defaults);
                }
            }
        }
        waiting
    }
}
