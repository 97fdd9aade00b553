//! Cases of `fullaircraft --cases` flown on all threads, each kept as soon as it is there; nothing of them stays in memory.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use fullaircraft::cases::list::{Grid, MODELS};
use fullaircraft::trim::model::FlightModel;
use fullaircraft::{Aircraft, Case, CaseFlight, CaseResult, FlightAir, LiftLimits, TrimTools};
use indicatif::ProgressBar;
use rayon::prelude::*;

use crate::args::Common;
use crate::commands::fullaircraft_draws::{Draw, Draws, Flies};
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
    /// Trims of the updated model's own aircraft, if another structure was found than that as given.
    pub(crate) found: Option<&'a TrimTools<'a>>,
    /// Lift limits of the section, for warnings.
    pub(crate) limits: Option<&'a [LiftLimits]>,
    /// What is finished.
    pub(crate) store: Store,
    /// What all cases share, where it is kept.
    pub(crate) shared: &'a Shared,
    /// Options of every command.
    pub(crate) common: &'a Common,
    /// Wings as likely as the calibrated one.
    pub(crate) draws: Draws<'a>,
}

/// An aircraft that cases are flown with: its trims, and both models or one twice.
struct Frame<'b> {
    tools: &'b TrimTools<'b>,
    models: [&'b FlightModel<'b>; 2],
}

/// What is told while cases are flown.
struct Counted<'b> {
    bar: &'b ProgressBar,
    refused: &'b AtomicUsize,
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
fn part(draw: Option<usize>, case: &Case) -> String {
    let flown = match draw {
        None => case.model.to_string(),
        Some(draw) => format!("draw {}", draw + 1),
    };
    format!("{flown} {:?} {:?}", case.v_m_s, case.action)
}

impl Flying<'_> {
    /// How many cases there are, those of draws among them.
    pub(crate) fn count(&self) -> usize {
        self.grid.len() + self.draws.count() * self.of_a_draw()
    }

    /// Cases of a draw: those of the updated model, which are the second half of the grid's.
    pub(crate) fn of_a_draw(&self) -> usize {
        self.grid.len() / MODELS.len()
    }

    /// The draw that a number is of, and the case: beyond the grid's numbers are those of the draws.
    pub(crate) fn case(&self, number: usize) -> (Option<usize>, Case) {
        let (own, of_a_draw) = (self.grid.len(), self.of_a_draw());
        match number.checked_sub(own) {
            None => (None, self.grid.case(number)),
            Some(beyond) => (Some(beyond / of_a_draw), self.grid.case(own - of_a_draw + beyond % of_a_draw)),
        }
    }

    /// Whose aircraft flies a case.
    fn flies(&self, draw: Option<usize>, case: &Case) -> Flies {
        match draw {
            Some(draw) => Flies::Draw(draw),
            None if case.model > 0 && self.found.is_some() => Flies::Found,
            None => Flies::Given,
        }
    }

    fn part(&self, number: usize) -> String {
        let (draw, case) = self.case(number);
        part(draw, &case)
    }

    /// All cases with what they cost and share.
    pub(crate) fn row(&self) -> Vec<Weighed> {
        let weighed = |number: usize| {
            let (draw, case) = self.case(number);
            let hash = Store::hash(&part(draw, &case));
            let frame = Fingerprint::default();
            Weighed {
                frame: match self.flies(draw, &case) {
                    Flies::Given => frame,
                    Flies::Found => frame.with(b"found"),
                    Flies::Draw(draw) => frame.with(&draw.to_le_bytes()),
                },
                is_late: case.is_dynamic(),
                group: frame.with(&[u8::from(case.model > 0)]).with(&case.v_m_s.to_le_bytes()),
                unit: hash,
                hash,
                cost: case.cost(),
                number,
            }
        };
        (0..self.count()).map(weighed).collect()
    }

    /// The result of a case, if it is finished.
    pub(crate) fn kept(&self, number: usize) -> Option<CaseResult> {
        let result = self.store.get(&self.part(number))?;
        Some(CaseResult { number: self.case(number).1.number, ..result })
    }

    /// Hashes of cases that are not finished, sorted.
    pub(crate) fn missing(&self) -> Vec<Fingerprint> {
        let parts = (0..self.count()).map(|number| self.part(number));
        let mut missing: Vec<Fingerprint> =
            parts.filter(|part| !self.store.has(part)).map(|part| Store::hash(&part)).collect();
        missing.sort_unstable();
        missing.dedup();
        missing
    }

    /// Flies those cases of a sorted row that are not finished, aircraft by aircraft.
    pub(crate) fn fly(&self, row: &[Weighed]) -> Result<Flown, Failure> {
        let is_missing = |case: &&Weighed| !self.store.has(&self.part(case.number));
        let missing: Vec<Weighed> = row.iter().filter(is_missing).copied().collect();
        let bar = progress::bar(self.common, missing.len(), "cases");
        let refused = AtomicUsize::new(0);
        let counted = Counted { bar: &bar, refused: &refused };
        for own in missing.chunk_by(|a, b| a.frame == b.frame) {
            let (draw, case) = self.case(own[0].number);
            self.with_frame(self.flies(draw, &case), |frame| self.fly_frame(frame, own, &counted))?;
        }
        progress::end(&bar);
        Ok(Flown { before: row.len() - missing.len(), refused: refused.into_inner() })
    }

    /// Works with an aircraft.
    fn with_frame<T>(
        &self,
        flies: Flies,
        work: impl FnOnce(&Frame<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let draw = match (flies, self.found) {
            (Flies::Draw(draw), _) => draw,
            (Flies::Found, Some(tools)) => return work(&Frame { tools, models: self.models }),
            _ => return work(&Frame { tools: self.tools, models: self.models }),
        };
        let Draw { mut aircraft, corrections } = self.draws.aircraft(draw)?;
        aircraft.wing.stations.clone_from(&self.tools.aircraft.wing.stations);
        let tools = TrimTools::new(&aircraft, &[])?;
        let model = aircraft.with_corrections(&corrections)?;
        work(&Frame { tools: &tools, models: [&model; 2] })
    }

    /// Flies cases with one aircraft. What needs no unsteady air comes first: it is kept before that air is prepared, which takes longest.
    fn fly_frame(&self, frame: &Frame<'_>, cases: &[Weighed], counted: &Counted<'_>) -> Result<(), Failure> {
        for is_late in [false, true] {
            let cases: Vec<Weighed> = cases.iter().filter(|case| case.is_late == is_late).copied().collect();
            let air = if is_late && !cases.is_empty() { Some(self.air(frame.tools.aircraft)?) } else { None };
            let flight = self.flight(frame, air.as_ref());
            let groups: Vec<&[Weighed]> = cases.chunk_by(|a, b| a.group == b.group).collect();
            groups.par_iter().try_for_each(|group| self.fly_group(&flight, group, counted))?;
        }
        Ok(())
    }

    /// Flies a case whether it is finished or not; it is kept if it was not.
    pub(crate) fn fly_one(&self, number: usize) -> Result<CaseResult, Failure> {
        let (draw, case) = self.case(number);
        self.with_frame(self.flies(draw, &case), |frame| {
            let air = if case.is_dynamic() { Some(self.air(frame.tools.aircraft)?) } else { None };
            let flight = self.flight(frame, air.as_ref());
            let start = Instant::now();
            let result = flight.one(&case, &flight.at(&case))?;
            if !self.store.has(&part(draw, &case)) {
                self.keep(part(draw, &case), &result, start.elapsed().as_secs_f64())?;
            }
            Ok(result)
        })
    }

    /// What cases share of all aircraft, made and kept for other processes; `moves` if a case needs unsteady air.
    pub(crate) fn leave(&self, moves: bool) -> Result<(), Failure> {
        let both = [Some(Flies::Given), self.found.map(|_| Flies::Found)];
        for flies in both.into_iter().flatten().chain((0..self.draws.count()).map(Flies::Draw)) {
            self.with_frame(
                flies,
                |frame| {
                    if moves { self.air(frame.tools.aircraft).map(drop) } else { Ok(()) }
                },
            )?;
        }
        Ok(())
    }

    /// The unsteady air of an aircraft.
    fn air(&self, aircraft: &Aircraft) -> Result<FlightAir, Failure> {
        Ok(FlightAir::kept(aircraft, self.shared)?)
    }

    fn flight<'b>(&'b self, frame: &'b Frame<'b>, air: Option<&'b FlightAir>) -> CaseFlight<'b> {
        CaseFlight { tools: frame.tools, models: frame.models, air, limits: self.limits }
    }

    /// Flies cases of one model at one airspeed.
    fn fly_group(
        &self,
        flight: &CaseFlight<'_>,
        group: &[Weighed],
        counted: &Counted<'_>,
    ) -> Result<(), Failure> {
        let Some(first) = group.first() else { return Ok(()) };
        let at = flight.at(&self.case(first.number).1);
        let at_once = if first.is_late { 1 } else { TRIMS_AT_ONCE };
        group.par_iter().with_min_len(at_once).try_for_each(|case| {
            let start = Instant::now();
            let (draw, case) = self.case(case.number);
            let result = flight.one(&case, &at)?;
            counted.refused.fetch_add(usize::from(result.refused.is_some()), Ordering::Relaxed);
            self.keep(part(draw, &case), &result, start.elapsed().as_secs_f64())?;
            counted.bar.inc(1);
            Ok(())
        })
    }

    fn keep(&self, part: String, result: &CaseResult, seconds: f64) -> Result<(), Failure> {
        let told = Told { part, seconds: Some(seconds), failed: result.refused.clone() };
        self.store.put_told(&told, &CaseResult { number: 0, ..result.clone() })
    }
}
