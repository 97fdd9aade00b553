//! The cases of a plan as a sweep: all in one process, or a share, preparation, merge and status of many.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Instant;

use fullaircraft::design_loads::instants::FlownCase;

use crate::args::Common;
use crate::commands::loads_flights::{Flights, Flown};
use crate::commands::loads_states::Frame;
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::show;
use crate::store::Told;
use crate::sweep::estimate::Estimate;
use crate::sweep::share::Share;
use crate::sweep::split::{Weighed, share_of};
use crate::sweep::{SweepArgs, Task, merging, status};

/// Name of the command.
const COMMAND: &str = "loads";
/// Cases that share a factorisation are flown for an estimate, so many of them: the first takes longest.
const ESTIMATED: usize = 12;
/// All cases as a share.
const ALL: Share = Share { number: 1, of: 1 };

/// Does a task of a process; all that was flown, if results are to be made of it.
///
/// # Errors
/// If something cannot be flown or kept, or cases are missing from a merge.
pub(crate) fn flown(
    flights: &Flights<'_>,
    task: Task,
    sweep: &SweepArgs,
    common: &Common,
    start: Instant,
) -> Result<Option<Flown>, Failure> {
    match task {
        Task::All => {
            flights.fly(&share_of(flights.row(), ALL), common)?;
            return all(flights).map(Some);
        }
        Task::Merge => {
            merging::one_state(&flights.store)?;
            return all(flights).map(Some);
        }
        Task::Part(share) => part(flights, share, common, start)?,
        Task::Case(hash) => again(flights, hash, common)?,
        Task::Prepare => prepare(flights, common)?,
        Task::Estimate => sweep.estimate.put(estimate(flights, common, start)?),
        Task::Status => {
            let status = status::status(COMMAND, &flights.store, flights.row());
            status::show(common, &flights.store, &status)?;
        }
    }
    Ok(None)
}

/// All that was flown; nothing may be missing.
fn all(flights: &Flights<'_>) -> Result<Flown, Failure> {
    let (flown, missing) = flights.finished();
    merging::complete(&flights.store, &missing, || flights.row())?;
    merging::remarks(&flights.store);
    Ok(flown)
}

/// A share of the cases, which are kept; results are made by `merge`.
fn part(flights: &Flights<'_>, share: Share, common: &Common, start: Instant) -> Result<(), Failure> {
    let all = flights.row();
    let count = all.len();
    let own = share_of(all, share);
    let before = flights.fly(&own, common)?;
    let text = format!(
        "part {share}: {} of {count} cases, {before} finished before; {:.2} s; kept in {}\n",
        own.len(),
        start.elapsed().as_secs_f64(),
        flights.store.folder().display()
    );
    show::summary(common, &text);
    Ok(())
}

/// A case, and what is flown with it, unless they are finished.
fn again(flights: &Flights<'_>, hash: Fingerprint, common: &Common) -> Result<(), Failure> {
    let row = share_of(flights.row(), ALL);
    let Some(case) = row.iter().find(|case| case.hash == hash) else {
        return Err(merging::no_such_case(hash));
    };
    let own: Vec<Weighed> = row.iter().filter(|other| other.unit == case.unit).copied().collect();
    let name = flights.part(case.number);
    let before = flights.fly(&own, common)? == own.len();
    let found = flights.store.get::<FlownCase>(&name);
    let found = found.ok_or_else(|| Failure::Computation(format!("{name}: can no longer be read")))?;
    let outcome = match (&found.refused, before) {
        (Some(why), _) => format!("cannot be flown: {why}"),
        (None, true) => "was finished; --json has it".to_owned(),
        (None, false) => format!("flown and kept, with {} others that are flown together", own.len() - 1),
    };
    show::summary(common, &format!("{name}: {outcome}\n"));
    show::json(common, &found)
}

/// What cases share, made and kept for each state of loading in turn before many processes begin.
fn prepare(flights: &Flights<'_>, common: &Common) -> Result<(), Failure> {
    merging::one_state(&flights.store)?;
    let row = flights.row();
    let mut moves: BTreeMap<Frame, bool> = BTreeMap::new();
    for case in &row {
        *moves.entry(flights.frame(case.number)).or_default() |= case.is_late;
    }
    for (frame, moves) in moves {
        flights.states.with(frame, moves, |loaded| Ok(flights.plan.check_names(loaded.tools)?))?;
    }
    let (files, bytes) = flights.shared.size();
    let text = format!(
        "{} cases in {} states of loading; all names are known, and nothing in {} is of another state; \
         {files} files of {:.1} MB there spare parts what cases share\n",
        row.len(),
        flights.design.masses.len(),
        flights.store.folder().display(),
        bytes as f64 / 1e6
    );
    show::summary(common, &text);
    Ok(())
}

/// The first, the middle and the last case of the row, flown with what is flown together with them and some that share their
/// factorisation, and what all will take.
fn estimate(flights: &Flights<'_>, common: &Common, start: Instant) -> Result<Estimate, Failure> {
    let row = share_of(flights.row(), ALL);
    let mut own: BTreeSet<Weighed> = BTreeSet::new();
    for case in [0, row.len() / 2, row.len() - 1].map(|at| row[at]) {
        own.extend(row.iter().filter(|other| other.unit == case.unit));
        let alike = row.iter().filter(|other| (other.group, other.is_late) == (case.group, case.is_late));
        own.extend(alike.filter(|other| other.unit == other.hash).take(ESTIMATED));
    }
    let own: Vec<Weighed> = own.into_iter().collect();
    flights.fly(&own, common)?;
    let told: Vec<(Weighed, Told)> =
        own.iter().filter_map(|case| Some((*case, flights.store.told_of(case.hash)?))).collect();
    Ok(Estimate::of_some(&row, &told, start))
}
