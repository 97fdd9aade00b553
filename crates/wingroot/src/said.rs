//! What a command says, kept for who runs it instead of printed ([`crate::embedded`]).

use std::sync::{Mutex, MutexGuard, PoisonError};

/// What a command would have printed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Said {
    /// Its summary.
    pub summary: String,
    /// Remarks and warnings.
    pub notes: Vec<String>,
}

static COLLECTED: Mutex<Option<Said>> = Mutex::new(None);

fn all() -> MutexGuard<'static, Option<Said>> {
    COLLECTED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Keeps what is said from now on instead of printing it.
pub(crate) fn collect() {
    *all() = Some(Said::default());
}

/// What was said since [`collect`]; from now on it is printed again.
pub(crate) fn collected() -> Said {
    all().take().unwrap_or_default()
}

/// Keeps something that would be printed; false if it is to be printed.
pub(crate) fn kept(keep: impl FnOnce(&mut Said)) -> bool {
    all().as_mut().map(keep).is_some()
}
