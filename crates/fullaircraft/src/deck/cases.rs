//! The trims a deck asks for: its subcases, or every TRIM card if none is selected; and what divergence it asks for.

use nastran::{BulkData, Diverg, InputError, Subcase, Trim};

/// One trim of a deck.
#[derive(Debug, Clone, PartialEq)]
pub struct DeckCase {
    /// What selects it.
    pub subcase: Subcase,
    /// Its TRIM card.
    pub trim: Trim,
}

/// A subcase that asks for divergence.
#[derive(Debug, Clone, PartialEq)]
pub struct DivergenceCase {
    /// What selects it.
    pub subcase: Subcase,
    /// Its DIVERG card.
    pub diverg: Diverg,
}

/// The subcases of a deck that ask for divergence, in its order.
///
/// # Errors
/// If a card of the air is wrong, or a subcase selects a DIVERG that is not there.
pub fn divergence_cases(bulk: &BulkData) -> Result<Vec<DivergenceCase>, InputError> {
    bulk.refuse_unread_air()?;
    let of = |subcase: &Subcase, id: u32| {
        let diverg = bulk.divergences.get(&id).ok_or_else(|| {
            InputError::general(format!("SUBCASE {} selects DIVERG {id}, which is not there", subcase.id))
        })?;
        Ok(DivergenceCase { subcase: subcase.clone(), diverg: diverg.clone() })
    };
    bulk.subcases.iter().filter_map(|subcase| subcase.divergence.map(|id| of(subcase, id))).collect()
}

/// The trims of a deck in its order.
///
/// # Errors
/// If a subcase selects a TRIM that is not there, or the deck has none.
pub fn deck_cases(bulk: &BulkData) -> Result<Vec<DeckCase>, InputError> {
    let cases = trims_or_none(bulk)?;
    if cases.is_empty() {
        return Err(InputError::general("the deck asks for no trim")
            .with_help("add a TRIM card and select it in a SUBCASE, or leave out the case control"));
    }
    Ok(cases)
}

/// As [`deck_cases`]; a deck that asks for divergence alone has none.
///
/// # Errors
/// As [`deck_cases`], if the deck asks for no divergence either.
pub fn deck_cases_beside_divergence(bulk: &BulkData) -> Result<Vec<DeckCase>, InputError> {
    if divergence_cases(bulk)?.is_empty() { deck_cases(bulk) } else { trims_or_none(bulk) }
}

fn trims_or_none(bulk: &BulkData) -> Result<Vec<DeckCase>, InputError> {
    bulk.refuse_unread_air()?;
    let mut cases = Vec::new();
    for subcase in &bulk.subcases {
        let Some(id) = subcase.trim else { continue };
        let trim = bulk.trims.get(&id).ok_or_else(|| {
            InputError::general(format!("SUBCASE {} selects TRIM {id}, which is not there", subcase.id))
        })?;
        if subcase.temperature.is_some() {
            let message = format!(
                "SUBCASE {} heats the structure (TEMPERATURE), which a trim does not know",
                subcase.id
            );
            return Err(InputError::at(&trim.span, message).with_help("leave TEMPERATURE out of the subcase"));
        }
        cases.push(DeckCase { subcase: subcase.clone(), trim: trim.clone() });
    }
    let asks_otherwise = bulk.subcases.iter().any(|subcase| subcase.divergence.is_some());
    if let ([] | [_], true) = (bulk.subcases.as_slice(), cases.is_empty() && !asks_otherwise) {
        let subcase = bulk.subcases.first().cloned().unwrap_or_default();
        cases.extend(
            bulk.trims.values().map(|trim| DeckCase { subcase: subcase.clone(), trim: trim.clone() }),
        );
    }
    Ok(cases)
}

/// Cards that are not read and would change a trim.
const NEEDED: [&str; 15] = [
    "AEFORCE", "AEPARM", "AEPRESS", "CAERO2", "CAERO3", "CAERO4", "CAERO5", "CSSCHD", "DMIJ", "DMIJI",
    "DMIK", "SPLINE3", "SPLINE6", "SPLINE7", "UXVEC",
];

/// Which of some cards the deck has that are not read.
pub(crate) fn unread_cards<'a>(bulk: &BulkData, names: &[&'a str]) -> Vec<&'a str> {
    names.iter().copied().filter(|name| bulk.unknown.contains_key(*name)).collect()
}

/// Refuses a deck with cards that are not read and would change its trims, by their names.
///
/// # Errors
/// If there is one.
pub(crate) fn refuse_unread(bulk: &BulkData) -> Result<(), InputError> {
    if let Some(card) = bulk.constraints.iter().find(|card| card.enforced != 0.0) {
        let message = format!(
            "SPC enforces a motion of {} on grid {}, which a trim does not know",
            card.enforced, card.grids[0]
        );
        return Err(InputError::at(&card.span, message).with_help("leave field D empty, or zero"));
    }
    let there = unread_cards(bulk, &NEEDED);
    if there.is_empty() {
        return Ok(());
    }
    let message =
        format!("the deck has {}, which would change its trims and which are not read", there.join(", "));
    Err(InputError::general(message).with_help(
        "write matrices as DMI (W2GJ, WKK, FA2J), panels as CAERO1 and splines as SPLINE1, 2, 4 or 5",
    ))
}
