//! Convex hulls in a plane with an exact test of which side of a line a point is on.

use robust::{Coord, orient2d};

/// The corners of the convex hull, counter-clockwise from the smallest x (of equal x the smallest y): places in `points`.
///
/// Extreme points only: none inside an edge; of equal points the first. Points on one line have two corners, equal points one.
pub(super) fn corners(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let by_place = |a: &usize, b: &usize| {
        let (p, q) = (points[*a], points[*b]);
        // Zeros of both signs are the same point.
        (p.0 + 0.0).total_cmp(&(q.0 + 0.0)).then((p.1 + 0.0).total_cmp(&(q.1 + 0.0))).then(a.cmp(b))
    };
    order.sort_by(by_place);
    order.dedup_by(|b, a| points[*a] == points[*b]);
    if order.len() < 3 {
        return order;
    }
    let mut lower = half(points, order.iter().copied());
    let mut upper = half(points, order.iter().rev().copied());
    lower.pop();
    upper.pop();
    lower.extend(upper);
    lower
}

/// The lower hull of sorted points, or the upper of reversed ones.
fn half(points: &[(f64, f64)], order: impl Iterator<Item = usize>) -> Vec<usize> {
    let at = |place: usize| Coord { x: points[place].0, y: points[place].1 };
    let mut kept: Vec<usize> = Vec::new();
    for next in order {
        while let [.., before, last] = kept[..] {
            if orient2d(at(before), at(last), at(next)) > 0.0 {
                break;
            }
            kept.pop();
        }
        kept.push(next);
    }
    kept
}
