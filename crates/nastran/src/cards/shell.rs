//! Shells of one thickness: CQUAD4, CTRIA3, their kin and PSHELL.

use super::prelude::*;
use super::solid::{midsides, reordered};
use crate::card::FIELDS_PER_LINE;

/// Nastran's default of TS/T: what MSC punches of single elements has 5/6 to ten digits.
const SHEAR_RATIO: f64 = 5.0 / 6.0;

/// The direction a shell's material axes are measured from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MaterialDirection {
    /// THETA: degrees from the side between the first two grids.
    AngleDeg(f64),
    /// MCID: the x axis of this coordinate system, projected onto the element.
    System(u32),
}

impl Ids for MaterialDirection {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Self::System(system) = self {
            change(system);
        }
    }
}

/// A shell element (CQUAD4, CQUADR or CQUAD8 with four corners, CTRIA3, CTRIAR or CTRIA6 with three).
#[derive(Debug, Clone, PartialEq)]
pub struct ShellElement {
    /// Identification number.
    pub id: u32,
    /// Property (PSHELL, PCOMP or PCOMPG).
    pub property: u32,
    /// Corner grids in order around the element: three or four.
    pub grids: Vec<u32>,
    /// Grids on the sides (CQUAD8, CTRIA6), in the order of [`Self::sides`]: empty, or one for each side that may be missing.
    pub midsides: Vec<Option<u32>>,
    /// Where the material's axes come from.
    pub direction: MaterialDirection,
    /// True for CQUADR and CTRIAR, whose membrane has its corners' rotations about the normal.
    pub is_r: bool,
    /// ZOFFS: distance from the plane of the grids to the reference plane, along the element's normal.
    pub offset: f64,
    /// Thicknesses at the corners, where they are not the property's.
    pub thickness: CornerThickness,
    /// Where the card stands.
    pub span: Span,
}

impl ShellElement {
    /// The sides in the order of the grids on them: places in `grids` of the corners at their ends.
    pub fn sides(&self) -> &'static [[usize; 2]] {
        if self.grids.len() == 4 { &[[0, 1], [1, 2], [2, 3], [3, 0]] } else { &[[0, 1], [1, 2], [2, 0]] }
    }

    /// CQUAD8: EID PID G1 G2 G3 G4 G5 G6 / G7 G8 T1 T2 T3 T4 THETA/MCID ZOFFS / TFLAG, and
    /// CTRIA6: EID PID G1 G2 G3 G4 G5 G6 / THETA/MCID ZOFFS T1 T2 T3 TFLAG.
    fn curved(card: &Card) -> Result<Self, InputError> {
        let corners = corners(card);
        let count = corners.len();
        let Places { angle, offset, flag, .. } = places(card);
        card.ends_after(flag + 1)?;
        let id = card.id(0, "EID")?;
        Ok(Self {
            id,
            property: card.id_or(1, "PID", id)?,
            grids: card.corners(2, corners)?,
            midsides: midsides(card, 2 + count, count)?,
            direction: direction(card, angle)?,
            is_r: false,
            offset: card.real_or(offset, "ZOFFS", 0.0)?,
            thickness: CornerThickness::read(card)?,
            span: card.span.clone(),
        })
    }
}

/// Where the fields of a shell's card are.
struct Places {
    angle: usize,
    offset: usize,
    flag: usize,
    thickness: usize,
}

fn places(card: &Card) -> Places {
    match card.name.as_str() {
        "CQUAD8" => Places { angle: 14, offset: 15, flag: 16, thickness: 10 },
        "CTRIA6" => Places { angle: 8, offset: 9, flag: 13, thickness: 10 },
        _ => {
            let angle = 2 + corners(card).len();
            Places { angle, offset: angle + 1, flag: FIELDS_PER_LINE + 1, thickness: FIELDS_PER_LINE + 2 }
        }
    }
}

impl DeckCard for ShellElement {
    numbered!();
    variant!(|card| {
        let kind = if card.is_r { 2 } else { 4 * usize::from(!card.midsides.is_empty()) };
        kind + usize::from(card.grids.len() == 3)
    });

    /// CQUAD4: EID PID G1 G2 G3 G4 THETA/MCID ZOFFS / blank TFLAG T1 T2 T3 T4, and
    /// CTRIA3: EID PID G1 G2 G3 THETA/MCID ZOFFS blank / blank TFLAG T1 T2 T3; CQUADR and CTRIAR alike.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        if matches!(card.name.as_str(), "CQUAD8" | "CTRIA6") {
            return Ok(vec![Self::curved(card)?]);
        }
        let corners = corners(card);
        let id = card.id(0, "EID")?;
        let after = 2 + corners.len();
        for index in (after + 2)..=FIELDS_PER_LINE {
            if !card.text(index).is_empty() {
                let message = format!("a field of {} that is always empty has a value", card.name);
                return Err(card.error(index, message));
            }
        }
        card.ends_after(FIELDS_PER_LINE + 2 + corners.len())?;
        Ok(vec![Self {
            id,
            property: card.id_or(1, "PID", id)?,
            grids: card.corners(2, corners)?,
            midsides: Vec::new(),
            direction: direction(card, after)?,
            is_r: card.name.ends_with('R'),
            offset: card.real_or(after + 1, "ZOFFS", 0.0)?,
            thickness: CornerThickness::read(card)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.property]).ints(self.grids.iter().copied());
        let card = self.midsides.iter().fold(card, |card, grid| card.optional(*grid));
        let given = self.thickness.at.len();
        // Of a CQUAD8 the corner thicknesses come first.
        let card = match self.midsides.len() {
            4 if given == 0 => card.blanks(4),
            4 => self.thickness.write(card),
            _ => card,
        };
        let card = match self.direction {
            MaterialDirection::AngleDeg(angle) => card.real(angle),
            MaterialDirection::System(system) => card.int(system),
        };
        let card = card.real(self.offset);
        let flag = |card: Fields| card.optional((self.thickness.is_ratio).then_some(1));
        match (self.midsides.len(), self.grids.len()) {
            _ if given == 0 => card,
            (4, _) => flag(card),
            (3, _) => flag(self.thickness.write(card)),
            (_, corners) => self.thickness.write(flag(card.blanks(FIELDS_PER_LINE + 1 - corners - 4))),
        }
    }

    raises!(cards: id, property, grids, midsides; systems: direction);

    /// Corners are listed the other way round, so that the normal is the image of the normal.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        let order: &[usize] = if self.grids.len() == 4 { &[1, 0, 3, 2] } else { &[1, 0, 2] };
        self.midsides = reordered(&self.midsides, self.sides(), order);
        self.grids = order.iter().map(|at| self.grids[*at]).collect();
        if !self.thickness.at.is_empty() {
            self.thickness.at = order.iter().map(|at| self.thickness.at[*at]).collect();
        }
        if let MaterialDirection::AngleDeg(angle) = &mut self.direction {
            *angle = minus(*angle);
        }
        Ok(Some(self))
    }
}

/// Names of the fields of the corners.
fn corners(card: &Card) -> &'static [&'static str] {
    if card.name.starts_with("CQUAD") { &["G1", "G2", "G3", "G4"] } else { &["G1", "G2", "G3"] }
}

/// Thicknesses of a shell at its corners (T1 to T4, TFLAG).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CornerThickness {
    /// Those given; empty if none is. A corner without one has the property's.
    pub at: Vec<Option<f64>>,
    /// They are in units of the property's thickness (TFLAG 1).
    pub is_ratio: bool,
}

impl CornerThickness {
    fn read(card: &Card) -> Result<Self, InputError> {
        let Places { flag, thickness, .. } = places(card);
        let is_ratio = match card.count_or(flag, "TFLAG", 0)? {
            0 => false,
            1 => true,
            _ => return Err(card.wrong(flag, "TFLAG", "0 or 1")),
        };
        let mut at = Vec::new();
        for (index, name) in (thickness..).zip(["T1", "T2", "T3", "T4"]).take(corners(card).len()) {
            let value = card.optional_real(index, name)?;
            if value.is_some_and(|value| !(value >= 0.0 && value.is_finite())) {
                return Err(card.wrong(index, name, "a thickness of zero or more"));
            }
            at.push(value);
        }
        Ok(if at.iter().all(Option::is_none) { Self::default() } else { Self { at, is_ratio } })
    }

    /// In units of the property's thickness, one a corner; nothing if all are the property's (to the digits of a card: ply thicknesses are
    /// summed).
    pub fn ratios(&self, property: f64) -> Option<Vec<f64>> {
        let unit = if self.is_ratio { 1.0 } else { property };
        let ratio = |value: &Option<f64>| value.map_or(1.0, |value| value / unit);
        let ratios: Vec<f64> = self.at.iter().map(ratio).collect();
        ratios.iter().any(|ratio| (ratio - 1.0).abs() > 1e-6).then_some(ratios)
    }

    fn write(&self, card: Fields) -> Fields {
        self.at.iter().fold(card, |card, value| card.optional_real(*value))
    }
}

/// A whole number is a coordinate system, a real an angle.
fn direction(card: &Card, index: usize) -> Result<MaterialDirection, InputError> {
    let text = card.text(index);
    if text.is_empty() {
        return Ok(MaterialDirection::AngleDeg(0.0));
    }
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return Ok(MaterialDirection::System(card.count_or(index, "MCID", 0)?));
    }
    card.real(index, "THETA").map(MaterialDirection::AngleDeg).map_err(|_| {
        card.wrong(index, "THETA", "an angle with a decimal point or the whole number of a coordinate system")
    })
}

/// A shell of one thickness (PSHELL).
#[derive(Debug, Clone, PartialEq)]
pub struct Pshell {
    /// Identification number.
    pub id: u32,
    /// MID1: membrane material; none means no membrane stiffness.
    pub membrane: Option<u32>,
    /// T.
    pub thickness: f64,
    /// MID2: bending material; none means no bending stiffness.
    pub bending: Option<u32>,
    /// 12I/T^3.
    pub bending_ratio: f64,
    /// MID3: transverse shear material; none means no shear flexibility.
    pub shear: Option<u32>,
    /// TS/T.
    pub shear_ratio: f64,
    /// NSM: non-structural mass per area.
    pub nsm: f64,
    /// MID4: material that couples membrane and bending.
    pub coupling: Option<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pshell {
    numbered!();
    /// PSHELL: PID MID1 T MID2 12I/T^3 MID3 TS/T NSM / Z1 Z2 MID4; stress distances are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(11)?;
        if card.text(3) == "-1" {
            return Err(card.error(3, "plane strain (MID2 = -1) of PSHELL is not read"));
        }
        let property = Pshell {
            id: card.id(0, "PID")?,
            membrane: card.optional_id(1, "MID1")?,
            thickness: card.positive(2, "T")?,
            bending: card.optional_id(3, "MID2")?,
            bending_ratio: card.not_negative(4, "12I/T**3", 1.0)?,
            shear: card.optional_id(5, "MID3")?,
            shear_ratio: card.not_negative(6, "TS/T", SHEAR_RATIO)?,
            nsm: card.real_or(7, "NSM", 0.0)?,
            coupling: card.optional_id(10, "MID4")?,
            span: card.span.clone(),
        };
        if property.membrane.is_none() && property.bending.is_none() {
            return Err(card.empty(1, "MID1", "a material here or in MID2"));
        }
        if property.shear.is_some() && property.bending.is_none() {
            return Err(card.error(5, "PSHELL has a shear material (MID3) but no bending material (MID2)"));
        }
        if property.coupling.is_some() && (property.membrane.is_none() || property.bending.is_none()) {
            return Err(card.error(10, "PSHELL has a coupling material (MID4) without both MID1 and MID2"));
        }
        Ok(vec![property])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id).optional(self.membrane).real(self.thickness);
        let card = card.optional(self.bending).real(self.bending_ratio).optional(self.shear);
        card.real(self.shear_ratio).real(self.nsm).blanks(2).optional(self.coupling)
    }

    raises!(cards: id, membrane, bending, shear, coupling);

    own_image!();
}
