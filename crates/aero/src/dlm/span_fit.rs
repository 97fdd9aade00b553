//! Integrals along the doublet line: the kernel's numerator fitted by a polynomial between a few of its values.
//!
//! The incidence that a strip of half width e induces at a point, y along and z across the strip's plane, is
//!
//! ```text
//! chord/(8 pi) int_-e^e [ N1(eta) T1/rho^2 + N2(eta) T2(eta)/rho^4 ] d eta,   rho^2 = (y-eta)^2 + z^2
//! ```
//!
//! (finite part in the plane). Numerators are replaced by the parabola through three points (Giesing, Kalman and Rodden,
//! AFFDL-TR-71-5, 1971) or the quartic through five (Rodden, Taylor and McIntosh, Journal of Aircraft 35, 1998). The
//! integral is then a sum of the numerators at those points with weights that depend on y/e and z/e only. They are made
//! of the moments of 1/rho^2 and 1/rho^4, which follow from the first two by a recurrence (eta^2 = rho^2 + 2 y eta - y^2 -
//! z^2), and far from the strip, where that cancels, from Gauss' rule; so no series is cut off, and size changes nothing.
//!
//! Within [`PLANAR`] half widths of the plane a point is taken to be in it: the fit's error would be divided by z there.
//! In the plane each end of the line has a core as the vortex lattice's legs have, so that a tail in line with the edges
//! of a wing's strips gets the mean of its neighbours. Besides its pole each end has a logarithm, with a wider core: its
//! factor is the fit's slope at the end, which is nothing in the kernel itself but differs between neighbouring fits.

use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Points closer to a strip's plane than this many half widths of the strip are in it (as in Nastran).
pub const PLANAR: f64 = 1e-3;
/// Core of the logarithm over the smaller half width of the two strips.
pub(super) const LOGARITHM_CORE: f64 = 0.1;

/// Cores of the line's ends, in half widths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cores {
    pub(super) pole: f64,
    pub(super) logarithm: f64,
}

/// Beyond this many half widths from the middle Gauss' rule is exact to round-off.
const FAR: f64 = 3.0;
/// Points of Gauss' rule; at FAR its error is 6^-32.
const GAUSS: usize = 16;
/// Most points of a fit.
pub(super) const MOST_POINTS: usize = 5;

/// Polynomial that stands for the kernel's numerator along the doublet line of a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum SpanFit {
    /// Second degree, three points: boxes must be short (aspect ratio below 3).
    Parabolic,
    /// Fourth degree, five points.
    #[default]
    Quartic,
}

impl SpanFit {
    /// Places of the points along the line, in half widths from the middle.
    pub fn points(self) -> &'static [f64] {
        match self {
            Self::Parabolic => &[-1.0, 0.0, 1.0],
            Self::Quartic => &[-1.0, -0.5, 0.0, 0.5, 1.0],
        }
    }

    /// Coefficients by powers, lowest first, of the polynomial that is 1 at point `i` and 0 at the others.
    fn cardinal(self, i: usize) -> [f64; MOST_POINTS] {
        let points = self.points();
        let mut product = [1.0, 0.0, 0.0, 0.0, 0.0];
        for at in points.iter().filter(|at| **at != points[i]) {
            let scale = 1.0 / (points[i] - at);
            let mut next = [0.0; MOST_POINTS];
            for power in 0..MOST_POINTS {
                let raised = if power == 0 { 0.0 } else { product[power - 1] };
                next[power] = (raised - at * product[power]) * scale;
            }
            product = next;
        }
        product
    }
}

/// Weights of the numerators at the points of a fit, for lengths in half widths: [for N1 T1, for N2 T2].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weights(pub(super) [[f64; MOST_POINTS]; 2]);

/// The weights for a point at (y, z), both in half widths, with `cores` of the line's ends.
pub(super) fn weights(fit: SpanFit, y: f64, z: f64, cores: Cores) -> Weights {
    let moments = moments(y, z.abs(), cores);
    let mut weights = [[0.0; MOST_POINTS]; 2];
    for i in 0..fit.points().len() {
        let cardinal = fit.cardinal(i);
        for (weights, moments) in weights.iter_mut().zip(&moments) {
            weights[i] = cardinal.iter().zip(moments).map(|(c, m)| c * m).sum();
        }
    }
    Weights(weights)
}

/// Moments 0 to 4 of 1/rho^2 and of 1/rho^4 over -1..1; those of 1/rho^4 are 0 in the plane.
fn moments(y: f64, z: f64, cores: Cores) -> [[f64; MOST_POINTS]; 2] {
    let planar = z <= PLANAR;
    let [first, mut second] = if y * y + z * z > FAR * FAR {
        far_moments(y, z)
    } else if planar {
        in_plane(y, cores)
    } else {
        near_moments(y, z)
    };
    if planar {
        second = [0.0; MOST_POINTS];
    }
    [first, second]
}

/// Nodes and weights of Gauss' rule on -1..1.
static RULE: LazyLock<[(f64, f64); GAUSS]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let n = GAUSS as f64;
        let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            // Legendre's polynomial by its three-term recurrence, then Newton's step.
            let (mut p, mut before) = (1.0, 0.0);
            for degree in 0..GAUSS {
                let d = degree as f64;
                (p, before) = (((2.0 * d + 1.0) * x * p - d * before) / (d + 1.0), p);
            }
            slope = n * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
});

fn far_moments(y: f64, z: f64) -> [[f64; MOST_POINTS]; 2] {
    let mut moments = [[0.0; MOST_POINTS]; 2];
    for (eta, weight) in RULE.iter() {
        let inverse = 1.0 / ((y - eta) * (y - eta) + z * z);
        let (mut one, mut two) = (weight * inverse, weight * inverse * inverse);
        let [first, second] = &mut moments;
        for (first, second) in first.iter_mut().zip(second) {
            *first += one;
            *second += two;
            one *= eta;
            two *= eta;
        }
    }
    moments
}

/// Continues the first two moments of 1/rho^2 to the fourth.
fn continued(zeroth: f64, first: f64, y: f64, square: f64) -> [f64; MOST_POINTS] {
    let second = 2.0 + 2.0 * y * first - square * zeroth;
    let third = 2.0 * y * second - square * first;
    let fourth = 2.0 / 3.0 + 2.0 * y * third - square * second;
    [zeroth, first, second, third, fourth]
}

/// In the plane, finite part; within the core of an end its pole falls to zero.
fn in_plane(y: f64, cores: Cores) -> [[f64; MOST_POINTS]; 2] {
    let pole = |d: f64| d / (d * d).max(cores.pole * cores.pole);
    let distance = |d: f64| d.abs().max(cores.logarithm);
    // By parts: int eta^p/(eta-y)^2 = -[eta^p/(eta-y)] + p int eta^(p-1)/(eta-y), of which the last by recurrence. So a
    // pole has the value at the end as its factor, and taking it away takes nothing else.
    let mut simple = (distance(y - 1.0) / distance(y + 1.0)).ln();
    let mut moments = [0.0; MOST_POINTS];
    for (power, moment) in moments.iter_mut().enumerate() {
        let (p, even) = (power as f64, power % 2 == 0);
        let left = pole(y + 1.0);
        *moment = pole(y - 1.0) - if even { left } else { -left };
        if power > 0 {
            *moment += p * simple;
            simple = y * simple + if even { 0.0 } else { 2.0 / p };
        }
    }
    [moments, [0.0; MOST_POINTS]]
}

/// Out of the plane.
fn near_moments(y: f64, z: f64) -> [[f64; MOST_POINTS]; 2] {
    let (right, left) = ((1.0 - y).powi(2) + z * z, (1.0 + y).powi(2) + z * z);
    let square = y * y + z * z;
    let zeroth = (2.0 * z).atan2(square - 1.0) / z;
    let log = 0.5 * (right / left).ln();
    let one = continued(zeroth, y * zeroth + log, y, square);
    let s0 = (zeroth + (1.0 - y) / right + (1.0 + y) / left) / (2.0 * z * z);
    let s1 = y * s0 + 0.5 * (1.0 / left - 1.0 / right);
    let s2 = one[0] + 2.0 * y * s1 - square * s0;
    let s3 = one[1] + 2.0 * y * s2 - square * s1;
    let s4 = one[2] + 2.0 * y * s3 - square * s2;
    [one, [s0, s1, s2, s3, s4]]
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORES: Cores = Cores { pole: 0.01, logarithm: 0.1 };

    /// The same moments by Simpson's rule with very many steps.
    fn by_quadrature(y: f64, z: f64) -> [[f64; MOST_POINTS]; 2] {
        let parts = 400_000_u32;
        let h = 2.0 / f64::from(parts);
        let mut sum = [[0.0; MOST_POINTS]; 2];
        for i in 0..=parts {
            let ends = if i == 0 || i == parts { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            let eta = -1.0 + h * f64::from(i);
            let inverse = 1.0 / ((y - eta).powi(2) + z * z);
            let mut weight = ends * h / 3.0;
            let [one, two] = &mut sum;
            for (one, two) in one.iter_mut().zip(two) {
                *one += weight * inverse;
                *two += weight * inverse * inverse;
                weight *= eta;
            }
        }
        sum
    }

    #[test]
    fn moments_are_those_of_quadrature_near_and_far() {
        for (y, z) in [
            (0.0, 0.01),
            (0.3, 0.1),
            (0.99, 0.05),
            (1.5, 0.02),
            (-2.0, 1.0),
            (2.9, 0.7),
            (3.1, 0.7),
            (-40.0, 9.0),
        ] {
            let (got, want) = (moments(y, z, CORES), by_quadrature(y, z));
            for kind in 0..2 {
                for power in 0..MOST_POINTS {
                    let (got, want) = (got[kind][power], want[kind][power]);
                    let size = by_quadrature(y, z)[kind][0].abs();
                    assert!((got - want).abs() < 1e-10 * size, "{kind} {power} at {y}, {z}: {got} {want}");
                }
            }
        }
    }

    #[test]
    fn in_the_plane_the_finite_part_is_the_limit_of_the_sum_without_its_infinite_part() {
        // pi/z for a point above the line, nothing beside it, and the same with powers of y.
        for y in [-0.5, 0.2, 1.7_f64] {
            let (plane, z): (_, f64) = (in_plane(y, CORES), 1e-5);
            let above = near_moments(y, z);
            for power in 0..MOST_POINTS {
                let infinite =
                    if y.abs() < 1.0 { PI / z * y.powi(i32::try_from(power).unwrap_or(0)) } else { 0.0 };
                let want = above[0][power] - infinite;
                assert!((plane[0][power] - want).abs() < 3e-4, "{y} {power}: {} {want}", plane[0][power]);
            }
        }
    }

    #[test]
    fn a_polynomial_of_the_fits_degree_is_integrated_exactly() {
        for (fit, degree) in [(SpanFit::Parabolic, 2), (SpanFit::Quartic, 4)] {
            for power in 0..=degree {
                let Weights([one, two]) = weights(fit, 0.4, 0.3, CORES);
                let at = |weights: [f64; MOST_POINTS]| -> f64 {
                    fit.points().iter().zip(weights).map(|(p, w)| w * p.powi(power)).sum()
                };
                let want = by_quadrature(0.4, 0.3);
                let i = usize::try_from(power).unwrap_or(0);
                assert!((at(one) - want[0][i]).abs() < 1e-10 && (at(two) - want[1][i]).abs() < 1e-9);
            }
        }
    }

    /// With a sixteenth of a half width between its points and so far away Simpson's rule is as good as exact.
    #[test]
    fn moments_far_away_are_those_of_quadrature_in_every_direction() {
        let places = [(0.0, 3.2), (3.2, 0.2), (5.0, 5.0), (-5.0, 5.0), (-200.0, 0.5), (200.0, 0.5)];
        for (y, z) in places.into_iter().chain([(0.5, 200.0), (-40.0, 0.01), (0.01, 40.0), (-9.0, 5e-4)]) {
            let (got, planar) = (moments(y, z, CORES), z <= PLANAR);
            let parts = 4000_u32;
            let mut want = [[0.0; MOST_POINTS]; 2];
            for i in 0..=parts {
                let ends = if i == 0 || i == parts { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
                let eta = f64::from(i) * 2.0 / f64::from(parts) - 1.0;
                let inverse = 1.0 / ((y - eta).powi(2) + z * z);
                let [one, two] = &mut want;
                for (power, (one, two)) in one.iter_mut().zip(two).enumerate() {
                    let weight =
                        ends * 2.0 / f64::from(3 * parts) * eta.powi(i32::try_from(power).unwrap_or(0));
                    *one += weight * inverse;
                    *two += if planar { 0.0 } else { weight * inverse * inverse };
                }
            }
            for kind in 0..2 {
                for power in 0..MOST_POINTS {
                    let (got, want, size) = (got[kind][power], want[kind][power], want[kind][0]);
                    assert!((got - want).abs() <= 1e-11 * size, "{kind} {power} at {y}, {z}: {got} {want}");
                }
            }
        }
    }

    /// Sixteen points integrate powers up to the thirty-first exactly.
    #[test]
    fn gauss_rule_is_exact_for_as_many_powers_as_it_has_numbers() {
        assert!(RULE.windows(2).all(|pair| pair[0].0 > pair[1].0));
        for power in 0..32 {
            let sum: f64 = RULE.iter().map(|(x, weight)| weight * x.powi(power)).sum();
            let want = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
            assert!((sum - want).abs() < 1e-14, "x^{power}: {sum} instead of {want}");
        }
    }

    /// A pole at either end has eta^p there as its factor, 1 or -1 at the left; its core makes d/core^2 of
    /// 1/d and touches no more. The logarithm's factor is the slope p eta^(p-1), as y^(p-1) to within d.
    #[test]
    fn cores_act_on_the_poles_and_the_logarithms_of_the_ends_alone() {
        let tiny = Cores { pole: 1e-9, logarithm: 1e-9 };
        for d in [-0.004, 0.004, 0.007, -0.0095] {
            for end in [1.0, -1.0] {
                let y: f64 = end + d;
                let plain = in_plane(y, tiny);
                let with_pole = in_plane(y, Cores { pole: 0.01, ..tiny });
                let with_log = in_plane(y, Cores { logarithm: 0.05, ..tiny });
                for power in 0..MOST_POINTS {
                    let p = i32::try_from(power).unwrap_or(0);
                    let pole = end.powi(p) * end * (d / 1e-4 - 1.0 / d);
                    let got = with_pole[0][power] - plain[0][power];
                    assert!((got - pole).abs() < 1e-9, "pole of {power} at {y}: {got} instead of {pole}");
                    let log =
                        if p == 0 { 0.0 } else { f64::from(p) * y.powi(p - 1) * end * (0.05 / d.abs()).ln() };
                    let got = with_log[0][power] - plain[0][power];
                    assert!((got - log).abs() < 1e-9, "logarithm of {power} at {y}: {got} instead of {log}");
                }
                assert_eq!([plain[1], with_pole[1], with_log[1]], [[0.0; MOST_POINTS]; 3]);
            }
        }
        // On the end itself there is nothing of its own pole, and the other one is 1/2 away.
        assert_eq!(in_plane(1.0, CORES)[0][0], -0.5);
        assert_eq!(in_plane(-1.0, CORES)[0][0], -0.5);
    }

    #[test]
    fn a_thousandth_of_a_half_width_is_the_plane_and_both_sides_of_it_are_alike() {
        assert_eq!(moments(0.3, PLANAR, CORES), moments(0.3, 0.0, CORES));
        assert_eq!(moments(0.3, 0.0, CORES)[0], in_plane(0.3, CORES)[0]);
        let above = moments(0.3, 1.001 * PLANAR, CORES);
        assert!((above[0][0] / (PI / (1.001 * PLANAR)) - 1.0).abs() < 1e-2, "{}", above[0][0]);
        for fit in [SpanFit::Parabolic, SpanFit::Quartic] {
            for z in [5e-4, 0.2, 4.0] {
                assert_eq!(weights(fit, 0.4, z, CORES), weights(fit, 0.4, -z, CORES));
            }
        }
        // Each polynomial is 1 at its own point and 0 at the others.
        for fit in [SpanFit::Parabolic, SpanFit::Quartic] {
            for (i, own) in fit.points().iter().enumerate() {
                for point in fit.points() {
                    let value: f64 = fit.cardinal(i).iter().rev().fold(0.0, |sum, c| sum * point + c);
                    let want = f64::from(u8::from(own == point));
                    assert!((value - want).abs() < 1e-14, "{fit:?} {own} at {point}: {value}");
                }
            }
        }
    }
}
