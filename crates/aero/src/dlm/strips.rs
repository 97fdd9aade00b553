//! Boxes gathered to strips: boxes behind each other, whose doublet lines differ in x only.
//!
//! Everything across the stream is then the same for all pairs of boxes of two strips. Boxes whose sides do not
//! lie along x share nothing and are strips of their own; that is slower, not wrong.

use crate::AeroBox;
use crate::error::AeroError;
use crate::horseshoe::CORE;
use nalgebra::{Point2, Vector2};
use std::ops::Range;

/// Boxes with the same y and z.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strip {
    /// Their indices.
    pub(super) boxes: Range<usize>,
    /// Middle of the doublet lines in (y, z), m.
    pub(super) middle: Point2<f64>,
    /// Unit vector in (y, z) from side 1 to side 2.
    pub(super) along: Vector2<f64>,
    /// Half the lines' length in (y, z), m.
    pub(super) half_width_m: f64,
    /// Where incidences are taken, in (y, z), m.
    pub(super) receiver: Point2<f64>,
    /// One for each box.
    pub(super) lines: Vec<Line>,
}

/// What differs between the boxes of a strip, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    /// x of the doublet line's middle.
    pub(super) x: f64,
    /// What x gains from the middle to side 2.
    pub(super) sweep: f64,
    /// x where the incidence is taken.
    pub(super) receiver_x: f64,
    pub(super) chord: f64,
    /// Radius of the core of the lines' ends.
    pub(super) core: f64,
}

impl Strip {
    /// The strips of boxes in their order.
    ///
    /// # Errors
    /// If a box has no width across the stream.
    pub(super) fn all(boxes: &[AeroBox]) -> Result<Vec<Self>, AeroError> {
        let mut strips: Vec<Self> = Vec::new();
        for (index, panel) in boxes.iter().enumerate() {
            let (strip, line) = Self::of_box(index, panel)?;
            match strips.last_mut() {
                Some(last) if last.same_across(&strip) => {
                    last.boxes.end = index + 1;
                    last.lines.push(line);
                }
                _ => strips.push(Self { lines: vec![line], ..strip }),
            }
        }
        Ok(strips)
    }

    fn of_box(index: usize, panel: &AeroBox) -> Result<(Self, Line), AeroError> {
        let [from, to] = panel.bound_vortex();
        let receiver = panel.three_quarter_point();
        let width = (to - from).yz().norm();
        if !(width > 0.0 && width.is_finite()) {
            return Err(AeroError::NoWidth { id: panel.id });
        }
        let strip = Self {
            boxes: index..index + 1,
            middle: Point2::new(f64::midpoint(from.y, to.y), f64::midpoint(from.z, to.z)),
            along: (to - from).yz() / width,
            half_width_m: width / 2.0,
            receiver: Point2::new(receiver.y, receiver.z),
            lines: Vec::new(),
        };
        let line = Line {
            x: f64::midpoint(from.x, to.x),
            sweep: (to.x - from.x) / 2.0,
            receiver_x: receiver.x,
            chord: panel.chord_m(),
            core: CORE * panel.chord_m().min(panel.width_m()),
        };
        Ok((strip, line))
    }

    fn same_across(&self, other: &Self) -> bool {
        self.middle == other.middle
            && self.along == other.along
            && self.half_width_m == other.half_width_m
            && self.receiver == other.receiver
    }

    /// Unit normal in (y, z): pressures are positive along it.
    pub(super) fn normal(&self) -> Vector2<f64> {
        Vector2::new(-self.along.y, self.along.x)
    }

    /// Smallest core of its boxes, m.
    pub(super) fn core_m(&self) -> f64 {
        self.lines.iter().fold(f64::INFINITY, |core, line| core.min(line.core))
    }
}
