//! Panels, control surfaces and monitoring stations: from fields to the structs of [`crate::cards`].

use crate::card::Card;
use crate::cards::{Aefact, Aelist, Aesurf, Caero1, Divisions, MonitorPoint};
use crate::source::InputError;

/// CAERO1: EID PID CP NSPAN NCHORD LSPAN LCHORD IGID / X1 Y1 Z1 X12 X4 Y4 Z4 X43.
pub(crate) fn caero1(card: &Card) -> Result<Caero1, InputError> {
    let chord = |index: usize, name: &str| -> Result<f64, InputError> {
        let value = card.real_or(index, name, 0.0)?;
        if value < 0.0 { Err(card.wrong(index, name, "a chord, zero or more")) } else { Ok(value) }
    };
    Ok(Caero1 {
        id: card.id(0, "EID")?,
        property: card.id(1, "PID")?,
        cp: card.count_or(2, "CP", 0)?,
        span_divisions: divisions(card, (3, "NSPAN"), (5, "LSPAN"))?,
        chord_divisions: divisions(card, (4, "NCHORD"), (6, "LCHORD"))?,
        group: card.count_or(7, "IGID", 1)?,
        point_1: card.vector(8, ["X1", "Y1", "Z1"])?,
        chord_1: chord(11, "X12")?,
        point_4: card.vector(12, ["X4", "Y4", "Z4"])?,
        chord_4: chord(15, "X43")?,
        span: card.span.clone(),
    })
}

fn divisions(card: &Card, count: (usize, &str), list: (usize, &str)) -> Result<Divisions, InputError> {
    match (card.count_or(count.0, count.1, 0)?, card.count_or(list.0, list.1, 0)?) {
        (0, 0) => Err(card.empty(count.0, count.1, &format!("a number, here or an AEFACT in {}", list.1))),
        (0, aefact) => Ok(Divisions::Aefact(aefact)),
        (number, 0) => Ok(Divisions::Equal(number)),
        _ => Err(card.error(list.0, format!("CAERO1 has both {} and {}; give one of them", count.1, list.1))),
    }
}

/// AEFACT: SID D1 D2 ...
pub(crate) fn aefact(card: &Card) -> Result<Aefact, InputError> {
    let values = (1..card.len().max(2)).map(|index| card.real(index, "D")).collect::<Result<_, _>>()?;
    Ok(Aefact { id: card.id(0, "SID")?, values, span: card.span.clone() })
}

/// AESURF: ID LABEL CID1 ALID1 CID2 ALID2 EFF; limits and reference values are skipped.
pub(crate) fn aesurf(card: &Card) -> Result<Aesurf, InputError> {
    let mut parts = vec![(card.count_or(2, "CID1", 0)?, card.id(3, "ALID1")?)];
    if !card.text(5).is_empty() {
        parts.push((card.count_or(4, "CID2", 0)?, card.id(5, "ALID2")?));
    }
    Ok(Aesurf {
        id: card.id(0, "ID")?,
        label: card.name_at(1, "LABEL")?,
        parts,
        effectiveness: card.real_or(6, "EFF", 1.0)?,
        span: card.span.clone(),
    })
}

/// AELIST: SID E1 E2 ... or E1 THRU E2.
pub(crate) fn aelist(card: &Card) -> Result<Aelist, InputError> {
    Ok(Aelist { id: card.id(0, "SID")?, boxes: card.id_list(1, "E")?, span: card.span.clone() })
}

/// MONPNT1: NAME LABEL / AXES COMP CP X Y Z CD, and
/// MONPNT3: NAME LABEL / AXES GRIDSET ELEMSET CP X Y Z XFLAG / CD; ELEMSET and XFLAG are skipped.
pub(crate) fn monitor(card: &Card) -> Result<MonitorPoint, InputError> {
    let is_structural = card.name == "MONPNT3";
    let cp_at = if is_structural { 11 } else { 10 };
    let cd_at = if is_structural { 16 } else { 14 };
    let axes = card.components(8, "AXES")?;
    if axes.is_empty() {
        return Err(card.empty(8, "AXES", "a combination of the digits 1 to 6"));
    }
    let cp = card.count_or(cp_at, "CP", 0)?;
    Ok(MonitorPoint {
        name: card.name_at(0, "NAME")?,
        label: card.long_text(1..8),
        axes,
        set: card.name_at(9, if is_structural { "GRIDSET" } else { "COMP" })?,
        cp,
        xyz: card.vector(cp_at + 1, ["X", "Y", "Z"])?,
        cd: card.count_or(cd_at, "CD", cp)?,
        is_structural,
        span: card.span.clone(),
    })
}
