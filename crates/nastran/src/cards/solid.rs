//! Solids: CHEXA, CPENTA, CTETRA and PSOLID.

use super::prelude::*;

/// Edges of CHEXA in the order of the grids on them, as places of the corners at their ends.
const HEXA_EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 5], [2, 6], [3, 7], [4, 5], [5, 6], [6, 7], [7, 4]];
/// Edges of CPENTA.
const PENTA_EDGES: [[usize; 2]; 9] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 4], [2, 5], [3, 4], [4, 5], [5, 3]];
/// Edges of CTETRA.
const TETRA_EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

/// A solid element (CHEXA with eight corners, CPENTA with six, CTETRA with four).
#[derive(Debug, Clone, PartialEq)]
pub struct SolidElement {
    /// Identification number.
    pub id: u32,
    /// PSOLID.
    pub property: u32,
    /// Corner grids: eight, six or four.
    pub grids: Vec<u32>,
    /// Grids on the edges, in the order of [`Self::edges`]: empty, or one for each edge that may be missing.
    pub midsides: Vec<Option<u32>>,
    /// Where the card stands.
    pub span: Span,
}

impl SolidElement {
    /// The edges in the order of the grids on them: places in `grids` of the corners at their ends.
    pub fn edges(&self) -> &'static [[usize; 2]] {
        match self.grids.len() {
            4 => &TETRA_EDGES,
            6 => &PENTA_EDGES,
            _ => &HEXA_EDGES,
        }
    }
}

/// Grids on edges from field `from` on, for so many edges: nothing if there are none.
pub(super) fn midsides(card: &Card, from: usize, count: usize) -> Result<Vec<Option<u32>>, InputError> {
    let read = |at: usize| match card.text(from + at) {
        "0" => Ok(None),
        _ => card.optional_id(from + at, &format!("G{}", from - 1 + at)),
    };
    let all: Vec<Option<u32>> = (0..count).map(read).collect::<Result<_, _>>()?;
    Ok(if all.iter().all(Option::is_none) { Vec::new() } else { all })
}

/// Grids on edges of an element whose corners are listed in another `order`.
pub(super) fn reordered(midsides: &[Option<u32>], edges: &[[usize; 2]], order: &[usize]) -> Vec<Option<u32>> {
    let old = |[a, b]: &[usize; 2]| {
        let ends = [order[*a], order[*b]];
        edges.iter().position(|edge| *edge == ends || *edge == [ends[1], ends[0]])
    };
    let of_edge = |edge| old(edge).and_then(|at| midsides.get(at).copied().flatten());
    if midsides.is_empty() { Vec::new() } else { edges.iter().map(of_edge).collect() }
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

    /// CHEXA, CPENTA, CTETRA: EID PID, corners G1 G2 ..., then grids on the edges, each of which may be missing.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let names = ["G1", "G2", "G3", "G4", "G5", "G6", "G7", "G8"];
        let (corners, edges) = match card.name.as_str() {
            "CHEXA" => (8, 12),
            "CPENTA" => (6, 9),
            _ => (4, 6),
        };
        let grids = card.corners(2, &names[..corners])?;
        card.ends_after(2 + corners + edges)?;
        let midsides = midsides(card, 2 + corners, edges)?;
        let id = card.id(0, "EID")?;
        let property = card.id_or(1, "PID", id)?;
        Ok(vec![SolidElement { id, property, grids, midsides, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.ints([self.id, self.property]).ints(self.grids.iter().copied());
        self.midsides.iter().fold(card, |card, grid| card.optional(*grid))
    }

    raises!(cards: id, property, grids, midsides);

    /// Corners are listed the other way round, so that the solid keeps its sense.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        let order: &[usize] = match self.grids.len() {
            8 => &[1, 0, 3, 2, 5, 4, 7, 6],
            6 => &[1, 0, 2, 4, 3, 5],
            _ => &[1, 0, 2, 3],
        };
        self.midsides = reordered(&self.midsides, self.edges(), order);
        self.grids = order.iter().filter_map(|at| self.grids.get(*at).copied()).collect();
        Ok(Some(self))
    }
}

/// IN of PSOLID: the network of integration points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SolidPoints {
    /// Blank, 0 or BUBBLE: Nastran's default, of CHEXA and CPENTA without grids on edges two points each way and bubble functions, of
    /// those with grids on edges three points each way.
    #[default]
    Usual,
    /// 1 or ONE: one point.
    One,
    /// 2 or TWO: two points each way, without bubble functions.
    Two,
    /// 3 or THREE: three points each way, without bubble functions.
    Three,
}

/// ISOP of PSOLID: how shear strains are integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SolidShear {
    /// Blank, 0 or REDUCED: reduced shear, Nastran's default.
    #[default]
    Reduced,
    /// 1 or FULL: the standard isoparametric element.
    Full,
}

/// What stands in IN, in its two spellings.
const POINTS: [(SolidPoints, [&str; 2]); 4] = [
    (SolidPoints::Usual, ["0", "BUBBLE"]),
    (SolidPoints::One, ["1", "ONE"]),
    (SolidPoints::Two, ["2", "TWO"]),
    (SolidPoints::Three, ["3", "THREE"]),
];
/// What stands in ISOP.
const SHEAR: [(SolidShear, [&str; 2]); 2] =
    [(SolidShear::Reduced, ["0", "REDUCED"]), (SolidShear::Full, ["1", "FULL"])];

/// A choice that has a number and a word; an empty field is the default.
fn choice<T: Copy + Default>(
    card: &Card,
    index: usize,
    what: &str,
    choices: &[(T, [&str; 2])],
) -> Result<T, InputError> {
    let text = card.text(index);
    if text.is_empty() {
        return Ok(T::default());
    }
    let is_said = |words: &[&str; 2]| words.iter().any(|word| text.eq_ignore_ascii_case(word));
    choices.iter().find(|(_, words)| is_said(words)).map(|(chosen, _)| *chosen).ok_or_else(|| {
        let list: Vec<String> =
            choices.iter().map(|(_, [digit, word])| format!("{digit} ({word})")).collect();
        card.wrong(index, what, &format!("empty or one of {}", list.join(", ")))
    })
}

/// A choice as it is written: its number, or nothing for the default.
fn number_of<T: PartialEq + Default>(choice: &T, choices: &[(T, [&'static str; 2])]) -> &'static str {
    let chosen = choices.iter().find(|(one, _)| one == choice && *choice != T::default());
    chosen.map_or("", |(_, [digit, _])| digit)
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
    /// IN: the network of integration points.
    pub points: SolidPoints,
    /// ISOP: reduced shear, or the standard isoparametric element.
    pub shear: SolidShear,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Psolid {
    numbered!();
    /// PSOLID: PID MID CORDM IN STRESS ISOP FCTN; STRESS is skipped, it says where stresses are printed.
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
            points: choice(card, 3, "IN", &POINTS)?,
            shear: choice(card, 5, "ISOP", &SHEAR)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.ints([self.id, self.material])
            .text(self.cordm.to_string())
            .text(number_of(&self.points, &POINTS))
            .blanks(1)
            .text(number_of(&self.shear, &SHEAR))
    }

    raises!(cards: id, material; systems: cordm);

    own_image!();
}
