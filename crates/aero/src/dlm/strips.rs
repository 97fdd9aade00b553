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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Lattice;
    use nalgebra::Point3;

    fn panel(id: u32, corners: [[f64; 3]; 4]) -> AeroBox {
        AeroBox { id, corners: corners.map(Point3::from) }
    }

    /// By hand: quarter points (0.25, 0, 0) and (1, 3, 4), three quarters of the mean chord of 1.5 m behind
    /// (0.25, 1.5, 2).
    #[test]
    fn a_box_has_the_line_that_its_corners_say() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.5, 3.0, 4.0], [0.5, 3.0, 4.0]];
        let strips = Strip::all(&[panel(1, corners)]).expect("a box");
        let [strip] = strips.as_slice() else { panic!("one strip") };
        assert_eq!((strip.boxes.clone(), strip.half_width_m), (0..1, 2.5));
        assert_eq!((strip.middle, strip.receiver), (Point2::new(1.5, 2.0), Point2::new(1.5, 2.0)));
        assert!((strip.along - Vector2::new(0.6, 0.8)).norm() < 1e-15);
        assert!((strip.normal() - Vector2::new(-0.8, 0.6)).norm() < 1e-15);
        let line = Line { x: 0.625, sweep: 0.375, receiver_x: 1.375, chord: 1.5, core: 0.015 };
        assert_eq!(strip.lines, [line]);
        // A narrow box has a core by its width; of several boxes the smallest counts.
        let narrow = Strip { lines: vec![Line { core: 0.004, ..line }, line], ..strip.clone() };
        assert_eq!((strip.core_m(), narrow.core_m()), (0.015, 0.004));
        let slim = panel(2, [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 0.3, 0.4], [0.0, 0.3, 0.4]]);
        let (_, slim) = Strip::of_box(0, &slim).expect("a box");
        assert!((slim.core - 0.005).abs() < 1e-17);
    }

    #[test]
    fn boxes_behind_each_other_are_one_strip_in_their_order() {
        let wing = Lattice::trapezoid(1, [0.0, 0.1, 0.0], 1.0, [0.5, 2.1, 0.3], 0.5, [3, 2]).expect("boxes");
        let tail = Lattice::trapezoid(11, [3.0, 0.1, 0.0], 1.0, [3.0, 1.1, 0.0], 1.0, [2, 1]).expect("boxes");
        let all = wing.joined(&tail).expect("one lattice");
        let strips = Strip::all(&all.boxes).expect("boxes");
        let ranges: Vec<_> = strips.iter().map(|strip| strip.boxes.clone()).collect();
        assert_eq!(ranges, [0..3, 3..6, 6..8]);
        for strip in &strips {
            assert_eq!(strip.lines.len(), strip.boxes.len());
            for (line, panel) in strip.lines.iter().zip(&all.boxes[strip.boxes.clone()]) {
                assert_eq!((line.receiver_x, line.chord), (panel.three_quarter_point().x, panel.chord_m()));
            }
        }
    }

    /// Each differs from the first box in one thing across the stream: place, width, roll, where the
    /// incidence is taken.
    #[test]
    fn boxes_that_differ_across_the_stream_are_strips_of_their_own() {
        let box_of = |from: [f64; 2], to: [f64; 2], skew: f64| {
            // Ends of the bound line stay, a quarter of the way from leading to trailing edge.
            let at = |x: f64, [y, z]: [f64; 2], by: f64| [x, y + by, z];
            panel(
                1,
                [
                    at(0.0, from, -skew),
                    at(1.0, from, 3.0 * skew),
                    at(1.0, to, 3.0 * skew),
                    at(0.0, to, -skew),
                ],
            )
        };
        let first = box_of([0.0, 0.0], [2.0, 0.0], 0.0);
        for (other, together) in [
            (box_of([0.0, 0.0], [2.0, 0.0], 0.0), true),
            (box_of([1.0, 0.0], [3.0, 0.0], 0.0), false),
            (box_of([0.0, 0.5], [2.0, 0.5], 0.0), false),
            (box_of([0.5, 0.0], [1.5, 0.0], 0.0), false),
            (box_of([1.0, -1.0], [1.0, 1.0], 0.0), false),
            (box_of([0.0, 0.0], [2.0, 0.0], 0.25), false),
        ] {
            let strips = Strip::all(&[first.clone(), other]).expect("boxes");
            assert_eq!(strips.len(), if together { 1 } else { 2 });
        }
    }

    #[test]
    fn boxes_without_a_width_that_is_a_number_are_refused() {
        for y in [0.0, f64::NAN, f64::INFINITY] {
            let flat = panel(7, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, y, 0.0], [0.0, y, 0.0]]);
            assert_eq!(Strip::all(&[flat]), Err(AeroError::NoWidth { id: 7 }));
        }
    }
}
