//! CHEXA with eight corners: trilinear shape functions and the quadratic modes 1 - x^2, 1 - y^2, 1 - z^2 of Wilson.
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
//! The trilinear element bends with a parasitic shear that locks it when it is slender; the modes take that shear
//! away (Wilson, Taylor, Doherty, Ghaboussi, *Incompatible displacement models*, 1973).

use super::shape::{Gradients, ModeGradients, QuadraturePoint, Shape, Values, gauss_2, gauss_3};

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
        3
    }

    fn mode_gradients(&self, at: [f64; 3]) -> ModeGradients {
        ModeGradients::from_fn(|row, mode| if row == mode { -2.0 * at[row] } else { 0.0 })
    }

    fn stiffness_points(&self) -> Vec<QuadraturePoint> {
        cube(&gauss_2())
    }

    /// The integrand of mass, N N^T det J, is of degree 4 in each coordinate.
    fn mass_points(&self) -> Vec<QuadraturePoint> {
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
