//! Transforms beside the sums that define them.

use fourier::{backward, cosines, fast_length, forward};
use num_complex::Complex;
use std::f64::consts::{PI, TAU};

/// 60 samples, and a prime number of them.
const LENGTHS: [u32; 2] = [60, 61];

fn samples(n: u32) -> Vec<f64> {
    (0..n).map(|i| (0.37 * f64::from(i)).sin() + f64::from(i % 7)).collect()
}

#[test]
fn transforms_are_the_sums_that_their_words_say() {
    for n in LENGTHS {
        let (values, length) = (samples(n), f64::from(n));
        let complex: Vec<Complex<f64>> = values.iter().map(|v| Complex::new(*v, 1.0 - v)).collect();
        let [mut forth, mut back] = [complex.clone(), complex.clone()];
        forward(&mut forth);
        backward(&mut back);
        for k in 0..n {
            let turned = |sign: f64| -> Complex<f64> {
                let one = |i: u32| Complex::cis(sign * TAU * f64::from(k) * f64::from(i) / length);
                (0..n).zip(&complex).map(|(i, value)| value * one(i)).sum()
            };
            let place = k as usize;
            assert!((forth[place] - turned(-1.0)).norm() < 1e-10, "{n}: {k}");
            assert!((back[place] - turned(1.0)).norm() < 1e-10, "{n}: {k}");
        }
    }
}

/// As many as there are samples, fewer, one, and more; of two records, and of one beside nothing.
#[test]
fn cosine_coefficients_are_the_sums_that_define_them() {
    for n in LENGTHS {
        let length = f64::from(n);
        let records = [samples(n), (0..n).map(|i| f64::from(i * i % 11) - 3.0).collect()];
        let nothing = vec![0.0; records[0].len()];
        // as many counts as transforms are kept, and the same again
        for count in (1..40).chain([7, records[0].len(), 2 * records[0].len()]) {
            let [first, second] = cosines([&records[0], &records[1]], count);
            let [alone, of_nothing] = cosines([&records[0], &nothing], count);
            assert!([&first, &second, &alone, &of_nothing].iter().all(|all| all.len() == count));
            for (k, place) in (0..).zip(0..count) {
                let wave = |i: u32| (PI * f64::from(k) * (f64::from(i) + 0.5) / length).cos();
                let sum =
                    |record: &[f64]| -> f64 { (0..n).zip(record).map(|(i, value)| value * wave(i)).sum() };
                let off = [
                    first[place] - sum(&records[0]),
                    second[place] - sum(&records[1]),
                    alone[place] - sum(&records[0]),
                    of_nothing[place],
                ];
                assert!(off.iter().all(|off| off.abs() < 1e-10), "{n}: {k} of {count}: {off:?}");
            }
        }
    }
}

#[test]
fn nothing_has_no_coefficients_but_zeros() {
    assert_eq!(cosines([&[0.0; 5], &[0.0; 5]], 2), [vec![0.0; 2], vec![0.0; 2]]);
}

#[test]
fn lengths_are_the_next_even_products_of_two_three_and_five() {
    let wanted = [(1, 2), (2, 2), (3, 4), (7, 8), (11, 12), (13, 16), (17, 18), (19, 20), (21, 24), (26, 30)];
    for (least, length) in wanted.into_iter().chain([(31, 32), (41, 48), (97, 100), (101, 108), (151, 160)]) {
        assert_eq!(fast_length(least), length, "{least}");
    }
}
