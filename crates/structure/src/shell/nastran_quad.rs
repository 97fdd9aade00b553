//! The stiffness of Nastran's CQUAD4, as MSC Nastran prints it of single elements (to ten digits, a square and a trapezoid; see the tests).
//!
//! - Curvature is what the membrane's strain is, rotations in the place of displacements: bilinear with four incompatible modes (Taylor, Beresford and
//!   Wilson 1976).
//! - Transverse shear is tied at the middles of the sides along these, linear across in axes that halve the angle of the diagonals: `g_x` = c1 + c2 eta,
//!   `g_y` = c3 + c4 xi. Each of the two has a flexibility over its values at -+ 1/sqrt 3: that of the section, and that of the bending that linear rotations lack
//!   (MacNeal, A simple quadrilateral shell element, Computers and Structures 8, 1978), dx^2 / (12 A D11) times 1 + a on and 1 - a off the diagonal with
//!   a = e / (e + (1 - e) dx^2 / dy^2), e = 1/40; dx and dy are the distances between the middles of opposite sides.
//! - Rotations about the normal are tied to the membrane's own, without modes, at the corners, each with the area of its two sides' parallelogram.

use super::point::{Point, tie_stiffness};
use super::quad::{self, CORNERS};
use super::side_shears::{along, side_shears};
use crate::laminate::ShellSection;
use nalgebra::{Matrix2, Matrix3, Matrix4, Point3, RowVector4, SMatrix, Vector2, Vector3};
use std::ops::AddAssign as _;

type Matrix24 = SMatrix<f64, 24, 24>;

/// MacNeal's epsilon.
const EPSILON: f64 = 1.0 / 40.0;

/// Natural coordinate of the Gauss points.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Natural coordinates of the middles of the sides.
const MIDDLES: [[f64; 2]; 4] = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];

/// Motions that stretch the middle surface, deflections that of a warped one.
const MEMBRANE: [usize; 12] = [0, 1, 2, 6, 7, 8, 12, 13, 14, 18, 19, 20];

/// Motions that bend it.
const BENDING: [usize; 8] = [3, 4, 9, 10, 15, 16, 21, 22];

/// A quadrilateral: its corners over its plane, its section and what its thickness is in units of the section's.
pub(super) struct NastranQuad<'a> {
    pub(super) corners: &'a [Point3<f64>],
    pub(super) section: &'a ShellSection,
    /// The 2 x 2 Gauss points with their thickness.
    pub(super) points: &'a [Point<24>],
    /// At the corners; empty if it is the section's everywhere.
    pub(super) thickness: &'a [f64],
}

impl NastranQuad<'_> {
    /// Membrane, bending and transverse shear.
    pub(super) fn stiffness(&self) -> Matrix24 {
        self.in_plane() + self.across()
    }

    /// The tie of the rotations about the normal, in units of the membrane's shear stiffness.
    pub(super) fn tie(&self, tie: f64) -> Matrix24 {
        let corners: Vec<Point<24>> =
            CORNERS.iter().map(|at| self.thickened(quad::point(self.corners, *at, 4.0))).collect();
        tie_stiffness(&corners, self.section, tie)
    }

    fn thickened(&self, point: Point<24>) -> Point<24> {
        let thickness = match self.thickness {
            [] => 1.0,
            ratios => point.shape.iter().zip(ratios).map(|(n, ratio)| n * ratio).sum(),
        };
        Point { thickness, ..point }
    }

    /// Membrane and bending, the incompatible modes of both condensed.
    fn in_plane(&self) -> Matrix24 {
        if self.section.is_coupled() {
            return self.coupled();
        }
        let mut all = Matrix24::zeros();
        self.add_alone(&mut all, MEMBRANE, |point| &point.membrane, |section| &section.membrane);
        self.add_alone(&mut all, BENDING, |point| &point.bending, |section| &section.bending);
        all
    }

    /// Adds membrane or bending of a section that does not couple them: strains of some motions and of the modes.
    fn add_alone<const M: usize>(
        &self,
        all: &mut Matrix24,
        motions: [usize; M],
        strains: fn(&Point<24>) -> &SMatrix<f64, 3, 24>,
        stiffness: fn(&ShellSection) -> &Matrix3<f64>,
    ) {
        let (mut uu, mut ua) = (SMatrix::<f64, M, M>::zeros(), SMatrix::<f64, M, 4>::zeros());
        let mut aa = Matrix4::zeros();
        for point in self.points {
            let own = SMatrix::<f64, 3, M>::from_fn(|i, j| strains(point)[(i, motions[j])]);
            let stiffness = stiffness(&self.section.thickened(point.thickness)) * point.area_m2;
            let stress = stiffness * own;
            uu += own.transpose() * stress;
            ua += stress.transpose() * point.modes;
            aa += point.modes.transpose() * stiffness * point.modes;
        }
        // A section may have a membrane alone, or bending alone.
        if let Some(factor) = aa.cholesky() {
            uu -= ua * factor.solve(&ua.transpose());
        }
        for (j, column) in motions.into_iter().enumerate() {
            for (i, row) in motions.into_iter().enumerate() {
                all[(row, column)] += uu[(i, j)];
            }
        }
    }

    /// Membrane and bending of a section that couples them.
    fn coupled(&self) -> Matrix24 {
        let mut uu = Matrix24::zeros();
        let mut across = SMatrix::<f64, 24, 8>::zeros();
        let mut of_modes = SMatrix::<f64, 8, 8>::zeros();
        for point in self.points {
            let section = self.section.thickened(point.thickness);
            let (a, b, d) = (&section.membrane, &section.coupling, &section.bending);
            let (m, k, modes) = (&point.membrane, &point.bending, &point.modes);
            let force = (a * m + b * k) * point.area_m2;
            let moment = (b * m + d * k) * point.area_m2;
            uu += m.transpose() * force + k.transpose() * moment;
            for (at, stress) in [(0, force), (4, moment)] {
                across.fixed_columns_mut::<4>(at).add_assign(&(stress.transpose() * modes));
            }
            for ((i, j), stiffness) in [((0, 0), a), ((0, 4), b), ((4, 0), b), ((4, 4), d)] {
                let work = modes.transpose() * stiffness * modes * point.area_m2;
                of_modes.fixed_view_mut::<4, 4>(i, j).add_assign(&work);
            }
        }
        of_modes.cholesky().map_or(uu, |factor| uu - across * factor.solve(&across.transpose()))
    }

    /// Transverse shear.
    fn across(&self) -> Matrix24 {
        let halving = halving(self.corners);
        let bending = [0, 1].map(|axis| self.bending_flexibility(&halving.row(axis).transpose()));
        let ([Some(bending_x), Some(bending_y)], Some(inverse), Some(mut flexibility)) =
            (bending, self.side_constants(&halving).try_inverse(), self.shear_flexibility(&halving))
        else {
            return Matrix24::zeros();
        };
        let [dx, dy] = self.between_sides(&halving);
        let area: f64 = self.points.iter().map(|point| point.area_m2).sum();
        for (first, long, wide, bending) in [(0, dx, dy, bending_x), (2, dy, dx, bending_y)] {
            let a = EPSILON / (EPSILON + (1.0 - EPSILON) * (long / wide).powi(2));
            let own =
                Matrix2::new(1.0 + a, 1.0 - a, 1.0 - a, 1.0 + a) * (long * long * bending / (12.0 * area));
            flexibility.fixed_view_mut::<2, 2>(first, first).add_assign(&own);
        }
        let Some(resisting) = flexibility.try_inverse() else { return Matrix24::zeros() };
        let g = GAUSS;
        let at_samples =
            Matrix4::new(1.0, -g, 0.0, 0.0, 1.0, g, 0.0, 0.0, 0.0, 0.0, 1.0, -g, 0.0, 0.0, 1.0, g);
        let shears = at_samples * inverse * side_shears::<4, 24>(self.corners);
        shears.transpose() * resisting * shears
    }

    /// The shears along the sides by c1 to c4.
    fn side_constants(&self, halving: &Matrix2<f64>) -> Matrix4<f64> {
        let mut constants = Matrix4::zeros();
        for (at, [xi, eta]) in MIDDLES.into_iter().enumerate() {
            let own = halving * along(self.corners, at);
            constants.set_row(at, &RowVector4::new(own.x, own.x * eta, own.y, own.y * xi));
        }
        constants
    }

    /// Distances of the middles of opposite sides along the two axes.
    fn between_sides(&self, halving: &Matrix2<f64>) -> [f64; 2] {
        let corner = |at: usize| halving * self.corners[at].coords.xy();
        let [a, b, c, d] = [0, 1, 2, 3].map(corner);
        [0.5 * (b + c - a - d).x, 0.5 * (c + d - a - b).y]
    }

    /// Mean of one over the stiffness of bending along a direction; nothing of a section that does not bend.
    fn bending_flexibility(&self, direction: &Vector2<f64>) -> Option<f64> {
        let [c, s] = [direction.x, direction.y];
        let curvature = Vector3::new(c * c, s * s, 2.0 * c * s);
        let of_point = |point: &Point<24>| {
            let bending = self.section.thickened(point.thickness).bending;
            let stiffness = curvature.dot(&(bending * curvature));
            (stiffness > 0.0).then(|| 1.0 / stiffness)
        };
        let all: Option<Vec<f64>> = self.points.iter().map(of_point).collect();
        all.map(|all| all.iter().sum::<f64>() / all.len() as f64)
    }

    /// Flexibility of the section's transverse shear over the four samples; nothing of a section that has no such stiffness. What couples the
    /// two directions stands in halves between each pair of samples.
    fn shear_flexibility(&self, halving: &Matrix2<f64>) -> Option<Matrix4<f64>> {
        let g = halving * self.section.shear * halving.transpose();
        let half = 0.5 * g[(0, 1)];
        let stiffness = Matrix4::from_fn(|i, j| match (i / 2 == j / 2, i == j) {
            (true, true) => g[(i / 2, i / 2)],
            (true, false) => 0.0,
            _ => half,
        });
        let samples = [[0.0, -GAUSS], [0.0, GAUSS], [-GAUSS, 0.0], [GAUSS, 0.0]];
        // Half of the element each.
        let shares = samples.map(|at| self.thickened(quad::point(self.corners, at, 2.0))).map(|point| {
            (point.area_m2 * self.section.thickened(point.thickness).shear.trace()
                / self.section.shear.trace())
            .sqrt()
        });
        let flexibility = stiffness.try_inverse()?;
        Some(Matrix4::from_fn(|i, j| flexibility[(i, j)] / (shares[i] * shares[j])))
    }
}

/// Rows: axes that halve the angle of the diagonals.
fn halving(corners: &[Point3<f64>]) -> Matrix2<f64> {
    let [one, other] =
        [corners[2] - corners[0], corners[3] - corners[1]].map(|diagonal| diagonal.xy().normalize());
    let x = (one - other).normalize();
    Matrix2::new(x.x, x.y, -x.y, x.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A warped tapered quadrilateral of growing thickness: what is condensed apart and what is condensed together are the same.
    #[test]
    fn membrane_and_bending_that_are_not_coupled_are_so_together_and_apart() {
        let corners =
            [[0.1, 0.2, 0.1], [1.3, 0.1, -0.1], [1.1, 0.9, 0.1], [0.0, 0.7, -0.1]].map(Point3::from);
        let section = ShellSection {
            membrane: Matrix3::new(3.0, 1.0, 0.2, 1.0, 4.0, -0.3, 0.2, -0.3, 1.5),
            coupling: Matrix3::zeros(),
            bending: Matrix3::new(0.5, 0.1, 0.0, 0.1, 0.3, 0.05, 0.0, 0.05, 0.2),
            shear: Matrix2::identity(),
            mass_kg_m2: 0.0,
            nsm_kg_m2: 0.0,
            mass_moment_kg_m: 0.0,
            mass_inertia_kg: 0.0,
        };
        let mut points = quad::points(&corners);
        for (point, thickness) in points.iter_mut().zip([1.0, 1.2, 1.4, 1.1]) {
            point.thickness = thickness;
        }
        for section in [
            section,
            ShellSection { membrane: Matrix3::zeros(), ..section },
            ShellSection { bending: Matrix3::zeros(), ..section },
        ] {
            let quad = NastranQuad { corners: &corners, section: &section, points: &points, thickness: &[] };
            let own = quad.in_plane();
            assert!(own.amax() > 0.0, "a stiffness");
            let is_whole = section.membrane.amax() > 0.0 && section.bending.amax() > 0.0;
            assert!(!is_whole || (own - quad.coupled()).amax() < 1e-14 * own.amax(), "{own}");
            assert!((own - own.transpose()).amax() < 1e-15 * own.amax());
        }
    }
}
