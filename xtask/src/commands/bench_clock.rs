//! How `bench` measures time and memory.

use std::time::Instant;

use serde_json::{Value, json};

use wingroot::failure::Failure;

/// Each step is run once to warm up and then this often; the median counts.
pub(super) const REPEATS: usize = 7;

/// A row of the table.
pub(super) fn row(name: &str, seconds: f64) -> Value {
    json!({ "name": name, "seconds": seconds })
}

/// Median wall time of a step.
pub(super) fn median(mut step: impl FnMut() -> Result<(), Failure>) -> Result<f64, Failure> {
    step()?;
    let mut times = Vec::with_capacity(REPEATS);
    for _ in 0..REPEATS {
        let start = Instant::now();
        step()?;
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    Ok(times[REPEATS / 2])
}

/// Processor time of all threads of this process so far, s: unlike the clock's it does not depend on what else the machine does;
/// zero where the system does not say.
pub(super) fn cpu_seconds() -> f64 {
    let ticks = || {
        let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
        // the name in brackets may have blanks; user and system time are the 12th and 13th field after it
        let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
        Some(fields.get(11)?.parse::<f64>().ok()? + fields.get(12)?.parse::<f64>().ok()?)
    };
    ticks().unwrap_or(0.0) / TICKS_PER_S
}

/// Linux counts processor time in hundredths of a second.
const TICKS_PER_S: f64 = 100.0;

/// Largest memory of this process so far, MB; none where the system does not say.
pub(super) fn peak_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches(" kB").trim().parse::<f64>().ok().map(|kb| kb / 1024.0)
}
