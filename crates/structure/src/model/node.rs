//! Grid points in basic axes, and which of their motions are clamped.

use nalgebra::{Matrix3, Point3};
use nastran::Span;

/// A grid point.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// The grid's identification number.
    pub id: u32,
    /// Its place in the basic system, m.
    pub point: Point3<f64>,
    /// Axes of its displacement system, as columns in the basic system.
    pub axes: Matrix3<f64>,
    /// Whether it is a scalar point: component 1 is its only motion, and it has no place (`point` is the origin).
    pub is_scalar: bool,
}

/// Components of one node that are held fixed.
#[derive(Debug, Clone, PartialEq)]
pub struct Clamp {
    /// Position of the node in [`crate::Model::nodes`].
    pub node: usize,
    /// Components, digits 1 to 6, in the axes of the grid's displacement system.
    pub components: Vec<u8>,
    /// The card that says so.
    pub span: Span,
}
