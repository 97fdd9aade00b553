//! Generalised springs: CBUSH and PBUSH.

use super::beam::{Orientation, optional_orientation};
use super::prelude::*;
use crate::card::FIELDS_PER_LINE;
use nalgebra::Point3;

/// The axes of a bush.
#[derive(Debug, Clone, PartialEq)]
pub enum BushAxes {
    /// CID: a coordinate system; 0 is basic.
    System(u32),
    /// x from end A to end B, the plane x-y by an orientation vector.
    Oriented(Orientation),
    /// Neither is given: x from end A to end B, only K1 and K4 may be there.
    Line,
}

/// A generalised spring (CBUSH).
#[derive(Debug, Clone, PartialEq)]
pub struct Cbush {
    /// Identification number.
    pub id: u32,
    /// PBUSH.
    pub property: u32,
    /// End grids; without a second one the bush ends at the ground.
    pub grids: (u32, Option<u32>),
    /// Axes of the stiffnesses.
    pub axes: BushAxes,
    /// S: place of the spring between A (0) and B (1).
    pub location: f64,
    /// OCID and S1 to S3: place of the spring in a coordinate system, instead of S, from end A.
    pub offset: Option<(u32, Point3<f64>)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Cbush {
    numbered!();
    /// CBUSH: EID PID GA GB GO/X1 X2 X3 CID / S OCID S1 S2 S3.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(13)?;
        let id = card.id(0, "EID")?;
        let grids = (card.id(2, "GA")?, card.optional_id(3, "GB")?);
        if grids.1 == Some(grids.0) {
            return Err(card.error(3, format!("grid {} stands twice in CBUSH {id}", grids.0)));
        }
        let oriented = optional_orientation(card)?;
        let axes = match oriented {
            _ if !card.text(7).is_empty() => BushAxes::System(card.count_or(7, "CID", 0)?),
            Some(orientation) => BushAxes::Oriented(orientation),
            None => BushAxes::Line,
        };
        if grids.1.is_none() && !matches!(axes, BushAxes::System(_)) {
            let message = format!("CBUSH {id} ends at the ground but names no coordinate system in CID");
            return Err(card.error(3, message).with_help("give CID, 0 for the basic system"));
        }
        let location = card.real_or(8, "S", 0.5)?;
        if !(0.0..=1.0).contains(&location) {
            return Err(card.wrong(8, "S", "from 0 to 1"));
        }
        let ocid = card.integer_or(9, "OCID", -1)?;
        let offset = match u32::try_from(ocid) {
            Ok(system) => Some((system, card.vector(10, ["S1", "S2", "S3"])?)),
            Err(_) if ocid == -1 => None,
            Err(_) => return Err(card.wrong(9, "OCID", "-1, 0 or a coordinate system")),
        };
        Ok(vec![Cbush {
            id,
            property: card.id_or(1, "PID", id)?,
            grids,
            axes,
            location,
            offset,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.property, self.grids.0]).optional(self.grids.1);
        let card = match &self.axes {
            BushAxes::System(system) => card.blanks(3).int(*system),
            BushAxes::Oriented(orientation) => orientation.write(card).blanks(1),
            BushAxes::Line => card.blanks(4),
        };
        let card = card.real(self.location);
        match &self.offset {
            Some((system, place)) => card.int(*system).reals(&place.coords),
            None => card,
        }
    }

    fn raise(&mut self, by: Step) {
        by.cards(&mut self.id);
        by.cards(&mut self.property);
        by.cards(&mut self.grids);
        match &mut self.axes {
            BushAxes::System(system) => by.systems(system),
            BushAxes::Oriented(orientation) => by.cards(orientation),
            BushAxes::Line => {}
        }
        if let Some((system, _)) = &mut self.offset {
            by.systems(system);
        }
    }

    /// The place is flipped in a mirrored system, too: its y axis is minus the image of the original's.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        if let BushAxes::Oriented(orientation) = self.axes {
            self.axes = BushAxes::Oriented(orientation.mirrored());
        }
        self.offset = self.offset.map(|(system, place)| (system, flipped(place.coords).into()));
        Ok(Some(self))
    }
}

/// A bush's property (PBUSH): six stiffnesses, six dampings and a mass.
#[derive(Debug, Clone, PartialEq)]
pub struct Pbush {
    /// Identification number.
    pub id: u32,
    /// K1 to K6.
    pub stiffness: [f64; 6],
    /// B1 to B6: viscous damping, force per velocity.
    pub damping: [f64; 6],
    /// M: mass, at the place of the spring.
    pub mass: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pbush {
    numbered!();
    /// PBUSH: PID, then rows of a word and its values: K, B and M are read, GE and RCV are skipped, thermal expansion (T) is refused.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (mut stiffness, mut damping, mut mass) = ([0.0; 6], [0.0; 6], 0.0);
        for row in (0..card.len()).step_by(FIELDS_PER_LINE) {
            let six = |letter: &str| -> Result<[f64; 6], InputError> {
                let mut values = [0.0; 6];
                for (index, value) in values.iter_mut().enumerate() {
                    *value = card.not_negative(row + 2 + index, &format!("{letter}{}", index + 1), 0.0)?;
                }
                Ok(values)
            };
            match card.text(row + 1).to_uppercase().as_str() {
                "K" => stiffness = six("K")?,
                "B" => damping = six("B")?,
                "M" => mass = card.not_negative(row + 2, "M", 0.0)?,
                "T" => card.unset(row + 2, "ALPHA")?,
                "GE" | "RCV" | "" => {}
                _ => {
                    let known = "K, B, M, GE, RCV or T, the only rows that are known";
                    return Err(card.wrong(row + 1, "FLAG", known));
                }
            }
        }
        Ok(vec![Pbush { id: card.id(0, "PID")?, stiffness, damping, mass, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let mut card = card.int(self.id).text("K").reals(&self.stiffness);
        if self.damping != [0.0; 6] {
            card = card.blanks(1).text("B").reals(&self.damping);
        }
        if self.mass != 0.0 {
            card = card.blanks(1).text("M").real(self.mass);
        }
        card
    }

    raises!(cards: id);

    own_image!();
}
