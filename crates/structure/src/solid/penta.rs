//! CPENTA with six corners: linear over the triangle 1-2-3, linear from it to 4-5-6, and twelve strain modes.
//!
//! Local coordinates: r from corner 1 to 2, s from 1 to 3, z from -1 (triangle 1-2-3) to 1 (triangle 4-5-6). The
//! strain modes are those of the incompatible displacements 1 - z^2, p^2, p q, q^2 with p = r - 1/3, q = s - 1/3, each
//! along three directions; they span the same space whichever corner comes first. A long prism bends exactly.
//!
//! A flat prism bent like a plate keeps the mean of its parasitic shear: displacements linear over a triangle cannot
//! make it vanish, and an element that took it away by itself would fail the patch test beside others. Within its
//! plane the triangle is one of constant strain. So wedges are for corners of meshes and for transitions, not for
//! thin plates.

use super::shape::{Gradients, ModeStrains, QuadraturePoint, Shape, Values, gauss_2, gauss_3};

/// The family of the wedge.
#[derive(Debug)]
pub(crate) struct Penta;

/// Local coordinates of the corners.
const CORNERS: [[f64; 3]; 6] =
    [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [0.0, 1.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];

/// Derivatives of the triangle's shape functions by r and s.
const TRIANGLE_GRADIENTS: [[f64; 3]; 2] = [[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0]];

impl Shape for Penta {
    fn card(&self) -> &'static str {
        "CPENTA"
    }

    fn middle(&self) -> [f64; 3] {
        [1.0 / 3.0, 1.0 / 3.0, 0.0]
    }

    fn values(&self, [r, s, z]: [f64; 3]) -> Values {
        let triangle = [1.0 - r - s, r, s];
        Values::from_fn(|i, _| if i < 6 { triangle[i % 3] * 0.5 * (1.0 + CORNERS[i][2] * z) } else { 0.0 })
    }

    fn gradients(&self, [r, s, z]: [f64; 3]) -> Gradients {
        let triangle = [1.0 - r - s, r, s];
        Gradients::from_fn(|row, i| match (row, i) {
            (_, 6..) => 0.0,
            (2, i) => triangle[i % 3] * 0.5 * CORNERS[i][2],
            (row, i) => TRIANGLE_GRADIENTS[row][i % 3] * 0.5 * (1.0 + CORNERS[i][2] * z),
        })
    }

    fn mode_count(&self) -> usize {
        12
    }

    fn mode_strains(&self, [r, s, z]: [f64; 3]) -> ModeStrains {
        let (p, q) = (r - 1.0 / 3.0, s - 1.0 / 3.0);
        let [rr, ss, zz, rs, sz, zr] = [0, 1, 2, 3, 4, 5];
        let mut modes = ModeStrains::zeros();
        let single = [
            (zz, z),
            (sz, z),
            (zr, z),
            (rr, p),
            (rr, q),
            (ss, p),
            (ss, q),
            (rs, p),
            (rs, q),
            (zr, p),
            (sz, q),
            (zr, q),
        ];
        for (mode, (row, strain)) in single.into_iter().enumerate() {
            modes[(row, mode)] = strain;
        }
        // The deflection p q has both shears.
        modes[(sz, 11)] = p;
        modes
    }

    fn stiffness_points(&self) -> Vec<QuadraturePoint> {
        prism(&TRIANGLE_2.map(|(r, s)| (r, s, 1.0 / 6.0)), &gauss_2())
    }

    /// The integrand of mass is of degree 3 over the triangle and 4 along the prism.
    fn mass_points(&self) -> Vec<QuadraturePoint> {
        prism(&radon(), &gauss_3())
    }

    /// Seven by three points, with which MSC Nastran 2024 prints displacements (IN = 3, ISOP = FULL); three by three make it 8 % softer.
    fn quadratic_points(&self) -> Vec<QuadraturePoint> {
        prism(&radon(), &gauss_3())
    }

    fn quadratic_mass_points(&self) -> Vec<QuadraturePoint> {
        prism(&radon(), &gauss_3())
    }
}

/// Three points of equal weight, exact to degree 2 over the triangle.
pub(super) const TRIANGLE_2: [(f64, f64); 3] =
    [(1.0 / 6.0, 1.0 / 6.0), (2.0 / 3.0, 1.0 / 6.0), (1.0 / 6.0, 2.0 / 3.0)];

/// Radon's seven points, exact to degree 5 over the triangle (Stroud, *Approximate Calculation of Multiple
/// Integrals*, T2: 5-1).
pub(crate) fn radon() -> [(f64, f64, f64); 7] {
    let root = 15.0_f64.sqrt();
    let (a, b) = ((6.0 - root) / 21.0, (6.0 + root) / 21.0);
    let (wa, wb) = ((155.0 - root) / 2400.0, (155.0 + root) / 2400.0);
    [
        (1.0 / 3.0, 1.0 / 3.0, 9.0 / 80.0),
        (a, a, wa),
        (1.0 - 2.0 * a, a, wa),
        (a, 1.0 - 2.0 * a, wa),
        (b, b, wb),
        (1.0 - 2.0 * b, b, wb),
        (b, 1.0 - 2.0 * b, wb),
    ]
}

pub(super) fn prism(triangle: &[(f64, f64, f64)], line: &[(f64, f64)]) -> Vec<QuadraturePoint> {
    let mut points = Vec::with_capacity(triangle.len() * line.len());
    for (r, s, over_triangle) in triangle {
        let along = line.iter().map(|(z, w)| QuadraturePoint { at: [*r, *s, *z], weight: over_triangle * w });
        points.extend(along);
    }
    points
}
