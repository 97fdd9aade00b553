//! What of the unsteady air takes long, modes and pressures, as matrices that can be kept.

use crate::flight::modes::FreeModes;
use faer::{Mat, c64};

/// Modes of the free aircraft, and pressures of all columns, boxes by columns.
pub(super) struct SolvedAir {
    /// The modes.
    pub(super) modes: FreeModes,
    /// Steady pressures per unit of each column.
    pub(super) steady: Mat<f64>,
    /// The same at each frequency of the table.
    pub(super) cp: Vec<Mat<c64>>,
}

impl SolvedAir {
    /// All of it: natural frequencies (one column), shapes, displacements of the boxes, steady pressures, then real and
    /// imaginary parts of each frequency's.
    pub(super) fn matrices(&self) -> Vec<Mat<f64>> {
        let FreeModes { omega_rad_s, shapes, boxes } = &self.modes;
        let omega = Mat::from_fn(omega_rad_s.len(), 1, |mode, _| omega_rad_s[mode]);
        let mut all = vec![omega, shapes.clone(), boxes.clone(), self.steady.clone()];
        for cp in &self.cp {
            let part = |of: fn(c64) -> f64| Mat::from_fn(cp.nrows(), cp.ncols(), |i, j| of(cp[(i, j)]));
            all.extend([part(|z| z.re), part(|z| z.im)]);
        }
        all
    }

    /// From what [`SolvedAir::matrices`] gave; `None` if sizes contradict each other.
    pub(super) fn of_matrices(all: Vec<Mat<f64>>) -> Option<Self> {
        let size = |matrix: &Mat<f64>| (matrix.nrows(), matrix.ncols());
        let mut all = all.into_iter();
        let [omega, shapes, boxes, steady] = [all.next()?, all.next()?, all.next()?, all.next()?];
        let is_right = omega.ncols() == 1
            && [&shapes, &boxes].iter().all(|of_modes| of_modes.ncols() == omega.nrows())
            && 2 * steady.nrows() == boxes.nrows()
            && all.len().is_multiple_of(2);
        let mut cp = Vec::new();
        while let Some((re, im)) = all.next().zip(all.next()) {
            if [size(&re), size(&im)] != [size(&steady); 2] {
                return None;
            }
            cp.push(Mat::from_fn(re.nrows(), re.ncols(), |i, j| c64::new(re[(i, j)], im[(i, j)])));
        }
        let omega_rad_s = (0..omega.nrows()).map(|mode| omega[(mode, 0)]).collect();
        is_right.then_some(Self { modes: FreeModes { omega_rad_s, shapes, boxes }, steady, cp })
    }
}

#[cfg(test)]
mod tests;
