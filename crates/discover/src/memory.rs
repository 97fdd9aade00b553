//! Changes that were flown around one current model: they depend on its effects and on what was commanded, not on what was
//! measured, so that other measurements of the same points and runs need not fly them again.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Effect, form, sizes.
pub(crate) type Key = (&'static str, &'static str, Vec<u64>);

/// See the module.
#[derive(Debug, Default)]
pub(crate) struct Memory(Mutex<HashMap<Key, Arc<Vec<f64>>>>);

impl Memory {
    fn locked(&self) -> MutexGuard<'_, HashMap<Key, Arc<Vec<f64>>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What is kept for a key, flown now if nothing is.
    pub(crate) fn change(&self, key: Key, flown: impl FnOnce() -> Vec<f64>) -> Arc<Vec<f64>> {
        if let Some(known) = self.locked().get(&key) {
            return Arc::clone(known);
        }
        let change = Arc::new(flown());
        self.locked().insert(key, Arc::clone(&change));
        change
    }
}
