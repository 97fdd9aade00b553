//! How many natural frequencies lie below a given one, without computing any.
//!
//! By Sylvester's law of inertia K - omega^2 M = L D L^T has as many negative pivots as there are eigenvalues below
//! omega^2 (Bathe, *Finite Element Procedures*, ch. 10). The factorisation does not pivot: close to an eigenvalue
//! of the matrix or of a leading block of it a pivot may be within round-off, and its sign means nothing. Then the
//! shift is moved by a few millionths, and if that does not help the count is refused.

use crate::factor::{Factor, Room, Scaled};
use crate::modes::ModesError;
use crate::sparse;
use crate::system::System;

/// Relative changes of the shift that are tried, one after the other.
const NUDGES: [f64; 5] = [0.0, 1e-6, -1e-6, 3e-6, -3e-6];

/// The number of natural frequencies below `omega_rad_s`, each counted as often as it occurs; rigid motions count
/// as zero frequencies.
///
/// # Errors
/// If the pivots stay too small to count, as for a motion with neither stiffness nor mass.
pub fn count_below(system: &System, omega_rad_s: f64) -> Result<usize, ModesError> {
    // A frequency is not negative; below zero there is none (and NaN is none either).
    if omega_rad_s.is_nan() || omega_rad_s <= 0.0 {
        return Ok(0);
    }
    count_below_square(system, omega_rad_s * omega_rad_s, Room::default())
}

/// Eigenvalues of K x = lambda M x below a positive `shift`, by a factor in the room of another one.
pub(crate) fn count_below_square(system: &System, shift: f64, mut room: Room) -> Result<usize, ModesError> {
    let (k, m) = (system.stiffness(), system.mass());
    let mass = sparse::diagonal(m);
    for nudge in NUDGES {
        let shift = shift * (1.0 + nudge);
        let size: Vec<f64> =
            sparse::diagonal(k).iter().zip(&mass).map(|(k, m)| k.abs() + shift * m).collect();
        let shifted = Scaled::of(k.symbolic(), sparse::combine(k, -shift, m), &size);
        let Some(factor) = Factor::indefinite(system.analysis(), &shifted, std::mem::take(&mut room)) else {
            continue;
        };
        if factor.is_certain {
            return Ok(factor.pivots().iter().filter(|(_, pivot)| *pivot < 0.0).count());
        }
        room = factor.into_room();
    }
    Err(ModesError::Uncountable { omega_rad_s: shift.sqrt() })
}
