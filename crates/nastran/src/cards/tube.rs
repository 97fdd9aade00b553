//! Tubes: CTUBE and PTUBE.

use super::prelude::*;

/// A rod of a tube's section (CTUBE).
#[derive(Debug, Clone, PartialEq)]
pub struct Ctube {
    /// Identification number.
    pub id: u32,
    /// PTUBE.
    pub property: u32,
    /// End grids.
    pub grids: [u32; 2],
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Ctube {
    numbered!();
    /// CTUBE: EID PID G1 G2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(4)?;
        let id = card.id(0, "EID")?;
        let property = card.id_or(1, "PID", id)?;
        let grids = card.corners(2, &["G1", "G2"])?;
        Ok(vec![Ctube { id, property, grids: [grids[0], grids[1]], span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.property]).ints(self.grids)
    }

    raises!(cards: id, property, grids);

    own_image!();
}

/// A tube's property (PTUBE).
#[derive(Debug, Clone, PartialEq)]
pub struct Ptube {
    /// Identification number.
    pub id: u32,
    /// MAT1.
    pub material: u32,
    /// OD and OD2: outer diameters at the two ends.
    pub diameters: [f64; 2],
    /// T; zero for a solid rod.
    pub thickness: f64,
    /// Non-structural mass per length.
    pub nsm: f64,
    /// Where the card stands.
    pub span: Span,
}

impl Ptube {
    /// Area and torsional constant, the means of the two ends'.
    pub fn section(&self) -> [f64; 2] {
        let mean = |power: i32| {
            let of = |outer: f64| {
                let inner = if self.thickness == 0.0 { 0.0 } else { outer - 2.0 * self.thickness };
                outer.powi(power) - inner.powi(power)
            };
            0.5 * (of(self.diameters[0]) + of(self.diameters[1]))
        };
        [std::f64::consts::PI / 4.0 * mean(2), std::f64::consts::PI / 32.0 * mean(4)]
    }
}

impl DeckCard for Ptube {
    numbered!();
    /// PTUBE: PID MID OD T NSM OD2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(6)?;
        let outer = card.positive(2, "OD")?;
        let other = card.optional_real(5, "OD2")?.filter(|other| *other != 0.0).unwrap_or(outer);
        let thickness = card.not_negative(3, "T", 0.0)?;
        if thickness > 0.5 * outer.min(other) {
            return Err(card.wrong(3, "T", "a thickness of at most half of the diameter"));
        }
        Ok(vec![Ptube {
            id: card.id(0, "PID")?,
            material: card.id(1, "MID")?,
            diameters: [outer, other],
            thickness,
            nsm: card.real_or(4, "NSM", 0.0)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.material]).real(self.diameters[0]).real(self.thickness);
        card.real(self.nsm).real(self.diameters[1])
    }

    raises!(cards: id, material);

    own_image!();
}
