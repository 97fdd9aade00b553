//! The true wing strip by strip: where each is, how the modes move it, and how the boxes' pressures load it.
//!
//! A strip carries a lift L at its quarter point and a nose-up moment M about it. Chords are rigid, so
//! these two do all the work there is, and every effect on the air can be said by strip.

use crate::modal::ModalStructure;
use coupling::planform::Planform;
use coupling::{CouplingError, ElasticWing};
use faer::Mat;
use tunnel::TunnelError;

/// Stretches of the span in which the flow may separate.
pub const ZONES: usize = 8;

/// See the module.
#[derive(Debug, Clone)]
pub struct Strips {
    /// Boxes of each strip (indices into the lattice), leading edge first.
    pub(crate) boxes: Vec<Vec<usize>>,
    /// Middle of each, m.
    pub y_m: Vec<f64>,
    /// Share of the half span: 0 root, 1 tip.
    pub eta: Vec<f64>,
    /// Quarter point, m.
    pub x_quarter_m: Vec<f64>,
    /// Chord, m.
    pub chord_m: Vec<f64>,
    /// Width, m.
    pub width_m: Vec<f64>,
    /// Which stretch of the span a strip belongs to.
    pub zone: Vec<usize>,
    /// Height of the quarter point by mode, strips by modes.
    pub(crate) height: Mat<f64>,
    /// Nose-up rotation by mode, strips by modes.
    pub(crate) twist: Mat<f64>,
}

impl Strips {
    pub(crate) fn new(
        wing: &ElasticWing,
        planform: &Planform,
        structure: &ModalStructure,
    ) -> Result<Self, TunnelError> {
        let correctable = &wing.correctable;
        let count = correctable.strip.iter().max().map_or(0, |last| last + 1);
        let mut boxes = vec![Vec::new(); count];
        for (&place, &strip) in correctable.places.iter().zip(&correctable.strip) {
            boxes[strip].push(place);
        }
        let none = CouplingError::Size { what: "structures of the true wing", got: 0, expected: 1 };
        let supported = wing.supported.as_ref().ok_or(TunnelError::Wing(none))?;
        let motion = &supported.k_displacements() * &structure.shapes;
        let first = |strip: usize| &wing.lattice.boxes[boxes[strip][0]];
        let y_m: Vec<f64> = (0..count).map(|strip| first(strip).mid_point().y).collect();
        let chord_m: Vec<f64> = (0..count).map(|strip| planform.chord_m(y_m[strip])).collect();
        let x_quarter_m: Vec<f64> = y_m.iter().map(|&y| planform.point(y, 0.25).x).collect();
        let modes = structure.shapes.ncols();
        let twist = Mat::from_fn(count, modes, |strip, mode| motion[(2 * boxes[strip][0] + 1, mode)]);
        let height = Mat::from_fn(count, modes, |strip, mode| {
            let aft_m = first(strip).mid_point().x - x_quarter_m[strip];
            motion[(2 * boxes[strip][0], mode)] + twist[(strip, mode)] * aft_m
        });
        let eta: Vec<f64> = y_m.iter().map(|y| y / planform.semispan_m).collect();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "eta is between 0 and 1")]
        let zone = eta.iter().map(|eta| ((eta * ZONES as f64) as usize).min(ZONES - 1)).collect();
        let width_m = (0..count).map(|strip| first(strip).width_m()).collect();
        Ok(Self { boxes, y_m, eta, x_quarter_m, chord_m, width_m, zone, height, twist })
    }

    /// Number of strips.
    pub fn len(&self) -> usize {
        self.y_m.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.y_m.is_empty()
    }

    /// Area of a strip, m².
    pub fn area_m2(&self, strip: usize) -> f64 {
        self.chord_m[strip] * self.width_m[strip]
    }

    /// Middle of a zone along the span, m.
    pub fn middle_of_zone_m(&self, zone: usize) -> f64 {
        let members = || (0..self.len()).filter(|strip| self.zone[*strip] == zone);
        members().map(|strip| self.y_m[strip]).sum::<f64>() / members().count().max(1) as f64
    }

    /// Area of a zone, m².
    pub fn area_of_zone_m2(&self, zone: usize) -> f64 {
        (0..self.len()).filter(|strip| self.zone[*strip] == zone).map(|strip| self.area_m2(strip)).sum()
    }

    /// Rows by boxes: lifts of all strips, then moments, per unit pressure coefficient and dynamic pressure.
    pub(crate) fn rows(&self, wing: &ElasticWing) -> Mat<f64> {
        let count = self.len();
        let mut rows = Mat::zeros(2 * count, wing.lattice.len());
        for (strip, boxes) in self.boxes.iter().enumerate() {
            for &j in boxes {
                let lift = wing.integration.area(j) * wing.lattice.boxes[j].normal().z;
                let aft_m = wing.lattice.boxes[j].quarter_point().x - self.x_quarter_m[strip];
                rows[(strip, j)] = lift;
                rows[(count + strip, j)] = -aft_m * lift;
            }
        }
        rows
    }

    /// Modes, then Fz, Mx, My, by strip loads (lifts, then moments): generalised forces and balance loads.
    pub(crate) fn gather(&self, structure: &ModalStructure) -> (Mat<f64>, Mat<f64>) {
        let count = self.len();
        let modes = self.height.ncols();
        let modal = Mat::from_fn(modes, 2 * count, |mode, column| {
            if column < count { self.height[(column, mode)] } else { self.twist[(column - count, mode)] }
        });
        let (x_m, y_m) = (structure.balance.x, structure.balance.y);
        let balance = Mat::from_fn(3, 2 * count, |row, column| match (row, column < count) {
            (0, true) | (2, false) => 1.0,
            (1, true) => self.y_m[column] - y_m,
            (2, true) => -(self.x_quarter_m[column] - x_m),
            _ => 0.0,
        });
        (modal, balance)
    }
}
