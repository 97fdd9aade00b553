//! The time of `discover` on a blind case of 37 runs, each flown twice, and of its null distribution.

use serde_json::{Value, json};

use super::bench_clock::row;
use wingroot::commands::hidden::timed_case;
use wingroot::failure::Failure;

/// One case, once: its searches differ, their medians would not say more.
pub(crate) fn rows() -> Result<Vec<Value>, Failure> {
    let folder = std::env::temp_dir().join(format!("wingroot_bench_{}", std::process::id()));
    let timed = timed_case(&folder)?;
    let mut case = row("discover_case_of_37_runs_twice", timed.seconds);
    case["model_runs"] = json!(timed.model_runs);
    case["model_runs_an_effect"] = json!(timed.model_runs as f64 / timed.effects as f64);
    Ok(vec![case, row("discover_null_distribution_of_20_campaigns", timed.nulls_seconds)])
}
