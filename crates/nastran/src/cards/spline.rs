//! Splines: SPLINE1, SPLINE2, SPLINE4 and SPLINE5.

use super::prelude::*;

/// The way a surface spline works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SplineKind {
    /// SPLINE1: infinite plate.
    Plate,
    /// SPLINE2: beam along the y axis of a system; DTOR is the ratio of bending to torsional flexibility.
    Beam {
        /// CID.
        system: u32,
        /// DTOR.
        torsional_ratio: f64,
        /// DTHX, DTHY: flexibility with which rotations about the spline's x and y axes are attached; 0 rigidly,
        /// -1 not at all.
        attachment: [f64; 2],
    },
}

impl Ids for SplineKind {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Self::Beam { system, .. } = self {
            change(system);
        }
    }
}

/// A spline from a set of grids to boxes: a range (SPLINE1, SPLINE2) or a list (SPLINE4, SPLINE5).
#[derive(Debug, Clone, PartialEq)]
pub struct SplineCard {
    /// Identification number.
    pub id: u32,
    /// CAERO1 whose boxes follow.
    pub panel: u32,
    /// First and last box; twice the panel's number if there is a list.
    pub boxes: (u32, u32),
    /// AELIST of the boxes.
    pub list: Option<u32>,
    /// SET1 of the grids.
    pub set: u32,
    /// Plate or beam.
    pub kind: SplineKind,
    /// DZ: flexibility with which displacements are attached; 0 rigidly, more smooths.
    pub flexibility: f64,
    /// FPS: a finite plate is asked for, which is computed as an infinite one.
    pub is_finite_plate: bool,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for SplineCard {
    numbered!();
    variant!(|card| 2 * usize::from(card.list.is_some()) + usize::from(card.kind != SplineKind::Plate));

    /// SPLINE1: EID CAERO BOX1 BOX2 SETG DZ METH USAGE / NELEM MELEM,
    /// SPLINE2: EID CAERO ID1 ID2 SETG DZ DTOR CID / DTHX DTHY blank USAGE,
    /// SPLINE4: EID CAERO AELIST blank SETG DZ METH USAGE / NELEM MELEM FTYPE RCORE, and
    /// SPLINE5: EID CAERO AELIST blank SETG DZ DTOR CID / DTHX DTHY blank USAGE METH blank FTYPE RCORE.
    ///
    /// A finite plate (FPS) is read as an infinite one, which [`SplineCard::is_finite_plate`] tells, and the number of its elements
    /// is skipped; other methods than plate and beam are refused.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let flexibility = card.not_negative(5, "DZ", 0.0)?;
        let by_list = matches!(card.name.as_str(), "SPLINE4" | "SPLINE5");
        let kind = if matches!(card.name.as_str(), "SPLINE1" | "SPLINE4") {
            card.ends_after(if by_list { 12 } else { 10 })?;
            card.word(6, "METH", &["IPS", "FPS"])?;
            card.word(7, "USAGE", &["BOTH"])?;
            SplineKind::Plate
        } else {
            card.ends_after(if by_list { 16 } else { 12 })?;
            let attachment = [attachment(card, 8, "DTHX")?, attachment(card, 9, "DTHY")?];
            card.word(11, "USAGE", &["BOTH"])?;
            if by_list {
                card.word(12, "METH", &["BEAM"])?;
            }
            let torsional_ratio = match card.optional_real(6, "DTOR")? {
                None => 1.0,
                Some(_) => card.positive(6, "DTOR")?,
            };
            SplineKind::Beam { system: card.count_or(7, "CID", 0)?, torsional_ratio, attachment }
        };
        let (id, panel, set) = (card.id(0, "EID")?, card.id(1, "CAERO")?, card.id(4, "SETG")?);
        let (boxes, list) = if by_list {
            card.unset(3, "field 5")?;
            ((panel, panel), Some(card.id(2, "AELIST")?))
        } else {
            ((card.id(2, "BOX1")?, card.id(3, "BOX2")?), None)
        };
        if boxes.1 < boxes.0 {
            let message = format!("box {} of {} comes after box {}", boxes.0, card.name, boxes.1);
            return Err(card.error(3, message).with_help("name the first box, then the last"));
        }
        let is_finite_plate = kind == SplineKind::Plate && card.text(6).eq_ignore_ascii_case("FPS");
        Ok(vec![SplineCard {
            id,
            panel,
            boxes,
            list,
            set,
            kind,
            flexibility,
            is_finite_plate,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.panel]);
        let card = match self.list {
            Some(list) => card.int(list).blanks(1).int(self.set),
            None => card.ints([self.boxes.0, self.boxes.1, self.set]),
        };
        match self.kind {
            SplineKind::Plate if self.is_finite_plate => card.real(self.flexibility).text("FPS"),
            SplineKind::Plate => card.real(self.flexibility),
            SplineKind::Beam { system, torsional_ratio, attachment } => {
                let card = card.real(self.flexibility).real(torsional_ratio).int(system);
                if attachment == [0.0; 2] { card } else { card.reals(&attachment) }
            }
        }
    }

    raises!(cards: id, set, list; boxes: panel, boxes; systems: kind);

    // Left out: splines are made for the whole aircraft.
    no_image!();
}

/// Flexibility of a rotation: zero or more, or -1 for none.
fn attachment(card: &Card, index: usize, name: &str) -> Result<f64, InputError> {
    let value = card.real_or(index, name, 0.0)?;
    if value >= 0.0 || (value + 1.0).abs() < 1e-9 {
        return Ok(value);
    }
    Err(card.wrong(index, name, "-1.0 (not attached) or a flexibility of zero or more"))
}
