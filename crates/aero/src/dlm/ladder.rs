//! The exponentials of a [`KernelIntegral`], term by term, for several values of u at once.
//!
//! Only the first one or two are computed as such; the others are products of earlier ones. Values below 1e-120 are
//! raised to that, which changes nothing and keeps squares clear of subnormal numbers.
#![expect(clippy::inline_always, reason = "a call would leave the vector instructions of the loop around it")]

use crate::lanes::Lanes;
use pulp::Simd;

const LEAST: f64 = 1e-120;

/// exp(-b_n u) for n = 1, 2, 3...
pub(super) trait Ladder<S: Simd> {
    /// Ready for the first term; `b` are the exponents.
    fn start(u: Lanes<S>, b: &[f64]) -> Self;
    /// The next term.
    fn next(&mut self) -> Lanes<S>;
}

/// b doubles: the next exponential is the last one squared.
pub(super) struct Doubling<S: Simd>(Lanes<S>);

impl<S: Simd> Ladder<S> for Doubling<S> {
    #[inline(always)]
    fn start(u: Lanes<S>, b: &[f64]) -> Self {
        Self((u * b[0]).exp_of_minus())
    }

    #[inline(always)]
    fn next(&mut self) -> Lanes<S> {
        let now = self.0.at_least(LEAST);
        self.0 = now * now;
        now
    }
}

/// b grows by sqrt(2): the next exponential but one is the last one squared.
pub(super) struct HalfDoubling<S: Simd>(Lanes<S>, Lanes<S>);

impl<S: Simd> Ladder<S> for HalfDoubling<S> {
    #[inline(always)]
    fn start(u: Lanes<S>, b: &[f64]) -> Self {
        Self((u * b[0]).exp_of_minus(), (u * b[1]).exp_of_minus())
    }

    #[inline(always)]
    fn next(&mut self) -> Lanes<S> {
        let now = self.0.at_least(LEAST);
        self.0 = self.1;
        self.1 = now * now;
        now
    }
}

/// b grows by equal steps: the next exponential is the last one times the first.
pub(super) struct EqualSteps<S: Simd>(Lanes<S>, Lanes<S>);

impl<S: Simd> Ladder<S> for EqualSteps<S> {
    #[inline(always)]
    fn start(u: Lanes<S>, b: &[f64]) -> Self {
        let first = (u * b[0]).exp_of_minus().at_least(1e-20);
        Self(first, first)
    }

    #[inline(always)]
    fn next(&mut self) -> Lanes<S> {
        let now = self.1;
        self.1 = now * self.0;
        now
    }
}
