//! What unit loads on the axis bend and twist: integrals of moments over stiffness.

use super::axis::{Axis, Stiffness};
use nalgebra::DMatrix;

/// Points of Gauss and their weights on (-1, 1).
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];
/// Pieces of the span over which is integrated.
const PIECES: u32 = 240;

/// One point of integration.
#[derive(Debug, Clone, Copy)]
struct Point {
    /// Along the axis, m.
    s_m: f64,
    /// Weight over bending stiffness, 1/(N m).
    bending: f64,
    /// Weight over torsional stiffness.
    torsion: f64,
}

/// See the module. It holds for places up to the end of the span.
#[derive(Debug, Clone)]
pub(crate) struct Flexibility {
    points: Vec<Point>,
    cos: f64,
}

impl Flexibility {
    pub(crate) fn new(axis: &Axis, end_y_m: f64, stiffness: &dyn Stiffness) -> Self {
        let half = 0.5 * end_y_m / f64::from(PIECES);
        let point = |piece: u32| {
            GAUSS.iter().map(move |(place, weight)| {
                let y_m = half * (f64::from(2 * piece + 1) + place);
                let [bending, torsion] = stiffness.at(y_m);
                let length = half * weight / axis.cos;
                Point { s_m: y_m / axis.cos, bending: length / bending, torsion: length / torsion }
            })
        };
        Self { points: (0..PIECES).flat_map(point).collect(), cos: axis.cos }
    }

    /// `(w, f, t)` at `to_y_m` by force, bending moment and torque at `from_y_m`; points between pieces count as they lie.
    pub(crate) fn between(&self, to_y_m: f64, from_y_m: f64) -> [[f64; 3]; 3] {
        let (to, from) = (to_y_m / self.cos, from_y_m / self.cos);
        let last = to.min(from);
        let mut c = [[0.0; 3]; 3];
        for point in self.points.iter().take_while(|point| point.s_m <= last) {
            let (arm_to, arm_from) = (to - point.s_m, from - point.s_m);
            c[0][0] += arm_to * arm_from * point.bending;
            c[0][1] += arm_to * point.bending;
            c[1][0] += arm_from * point.bending;
            c[1][1] += point.bending;
            c[2][2] += point.torsion;
        }
        c
    }

    /// Three rows a place of `to`, three columns a place of `from`.
    pub(crate) fn matrix(&self, to_y_m: &[f64], from_y_m: &[f64]) -> DMatrix<f64> {
        let mut c = DMatrix::zeros(3 * to_y_m.len(), 3 * from_y_m.len());
        for (i, to) in to_y_m.iter().enumerate() {
            for (j, from) in from_y_m.iter().enumerate() {
                let block = self.between(*to, *from);
                for (row, values) in block.iter().enumerate() {
                    for (column, value) in values.iter().enumerate() {
                        c[(3 * i + row, 3 * j + column)] = *value;
                    }
                }
            }
        }
        c
    }
}
