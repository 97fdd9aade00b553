//! The objective of paper 1, Eq. 8, the straight-line floor under it, and the test for what no line can follow.

use crate::statics::{AirspeedData, Angle, StaticData};
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// Root mean square error a channel (zero for a channel that is not measured).
pub fn rmse<const N: usize>(residuals: &[[f64; N]], channels: [bool; N]) -> [f64; N] {
    std::array::from_fn(|c| {
        if !channels[c] || residuals.is_empty() {
            return 0.0;
        }
        (residuals.iter().map(|r| r[c] * r[c]).sum::<f64>() / residuals.len() as f64).sqrt()
    })
}

/// Paper 1, Eq. 8: `F = w_Fz RMSE(Fz) + w_Mx RMSE(Mx) + w_My RMSE(My)`, N and N m added as the paper does; with a fourth
/// channel `+ w_tip RMSE(tip)`, whose weight in N m/m makes it commensurable (see [`Settings::tip_weight`]).
///
/// [`Settings::tip_weight`]: crate::Settings::tip_weight
pub fn objective<const N: usize>(rmse: [f64; N], weights: [f64; N]) -> f64 {
    (0..N).map(|c| weights[c] * rmse[c]).sum()
}

/// What a channel's means do that no straight line can follow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nonlinearity {
    /// Second derivative over two: the load per rad² of the least-squares parabola.
    pub curvature_per_rad2: f64,
    /// F statistic of the line's error against noise (or of the curvature against the scatter about a parabola).
    pub f: f64,
    /// Probability of an F as large without any nonlinearity.
    pub p_value: f64,
}

/// Straight lines through the means of one airspeed, or through what a wing that bends far misses of them.
#[derive(Debug, Clone, PartialEq)]
pub struct LineFit {
    /// RMSE of the least-squares straight line in alpha, by channel.
    pub rmse: [f64; 4],
    /// Residuals of the line by angle and channel.
    pub residuals: Vec<[f64; 4]>,
    /// Tests for nonlinearity by channel; none where nothing can be said (three angles without known noise).
    pub nonlinearity: [Option<Nonlinearity>; 4],
}

/// Fits a straight line to every channel of an airspeed and tests what is left.
///
/// With known noise (declared, or from replicates) the test is F = (squares about the line / (n - 2)) / variance,
/// with means weighted by their replicates. Without, the noise is the scatter about a parabola, and the test is of
/// the curvature alone.
pub fn line_fit(data: &StaticData, airspeed: &AirspeedData) -> LineFit {
    let readings: Vec<[f64; 4]> = airspeed.angles.iter().map(Angle::readings).collect();
    line_fit_of(data, airspeed, &readings)
}

/// The same of other values at its angles, as of what a model misses.
pub(crate) fn line_fit_of(data: &StaticData, airspeed: &AirspeedData, values: &[[f64; 4]]) -> LineFit {
    let alphas: Vec<f64> = airspeed.angles.iter().map(|angle| angle.alpha_rad).collect();
    let mut residuals = vec![[0.0; 4]; alphas.len()];
    let mut nonlinearity = [None; 4];
    for channel in (0..4).filter(|&c| data.channels[c]) {
        let loads: Vec<f64> = values.iter().map(|row| row[channel]).collect();
        let (line, _) = polynomial_residuals(&alphas, &loads, 1);
        for (row, value) in residuals.iter_mut().zip(&line) {
            row[channel] = *value;
        }
        nonlinearity[channel] = test(data, airspeed, channel, &alphas, &loads, &line);
    }
    LineFit { rmse: rmse(&residuals, data.channels), residuals, nonlinearity }
}

fn test(
    data: &StaticData,
    airspeed: &AirspeedData,
    channel: usize,
    alphas: &[f64],
    loads: &[f64],
    line: &[f64],
) -> Option<Nonlinearity> {
    let count = alphas.len();
    let squares = |residuals: &[f64]| residuals.iter().map(|r| r * r).sum::<f64>();
    let (parabola, coefficients) = polynomial_residuals(alphas, loads, 2);
    let curvature_per_rad2 = coefficients.get(2).copied().unwrap_or(0.0);
    if let Some(sigma) = data.point_sigma {
        let freedom = (count - 2) as f64;
        let weighted: f64 =
            line.iter().zip(&airspeed.angles).map(|(r, angle)| r * r * angle.replicates as f64).sum();
        let f = weighted / freedom / sigma[channel].powi(2).max(f64::MIN_POSITIVE);
        let p_value = probability_of_noise(f, freedom, data.noise_dof)?;
        return Some(Nonlinearity { curvature_per_rad2, f, p_value });
    }
    if count < 4 {
        return None;
    }
    let freedom = (count - 3) as f64;
    let f = (squares(line) - squares(&parabola)) / (squares(&parabola) / freedom).max(f64::MIN_POSITIVE);
    Some(Nonlinearity {
        curvature_per_rad2,
        f,
        p_value: FisherSnedecor::new(1.0, freedom).ok()?.sf(f.max(0.0)),
    })
}

/// Probability that noise alone makes a mean square as large: `f` over its variance, which is declared or estimated with so many
/// degrees of freedom.
pub(crate) fn probability_of_noise(f: f64, freedom: f64, noise_dof: Option<usize>) -> Option<f64> {
    match noise_dof {
        Some(dof) => Some(FisherSnedecor::new(freedom, dof as f64).ok()?.sf(f)),
        None => Some(ChiSquared::new(freedom).ok()?.sf(f * freedom)),
    }
}

/// Residuals and coefficients (ascending powers) of a least-squares polynomial of order 1 or 2.
pub(crate) fn polynomial_residuals(x: &[f64], y: &[f64], order: usize) -> (Vec<f64>, Vec<f64>) {
    use faer::linalg::solvers::SolveLstsq;
    if x.len() <= order {
        return (vec![0.0; x.len()], Vec::new());
    }
    let scale = x.iter().map(|v| v.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let power = |value: f64, k: usize| (0..k).fold(1.0, |product, _| product * value);
    let matrix = faer::Mat::from_fn(x.len(), order + 1, |i, k| power(x[i] / scale, k));
    let right = faer::Mat::from_fn(x.len(), 1, |i, _| y[i]);
    let solution = matrix.qr().solve_lstsq(right);
    let fitted = |i: usize| (0..=order).map(|k| solution[(k, 0)] * matrix[(i, k)]).sum::<f64>();
    let residuals = (0..x.len()).map(|i| y[i] - fitted(i)).collect();
    (residuals, (0..=order).map(|k| solution[(k, 0)] / power(scale, k)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() < tolerance, "{a} {b}");
    }

    #[test]
    fn the_objective_is_the_weighted_sum_of_root_mean_squares() {
        let found = rmse(&[[3.0, 1.0, 5.0], [-4.0, 1.0, 5.0]], [true, true, false]);
        near(found[0], 12.5_f64.sqrt(), 1e-12);
        assert_eq!(found[1..], [1.0, 0.0]);
        assert_eq!(rmse::<2>(&[], [true; 2]), [0.0; 2]);
        assert_eq!(objective([1.0, 2.0, 3.0], [10.0, 0.5, 1.0]), 14.0);
    }

    /// Upper 5 % points: F(1, 10) 4.965, F(3, 20) 3.098, chi square of three degrees 7.815.
    #[test]
    fn chances_are_those_of_the_tables() {
        let chance = |f, freedom, dof| probability_of_noise(f, freedom, dof).expect("a law");
        near(chance(4.965, 1.0, Some(10)), 0.05, 1e-4);
        near(chance(3.098, 3.0, Some(20)), 0.05, 1e-4);
        near(chance(7.815 / 3.0, 3.0, None), 0.05, 1e-4);
        assert_eq!(probability_of_noise(1.0, 0.0, Some(3)), None);
    }

    #[test]
    fn polynomials_are_found_in_their_own_powers() {
        let x = [-2.0, 0.5, 1.0, 4.0];
        let y = x.map(|x| 3.0 - 2.0 * x + 0.25 * x * x);
        let (residuals, coefficients) = polynomial_residuals(&x, &y, 2);
        assert!(residuals.iter().all(|r| r.abs() < 1e-12), "{residuals:?}");
        coefficients.iter().zip([3.0, -2.0, 0.25]).for_each(|(a, b)| near(*a, b, 1e-12));
        // a line through 0, 0, 3 at -1, 0, 1 has the slope 1.5
        let (residuals, coefficients) = polynomial_residuals(&[-1.0, 0.0, 1.0], &[0.0, 0.0, 3.0], 1);
        coefficients.iter().zip([1.0, 1.5]).for_each(|(a, b)| near(*a, b, 1e-12));
        residuals.iter().zip([0.5, -1.0, 0.5]).for_each(|(a, b)| near(*a, b, 1e-12));
        assert_eq!(polynomial_residuals(&x[..2], &y[..2], 2), (vec![0.0; 2], vec![]));
        assert_eq!(polynomial_residuals(&x[..3], &y[..3], 2).1.len(), 3);
    }
}
