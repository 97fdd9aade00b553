//! Bars and beams: CBAR and CBEAM.

use super::prelude::*;
use nalgebra::Vector3;

/// A bar or beam element (CBAR, CBEAM).
#[derive(Debug, Clone, PartialEq)]
pub struct BeamElement {
    /// Identification number.
    pub id: u32,
    /// Property (PBAR or PBEAM).
    pub property: u32,
    /// End grids A and B.
    pub grids: [u32; 2],
    /// Orientation: a vector in end A's displacement system unless `offt` says otherwise, or a grid.
    pub orientation: Orientation,
    /// Pin flags at ends A and B, digits 1 to 6.
    pub pins: [Vec<u8>; 2],
    /// Offset vectors from grid to element end, in the grids' displacement systems unless `offt` says otherwise.
    pub offsets: [Vector3<f64>; 2],
    /// What axes orientation and offset vectors are given in.
    pub offt: Offt,
    /// True for CBEAM, false for CBAR.
    pub is_beam: bool,
    /// Where the card stands.
    pub span: Span,
}

/// OFFT: in what axes the vectors of a bar or beam are given; by default all in displacement systems (GGG).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Offt {
    /// The orientation vector is in the basic system (B).
    pub is_basic: bool,
    /// The offset vector at each end is in element axes, x from grid A to grid B (O).
    pub is_element: [bool; 2],
}

impl Offt {
    /// Three letters, or the 1 (vector) and 2 (grid) of old decks, which say nothing that the fields before do not.
    fn read(card: &Card) -> Result<Self, InputError> {
        let text = card.text(7).to_ascii_uppercase();
        if matches!(text.as_str(), "" | "0" | "1" | "2") {
            return Ok(Self::default());
        }
        match text.as_bytes() {
            [vector @ (b'G' | b'B'), a @ (b'G' | b'O'), b @ (b'G' | b'O')] => {
                Ok(Self { is_basic: *vector == b'B', is_element: [*a == b'O', *b == b'O'] })
            }
            _ => Err(card.wrong(7, "OFFT", "G or B and twice G or O, such as GGG or BOO")),
        }
    }

    /// Its letters; empty for the default.
    fn write(self) -> String {
        if self == Self::default() {
            return String::new();
        }
        let letter = |is_element: bool| if is_element { 'O' } else { 'G' };
        let vector = if self.is_basic { 'B' } else { 'G' };
        [vector, letter(self.is_element[0]), letter(self.is_element[1])].iter().collect()
    }
}

/// The vector that, with the element axis, spans plane 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Orientation {
    /// X1, X2, X3.
    Vector(Vector3<f64>),
    /// G0.
    Grid(u32),
}

impl Ids for Orientation {
    fn each(&mut self, change: &mut dyn FnMut(&mut u32)) {
        if let Self::Grid(grid) = self {
            change(grid);
        }
    }
}

impl Orientation {
    /// Its image about y = 0.
    pub(super) fn mirrored(self) -> Self {
        match self {
            Self::Vector(vector) => Self::Vector(flipped(vector)),
            grid @ Self::Grid(_) => grid,
        }
    }

    /// Its three fields.
    pub(super) fn write(&self, card: Fields) -> Fields {
        match self {
            Self::Vector(vector) => card.reals(vector),
            Self::Grid(grid) => card.int(*grid).blanks(2),
        }
    }
}

impl DeckCard for BeamElement {
    numbered!();
    variant!(|card| usize::from(card.is_beam));

    /// CBAR, CBEAM: EID PID GA GB X1 X2 X3 OFFT / PA PB W1A W2A W3A W1B W2B W3B (/ SA SB).
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let is_beam = card.name == "CBEAM";
        let id = card.id(0, "EID")?;
        for (index, name) in [(16, "SA"), (17, "SB")] {
            if is_beam && card.count_or(index, name, 0)? != 0 {
                return Err(card.error(index, format!("warping ({name}) of {} is not read", card.name)));
            }
        }
        Ok(vec![BeamElement {
            id,
            property: if card.text(1).is_empty() { id } else { card.id(1, "PID")? },
            grids: [card.id(2, "GA")?, card.id(3, "GB")?],
            orientation: orientation(card)?,
            pins: [card.components(8, "PA")?, card.components(9, "PB")?],
            offsets: [card.vector(10, ["W1A", "W2A", "W3A"])?, card.vector(13, ["W1B", "W2B", "W3B"])?],
            offt: Offt::read(card)?,
            is_beam,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = self.orientation.write(card.ints([self.id, self.property]).ints(self.grids));
        let card = card.text(self.offt.write()).digits(&self.pins[0]).digits(&self.pins[1]);
        let [a, b] = &self.offsets;
        if self.offsets == [Vector3::zeros(); 2] { card } else { card.reals(a).reals(b) }
    }

    raises!(cards: id, property, grids, orientation);

    fn mirrored(self, _: &Mirror) -> Mirrored<Self> {
        let orientation = self.orientation.mirrored();
        // Element z is the cross product of axis and orientation vector: along it the sign changes.
        let image = |end: usize| {
            let offset = self.offsets[end];
            if self.offt.is_element[end] {
                Vector3::new(offset.x, offset.y, minus(offset.z))
            } else {
                flipped(offset)
            }
        };
        Ok(Some(Self { orientation, offsets: [image(0), image(1)], ..self }))
    }
}

fn orientation(card: &Card) -> Result<Orientation, InputError> {
    optional_orientation(card)?.ok_or_else(|| {
        card.empty(4, "X1", "an orientation vector or a grid")
            .with_help("give the vector on the element, or a default by BAROR (bars) or BEAMOR (beams)")
    })
}

/// Fields G0 or X1 X2 X3 of bars, beams and bushes; nothing if all are empty.
pub(crate) fn optional_orientation(card: &Card) -> Result<Option<Orientation>, InputError> {
    let text = card.text(4);
    if text.parse::<i64>().is_ok() && card.text(5).is_empty() && card.text(6).is_empty() {
        return Ok(Some(Orientation::Grid(card.id(4, "G0")?)));
    }
    if text.is_empty() && card.text(5).is_empty() && card.text(6).is_empty() {
        return Ok(None);
    }
    let vector: Vector3<f64> = card.vector(4, ["X1", "X2", "X3"])?;
    if vector == Vector3::zeros() {
        return Err(card.error(4, format!("the orientation vector of {} is zero", card.name)));
    }
    Ok(Some(Orientation::Vector(vector)))
}
