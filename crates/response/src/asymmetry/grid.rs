//! The rectangular grid that the points of a displacement field stand on: lines of equal x and of equal y, the area that
//! belongs to each point, and which line is the mirror image of which.

use std::collections::BTreeMap;

use nastran::InputError;

/// Coordinates nearer than this share of the extent are the same grid line.
const SAME: f64 = 1e-6;

/// Out-of-plane displacement at a point of the wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Aft, mm.
    pub x_mm: f64,
    /// To the right, mm.
    pub y_mm: f64,
    /// Out of plane, mm.
    pub w_mm: f64,
}

/// Points by their lines (chordwise, spanwise).
pub(super) struct Grid {
    /// The points, by numbers of their lines.
    pub(super) points: BTreeMap<(usize, usize), Displacement>,
    /// To each spanwise line its mirror image, if there is one.
    pub(super) mirror: Vec<Option<usize>>,
    widths: [Vec<f64>; 2],
}

impl Grid {
    pub(super) fn new(field: &[Displacement], centre_y_mm: f64) -> Result<Self, InputError> {
        if let Some(index) =
            field.iter().position(|p| ![p.x_mm, p.y_mm, p.w_mm].iter().all(|v| v.is_finite()))
        {
            let message =
                format!("point {} of the displacement field has a number that is not finite", index + 1);
            return Err(InputError::general(message));
        }
        let xs = lines(field.iter().map(|point| point.x_mm));
        let ys = lines(field.iter().map(|point| point.y_mm - centre_y_mm));
        if xs.len() < 2 || ys.len() < 2 || 4 * field.len() < xs.len() * ys.len() {
            let message = format!(
                "{} points stand on {} lines of equal x and {} of equal y; expected a grid",
                field.len(),
                xs.len(),
                ys.len()
            );
            return Err(InputError::general(message)
                .with_help("interpolate the measured field to a rectangular grid first"));
        }
        let mut points = BTreeMap::new();
        for point in field {
            let place = (nearest(&xs, point.x_mm), nearest(&ys, point.y_mm - centre_y_mm));
            if points.insert(place, *point).is_some() {
                let message = format!("the point x = {} mm, y = {} mm occurs twice", point.x_mm, point.y_mm);
                return Err(InputError::general(message));
            }
        }
        let widths = [widths(&xs), widths(&ys)];
        let mirror = ys
            .iter()
            .map(|y| {
                let image = nearest(&ys, -y);
                ((ys[image] + y).abs() <= 2.0 * SAME * extent(&ys)).then_some(image)
            })
            .collect();
        Ok(Self { points, mirror, widths })
    }

    /// The area of a point, mm^2.
    pub(super) fn area(&self, x_line: usize, y_line: usize) -> f64 {
        self.widths[0][x_line] * self.widths[1][y_line]
    }

    /// True if both spacings are constant.
    pub(super) fn equally_spaced(&self) -> bool {
        self.widths.iter().all(|widths| {
            let first = widths[0];
            widths.iter().all(|width| (width - first).abs() <= 1e-3 * first)
        })
    }
}

fn extent(sorted: &[f64]) -> f64 {
    sorted.last().unwrap_or(&0.0) - sorted.first().unwrap_or(&0.0)
}

/// The distinct values, ascending.
fn lines(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    let tolerance = SAME * extent(&sorted);
    let mut distinct: Vec<f64> = Vec::new();
    for value in sorted {
        if distinct.last().is_none_or(|last| value - last > tolerance) {
            distinct.push(value);
        }
    }
    distinct
}

/// The number of the line nearest to a value.
fn nearest(lines: &[f64], value: f64) -> usize {
    let after = lines.partition_point(|line| *line < value).min(lines.len() - 1);
    let before = after.saturating_sub(1);
    if (value - lines[before]).abs() <= (lines[after] - value).abs() { before } else { after }
}

/// To each line the distance between the middles to its neighbours; an outer one is as wide as its inner gap.
fn widths(lines: &[f64]) -> Vec<f64> {
    let gap = |k: usize| lines[k + 1] - lines[k];
    let last = lines.len() - 1;
    (0..=last)
        .map(|k| match k {
            0 => gap(0),
            k if k == last => gap(last - 1),
            k => 0.5 * (gap(k - 1) + gap(k)),
        })
        .collect()
}
