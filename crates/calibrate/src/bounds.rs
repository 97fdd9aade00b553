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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::{Toy, near};

    fn row(unknown: usize, coefficient: f64, limit: f64) -> BoundRow {
        BoundRow { entries: vec![(unknown, coefficient)], limit }
    }

    #[test]
    fn a_bound_is_kept_a_millionth_inside() {
        near(row(0, 1.0, 2.0).inside(), 2.0 - 2e-6, 1e-15);
        near(row(0, 1.0, -0.5).inside(), -0.5 - 5e-7, 1e-15);
        let both = BoundRow { entries: vec![(1, 2.0), (2, -3.0)], limit: 0.0 };
        near(both.value(&[9.0, 5.0, 2.0]), 4.0, 1e-15);
    }

    #[test]
    fn the_way_to_a_goal_ends_at_the_first_bound_that_it_meets() {
        let all =
            Bounds { rows: vec![row(0, 1.0, 2.0), row(1, 1.0, 2.0), row(0, -1.0, 9.0)], first: Vec::new() };
        let within = |x: [f64; 2], goal: [f64; 2]| all.share_within(&x, &goal);
        assert_eq!(within([0.0, 0.0], [1.9, 1.9]), (1.0, vec![]));
        let (share, broken) = within([1.0, 0.0], [5.0, 3.0]);
        near(share, (1.0 - 2e-6) / 4.0, 1e-12);
        assert_eq!(broken, [0, 1]);
        let (share, broken) = within([1.0, 0.5], [1.0, 3.5]);
        near(share, (1.5 - 2e-6) / 3.0, 1e-12);
        assert_eq!(broken, [1]);
        // beyond a bound: back is free, on or along it is not or does nothing
        assert_eq!(within([4.0, 0.0], [3.0, 0.0]), (1.0, vec![]));
        assert_eq!(within([3.0, 0.0], [3.0, 0.0]), (1.0, vec![]));
        assert_eq!(within([3.0, 0.0], [4.0, 0.0]), (0.0, vec![0]));
        // a tenth of the margin is the solver's
        assert_eq!(within([0.0, 0.0], [2.0 - 3e-7, 0.0]), (1.0, vec![]));
        assert_eq!(within([0.0, 0.0], [2.0 - 1e-7, 0.0]).1, [0]);
    }

    /// Differences of chordwise neighbours in all families, and less than every factor, as boxes have them.
    #[test]
    fn rows_are_the_differences_of_neighbours_and_the_factors_of_every_strip() {
        let toy = Toy::new(4, 6);
        let basis = Basis::new(&toy.boxes, 3, 2);
        let x: Vec<f64> = (0..basis.size()).map(|k| ((7 * k * k + k) % 23) as f64 / 10.0).collect();
        let (rows, strips) = bound_rows(&basis, &toy.boxes, 0.05, 0.2);
        let c = basis.corrections(&x);
        let (mut differences, mut factors) = (Vec::new(), Vec::new());
        // two boxes share a polynomial: the first of each, and where it follows another
        for b in (0..24).step_by(2) {
            for family in [&c.force, &c.moment, &c.pressure_offset] {
                if b % 6 > 0 {
                    differences.extend([family[b] - family[b - 1], family[b - 1] - family[b]]);
                }
            }
            factors.extend([-c.force[b], -c.moment[b]]);
        }
        let of = |limit: f64| -> Vec<f64> {
            rows.iter().filter(|row| row.limit == limit).map(|row| row.value(&x)).collect()
        };
        for (mut found, mut expected) in [(of(0.05), differences), (of(-0.2), factors)] {
            assert_eq!(found.len(), expected.len());
            found.sort_by(f64::total_cmp);
            expected.sort_by(f64::total_cmp);
            assert!(
                found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-12),
                "{found:?} {expected:?}"
            );
        }
        // 2 strips that follow another, 6 differences each; 6 factors
        assert_eq!(strips, (0..4).flat_map(|strip| [strip; 18]).collect::<Vec<_>>());
    }

    /// Lobatto's five points of 0 to 1 are 0, (2 - root 2)/4, 1/2, (2 + root 2)/4, 1.
    #[test]
    fn a_fit_starts_with_the_strips_at_lobattos_points() {
        let toy = Toy::new(25, 2);
        let basis = Basis::new(&toy.boxes, 2, 0);
        let found = bounds(&basis, &toy.boxes, 0.05, 0.2);
        // of a strip: two factors, then six differences and two factors
        assert_eq!(found.rows.len(), 250);
        let strips: Vec<usize> = found.first.iter().map(|row| row / 10).collect();
        assert_eq!(strips, [0, 3, 12, 21, 24].iter().flat_map(|s| [*s; 10]).collect::<Vec<_>>());
    }

    #[test]
    fn neighbours_are_at_their_bound_within_a_percent_of_it() {
        let rows = [row(0, 1.0, 2.0), row(0, -1.0, 2.0), row(0, -1.0, -0.1)];
        for (x, active) in [(1.97, 0), (1.99, 1), (2.0, 1), (-1.985, 1), (0.1, 0), (0.0, 0)] {
            assert_eq!(active_neighbours(&rows, &[x]), active, "{x}");
        }
        // a bound of zero is no neighbours'
        assert_eq!(active_neighbours(&[row(0, 1.0, 0.0)], &[1.0]), 0);
    }
}
