//! The linear bounds: chordwise neighbours differ by at most a setting, factors stay above a minimum.
//!
//! They hold at every box, which is some 5000 rows on the paper's wing, but along the span they bound a polynomial:
//! the cone programs start with the rows of a few well-placed strips, and rows that a step would break join them.

use crate::basis::Basis;
use coupling::CorrectableBoxes;

/// All bounds of a wing, and which of them a fit starts with.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// Every row, at every box.
    pub rows: Vec<BoundRow>,
    /// Rows at the strips nearest to Lobatto's points of the span, where a polynomial's bounds matter most.
    pub first: Vec<usize>,
}

/// A row `sum of coefficient * unknown <= limit`.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundRow {
    /// (unknown, coefficient).
    pub entries: Vec<(usize, f64)>,
    /// Right side.
    pub limit: f64,
}

/// Bounds are kept this share inside, so that neither the solver's tolerance nor rounding breaks them.
const INSIDE: f64 = 1e-6;

impl BoundRow {
    /// The limit that is aimed at, a little inside.
    pub fn inside(&self) -> f64 {
        self.limit - INSIDE * self.limit.abs()
    }

    /// Left side at x.
    pub fn value(&self, x: &[f64]) -> f64 {
        self.entries.iter().map(|&(unknown, coefficient)| coefficient * x[unknown]).sum()
    }
}

impl Bounds {
    /// How far from x towards a goal all bounds hold (1: all the way), and the rows that the goal breaks.
    pub fn share_within(&self, x: &[f64], goal: &[f64]) -> (f64, Vec<usize>) {
        let mut share = 1.0_f64;
        let mut broken = Vec::new();
        for (index, row) in self.rows.iter().enumerate() {
            let (here, there) = (row.value(x), row.value(goal));
            // a tenth of the margin is left to the solver
            if there > row.limit - 0.1 * INSIDE * row.limit.abs() && here < there {
                share = share.min(((row.inside() - here) / (there - here)).max(0.0));
                broken.push(index);
            }
        }
        (share, broken)
    }
}

/// The bounds of a wing.
pub fn bounds(basis: &Basis, boxes: &CorrectableBoxes, neighbour: f64, least_factor: f64) -> Bounds {
    let points = 5 * basis.terms;
    let lobatto = |k: usize| 0.5 * (1.0 - (std::f64::consts::PI * k as f64 / (points - 1) as f64).cos());
    let nearest = |y: f64| {
        let distance = |b: &usize| (boxes.y_norm[*b] - y).abs();
        (0..boxes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|b| boxes.strip[b])
    };
    let strips: Vec<usize> = (0..points).filter_map(|k| nearest(lobatto(k))).collect();
    let (rows, strip_of_row) = bound_rows(basis, boxes, neighbour, least_factor);
    let first = (0..rows.len()).filter(|&row| strips.contains(&strip_of_row[row])).collect();
    Bounds { rows, first }
}

/// All rows: for every family, strip and pair of chordwise neighbours `|difference| <= neighbour`,
/// and for every box `factor >= least_factor`; and the strip of each row.
fn bound_rows(
    basis: &Basis,
    boxes: &CorrectableBoxes,
    neighbour: f64,
    least_factor: f64,
) -> (Vec<BoundRow>, Vec<usize>) {
    let mut rows = Vec::new();
    let mut strips = Vec::new();
    for b in 0..boxes.len() {
        let strip = basis.strip_of[b];
        let first_of_strip = boxes.chord_row[b] == 0 || basis.strip_of[b - 1] != strip;
        if !first_of_strip {
            continue;
        }
        for family in 0..3 {
            let here = basis.column(family, strip);
            if boxes.chord_row[b] > 0 {
                let ahead = basis.column(family, basis.strip_of[b - 1]);
                for sign in [1.0, -1.0] {
                    let difference = (0..basis.terms).flat_map(|k| {
                        let p = sign * basis.polynomials[(b, k)];
                        [(here + k, p), (ahead + k, -p)]
                    });
                    rows.push(BoundRow { entries: difference.collect(), limit: neighbour });
                }
            }
            if family < 2 {
                let negative = (0..basis.terms).map(|k| (here + k, -basis.polynomials[(b, k)]));
                rows.push(BoundRow { entries: negative.collect(), limit: -least_factor });
            }
        }
        strips.resize(rows.len(), boxes.strip[b]);
    }
    (rows, strips)
}

/// Number of neighbour rows that are active (within 1 % of the bound).
pub fn active_neighbours(rows: &[BoundRow], x: &[f64]) -> usize {
    rows.iter().filter(|row| row.limit > 0.0 && row.value(x) > 0.99 * row.limit).count()
}
