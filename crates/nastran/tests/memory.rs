//! The memory there is, and the refusal of what needs more.

use nastran::memory::{available, demand};
use std::fs::read_to_string;

/// What Linux has available, bytes; none on other systems.
fn of_the_system() -> Option<f64> {
    let text = read_to_string("/proc/meminfo").ok()?;
    let mut words = text.split_whitespace().skip_while(|word| *word != "MemAvailable:");
    Some(1024.0 * words.nth(1)?.parse::<f64>().ok()?)
}

/// Whether the process or its control group may take all that the system has.
fn is_unlimited() -> bool {
    let limits = read_to_string("/proc/self/limits").unwrap_or_default();
    let addresses = limits.lines().find_map(|line| line.strip_prefix("Max address space"));
    let group = read_to_string("/sys/fs/cgroup/memory.max").unwrap_or_default();
    addresses.is_some_and(|most| most.trim_start().starts_with("unlimited"))
        && group.trim().parse::<u64>().is_err()
}

#[test]
fn the_least_of_what_there_is_counts() {
    let ours = available() as f64;
    assert!(ours > 1e6);
    // within a factor of two: others take memory and give it back meanwhile
    if let Some(system) = of_the_system() {
        assert!(ours <= 2.0 * system, "{ours} of {system}");
        assert!(ours >= 0.5 * system || !is_unlimited(), "{ours} of {system}");
    }
}

#[test]
fn more_than_there_is_is_refused_with_both_numbers() {
    demand("one number", 8.0).unwrap();
    let error = demand("20000 boxes", 1e18).unwrap_err();
    assert!(error.message.starts_with("20000 boxes take about 1000000.0 TB of memory, and "), "{error}");
}
