//! Springs and masses between single motions: CELAS1 to CELAS4, PELAS, CMASS1 to CMASS4 and PMASS.

use super::prelude::*;
use crate::card::FIELDS_PER_LINE;
use crate::motion::{Motion, keeps_sign};

/// What a scalar element's number is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScalarValue {
    /// Given on the element (CELAS2, CMASS2).
    Given(f64),
    /// Given by a property (CELAS1: PELAS, CMASS1: PMASS).
    Property(u32),
}

impl Ids for ScalarValue {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Self::Property(property) = self {
            change(property);
        }
    }
}

/// A scalar spring (CELAS1 to CELAS4) or mass (CMASS1 to CMASS4) between two motions, or a motion and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarElement {
    /// Identification number.
    pub id: u32,
    /// Stiffness or mass.
    pub value: ScalarValue,
    /// The motions at both ends; none is the ground.
    pub ends: [Option<Motion>; 2],
    /// True for CMASS1 and CMASS2, false for CELAS1 and CELAS2.
    pub is_mass: bool,
    /// Where the card stands.
    pub span: Span,
}

impl ScalarElement {
    /// Whether it joins scalar points only (CELAS3, CELAS4, CMASS3, CMASS4).
    fn joins_points(&self) -> bool {
        self.ends.iter().flatten().all(|(_, component)| *component == 0)
    }
}

impl DeckCard for ScalarElement {
    numbered!();
    variant!(|card| {
        usize::from(matches!(card.value, ScalarValue::Given(_))) + 2 * usize::from(card.joins_points())
    });

    /// CELAS1, CMASS1: EID PID G1 C1 G2 C2; CELAS2: EID K G1 C1 G2 C2 GE S; CMASS2: EID M G1 C1 G2 C2; CELAS3, CMASS3:
    /// EID PID S1 S2; CELAS4: EID K S1 S2; CMASS4: EID M S1 S2.
    ///
    /// Damping and stress coefficients are skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let is_scalar = card.name.ends_with(['3', '4']);
        card.ends_after(if card.name == "CELAS2" {
            8
        } else if is_scalar {
            4
        } else {
            6
        })?;
        let id = card.id(0, "EID")?;
        let value = match card.name.as_str() {
            "CELAS2" | "CELAS4" => ScalarValue::Given(card.real(1, "K")?),
            "CMASS2" | "CMASS4" => ScalarValue::Given(card.real(1, "M")?),
            _ => ScalarValue::Property(card.id_or(1, "PID", id)?),
        };
        let ends = if is_scalar {
            let point = |at: usize, name: &str| {
                Ok(Some(card.count_or(at, name, 0)?).filter(|id| *id > 0).map(|id| (id, 0)))
            };
            [point(2, "S1")?, point(3, "S2")?]
        } else {
            [end(card, 2, "G1", "C1")?, end(card, 4, "G2", "C2")?]
        };
        if ends[0] == ends[1] {
            let message = match ends[0] {
                None => format!("{} {id} has no grid at either end", card.name),
                Some((grid, _)) => {
                    format!("both ends of {} {id} are the same motion of grid {grid}", card.name)
                }
            };
            return Err(card.error(2, message));
        }
        Ok(vec![ScalarElement {
            id,
            value,
            ends,
            is_mass: card.name.starts_with("CMASS"),
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id);
        let card = match self.value {
            ScalarValue::Property(property) => card.int(property),
            ScalarValue::Given(value) => card.real(value),
        };
        if self.joins_points() {
            return card.ints(self.ends.map(|end| end.map_or(0, |(point, _)| point)));
        }
        card.motion(self.ends[0]).motion(self.ends[1])
    }

    raises!(cards: id, value, ends);

    fn mirrored(self, _: &Mirror) -> Mirrored<Self> {
        match self.ends {
            [Some(a), Some(b)] if keeps_sign(a) != keeps_sign(b) => {
                let message = format!(
                    "scalar element {} joins motions of which one changes its sign in the mirror",
                    self.id
                );
                Err(InputError::at(&self.span, message)
                    .with_help("join motions of the same kind, or use an MPC and a spring to the ground"))
            }
            _ => Ok(Some(self)),
        }
    }
}

/// A motion, or the ground where the grid is empty or zero.
fn end(card: &Card, index: usize, grid: &str, digit: &str) -> Result<Option<Motion>, InputError> {
    if matches!(card.text(index), "" | "0") {
        card.unset(index + 1, digit)?;
        return Ok(None);
    }
    card.motion(index, grid, digit).map(Some)
}

/// The value of a scalar property (PELAS K1, PMASS M1).
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarProperty {
    /// Identification number.
    pub id: u32,
    /// Stiffness or mass.
    pub value: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for ScalarProperty {
    numbered!();
    /// PELAS: PID K GE S, twice on one card; PMASS: PID M, four times on one card.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let (stride, what) = if card.name == "PELAS" { (4, "K") } else { (2, "M") };
        card.ends_after(FIELDS_PER_LINE)?;
        let mut properties = Vec::new();
        for at in (0..card.len().max(1)).step_by(stride) {
            let is_empty = (at..at + stride).all(|index| card.text(index).is_empty());
            if at > 0 && is_empty {
                continue;
            }
            let (id, value) = (card.id(at, "PID")?, card.real(at + 1, what)?);
            properties.push(ScalarProperty { id, value, span: card.span.clone() });
        }
        Ok(properties)
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).real(self.value)
    }

    raises!(cards: id);

    own_image!();
}
