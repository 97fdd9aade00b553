//! Which motion of a deck in its flow takes longest to decay, in words.

use faer::c64;
use std::f64::consts::{LN_2, TAU};

/// A root grows if its real part is more than this share of its size, and its size more than this share of the largest: zero found twice
/// is a small pair.
pub(super) const GROWS: f64 = 1e-6;

/// The motion among roots that takes longest to decay, and what can be done.
pub(super) fn slowest_words(roots: &[c64]) -> String {
    let decaying = roots.iter().filter(|p| p.re < -GROWS * p.norm());
    match decaying.max_by(|a, b| a.re.total_cmp(&b.re)) {
        Some(p) if p.im != 0.0 => format!(
            "the air alone gives the motion at {:.3} Hz {:.4} % of critical damping; structural damping is PARAM G, or SDAMPING with TABDMP1",
            p.im.abs() / TAU,
            -100.0 * p.re / p.norm()
        ),
        Some(p) => format!("a motion without oscillation takes {:.0} s to halve", LN_2 / -p.re),
        None => "no motion decays".to_owned(),
    }
}

#[cfg(test)]
mod tests;
