//! Natural modes of a beam, and how they move any point.

use super::slices::Beam;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Modes of unit generalised mass, slowest first.
#[derive(Debug, Clone)]
pub struct Modes {
    /// Natural frequencies, rad/s.
    pub omega_rad_s: Vec<f64>,
    /// Motions of the slices, three rows a slice, a column a mode.
    pub(crate) slices: DMatrix<f64>,
    /// Inertia loads of the modes at unit acceleration.
    inertia: DMatrix<f64>,
}

/// How the modes move a place of the span.
#[derive(Debug, Clone)]
pub struct Shape {
    /// Height of a point, by mode.
    pub height: Vec<f64>,
    /// Nose-up rotation, by mode.
    pub pitch: Vec<f64>,
}

impl Beam {
    /// The slowest `count` modes.
    pub fn modes(&self, count: usize) -> Modes {
        let places = self.places();
        let c = self.flexibility.matrix(&places, &places);
        let mass = self.mass();
        // M = L Lᵀ block by block; Lᵀ C L has the inverse squares of the frequencies
        let l = factor(&mass);
        let eigen = SymmetricEigen::new(symmetric(&(l.transpose() * c * &l)));
        let mut order: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        order.truncate(count);
        let omega_rad_s = order.iter().map(|i| eigen.eigenvalues[*i].max(f64::MIN_POSITIVE).sqrt().recip());
        let omega_rad_s: Vec<f64> = omega_rad_s.collect();
        let y = DMatrix::from_fn(mass.nrows(), order.len(), |i, k| eigen.eigenvectors[(i, order[k])]);
        // x = L⁻ᵀ y, and M x = L y
        let inertia = &l * &y;
        let mut slices = l.transpose().solve_upper_triangular(&y).unwrap_or(y);
        let mut inertia = inertia;
        for (mode, mut shape) in slices.column_iter_mut().enumerate() {
            let last = shape.len() - 3;
            if shape[last] < 0.0 {
                shape.neg_mut();
                inertia.column_mut(mode).neg_mut();
            }
        }
        Modes { omega_rad_s, slices, inertia }
    }

    /// Height of the axis's end under a force at a point of the wing.
    pub fn end_under(&self, force_n: f64, x_m: f64, y_m: f64) -> f64 {
        let c = self.flexibility.between(self.end_y_m, y_m);
        let along = self.axis.height(x_m - self.axis.x_m(y_m), 0.0);
        force_n * (0..3).map(|i| c[0][i] * along[i]).sum::<f64>()
    }

    /// How modes move a point, by their own inertia loads on the axis: exact between slices too.
    pub fn shape(&self, modes: &Modes, x_m: f64, y_m: f64) -> Shape {
        let c = self.flexibility.matrix(&[y_m], &self.places()) * &modes.inertia;
        let along = self.axis.height(x_m - self.axis.x_m(y_m.max(0.0)), 0.0);
        let of = |row: [f64; 3]| {
            let one = |mode: usize| {
                let omega2 = modes.omega_rad_s[mode].powi(2);
                omega2 * (0..3).map(|i| row[i] * c[(i, mode)]).sum::<f64>()
            };
            (0..modes.omega_rad_s.len()).map(one).collect()
        };
        Shape { height: of(along), pitch: of(self.axis.pitch()) }
    }
}

impl Modes {
    /// Generalised loads of loads on the slices.
    pub(crate) fn loads(&self, on_slices: &DMatrix<f64>) -> DMatrix<f64> {
        self.slices.transpose() * on_slices
    }

    /// Static deflection by generalised loads.
    pub(crate) fn deflected(&self, loads: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(loads.len(), |i, _| loads[i] / self.omega_rad_s[i].powi(2))
    }
}

/// Cholesky's factor of a matrix of 3 by 3 blocks.
fn factor(mass: &DMatrix<f64>) -> DMatrix<f64> {
    let mut l = DMatrix::zeros(mass.nrows(), mass.ncols());
    for first in (0..mass.nrows()).step_by(3) {
        for i in 0..3 {
            for j in 0..=i {
                let (row, column) = (first + i, first + j);
                let inner: f64 = (0..j).map(|k| l[(row, first + k)] * l[(column, first + k)]).sum();
                let rest: f64 = mass[(row, column)] - inner;
                l[(row, column)] = if i == j { rest.max(0.0).sqrt() } else { rest / l[(column, column)] };
            }
        }
    }
    l
}

fn symmetric(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    0.5 * (matrix + matrix.transpose())
}
