//! Grids, coordinate systems, elements, masses and constraints: from fields to the structs of [`crate::cards`].

use crate::card::Card;
use crate::cards::{
    BeamElement, Conm2, Coord, CoordDefinition, CoordKind, Grid, Orientation, Rbe2, Set1, Spc1,
};
use crate::real;
use crate::source::InputError;

/// GRID: ID CP X1 X2 X3 CD PS.
pub(crate) fn grid(card: &Card) -> Result<Grid, InputError> {
    Ok(Grid {
        id: card.id(0, "ID")?,
        cp: card.count_or(1, "CP", 0)?,
        xyz: card.vector(2, ["X1", "X2", "X3"])?,
        cd: card.count_or(5, "CD", 0)?,
        ps: card.components(6, "PS")?,
        span: card.span.clone(),
    })
}

/// CORD1R, CORD1C, CORD1S: CID G1 G2 G3, twice on one card.
pub(crate) fn cord1(card: &Card) -> Result<Vec<Coord>, InputError> {
    let one = |from: usize| -> Result<Coord, InputError> {
        let grids = [card.id(from + 1, "G1")?, card.id(from + 2, "G2")?, card.id(from + 3, "G3")?];
        Ok(Coord {
            id: card.id(from, "CID")?,
            kind: kind(card),
            definition: CoordDefinition::Grids(grids),
            span: card.span.clone(),
        })
    };
    let mut systems = vec![one(0)?];
    if card.len() > 4 {
        systems.push(one(4)?);
    }
    Ok(systems)
}

/// CORD2R, CORD2C, CORD2S: CID RID A1 A2 A3 B1 B2 B3 / C1 C2 C3.
pub(crate) fn cord2(card: &Card) -> Result<Coord, InputError> {
    let definition = CoordDefinition::Points {
        rid: card.count_or(1, "RID", 0)?,
        a: card.vector(2, ["A1", "A2", "A3"])?,
        b: card.vector(5, ["B1", "B2", "B3"])?,
        c: card.vector(8, ["C1", "C2", "C3"])?,
    };
    Ok(Coord { id: card.id(0, "CID")?, kind: kind(card), definition, span: card.span.clone() })
}

fn kind(card: &Card) -> CoordKind {
    match card.name.chars().last() {
        Some('C') => CoordKind::Cylindrical,
        Some('S') => CoordKind::Spherical,
        _ => CoordKind::Rectangular,
    }
}

/// CBAR, CBEAM: EID PID GA GB X1 X2 X3 OFFT / PA PB W1A W2A W3A W1B W2B W3B (/ SA SB).
pub(crate) fn beam_element(card: &Card) -> Result<BeamElement, InputError> {
    let is_beam = card.name == "CBEAM";
    let id = card.id(0, "EID")?;
    if !card.text(7).is_empty() && !card.text(7).eq_ignore_ascii_case("GGG") {
        return Err(card.wrong(7, "OFFT", "GGG, the only kind of offset vectors that is read"));
    }
    for (index, name) in [(16, "SA"), (17, "SB")] {
        if is_beam && card.count_or(index, name, 0)? != 0 {
            return Err(card.error(index, format!("warping ({name}) of {} is not read", card.name)));
        }
    }
    Ok(BeamElement {
        id,
        property: if card.text(1).is_empty() { id } else { card.id(1, "PID")? },
        grids: [card.id(2, "GA")?, card.id(3, "GB")?],
        orientation: orientation(card)?,
        pins: [card.components(8, "PA")?, card.components(9, "PB")?],
        offsets: [card.vector(10, ["W1A", "W2A", "W3A"])?, card.vector(13, ["W1B", "W2B", "W3B"])?],
        is_beam,
        span: card.span.clone(),
    })
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
    let vector = card.vector(4, ["X1", "X2", "X3"])?;
    if vector == [0.0; 3] {
        return Err(card.error(4, format!("the orientation vector of {} is zero", card.name)));
    }
    Ok(Some(Orientation::Vector(vector)))
}

/// CONM2: EID G CID M X1 X2 X3 blank / I11 I21 I22 I31 I32 I33.
pub(crate) fn conm2(card: &Card) -> Result<Conm2, InputError> {
    let cid = card.integer_or(2, "CID", 0)?;
    if cid < -1 {
        return Err(card.wrong(2, "CID", "-1, 0 or a coordinate system"));
    }
    let mut inertia = [0.0; 6];
    for (index, name) in ["I11", "I21", "I22", "I31", "I32", "I33"].into_iter().enumerate() {
        inertia[index] = card.real_or(8 + index, name, 0.0)?;
    }
    Ok(Conm2 {
        id: card.id(0, "EID")?,
        grid: card.id(1, "G")?,
        cid,
        mass: card.real(3, "M")?,
        offset: card.vector(4, ["X1", "X2", "X3"])?,
        inertia,
        span: card.span.clone(),
    })
}

/// RBE2: EID GN CM GM1 GM2 ...; a thermal expansion coefficient at the end is skipped.
pub(crate) fn rbe2(card: &Card) -> Result<Rbe2, InputError> {
    let components = card.components(2, "CM")?;
    if components.is_empty() {
        return Err(card.empty(2, "CM", "the dependent components, such as 123456"));
    }
    let has_alpha = card.len() > 4 && real::parse(card.text(card.len() - 1)).is_some();
    let end = card.len() - usize::from(has_alpha);
    Ok(Rbe2 {
        id: card.id(0, "EID")?,
        independent: card.id(1, "GN")?,
        components,
        dependent: card.id_list_until(3, end, "GM")?,
        span: card.span.clone(),
    })
}

/// SPC1: SID C G1 G2 ... or G1 THRU G2.
pub(crate) fn spc1(card: &Card) -> Result<Spc1, InputError> {
    let components = card.components(1, "C")?;
    if components.is_empty() {
        return Err(card.empty(1, "C", "the clamped components, such as 123456"));
    }
    let grids = card.id_list(2, "G")?;
    Ok(Spc1 { set: card.id(0, "SID")?, components, grids, span: card.span.clone() })
}

/// SET1: SID ID1 ID2 ... or ID1 THRU ID2.
pub(crate) fn set1(card: &Card) -> Result<Set1, InputError> {
    Ok(Set1 { id: card.id(0, "SID")?, ids: card.id_list(1, "ID")?, span: card.span.clone() })
}
