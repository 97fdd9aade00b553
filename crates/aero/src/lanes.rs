//! Numbers side by side in two vector registers, of whatever width the processor has.
//!
//! All of it is inlined into the loop around it, which `pulp` has compiled for each set of vector
//! instructions and picks at run time. No function of the platform's library is called, as those take one number:
//! exp, cos and sin are Taylor series on a reduced range (Cody and Waite, Software Manual for the Elementary
//! Functions, 1980), which branches nowhere.
#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use pulp::Simd;
use pulp::bytemuck::cast;
use std::ops::{Add, AddAssign, Mul, Sub};

/// Lists that are read by [`Lanes`] have a multiple of this length: two of the widest registers.
pub(crate) const PADDING: usize = 16;

/// Adding and subtracting this rounds to the nearest whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts, of which the first has zeros at its end: exact products with whole numbers.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
/// pi in three such parts.
const PI: [f64; 3] = [3.141_592_653_468_251_2, 1.215_420_101_260_793_2e-10, 4.044_532_497_591_901e-21];

/// Numbers in two registers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lanes<S: Simd> {
    simd: S,
    both: [S::f64s; 2],
}

impl<S: Simd> Lanes<S> {
    /// How many numbers.
    pub(crate) const WIDTH: usize = 2 * S::F64_LANES;

    #[inline(always)]
    pub(crate) fn all(simd: S, value: f64) -> Self {
        Self { simd, both: [simd.splat_f64s(value); 2] }
    }

    /// The first numbers of a slice.
    #[inline(always)]
    pub(crate) fn load(simd: S, from: &[f64]) -> Self {
        let (vectors, _) = S::as_simd_f64s(from);
        Self { simd, both: [vectors[0], vectors[1]] }
    }

    /// Writes the numbers over the first of a slice.
    #[inline(always)]
    pub(crate) fn store(self, to: &mut [f64]) {
        let (vectors, _) = S::as_mut_simd_f64s(to);
        vectors[..2].copy_from_slice(&self.both);
    }

    /// Adds the numbers to the first of a slice.
    #[inline(always)]
    pub(crate) fn add_to(self, to: &mut [f64]) {
        let (vectors, _) = S::as_mut_simd_f64s(to);
        for (sum, value) in vectors[..2].iter_mut().zip(self.both) {
            *sum = self.simd.add_f64s(*sum, value);
        }
    }

    #[inline(always)]
    fn map(self, f: impl Fn(S, S::f64s) -> S::f64s) -> Self {
        let [a, b] = self.both;
        Self { both: [f(self.simd, a), f(self.simd, b)], ..self }
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(S, S::f64s, S::f64s) -> S::f64s) -> Self {
        let ([a, b], [c, d]) = (self.both, other.both);
        Self { both: [f(self.simd, a, c), f(self.simd, b, d)], ..self }
    }

    /// One number everywhere.
    #[inline(always)]
    pub(crate) fn same(self, value: f64) -> Self {
        Self::all(self.simd, value)
    }

    /// self * by + add, in one instruction where there is one.
    #[inline(always)]
    pub(crate) fn times_plus(self, by: Self, add: Self) -> Self {
        let ([a, b], [c, d], [e, f]) = (self.both, by.both, add.both);
        Self { both: [self.simd.mul_add_e_f64s(a, c, e), self.simd.mul_add_e_f64s(b, d, f)], ..self }
    }

    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        self.map(S::sqrt_f64s)
    }

    #[inline(always)]
    pub(crate) fn recip(self) -> Self {
        self.same(1.0).zip(self, S::div_f64s)
    }

    #[inline(always)]
    pub(crate) fn abs(self) -> Self {
        (self.same(0.0) - self).zip(self, S::max_f64s)
    }

    /// 1 where the number is positive, -1 where it is negative, between them at 0.
    ///
    /// Products and bounds only: comparisons with a mask would not be inlined.
    #[inline(always)]
    pub(crate) fn sign(self) -> Self {
        (self * 1e300).at_least(-1.0).map(|s, v| s.min_f64s(v, s.splat_f64s(1.0)))
    }

    /// 1 where the number is positive, 0 where it is negative, between them at 0.
    #[inline(always)]
    pub(crate) fn is_positive(self) -> Self {
        (self * 1e300).at_least(0.0).map(|s, v| s.min_f64s(v, s.splat_f64s(1.0)))
    }

    /// The larger of two.
    #[inline(always)]
    pub(crate) fn max(self, other: Self) -> Self {
        self.zip(other, S::max_f64s)
    }

    /// The smaller of two.
    #[inline(always)]
    pub(crate) fn min(self, other: Self) -> Self {
        self.zip(other, S::min_f64s)
    }

    /// At least `least`, which keeps products clear of subnormal numbers: those are slow.
    #[inline(always)]
    pub(crate) fn at_least(self, least: f64) -> Self {
        self.map(|s, v| s.max_f64s(v, s.splat_f64s(least)))
    }

    #[inline(always)]
    fn rounded(self) -> Self {
        (self + self.same(ROUND)) - self.same(ROUND)
    }

    /// Horner's rule; coefficients by falling powers.
    #[inline(always)]
    fn polynomial<const N: usize>(self, coefficients: &[f64; N]) -> Self {
        let mut sum = self.same(coefficients[0]);
        for coefficient in &coefficients[1..] {
            sum = sum.times_plus(self, self.same(*coefficient));
        }
        sum
    }

    /// exp(-v) for v >= 0; 1e-304 beyond 700.
    #[inline(always)]
    pub(crate) fn exp_of_minus(self) -> Self {
        let v = self.map(|s, v| s.min_f64s(v, s.splat_f64s(700.0)));
        let n = (v * std::f64::consts::LOG2_E).rounded();
        let rest = n * LN_2[0] - v + n * LN_2[1];
        // 2^-n: added to 2^52, the whole number 1023 - n times 2^32 stands at the foot of the upper half of the bits;
        // the exponent is twenty bits further up, where the shift puts it and drops what was above.
        let exponent = (v.same(1023.0) - n) * 4_294_967_296.0 + v.same(4_503_599_627_370_496.0);
        let scale = exponent.map(|s, v| cast(s.wrapping_dyn_shl_u32s(cast(v), s.splat_u32s(20))));
        scale * rest.polynomial(&EXP)
    }

    /// Cosine and sine, for arguments up to 1e5.
    #[inline(always)]
    pub(crate) fn cos_sin(self) -> (Self, Self) {
        let turns = (self * std::f64::consts::FRAC_1_PI).rounded();
        let rest = ((self - turns * PI[0]) - turns * PI[1]) - turns * PI[2];
        // Half turns: an odd number of them changes both signs.
        let half = turns * 0.5;
        let sign = self.same(1.0) - (half - half.rounded()).abs() * 4.0;
        let square = rest * rest;
        (sign * square.polynomial(&COS), sign * rest * square.polynomial(&SIN))
    }
}

/// Taylor's coefficients by falling powers: 1/(first + step i)! times `sign`^i.
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

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, S::add_f64s)
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, S::sub_f64s)
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, S::mul_f64s)
    }
}

impl<S: Simd> Mul<f64> for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * self.same(factor)
    }
}

impl<S: Simd> AddAssign for Lanes<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::{Arch, WithSimd};

    /// exp(-v), cos v and sin v of one number.
    struct Functions(f64);

    impl WithSimd for Functions {
        type Output = [f64; 3];

        fn with_simd<S: Simd>(self, simd: S) -> [f64; 3] {
            let v = Lanes::all(simd, self.0);
            let (cos, sin) = v.cos_sin();
            [v.exp_of_minus(), cos, sin].map(|lanes| {
                let mut list = [0.0; PADDING];
                lanes.add_to(&mut list);
                list[0]
            })
        }
    }

    #[test]
    fn exponentials_are_those_of_the_library() {
        for i in 0..70_000_u32 {
            let v = f64::from(i) * 0.01;
            let [got, ..] = Arch::new().dispatch(Functions(v));
            assert!((got / (-v).exp() - 1.0).abs() < 1e-15, "{v}: {got}");
        }
        assert!(Arch::new().dispatch(Functions(1e6))[0] < 1e-303);
    }

    #[test]
    fn cosines_and_sines_are_those_of_the_library() {
        for i in -50_000..50_000_i32 {
            let v = f64::from(i) * 0.013;
            let [_, cos, sin] = Arch::new().dispatch(Functions(v));
            assert!((cos - v.cos()).abs() < 1e-15 && (sin - v.sin()).abs() < 1e-15, "{v}");
        }
    }
}
