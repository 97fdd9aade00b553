//! Pressures on faces: PLOAD between grids, PLOAD2 on shells, PLOAD4 on shells and faces of solids.

use super::prelude::*;
use nalgebra::Vector3;

/// What a pressure acts on.
#[derive(Debug, Clone, PartialEq)]
pub enum Pressed {
    /// The face between three or four grids (PLOAD).
    Grids(Vec<u32>),
    /// Shells (PLOAD2, PLOAD4).
    Elements(Vec<u32>),
    /// The face of a solid that holds a corner and the one opposite to it, or for a triangle of a CPENTA only the corner,
    /// or for a CTETRA the corner that the face does not hold (PLOAD4).
    Face {
        /// The solid.
        element: u32,
        /// G1.
        corner: u32,
        /// G3 or G4.
        other: Option<u32>,
    },
}

/// A pressure normal to faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Pressure {
    /// Load set.
    pub set: u32,
    /// What it acts on.
    pub on: Pressed,
    /// At the corners; the last is zero for three.
    pub pressure: [f64; 4],
    /// Coordinate system and direction of a load per area that is not along the normal (PLOAD4 N1 N2 N3).
    pub direction: Option<(u32, Vector3<f64>)>,
    /// The elements are those of a range (THRU), in which numbers may be missing.
    pub is_range: bool,
    /// Name of the card.
    pub form: usize,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Pressure {
    keyed!(u32, set);
    variant!(|card| card.form);
    /// PLOAD: SID P G1 G2 G3 G4. PLOAD2: SID P EID1 EID2 ... or THRU. PLOAD4: SID EID P1 P2 P3 P4 G1 G3, or THRU EID2, / CID N1 N2 N3.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let set = card.id(0, "SID")?;
        let span = card.span.clone();
        if card.name == "PLOAD4" {
            return four(card, set);
        }
        let pressure = [card.real(1, "P")?; 4];
        let (on, form) = if card.name == "PLOAD" {
            card.ends_after(6)?;
            let names = ["G1", "G2", "G3", "G4"];
            let count = if card.text(5).is_empty() { 3 } else { 4 };
            (Pressed::Grids(card.corners(2, &names[..count])?), 0)
        } else {
            (Pressed::Elements(card.id_list(2, "EID")?), 1)
        };
        let is_range = form == 1 && card.text(3).eq_ignore_ascii_case("THRU");
        Ok(vec![Self { set, on, pressure, direction: None, is_range, form, span }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.set);
        let directed = |card: Fields| match &self.direction {
            Some((system, vector)) => card.next_line().int(*system).reals(vector),
            None => card,
        };
        match (&self.on, self.form) {
            (Pressed::Face { element, corner, other }, _) => {
                directed(card.int(*element).reals(&self.pressure).int(*corner).optional(*other))
            }
            (Pressed::Elements(list), 2) => {
                directed(card.ints(list.iter().copied().take(1)).reals(&self.pressure))
            }
            (Pressed::Grids(list) | Pressed::Elements(list), _) => {
                card.real(self.pressure[0]).ints(list.iter().copied())
            }
        }
    }

    // Sets keep their numbers.
    fn raise(&mut self, by: Step) {
        if let Some((system, _)) = &mut self.direction {
            by.systems(system);
        }
        match &mut self.on {
            Pressed::Grids(list) | Pressed::Elements(list) => by.cards(list),
            Pressed::Face { element, corner, other } => {
                by.cards(element);
                by.cards(corner);
                by.cards(other);
            }
        }
    }

    // An image has no case control that selects loads.
    no_image!();
}

/// PLOAD4, an item an element.
fn four(card: &Card, set: u32) -> Result<Vec<Pressure>, InputError> {
    // Loads along lines act on edges: SORL LINE, LDIR.
    card.word(12, "SORL", &["SURF"])?;
    card.word(13, "LDIR", &["NORM"])?;
    card.ends_after(14)?;
    let vector: Vector3<f64> = card.vector(9, ["N1", "N2", "N3"])?;
    let system = card.count_or(8, "CID", 0)?;
    let direction = (vector != Vector3::zeros()).then_some((system, vector));
    let first = card.real(2, "P1")?;
    let mut pressure = [first; 4];
    for (at, name) in [(1, "P2"), (2, "P3"), (3, "P4")] {
        pressure[at] = card.real_or(2 + at, name, first)?;
    }
    let element = card.id(1, "EID")?;
    let (form, span) = (2, card.span.clone());
    if card.text(6).eq_ignore_ascii_case("THRU") {
        let last = card.id(7, "EID2")?;
        let one = |element| {
            let on = Pressed::Elements(vec![element]);
            Pressure { set, on, pressure, direction, is_range: true, form, span: span.clone() }
        };
        return if last < element || last - element > 1_000_000 {
            Err(card.wrong(7, "EID2", "an element number above EID"))
        } else {
            Ok((element..=last).map(one).collect())
        };
    }
    let on = if card.text(6).is_empty() {
        Pressed::Elements(vec![element])
    } else {
        let other = if card.text(7).is_empty() { None } else { Some(card.id(7, "G3")?) };
        Pressed::Face { element, corner: card.id(6, "G1")?, other }
    };
    Ok(vec![Pressure { set, on, pressure, direction, is_range: false, form, span }])
}
