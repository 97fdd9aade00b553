//! How far a sweep is: what is finished and what is left, failures by their words, and the slowest cases.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Serialize;

use crate::common::Common;
use crate::failure::Failure;
use crate::show;
use crate::store::{Store, Told};
use crate::sweep::merging;
use crate::sweep::split::Weighed;

/// Slowest cases that are shown, and failures of one kind.
const SHOWN: usize = 5;

/// How far a sweep is.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Status {
    /// Name of the command.
    command: &'static str,
    /// Cases of the sweep; those that are the same count once.
    cases: usize,
    /// Finished cases, failures among them.
    finished: usize,
    /// Cases that could not be computed, by why.
    failures: BTreeMap<String, Vec<One>>,
    /// The slowest cases.
    slowest: Vec<One>,
    /// Time of all finished cases together, s.
    seconds: f64,
    /// What the others will take by the costs of the table, s; left out if nothing is finished.
    #[serde(skip_serializing_if = "Option::is_none")]
    seconds_left: Option<f64>,
    /// Segments of other inputs, with what differs.
    other_inputs: Vec<String>,
    /// Records that are damaged.
    damaged: usize,
}

/// A finished case.
#[derive(Debug, Clone, Serialize, JsonSchema)]
struct One {
    /// Its hash, for `--case`.
    hash: String,
    /// What it is.
    case: String,
    /// What it took, s; left out if it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    seconds: Option<f64>,
}

impl One {
    fn of(told: &Told) -> Self {
        Self { hash: Store::hash(&told.part).to_string(), case: told.part.clone(), seconds: told.seconds }
    }
}

/// Looks through a store for the cases of a sweep.
pub fn status(command: &'static str, store: &Store, mut all: Vec<Weighed>) -> Status {
    all.sort_unstable();
    all.dedup_by_key(|case| case.hash);
    let costs: HashMap<_, u64> = all.iter().map(|case| (case.hash, case.cost)).collect();
    let (mut cost, mut failures) = (0, BTreeMap::<String, Vec<One>>::new());
    let mut status = Status { command, cases: costs.len(), ..Status::default() };
    store.told(|told| {
        let Some(own) = costs.get(&Store::hash(&told.part)) else { return };
        status.finished += 1;
        cost += own;
        status.seconds += told.seconds.unwrap_or(0.0);
        if let Some(why) = &told.failed {
            failures.entry(why.clone()).or_default().push(One::of(&told));
        }
        status.slowest.push(One::of(&told));
        if status.slowest.len() > 4 * SHOWN {
            keep_slowest(&mut status.slowest);
        }
    });
    keep_slowest(&mut status.slowest);
    status.failures = failures;
    let left: u64 = costs.values().sum::<u64>() - cost;
    status.seconds_left = (cost > 0).then(|| status.seconds * left as f64 / cost as f64);
    let standing = store.standing();
    status.damaged = standing.damaged;
    status.other_inputs = standing
        .foreign
        .iter()
        .map(|foreign| format!("{}: another {}", foreign.path.display(), foreign.differs.join(", ")))
        .collect();
    status
}

fn keep_slowest(all: &mut Vec<One>) {
    all.sort_by(|a, b| b.seconds.unwrap_or(0.0).total_cmp(&a.seconds.unwrap_or(0.0)));
    all.truncate(SHOWN);
}

/// Shows how far a sweep is.
///
/// # Errors
/// If nothing can be printed.
pub fn show(common: &Common, store: &Store, status: &Status) -> Result<(), Failure> {
    merging::remarks(store);
    let mut text = format!("{} of {} cases are finished", status.finished, status.cases);
    // Writing to a String cannot fail.
    let failed: usize = status.failures.values().map(Vec::len).sum();
    let _ = write!(text, ", {failed} of them not to be computed; {:.1} s of one thread", status.seconds);
    match status.seconds_left {
        Some(left) if status.finished < status.cases => {
            let _ = writeln!(text, ", some {left:.0} s left");
        }
        _ => text.push('\n'),
    }
    for (why, cases) in &status.failures {
        let _ = writeln!(text, "{} not computed: {why}", cases.len());
        for one in cases.iter().take(SHOWN) {
            let _ = writeln!(text, "    --case {}  {}", one.hash, one.case);
        }
    }
    if !status.slowest.is_empty() {
        text += "the slowest:\n";
    }
    for one in &status.slowest {
        let _ = writeln!(text, "    {:9.4} s  --case {}  {}", one.seconds.unwrap_or(0.0), one.hash, one.case);
    }
    for other in &status.other_inputs {
        let _ = writeln!(text, "not of this sweep: {other}");
    }
    show::summary(common, &text);
    show::json(common, status)
}
