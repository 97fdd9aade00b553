//! Eight numbers at a time, in plain arrays that the compiler turns into vector instructions.
//!
//! All of it is inlined into the loop of `numerators.rs`, which `pulp` has compiled for each set of vector
//! instructions and picks at run time. No function of the platform's library is called, as those take one number:
//! exp, cos and sin are Taylor series on a reduced range (Cody and Waite, Software Manual for the Elementary
//! Functions, 1980), which branches nowhere.
#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use std::ops::{Add, AddAssign, Mul, Sub};

/// Numbers in one vector.
pub(super) const WIDTH: usize = 8;

/// Adding and subtracting this rounds to the nearest whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts, of which the first has zeros at its end: exact products with whole numbers.
const LN_2: [f64; 2] = [6.931_471_803_691_238_16e-1, 1.908_214_929_270_587_70e-10];
/// pi in three such parts.
const PI: [f64; 3] =
    [3.141_592_653_468_251_228_34, 1.215_420_101_260_793_195_32e-10, 4.044_532_497_591_901_263_08e-21];

/// A vector of numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lanes(pub(super) [f64; WIDTH]);

impl Lanes {
    #[inline(always)]
    pub(super) fn all(value: f64) -> Self {
        Self([value; WIDTH])
    }

    /// The first numbers of a slice.
    #[inline(always)]
    pub(super) fn load(from: &[f64]) -> Self {
        let mut lanes = [0.0; WIDTH];
        lanes.copy_from_slice(&from[..WIDTH]);
        Self(lanes)
    }

    /// Adds the numbers to the first of a slice.
    #[inline(always)]
    pub(super) fn add_to(self, to: &mut [f64]) {
        for (sum, value) in to[..WIDTH].iter_mut().zip(self.0) {
            *sum += value;
        }
    }

    #[inline(always)]
    fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
        for value in &mut self.0 {
            *value = f(*value);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        for (value, other) in self.0.iter_mut().zip(other.0) {
            *value = f(*value, other);
        }
        self
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline(always)]
    pub(super) fn recip(self) -> Self {
        self.map(|v| 1.0 / v)
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        self.map(f64::abs)
    }

    /// 1 where the number is not negative, else -1.
    #[inline(always)]
    pub(super) fn sign(self) -> Self {
        self.map(|v| if v < 0.0 { -1.0 } else { 1.0 })
    }

    /// At least `least`, which keeps products clear of subnormal numbers: those are slow.
    #[inline(always)]
    pub(super) fn at_least(self, least: f64) -> Self {
        self.map(|v| if v > least { v } else { least })
    }

    /// exp(-v) for v >= 0; 1e-304 beyond 700.
    #[inline(always)]
    pub(super) fn exp_of_minus(self) -> Self {
        let v = self.map(|v| if v < 700.0 { v } else { 700.0 });
        let n = v.map(|v| rounded(v * std::f64::consts::LOG2_E));
        let rest = n.zip(v, |n, v| (n * LN_2[0] - v) + n * LN_2[1]);
        // 2^-n: the low bits of 2^52 + m are the whole number m, here the exponent's.
        let scale = n.map(|n| f64::from_bits((1023.0 - n + 4_503_599_627_370_496.0).to_bits() << 52));
        scale * rest.polynomial(&EXP)
    }

    /// Horner's rule; coefficients by falling powers.
    #[inline(always)]
    fn polynomial<const N: usize>(self, coefficients: &[f64; N]) -> Self {
        let mut sum = Self::all(coefficients[0]);
        for coefficient in &coefficients[1..] {
            sum = sum * self + Self::all(*coefficient);
        }
        sum
    }

    /// Cosine and sine, for arguments up to 1e5.
    #[inline(always)]
    pub(super) fn cos_sin(self) -> (Self, Self) {
        let turns = self.map(|v| rounded(v * std::f64::consts::FRAC_1_PI));
        let rest = self.zip(turns, |v, n| ((v - n * PI[0]) - n * PI[1]) - n * PI[2]);
        // Half turns: an odd number of them changes both signs.
        let sign = turns.map(|n| 1.0 - 4.0 * (0.5 * n - rounded(0.5 * n)).abs());
        let square = rest * rest;
        (sign * square.polynomial(&COS), sign * rest * square.polynomial(&SIN))
    }
}

#[inline(always)]
fn rounded(v: f64) -> f64 {
    (v + ROUND) - ROUND
}

/// 1, -+1/2!, 1/4! ... or 1, -+1/3!, 1/5! ...: `first` is 0 or 1, the sign of the second `sign`; highest power first.
const fn series<const N: usize>(first: usize, step: usize, sign: f64) -> [f64; N] {
    let mut list = [1.0; N];
    let mut i = 1;
    let mut last = 1.0;
    while i < N {
        let mut factor = first + step * (i - 1) + 1;
        while factor <= first + step * i {
            last /= factor as f64;
            factor += 1;
        }
        last *= sign;
        list[N - 1 - i] = last;
        i += 1;
    }
    list
}

const EXP: [f64; 14] = series(0, 1, 1.0);
const COS: [f64; 12] = series(0, 2, -1.0);
const SIN: [f64; 12] = series(1, 2, -1.0);

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl Mul<f64> for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self.map(|v| v * factor)
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponentials_are_those_of_the_library() {
        for i in 0..70_000_u32 {
            let v = f64::from(i) * 0.01;
            let got = Lanes::all(v).exp_of_minus().0[0];
            assert!((got / (-v).exp() - 1.0).abs() < 1e-15, "{v}: {got}");
        }
        assert!(Lanes::all(1e6).exp_of_minus().0[0] < 1e-303);
    }

    #[test]
    fn cosines_and_sines_are_those_of_the_library() {
        for i in -50_000..50_000_i32 {
            let v = f64::from(i) * 0.013;
            let (cos, sin) = Lanes::all(v).cos_sin();
            assert!((cos.0[0] - v.cos()).abs() < 1e-15 && (sin.0[0] - v.sin()).abs() < 1e-15, "{v}");
        }
    }
}
