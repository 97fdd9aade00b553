//! The section's contour over the chord: heights, arc lengths, area (chord 1), and where its points are in space.

use crate::planform::Planform;
use aero::Airfoil;
use nalgebra::Point3;
use nastran::InputError;
use std::path::{Path, PathBuf};

/// Steps of the numerical arc length and area, in sqrt(x): the arc's error is below 1e-5 of it.
const STEPS: usize = 400;

/// Upper or lower surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Lower,
    Upper,
}

/// Both surfaces.
pub(super) const SIDES: [Side; 2] = [Side::Lower, Side::Upper];

/// A section of chord 1.
#[derive(Debug)]
pub(super) struct Contour {
    airfoil: Airfoil,
    /// The section's file, for complaints.
    pub(super) path: PathBuf,
}

impl Contour {
    pub(super) fn read(planform: &Planform, folder: &Path) -> Result<Self, InputError> {
        // `Planform::check` made sure that there is one.
        let path = folder.join(planform.airfoil.as_deref().unwrap_or_default());
        Ok(Self { airfoil: Airfoil::read(&path)?, path })
    }

    pub(super) fn height(&self, side: Side, x_over_c: f64) -> f64 {
        let half = 0.5 * self.airfoil.thickness(x_over_c);
        self.airfoil.camber(x_over_c) + if side == Side::Upper { half } else { -half }
    }

    pub(super) fn camber(&self, x_over_c: f64) -> f64 {
        self.airfoil.camber(x_over_c)
    }

    pub(super) fn thickness(&self, x_over_c: f64) -> f64 {
        self.airfoil.thickness(x_over_c)
    }

    /// Points of one surface between two places on the chord, dense enough to stand for the curve.
    pub(super) fn points(&self, side: Side, from: f64, to: f64) -> Vec<[f64; 2]> {
        let (low, high) = (from.sqrt(), to.sqrt());
        (0..=STEPS)
            .map(|step| {
                let x = (low + (high - low) * step as f64 / STEPS as f64).powi(2);
                [x, self.height(side, x)]
            })
            .collect()
    }

    /// Length of one surface between two places on the chord.
    pub(super) fn arc(&self, side: Side, from: f64, to: f64) -> f64 {
        length(&self.points(side, from, to))
    }

    /// Length of one surface drawn straight from chord line to chord line.
    pub(super) fn facets(&self, side: Side, lines: &[f64]) -> f64 {
        let points: Vec<[f64; 2]> = lines.iter().map(|&x| [x, self.height(side, x)]).collect();
        length(&points)
    }

    /// Enclosed area.
    pub(super) fn area(&self) -> f64 {
        let steps: Vec<f64> = (0..=STEPS).map(|step| (step as f64 / STEPS as f64).powi(2)).collect();
        self.area_between(&steps)
    }

    /// Area of the polygon with corners at the chord lines.
    pub(super) fn area_between(&self, lines: &[f64]) -> f64 {
        let strip =
            |pair: &[f64]| 0.5 * (pair[1] - pair[0]) * (self.thickness(pair[0]) + self.thickness(pair[1]));
        lines.windows(2).map(strip).sum()
    }
}

fn length(points: &[[f64; 2]]) -> f64 {
    points.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum()
}

impl Planform {
    /// A point of the section at span station `y_m`, given over the chord: placed by sweep and dihedral as the
    /// boxes, turned by the twist about the quarter chord (nose up positive).
    pub fn section_point(&self, y_m: f64, x_over_c: f64, z_over_c: f64) -> Point3<f64> {
        let fraction = (y_m / self.semispan_m).clamp(0.0, 1.0);
        let twist = (self.twist_deg.0 + fraction * (self.twist_deg.1 - self.twist_deg.0)).to_radians();
        let (sin, cos) = twist.sin_cos();
        let chord_m = self.chord_m(y_m);
        let (aft, up) = ((x_over_c - 0.25) * chord_m, z_over_c * chord_m);
        let quarter = self.point(y_m, 0.25);
        Point3::new(quarter.x + aft * cos + up * sin, quarter.y, quarter.z + up * cos - aft * sin)
    }
}

#[cfg(test)]
mod tests {
    use super::{Contour, Side};
    use aero::Airfoil;
    use std::path::PathBuf;

    const TEXT: &str = include_str!("../../../../../data/tuflex/e214.dat");

    fn shipped() -> Contour {
        let airfoil = Airfoil::parse("e214.dat", TEXT).expect("the shipped section");
        Contour { airfoil, path: PathBuf::from("e214.dat") }
    }

    #[test]
    fn both_surfaces_pass_through_the_published_points() {
        let contour = shipped();
        let words = |line: &str| -> Vec<f64> {
            line.split_whitespace().map(|word| word.parse().expect("a number")).collect()
        };
        let points: Vec<Vec<f64>> = TEXT.lines().skip(1).map(words).collect();
        // The foremost point is at 0.00005: chords count from there.
        let chord = 1.0 - 0.00005;
        for (place, point) in points.iter().enumerate() {
            let side = if place <= 32 { Side::Upper } else { Side::Lower };
            let height = contour.height(side, (point[0] - 0.00005) / chord) * chord;
            assert!((height - point[1]).abs() < 1e-12, "{point:?}: {height}");
        }
    }

    #[test]
    fn lengths_and_area_are_a_little_more_than_the_polygon_s() {
        let contour = shipped();
        // Sums over the straight lines through the file's 61 points: 2.0390 and 0.07220.
        let arc = contour.arc(Side::Upper, 0.0, 1.0) + contour.arc(Side::Lower, 0.0, 1.0);
        assert!((2.0390..2.0410).contains(&arc), "{arc}");
        assert!((0.07220..0.07240).contains(&contour.area()), "{}", contour.area());
    }
}
