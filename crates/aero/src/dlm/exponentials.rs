//! Sums of exponentials for `1 - u/sqrt(1+u^2)`, on which the integrals of the kernel rest.
//!
//! With `1 - u/sqrt(1+u^2) ~ sum a_n exp(-b_n u)` for u >= 0 the integrals of the oscillating kernel have closed forms.
//! Laschka's set has `b_n = 0.372 n` and 11 terms (Blair, A Compilation of the Mathematics Leading to the Doublet
//! Lattice Method, WL-TR-92-3028, 1992); Desmarais' D12.1 has `b_n = b 2^n` and 12 terms (Desmarais, NASA TM 84562,
//! 1982). Both need one exponential only: the next is the last one times the first, or the last one squared.

use serde::{Deserialize, Serialize};

/// Which sum of exponentials stands for `1 - u/sqrt(1+u^2)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum KernelIntegral {
    /// 12 terms, exponents doubling: off by 2.5e-5 at most.
    #[default]
    Desmarais,
    /// 11 terms, equal steps of the exponents: off by 1.3e-3 at most. In many older programs, for comparison.
    Laschka,
    /// 24 terms of our own, exponents in steps of sqrt(2): off by 3.1e-7 at most, and dearer by a half.
    Fine,
}

/// Coefficients of Desmarais' D12.1.
const DESMARAIS: [f64; 12] = [
    0.000_319_759_140,
    -0.000_055_461_471,
    0.002_726_074_362,
    0.005_749_551_566,
    0.031_455_895_072,
    0.106_031_126_212,
    0.406_838_011_567,
    0.798_112_357_155,
    -0.417_749_229_098,
    0.077_480_713_894,
    -0.012_677_284_771,
    0.001_787_032_960,
];
/// The exponents are this times 2, 4, 8...
const DESMARAIS_EXPONENT: f64 = 0.009_054_814_793;

/// Coefficients of Laschka's 11 terms.
const LASCHKA: [f64; 11] = [
    0.241_861_98,
    -2.791_802_7,
    24.991_079,
    -111.591_96,
    271.435_49,
    -305.752_88,
    -41.183_630,
    545.985_37,
    -644.781_55,
    328.727_55,
    -64.279_511,
];
/// The exponents are this times 1, 2, 3...
const LASCHKA_EXPONENT: f64 = 0.372;

/// Coefficients of 24 terms, fitted by least squares with weights raised where the error was largest.
const FINE: [f64; 24] = [
    0.000_415_464_557,
    -0.002_199_793_886,
    0.006_662_916_676,
    -0.014_051_043_289,
    0.024_329_876_591,
    -0.035_260_213_789,
    0.047_554_767_152,
    -0.056_187_303_606,
    0.068_717_277_503,
    -0.068_832_206_091,
    0.088_882_623_155,
    -0.064_828_983_084,
    0.124_425_699_028,
    -0.017_046_985_712,
    0.228_849_696_401,
    0.150_317_052_165,
    0.475_083_135_428,
    0.319_612_634_175,
    0.136_287_584_299,
    -0.736_462_640_270,
    0.416_086_613_931,
    -0.107_229_987_031,
    0.016_193_234_919,
    -0.001_319_366_081,
];
/// The exponents are this times 2^(1/2), 2, 2^(3/2)...
const FINE_EXPONENT: f64 = 0.0052;

impl KernelIntegral {
    /// Pairs (a, b) of the terms a exp(-b u), in ascending order of b.
    pub fn terms(self) -> Vec<(f64, f64)> {
        let count = |list: &[f64]| -> Vec<(f64, i32)> { list.iter().copied().zip(1..).collect() };
        let with = |list: &[f64], exponent: &dyn Fn(i32) -> f64| {
            count(list).into_iter().map(|(a, n)| (a, exponent(n))).collect()
        };
        match self {
            Self::Desmarais => with(&DESMARAIS, &|n| DESMARAIS_EXPONENT * 2_f64.powi(n)),
            Self::Laschka => with(&LASCHKA, &|n| LASCHKA_EXPONENT * f64::from(n)),
            Self::Fine => with(&FINE, &|n| FINE_EXPONENT * (f64::from(n) / 2.0).exp2()),
        }
    }

    /// Largest error of the sum for u >= 0, a little rounded up.
    pub fn largest_error(self) -> f64 {
        match self {
            Self::Desmarais => 2.54e-5,
            Self::Laschka => 1.35e-3,
            Self::Fine => 3.1e-7,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_sum_is_within_its_stated_error_and_no_further() {
        for by in [KernelIntegral::Desmarais, KernelIntegral::Laschka, KernelIntegral::Fine] {
            let terms = by.terms();
            let off = |i: u32| {
                let u = if i == 0 { 0.0 } else { 10_f64.powf(f64::from(i) * 5e-4 - 4.0) };
                let s = (1.0 + u * u).sqrt();
                let sum: f64 = terms.iter().map(|(a, b)| a * (-b * u).exp()).sum();
                (sum - 1.0 / (s * (s + u))).abs()
            };
            let largest = (0..20_000).map(off).fold(0.0, f64::max);
            assert!(largest <= by.largest_error(), "{by:?}: {largest:e}");
            assert!(largest > 0.98 * by.largest_error(), "{by:?}: {largest:e}");
        }
    }
}
