//! Solids and rods with their properties: CHEXA, CPENTA, CTETRA, PSOLID, CROD and PROD, from fields to the structs
//! of [`crate::fe_cards`].

use crate::card::Card;
use crate::fe_cards::{Crod, Prod, Psolid, SolidElement};
use crate::source::InputError;

/// CHEXA, CPENTA, CTETRA: EID PID G1 G2 ...; midside grids are refused.
pub(crate) fn solid(card: &Card) -> Result<SolidElement, InputError> {
    let names = ["G1", "G2", "G3", "G4", "G5", "G6", "G7", "G8"];
    let (corners, with_midsides) = match card.name.as_str() {
        "CHEXA" => (8, 20),
        "CPENTA" => (6, 15),
        _ => (4, 10),
    };
    let grids = card.corners(2, &names[..corners])?;
    card.ends_after(2 + with_midsides)?;
    if card.len() > 2 + corners {
        let surplus = (2 + corners..card.len()).find(|index| !card.text(*index).is_empty());
        let message = format!(
            "{} {} has midside grids, which are not read; only its {corners} corner grids G1 to G{corners} are",
            card.name,
            card.text(0)
        );
        return Err(card
            .error(surplus.unwrap_or(2 + corners), message)
            .with_help("write the mesh with linear elements"));
    }
    let id = card.id(0, "EID")?;
    Ok(SolidElement { id, property: card.id_or(1, "PID", id)?, grids, span: card.span.clone() })
}

/// PSOLID: PID MID CORDM IN STRESS ISOP FCTN; IN, STRESS and ISOP choose integration points and are skipped.
pub(crate) fn psolid(card: &Card) -> Result<Psolid, InputError> {
    card.ends_after(7)?;
    card.word(6, "FCTN", &["SMECH"])?;
    let cordm = card.integer_or(2, "CORDM", 0)?;
    if cordm < -1 {
        return Err(card.wrong(2, "CORDM", "-1, 0 or a coordinate system"));
    }
    Ok(Psolid { id: card.id(0, "PID")?, material: card.id(1, "MID")?, cordm, span: card.span.clone() })
}

/// CROD: EID PID G1 G2.
pub(crate) fn crod(card: &Card) -> Result<Crod, InputError> {
    card.ends_after(4)?;
    let id = card.id(0, "EID")?;
    let property = card.id_or(1, "PID", id)?;
    let grids = card.corners(2, &["G1", "G2"])?;
    Ok(Crod { id, property, grids: [grids[0], grids[1]], span: card.span.clone() })
}

/// PROD: PID MID A J C NSM; the stress coefficient C is skipped.
pub(crate) fn prod(card: &Card) -> Result<Prod, InputError> {
    card.ends_after(6)?;
    Ok(Prod {
        id: card.id(0, "PID")?,
        material: card.id(1, "MID")?,
        area: card.not_negative(2, "A", 0.0)?,
        j: card.not_negative(3, "J", 0.0)?,
        nsm: card.real_or(5, "NSM", 0.0)?,
        span: card.span.clone(),
    })
}
