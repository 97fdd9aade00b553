//! Control surfaces and lists of boxes: AESURF and AELIST.

use super::prelude::*;

/// A control surface (AESURF): one or two hinge systems, each with its box list.
#[derive(Debug, Clone, PartialEq)]
pub struct Aesurf {
    /// Identification number.
    pub id: u32,
    /// Label.
    pub label: String,
    /// (CID, AELIST) pairs; the hinge is the y axis of CID.
    pub parts: Vec<(u32, u32)>,
    /// EFF.
    pub effectiveness: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aesurf {
    numbered!();
    /// AESURF: ID LABEL CID1 ALID1 CID2 ALID2 EFF; limits and reference values are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let mut parts = vec![(card.count_or(2, "CID1", 0)?, card.id(3, "ALID1")?)];
        if !card.text(5).is_empty() {
            parts.push((card.count_or(4, "CID2", 0)?, card.id(5, "ALID2")?));
        }
        Ok(vec![Aesurf {
            id: card.id(0, "ID")?,
            label: card.name_at(1, "LABEL")?,
            parts,
            effectiveness: card.real_or(6, "EFF", 1.0)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id).text(self.label.clone());
        let card = self.parts.iter().take(2).fold(card, |card, part| card.ints([part.0, part.1]));
        card.blanks(4 - 2 * self.parts.len().min(2)).real(self.effectiveness)
    }

    fn raise(&mut self, by: Step) {
        by.cards(&mut self.id);
        for (system, list) in &mut self.parts {
            by.systems(system);
            by.cards(list);
        }
    }

    own_image!();
}

/// A list of boxes (AELIST), THRU expanded.
#[derive(Debug, Clone, PartialEq)]
pub struct Aelist {
    /// Identification number.
    pub id: u32,
    /// Box identification numbers.
    pub boxes: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aelist {
    numbered!();
    /// AELIST: SID E1 E2 ... or E1 THRU E2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        Ok(vec![Aelist { id: card.id(0, "SID")?, boxes: card.id_list(1, "E")?, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).ints(self.boxes.iter().copied())
    }

    raises!(cards: id; boxes: boxes);

    /// The images of its boxes, in ascending number.
    fn mirrored(mut self, mirror: &Mirror) -> Mirrored<Self> {
        let image = |id: &u32| mirror.boxes.get(id).copied().unwrap_or(*id);
        self.boxes = self.boxes.iter().map(image).collect();
        self.boxes.sort_unstable();
        Ok(Some(self))
    }
}
