//! Shells and their properties: CQUAD4, CTRIA3, PSHELL, PCOMP and PCOMPG, from fields to the structs of
//! [`crate::fe_cards`], with the defaults of Nastran's Quick Reference Guide.

use crate::card::Card;
use crate::fe_cards::{MaterialDirection, Pcomp, Ply, Pshell, ShellElement};
use crate::field::FIELDS_PER_LINE;
use crate::source::{InputError, Span};

/// Nastran's default of TS/T; the exact 5/6 is not what it computes with.
const SHEAR_RATIO: f64 = 0.833_333;

/// A corner thickness that must turn out to be the property's.
#[derive(Debug)]
pub(crate) struct CornerThickness {
    /// The shell element.
    pub(crate) element: u32,
    /// The thickness, or its ratio to the property's.
    pub(crate) value: f64,
    /// TFLAG = 1.
    pub(crate) is_ratio: bool,
    /// Where it stands.
    pub(crate) span: Span,
}

/// CQUAD4: EID PID G1 G2 G3 G4 THETA/MCID ZOFFS / blank TFLAG T1 T2 T3 T4, and
/// CTRIA3: EID PID G1 G2 G3 THETA/MCID ZOFFS blank / blank TFLAG T1 T2 T3.
pub(crate) fn shell(card: &Card) -> Result<(ShellElement, Vec<CornerThickness>), InputError> {
    let corners: &[&str] =
        if card.name == "CQUAD4" { &["G1", "G2", "G3", "G4"] } else { &["G1", "G2", "G3"] };
    let id = card.id(0, "EID")?;
    let after = 2 + corners.len();
    let first_thickness = FIELDS_PER_LINE + 2;
    for index in (after + 2)..=FIELDS_PER_LINE {
        if !card.text(index).is_empty() {
            return Err(
                card.error(index, format!("a field of {} that is always empty has a value", card.name))
            );
        }
    }
    card.ends_after(first_thickness + corners.len())?;
    let flag = card.count_or(FIELDS_PER_LINE + 1, "TFLAG", 0)?;
    if flag > 1 {
        return Err(card.wrong(FIELDS_PER_LINE + 1, "TFLAG", "0 or 1"));
    }
    let mut thicknesses = Vec::new();
    for (index, name) in (first_thickness..).zip(["T1", "T2", "T3", "T4"]).take(corners.len()) {
        if let Some(value) = card.optional_real(index, name)? {
            let span = card.span_of(index).clone();
            thicknesses.push(CornerThickness { element: id, value, is_ratio: flag == 1, span });
        }
    }
    let element = ShellElement {
        id,
        property: card.id_or(1, "PID", id)?,
        grids: card.corners(2, corners)?,
        direction: direction(card, after)?,
        offset: card.real_or(after + 1, "ZOFFS", 0.0)?,
        span: card.span.clone(),
    };
    Ok((element, thicknesses))
}

/// A whole number is a coordinate system, a real an angle.
fn direction(card: &Card, index: usize) -> Result<MaterialDirection, InputError> {
    let text = card.text(index);
    if text.is_empty() {
        return Ok(MaterialDirection::AngleDeg(0.0));
    }
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return Ok(MaterialDirection::System(card.count_or(index, "MCID", 0)?));
    }
    card.real(index, "THETA").map(MaterialDirection::AngleDeg).map_err(|_| {
        card.wrong(index, "THETA", "an angle with a decimal point or the whole number of a coordinate system")
    })
}

/// PSHELL: PID MID1 T MID2 12I/T^3 MID3 TS/T NSM / Z1 Z2 MID4; stress distances are skipped.
pub(crate) fn pshell(card: &Card) -> Result<Pshell, InputError> {
    card.ends_after(11)?;
    if card.text(3) == "-1" {
        return Err(card.error(3, "plane strain (MID2 = -1) of PSHELL is not read"));
    }
    let property = Pshell {
        id: card.id(0, "PID")?,
        membrane: card.optional_id(1, "MID1")?,
        thickness: card.positive(2, "T")?,
        bending: card.optional_id(3, "MID2")?,
        bending_ratio: card.not_negative(4, "12I/T**3", 1.0)?,
        shear: card.optional_id(5, "MID3")?,
        shear_ratio: card.not_negative(6, "TS/T", SHEAR_RATIO)?,
        nsm: card.real_or(7, "NSM", 0.0)?,
        coupling: card.optional_id(10, "MID4")?,
        span: card.span.clone(),
    };
    if property.membrane.is_none() && property.bending.is_none() {
        return Err(card.empty(1, "MID1", "a material here or in MID2"));
    }
    if property.shear.is_some() && property.bending.is_none() {
        return Err(card.error(5, "PSHELL has a shear material (MID3) but no bending material (MID2)"));
    }
    if property.coupling.is_some() && (property.membrane.is_none() || property.bending.is_none()) {
        return Err(card.error(10, "PSHELL has a coupling material (MID4) without both MID1 and MID2"));
    }
    Ok(property)
}

/// PCOMP: PID Z0 NSM SB FT TREF GE LAM / MID1 T1 THETA1 SOUT1 MID2 T2 THETA2 SOUT2 / ..., and
/// PCOMPG: the same first line, then a line GPLYID MID T THETA SOUT for every ply.
///
/// Strength, temperature and damping (SB, FT, TREF, GE) are skipped. Four empty fields are no ply.
pub(crate) fn pcomp(card: &Card) -> Result<Pcomp, InputError> {
    let is_global = card.name == "PCOMPG";
    card.word(7, "LAM", &["SYM"])?;
    let (stride, first) = if is_global { (FIELDS_PER_LINE, 1) } else { (4, 0) };
    let mut plies: Vec<Ply> = Vec::new();
    for start in (FIELDS_PER_LINE..card.len()).step_by(stride) {
        let at = start + first;
        if (start..start + stride).all(|index| card.text(index).is_empty()) {
            continue;
        }
        for index in at + 4..start + stride {
            card.unset(index, "behind SOUT")?;
        }
        let ply = ply(card, at, plies.last())?;
        let global_id = if is_global { Some(card.id(start, "GPLYID")?) } else { None };
        if let Some(id) = global_id.filter(|_| plies.iter().any(|other| other.global_id == global_id)) {
            return Err(card.error(start, format!("global ply {id} stands twice in PCOMPG {}", card.text(0))));
        }
        plies.push(Ply { global_id, ..ply });
    }
    if plies.is_empty() {
        let message = format!("{} {} has no plies", card.name, card.text(0));
        return Err(card.error(0, message).with_help("plies start in the second line: MID, T, THETA, SOUT"));
    }
    Ok(Pcomp {
        id: card.id(0, "PID")?,
        z0: card.optional_real(1, "Z0")?,
        nsm: card.real_or(2, "NSM", 0.0)?,
        plies,
        is_symmetric: !card.text(7).is_empty(),
        is_global,
        span: card.span.clone(),
    })
}

/// MID T THETA SOUT; an empty material or thickness is that of the ply before.
fn ply(card: &Card, at: usize, before: Option<&Ply>) -> Result<Ply, InputError> {
    card.word(at + 3, "SOUT", &["YES", "NO"])?;
    let material = match (card.optional_id(at, "MID")?, before) {
        (Some(material), _) => material,
        (None, Some(ply)) => ply.material,
        (None, None) => return Err(card.empty(at, "MID", "the material of the first ply")),
    };
    let thickness = match before {
        Some(ply) if card.text(at + 1).is_empty() => ply.thickness,
        _ => card.positive(at + 1, "T")?,
    };
    Ok(Ply { material, thickness, angle_deg: card.real_or(at + 2, "THETA", 0.0)?, global_id: None })
}
