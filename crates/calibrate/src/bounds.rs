//! The linear bounds: chordwise neighbours differ by at most a setting, factors stay above a minimum.

use crate::basis::Basis;
use coupling::CorrectableBoxes;

/// A row `sum of coefficient * unknown <= limit`.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundRow {
    /// (unknown, coefficient).
    pub entries: Vec<(usize, f64)>,
    /// Right side.
    pub limit: f64,
}

impl BoundRow {
    /// Left side at x.
    pub fn value(&self, x: &[f64]) -> f64 {
        self.entries.iter().map(|&(unknown, coefficient)| coefficient * x[unknown]).sum()
    }
}

/// All bounds of a wing: for every family, strip and pair of chordwise neighbours `|difference| <= neighbour`,
/// and for every box `factor >= least_factor`.
pub fn bound_rows(
    basis: &Basis,
    boxes: &CorrectableBoxes,
    neighbour: f64,
    least_factor: f64,
) -> Vec<BoundRow> {
    let mut rows = Vec::new();
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
    }
    rows
}

/// Largest violation of any bound at x; zero or negative if all hold.
pub fn violation(rows: &[BoundRow], x: &[f64]) -> f64 {
    rows.iter().map(|row| row.value(x) - row.limit).fold(f64::NEG_INFINITY, f64::max)
}

/// Number of neighbour rows that are active (within 1 % of the bound).
pub fn active_neighbours(rows: &[BoundRow], x: &[f64]) -> usize {
    rows.iter().filter(|row| row.limit > 0.0 && row.value(x) > 0.99 * row.limit).count()
}
