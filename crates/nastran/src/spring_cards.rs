//! Springs, scalar masses and the 6 x 6 mass: CBUSH, PBUSH, CELAS1, CELAS2, PELAS, CMASS1, CMASS2, PMASS and CONM1,
//! from fields to the structs of [`crate::fe_cards`].

use crate::card::Card;
use crate::fe_cards::{BushAxes, Cbush, Conm1, Motion, Pbush, ScalarElement, ScalarProperty, ScalarValue};
use crate::field::FIELDS_PER_LINE;
use crate::source::InputError;
use crate::structure_cards::optional_orientation;

/// CBUSH: EID PID GA GB GO/X1 X2 X3 CID / S OCID S1 S2 S3.
pub(crate) fn cbush(card: &Card) -> Result<Cbush, InputError> {
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
    Ok(Cbush {
        id,
        property: card.id_or(1, "PID", id)?,
        grids,
        axes,
        location,
        offset,
        span: card.span.clone(),
    })
}

/// PBUSH: PID, then rows of a word and its values: K K1 ... K6 is read; B, GE and RCV are skipped, M is refused.
pub(crate) fn pbush(card: &Card) -> Result<Pbush, InputError> {
    let mut stiffness = [0.0; 6];
    for row in (0..card.len()).step_by(FIELDS_PER_LINE) {
        match card.text(row + 1).to_uppercase().as_str() {
            "K" => {
                let names = ["K1", "K2", "K3", "K4", "K5", "K6"];
                for (index, name) in names.into_iter().enumerate() {
                    stiffness[index] = card.not_negative(row + 2 + index, name, 0.0)?;
                }
            }
            "M" => card.unset(row + 2, "M")?,
            "B" | "GE" | "RCV" | "" => {}
            _ => return Err(card.wrong(row + 1, "FLAG", "K, B, GE or RCV, the only rows that are known")),
        }
    }
    Ok(Pbush { id: card.id(0, "PID")?, stiffness, span: card.span.clone() })
}

/// CELAS1, CMASS1: EID PID G1 C1 G2 C2; CELAS2: EID K G1 C1 G2 C2 GE S; CMASS2: EID M G1 C1 G2 C2.
///
/// Damping and stress coefficients are skipped; scalar points are refused.
pub(crate) fn scalar_element(card: &Card) -> Result<ScalarElement, InputError> {
    card.ends_after(if card.name == "CELAS2" { 8 } else { 6 })?;
    let id = card.id(0, "EID")?;
    let value = match card.name.as_str() {
        "CELAS2" => ScalarValue::Given(card.real(1, "K")?),
        "CMASS2" => ScalarValue::Given(card.real(1, "M")?),
        _ => ScalarValue::Property(card.id_or(1, "PID", id)?),
    };
    let ends = [end(card, 2, "G1", "C1")?, end(card, 4, "G2", "C2")?];
    if ends[0] == ends[1] {
        let message = match ends[0] {
            None => format!("{} {id} has no grid at either end", card.name),
            Some((grid, _)) => format!("both ends of {} {id} are the same motion of grid {grid}", card.name),
        };
        return Err(card.error(2, message));
    }
    Ok(ScalarElement { id, value, ends, span: card.span.clone() })
}

/// A motion, or the ground where the grid is empty or zero.
fn end(card: &Card, index: usize, grid: &str, digit: &str) -> Result<Option<Motion>, InputError> {
    if matches!(card.text(index), "" | "0") {
        card.unset(index + 1, digit)?;
        return Ok(None);
    }
    card.motion(index, grid, digit).map(Some)
}

/// PELAS: PID K GE S, twice on one card; PMASS: PID M, four times on one card.
pub(crate) fn scalar_properties(card: &Card) -> Result<Vec<ScalarProperty>, InputError> {
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

/// CONM1: EID G CID M11 M21 M22 M31 M32 / M33 M41 ... M66, the lower triangle row by row.
pub(crate) fn conm1(card: &Card) -> Result<Conm1, InputError> {
    card.ends_after(24)?;
    let mut mass = [[0.0; 6]; 6];
    let lower = (0..6).flat_map(|row| (0..=row).map(move |column| (row, column)));
    for (index, (row, column)) in (3..).zip(lower) {
        let value = card.real_or(index, &format!("M{}{}", row + 1, column + 1), 0.0)?;
        (mass[row][column], mass[column][row]) = (value, value);
    }
    Ok(Conm1 {
        id: card.id(0, "EID")?,
        grid: card.id(1, "G")?,
        cid: card.count_or(2, "CID", 0)?,
        mass,
        span: card.span.clone(),
    })
}
