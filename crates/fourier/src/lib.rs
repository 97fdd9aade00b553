#![doc = include_str!("../README.md")]

mod bluestein;

use num_complex::Complex;
use rustfft::FftPlanner;
use std::cell::RefCell;

pub use bluestein::cosines;

thread_local! {
    /// Plans are made once a length.
    static PLANNER: RefCell<FftPlanner<f64>> = RefCell::new(FftPlanner::new());
}

/// The sums over n of `values[n] exp(-2 pi i k n / N)`, in place.
pub fn forward(values: &mut [Complex<f64>]) {
    PLANNER.with_borrow_mut(|planner| planner.plan_fft_forward(values.len())).process(values);
}

/// The sums over n of `values[n] exp(2 pi i k n / N)`, in place: N times the inverse of [`forward`].
pub fn backward(values: &mut [Complex<f64>]) {
    PLANNER.with_borrow_mut(|planner| planner.plan_fft_inverse(values.len())).process(values);
}

/// The next even length that is a product of 2, 3 and 5.
pub fn fast_length(least: usize) -> usize {
    let smooth = |mut n: usize| {
        for p in [2, 3, 5] {
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        n == 1
    };
    // a power of two lies between any number and its double
    (least..=2 * least).find(|n| n.is_multiple_of(2) && smooth(*n)).unwrap_or(least)
}
