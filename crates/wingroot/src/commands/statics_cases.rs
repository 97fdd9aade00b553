//! Which loads under which boundary conditions a static deck asks for: LOAD of its subcases, or its only load set.

use nastran::{Analysis, BulkData, InputError, Solution, Subcase};
use std::path::Path;
use structure::load_sets;

use crate::show;

/// One load under its boundary conditions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Asked {
    /// The subcase; none where the deck has one condition only, or no case control.
    pub(super) subcase: Option<u32>,
    /// The load set; none where only motions are enforced or temperatures load.
    pub(super) load: Option<u32>,
    /// Temperatures that load, and those at which nothing has expanded.
    pub(super) temperatures: [Option<u32>; 2],
    /// SPC, MPC and SUPORT1 of the subcase.
    conditions: [Option<u32>; 3],
}

impl Asked {
    fn of(case: &Subcase, load: Option<u32>) -> Self {
        let temperatures = [case.temperature, case.initial_temperature];
        Self { subcase: Some(case.id), load, temperatures, conditions: [case.spc, case.mpc, case.support] }
    }

    /// Whether boundary conditions are the same.
    pub(super) fn is_bounded_as(&self, other: &Self) -> bool {
        self.conditions == other.conditions && self.subcase.is_some() == other.subcase.is_some()
    }
}

/// The loads that a deck asks for; `load` and `subcase` are the user's.
///
/// # Errors
/// If the subcase is not there, or nothing says which load set applies.
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
        let is_loaded = selected.is_some() || case.temperature.is_some() || is_enforced(bulk, case);
        let load = if is_loaded { selected } else { alone(bulk)? };
        return Ok(vec![Asked::of(case, load)]);
    }
    if load.is_none() {
        let is_loaded =
            |case: &&Subcase| case.load.is_some() || case.temperature.is_some() || is_enforced(bulk, case);
        let loaded: Vec<&Subcase> = bulk.subcases.iter().filter(is_loaded).collect();
        if !loaded.is_empty() {
            return Ok(loaded.into_iter().map(|case| Asked::of(case, case.load)).collect());
        }
    }
    let set = match load {
        Some(set) => Some(set),
        None => alone(bulk)?,
    };
    if let (None, Some(set), false) = (load, set, bulk.subcases.is_empty()) {
        show::note(&format!("the case control selects no LOAD: load set {set}, the only one, is applied"));
    }
    Ok(vec![Asked { subcase: None, load: set, temperatures: [None; 2], conditions: [None; 3] }])
}

/// Whether an SPC of the subcase enforces a motion.
fn is_enforced(bulk: &BulkData, case: &Subcase) -> bool {
    let there = |set: u32| bulk.constraints.iter().any(|card| card.set == set && card.enforced != 0.0);
    let united =
        |set: u32| bulk.constraint_unions.get(&set).map_or_else(Vec::new, |union| union.sets.clone());
    case.spc.is_some_and(|set| there(set) || united(set).into_iter().any(there))
}

/// Materials that count where a deck asks for nonlinear statics.
const NONLINEAR: [&str; 7] = ["MATS1", "MATS3", "MATSMA", "MATEP", "MATVP", "MATG", "CREEP"];

/// Refuses nonlinear statics (SOL 106, 400, 401) of materials that yield, creep or damage; linear statics leaves them out as Nastran does.
///
/// # Errors
/// If the deck asks for that.
pub(super) fn refuse_nonlinear_materials(bulk: &BulkData, deck: &Path) -> Result<(), InputError> {
    let asked = Solution::of_file(deck)?;
    let Some(solution) = asked.filter(|solution| solution.analysis == Analysis::NonlinearStatics) else {
        return Ok(());
    };
    let Some((name, unread)) = bulk.unknown.iter().find(|(name, _)| NONLINEAR.contains(&name.as_str()))
    else {
        return Ok(());
    };
    let message = format!(
        "SOL {} asks for a material that is not linear ({name}), which wingroot is not for",
        solution.name
    );
    Err(InputError::at(&unread.first, message).with_help("take it out to compute with the elastic material"))
}

/// Takes PARAM LGDISP out of a deck whose solution is linear: Nastran follows it in SOL 106 and 400.
///
/// # Errors
/// If the deck cannot be read.
pub(super) fn set_aside_lgdisp(bulk: &mut BulkData, deck: &Path) -> Result<(), InputError> {
    let is_linear = Solution::of_file(deck)?.is_some_and(|asked| asked.analysis == Analysis::Statics);
    if is_linear && bulk.parameters.remove("LGDISP").is_some_and(|value| value > 0.0) {
        show::note(
            "PARAM LGDISP acts in SOL 106 and 400, not in SOL 101: deflections are small (--nonlinear makes them large)",
        );
    }
    Ok(())
}

/// Whether PARAM INREL asks for inertia relief about the SUPORT.
///
/// # Errors
/// If it asks for it without a SUPORT (-2), or is no option.
pub(super) fn asks_for_inertia_relief(bulk: &BulkData) -> Result<bool, InputError> {
    match bulk.parameters.get("INREL").copied().unwrap_or(0.0) {
        0.0 => Ok(false),
        -1.0 => Ok(true),
        other => Err(InputError::general(format!("PARAM INREL is {other}; 0 and -1 are read"))
            .with_help("name the motions in which the structure is free by SUPORT, and give -1")),
    }
}

/// Says how a structure accelerates under its loads.
pub(super) fn say_accelerations(accelerations: &[(u32, u8, f64)]) {
    let of = |(grid, component, value): &(u32, u8, f64)| {
        let unit = if *component <= 3 { "m/s^2" } else { "rad/s^2" };
        format!("GRID {grid} component {component} {value:.6} {unit}")
    };
    let list: Vec<String> = accelerations.iter().map(of).collect();
    show::note(&format!("inertia relief (PARAM INREL): the structure accelerates by {}", list.join(", ")));
}

/// The load set that there can be no doubt about: the only one, the only LOAD, or none where motions are enforced.
fn alone(bulk: &BulkData) -> Result<Option<u32>, InputError> {
    let all = load_sets(bulk);
    let sums: Vec<u32> = bulk.load_sums.keys().copied().collect();
    match (all.as_slice(), sums.as_slice()) {
        ([set], _) | (_, [set]) => Ok(Some(*set)),
        ([], _) if bulk.constraints.iter().any(|card| card.enforced != 0.0) => Ok(None),
        ([], _) => Err(InputError::general("the deck has no loads").with_help(
            "FORCE, MOMENT, FORCE1, MOMENT1, FORCE2, MOMENT2, PLOAD, PLOAD1, PLOAD2, PLOAD4, GRAV, LOAD, SPCD, motions enforced by SPC and temperatures that the case control selects are read",
        )),
        _ => {
            let list: Vec<String> = all.iter().map(u32::to_string).collect();
            Err(InputError::general("the deck has several load sets and no LOAD in its case control")
                .with_help(format!("name one by --load: {}", list.join(", "))))
        }
    }
}
