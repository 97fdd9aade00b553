//! Comparison with a reference.

use serde_json::Value;

/// Compares with a reference, relative to it.
pub(crate) fn close(ours: f64, reference: &Value, rel: f64, what: &str) {
    let reference = reference.as_f64().unwrap_or_else(|| panic!("{what}: {reference} is no number"));
    let most = rel * reference.abs().max(1e-12);
    assert!((ours - reference).abs() <= most, "{what}: {ours} beside {reference}");
}
