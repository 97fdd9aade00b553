//! What depends linearly on the rig's motion: rows by everything that moves or drives it, in named columns.

use faer::{Mat, MatRef};
use std::ops::Range;

/// Where the columns of a [`Linear`] stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Modes.
    pub(crate) modes: usize,
    /// How many of them, from the first, are slow: of the air's first family.
    pub(crate) slow_modes: usize,
    /// Control surfaces.
    pub(crate) controls: usize,
    /// Poles of the air's two families.
    pub(crate) poles: [usize; 2],
    /// Fields of acceleration.
    pub(crate) fields: usize,
}

impl Layout {
    /// Motions: modes, root pitch, controls.
    pub(crate) fn motions(self) -> usize {
        self.modes + 1 + self.controls
    }

    /// Derivative 0, 1 or 2 of every motion, in the order of [`Layout::motions`].
    pub(crate) fn motion(self, derivative: usize) -> Range<usize> {
        let first = derivative * self.motions();
        first..first + self.motions()
    }

    /// Modal accelerations.
    pub(crate) fn modal_accelerations(self) -> Range<usize> {
        let first = self.motion(2).start;
        first..first + self.modes
    }

    /// The motions of one of the air's families.
    pub(crate) fn family(self, family: usize) -> impl Iterator<Item = usize> {
        (0..self.motions()).filter(move |motion| self.family_of(*motion) == family)
    }

    /// The family a motion belongs to: 1 for the fast modes, 0 for all else.
    pub(crate) fn family_of(self, motion: usize) -> usize {
        usize::from((self.slow_modes..self.modes).contains(&motion))
    }

    /// Number of lag states of the families before `family` and of its poles before `pole`.
    pub(crate) fn lags_before(self, family: usize, pole: usize) -> usize {
        let fast = self.modes - self.slow_modes;
        let slow = self.motions() - fast;
        if family == 0 { pole * slow } else { self.poles[0] * slow + pole * fast }
    }

    /// Number of all lag states.
    pub(crate) fn lags(self) -> usize {
        self.lags_before(1, self.poles[1])
    }

    /// Lag states by family, pole and motion, in the order of their columns.
    pub(crate) fn every_lag(self) -> impl Iterator<Item = (usize, usize, usize)> {
        (0..2).flat_map(move |family| {
            (0..self.poles[family])
                .flat_map(move |pole| self.family(family).map(move |motion| (family, pole, motion)))
        })
    }

    /// The column of the first lag state.
    pub(crate) fn first_lag(self) -> usize {
        3 * self.motions()
    }

    /// The constant one.
    pub(crate) fn one(self) -> usize {
        self.first_lag() + self.lags()
    }

    /// Fields of acceleration.
    pub(crate) fn field(self, field: usize) -> usize {
        self.one() + 1 + field
    }

    /// All columns.
    pub(crate) fn len(self) -> usize {
        self.field(self.fields)
    }
}

/// See the module.
#[derive(Debug, Clone)]
pub(crate) struct Linear {
    pub(crate) layout: Layout,
    pub(crate) by: Mat<f64>,
}

impl Linear {
    pub(crate) fn zeros(rows: usize, layout: Layout) -> Self {
        Self { layout, by: Mat::zeros(rows, layout.len()) }
    }

    /// left * self
    pub(crate) fn mapped(&self, left: MatRef<'_, f64>) -> Self {
        Self { layout: self.layout, by: left * &self.by }
    }

    pub(crate) fn plus(self, other: &Self) -> Self {
        Self { layout: self.layout, by: self.by + &other.by }
    }

    /// The same with the modal accelerations expressed by everything else, as `modal` gives them.
    pub(crate) fn with_modal(mut self, modal: &Self) -> Self {
        let columns = self.layout.modal_accelerations();
        let share = self.by.as_ref().subcols(columns.start, columns.len()).to_owned();
        self.by.as_mut().subcols_mut(columns.start, columns.len()).fill(0.0);
        self.by += share * &modal.by;
        self
    }
}

#[cfg(test)]
mod tests;
