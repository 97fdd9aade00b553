//! Corrected box loads of pressures: paper 1, Eq. 7, the only place that computes it.
//!
//! ```text
//! P = q W S cp + q S f_e        lift_j   = q A_j     (W_force,j  cp_j + f_e,j)
//!     cp = Q w                  moment_j = q A_j c/4 (W_moment,j cp_j + f_e,j)
//! ```
//! The first part is linear in cp and comes as a dense matrix, as rows R W S of whatever weighs box loads, or as those rows
//! times real or complex pressures; the second is a column of its own. Derivatives by W and `f_e` follow from the same two.

use crate::corrections::Corrections;
use crate::integration::{BoxLoads, Integration};
use faer::traits::ComplexField;
use faer::{Mat, MatRef};
use std::iter::Sum;
use std::ops::Mul;

/// See the module.
#[derive(Debug, Clone, Copy)]
pub struct LoadOperator<'a> {
    integration: &'a Integration,
    corrections: &'a Corrections,
}

/// Derivatives of weighted box loads by the corrections of some boxes: rows of the weights by boxes.
#[derive(Debug, Clone)]
pub struct LoadDerivatives {
    /// By the force factor.
    pub by_force: Mat<f64>,
    /// By the moment factor.
    pub by_moment: Mat<f64>,
    /// By the pressure offset `f_e`/q.
    pub by_offset: Mat<f64>,
}

impl Integration {
    /// Loads of these boxes with corrections, one entry a box.
    ///
    /// # Panics
    /// If the corrections are for another number of boxes.
    pub fn corrected<'a>(&'a self, corrections: &'a Corrections) -> LoadOperator<'a> {
        assert_eq!(self.len(), corrections.len(), "corrections are for another number of boxes");
        LoadOperator { integration: self, corrections }
    }

    /// `R S`: what rows that weigh box loads (two columns a box) make of pressure coefficients, per unit dynamic pressure
    /// and without corrections: rows by boxes.
    pub fn rows_by_pressure(&self, rows: MatRef<'_, f64>) -> Mat<f64> {
        self.corrected(&Corrections::neutral(self.len())).rows_by_pressure(rows)
    }
}

impl LoadOperator<'_> {
    /// `q W S cp`, column by column of real or complex pressure coefficients: two rows a box, N and N m.
    ///
    /// # Panics
    /// If there is not one row a box.
    pub fn of_pressures<T>(&self, q_pa: f64, cp: MatRef<'_, T>) -> Mat<T>
    where
        T: ComplexField + Copy + Mul<f64, Output = T>,
    {
        assert_eq!(cp.nrows(), self.integration.len(), "pressures are for another number of boxes");
        let mut loads = Mat::zeros(2 * cp.nrows(), cp.ncols());
        for (column, cp) in cp.col_iter().enumerate() {
            let (boxes, _) = loads.col_as_slice_mut(column).as_chunks_mut();
            for (j, (load, cp)) in boxes.iter_mut().zip(cp.iter()).enumerate() {
                *load = self.of_pressure(q_pa, j, *cp);
            }
        }
        loads
    }

    /// Adds `q S f_e` to one column of box loads.
    pub fn add_offset(&self, q_pa: f64, loads: &mut Mat<f64>, column: usize) {
        for j in 0..self.integration.len() {
            for (part, load) in self.of_offset(q_pa, j).into_iter().enumerate() {
                loads[(2 * j + part, column)] += load;
            }
        }
    }

    /// All of paper 1, Eq. 7 for one case.
    ///
    /// # Panics
    /// If there is not one pressure coefficient a box.
    pub fn box_loads(&self, q_pa: f64, cp: &[f64]) -> BoxLoads {
        let mut loads = self.of_pressures(q_pa, MatRef::from_column_major_slice(cp, cp.len(), 1));
        self.add_offset(q_pa, &mut loads, 0);
        BoxLoads { values: loads.col_as_slice(0).to_vec() }
    }

    /// `R W S`: what rows that weigh box loads (two columns a box) make of pressure coefficients, per unit dynamic pressure:
    /// rows by boxes.
    pub fn rows_by_pressure(&self, rows: MatRef<'_, f64>) -> Mat<f64> {
        let (s, c) = (self.integration, self.corrections);
        Mat::from_fn(rows.nrows(), s.len(), |i, j| {
            s.area(j) * (c.force[j] * rows[(i, 2 * j)] + c.moment[j] * s.moment_arm(j) * rows[(i, 2 * j + 1)])
        })
    }

    /// `R W S cp` of real or complex pressure coefficients, per unit dynamic pressure: rows by the columns of `cp`.
    pub fn weighed<T>(&self, rows: MatRef<'_, f64>, cp: MatRef<'_, T>) -> Mat<T>
    where
        T: Copy + Mul<f64, Output = T> + Sum,
    {
        let by_pressure = self.rows_by_pressure(rows);
        Mat::from_fn(rows.nrows(), cp.ncols(), |i, column| {
            (0..cp.nrows()).map(|j| cp[(j, column)] * by_pressure[(i, j)]).sum()
        })
    }

    /// `R S f_e`: what rows that weigh box loads make of the pressure offsets, per unit dynamic pressure.
    pub fn offset_weighed(&self, rows: MatRef<'_, f64>) -> Vec<f64> {
        let offset: Vec<[f64; 2]> = (0..self.integration.len()).map(|j| self.of_offset(1.0, j)).collect();
        let of = |i: usize| offset.iter().flatten().enumerate().map(|(k, load)| rows[(i, k)] * load).sum();
        (0..rows.nrows()).map(of).collect()
    }

    /// Derivatives of `R P` by the corrections of `boxes` at given pressures: R has two columns a box.
    pub fn derivatives(
        &self,
        q_pa: f64,
        rows: MatRef<'_, f64>,
        cp: &[f64],
        boxes: &[usize],
    ) -> LoadDerivatives {
        let (s, size) = (self.integration, rows.nrows());
        let lift = |j: usize| q_pa * s.area(j);
        let of =
            |each: &dyn Fn(usize, usize) -> f64| Mat::from_fn(size, boxes.len(), |i, b| each(i, boxes[b]));
        LoadDerivatives {
            by_force: of(&|i, j| rows[(i, 2 * j)] * lift(j) * cp[j]),
            by_moment: of(&|i, j| rows[(i, 2 * j + 1)] * lift(j) * s.moment_arm(j) * cp[j]),
            by_offset: of(&|i, j| lift(j) * (rows[(i, 2 * j)] + s.moment_arm(j) * rows[(i, 2 * j + 1)])),
        }
    }

    /// Lift and moment of one box by its pressure.
    fn of_pressure<T: Copy + Mul<f64, Output = T>>(&self, q_pa: f64, j: usize, cp: T) -> [T; 2] {
        let (s, c) = (self.integration, self.corrections);
        let lift = cp * (q_pa * s.area(j));
        [lift * c.force[j], lift * c.moment[j] * s.moment_arm(j)]
    }

    /// Lift and moment of one box by its pressure offset.
    fn of_offset(&self, q_pa: f64, j: usize) -> [f64; 2] {
        let lift = q_pa * self.integration.area(j) * self.corrections.pressure_offset[j];
        [lift, lift * self.integration.moment_arm(j)]
    }
}
