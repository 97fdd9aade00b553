//! The banded solution against the dense normal equations, derivatives against differences of fourth order.

use super::*;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Minimum of `sum (y - a)² + lambda sum (third difference of a)²`.
fn dense(values: &[f64], lambda: f64, from_rest: bool) -> Vec<f64> {
    let n = values.len();
    let rows: Vec<usize> = (if from_rest { 1 } else { 3 }..n).collect();
    let mut third = Mat::<f64>::zeros(rows.len(), n);
    for (row, &last) in rows.iter().enumerate() {
        for (k, c) in [-1.0, 3.0, -3.0, 1.0].into_iter().enumerate() {
            // before the first sample the signal is the first
            third[(row, (last + k).saturating_sub(3))] += c;
        }
    }
    let normal = Mat::<f64>::identity(n, n) + third.transpose() * &third * faer::Scale(lambda);
    let solution = normal.partial_piv_lu().solve(Mat::from_fn(n, 1, |i, _| values[i]));
    (0..n).map(|i| solution[(i, 0)]).collect()
}

#[test]
fn the_banded_solution_is_that_of_the_normal_equations() {
    let values: Vec<f64> = (0..17).map(|k| (1.7 * f64::from(k)).sin() + 0.1 * f64::from(k)).collect();
    for count in [1, 2, 3, 4, 5, 17] {
        for (lambda, from_rest) in [(0.3, true), (20.0, true), (0.3, false), (20.0, false), (0.0, true)] {
            let (ours, wanted) =
                (whittaker(&values[..count], lambda, from_rest), dense(&values[..count], lambda, from_rest));
            for (a, b) in ours.iter().zip(&wanted) {
                assert!((a - b).abs() < 1e-10, "{count} samples, {lambda}, {from_rest}: {a} {b}");
            }
        }
    }
}

#[test]
fn the_penalty_halves_the_power_at_the_cutoff_and_none_is_needed_above_half_the_sampling_rate() {
    for (dt, cutoff) in [(0.005, 10.0_f64), (0.01, 25.0), (0.001, 3.0)] {
        let w = std::f64::consts::TAU * cutoff * dt;
        let answer = 1.0 / (1.0 + penalty(dt, cutoff) * (2.0 - 2.0 * w.cos()).powi(3));
        assert!((answer * answer - 0.5).abs() < 1e-12, "{cutoff}");
    }
    assert_eq!((penalty(0.5, 1.0), penalty(0.5, 3.0)), (0.0, 0.0));
    assert!((penalty(0.5, 1.0 - 1e-9) * 64.0 - 0.414_213_562_373).abs() < 1e-9);
    let values = [1.0, -1.0, 2.0, 0.5];
    assert_eq!(zero_phase(&values, 0.5, 1.0), values);
}

#[test]
fn ends_are_free_where_loads_are_compared_and_at_rest_where_a_run_begins() {
    let parabola: Vec<f64> = (0..30).map(|k| 1.0 + 0.2 * f64::from(k) - 0.01 * f64::from(k * k)).collect();
    let (through, rested) = (zero_phase(&parabola, 0.01, 5.0), smooth_from_rest(&parabola, 0.01, 5.0).value);
    assert!(through.iter().zip(&parabola).all(|(a, b)| (a - b).abs() < 1e-8));
    assert_eq!(rested, whittaker(&parabola, penalty(0.01, 5.0), true));
    assert!((rested[0] - parabola[0]).abs() > 1e-3);
}

#[test]
fn derivatives_are_central_differences_of_fourth_order_between_rest_and_a_straight_line() {
    let h = 0.5;
    // no smoothing at this cutoff
    let of = |values: &[f64]| {
        let smooth = smooth_from_rest(values, h, 2.0);
        assert_eq!(smooth.value, values);
        let scaled = |v: Vec<f64>, by: f64| v.into_iter().map(|x| x * by).collect::<Vec<f64>>();
        (scaled(smooth.rate, 12.0 * h), scaled(smooth.second, 12.0 * h * h))
    };
    let near = |(rate, second): (Vec<f64>, Vec<f64>), wanted: ([f64; 7], [f64; 7])| {
        let same = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(same(&rate, &wanted.0) && same(&second, &wanted.1), "{rate:?} {second:?} for {wanted:?}");
    };
    let pulse = |at: usize| -> [f64; 7] { std::array::from_fn(|k| f64::from(u8::from(k == at))) };
    near(of(&pulse(3)), ([0.0, -1.0, 8.0, 0.0, -8.0, 1.0, 0.0], [0.0, -1.0, 16.0, -30.0, 16.0, -1.0, 0.0]));
    // the first sample goes on to the left
    near(of(&pulse(0)), ([0.0, -7.0, 1.0, 0.0, 0.0, 0.0, 0.0], [0.0, 15.0, -1.0, 0.0, 0.0, 0.0, 0.0]));
    // 0 .. 0, 1 goes on with 2 and 3
    near(of(&pulse(6)), ([0.0, 0.0, 0.0, 0.0, -1.0, 6.0, 13.0], [0.0, 0.0, 0.0, 0.0, -1.0, 14.0, -1.0]));
    let line = smooth_from_rest(&[2.0, 3.0], 1.0, 2.0);
    assert_eq!((line.rate[0], line.second[0]), (0.0, 0.0));
    // 2 2 [3] 4 5
    assert!((line.rate[1] - (2.0 - 16.0 + 32.0 - 5.0) / 12.0).abs() < 1e-12, "{:?}", line.rate);
    assert_eq!(
        smooth_from_rest(&[2.0], 1.0, 2.0),
        Smooth { value: vec![2.0], rate: vec![0.0], second: vec![0.0] }
    );
}
