//! Which instants stay under a cap: greedy cover by cases.

use super::drivers::{Driver, Rank};
use super::file::SelectFile;
use super::instant::Instant;
use nastran::{InputError, place_of, read_text};
use std::collections::{BTreeMap, BTreeSet};

/// Whether each instant of `order` is selected.
///
/// # Errors
/// If more cases are asked for by number than the cap allows.
pub(super) fn cover(file: &SelectFile, order: &[&Instant], all: &[Driver]) -> Result<Vec<bool>, InputError> {
    let case_of = |driver: &Driver| (order[driver.place].model, order[driver.place].case);
    let mut chosen: BTreeSet<_> =
        all.iter().filter(|driver| driver.rank == Rank::Always).map(case_of).collect();
    let most = file.at_most.unwrap_or(usize::MAX);
    if chosen.len() > most {
        let message =
            format!("{} cases are asked for by number, and at most {most} are wanted", chosen.len());
        return Err(InputError::in_field(&file.path, "at_most", message).with_help("raise `at_most`"));
    }
    for rank in [Rank::End, Rank::Corner, Rank::Other] {
        while chosen.len() < most {
            let mut open: BTreeMap<_, usize> = BTreeMap::new();
            for driver in all.iter().filter(|driver| driver.rank == rank) {
                if !chosen.contains(&case_of(driver)) {
                    *open.entry(case_of(driver)).or_default() += 1;
                }
            }
            // The case that gives most; of equal ones the lowest.
            let Some(best) = open.iter().max_by(|a, b| a.1.cmp(b.1).then(b.0.cmp(a.0))) else { break };
            chosen.insert(*best.0);
        }
    }
    let mut kept = vec![false; order.len()];
    for driver in all.iter().filter(|driver| chosen.contains(&case_of(driver))) {
        kept[driver.place] = true;
    }
    Ok(kept)
}

impl SelectFile {
    /// A complaint that a case is not there.
    pub(super) fn no_case(&self, case: usize) -> InputError {
        let text = read_text(&self.path).unwrap_or_default();
        let place = place_of(&["cases:", &case.to_string()], &text, &self.path);
        InputError::at(&place, format!("there are no loads of a case {case}"))
            .with_help("cases.csv lists the cases and which were flown")
    }
}
