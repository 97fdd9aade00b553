//! Transforms beside the sums that define them.

use fourier::{backward, cosines, forward};
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
        let mut cosine = values.clone();
        cosines(&mut cosine);
        for k in 0..n {
            let turned = |sign: f64| -> Complex<f64> {
                let one = |i: u32| Complex::cis(sign * TAU * f64::from(k) * f64::from(i) / length);
                (0..n).zip(&complex).map(|(i, value)| value * one(i)).sum()
            };
            let place = k as usize;
            assert!((forth[place] - turned(-1.0)).norm() < 1e-10, "{n}: {k}");
            assert!((back[place] - turned(1.0)).norm() < 1e-10, "{n}: {k}");
            let wave = |i: u32| (PI * f64::from(k) * (f64::from(i) + 0.5) / length).cos();
            let sum: f64 = (0..n).zip(&values).map(|(i, value)| value * wave(i)).sum();
            assert!((cosine[place] - sum).abs() < 1e-10, "{n}: {k}");
        }
    }
}
