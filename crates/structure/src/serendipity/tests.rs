//! Shape functions: one at their own grid, their slopes those of differences.

use super::*;

/// Each function is one at its grid and zero at the others, and together they are one.
#[test]
fn functions_belong_to_their_grids() {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let triangles = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let check = |corners: &[[f64; 2]], edges: &[Edge], linear: fn([f64; 2]) -> Functions| {
        let middle = |edge: &Edge| {
            let [a, b] = edge.ends().map(|end| corners[end]);
            [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
        };
        let places: Vec<[f64; 2]> = corners.iter().copied().chain(edges.iter().map(middle)).collect();
        for (own, [x, y]) in places.iter().enumerate() {
            let functions = with_midsides(linear([*x, *y]), edges.iter().copied(), [*x, *y, 0.0]);
            for (other, value) in functions.values.iter().enumerate() {
                assert_eq!(*value, f64::from(u8::from(own == other)), "{other} at grid {own}");
            }
        }
        let functions = with_midsides(linear([0.3, 0.2]), edges.iter().copied().skip(1), [0.3, 0.2, 0.0]);
        assert!((functions.values.iter().sum::<f64>() - 1.0).abs() < 1e-15, "one grid is left out");
        assert!(functions.slopes.iter().sum::<Vector3<f64>>().norm() < 1e-15);
    };
    check(&corners, &QUADRILATERAL, quadrilateral);
    check(&triangles, &TRIANGLE, triangle);
}

/// Slopes are those of differences, with all edges and with some, and functions add up to one.
#[test]
fn slopes_are_those_of_the_functions() {
    let check = |edges: &[Edge], linear: fn([f64; 2]) -> Functions, what: &str| {
        let of = |[x, y]: [f64; 2]| with_midsides(linear([x, y]), edges.iter().copied(), [x, y, 0.0]);
        for at in [[0.3, 0.2], [-0.4, 0.7], [0.1, -0.9]] {
            let (own, step) = (of(at), 1e-5);
            for axis in 0..2 {
                let moved = |by: f64| {
                    let mut at = at;
                    at[axis] += by;
                    of(at).values
                };
                let (up, down) = (moved(step), moved(-step));
                for (node, slope) in own.slopes.iter().enumerate() {
                    let difference = (up[node] - down[node]) / (2.0 * step);
                    assert!((slope[axis] - difference).abs() < 1e-9, "{what}, function {node}, {axis}");
                }
            }
            assert!((own.values.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{what}");
            assert!(own.slopes.iter().all(|slope| slope.z == 0.0));
        }
    };
    check(&QUADRILATERAL, quadrilateral, "eight grids");
    check(&QUADRILATERAL[1..3], quadrilateral, "six of eight grids");
    check(&TRIANGLE, triangle, "six grids");
    check(&TRIANGLE[1..2], triangle, "four of six grids");
}

#[test]
fn lumped_masses_share_the_total_by_their_own() {
    assert_eq!(lumped(&[1.0, 3.0, 4.0], 16.0), [2.0, 6.0, 8.0]);
}
