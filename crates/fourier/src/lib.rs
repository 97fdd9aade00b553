#![doc = include_str!("../README.md")]

use num_complex::Complex;
use rustdct::DctPlanner;
use rustfft::FftPlanner;
use std::cell::RefCell;

thread_local! {
    /// Plans are made once a length.
    static FOURIER: RefCell<FftPlanner<f64>> = RefCell::new(FftPlanner::new());
    static COSINES: RefCell<DctPlanner<f64>> = RefCell::new(DctPlanner::new());
}

/// The sums over n of `values[n] exp(-2 pi i k n / N)`, in place.
pub fn forward(values: &mut [Complex<f64>]) {
    FOURIER.with_borrow_mut(|planner| planner.plan_fft_forward(values.len())).process(values);
}

/// The sums over n of `values[n] exp(2 pi i k n / N)`, in place: N times the inverse of [`forward`].
pub fn backward(values: &mut [Complex<f64>]) {
    FOURIER.with_borrow_mut(|planner| planner.plan_fft_inverse(values.len())).process(values);
}

/// The sums over n of `values[n] cos(pi k (n + 1/2) / N)` (DCT-II), in place.
pub fn cosines(values: &mut [f64]) {
    COSINES.with_borrow_mut(|planner| planner.plan_dct2(values.len())).process_dct2(values);
}
