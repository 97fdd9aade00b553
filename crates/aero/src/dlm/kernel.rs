//! The oscillating kernel: Landahl's form (AIAA Journal 5, 1967) as Rodden, Giesing and Kalman use it.
//!
//! A doublet of unit strength and a point `x_m` downstream and `r_m` beside it, kappa = omega/V, beta^2 = 1 - M^2:
//!
//! ```text
//! R = sqrt(x^2 + beta^2 r^2),  u = (M R - x)/(beta^2 r),  k = kappa r
//! K1 = -I1 - exp(-i k u) M r/(R s),  s = sqrt(1 + u^2)
//! K2 = 3 I2 + exp(-i k u) [ i k M^2 r^2/(R^2 s) + M r ((1+u^2) beta^2 r^2/R^2 + 2 + M r u/R)/(R s^3) ]
//! I1 = int_u^inf exp(-i k v)/(1+v^2)^(3/2) dv,  I2 = int_u^inf exp(-i k v)/(1+v^2)^(5/2) dv
//! ```
//!
//! (Giesing, Kalman and Rodden, AFFDL-TR-71-5, 1971, eqs. 4 to 14, with the signs of Rodden's paper of 1968.)
//! What the vortex lattice has already is taken off: `N = K10 - K exp(-i kappa x)` for K1 and likewise for K2.
//!
//! The integrals for u >= 0 follow from [`KernelIntegral`] by parts (the report's appendix A), those for u < 0 from
//! the integrand's symmetry: `I(u) = 2 Re I(0) - conj I(-u)`.

use crate::dlm::exponentials::KernelIntegral;
use faer::c64;

const I: c64 = c64::new(0.0, 1.0);

/// I1 and I2 of the module's equations, at lower limit `u` and `k` = omega r/V > 0 or 0.
pub fn integrals(u: f64, k: f64, by: KernelIntegral) -> [c64; 2] {
    if u >= 0.0 {
        return upper(u, k, by);
    }
    let (whole, rest) = (upper(0.0, k, by), upper(-u, k, by));
    [0, 1].map(|i| c64::from(2.0 * whole[i].re) - rest[i].conj())
}

/// The integrals for u >= 0.
fn upper(u: f64, k: f64, by: KernelIntegral) -> [c64; 2] {
    let (mut i0, mut j0) = (c64::default(), c64::default());
    for (a, b) in by.terms() {
        let (e, p) = (a * (-b * u).exp(), c64::from(1.0) / c64::new(b, k));
        i0 += p * e;
        j0 += (p * p + p * u) * e;
    }
    let s = (1.0 + u * u).sqrt();
    let g = 1.0 / (s * (s + u));
    let turn = (-I * (k * u)).exp();
    let first = (c64::from(g) - I * k * i0) * turn;
    let second = ((c64::from(2.0) + I * (k * u)) * g - u / (s * s * s) - I * k * i0 + j0 * (k * k)) * turn;
    [first, second / 3.0]
}

/// Place of a receiving point as seen from a doublet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Distance downstream, m; negative if the point is upstream.
    pub x_m: f64,
    /// Distance across the stream, m; greater than 0.
    pub r_m: f64,
}

/// Numerators N1 and N2 of the oscillatory increment: see the module. Zero at `omega_over_v` (1/m) = 0.
pub fn numerators(at: Separation, mach: f64, omega_over_v: f64, by: KernelIntegral) -> [c64; 2] {
    let Separation { x_m: x, r_m: r } = at;
    let beta_2 = 1.0 - mach * mach;
    let big_r = (x * x + beta_2 * r * r).sqrt();
    let u = (mach * big_r - x) / (beta_2 * r);
    let k = omega_over_v * r;
    let [i1, i2] = integrals(u, k, by);
    let s = (1.0 + u * u).sqrt();
    let turn = (-I * (k * u)).exp();
    let ratio = mach * r / big_r;
    let k1 = -i1 - turn * (ratio / s);
    let near = beta_2 * (r / big_r) * (r / big_r);
    let k2 = i2 * 3.0
        + I * k * turn * (ratio * ratio / s)
        + turn * (ratio * (s * s * near + 2.0 + ratio * u) / (s * s * s));
    let shift = (-I * (omega_over_v * x)).exp();
    [c64::from(-1.0 - x / big_r) - k1 * shift, c64::from(2.0 + x / big_r * (2.0 + near)) - k2 * shift]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// I1 and I2 by Simpson's rule over theta = atan(v), fine enough for k tan(theta) near the far end.
    fn quadrature(u: f64, k: f64) -> [c64; 2] {
        let (from, parts) = (u.atan(), 60_000_u32);
        let h = (FRAC_PI_2 - from) / f64::from(parts);
        let mut sum = [c64::default(); 2];
        for i in 0..parts {
            let weight = if i == 0 { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            let theta = from + h * f64::from(i);
            let turn = (-I * (k * theta.tan())).exp() * (weight * h / 3.0);
            sum[0] += turn * theta.cos();
            sum[1] += turn * theta.cos().powi(3);
        }
        sum
    }

    /// Errors of I1 and 3 I2 over u and k, as multiples of what an error of the sum may cause.
    ///
    /// By parts, an error d(u) of the sum makes an error of at most its total variation in I1, and `1 + k (1+|u|)`
    /// times that in 3 I2. d swings at most twice a term, so its variation is at most 4 times terms times max |d|.
    fn check(by: KernelIntegral) {
        let most = 4.0 * by.largest_error() * by.terms().len() as f64;
        for u in [-20.0, -3.0, -1.0, -0.2, 0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 15.0, 60.0] {
            for k in [0.0, 0.01, 0.1, 0.5, 1.0, 2.0, 5.0] {
                let (got, want) = (integrals(u, k, by), quadrature(u, k));
                let off = [(got[0] - want[0]).norm(), 3.0 * (got[1] - want[1]).norm()];
                // Simpson's own error is below 1e-7 with these steps, except where k is 0: there it is exact.
                let bound = most + 1e-7;
                assert!(off[0] < bound, "{by:?} u {u} k {k}: I1 off by {:.2e}, bound {bound:.2e}", off[0]);
                let bound = bound * (1.0 + k * (1.0 + u.abs()));
                assert!(off[1] < bound, "{by:?} u {u} k {k}: I2 off by {:.2e}, bound {bound:.2e}", off[1]);
            }
        }
    }

    #[test]
    fn the_integrals_are_those_of_numerical_quadrature_to_the_error_of_the_sum() {
        for by in [KernelIntegral::Desmarais, KernelIntegral::Laschka, KernelIntegral::Fine] {
            check(by);
        }
    }

    #[test]
    fn the_oscillatory_part_fades_with_frequency_and_obeys_reversed_time() {
        for (x_m, r_m, mach) in [(0.7, 0.2, 0.0), (-0.4, 0.3, 0.6), (5.0, 0.01, 0.8)] {
            let at = Separation { x_m, r_m };
            for part in numerators(at, mach, 0.0, KernelIntegral::Desmarais) {
                assert!(part.norm() < 1e-12, "{part}");
            }
            let ahead = numerators(at, mach, 1.3, KernelIntegral::Desmarais);
            let back = numerators(at, mach, -1.3, KernelIntegral::Desmarais);
            for (a, b) in ahead.iter().zip(back) {
                assert!((a.conj() - b).norm() < 1e-12);
            }
        }
    }
}
