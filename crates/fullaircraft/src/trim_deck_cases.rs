//! The trims a deck asks for: its subcases, or every TRIM card if it has none.

use nastran::{BulkData, InputError, Subcase, Trim};
use std::collections::BTreeSet;

/// One trim of a deck.
#[derive(Debug, Clone, PartialEq)]
pub struct DeckCase {
    /// What selects it.
    pub subcase: Subcase,
    /// Its TRIM card.
    pub trim: Trim,
}

/// The trims of a deck in its order.
///
/// # Errors
/// If a subcase selects a TRIM that is not there, or the deck has none.
pub fn deck_cases(bulk: &BulkData) -> Result<Vec<DeckCase>, InputError> {
    let mut cases = Vec::new();
    for subcase in &bulk.subcases {
        let Some(id) = subcase.trim else { continue };
        let trim = bulk.trims.get(&id).ok_or_else(|| {
            InputError::general(format!("SUBCASE {} selects TRIM {id}, which is not there", subcase.id))
        })?;
        cases.push(DeckCase { subcase: subcase.clone(), trim: trim.clone() });
    }
    if bulk.subcases.is_empty() {
        cases.extend(
            bulk.trims.values().map(|trim| DeckCase { subcase: Subcase::default(), trim: trim.clone() }),
        );
    }
    if cases.is_empty() {
        return Err(InputError::general("the deck asks for no trim")
            .with_help("add a TRIM card and select it in a SUBCASE, or leave out the case control"));
    }
    Ok(cases)
}

/// The deck as a subcase sees it: its SPC and MPC sets and its symmetry. Without a selection all sets apply.
///
/// # Errors
/// If a selected set is not there, or is an SPCADD or MPCADD, which are not read.
pub fn select(bulk: &BulkData, subcase: &Subcase) -> Result<BulkData, InputError> {
    let mut bulk = bulk.clone();
    if let Some(set) = subcase.spc {
        let sets: BTreeSet<u32> = bulk.constraints.iter().map(|card| card.set).collect();
        check(&bulk, "SPC", set, &sets)?;
        bulk.constraints.retain(|card| card.set == set);
    }
    if let Some(set) = subcase.mpc {
        let sets: BTreeSet<u32> = bulk.equations.iter().map(|card| card.set).collect();
        check(&bulk, "MPC", set, &sets)?;
        bulk.equations.retain(|card| card.set == set);
    }
    if let (Some(symmetry), Some(aeros)) = (subcase.symmetry, &mut bulk.aero_reference) {
        aeros.symmetry = symmetry;
    }
    Ok(bulk)
}

fn check(bulk: &BulkData, kind: &str, set: u32, sets: &BTreeSet<u32>) -> Result<(), InputError> {
    let added = format!("{kind}ADD");
    if bulk.unknown.contains_key(&added) {
        return Err(InputError::general(format!(
            "{added} is not read, so {kind} = {set} cannot be selected"
        ))
        .with_help(format!("give the cards of set {set} that number themselves")));
    }
    if sets.contains(&set) {
        return Ok(());
    }
    Err(InputError::general(format!("the case control selects {kind} {set}, which is not there")))
}
