//! Rotations in space: their logarithm, and how it changes with a spin.
//!
//! With R = exp([theta]) and a small spin w applied after it, log(exp([w]) R) = theta + L(theta) w,
//! L = 1 - [theta]/2 + eta [theta]^2 (Nour-Omid and Rankin 1991, eq. 3.17).

use nalgebra::{Matrix3, Vector3};

/// Below this angle eta is summed as a series, rad.
const SERIES_ETA: f64 = 0.01;

/// Below this angle mu is summed as a series, rad.
const SERIES_MU: f64 = 0.05;

/// v with A - A^T = `[v]`.
pub(crate) fn axial(a: &Matrix3<f64>) -> Vector3<f64> {
    Vector3::new(a[(2, 1)] - a[(1, 2)], a[(0, 2)] - a[(2, 0)], a[(1, 0)] - a[(0, 1)])
}

/// The rotation vector of a rotation, up to half a turn, rad.
pub(crate) fn logarithm(r: &Matrix3<f64>) -> Vector3<f64> {
    let twice_sine = axial(r);
    let (sine, cosine) = (0.5 * twice_sine.norm(), 0.5 * (r.trace() - 1.0));
    let angle = sine.atan2(cosine);
    if sine > 1e-6 {
        return twice_sine * (0.5 * angle / sine);
    }
    if cosine > 0.0 {
        return twice_sine * 0.5;
    }
    // Half a turn: R = 2 n n^T - 1.
    let outer = (r + Matrix3::identity()) * 0.5;
    let largest = outer.diagonal().imax();
    outer.column(largest).normalize() * angle
}

/// L(theta): the rotation vector's change by a spin.
pub(crate) fn by_spin(theta: &Vector3<f64>) -> Matrix3<f64> {
    let cross = theta.cross_matrix();
    Matrix3::identity() - cross * 0.5 + cross * cross * eta(theta.norm())
}

/// The change of L(theta)^T m with theta, m held.
pub(crate) fn moment_by_vector(theta: &Vector3<f64>, m: &Vector3<f64>) -> Matrix3<f64> {
    let angle = theta.norm();
    let cross = theta.cross_matrix();
    let squares = Matrix3::identity() * theta.dot(m) + theta * m.transpose() - m * theta.transpose() * 2.0;
    squares * eta(angle) + cross * cross * m * theta.transpose() * mu(angle) - m.cross_matrix() * 0.5
}

fn eta(t: f64) -> f64 {
    if t < SERIES_ETA {
        let square = t * t;
        return 1.0 / 12.0 + square / 720.0 + square * square / 30240.0;
    }
    (1.0 - 0.5 * t / (0.5 * t).tan()) / (t * t)
}

/// eta' / t.
fn mu(t: f64) -> f64 {
    if t < SERIES_MU {
        let square = t * t;
        return 1.0 / 360.0 + square / 7560.0 + square * square / 201_600.0;
    }
    (t * t + 4.0 * t.cos() + t * t.sin() - 4.0) / (4.0 * t.powi(4) * (0.5 * t).sin().powi(2))
}

#[cfg(test)]
mod tests;
