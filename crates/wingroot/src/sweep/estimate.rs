//! What a sweep will take, from a few of its cases.

use std::fmt::Write as _;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use crate::store::Told;
use crate::sweep::split::Weighed;

/// What was measured with a few cases, and what it comes to.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Estimate {
    /// Cases of the sweep.
    pub cases: usize,
    /// These in words, each with its time, s.
    pub flown: Vec<(String, f64)>,
    /// What a process takes before its first case, s.
    pub setup_s: f64,
    /// All cases on one thread, s.
    pub seconds: f64,
    /// Largest memory of the process that computed them, bytes.
    pub memory_bytes: f64,
}

/// Where a command leaves the estimate that it was asked for.
#[derive(Debug, Clone, Default)]
pub struct Slot(Arc<Mutex<Option<Estimate>>>);

impl Slot {
    /// Leaves it.
    pub fn put(&self, estimate: Estimate) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(estimate);
    }

    /// Takes it.
    pub fn take(&self) -> Option<Estimate> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// Longest time of a part that parts are made for, s: a part that is lost costs this, and many short ones wait in queues.
const PART_S: f64 = 900.0;
/// Most parts: what an array of Slurm has unless it is configured for more.
const MOST_PARTS: f64 = 1000.0;
/// A part may take so many times its estimate, and so much of its memory.
const MARGIN: [f64; 2] = [4.0, 2.0];
/// Computed cases that are shown.
const SHOWN: usize = 3;
/// Least memory of a part, MB.
const LEAST_MB: f64 = 1024.0;

impl Estimate {
    /// Of cases of a row that were computed since `start`, each with what was told of it. Those without and with unsteady air are
    /// taken to the whole row apart: the table's costs are between the two only roughly right.
    pub fn of_some(row: &[Weighed], told: &[(Weighed, Told)], start: Instant) -> Self {
        let flown = told.iter().map(|(_, told)| (told.part.clone(), told.seconds.unwrap_or(0.0)));
        let flown: Vec<(String, f64)> = flown.collect();
        let seconds = [false, true].into_iter().map(|is_late| {
            let cost =
                |cases: &mut dyn Iterator<Item = Weighed>| cases.map(|case| case.cost).sum::<u64>() as f64;
            let own = || told.iter().filter(|(case, _)| case.is_late == is_late);
            let seconds: f64 = own().filter_map(|(_, told)| told.seconds).sum();
            let of_all = cost(&mut row.iter().filter(|case| case.is_late == is_late).copied());
            seconds * of_all / cost(&mut own().map(|(case, _)| *case)).max(1.0)
        });
        let seconds: f64 = seconds.sum();
        let setup_s = start.elapsed().as_secs_f64() - flown.iter().map(|(_, seconds)| seconds).sum::<f64>();
        let memory_bytes = peak_memory_bytes();
        Self { cases: row.len(), flown, setup_s: setup_s.max(0.0), seconds, memory_bytes }
    }

    /// Number of parts of so many threads each.
    pub fn parts(&self, cpus: usize) -> usize {
        let parts = (self.seconds / cpus.max(1) as f64 / PART_S).ceil().clamp(1.0, MOST_PARTS);
        rounded(parts).min(self.cases.max(1))
    }

    /// What one part is expected to take, s.
    pub fn part_s(&self, parts: usize, cpus: usize) -> f64 {
        self.setup_s + self.seconds / (parts.max(1) * cpus.max(1)) as f64
    }

    /// Time that a part may take, minutes.
    pub fn part_minutes(&self, parts: usize, cpus: usize) -> usize {
        rounded((MARGIN[0] * self.part_s(parts, cpus) / 60.0).ceil().max(10.0))
    }

    /// Memory that a part may take, MB.
    pub fn memory_mb(&self) -> usize {
        rounded((MARGIN[1] * self.memory_bytes / 1e6).max(LEAST_MB).ceil())
    }

    /// The estimate as comments of a script.
    pub fn lines(&self, parts: usize, cpus: usize) -> String {
        let mut text = format!(
            "# {} cases. {} were computed for this estimate, and are kept; the slowest:\n",
            self.cases,
            self.flown.len()
        );
        let mut flown: Vec<&(String, f64)> = self.flown.iter().collect();
        flown.sort_by(|a, b| b.1.total_cmp(&a.1));
        for (case, seconds) in flown.into_iter().take(SHOWN) {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "#   {seconds:9.4} s  {case}");
        }
        let _ = writeln!(
            text,
            "# All on one thread: {:.0} s, and {:.1} s of each process before its first case. {parts} parts with {cpus} threads: some {:.0} s each,\n\
             # allowed {} times that, and {} MB (used here: {:.0} MB).",
            self.seconds,
            self.setup_s,
            self.part_s(parts, cpus),
            MARGIN[0],
            self.memory_mb(),
            self.memory_bytes / 1e6
        );
        text.trim_end().to_owned()
    }
}

/// Largest memory of this process, bytes, where the system tells (Linux); else what a small aircraft takes.
pub fn peak_memory_bytes() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().strip_suffix(" kB")?.trim().parse::<f64>().ok());
    kilobytes.map_or(0.5e9, |kilobytes| 1024.0 * kilobytes)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "positive and bounded by its callers"
)]
fn rounded(value: f64) -> usize {
    value.round().clamp(0.0, 1e9) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_as_many_as_quarters_of_an_hour() {
        let of = |seconds: f64| Estimate { cases: 5000, seconds, setup_s: 10.0, ..Estimate::default() };
        assert_eq!(of(3600.0).parts(1), 4);
        assert_eq!(of(3600.0).parts(4), 1);
        assert_eq!(of(1e9).parts(1), 1000);
        assert_eq!(of(3600.0).part_s(4, 1), 910.0);
        assert_eq!(of(3600.0).part_minutes(4, 1), 61);
        assert_eq!(of(0.0).memory_mb(), 1024);
    }
}
