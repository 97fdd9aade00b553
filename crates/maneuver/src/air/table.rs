//! Pressures of a set of motions at a table of frequencies, by the doublet lattice.

use aero::{AeroError, DoubletLattice};
use faer::{Mat, Scale, c64};

/// Incidences of motions: `w(p) = still + p moving`, p = s/V in 1/m, one row a box, one column a motion.
#[derive(Debug, Clone)]
pub struct MotionColumns {
    /// Incidence per unit of the motion, rad.
    pub still: Mat<f64>,
    /// Incidence times V per unit rate of the motion, m.
    pub moving: Mat<f64>,
}

impl MotionColumns {
    /// The incidence at omega/V.
    pub fn incidence(&self, omega_over_v: f64) -> Mat<c64> {
        Mat::from_fn(self.still.nrows(), self.still.ncols(), |j, column| {
            c64::new(self.still[(j, column)], omega_over_v * self.moving[(j, column)])
        })
    }
}

/// See the module.
#[derive(Debug, Clone)]
pub struct AirTable {
    /// Frequencies omega/V, 1/m, ascending and positive.
    pub omega_over_v_per_m: Vec<f64>,
    /// Pressure coefficients per unit of each motion, boxes by motions, one matrix a frequency.
    pub cp: Vec<Mat<c64>>,
}

impl AirTable {
    /// Solves at each frequency; one factorisation each.
    ///
    /// # Errors
    /// As [`DoubletLattice::at`].
    pub fn new(
        solver: &DoubletLattice,
        columns: &MotionColumns,
        omega_over_v_per_m: &[f64],
    ) -> Result<Self, AeroError> {
        let cp = omega_over_v_per_m.iter().map(|&kappa| solve(solver, columns, kappa));
        Ok(Self { cp: cp.collect::<Result<_, _>>()?, omega_over_v_per_m: omega_over_v_per_m.to_vec() })
    }

    /// The same for the two parts of the motions' incidence apart, `still` and `moving`, each per unit.
    ///
    /// # Errors
    /// As [`DoubletLattice::at`].
    pub fn of_parts(
        solver: &DoubletLattice,
        columns: &MotionColumns,
        omega_over_v_per_m: &[f64],
    ) -> Result<[Self; 2], AeroError> {
        let mut parts =
            [(); 2].map(|()| Self { omega_over_v_per_m: omega_over_v_per_m.to_vec(), cp: Vec::new() });
        for &kappa in omega_over_v_per_m {
            let solved = solver.at(kappa)?;
            for (part, incidence) in parts.iter_mut().zip([&columns.still, &columns.moving]) {
                let incidence = Mat::from_fn(incidence.nrows(), incidence.ncols(), |j, column| {
                    c64::from(incidence[(j, column)])
                });
                part.cp.push(solved.pressures(incidence.as_ref()));
            }
        }
        Ok(parts)
    }

    /// The table of the motions from those of the two parts of their incidence.
    pub fn of_motions([still, moving]: &[Self; 2]) -> Self {
        let whole = |((kappa, still), moving): ((&f64, &Mat<c64>), &Mat<c64>)| {
            still + Scale(c64::new(0.0, *kappa)) * moving
        };
        let omega_over_v_per_m = still.omega_over_v_per_m.clone();
        let cp = omega_over_v_per_m.iter().zip(&still.cp).zip(&moving.cp).map(whole).collect();
        Self { omega_over_v_per_m, cp }
    }
}

/// Pressures of the motions at one frequency.
pub(super) fn solve(
    solver: &DoubletLattice,
    columns: &MotionColumns,
    omega_over_v: f64,
) -> Result<Mat<c64>, AeroError> {
    Ok(solver.at(omega_over_v)?.pressures(columns.incidence(omega_over_v).as_ref()))
}
