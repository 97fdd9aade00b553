//! The thin section in oscillating flow without compressibility (Theodorsen, NACA TR 496, 1935; Sears, J. Aeronautical
//! Sciences 8, 1941): closed forms that results are compared with. Time goes as exp(+i omega t).

use faer::{Mat, c64};
use std::f64::consts::{FRAC_PI_4, PI};

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;
/// Below it Bessel functions are summed as power series, above it as asymptotic ones: both are good to 1e-12 there.
const SERIES_TO: f64 = 14.0;

/// Hankel functions of the second kind, orders 0 and 1, of a positive argument.
pub fn hankel_2(x: f64) -> [c64; 2] {
    if x < SERIES_TO { by_series(x) } else { [0.0, 1.0].map(|order| asymptotic(order, x)) }
}

/// J - i Y by power series (Abramowitz and Stegun 9.1.10, 9.1.11).
fn by_series(x: f64) -> [c64; 2] {
    let (half, minus) = (0.5 * x, -0.25 * x * x);
    let log = half.ln() + EULER;
    let (mut term, mut harmonic) = (1.0, 0.0);
    let [mut j0, mut y0, mut j1, mut y1] = [0.0; 4];
    for k in 0..80 {
        let m = f64::from(k);
        if k > 0 {
            term *= minus / (m * m);
            harmonic += 1.0 / m;
        }
        j0 += term;
        y0 += term * (log - harmonic) * 2.0 / PI;
        let next = term * half / (m + 1.0);
        j1 += next;
        y1 += next * (2.0 * log - 2.0 * harmonic - 1.0 / (m + 1.0)) / PI;
    }
    [c64::new(j0, -y0), c64::new(j1, -(y1 - 2.0 / (PI * x)))]
}

/// Hankel's expansion for large arguments (Abramowitz and Stegun 9.2.8).
fn asymptotic(order: f64, x: f64) -> c64 {
    let mu = 4.0 * order * order;
    let (mut term, mut sum) = (c64::new(1.0, 0.0), c64::new(1.0, 0.0));
    for k in 1..40 {
        let m = f64::from(k);
        let next = term * c64::new(0.0, -(mu - (2.0 * m - 1.0).powi(2)) / (8.0 * m * x));
        if next.norm() >= term.norm() {
            break;
        }
        term = next;
        sum += term;
    }
    let phase = x - 0.5 * order * PI - FRAC_PI_4;
    sum * c64::new(phase.cos(), -phase.sin()) * (2.0 / (PI * x)).sqrt()
}

/// Theodorsen's function C(k), one at k = 0.
pub fn theodorsen(k: f64) -> c64 {
    if k == 0.0 {
        return c64::new(1.0, 0.0);
    }
    let [h0, h1] = hankel_2(k);
    h1 / (h1 + c64::new(0.0, 1.0) * h0)
}

/// Sears' function for a gust whose phase is taken at mid-chord.
pub fn sears(k: f64) -> c64 {
    let [h0, h1] = hankel_2(k);
    let (j0, j1) = (h0.re, h1.re);
    theodorsen(k) * c64::new(j0, -j1) + c64::new(0.0, j1)
}

/// Forces of a strip of width one per unit dynamic pressure: rows plunging force (down) and moment (nose up) about the elastic
/// axis, columns displacement down (m) and nose-up angle (rad), at omega/V. `b` is the semi-chord in m, `a` the axis' place
/// aft of mid-chord in semi-chords.
pub fn strip_forces(omega_over_v: f64, b: f64, a: f64) -> Mat<c64> {
    let kappa = omega_over_v;
    let i = c64::new(0.0, 1.0);
    let c = theodorsen(kappa * b);
    // incidence at the three-quarter point
    let w = [i * kappa, c64::from(1.0) + i * (kappa * b * (0.5 - a))];
    let apparent = 2.0 * PI * b * b;
    let lift = [
        w[0] * c * (4.0 * PI * b) - apparent * kappa * kappa,
        w[1] * c * (4.0 * PI * b) + (i * kappa + b * a * kappa * kappa) * apparent,
    ];
    let moment = [
        w[0] * c * (4.0 * PI * b * b * (a + 0.5)) - apparent * b * a * kappa * kappa,
        w[1] * c * (4.0 * PI * b * b * (a + 0.5))
            + (b * b * (0.125 + a * a) * kappa * kappa - i * (kappa * b * (0.5 - a))) * apparent,
    ];
    Mat::from_fn(2, 2, |row, column| if row == 0 { -lift[column] } else { moment[column] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_expansions_agree_where_they_meet() {
        for (order, series) in [0.0, 1.0].into_iter().zip(by_series(SERIES_TO)) {
            assert!((series - asymptotic(order, SERIES_TO)).norm() < 1e-11);
        }
    }

    /// J1 Y0 - J0 Y1 = 2/(pi x), Abramowitz and Stegun 9.1.16.
    #[test]
    fn the_wronskian_of_the_hankel_functions_is_theirs() {
        for x in [1e-3, 0.1, 1.0, 5.0, 13.9, 14.1, 60.0] {
            let [h0, h1] = hankel_2(x);
            let (y0, y1) = (-h0.im, -h1.im);
            let wronskian = h1.re * y0 - h0.re * y1;
            assert!((wronskian * PI * x / 2.0 - 1.0).abs() < 1e-10, "{x}: {wronskian}");
        }
    }
}
