//! Which reader reads which card, and where its item is kept.

use crate::aero_cards as aero;
use crate::card::Card;
use crate::cards::BulkData;
use crate::fe_dispatch;
use crate::property_cards as property;
use crate::rigid_cards as rigid;
use crate::section_cards as section;
use crate::shell_cards::CornerThickness;
use crate::source::{InputError, Span};
use crate::structure_cards as structure;
use crate::trim_cards as trim;
use std::collections::BTreeMap;

/// Keeps the item of a card; false if cards of that name are not read.
pub(crate) fn card(
    deck: &mut BulkData,
    thicknesses: &mut Vec<CornerThickness>,
    card: &Card,
) -> Result<bool, InputError> {
    Ok(structure_card(deck, card)?
        || aero_card(deck, card)?
        || trim_card(deck, card)?
        || fe_dispatch::element(deck, thicknesses, card)?
        || fe_dispatch::property(deck, card)?
        || fe_dispatch::other(deck, card)?)
}

/// Keeps the item of a card whose name is known here.
fn structure_card(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "GRID" => {
            let item = structure::grid(card)?;
            keep(&mut deck.grids, card, item.id, item, |item| &item.span)
        }
        "CORD1R" | "CORD1C" | "CORD1S" => structure::cord1(card)?
            .into_iter()
            .try_for_each(|item| keep(&mut deck.coords, card, item.id, item, |item| &item.span)),
        "CORD2R" | "CORD2C" | "CORD2S" => {
            let item = structure::cord2(card)?;
            keep(&mut deck.coords, card, item.id, item, |item| &item.span)
        }
        "CBAR" | "CBEAM" => {
            let item = structure::beam_element(card)?;
            keep(&mut deck.beams, card, item.id, item, |item| &item.span)
        }
        "PBAR" | "PBEAM" | "PBARL" | "PBEAML" => {
            let read = match card.name.as_str() {
                "PBAR" => property::pbar,
                "PBEAM" => property::pbeam,
                "PBARL" => section::pbarl,
                _ => section::pbeaml,
            };
            let item = read(card)?;
            keep(&mut deck.beam_properties, card, item.id, item, |item| &item.span)
        }
        "MAT1" => {
            let item = property::mat1(card)?;
            keep(&mut deck.materials, card, item.id, item, |item| &item.span)
        }
        "CONM2" => {
            let item = structure::conm2(card)?;
            keep(&mut deck.masses, card, item.id, item, |item| &item.span)
        }
        "RBE2" => {
            let item = structure::rbe2(card)?;
            keep(&mut deck.rigid, card, item.id, item, |item| &item.span)
        }
        "SPC1" => {
            deck.constraints.push(structure::spc1(card)?);
            Ok(())
        }
        "SPC" => {
            deck.constraints.extend(rigid::spc(card)?);
            Ok(())
        }
        "SPCADD" => unite(&mut deck.constraint_unions, card),
        "MPCADD" => unite(&mut deck.equation_unions, card),
        "SET1" => {
            let item = structure::set1(card)?;
            keep(&mut deck.sets, card, item.id, item, |item| &item.span)
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

fn aero_card(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "CAERO1" => {
            let item = aero::caero1(card)?;
            keep(&mut deck.panels, card, item.id, item, |item| &item.span)
        }
        "PAERO1" => {
            keep(&mut deck.panel_properties, card, card.id(0, "PID")?, card.span.clone(), |span| span)
        }
        "AEFACT" => {
            let item = aero::aefact(card)?;
            keep(&mut deck.factors, card, item.id, item, |item| &item.span)
        }
        "AESURF" => {
            let item = aero::aesurf(card)?;
            keep(&mut deck.surfaces, card, item.id, item, |item| &item.span)
        }
        "AELIST" => {
            let item = aero::aelist(card)?;
            keep(&mut deck.box_lists, card, item.id, item, |item| &item.span)
        }
        "MONPNT1" | "MONPNT3" => {
            let item = aero::monitor(card)?;
            if let Some(first) = deck.monitors.iter().find(|other| other.name == item.name) {
                return Err(twice(card, &format!("monitoring station {}", item.name), &first.span));
            }
            deck.monitors.push(item);
            Ok(())
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

/// Keeps the item of a card of static aeroelasticity.
fn trim_card(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "AEROS" => {
            let item = trim::aeros(card)?;
            if let Some(first) = &deck.aero_reference {
                return Err(twice(card, "AEROS", &first.span));
            }
            deck.aero_reference = Some(item);
            Ok(())
        }
        "AESTAT" => {
            let item = trim::aestat(card)?;
            keep(&mut deck.trim_variables, card, item.id, item, |item| &item.span)
        }
        "TRIM" => {
            let item = trim::trim(card)?;
            keep(&mut deck.trims, card, item.id, item, |item| &item.span)
        }
        "AELINK" => {
            deck.aero_links.push(trim::aelink(card)?);
            Ok(())
        }
        "AECOMP" => {
            let item = trim::aecomp(card)?;
            if let Some(first) = deck.aero_components.get(&item.name) {
                return Err(twice(card, &format!("component {}", item.name), &first.span));
            }
            deck.aero_components.insert(item.name.clone(), item);
            Ok(())
        }
        "SUPORT" => {
            deck.supports.extend(trim::suport(card)?);
            Ok(())
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

pub(crate) fn keep<T>(
    map: &mut BTreeMap<u32, T>,
    card: &Card,
    id: u32,
    item: T,
    span: impl Fn(&T) -> &Span,
) -> Result<(), InputError> {
    if let Some(first) = map.get(&id) {
        return Err(twice(card, &format!("{} {id}", card.name), span(first)));
    }
    map.insert(id, item);
    Ok(())
}

/// SPCADD, MPCADD: SID S1 S2 ...
fn unite(unions: &mut BTreeMap<u32, Vec<u32>>, card: &Card) -> Result<(), InputError> {
    let (id, sets) = (card.id(0, "SID")?, card.id_list(1, "S")?);
    if sets.contains(&id) {
        return Err(card.error(0, format!("{} {id} unites itself with others", card.name)));
    }
    if unions.insert(id, sets).is_some() {
        let help = "give every card its own number, and name all sets on one card";
        return Err(card.error(0, format!("{} {id} is given twice", card.name)).with_help(help));
    }
    Ok(())
}

pub(crate) fn twice(card: &Card, what: &str, first: &Span) -> InputError {
    let message = format!("{what} is given twice; the number or name is taken since {first}");
    card.error(0, message).with_help("give every card its own number or name")
}
