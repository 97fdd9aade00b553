//! What was solved at a frequency, kept for all who ask for the same: wings of one lattice with other structures or corrections.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Most memory that it takes, bytes; what does not fit is solved again each time.
const MOST_BYTES: usize = 256 << 20;

/// Solutions by frequency.
#[derive(Debug)]
pub(super) struct Kept<T> {
    by_frequency: Mutex<HashMap<u64, Arc<T>>>,
}

impl<T> Kept<T> {
    /// Nothing yet.
    pub(super) fn new() -> Self {
        Self { by_frequency: Mutex::default() }
    }

    /// The solution at a frequency, 1/m, of so many complex numbers.
    pub(super) fn at<E>(
        &self,
        omega_over_v: f64,
        numbers: usize,
        solve: impl FnOnce() -> Result<T, E>,
    ) -> Result<Arc<T>, E> {
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

    #[test]
    fn what_would_take_more_than_the_most_memory_is_solved_again() {
        let solutions = |numbers: usize, frequencies: u32| {
            let (kept, mut count) = (Kept::new(), 0);
            for omega_over_v in (0..frequencies).chain(0..frequencies).map(f64::from) {
                let solve = || {
                    count += 1;
                    Ok::<f64, ()>(10.0 * omega_over_v)
                };
                assert_eq!(
                    kept.at(omega_over_v, numbers, solve).map(|solved| *solved),
                    Ok(10.0 * omega_over_v)
                );
            }
            count
        };
        assert_eq!(solutions(4, 5), 5);
        // 64 MB each: four are kept, the fifth is solved twice
        assert_eq!(solutions(2048 * 2048, 5), 6);
        assert_eq!(solutions(100_000 * 100_000, 1), 2);
        let kept = Kept::<f64>::new();
        assert_eq!(kept.at(1.0, 4, || Err("singular")), Err("singular"));
        assert_eq!(
            kept.at(1.0, 4, || Ok::<f64, ()>(2.0)).map(|solved| *solved),
            Ok(2.0),
            "errors are not kept"
        );
    }
}
