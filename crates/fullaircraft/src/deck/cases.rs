//! The trims a deck asks for: its subcases, or every TRIM card if it has none.

use nastran::{BulkData, InputError, SetUnion, Subcase, Trim};
use std::collections::{BTreeMap, BTreeSet};

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

/// Cards that are not read and would change a trim.
const NEEDED: [&str; 16] = [
    "AEFORCE", "AEPARM", "AEPRESS", "CAERO2", "CAERO3", "CAERO4", "CAERO5", "CSSCHD", "DMIJ", "DMIJI",
    "DMIK", "SPLINE3", "SPLINE6", "SPLINE7", "SUPORT1", "UXVEC",
];

/// Refuses a deck with cards that are not read and would change its trims, by their names.
///
/// # Errors
/// If there is one.
pub(crate) fn refuse_unread(bulk: &BulkData) -> Result<(), InputError> {
    let there: Vec<&str> = NEEDED.into_iter().filter(|name| bulk.unknown.contains_key(*name)).collect();
    if there.is_empty() {
        return Ok(());
    }
    let message =
        format!("the deck has {}, which would change its trims and which are not read", there.join(", "));
    Err(InputError::general(message).with_help(
        "write matrices as DMI (W2GJ, WKK, FA2J), panels as CAERO1, splines as SPLINE1, 2, 4 or 5, and SUPORT for SUPORT1",
    ))
}

/// The deck as a subcase sees it: its SPC and MPC sets (SPCADD and MPCADD unite several) and its symmetry. Without a selection
/// all sets apply.
///
/// # Errors
/// If a selected set is not there, or one that an SPCADD or MPCADD unites.
pub fn select(bulk: &BulkData, subcase: &Subcase) -> Result<BulkData, InputError> {
    let mut bulk = bulk.clone();
    if let Some(set) = subcase.spc {
        let sets = bulk.constraints.iter().map(|card| card.set).collect();
        let kept = selected("SPC", set, &sets, &bulk.constraint_unions)?;
        bulk.constraints.retain(|card| kept.contains(&card.set));
    }
    if let Some(set) = subcase.mpc {
        let sets = bulk.equations.iter().map(|card| card.set).collect();
        let kept = selected("MPC", set, &sets, &bulk.equation_unions)?;
        bulk.equations.retain(|card| kept.contains(&card.set));
    }
    if let (Some(symmetry), Some(aeros)) = (subcase.symmetry, &mut bulk.aero_reference) {
        aeros.symmetry = symmetry;
    }
    Ok(bulk)
}

/// The sets that a selection means.
fn selected(
    kind: &str,
    set: u32,
    sets: &BTreeSet<u32>,
    unions: &BTreeMap<u32, SetUnion>,
) -> Result<Vec<u32>, InputError> {
    let Some(SetUnion { sets: united, .. }) = unions.get(&set) else {
        return if sets.contains(&set) {
            Ok(vec![set])
        } else {
            Err(InputError::general(format!("the case control selects {kind} {set}, which is not there")))
        };
    };
    if sets.contains(&set) {
        let message = format!("{kind} {set} is a set of its own and a union by {kind}ADD");
        return Err(InputError::general(message).with_help("give the union another number"));
    }
    match united.iter().find(|one| !sets.contains(one)) {
        Some(missing) => {
            Err(InputError::general(format!("{kind}ADD {set} unites set {missing}, which is not there")))
        }
        None => Ok(united.clone()),
    }
}
