//! What unit loads on the axis bend and twist: integrals of moments over stiffness.

use super::axis::{Axis, Stiffness};
use nalgebra::DMatrix;

/// Pieces of the span, each of one stiffness, over which moments are integrated exactly.
const PIECES: u32 = 360;

/// A piece of the axis.
#[derive(Debug, Clone, Copy)]
struct Piece {
    /// Its beginning along the axis, m.
    from_m: f64,
    /// One over the bending stiffness, 1/(N m²).
    bending: f64,
    /// One over the torsional stiffness.
    torsion: f64,
}

/// See the module. It holds for places up to the end of the span.
#[derive(Debug, Clone)]
pub(crate) struct Flexibility {
    pieces: Vec<Piece>,
    length_m: f64,
    cos: f64,
}

impl Flexibility {
    pub(crate) fn new(axis: &Axis, end_y_m: f64, stiffness: &dyn Stiffness) -> Self {
        let width_m = end_y_m / f64::from(PIECES);
        let piece = |number: u32| {
            let [bending, torsion] = stiffness.at(width_m * (f64::from(number) + 0.5));
            Piece {
                from_m: width_m * f64::from(number) / axis.cos,
                bending: 1.0 / bending,
                torsion: 1.0 / torsion,
            }
        };
        Self { pieces: (0..PIECES).map(piece).collect(), length_m: width_m / axis.cos, cos: axis.cos }
    }

    /// `(w, f, t)` at `to_y_m` by force, bending moment and torque at `from_y_m`.
    pub(crate) fn between(&self, to_y_m: f64, from_y_m: f64) -> [[f64; 3]; 3] {
        let (to, from) = (to_y_m / self.cos, from_y_m / self.cos);
        let last = to.min(from);
        let mut c = [[0.0; 3]; 3];
        for piece in self.pieces.iter().take_while(|piece| piece.from_m < last) {
            let length = self.length_m.min(last - piece.from_m);
            let middle = piece.from_m + 0.5 * length;
            let (arm_to, arm_from) = (to - middle, from - middle);
            let bent = length * piece.bending;
            c[0][0] += bent * (arm_to * arm_from + length * length / 12.0);
            c[0][1] += bent * arm_to;
            c[1][0] += bent * arm_from;
            c[1][1] += bent;
            c[2][2] += length * piece.torsion;
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
