//! Corrections moved by as much as others differ, within what pressures can be.

use aero::Corrections;

/// Least factor on a box's force: pressures that panel methods have do not turn round.
const LEAST_FORCE: f64 = 0.05;

/// Corrections moved by as much as others differ.
pub(crate) fn moved(centre: &Corrections, to: &Corrections, from: &Corrections) -> Corrections {
    let family = |of: fn(&Corrections) -> &Vec<f64>, least: f64| {
        of(centre)
            .iter()
            .zip(of(to).iter().zip(of(from)))
            .map(|(centre, (to, from))| short((centre + to - from).max(least.min(*centre))))
            .collect()
    };
    Corrections {
        force: family(|c| &c.force, LEAST_FORCE),
        moment: family(|c| &c.moment, f64::NEG_INFINITY),
        pressure_offset: family(|c| &c.pressure_offset, f64::NEG_INFINITY),
    }
}

/// Seven decimals: no spread is known better, and the file stays small.
pub(crate) fn short(value: f64) -> f64 {
    (value * 1e7).round() / 1e7
}
