//! The axes in which the air is computed: x along the stream, y to the right, z up (ACSID of AERO and AEROS).

use nalgebra::{Matrix3, Point3};
use nastran::{Frames, InputError, Span};

/// Axes of the stream.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamAxes {
    /// Their origin, m, basic axes.
    pub origin: Point3<f64>,
    /// x, y and z as columns, basic axes.
    pub axes: Matrix3<f64>,
}

impl StreamAxes {
    /// The basic system: what a deck means that names none.
    pub fn basic() -> Self {
        Self { origin: Point3::origin(), axes: Matrix3::identity() }
    }

    /// A deck's system `acsid`, which the card at `span` names.
    ///
    /// # Errors
    /// If it is not there or not rectangular.
    pub fn of_deck(frames: &Frames, acsid: u32, span: &Span) -> Result<Self, InputError> {
        Ok(Self { origin: frames.origin(acsid, span)?, axes: frames.axes_at(acsid, span)? })
    }

    /// Whether they are the basic system to the last digit.
    pub fn is_basic(&self) -> bool {
        *self == Self::basic()
    }

    /// A point of the basic system, m, in these axes.
    pub fn seen(&self, point: &Point3<f64>) -> Point3<f64> {
        if self.is_basic() { *point } else { (self.axes.transpose() * (point - self.origin)).into() }
    }
}
