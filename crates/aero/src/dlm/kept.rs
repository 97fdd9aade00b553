//! Factors of a lattice by frequency, kept for all who ask for the same: wings of one lattice with other structures or corrections.

use super::oscillatory::OscillatoryAero;
use crate::error::AeroError;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Most memory that they take, bytes; what does not fit is solved again each time.
const MOST_BYTES: usize = 256 << 20;

/// See the module.
#[derive(Debug, Default)]
pub(super) struct Kept {
    by_frequency: Mutex<HashMap<u64, Arc<OscillatoryAero>>>,
}

impl Kept {
    /// The factors at a frequency, 1/m, with so many numbers.
    pub(super) fn at(
        &self,
        omega_over_v: f64,
        numbers: usize,
        solve: impl FnOnce() -> Result<OscillatoryAero, AeroError>,
    ) -> Result<Arc<OscillatoryAero>, AeroError> {
        let kept = || self.by_frequency.lock().unwrap_or_else(PoisonError::into_inner);
        let key = omega_over_v.to_bits();
        if let Some(known) = kept().get(&key) {
            return Ok(Arc::clone(known));
        }
        let solved = Arc::new(solve()?);
        let mut kept = kept();
        let each = size_of::<faer::c64>() * numbers;
        if (kept.len() + 1) * each <= MOST_BYTES {
            kept.insert(key, Arc::clone(&solved));
        }
        Ok(solved)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DlmSettings, DoubletLattice, Lattice, MirrorPlane};

    #[test]
    fn what_would_take_more_than_the_most_memory_is_solved_again() {
        let lattice =
            Lattice::trapezoid(1, [0.0, 0.1, 0.0], 1.0, [0.0, 2.0, 0.0], 1.0, [1, 2]).expect("boxes");
        let doublets = DoubletLattice::new(&lattice, MirrorPlane::None, 0.0, &DlmSettings::default());
        let solved = doublets.expect("a lattice").at(1.0).expect("factors");
        let solutions = |numbers: usize, frequencies: u32| {
            let (kept, mut count) = (Kept::default(), 0);
            for omega_over_v in (0..frequencies).chain(0..frequencies).map(f64::from) {
                let solve = || {
                    count += 1;
                    Ok(solved.as_ref().clone())
                };
                kept.at(omega_over_v, numbers, solve).expect("factors");
            }
            count
        };
        assert_eq!(solutions(4, 5), 5);
        // 64 MB each: four are kept, the fifth is solved twice
        assert_eq!(solutions(2048 * 2048, 5), 6);
        assert_eq!(solutions(100_000 * 100_000, 1), 2);
    }
}
