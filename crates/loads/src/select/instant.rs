//! Loads at an instant, which are selected from.

use super::file::Model;

/// Loads at one instant of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Instant {
    /// Model.
    pub model: Model,
    /// Number of the case.
    pub case: usize,
    /// Number within the case, from one.
    pub instant: usize,
    /// Fx, Fy, Fz, N, and Mx, My, Mz, N m, at each station.
    pub loads: Vec<[f64; 6]>,
}

impl Instant {
    /// What instants are sorted by.
    pub(super) fn key(&self) -> (Model, usize, usize) {
        (self.model, self.case, self.instant)
    }
}
