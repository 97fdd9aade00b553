//! The elastic axis, and the stiffness along it.

use crate::wing::{Planform, Stations};

/// A straight axis that begins at `root_x_m`, y = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Its beginning, m.
    pub root_x_m: f64,
    /// Sine of its sweep.
    pub sin: f64,
    /// Cosine of its sweep.
    pub cos: f64,
}

impl Axis {
    /// The axis of a wing: through the table's points at root and tip.
    pub fn of(planform: &Planform, stations: &Stations) -> Self {
        let at = |y_m: f64| planform.x_m(y_m, stations.at(&stations.axis_x_over_c, y_m));
        let (root_x_m, tip_x_m) = (at(0.0), at(planform.semispan_m));
        let along = planform.semispan_m.hypot(tip_x_m - root_x_m);
        Self { root_x_m, sin: (tip_x_m - root_x_m) / along, cos: planform.semispan_m / along }
    }

    /// An axis along y.
    pub const STRAIGHT: Self = Self { root_x_m: 0.0, sin: 0.0, cos: 1.0 };

    /// Its point at a place of the span, m.
    pub fn x_m(&self, y_m: f64) -> f64 {
        self.root_x_m + y_m * self.sin / self.cos
    }

    /// Height of a point by `(w, f, t)` of the axis beside it.
    pub(crate) fn height(&self, dx_m: f64, dy_m: f64) -> [f64; 3] {
        [1.0, dx_m * self.sin + dy_m * self.cos, dy_m * self.sin - dx_m * self.cos]
    }

    /// Nose-up rotation of a section along x.
    pub(crate) fn pitch(&self) -> [f64; 3] {
        [0.0, -self.sin, self.cos]
    }

    /// Rotation of a section along y: its slope outward.
    pub(crate) fn roll(&self) -> [f64; 3] {
        [0.0, self.cos, self.sin]
    }
}

/// Stiffness over the span.
pub trait Stiffness {
    /// Bending and torsional stiffness at a place of the span, N m².
    fn at(&self, y_m: f64) -> [f64; 2];
}

impl<F: Fn(f64) -> [f64; 2]> Stiffness for F {
    fn at(&self, y_m: f64) -> [f64; 2] {
        self(y_m)
    }
}
