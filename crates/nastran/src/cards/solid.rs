//! Solids: CHEXA, CPENTA, CTETRA and PSOLID.

use super::prelude::*;

/// A solid element (CHEXA with eight grids, CPENTA with six, CTETRA with four).
#[derive(Debug, Clone, PartialEq)]
pub struct SolidElement {
    /// Identification number.
    pub id: u32,
    /// PSOLID.
    pub property: u32,
    /// Corner grids: eight, six or four.
    pub grids: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for SolidElement {
    numbered!();
    fn variant(&self) -> usize {
        match self.grids.len() {
            4 => 2,
            6 => 1,
            _ => 0,
        }
    }

    /// CHEXA, CPENTA, CTETRA: EID PID G1 G2 ...; midside grids are refused.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let names = ["G1", "G2", "G3", "G4", "G5", "G6", "G7", "G8"];
        let (corners, with_midsides) = match card.name.as_str() {
            "CHEXA" => (8, 20),
            "CPENTA" => (6, 15),
            _ => (4, 10),
        };
        let grids = card.corners(2, &names[..corners])?;
        card.ends_after(2 + with_midsides)?;
        if card.len() > 2 + corners {
            let surplus = (2 + corners..card.len()).find(|index| !card.text(*index).is_empty());
            let message = format!(
                "{} {} has midside grids, which are not read; only its {corners} corner grids G1 to G{corners} are",
                card.name,
                card.text(0)
            );
            return Err(card
                .error(surplus.unwrap_or(2 + corners), message)
                .with_help("write the mesh with linear elements"));
        }
        let id = card.id(0, "EID")?;
        Ok(vec![SolidElement { id, property: card.id_or(1, "PID", id)?, grids, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.property]).ints(self.grids.iter().copied())
    }

    raises!(cards: id, property, grids);

    /// Corners are listed the other way round, so that the solid keeps its sense.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        let order: &[usize] = match self.grids.len() {
            8 => &[1, 0, 3, 2, 5, 4, 7, 6],
            6 => &[1, 0, 2, 4, 3, 5],
            _ => &[1, 0, 2, 3],
        };
        self.grids = order.iter().filter_map(|at| self.grids.get(*at).copied()).collect();
        Ok(Some(self))
    }
}

/// A solid's property (PSOLID).
#[derive(Debug, Clone, PartialEq)]
pub struct Psolid {
    /// Identification number.
    pub id: u32,
    /// MAT1 or MAT9.
    pub material: u32,
    /// CORDM: material axes; 0 is basic, a positive number a coordinate system. (-1, element axes, is refused for
    /// materials that are not isotropic.)
    pub cordm: i32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Psolid {
    numbered!();
    /// PSOLID: PID MID CORDM IN STRESS ISOP FCTN; IN, STRESS and ISOP choose integration points and are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(7)?;
        card.word(6, "FCTN", &["SMECH"])?;
        let cordm = card.integer_or(2, "CORDM", 0)?;
        if cordm < -1 {
            return Err(card.wrong(2, "CORDM", "-1, 0 or a coordinate system"));
        }
        Ok(vec![Psolid {
            id: card.id(0, "PID")?,
            material: card.id(1, "MID")?,
            cordm,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.material]).text(self.cordm.to_string())
    }

    raises!(cards: id, material; systems: cordm);

    own_image!();
}
