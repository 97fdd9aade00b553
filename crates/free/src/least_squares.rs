//! Levenberg and Marquardt's least squares with difference quotients; parameters stay within bounds.

use nalgebra::{DMatrix, DVector};

/// Steps taken at most.
const MOST_STEPS: usize = 30;
/// A step that gains less of the cost than this part is the last.
const LEAST_GAIN: f64 = 1e-5;
/// Step of the difference quotients, in parameters of order one.
const QUOTIENT: f64 = 1e-5;

/// Minimises half of the sum of squares from `start`; every parameter is of order one.
pub fn minimise(residuals: &dyn Fn(&[f64]) -> DVector<f64>, start: &[f64], bounds: &[[f64; 2]]) -> Vec<f64> {
    let mut x = start.to_vec();
    let mut here = residuals(&x);
    let mut cost = 0.5 * here.norm_squared();
    let mut lambda = 1e-3;
    let mut jacobian = quotients(residuals, &x, &here, bounds);
    for _ in 0..MOST_STEPS {
        let normal = jacobian.tr_mul(&jacobian);
        let slope = jacobian.tr_mul(&here);
        let mut gained = None;
        while gained.is_none() && lambda < 1e9 {
            let trial = step(&normal, &slope, lambda, &x, bounds);
            let there = residuals(&trial);
            let value = 0.5 * there.norm_squared();
            if value < cost {
                gained = Some(cost - value);
                (x, here, cost) = (trial, there, value);
                lambda = (lambda * 0.2).max(1e-12);
            } else {
                lambda *= 6.0;
            }
        }
        jacobian = quotients(residuals, &x, &here, bounds);
        if gained.is_none_or(|gain| gain < LEAST_GAIN * (1e-6 + cost)) {
            break;
        }
    }
    x
}

/// `J'J` at a place.
pub fn normal(residuals: &dyn Fn(&[f64]) -> DVector<f64>, x: &[f64], bounds: &[[f64; 2]]) -> DMatrix<f64> {
    let jacobian = quotients(residuals, x, &residuals(x), bounds);
    jacobian.tr_mul(&jacobian)
}

/// A damped step; parameters at a bound that would cross it stay there and leave the step to the others.
fn step(
    normal: &DMatrix<f64>,
    slope: &DVector<f64>,
    lambda: f64,
    x: &[f64],
    bounds: &[[f64; 2]],
) -> Vec<f64> {
    let free: Vec<usize> = (0..x.len())
        .filter(|&k| !(x[k] <= bounds[k][0] && slope[k] > 0.0 || x[k] >= bounds[k][1] && slope[k] < 0.0))
        .collect();
    let damped = DMatrix::from_fn(free.len(), free.len(), |i, j| {
        let entry = normal[(free[i], free[j])];
        if i == j { entry * (1.0 + lambda) + 1e-12 } else { entry }
    });
    let right = DVector::from_fn(free.len(), |i, _| -slope[free[i]]);
    let mut trial = x.to_vec();
    if let Some(factor) = damped.cholesky() {
        for (change, &k) in factor.solve(&right).iter().zip(&free) {
            trial[k] = (x[k] + change).clamp(bounds[k][0], bounds[k][1]);
        }
    }
    trial
}

fn quotients(
    residuals: &dyn Fn(&[f64]) -> DVector<f64>,
    x: &[f64],
    here: &DVector<f64>,
    bounds: &[[f64; 2]],
) -> DMatrix<f64> {
    let mut jacobian = DMatrix::zeros(here.len(), x.len());
    for k in 0..x.len() {
        let mut moved = x.to_vec();
        let change = if x[k] + QUOTIENT > bounds[k][1] { -QUOTIENT } else { QUOTIENT };
        moved[k] += change;
        jacobian.set_column(k, &((residuals(&moved) - here) / change));
    }
    jacobian
}
