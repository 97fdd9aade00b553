//! Splines and parameters: SPLINE1, SPLINE2, SPLINE4, SPLINE5 and PARAM, from fields to the structs of [`crate::fe_cards`].

use crate::card::Card;
use crate::fe_cards::{SplineCard, SplineKind};
use crate::real;
use crate::source::InputError;

/// SPLINE1: EID CAERO BOX1 BOX2 SETG DZ METH USAGE / NELEM MELEM,
/// SPLINE2: EID CAERO ID1 ID2 SETG DZ DTOR CID / DTHX DTHY blank USAGE,
/// SPLINE4: EID CAERO AELIST blank SETG DZ METH USAGE / NELEM MELEM FTYPE RCORE, and
/// SPLINE5: EID CAERO AELIST blank SETG DZ DTOR CID / DTHX DTHY blank USAGE METH blank FTYPE RCORE.
///
/// The number of elements of a finite plate is skipped; smoothing (DZ) and other
/// methods than the infinite plate and beam are refused.
pub(crate) fn spline(card: &Card) -> Result<SplineCard, InputError> {
    card.unset(5, "DZ")?;
    let by_list = matches!(card.name.as_str(), "SPLINE4" | "SPLINE5");
    let kind = if matches!(card.name.as_str(), "SPLINE1" | "SPLINE4") {
        card.ends_after(if by_list { 12 } else { 10 })?;
        card.word(6, "METH", &["IPS"])?;
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
    Ok(SplineCard { id, panel, boxes, list, set, kind, span: card.span.clone() })
}

/// Flexibility of a rotation: zero or more, or -1 for none.
fn attachment(card: &Card, index: usize, name: &str) -> Result<f64, InputError> {
    let value = card.real_or(index, name, 0.0)?;
    if value >= 0.0 || (value + 1.0).abs() < 1e-9 {
        return Ok(value);
    }
    Err(card.wrong(index, name, "-1.0 (not attached) or a flexibility of zero or more"))
}

/// PARAM: name and value; nothing if the value is no number, or complex.
pub(crate) fn parameter(card: &Card) -> Result<Option<(String, f64)>, InputError> {
    let name = card.name_at(0, "N")?;
    let text = card.text(1);
    if text.is_empty() {
        return Err(card.empty(1, "V1", "a value"));
    }
    let whole = text.parse::<i32>().ok().map(f64::from);
    let Some(value) = whole.or_else(|| real::parse(text)) else {
        if text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
            return Err(card.wrong(1, "V1", "a number or a word"));
        }
        return Ok(None);
    };
    if name == "WTMASS" && (value <= 0.0 || whole.is_some()) {
        return Err(card.wrong(1, "V1", "a real number above zero, as WTMASS must be"));
    }
    Ok(card.text(2).is_empty().then_some((name, value)))
}
