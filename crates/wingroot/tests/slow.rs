//! Tests that take minutes.

use std::io::Write as _;

/// Whether `RUN_SLOW_TESTS=1` asks for them; where it does not, what it would run is said.
pub(crate) fn runs(what: &str) -> bool {
    let is_asked = std::env::var_os("RUN_SLOW_TESTS").is_some();
    if !is_asked {
        // past the capture of tests that pass
        let _ = writeln!(std::io::stderr(), "skipped: RUN_SLOW_TESTS=1 {what}");
    }
    is_asked
}
