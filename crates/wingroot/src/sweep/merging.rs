//! What must hold before results are made of a store: one state of all inputs, and no case missing.

use std::collections::BTreeMap;

use nastran::InputError;

use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::show;
use crate::store::Store;
use crate::sweep::lines;
use crate::sweep::share::Share;
use crate::sweep::split::{Weighed, share_of};

/// Missing cases that are named one by one.
const NAMED: usize = 10;

/// Refuses a store with segments of other inputs than these, by the names of what differs.
///
/// # Errors
/// If there is such a segment.
pub fn one_state(store: &Store) -> Result<(), Failure> {
    let Some(foreign) = store.standing().foreign.into_iter().next() else { return Ok(()) };
    let message = format!("these cases were computed with another state of: {}", foreign.differs.join(", "));
    let help =
        "merge with the files and the program of the parts, or remove this file and compute its cases again";
    Err(InputError::in_file(&foreign.path, message).with_help(help).into())
}

/// Says what was not believed, and what was found twice with other digits.
pub fn remarks(store: &Store) {
    let standing = store.standing();
    if standing.damaged > 0 {
        show::note(&format!(
            "{} records of {} are damaged and not believed",
            standing.damaged,
            store.folder().display()
        ));
    }
    if let Some(first) = standing.contradicted.first() {
        show::note(&format!(
            "{} cases were computed twice with other digits, as processors of two types do; the first counts: {first}",
            standing.contradicted.len()
        ));
    }
}

/// Refuses a sweep of which cases are missing, after the lines that compute them; `all` makes its cases.
///
/// # Errors
/// If one is missing.
pub fn complete(
    store: &Store,
    missing: &[Fingerprint],
    all: impl Fn() -> Vec<Weighed>,
) -> Result<(), Failure> {
    if missing.is_empty() {
        return Ok(());
    }
    let line = lines::sweep_line();
    let mut said = Vec::new();
    if missing.len() <= NAMED {
        said.extend(missing.iter().map(|hash| format!("wingroot {line} --case {hash}")));
    } else if let Some(of) = parts(store) {
        for number in 1..=of {
            let part = share_of(all(), Share { number, of });
            let count = part.iter().filter(|case| missing.binary_search(&case.hash).is_ok()).count();
            if count > 0 {
                said.push(format!("wingroot {line} --part {number}/{of}    # {count} missing"));
            }
        }
    }
    let message = format!("{} cases are not finished", missing.len());
    if said.is_empty() {
        said.push(format!("wingroot {line} --part 1/1"));
    }
    Err(InputError::general(message).with_help(format!("compute them with\n{}", said.join("\n"))).into())
}

/// What is said of a hash that no case has.
pub fn no_such_case(hash: Fingerprint) -> Failure {
    let error = InputError::general(format!("no case of these has the hash {hash}"));
    error.with_help("hashes are those that `wingroot status` and `wingroot merge` show").into()
}

/// Into how many parts a store's cases were mostly dealt, by the names of its segments.
fn parts(store: &Store) -> Option<usize> {
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for label in store.labels() {
        let of = label.strip_prefix("part").and_then(|part| part.split_once("of")?.1.parse().ok());
        *counts.entry(of.unwrap_or(1)).or_default() += 1;
    }
    counts.into_iter().filter(|(of, _)| *of > 1).max_by_key(|(_, count)| *count).map(|(of, _)| of)
}
