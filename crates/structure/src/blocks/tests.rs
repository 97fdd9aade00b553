//! Noise as published; products of many rows.

use super::*;

/// Vigna's xorshift64* (ACM Trans. Math. Softw. 42, 2016) from this seed, its upper 32 bits, computed beside the
/// program.
#[test]
fn noise_is_that_of_xorshift_with_a_final_multiplication() {
    let bits = [226_735_074_u32, 1_422_150_777, 2_823_156_546, 2_104_363_911, 2_430_129_893, 2_649_149_199];
    let mut noise = Noise::new();
    let first = noise.extend(Mat::zeros(2, 0).as_ref(), 2);
    let more = noise.extend(first.as_ref().subcols(1, 1), 1);
    assert_eq!((first.nrows(), first.ncols(), more.ncols()), (2, 2, 2));
    let own = [first[(0, 0)], first[(1, 0)], first[(0, 1)], first[(1, 1)], more[(0, 1)], more[(1, 1)]];
    for (own, bits) in own.iter().zip(bits) {
        assert!((own - (2.0 * f64::from(bits) / 4_294_967_295.0 - 1.0)).abs() < 1e-15, "{own}");
    }
    assert_eq!((more[(0, 0)], more[(1, 0)]), (first[(0, 1)], first[(1, 1)]), "what is kept comes first");
}

#[test]
fn products_are_those_of_rows_and_columns() {
    let a = Mat::from_fn(3, 2, |i, j| (1 + i + 3 * j) as f64);
    let b = Mat::from_fn(3, 2, |i, j| (i as f64) - 2.0 * (j as f64));
    let own = inner(a.as_ref(), b.as_ref());
    // Columns 1 2 3 and 4 5 6 by 0 1 2 and -2 -1 0.
    assert_eq!([own[(0, 0)], own[(0, 1)], own[(1, 0)], own[(1, 1)]], [8.0, -4.0, 17.0, -13.0]);
    let own = product(a.as_ref(), Mat::from_fn(2, 1, |i, _| 1.0 + i as f64).as_ref());
    assert_eq!([own[(0, 0)], own[(1, 0)], own[(2, 0)]], [9.0, 12.0, 15.0]);
}

/// More rows than a thread works on at a time: sums of whole numbers, which are exact, and of others, the same on any number of threads.
#[test]
fn products_of_many_rows_are_whole_and_the_same_on_any_number_of_threads() {
    let n = 2 * ROWS + 3;
    let a = Mat::from_fn(n, 2, |i, j| if j == 0 { 1.0 } else { i as f64 });
    let own = inner(a.as_ref(), a.as_ref());
    let (count, sum) = (n as f64, (n * (n - 1) / 2) as f64);
    assert_eq!([own[(0, 0)], own[(0, 1)], own[(1, 0)]], [count, sum, sum]);
    let turned = product(a.as_ref(), Mat::from_fn(2, 1, |i, _| [3.0, 2.0][i]).as_ref());
    assert!((0..n).all(|i| turned[(i, 0)] == 3.0 + 2.0 * i as f64));
    let b = Mat::from_fn(n, 3, |i, j| (1.1 * i as f64 + j as f64).sin());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| (inner(b.as_ref(), b.as_ref()), product(b.as_ref(), Mat::identity(3, 3).as_ref())))
    };
    assert!(on(1) == on(3));
}
