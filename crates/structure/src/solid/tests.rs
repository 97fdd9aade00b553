//! Shape functions, rules of integration and strain modes of the three families.

use super::shape::QuadraturePoint;
use super::*;
use crate::serendipity::{self, Edge, Functions, with_midsides};

fn factorial(n: i32) -> f64 {
    f64::from((1..=n).product::<i32>())
}

/// Integral of x^i over -1 to 1.
fn along(i: i32) -> f64 {
    if i % 2 == 0 { 2.0 / f64::from(i + 1) } else { 0.0 }
}

/// Integrals of r^i s^j t^k over the parent shapes.
fn exact(corners: usize, [i, j, k]: [i32; 3]) -> f64 {
    match corners {
        8 => along(i) * along(j) * along(k),
        6 => factorial(i) * factorial(j) / factorial(i + j + 2) * along(k),
        _ => factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3),
    }
}

/// Checks a rule on all products whose degrees over the first two coordinates and along the third it must integrate.
fn integrates(corners: usize, points: &[QuadraturePoint], fits: &dyn Fn([i32; 3]) -> bool, what: &str) {
    for at in 0..216 {
        let powers = [at / 36, at / 6 % 6, at % 6];
        if fits(powers) {
            let value =
                |p: &QuadraturePoint| (0..3).map(|axis| p.at[axis].powi(powers[axis])).product::<f64>();
            let own: f64 = points.iter().map(|p| p.weight * value(p)).sum();
            let expected = exact(corners, powers);
            assert!((own - expected).abs() < 1e-13, "{what}: {powers:?}: {own} for {expected}");
        }
    }
}

#[test]
fn rules_are_exact_to_the_degrees_that_they_claim() {
    let shape = |corners: usize| base_of(corners).expect("a family");
    let each = |most: i32| move |p: [i32; 3]| p.iter().all(|power| *power <= most);
    let prism = |flat: i32, line: i32| move |[i, j, k]: [i32; 3]| i + j <= flat && k <= line;
    let total = |most: i32| move |p: [i32; 3]| p.iter().sum::<i32>() <= most;
    integrates(8, &shape(8).stiffness_points(), &each(3), "CHEXA, stiffness");
    for points in [shape(8).mass_points(), shape(8).quadratic_points(), shape(8).quadratic_mass_points()] {
        integrates(8, &points, &each(5), "CHEXA, 27 points");
    }
    integrates(6, &shape(6).stiffness_points(), &prism(2, 3), "CPENTA, stiffness");
    integrates(6, &shape(6).quadratic_points(), &prism(2, 5), "CPENTA, stiffness with edges");
    for points in [shape(6).mass_points(), shape(6).quadratic_mass_points()] {
        integrates(6, &points, &prism(5, 5), "CPENTA, mass");
    }
    integrates(4, &shape(4).stiffness_points(), &total(1), "CTETRA, stiffness");
    for points in [shape(4).mass_points(), shape(4).quadratic_points()] {
        integrates(4, &points, &total(2), "CTETRA, four points");
    }
    integrates(4, &shape(4).quadratic_mass_points(), &total(5), "CTETRA, mass with edges");
}

fn corners_of(count: usize) -> Vec<[f64; 3]> {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let layers = |flat: &[[f64; 2]]| -> Vec<[f64; 3]> {
        [-1.0, 1.0].iter().flat_map(|z| flat.iter().map(|[x, y]| [*x, *y, *z])).collect()
    };
    match count {
        8 => layers(&square),
        6 => layers(&triangle),
        _ => vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    }
}

fn edges_of(count: usize) -> &'static [Edge] {
    match count {
        8 => &serendipity::HEXAHEDRON,
        6 => &serendipity::WEDGE,
        _ => &serendipity::TETRAHEDRON,
    }
}

/// Functions of the corners and of the grids on edges.
fn functions(count: usize, edges: &[Edge], at: [f64; 3]) -> Functions {
    let shape = base_of(count).expect("a family");
    let (values, slopes) = (shape.values(at), shape.gradients(at));
    assert!(values.iter().skip(count).all(|value| *value == 0.0), "padded with zeros");
    assert!(slopes.column_iter().skip(count).all(|slope| slope.norm() == 0.0), "padded with zeros");
    let linear = Functions {
        values: values.iter().take(count).copied().collect(),
        slopes: slopes.column_iter().take(count).map(Into::into).collect(),
    };
    with_midsides(linear, edges.iter().copied(), at)
}

#[test]
fn functions_are_one_at_their_grid_and_slopes_are_theirs() {
    for count in [8, 6, 4] {
        let (corners, all) = (corners_of(count), edges_of(count));
        for edges in [&all[..0], &all[1..3], all] {
            let middle = |edge: &Edge| {
                let [a, b] = edge.ends().map(|end| corners[end]);
                [0, 1, 2].map(|axis| 0.5 * (a[axis] + b[axis]))
            };
            let places: Vec<[f64; 3]> = corners.iter().copied().chain(edges.iter().map(middle)).collect();
            for (own, at) in places.iter().enumerate() {
                for (other, value) in functions(count, edges, *at).values.iter().enumerate() {
                    let expected = f64::from(u8::from(own == other));
                    assert!((value - expected).abs() < 1e-15, "{count} corners: {other} at grid {own}");
                }
            }
            for at in [[0.3, 0.2, -0.4], [0.1, 0.6, 0.7], [0.25, 0.15, 0.05]] {
                let (own, step) = (functions(count, edges, at), 1e-5);
                assert!((own.values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                for axis in 0..3 {
                    let moved = |by: f64| {
                        let mut at = at;
                        at[axis] += by;
                        functions(count, edges, at).values
                    };
                    for (node, (up, down)) in moved(step).iter().zip(moved(-step)).enumerate() {
                        let difference = (up - down) / (2.0 * step);
                        let slope = own.slopes[node][axis];
                        assert!(
                            (slope - difference).abs() < 1e-9,
                            "{count} corners: {node} by {axis}: {slope}"
                        );
                    }
                }
            }
        }
    }
}

/// A constant stress does no work on them: their mean is zero.
#[test]
fn strain_modes_have_no_mean_and_are_those_that_are_told() {
    for (count, modes) in [(8, 21), (6, 12), (4, 0)] {
        let shape = base_of(count).expect("a family");
        assert_eq!(shape.mode_count(), modes);
        let mean: ModeStrains = shape.mass_points().iter().map(|p| shape.mode_strains(p.at) * p.weight).sum();
        assert!(mean.amax() < 1e-14, "{count} corners: {mean}");
        let own = shape.mode_strains([0.21, 0.34, 0.55]);
        assert!(own.columns(modes, 21 - modes).amax() == 0.0);
        assert!((0..modes).all(|mode| own.column(mode).amax() > 0.0));
        assert_eq!(shape.middle().len(), 3);
    }
    let amounts = |count: usize, at: [f64; 3], row: usize| {
        let modes = base_of(count).expect("a family").mode_strains(at);
        let mut own: Vec<f64> = modes.row(row).iter().copied().filter(|value| *value != 0.0).collect();
        own.sort_by(f64::total_cmp);
        own
    };
    // xx: x, x y, x z; xy: x, y, x z, y z; and so on in turn.
    let told = [
        vec![2.0, 6.0, 10.0],
        vec![3.0, 6.0, 15.0],
        vec![5.0, 10.0, 15.0],
        vec![2.0, 3.0, 10.0, 15.0],
        vec![3.0, 5.0, 6.0, 10.0],
        vec![2.0, 5.0, 6.0, 15.0],
    ];
    for (row, told) in told.iter().enumerate() {
        assert_eq!(amounts(8, [2.0, 3.0, 5.0], row), *told, "row {row}");
    }
    // Of a wedge with p = 2, q = 3: 1 - z^2 along three directions, p^2, p q and q^2 in the triangle and across it.
    let third = 1.0 / 3.0;
    let told =
        [vec![2.0, 3.0], vec![2.0, 3.0], vec![5.0], vec![2.0, 3.0], vec![2.0, 3.0, 5.0], vec![2.0, 3.0, 5.0]];
    for (row, told) in told.iter().enumerate() {
        let own = amounts(6, [2.0 + third, 3.0 + third, 5.0], row);
        assert!(
            own.len() == told.len() && own.iter().zip(told).all(|(a, b)| (a - b).abs() < 1e-14),
            "row {row}"
        );
    }
}

#[test]
fn the_modes_are_measured_from_the_middle() {
    for (count, middle) in [(8, [0.0; 3]), (6, [1.0 / 3.0, 1.0 / 3.0, 0.0]), (4, [0.25; 3])] {
        let shape = base_of(count).expect("a family");
        let corners = corners_of(count);
        let mean =
            [0, 1, 2].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / count as f64);
        assert_eq!(shape.middle(), middle);
        assert!(mean.iter().zip(middle).all(|(mean, own)| (mean - own).abs() < 1e-15));
    }
    assert!(base_of(5).is_none());
    assert_eq!(
        [8, 6, 4].map(|count| base_of(count).map(Shape::card)),
        ["CHEXA", "CPENTA", "CTETRA"].map(Some)
    );
}
