//! Central composite designs for surfaces of second order: a factorial, two axial points for each factor, and centre points
//! (Box and Wilson, J. R. Stat. Soc. B 13 (1951)).

use super::{Design, full_factorial};
use crate::fault::Fault;

/// How far out the axial points are, in coded units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axial {
    /// At the faces: 1. Three levels for each factor.
    Face,
    /// At 2^(k/4): the variance of predictions depends on the distance from the centre only.
    Rotatable,
    /// A given distance.
    At(f64),
}

/// The design: factorial points in standard order, axial points, centre points.
///
/// # Errors
/// If a name cannot be used, or the distance is not above 0.
pub fn central_composite(factors: &[&str], axial: Axial, centre_points: usize) -> Result<Design, Fault> {
    let factorial = full_factorial(factors)?;
    let distance = match axial {
        Axial::Face => 1.0,
        Axial::Rotatable => (factors.len() as f64 / 4.0).exp2(),
        Axial::At(distance) => distance,
    };
    let is_good = distance > 0.0 && distance.is_finite();
    Fault::unless(is_good, "the distance of axial points", distance, "a number above 0")?;
    let mut points = factorial.points().to_vec();
    for factor in 0..factors.len() {
        for value in [-distance, distance] {
            let mut point = vec![0.0; factors.len()];
            point[factor] = value;
            points.push(point);
        }
    }
    points.extend(std::iter::repeat_n(vec![0.0; factors.len()], centre_points));
    Design::new(factors, points)
}
