//! Rotations in space: the three numbers that an element measures one by, and how these change with a spin.
//!
//! With R = exp([theta]) and a small spin w applied after it, log(exp([w]) R) = theta + L(theta) w,
//! L = 1 - [theta]/2 + eta [theta]^2 (Nour-Omid and Rankin 1991, eq. 3.17).
//!
//! A shell does not resist the rotation about its normal n but for a weak tie. In the logarithm that rotation turns the axis of the tilt, too, by
//! half of itself, so that moments of bending drive it: elements that bend by a tenth of a rad twist by whole ones. Where a node's
//! normal is R n = d, c = n . d and p = n x d, a shell's numbers are the tilt and the twist of R = exp([tilt]) exp(twist [n]),
//!
//! theta = f(c) p + twist n,  f = acos(c) / sin(acos(c)),
//! L = f (c 1 - d n^T) - f' p p^T + n (n + d)^T / (1 + c),
//!
//! of which the first, all that bends, knows nothing of the twist, and L depends on d alone.

use nalgebra::{Matrix3, Vector3};

/// The three numbers that an element measures a rotation of a node by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Measure {
    /// The logarithm.
    Logarithm,
    /// Tilt and twist of a unit vector.
    Tilt(Vector3<f64>),
}

/// A rotation, its numbers theta, and their change L by a spin.
pub(crate) struct Turn {
    pub(crate) rotation: Matrix3<f64>,
    pub(crate) theta: Vector3<f64>,
    pub(crate) by_spin: Matrix3<f64>,
    measure: Measure,
}

impl Turn {
    /// A rotation, measured.
    pub(crate) fn of(rotation: Matrix3<f64>, measure: Measure) -> Self {
        let (theta, by_spin) = match measure {
            Measure::Logarithm => {
                let theta = logarithm(&rotation);
                (theta, by_spin(&theta))
            }
            Measure::Tilt(n) => {
                let tilt = Tilt::of(&rotation, &n);
                (tilt.theta(&rotation), tilt.by_spin())
            }
        };
        Self { rotation, theta, by_spin, measure }
    }

    /// The change of L^T m by a spin, m held.
    pub(crate) fn moment_by_spin(&self, m: &Vector3<f64>) -> Matrix3<f64> {
        match self.measure {
            Measure::Logarithm => moment_by_vector(&self.theta, m) * self.by_spin,
            Measure::Tilt(n) => Tilt::of(&self.rotation, &n).moment_by_spin(m),
        }
    }
}

/// Where a normal is.
struct Tilt {
    n: Vector3<f64>,
    d: Vector3<f64>,
    c: f64,
    p: Vector3<f64>,
    /// f and its first two derivatives by c.
    f: [f64; 3],
}

impl Tilt {
    fn of(rotation: &Matrix3<f64>, n: &Vector3<f64>) -> Self {
        let d = rotation * n;
        // Upside down, there is no smallest rotation.
        let (c, p) = (n.dot(&d).clamp(UPSIDE_DOWN, 1.0), n.cross(&d));
        Self { n: *n, d, c, p, f: angle_over_sine(c) }
    }

    fn theta(&self, rotation: &Matrix3<f64>) -> Vector3<f64> {
        let cross = self.p.cross_matrix();
        let smallest = Matrix3::identity() + cross + cross * cross / (1.0 + self.c);
        let about = smallest.transpose() * rotation;
        let twist = (0.5 * self.n.dot(&axial(&about))).atan2(0.5 * (about.trace() - 1.0));
        self.p * self.f[0] + self.n * twist
    }

    fn by_spin(&self) -> Matrix3<f64> {
        let Self { n, d, c, p, f: [f, f_c, _] } = self;
        (Matrix3::identity() * *c - d * n.transpose()) * *f - p * p.transpose() * *f_c
            + n * (n + d).transpose() / (1.0 + c)
    }

    fn moment_by_spin(&self, m: &Vector3<f64>) -> Matrix3<f64> {
        let Self { n, d, c, p, f: [f, f_c, f_cc] } = self;
        let (along, across, twisting) = (d.dot(m), p.dot(m), n.dot(m) / (1.0 + c));
        let by_cosine = (m * *c - n * along) * *f_c - p * (across * f_cc) - (n + d) * (twisting / (1.0 + c));
        let n_cross = n.cross_matrix();
        let by_normal = by_cosine * n.transpose() + (m * n.transpose() - n * m.transpose()) * *f
            - (n_cross * across + p * (m.transpose() * n_cross)) * *f_c
            + Matrix3::identity() * twisting;
        by_normal * -d.cross_matrix()
    }
}

/// Cosine of a tilt below which it is taken as this, just short of half a turn.
const UPSIDE_DOWN: f64 = -1.0 + 1e-9;

/// 1 - c below which f is summed as a series.
const SERIES_TILT: f64 = 0.1;

/// Of which each is a twentieth of the one before, or less.
const SERIES_TERMS: u32 = 18;

/// f(c) = acos(c) / sin(acos(c)) and its first two derivatives.
fn angle_over_sine(c: f64) -> [f64; 3] {
    let x = 1.0 - c;
    if x < SERIES_TILT {
        // f = sum a_k x^k, a_k+1 / a_k = (k + 1) / (2 k + 3)
        let (mut a, mut powers, mut sums) = (1.0, [0.0, 0.0, 1.0], [0.0; 3]);
        for k in (0..SERIES_TERMS).map(f64::from) {
            sums[0] += a * powers[2];
            sums[1] -= a * k * powers[1];
            sums[2] += a * k * (k - 1.0) * powers[0];
            a *= (k + 1.0) / (2.0 * k + 3.0);
            powers = [powers[1], powers[2], powers[2] * x];
        }
        return sums;
    }
    let square = x * (1.0 + c);
    let f = c.acos() / square.sqrt();
    let f_c = (c * f - 1.0) / square;
    [f, f_c, (f + 3.0 * c * f_c) / square]
}

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
fn moment_by_vector(theta: &Vector3<f64>, m: &Vector3<f64>) -> Matrix3<f64> {
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
