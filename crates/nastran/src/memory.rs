//! The memory there is, so that work too large for the machine is refused in a sentence before it begins.
//!
//! On Linux it is the least of what the system has available, what the process may still take (`ulimit -v`) and what
//! its control group leaves; elsewhere [`ASSUMED`] is taken.

use crate::source::InputError;

/// What is taken where the system does not say: the memory of a small computer, bytes.
pub const ASSUMED: u64 = 8_000_000_000;

/// Bytes that can still be taken.
pub fn available() -> u64 {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let system = after(&read("/proc/meminfo"), "MemAvailable:").map(|kilobytes| 1024 * kilobytes);
    let in_use = || after(&read("/proc/self/status"), "VmSize:").map_or(0, |kilobytes| 1024 * kilobytes);
    let process =
        after(&read("/proc/self/limits"), "Max address space").map(|most| most.saturating_sub(in_use()));
    let number = |name: &str| read(&format!("/sys/fs/cgroup/{name}")).trim().parse::<u64>().ok();
    let group = number("memory.max").map(|most| most.saturating_sub(number("memory.current").unwrap_or(0)));
    [system, process, group].into_iter().flatten().min().unwrap_or(ASSUMED)
}

/// The number behind a name in a text of the system; none if there is no such line or no number (`unlimited`).
fn after(text: &str, name: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next()?.parse().ok()
}

/// Refuses work that takes more than the memory there is; `what` says what it is ("20000 boxes").
///
/// # Errors
/// If `bytes` are more than [`available`].
pub fn demand(what: &str, bytes: f64) -> Result<(), InputError> {
    let there = available() as f64;
    if bytes <= there {
        return Ok(());
    }
    let message = format!("{what} take about {} of memory, and {} are free", words(bytes), words(there));
    Err(InputError::general(message).with_help("make it smaller, or use a computer with more memory"))
}

/// Bytes in words.
pub(crate) fn words(bytes: f64) -> String {
    let (unit, name) =
        [(1e12, "TB"), (1e9, "GB")].into_iter().find(|(unit, _)| bytes >= *unit).unwrap_or((1e6, "MB"));
    format!("{:.1} {name}", bytes / unit)
}
