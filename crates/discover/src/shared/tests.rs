//! The inner product beside `(I + G G')⁻¹` written out.

use super::*;

/// Two columns that are neither orthogonal to each other nor of one length.
fn columns() -> [Vec<f64>; 2] {
    [vec![1.0, 0.5, -0.3, 0.0, 2.0], vec![0.2, -1.0, 0.7, 0.4, 1.0]]
}

/// `(I + G G')⁻¹`, by elimination.
fn whole() -> Mat<f64> {
    let g = columns();
    let sum = Mat::from_fn(5, 5, |i, j| f64::from(u8::from(i == j)) + g[0][i] * g[0][j] + g[1][i] * g[1][j]);
    sum.partial_piv_lu().solve(Mat::<f64>::identity(5, 5))
}

fn jacobian() -> Mat<f64> {
    let rows = [[0.3, 1.0], [-1.2, 0.4], [0.8, 0.8], [2.0, -0.5], [0.1, 1.5]];
    Mat::from_fn(5, 2, |i, j| rows[i][j])
}

fn residual() -> [f64; 5] {
    [3.0, -1.0, 2.5, 0.7, -2.0]
}

#[test]
fn the_inner_product_is_that_of_the_inverse_covariance() {
    let shared = Shared::new(&columns(), 5);
    let (w, x) = (whole(), jacobian());
    let expected = x.transpose() * &w * &x;
    let gram = shared.gram(x.as_ref());
    assert_eq!((gram.nrows(), gram.ncols()), (2, 2));
    let r = Mat::from_fn(5, 1, |i, _| residual()[i]);
    let weighted = shared.weighted(&residual());
    let by_elimination = &w * &r;
    assert_eq!(weighted.len(), 5);
    assert!((0..5).all(|i| (weighted[i] - by_elimination[(i, 0)]).abs() < 1e-12), "{weighted:?}");
    let square = (r.transpose() * &w * &r)[(0, 0)];
    assert!((shared.norm(&residual()) - square).abs() < 1e-12);
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        assert!((gram[(i, j)] - expected[(i, j)]).abs() < 1e-12, "{i} {j}");
    }
    // one column of one row: half of it is left
    assert!((Shared::new(&[vec![1.0]], 1).norm(&[4.0]) - 8.0).abs() < 1e-12);
    // nothing shared: the sum of squares
    let free = Shared::new(&[], 2);
    assert!((free.norm(&[3.0, 4.0]) - 25.0).abs() < 1e-12);
    assert_eq!(free.weighted(&[3.0, 4.0]), [3.0, 4.0]);
}

#[test]
fn a_step_solves_the_normal_equations_with_the_prior() {
    let shared = Shared::new(&columns(), 5);
    let (w, j) = (whole(), jacobian());
    let r = Mat::from_fn(5, 1, |i, _| residual()[i]);
    let sizes = [0.6, -0.9];
    let columns = [0, 1].map(|k| shared.extended(j.col_as_slice(k).to_vec()));
    let extended = Mat::from_fn(7, 2, |i, k| columns[k][i]);
    let seen = shared.extended(residual().to_vec());
    assert!((shared.norm_of_extended(&seen) - shared.norm(&residual())).abs() < 1e-12);
    let LinearStep { step, gain, square } = shared.step(&extended, &seen, &sizes);
    let normal = j.transpose() * &w * &j + Mat::<f64>::identity(2, 2);
    let right = j.transpose() * &w * &r - Mat::from_fn(2, 1, |i, _| sizes[i]);
    let taken = Mat::from_fn(2, 1, |i, _| step[i]);
    let left = &normal * &taken - &right;
    assert_eq!(step.len(), 2);
    assert!(left[(0, 0)].abs() < 1e-12 && left[(1, 0)].abs() < 1e-12, "{step:?}");
    assert!((gain - (taken.transpose() * &right)[(0, 0)]).abs() < 1e-12);
    assert!((square - shared.norm(&residual())).abs() < 1e-12);
    // what chi square and prior of the linear model fall by
    let after: Vec<f64> =
        (0..5).map(|i| residual()[i] - (0..2).map(|k| j[(i, k)] * step[k]).sum::<f64>()).collect();
    let prior = |at: [f64; 2]| at[0] * at[0] + at[1] * at[1];
    let fallen = shared.norm(&residual()) + prior(sizes)
        - shared.norm(&after)
        - prior([sizes[0] + step[0], sizes[1] + step[1]]);
    assert!((gain - fallen).abs() < 1e-12, "{gain} {fallen}");
}
