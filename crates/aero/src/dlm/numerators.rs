//! The kernel's numerators for many pairs of boxes at once: the inner loop.
//!
//! The equations are those of `kernel.rs`, arranged for speed. Boxes of one strip share y and z, so all pairs of boxes
//! of two strips share r and k = kappa r, and with them what multiplies the exponentials ([`Coefficients`]). With
//! a = |u|, P = sum p_n exp(-b_n a), Q likewise, g = 1 - a/s:
//!
//! ```text
//! B1 = g + P,  B2 = (2 + i k a) g - a/s^3 + (1 + i k a) P + Q        (I1 and 3 I2 without exp(-i k a))
//! p_n = -i k a_n/(b_n + i k),  q_n = k^2 a_n/(b_n + i k)^2
//! ```
//!
//! For u < 0, -conj(B) takes the place of B and 2 Re B(0) exp(-i kappa x) comes on top. The phases of exp(-i k u) and
//! exp(-i kappa x) add up to -kappa M (R - M x)/beta^2, which is nothing at Mach 0.
#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use crate::dlm::exponentials::KernelIntegral;
use crate::dlm::ladder::{Doubling, EqualSteps, HalfDoubling, Ladder};
use crate::lanes::{Lanes, PADDING};
use faer::c64;
use pulp::{Arch, Simd, WithSimd};

/// What all pairs of boxes share.
#[derive(Debug, Clone)]
pub(super) struct Stream {
    pub(super) mach: f64,
    /// omega/V, 1/m.
    pub(super) kappa: f64,
    pub(super) integral: KernelIntegral,
    a: Vec<f64>,
    b: Vec<f64>,
}

impl Stream {
    pub(super) fn new(mach: f64, kappa: f64, integral: KernelIntegral) -> Self {
        let (a, b) = integral.terms().into_iter().unzip();
        Self { mach, kappa, integral, a, b }
    }
}

/// What the pairs of boxes of two strips share at one point of the doublet line.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    r: f64,
    /// Weights of N1 and N2.
    weights: [f64; 2],
    /// Real and imaginary parts of p_n and q_n.
    terms: Vec<[f64; 4]>,
    /// 2 Re B1(0) and 2 Re B2(0).
    whole: [f64; 2],
}

impl Coefficients {
    /// For a distance `r` (m, greater than 0) across the stream.
    pub(super) fn set(&mut self, stream: &Stream, r: f64, weights: [f64; 2]) {
        let k = stream.kappa * r;
        (self.r, self.weights) = (r, weights);
        self.terms.clear();
        self.whole = [2.0, 4.0];
        for (a, b) in stream.a.iter().zip(&stream.b) {
            let inverse = c64::new(*b, k).inv();
            let p = c64::new(0.0, -k * a) * inverse;
            let q = inverse * inverse * (k * k * a);
            self.terms.push([p.re, p.im, q.re, q.im]);
            self.whole[0] += 2.0 * p.re;
            self.whole[1] += 2.0 * (p.re + q.re);
        }
    }
}

/// Pairs of boxes of two strips, padded to whole vectors: numbers of the pairs in, sums of numerators out.
#[derive(Debug, Clone, Default)]
pub(super) struct Pairs {
    /// Distance downstream, m.
    pub(super) x: Vec<f64>,
    /// Real and imaginary part of exp(-i kappa x).
    pub(super) shift: [Vec<f64>; 2],
    /// Real and imaginary part of the weighted sum of numerators so far.
    pub(super) sum: [Vec<f64>; 2],
}

impl Pairs {
    /// Room for `count` pairs, sums at zero.
    pub(super) fn reset(&mut self, count: usize) {
        let padded = count.next_multiple_of(PADDING);
        for list in self.shift.iter_mut().chain(&mut self.sum).chain([&mut self.x]) {
            list.clear();
            list.resize(padded, 0.0);
        }
        // Any place but the doublet's own will do for the pairs that are not there.
        self.x[count..].fill(1.0);
    }

    /// Adds the weighted numerators of one point of the line.
    pub(super) fn add(&mut self, arch: Arch, stream: &Stream, at: &Coefficients) {
        arch.dispatch(Step { stream, at, pairs: self });
    }
}

struct Step<'a> {
    stream: &'a Stream,
    at: &'a Coefficients,
    pairs: &'a mut Pairs,
}

impl WithSimd for Step<'_> {
    type Output = ();

    /// Compiled once for each set of vector instructions; everything it calls is inlined.
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { stream, at, pairs } = self;
        let flat = at.weights[1] == 0.0;
        match (stream.integral, flat) {
            (KernelIntegral::Desmarais, true) => all::<S, Doubling<S>, false>(simd, stream, at, pairs),
            (KernelIntegral::Desmarais, false) => all::<S, Doubling<S>, true>(simd, stream, at, pairs),
            (KernelIntegral::Laschka, true) => all::<S, EqualSteps<S>, false>(simd, stream, at, pairs),
            (KernelIntegral::Laschka, false) => all::<S, EqualSteps<S>, true>(simd, stream, at, pairs),
            (KernelIntegral::Fine, true) => all::<S, HalfDoubling<S>, false>(simd, stream, at, pairs),
            (KernelIntegral::Fine, false) => all::<S, HalfDoubling<S>, true>(simd, stream, at, pairs),
        }
    }
}

#[inline(always)]
fn all<S: Simd, L: Ladder<S>, const SECOND: bool>(
    simd: S,
    stream: &Stream,
    at: &Coefficients,
    pairs: &mut Pairs,
) {
    let Pairs { x, shift: [cos, sin], sum: [re, im] } = pairs;
    let width = Lanes::<S>::WIDTH;
    let inputs = x.chunks_exact(width).zip(cos.chunks_exact(width)).zip(sin.chunks_exact(width));
    let outputs = re.chunks_exact_mut(width).zip(im.chunks_exact_mut(width));
    for (((x, cos), sin), (re, im)) in inputs.zip(outputs) {
        let shift = (Lanes::load(simd, cos), Lanes::load(simd, sin));
        let sum = several::<S, L, SECOND>(stream, at, Lanes::load(simd, x), shift);
        sum.0.add_to(re);
        sum.1.add_to(im);
    }
}

/// P and Q of the module's equations.
#[inline(always)]
fn sums<S: Simd, L: Ladder<S>, const SECOND: bool>(
    stream: &Stream,
    at: &Coefficients,
    a: Lanes<S>,
) -> [Lanes<S>; 4] {
    let same = |value: f64| a.same(value);
    let mut ladder = L::start(a, &stream.b);
    let mut sums = [a.same(0.0); 4];
    for term in &at.terms {
        let e = ladder.next();
        sums[0] = e.times_plus(same(term[0]), sums[0]);
        sums[1] = e.times_plus(same(term[1]), sums[1]);
        if SECOND {
            sums[2] = e.times_plus(same(term[2]), sums[2]);
            sums[3] = e.times_plus(same(term[3]), sums[3]);
        }
    }
    sums
}

/// Weighted numerators of some pairs; `shift` is exp(-i kappa x).
#[inline(always)]
fn several<S: Simd, L: Ladder<S>, const SECOND: bool>(
    stream: &Stream,
    at: &Coefficients,
    x: Lanes<S>,
    shift: (Lanes<S>, Lanes<S>),
) -> (Lanes<S>, Lanes<S>) {
    let (one, zero, mach) = (x.same(1.0), x.same(0.0), stream.mach);
    let beta_2 = 1.0 - mach * mach;
    let big_r = (x * x + x.same(beta_2 * at.r * at.r)).sqrt();
    let inverse = big_r.recip();
    let u = (big_r * mach - x) * (1.0 / (beta_2 * at.r));
    let (a, sign) = (u.abs(), u.sign());
    let s = (one + u * u).sqrt();
    let inverse_s = s.recip();
    // 1 - a/s without cancellation.
    let g = inverse_s * (s + a).recip();
    let [p_re, p_im, q_re, q_im] = sums::<S, L, SECOND>(stream, at, a);
    let slope = x * inverse;
    let ratio = inverse * (mach * at.r);
    let turn = phase(stream, big_r, x);
    let past = (one - sign) * 0.5;
    let whole = past * at.whole[0];
    let (re, im) = turned((sign * (g + p_re) + ratio * inverse_s, p_im), turn);
    let first =
        ((re + whole * shift.0 - one - slope) * at.weights[0], (im + whole * shift.1) * at.weights[0]);
    if !SECOND {
        return first;
    }
    let ka = a * (stream.kappa * at.r);
    let inverse_s3 = inverse_s * inverse_s * inverse_s;
    let b_re = (g + g) - a * inverse_s3 + p_re - ka * p_im + q_re;
    let b_im = ka * (g + p_re) + p_im + q_im;
    let near = inverse * inverse * (beta_2 * at.r * at.r);
    let two = one + one;
    let steady = ratio * inverse_s3 * (s * s * near + two + ratio * u);
    let inside = (sign * b_re + steady, b_im + ratio * ratio * inverse_s * (stream.kappa * at.r));
    let whole = past * at.whole[1];
    let (re, im) = turned(inside, turn);
    let second = (slope * (near + two) + two - re - whole * shift.0, zero - im - whole * shift.1);
    (first.0 + second.0 * at.weights[1], first.1 + second.1 * at.weights[1])
}

/// exp(-i kappa M (R - M x)/beta^2).
#[inline(always)]
fn phase<S: Simd>(stream: &Stream, big_r: Lanes<S>, x: Lanes<S>) -> (Lanes<S>, Lanes<S>) {
    let mach = stream.mach;
    if mach == 0.0 {
        return (x.same(1.0), x.same(0.0));
    }
    ((big_r - x * mach) * (-stream.kappa * mach / (1.0 - mach * mach))).cos_sin()
}

#[inline(always)]
fn turned<S: Simd>(value: (Lanes<S>, Lanes<S>), by: (Lanes<S>, Lanes<S>)) -> (Lanes<S>, Lanes<S>) {
    (value.0 * by.0 - value.1 * by.1, value.0 * by.1 + value.1 * by.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dlm::kernel::{Separation, numerators};

    #[test]
    fn eight_at_once_are_one_by_one() {
        for integral in [KernelIntegral::Desmarais, KernelIntegral::Laschka, KernelIntegral::Fine] {
            for (mach, kappa, r) in [(0.0, 0.8, 0.3), (0.5, 3.0, 0.02), (0.8, 0.1, 2.0), (0.6, 20.0, 1.0)] {
                let stream = Stream::new(mach, kappa, integral);
                for weights in [[1.0, 0.0], [0.0, 1.0], [0.3, -0.7]] {
                    let mut at = Coefficients::default();
                    at.set(&stream, r, weights);
                    let mut pairs = Pairs::default();
                    let places = [-30.0, -1.0, -0.1, 0.0, 0.05, 0.2, 0.7, 3.0, 12.0, 40.0];
                    pairs.reset(places.len());
                    for (i, x) in places.iter().enumerate() {
                        (pairs.x[i], pairs.shift[0][i], pairs.shift[1][i]) =
                            (*x, (kappa * x).cos(), -(kappa * x).sin());
                    }
                    pairs.add(Arch::new(), &stream, &at);
                    for (i, x_m) in places.iter().copied().enumerate() {
                        let [one, two] = numerators(Separation { x_m, r_m: r }, mach, kappa, integral);
                        let want = one * weights[0] + two * weights[1];
                        let got = c64::new(pairs.sum[0][i], pairs.sum[1][i]);
                        assert!(
                            (got - want).norm() < 2e-11,
                            "{integral:?} Mach {mach} x {x_m}: {got} {want}"
                        );
                    }
                }
            }
        }
    }
}
