//! Which directions of the factors the data determine, and how well.
//!
//! The rows of J are d(prediction)/d(factor) over sigma. A direction v of its singular value decomposition with the
//! singular value s has the standard deviation 1/s.

use nalgebra::{DMatrix, DVector};

/// Share of a factor that may lie in undetermined directions before the factor counts as undetermined.
const SHARE: f64 = 0.01;

/// The directions of a linearised fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Determination {
    /// Unit directions in the space of the factors, the best determined first.
    pub directions: Vec<Vec<f64>>,
    /// Standard deviation of each direction; infinite if the data say nothing about it.
    pub sigma: Vec<f64>,
    /// How many of them count as determined.
    pub determined: usize,
}

impl Determination {
    /// Of weighted sensitivities; directions beyond `limit` are not determined. Also the least-squares step for the
    /// residuals within the determined directions.
    pub(super) fn of(
        sensitivities: &[Vec<f64>],
        residuals: &[f64],
        count: usize,
        limit: f64,
    ) -> (Self, Vec<f64>) {
        if count == 0 {
            return (Self { directions: Vec::new(), sigma: Vec::new(), determined: 0 }, Vec::new());
        }
        // Rows of zeros give every direction its singular value.
        let rows = sensitivities.len().max(count);
        let j = DMatrix::from_fn(rows, count, |i, p| sensitivities.get(i).map_or(0.0, |row| row[p]));
        let r = DVector::from_fn(rows, |i, _| residuals.get(i).copied().unwrap_or(0.0));
        let svd = j.svd(true, true);
        let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else {
            return (Self { directions: Vec::new(), sigma: Vec::new(), determined: 0 }, vec![0.0; count]);
        };
        let mut step = DVector::zeros(count);
        let (mut directions, mut sigma, mut determined) = (Vec::new(), Vec::new(), 0);
        for (i, s) in svd.singular_values.iter().enumerate() {
            let direction = v_t.row(i).transpose();
            let is_determined = s * limit > 1.0;
            if is_determined {
                determined += 1;
                step += &direction * (u.column(i).dot(&r) / s);
            }
            sigma.push(if *s > f64::EPSILON * svd.singular_values[0] { 1.0 / s } else { f64::INFINITY });
            directions.push(direction.iter().copied().collect());
        }
        (Self { directions, sigma, determined }, step.iter().copied().collect())
    }

    /// Covariance of the factors within the determined directions.
    pub fn covariance(&self) -> Vec<Vec<f64>> {
        let count = self.directions.len();
        let entry = |a: usize, b: usize| {
            let of = |i: usize| self.sigma[i].powi(2) * self.directions[i][a] * self.directions[i][b];
            (0..self.determined).map(of).sum()
        };
        (0..count).map(|a| (0..count).map(|b| entry(a, b)).collect()).collect()
    }

    /// Share (0 to 1) of a factor that lies in directions that are not determined.
    pub fn undetermined_share(&self, factor: usize) -> f64 {
        self.directions[self.determined..].iter().map(|direction| direction[factor].powi(2)).sum()
    }

    /// Whether the data determine a factor by itself.
    pub fn is_determined(&self, factor: usize) -> bool {
        self.undetermined_share(factor) < SHARE
    }

    /// The directions that are not determined, each as factors and their parts in it (small parts left out).
    pub fn undetermined_directions(&self) -> Vec<Vec<(usize, f64)>> {
        let parts = |direction: &Vec<f64>| {
            direction.iter().copied().enumerate().filter(|(_, part)| part.abs() > 0.05).collect()
        };
        self.directions[self.determined..].iter().map(parts).collect()
    }
}

#[cfg(test)]
mod tests;
