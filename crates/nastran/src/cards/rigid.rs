//! Rigid elements about one grid and weighted means: RBE2 and RBE3. Thermal expansion is skipped.

use super::prelude::*;
use crate::real;

/// A rigid element (RBE2).
#[derive(Debug, Clone, PartialEq)]
pub struct Rbe2 {
    /// Identification number.
    pub id: u32,
    /// Independent grid.
    pub independent: u32,
    /// Dependent components, digits 1 to 6.
    pub components: Vec<u8>,
    /// Dependent grids.
    pub dependent: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Rbe2 {
    numbered!();
    /// RBE2: EID GN CM GM1 GM2 ...; a thermal expansion coefficient at the end is skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let components = card.components(2, "CM")?;
        if components.is_empty() {
            return Err(card.empty(2, "CM", "the dependent components, such as 123456"));
        }
        let has_alpha = card.len() > 4 && real::parse(card.text(card.len() - 1)).is_some();
        let end = card.len() - usize::from(has_alpha);
        Ok(vec![Rbe2 {
            id: card.id(0, "EID")?,
            independent: card.id(1, "GN")?,
            components,
            dependent: card.id_list_until(3, end, "GM")?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.independent]).digits(&self.components);
        card.ints(self.dependent.iter().copied())
    }

    raises!(cards: id, independent, dependent);

    own_image!();
}

/// One group of an RBE3: weight, components, grids.
#[derive(Debug, Clone, PartialEq)]
pub struct Rbe3Group {
    /// WT.
    pub weight: f64,
    /// C: components, digits 1 to 6.
    pub components: Vec<u8>,
    /// G.
    pub grids: Vec<u32>,
}

impl Ids for Rbe3Group {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        self.grids.each(change);
    }
}

/// A motion that is the weighted mean of others (RBE3).
#[derive(Debug, Clone, PartialEq)]
pub struct Rbe3 {
    /// Identification number.
    pub id: u32,
    /// REFGRID.
    pub reference: u32,
    /// REFC: its components that follow.
    pub components: Vec<u8>,
    /// What they follow.
    pub groups: Vec<Rbe3Group>,
    /// UM: the motions to be made dependent instead of the reference's, grid and components.
    pub um: Vec<(u32, Vec<u8>)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Rbe3 {
    numbered!();
    /// RBE3: EID blank REFGRID REFC WT1 C1 G1,1 G1,2 ... WT2 C2 ... UM GM1 CM1 GM2 CM2 ... ALPHA a.
    ///
    /// Groups start with a real number. Thermal expansion is skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let id = card.id(0, "EID")?;
        let find = |word: &str| (4..card.len()).find(|index| card.text(*index).eq_ignore_ascii_case(word));
        let end = find("ALPHA").unwrap_or(card.len());
        let um_at = find("UM").filter(|index| *index < end);
        let groups = groups(card, 4, um_at.unwrap_or(end))?;
        if groups.is_empty() {
            let message = format!("RBE3 {id} has no grids to follow");
            return Err(card
                .error(4, message)
                .with_help("give a weight, components and grids: 1.0, 123, G1, G2"));
        }
        let mut um = Vec::new();
        let mut at = um_at.map_or(end, |index| index + 1);
        while at < end {
            if card.text(at).is_empty() {
                at += 1;
            } else {
                um.push((card.id(at, "GM")?, card.some_components(at + 1, "CM")?));
                at += 2;
            }
        }
        Ok(vec![Rbe3 {
            id,
            reference: card.id(2, "REFGRID")?,
            components: card.some_components(3, "REFC")?,
            groups,
            um,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id).blanks(1).int(self.reference).digits(&self.components);
        let mut card = self.groups.iter().fold(card, |card, group| {
            card.real(group.weight).digits(&group.components).ints(group.grids.iter().copied())
        });
        for (line, motions) in self.um.chunks(3).enumerate() {
            card = card.next_line();
            card = if line == 0 { card.text("UM") } else { card.blanks(1) };
            card = motions.iter().fold(card, |card, (grid, components)| card.int(*grid).digits(components));
        }
        card
    }

    raises!(cards: id, reference, groups, um);

    own_image!();
}

fn groups(card: &Card, from: usize, end: usize) -> Result<Vec<Rbe3Group>, InputError> {
    let is_weight = |index: usize| real::parse(card.text(index)).is_some();
    let mut groups = Vec::new();
    let mut at = from;
    while at < end {
        if card.text(at).is_empty() {
            at += 1;
            continue;
        }
        let (weight, components) = (card.real(at, "WT")?, card.some_components(at + 1, "C")?);
        if weight < 0.0 {
            return Err(card.wrong(at, "WT", "zero or more"));
        }
        let next = (at + 2..end).find(|index| is_weight(*index)).unwrap_or(end);
        let grids = card.id_list_until(at + 2, next, "G")?;
        groups.push(Rbe3Group { weight, components, grids });
        at = next;
    }
    Ok(groups)
}
