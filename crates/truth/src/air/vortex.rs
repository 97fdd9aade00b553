//! Straight vortices in the plane z = 0 (Biot and Savart).

/// A point of the plane, m.
pub(crate) type Point = [f64; 2];

/// Downwash at a point by a vortex of unit strength from one point to another.
fn segment(at: Point, from: Point, to: Point) -> f64 {
    let (a, b) = ([at[0] - from[0], at[1] - from[1]], [at[0] - to[0], at[1] - to[1]]);
    let across = a[0] * b[1] - a[1] * b[0];
    let (far, near) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
    let along = [to[0] - from[0], to[1] - from[1]];
    let length2 = along[0] * along[0] + along[1] * along[1];
    if across * across <= 1e-20 * length2 * far.max(near).powi(2) {
        return 0.0;
    }
    let share = (along[0] * a[0] + along[1] * a[1]) / far - (along[0] * b[0] + along[1] * b[1]) / near;
    -share / (2.0 * std::f64::consts::TAU * across)
}

/// Downwash of a ring: corners inner front, outer front, outer rear, inner rear. Its front runs outward, so that it lifts.
pub(crate) fn ring(at: Point, corners: &[Point; 4]) -> f64 {
    (0..4).map(|side| segment(at, corners[side], corners[(side + 1) % 4])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn a_long_vortex_blows_down_behind_itself_as_a_line_does() {
        let found = segment([2.0, 0.0], [0.0, -1e5], [0.0, 1e5]);
        assert!((found - 1.0 / (TAU * 2.0)).abs() < 1e-9, "{found}");
        assert!(segment([-2.0, 0.0], [0.0, -1e5], [0.0, 1e5]) < 0.0);
    }

    #[test]
    fn a_square_ring_blows_through_its_middle_as_known() {
        // side 2: four sides at distance 1, each sqrt 2/(4 pi)
        let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
        assert!((ring([0.0, 0.0], &corners) - 2.0_f64.sqrt() / PI).abs() < 1e-12);
    }
}
