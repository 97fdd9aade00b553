//! Which reader reads which card of general finite elements, and where its item is kept.

use crate::card::Card;
use crate::cards::BulkData;
use crate::dispatch::keep;
use crate::genel_card as genel;
use crate::material_cards as material;
use crate::rigid_cards as rigid;
use crate::shell_cards as shell;
use crate::shell_cards::CornerThickness;
use crate::solid_cards as solid;
use crate::source::InputError;
use crate::spline_cards as spline;
use crate::spring_cards as spring;

/// Keeps an element; false if the card is none of these.
pub(crate) fn element(
    deck: &mut BulkData,
    thicknesses: &mut Vec<CornerThickness>,
    card: &Card,
) -> Result<bool, InputError> {
    match card.name.as_str() {
        "CQUAD4" | "CTRIA3" => {
            let (item, corners) = shell::shell(card)?;
            thicknesses.extend(corners);
            keep(&mut deck.shells, card, item.id, item, |item| &item.span)
        }
        "CHEXA" | "CPENTA" | "CTETRA" => {
            let item = solid::solid(card)?;
            keep(&mut deck.solids, card, item.id, item, |item| &item.span)
        }
        "CROD" => {
            let item = solid::crod(card)?;
            keep(&mut deck.rods, card, item.id, item, |item| &item.span)
        }
        "CBUSH" => {
            let item = spring::cbush(card)?;
            keep(&mut deck.bushes, card, item.id, item, |item| &item.span)
        }
        "CELAS1" | "CELAS2" => {
            let item = spring::scalar_element(card)?;
            keep(&mut deck.springs, card, item.id, item, |item| &item.span)
        }
        "CMASS1" | "CMASS2" => {
            let item = spring::scalar_element(card)?;
            keep(&mut deck.scalar_masses, card, item.id, item, |item| &item.span)
        }
        "GENEL" => {
            let item = genel::genel(card)?;
            keep(&mut deck.general, card, item.id, item, |item| &item.span)
        }
        "CONM1" => {
            let item = spring::conm1(card)?;
            keep(&mut deck.mass_matrices, card, item.id, item, |item| &item.span)
        }
        "RBAR" => {
            let item = rigid::rbar(card)?;
            keep(&mut deck.rigid_bars, card, item.id, item, |item| &item.span)
        }
        "RBE3" => {
            let item = rigid::rbe3(card)?;
            keep(&mut deck.averages, card, item.id, item, |item| &item.span)
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

/// Keeps a property or a material; false if the card is none of these.
pub(crate) fn property(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "PSHELL" => {
            let item = shell::pshell(card)?;
            keep(&mut deck.shell_properties, card, item.id, item, |item| &item.span)
        }
        "PCOMP" | "PCOMPG" => {
            let item = shell::pcomp(card)?;
            keep(&mut deck.laminates, card, item.id, item, |item| &item.span)
        }
        "PSOLID" => {
            let item = solid::psolid(card)?;
            keep(&mut deck.solid_properties, card, item.id, item, |item| &item.span)
        }
        "PROD" => {
            let item = solid::prod(card)?;
            keep(&mut deck.rod_properties, card, item.id, item, |item| &item.span)
        }
        "PBUSH" => {
            let item = spring::pbush(card)?;
            keep(&mut deck.bush_properties, card, item.id, item, |item| &item.span)
        }
        "PELAS" => spring::scalar_properties(card)?
            .into_iter()
            .try_for_each(|item| keep(&mut deck.spring_properties, card, item.id, item, |item| &item.span)),
        "PMASS" => spring::scalar_properties(card)?
            .into_iter()
            .try_for_each(|item| keep(&mut deck.mass_properties, card, item.id, item, |item| &item.span)),
        "MAT2" => {
            let item = material::mat2(card)?;
            keep(&mut deck.plane_materials, card, item.id, item, |item| &item.span)
        }
        "MAT8" => {
            let item = material::mat8(card)?;
            keep(&mut deck.ply_materials, card, item.id, item, |item| &item.span)
        }
        "MAT9" => {
            let item = material::mat9(card)?;
            keep(&mut deck.solid_materials, card, item.id, item, |item| &item.span)
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

/// Keeps an equation, spline or parameter; false if the card is none of these.
pub(crate) fn other(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "MPC" => deck.equations.push(rigid::mpc(card)?),
        "SPLINE1" | "SPLINE2" | "SPLINE4" | "SPLINE5" => {
            let item = spline::spline(card)?;
            keep(&mut deck.splines, card, item.id, item, |item| &item.span)?;
        }
        "PARAM" => {
            let Some((name, value)) = spline::parameter(card)? else { return Ok(false) };
            let before = deck.parameters.insert(name.clone(), value);
            if let Some(before) = before.filter(|before| *before != value) {
                let message = format!("parameter {name} is {value} here and {before} before");
                return Err(card.error(1, message).with_help("give every parameter once"));
            }
        }
        _ => return Ok(false),
    }
    Ok(true)
}
