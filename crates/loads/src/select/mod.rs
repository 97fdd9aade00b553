//! Selection of the cases that go to stress, apart from flying and enveloping them: a policy over finished loads.
//!
//! Drivers are what a policy asks for (an end, a corner of a hull, ...), each with the instant that gives it; of equal ones that of the
//! lowest case. A cap takes cases by greedy cover: those asked for by number, then all ends, then corners, then the rest.

mod cover;
mod csv;
mod drivers;
pub mod file;
mod hull;
mod instant;
mod places;

use crate::select::file::{Model, Policy, SelectFile};
use cover::cover;
use drivers::{Driver, drivers};
pub use instant::Instant;
use nastran::InputError;
use places::Places;
use std::collections::BTreeMap;

/// An end, a corner or what else a policy asks for, and the instant that gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Model.
    pub model: Model,
    /// Which policy.
    pub policy: &'static str,
    /// What it is: station, load and end, or station and pair.
    pub what: String,
    /// Values of the loads it is about, N or N m.
    pub values: Vec<f64>,
    /// The case that gives it.
    pub case: usize,
    /// The instant of that case.
    pub instant: usize,
    /// Whether that instant is selected.
    pub covered: bool,
}

/// A selected instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Selected {
    /// Load set, from one.
    pub sid: u32,
    /// Model.
    pub model: Model,
    /// Number of the case.
    pub case: usize,
    /// Number within the case.
    pub instant: usize,
    /// How many ends and corners it drives.
    pub driven: usize,
    /// What asked for it.
    pub why: Vec<String>,
}

/// What a policy selects.
#[derive(Debug, Clone, PartialEq)]
pub struct Selection {
    /// Selected instants, in the order of cases.
    pub selected: Vec<Selected>,
    /// Everything that was asked for.
    pub drives: Vec<Drive>,
    /// Cases that are never taken, with the reason.
    pub never: Vec<(usize, String)>,
}

impl Selection {
    /// What was asked for and is not selected, for the cap.
    pub fn uncovered(&self) -> impl Iterator<Item = &Drive> {
        self.drives.iter().filter(|drive| !drive.covered)
    }
}

/// Selects among instants, whose loads are in the order of `stations`.
///
/// # Errors
/// If the file names a station or a case that is not there, or the cap is below the number of cases asked for by number.
pub fn select(file: &SelectFile, stations: &[String], instants: &[Instant]) -> Result<Selection, InputError> {
    let places = Places::new(file, stations);
    let mut order: Vec<&Instant> = instants.iter().collect();
    order.sort_by_key(|instant| instant.key());
    let never = never(file, &order)?;
    order.retain(|instant| {
        file.models.contains(&instant.model) && !never.iter().any(|(case, _)| *case == instant.case)
    });
    let all = drivers(file, &places, &order)?;
    let kept = cover(file, &order, &all)?;
    Ok(Selection { selected: selected(&order, &all, &kept), drives: drives(&order, &all, &kept), never })
}

fn never(file: &SelectFile, order: &[&Instant]) -> Result<Vec<(usize, String)>, InputError> {
    let mut never = Vec::new();
    for policy in &file.policies {
        if let Policy::Never { cases, because } = policy {
            for case in cases {
                if !order.iter().any(|instant| instant.case == *case) {
                    return Err(file.no_case(*case));
                }
                never.push((*case, because.clone()));
            }
        }
    }
    Ok(never)
}

fn selected(order: &[&Instant], all: &[Driver], kept: &[bool]) -> Vec<Selected> {
    let mut by_instant: BTreeMap<usize, Vec<&Driver>> = BTreeMap::new();
    for driver in all.iter().filter(|driver| kept[driver.place]) {
        by_instant.entry(driver.place).or_default().push(driver);
    }
    let one = |(sid, (place, drivers)): (u32, (usize, Vec<&Driver>))| {
        let instant = order[place];
        Selected {
            sid,
            model: instant.model,
            case: instant.case,
            instant: instant.instant,
            driven: drivers.iter().filter(|driver| driver.rank.is_driven()).count(),
            why: drivers.iter().map(|driver| format!("{}: {}", driver.policy, driver.what)).collect(),
        }
    };
    (1..).zip(by_instant).map(one).collect()
}

fn drives(order: &[&Instant], all: &[Driver], kept: &[bool]) -> Vec<Drive> {
    let one = |driver: &Driver| {
        let instant = order[driver.place];
        Drive {
            model: instant.model,
            policy: driver.policy,
            what: driver.what.clone(),
            values: driver.values.clone(),
            case: instant.case,
            instant: instant.instant,
            covered: kept[driver.place],
        }
    };
    all.iter().map(one).collect()
}
