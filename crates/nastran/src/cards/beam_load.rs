//! Loads along bars and beams: PLOAD1.

use super::prelude::*;

/// A force or moment along a stretch of a bar or beam, or at one place of it (PLOAD1).
#[derive(Debug, Clone, PartialEq)]
pub struct BeamLoad {
    /// Load set.
    pub set: u32,
    /// The CBAR or CBEAM.
    pub element: u32,
    /// Its component: 1 to 3 a force along x, y, z, 4 to 6 a moment about them.
    pub component: u8,
    /// In the element's axes, not the basic ones.
    pub is_element: bool,
    /// Places are lengths from end A, not shares of the length.
    pub is_length: bool,
    /// The load is one on the length that is seen along its direction (scales LEPR and FRPR of a force along basic axes; along the element's they are LE
    /// and FR).
    pub is_projected: bool,
    /// Where it begins and ends; the same place: it is concentrated there.
    pub places: [f64; 2],
    /// There; linear between. Per length, or a force or moment if concentrated.
    pub values: [f64; 2],
    /// Where the card stands.
    pub span: Span,
}

/// TYPE without its E.
const TYPES: [&str; 6] = ["FX", "FY", "FZ", "MX", "MY", "MZ"];

impl DeckCard for BeamLoad {
    keyed!(u32, set);
    /// PLOAD1: SID EID TYPE SCALE X1 P1 X2 P2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(8)?;
        let name = card.text(2).to_ascii_uppercase();
        let (plain, is_element) =
            name.strip_suffix('E').map_or((name.as_str(), false), |plain| (plain, true));
        let component = (1..).zip(TYPES).find(|(_, known)| *known == plain).map(|(component, _)| component);
        let component = component.ok_or_else(|| card.wrong(2, "TYPE", "FX to MZ or FXE to MZE"))?;
        let (is_length, is_projected) = match card.text(3).to_ascii_uppercase().as_str() {
            "LE" => (true, false),
            "FR" => (false, false),
            "LEPR" => (true, true),
            "FRPR" => (false, true),
            _ => return Err(card.wrong(3, "SCALE", "LE, FR, LEPR or FRPR")),
        };
        let (from, first) = (card.real(4, "X1")?, card.real(5, "P1")?);
        let to = card.real_or(6, "X2", from)?;
        if from < 0.0 || to < from || (!is_length && to > 1.0) {
            let message =
                format!("PLOAD1 runs from {from} to {to}, not from end A towards end B of its element");
            return Err(card.error(4, message));
        }
        if is_projected && component > 3 && !is_element {
            let message = "PLOAD1: what is projected is a force along basic axes";
            return Err(card.error(3, message).with_help("write SCALE as LE or FR"));
        }
        Ok(vec![Self {
            set: card.id(0, "SID")?,
            element: card.id(1, "EID")?,
            component,
            is_element,
            is_length,
            is_projected: is_projected && !is_element,
            places: [from, to],
            values: [first, if to > from { card.real_or(7, "P2", first)? } else { first }],
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let plain = TYPES[usize::from(self.component.clamp(1, 6)) - 1];
        let name = format!("{plain}{}", if self.is_element { "E" } else { "" });
        let scale = match (self.is_length, self.is_projected) {
            (true, false) => "LE",
            (false, false) => "FR",
            (true, true) => "LEPR",
            (false, true) => "FRPR",
        };
        let card = card.ints([self.set, self.element]).text(name).text(scale);
        card.real(self.places[0]).real(self.values[0]).real(self.places[1]).real(self.values[1])
    }

    // Sets keep their numbers.
    raises!(cards: element);

    // An image has no case control that selects loads.
    no_image!();
}
