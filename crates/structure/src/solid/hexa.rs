//! CHEXA with eight corners: trilinear shape functions and 21 strain modes.
//!
//! ```text
//!      8 ------- 7
//!     /|        /|      local axes: x from face 1-4-8-5 to 2-3-7-6, y from 1-2-6-5 to 4-3-7-8,
//!    5 ------- 6 |      z from 1-2-3-4 to 5-6-7-8, each from -1 to 1
//!    | 4 ------| 3
//!    |/        |/
//!    1 ------- 2
//! ```
//!
//! The trilinear element bends with parasitic strains that lock it when it is slender. 21 strain modes take them away:
//!
//! - nine of Wilson's incompatible displacements 1 - x^2, 1 - y^2, 1 - z^2 along three directions: strain
//!   a x (gradient along x) and so on (Wilson, Taylor, Doherty, Ghaboussi, *Incompatible displacement models*, 1973).
//!   Constant bending of a box is exact with them;
//! - twelve bilinear ones, xx: x y, x z; xy: x z, y z; and so on in turn, for bending that changes across the element,
//!   without which thin plates lock (Andelfinger and Ramm, *EAS-elements for two- and three-dimensional plate and
//!   shell structures*, Int. J. Num. Meth. Eng. 36, 1993).

use super::shape::{Gradients, ModeStrains, QuadraturePoint, Shape, Values, gauss_2, gauss_3};

/// The family of the hexahedron.
#[derive(Debug)]
pub(crate) struct Hexa;

/// Local coordinates of the corners.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

impl Shape for Hexa {
    fn card(&self) -> &'static str {
        "CHEXA"
    }

    fn middle(&self) -> [f64; 3] {
        [0.0; 3]
    }

    fn values(&self, at: [f64; 3]) -> Values {
        Values::from_fn(|i, _| (0..3).map(|axis| 0.5 * (1.0 + CORNERS[i][axis] * at[axis])).product())
    }

    fn gradients(&self, at: [f64; 3]) -> Gradients {
        Gradients::from_fn(|row, i| {
            let factor = |axis: usize| {
                let side = CORNERS[i][axis];
                if axis == row { 0.5 * side } else { 0.5 * (1.0 + side * at[axis]) }
            };
            factor(0) * factor(1) * factor(2)
        })
    }

    fn mode_count(&self) -> usize {
        21
    }

    fn mode_strains(&self, at: [f64; 3]) -> ModeStrains {
        let mut modes = ModeStrains::zeros();
        for axis in 0..3 {
            // Rows 3, 4, 5 are the shears of an axis with the next.
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let own = [
                (axis, at[axis]),
                (3 + axis, at[axis]),
                (3 + axis, at[next]),
                (axis, at[axis] * at[next]),
                (axis, at[axis] * at[last]),
                (3 + axis, at[axis] * at[last]),
                (3 + axis, at[next] * at[last]),
            ];
            for (mode, (row, strain)) in own.into_iter().enumerate() {
                modes[(row, 7 * axis + mode)] = strain;
            }
        }
        modes
    }

    fn stiffness_points(&self) -> Vec<QuadraturePoint> {
        cube(&gauss_2())
    }

    /// The integrand of mass, N N^T det J, is of degree 4 in each coordinate.
    fn mass_points(&self) -> Vec<QuadraturePoint> {
        cube(&gauss_3())
    }

    fn quadratic_points(&self) -> Vec<QuadraturePoint> {
        cube(&gauss_3())
    }

    fn quadratic_mass_points(&self) -> Vec<QuadraturePoint> {
        cube(&gauss_3())
    }
}

fn cube(line: &[(f64, f64)]) -> Vec<QuadraturePoint> {
    let mut points = Vec::with_capacity(line.len().pow(3));
    for (x, wx) in line {
        for (y, wy) in line {
            points.extend(
                line.iter().map(|(z, wz)| QuadraturePoint { at: [*x, *y, *z], weight: wx * wy * wz }),
            );
        }
    }
    points
}
