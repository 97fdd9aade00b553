//! Cases of `fullaircraft --cases` flown on all threads, each kept as soon as it is there; nothing of them stays in memory.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use fullaircraft::cases::list::Grid;
use fullaircraft::trim::model::FlightModel;
use fullaircraft::{Case, CaseFlight, CaseResult, FlightAir, LiftLimits, TrimTools};
use indicatif::ProgressBar;
use rayon::prelude::*;

use crate::args::Common;
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::progress;
use crate::store::{Shared, Store, Told};
use crate::sweep::split::Weighed;

/// Name of the command in results.
pub(crate) const COMMAND: &str = "fullaircraft --cases";
/// Trims that a thread takes at once.
const TRIMS_AT_ONCE: usize = 16;

/// Everything that cases are flown and kept with.
pub(crate) struct Flying<'a> {
    /// The cases.
    pub(crate) grid: Grid,
    /// Shared by all trims.
    pub(crate) tools: &'a TrimTools<'a>,
    /// Initial and updated model.
    pub(crate) models: [&'a FlightModel<'a>; 2],
    /// Lift limits of the section, for warnings.
    pub(crate) limits: Option<&'a [LiftLimits]>,
    /// What is finished.
    pub(crate) store: Store,
    /// What all cases share, where it is kept.
    pub(crate) shared: &'a Shared,
    /// Options of every command.
    pub(crate) common: &'a Common,
}

/// How many cases were flown.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flown {
    /// Finished before.
    pub(crate) before: usize,
    /// Flown now, and found impossible.
    pub(crate) refused: usize,
}

/// What a case is called in the store: its number is its place in a list, which may be another next time.
fn part(case: &Case) -> String {
    format!("{} {:?} {:?}", case.model, case.v_m_s, case.action)
}

impl Flying<'_> {
    /// All cases with what they cost and share.
    pub(crate) fn row(&self) -> Vec<Weighed> {
        let weighed = |case: Case| Weighed {
            is_late: case.is_dynamic(),
            group: Fingerprint::default().with(&[u8::from(case.model > 0)]).with(&case.v_m_s.to_le_bytes()),
            hash: Store::hash(&part(&case)),
            cost: case.cost(),
            number: case.number,
        };
        self.grid.cases().map(weighed).collect()
    }

    /// The result of a case, if it is finished.
    pub(crate) fn kept(&self, number: usize) -> Option<CaseResult> {
        let result = self.store.get(&part(&self.grid.case(number)))?;
        Some(CaseResult { number, ..result })
    }

    /// Hashes of cases that are not finished, sorted.
    pub(crate) fn missing(&self) -> Vec<Fingerprint> {
        let parts = self.grid.cases().map(|case| part(&case));
        let mut missing: Vec<Fingerprint> =
            parts.filter(|part| !self.store.has(part)).map(|part| Store::hash(&part)).collect();
        missing.sort_unstable();
        missing.dedup();
        missing
    }

    /// Flies those cases of a sorted row that are not finished. What needs no unsteady air comes first: it is kept before that
    /// air is prepared, which takes longest.
    pub(crate) fn fly(&self, row: &[Weighed]) -> Result<Flown, Failure> {
        let is_missing = |case: &&Weighed| !self.store.has(&part(&self.grid.case(case.number)));
        let missing: Vec<Weighed> = row.iter().filter(is_missing).copied().collect();
        let bar = progress::bar(self.common, missing.len(), "cases");
        let refused = AtomicUsize::new(0);
        for is_late in [false, true] {
            let cases: Vec<Weighed> =
                missing.iter().filter(|case| case.is_late == is_late).copied().collect();
            let air = if is_late && !cases.is_empty() { Some(self.air()?) } else { None };
            let flight = self.flight(air.as_ref());
            let groups: Vec<&[Weighed]> = cases.chunk_by(|a, b| a.group == b.group).collect();
            groups.par_iter().try_for_each(|group| self.fly_group(&flight, group, &bar, &refused))?;
        }
        progress::end(&bar);
        Ok(Flown { before: row.len() - missing.len(), refused: refused.into_inner() })
    }

    /// Flies a case whether it is finished or not; it is kept if it was not.
    pub(crate) fn fly_one(&self, number: usize) -> Result<CaseResult, Failure> {
        let case = self.grid.case(number);
        let air = if case.is_dynamic() { Some(self.air()?) } else { None };
        let flight = self.flight(air.as_ref());
        let start = Instant::now();
        let result = flight.one(&case, &flight.at(&case))?;
        if !self.store.has(&part(&case)) {
            self.keep(&case, &result, start.elapsed().as_secs_f64())?;
        }
        Ok(result)
    }

    /// The unsteady air.
    pub(crate) fn air(&self) -> Result<FlightAir, Failure> {
        Ok(FlightAir::kept(self.tools.aircraft, self.shared)?)
    }

    fn flight<'b>(&'b self, air: Option<&'b FlightAir>) -> CaseFlight<'b> {
        CaseFlight { tools: self.tools, models: self.models, air, limits: self.limits }
    }

    /// Flies cases of one model at one airspeed.
    fn fly_group(
        &self,
        flight: &CaseFlight<'_>,
        group: &[Weighed],
        bar: &ProgressBar,
        refused: &AtomicUsize,
    ) -> Result<(), Failure> {
        let Some(first) = group.first() else { return Ok(()) };
        let at = flight.at(&self.grid.case(first.number));
        let at_once = if first.is_late { 1 } else { TRIMS_AT_ONCE };
        group.par_iter().with_min_len(at_once).try_for_each(|case| {
            let start = Instant::now();
            let case = self.grid.case(case.number);
            let result = flight.one(&case, &at)?;
            refused.fetch_add(usize::from(result.refused.is_some()), Ordering::Relaxed);
            self.keep(&case, &result, start.elapsed().as_secs_f64())?;
            bar.inc(1);
            Ok(())
        })
    }

    fn keep(&self, case: &Case, result: &CaseResult, seconds: f64) -> Result<(), Failure> {
        let told = Told { part: part(case), seconds: Some(seconds), failed: result.refused.clone() };
        self.store.put_told(&told, &CaseResult { number: 0, ..result.clone() })
    }
}
