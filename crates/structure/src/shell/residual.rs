//! The residual bending flexibility of Nastran's CTRIAR and CQUADR (MacNeal, A simple quadrilateral shell element, Computers
//! and Structures 8, 1978, but for a factor), with which the elastic modes of mAEWing2, a wing of CTRIAR, are within 1 % of their print. (Those of CTRIA3 and CQUAD4 are known
//! to all digits, and other: with CTRIA3's the same modes are up to 3 % off.)
//!
//! A transverse force Q bends what it crosses, by a moment that is linear in between; linear rotations have no such bending, and
//! elements without it are too stiff. So bending is counted as flexibility of the transverse shear. Of a force that is the
//! same everywhere, the moment Q x has the flexibility <x^2> / D11, the mean over the element about its middle: a^2 / 12 D11 of a
//! rectangle a by b, a^2 / 18 D11 of its half (of which MSC's have [`OF_MSC`]). A force that is linear across, Q y, is carried by that bending and by the twisting moment
//! Q y^2 / 2, whose part beyond its mean has the flexibility (<y^4> - <y^2>^2) / 4 <y^2> D33, b^2 / 60 D33 of a rectangle and 7 b^2 / 360 D33 of its
//! half: it deforms as both, side by side, do. (Bending alone would let a strip of single elements twist several times too easily.)

use crate::laminate::ShellSection;
use nalgebra::{Matrix2, Point3, Vector2, Vector3};

/// What MSC's elements have of the flexibility of a uniform force: 3/4, by prints of a single CTRIAR and a single CQUADR to seven digits (pyNastran's
/// d200obus). Of a force that varies no print of so few elements is known.
const OF_MSC: f64 = 0.75;

/// Flexibilities of transverse shear, m/N.
#[derive(Debug, Clone, Copy)]
pub(super) struct Residual {
    /// Of shear that is the same everywhere in the element.
    uniform: Matrix2<f64>,
    /// Of shear that has no mean.
    varying: Matrix2<f64>,
}

impl Residual {
    /// Of an element with `corners` over its plane: sums over the sides, which are those of a rectangle and of its half; <x^2> of any triangle.
    pub(super) fn of(corners: &[Point3<f64>], section: &ShellSection) -> Self {
        let n = corners.len();
        let (mut bending, mut twisting) = (Matrix2::zeros(), Matrix2::zeros());
        let [of_bending, of_twist] = if n == 3 { [36.0, 720.0 / 7.0] } else { [24.0, 120.0] };
        for at in 0..n {
            let side = (corners[(at + 1) % n] - corners[at]).xy();
            let across = Vector2::new(-side.y, side.x);
            let [c, s] = [side.x / side.norm(), side.y / side.norm()];
            let stiffness = |curvature: Vector3<f64>| curvature.dot(&(section.bending * curvature));
            let bent = stiffness(Vector3::new(c * c, s * s, 2.0 * c * s));
            let twisted = stiffness(Vector3::new(-c * s, c * s, c * c - s * s));
            if bent > 0.0 && twisted > 0.0 {
                bending += side * side.transpose() / (of_bending * bent);
                twisting += across * across.transpose() / (of_twist * twisted);
            }
        }
        // Side by side, stiffnesses add up.
        let stiffness = [bending, twisting].map(|part| part.try_inverse().unwrap_or_else(Matrix2::zeros));
        let varying = (stiffness[0] + stiffness[1]).try_inverse().unwrap_or_else(Matrix2::zeros);
        Self { uniform: bending * OF_MSC, varying }
    }

    /// Shear stiffness of a section with this flexibility, of uniform and of varying shear; `ratio` is that of the thickness there to the
    /// section's for which it was made.
    pub(super) fn stiffness(&self, section: &ShellSection, ratio: f64) -> [Matrix2<f64>; 2] {
        let own = section.shear.try_inverse();
        [self.uniform, self.varying].map(|added| {
            own.and_then(|own| (own + added / ratio.powi(3)).try_inverse()).unwrap_or(section.shear)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means over an element of corners by a fine grid of its unit square or triangle.
    fn mean(corners: &[Point3<f64>], value: impl Fn(Vector2<f64>) -> f64) -> f64 {
        let n = 400;
        let middle =
            corners.iter().map(|corner| corner.coords.xy()).sum::<Vector2<f64>>() / corners.len() as f64;
        let [one, other] = [1, corners.len() - 1].map(|at| (corners[at] - corners[0]).xy());
        let places = (0..n * n).map(|at| [at / n, at % n].map(|i| (f64::from(i) + 0.5) / f64::from(n)));
        let inside: Vec<f64> = places
            .filter(|[s, t]| corners.len() == 4 || s + t < 1.0)
            .map(|[s, t]| value(corners[0].coords.xy() + one * s + other * t - middle))
            .collect();
        inside.iter().sum::<f64>() / inside.len() as f64
    }

    /// The same in all directions: D11 = D22, D33, D12 = D11 - 2 D33.
    fn section(d11: f64, d33: f64) -> ShellSection {
        let d12 = d11 - 2.0 * d33;
        let bending = nalgebra::Matrix3::new(d11, d12, 0.0, d12, d11, 0.0, 0.0, 0.0, d33);
        ShellSection { bending, ..ShellSection::laminate(&[], 0.0, crate::laminate::ShearModel::Equilibrium) }
    }

    #[test]
    fn a_linear_moment_bends_by_the_mean_square_of_its_arm() {
        let triangle = [[0.0, 0.0, 0.0], [1.3, 0.2, 0.0], [0.3, 0.9, 0.0]].map(Point3::from);
        let parallelogram =
            [[0.0, 0.0, 0.0], [1.3, 0.2, 0.0], [1.6, 1.1, 0.0], [0.3, 0.9, 0.0]].map(Point3::from);
        for corners in [&triangle[..], &parallelogram] {
            let found = Residual::of(corners, &section(3.0, 1.5)).uniform;
            for (i, j) in [(0, 0), (0, 1), (1, 1)] {
                let expected = OF_MSC * mean(corners, |r| r[i] * r[j]) / 3.0;
                assert!(
                    (found[(i, j)] - expected).abs() < 5e-3 * found.norm(),
                    "{i} {j}: {} {expected}",
                    found[(i, j)]
                );
            }
        }
    }

    #[test]
    fn shear_that_varies_is_carried_by_bending_and_twist_side_by_side() {
        let half = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.5, 0.0]].map(Point3::from);
        let rectangle =
            [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 0.5, 0.0], [0.0, 0.5, 0.0]].map(Point3::from);
        let twist = |corners: &[Point3<f64>]| {
            // across y in x direction: the moment (y² - <y²>) / 2 beside the force y
            let [second, fourth] = [2, 4].map(|power| mean(corners, |r| r.y.powi(power)));
            (fourth - second * second) / (4.0 * second * 1.5)
        };
        for corners in [&half[..], &rectangle] {
            let soft_in_bending = Residual::of(corners, &section(1e-9, 1.5)).varying;
            assert!(
                (soft_in_bending[(0, 0)] / twist(corners) - 1.0).abs() < 0.01,
                "{soft_in_bending} {}",
                twist(corners)
            );
        }
        let both = 1.0 / Residual::of(&rectangle, &section(3.0, 1.5)).varying[(0, 0)];
        let expected = 1.0 / twist(&rectangle) + 3.0 / mean(&rectangle, |r| r.x * r.x);
        assert!((both / expected - 1.0).abs() < 1e-3, "{both} {expected}");
    }
}
