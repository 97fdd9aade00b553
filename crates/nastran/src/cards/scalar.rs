//! Springs, masses and dampers between single motions: CELAS1 to CELAS4, PELAS, CMASS1 to CMASS4, PMASS, CDAMP1 to CDAMP4 and PDAMP.

use super::prelude::*;
use crate::card::FIELDS_PER_LINE;
use crate::motion::{Motion, keeps_sign};

/// What a scalar element is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScalarKind {
    /// A stiffness (CELAS).
    Spring,
    /// A mass (CMASS).
    Mass,
    /// A viscous damping, force per velocity (CDAMP).
    Damper,
}

impl ScalarKind {
    /// Of the card of an element or a property.
    fn of(name: &str) -> Self {
        match name {
            "PMASS" => Self::Mass,
            "PDAMP" => Self::Damper,
            _ if name.starts_with("CMASS") => Self::Mass,
            _ if name.starts_with("CDAMP") => Self::Damper,
            _ => Self::Spring,
        }
    }

    /// The letter of its value on cards.
    fn letter(self) -> &'static str {
        match self {
            Self::Spring => "K",
            Self::Mass => "M",
            Self::Damper => "B",
        }
    }
}

/// What a scalar element's number is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScalarValue {
    /// Given on the element (CELAS2, CMASS2, CDAMP2).
    Given(f64),
    /// Given by a property (CELAS1: PELAS, CMASS1: PMASS, CDAMP1: PDAMP).
    Property(u32),
}

impl Ids for ScalarValue {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Self::Property(property) = self {
            change(property);
        }
    }
}

/// A scalar spring (CELAS1 to CELAS4), mass (CMASS1 to CMASS4) or damper (CDAMP1 to CDAMP4) between two motions, or a motion and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarElement {
    /// Identification number.
    pub id: u32,
    /// Stiffness, mass or damping.
    pub value: ScalarValue,
    /// The motions at both ends; none is the ground.
    pub ends: [Option<Motion>; 2],
    /// Which of them.
    pub kind: ScalarKind,
    /// Where the card stands.
    pub span: Span,
}

impl ScalarElement {
    /// Whether it joins scalar points only (CELAS3, CMASS4 and the like).
    fn joins_points(&self) -> bool {
        self.ends.iter().flatten().all(|(_, component)| *component == 0)
    }
}

impl DeckCard for ScalarElement {
    numbered!();
    variant!(|card| {
        usize::from(matches!(card.value, ScalarValue::Given(_))) + 2 * usize::from(card.joins_points())
    });

    /// CELAS1: EID PID G1 C1 G2 C2; CELAS2: EID K G1 C1 G2 C2 GE S; CELAS3: EID PID S1 S2; CELAS4: EID K S1 S2; so, with M or B for
    /// K and no GE and S, CMASS1 to CMASS4 and CDAMP1 to CDAMP4.
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
        let (id, kind) = (card.id(0, "EID")?, ScalarKind::of(&card.name));
        let value = if card.name.ends_with(['2', '4']) {
            ScalarValue::Given(card.real(1, kind.letter())?)
        } else {
            ScalarValue::Property(card.id_or(1, "PID", id)?)
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
        Ok(vec![ScalarElement { id, value, ends, kind, span: card.span.clone() }])
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

/// The value of a scalar property (PELAS K1, PMASS M1, PDAMP B1).
#[derive(Debug, Clone, PartialEq)]
pub struct ScalarProperty {
    /// Identification number.
    pub id: u32,
    /// Stiffness, mass or damping.
    pub value: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for ScalarProperty {
    numbered!();
    /// PELAS: PID K GE S, twice on one card; PMASS and PDAMP: PID M or B, four times on one card.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let kind = ScalarKind::of(&card.name);
        let (stride, what) = (if kind == ScalarKind::Spring { 4 } else { 2 }, kind.letter());
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
