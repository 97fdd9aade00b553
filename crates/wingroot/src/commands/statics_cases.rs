//! Which loads under which boundary conditions a static deck asks for: LOAD of its subcases, or its only load set.

use nastran::{BulkData, InputError, Subcase};
use structure::load_sets;

use crate::show;

/// One load under its boundary conditions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Asked {
    /// The subcase; none where the deck has one condition only, or no case control.
    pub(super) subcase: Option<u32>,
    /// The load set; none where only motions are enforced.
    pub(super) load: Option<u32>,
    /// SPC, MPC and SUPORT1 of the subcase.
    conditions: [Option<u32>; 3],
}

impl Asked {
    fn of(case: &Subcase, load: Option<u32>) -> Self {
        Self { subcase: Some(case.id), load, conditions: [case.spc, case.mpc, case.support] }
    }

    /// Whether boundary conditions are the same.
    pub(super) fn is_bounded_as(&self, other: &Self) -> bool {
        self.conditions == other.conditions && self.subcase.is_some() == other.subcase.is_some()
    }
}

/// The loads that a deck asks for; `load` and `subcase` are the user's.
///
/// # Errors
/// If the subcase is not there, selects temperatures, or nothing says which load set applies.
pub(super) fn asked(
    bulk: &BulkData,
    load: Option<u32>,
    subcase: Option<u32>,
) -> Result<Vec<Asked>, InputError> {
    if let Some(id) = subcase {
        let Some(case) = bulk.subcases.iter().find(|case| case.id == id) else {
            // Says which there are.
            return Err(bulk
                .bounded(subcase)
                .err()
                .unwrap_or_else(|| InputError::general("no such subcase")));
        };
        let selected = load.or(case.load);
        let load = if selected.is_some() || is_enforced(bulk, case) { selected } else { alone(bulk)? };
        return Ok(vec![Asked::of(warm(case)?, load)]);
    }
    if load.is_none() {
        let is_loaded = |case: &&Subcase| case.load.is_some() || is_enforced(bulk, case);
        let loaded: Vec<&Subcase> = bulk.subcases.iter().filter(is_loaded).collect();
        if !loaded.is_empty() {
            return loaded.into_iter().map(|case| Ok(Asked::of(warm(case)?, case.load))).collect();
        }
        bulk.subcases.iter().try_for_each(|case| warm(case).map(|_| ()))?;
    }
    let set = match load {
        Some(set) => Some(set),
        None => alone(bulk)?,
    };
    if let (None, Some(set), false) = (load, set, bulk.subcases.is_empty()) {
        show::note(&format!("the case control selects no LOAD: load set {set}, the only one, is applied"));
    }
    Ok(vec![Asked { subcase: None, load: set, conditions: [None; 3] }])
}

/// Whether an SPC of the subcase enforces a motion.
fn is_enforced(bulk: &BulkData, case: &Subcase) -> bool {
    let there = |set: u32| bulk.constraints.iter().any(|card| card.set == set && card.enforced != 0.0);
    let united =
        |set: u32| bulk.constraint_unions.get(&set).map_or_else(Vec::new, |union| union.sets.clone());
    case.spc.is_some_and(|set| there(set) || united(set).into_iter().any(there))
}

/// A subcase without temperatures.
fn warm(case: &Subcase) -> Result<&Subcase, InputError> {
    let Some(set) = case.temperature else { return Ok(case) };
    let message =
        format!("subcase {} selects temperatures (set {set}), and thermal expansion is not read", case.id);
    Err(InputError::general(message).with_help("name a subcase without TEMPERATURE, or take it out"))
}

/// The load set that there can be no doubt about: the only one, the only LOAD, or none where motions are enforced.
fn alone(bulk: &BulkData) -> Result<Option<u32>, InputError> {
    let all = load_sets(bulk);
    let sums: Vec<u32> = bulk.load_sums.keys().copied().collect();
    match (all.as_slice(), sums.as_slice()) {
        ([set], _) | (_, [set]) => Ok(Some(*set)),
        ([], _) if bulk.constraints.iter().any(|card| card.enforced != 0.0) => Ok(None),
        ([], _) => Err(InputError::general("the deck has no loads").with_help(
            "FORCE, MOMENT, FORCE1, MOMENT1, FORCE2, MOMENT2, PLOAD, PLOAD1, PLOAD2, PLOAD4, GRAV, LOAD and motions enforced by SPC are read",
        )),
        _ => {
            let list: Vec<String> = all.iter().map(u32::to_string).collect();
            Err(InputError::general("the deck has several load sets and no LOAD in its case control")
                .with_help(format!("name one by --load: {}", list.join(", "))))
        }
    }
}
