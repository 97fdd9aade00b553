//! The scorer: answers beside verdicts, as metrics with intervals and a table of confusions.

mod costs;
mod families;
mod gates;
mod judged;
mod metric;
mod naming;
mod parameters;
mod wilson;

pub use families::Families;
pub use gates::{Bound, Gate, gates};
pub use metric::{Metric, Metrics};
pub use wilson::wilson;

use crate::answer::Answer;
use crate::class::Class;
use discover::result::DiscoverResult;
use judged::Judged;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// `result.json` of the benchmark.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BenchmarkResult {
    /// Name of the command.
    pub command: String,
    /// Seed of the list of cases.
    pub seed: u64,
    /// The one class of all cases, if they are of one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub class: Option<Class>,
    /// A: corrections from static points without the effects; B: from each case's own.
    pub track: String,
    /// Which program made the campaigns: `doublet`, the model's library with another mesh, or `vortex`, one of its own.
    pub truth: String,
    /// What is measured.
    #[serde(flatten)]
    pub scored: Metrics,
    /// The acceptance criteria beside it.
    pub gates: Vec<Gate>,
    /// Time it took, s.
    pub seconds: f64,
}

/// Scores verdicts against answers, one a case.
pub fn score(cases: &[(Answer, DiscoverResult)], families: &Families) -> Metrics {
    let judged: Vec<Judged<'_>> =
        cases.iter().map(|(answer, verdict)| Judged { answer, verdict, families }).collect();
    let mut metrics = BTreeMap::new();
    naming::add(&judged, &mut metrics);
    parameters::add(&judged, &mut metrics);
    costs::add(&judged, &mut metrics);
    let mut confusion: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
    for case in &judged {
        *confusion.entry(case.hidden_as()).or_default().entry(case.answered_as()).or_default() += 1;
    }
    Metrics { cases: cases.len(), metrics, confusion }
}
