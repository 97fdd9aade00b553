//! Laws of element matrices and sections: masses beside integrals worked out by hand, panels whichever corner comes
//! first, rigid shear, counts.

use crate::common::{beam, close, section, system};
use faer::Mat;
use nalgebra::{DVector, Matrix2, Matrix3, Point3, Vector3};
use nastran::{Mat1, Span, parse_deck};
use std::sync::Arc;
use structure::{
    CurvedPlace, CurvedShell, Element, Model, QuadraticSolid, SectionAxis, ShellSection, SolidMaterial,
    count_below, normal_modes,
};

fn solid(corners: &[[f64; 3]], edges: &[[usize; 2]], rho: f64) -> (QuadraticSolid, Vec<Vector3<f64>>) {
    let corners: Vec<Vector3<f64>> = corners.iter().copied().map(Vector3::from).collect();
    let middles = edges.iter().map(|[a, b]| (corners[*a] + corners[*b]) * 0.5);
    let places: Vec<Vector3<f64>> = corners.iter().copied().chain(middles).collect();
    let expansion = nastran::Expansion::default();
    let card = Mat1 { id: 1, e: 1e6, g: 0.0, nu: 0.25, rho, expansion, span: Span::generated("test") };
    let material = Arc::new(SolidMaterial::from_mat1(&card).expect("a sound material"));
    let points: Vec<Point3<f64>> = places.iter().copied().map(Point3::from).collect();
    let (nodes, sides): (Vec<_>, Vec<_>) = ((0..places.len()).collect(), (0..edges.len()).collect());
    let built = QuadraticSolid::new(1, nodes, &points, &sides, &material, &Span::generated("test"));
    (built.expect("a possible solid"), places)
}

/// Integrals of products of the ten functions over a tetrahedron, in units of V / 420.
#[test]
fn a_quadratic_tetrahedron_has_the_mass_of_its_integrals() {
    let corners = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.4], [0.2, 0.9, 0.2], [0.4, 0.3, 1.5]];
    let edges = crate::meshed::TETRA;
    let (element, at) = solid(&corners, edges, 3.0);
    let volume = (at[1] - at[0]).cross(&(at[2] - at[0])).dot(&(at[3] - at[0])) / 6.0;
    close(element.volume_m3(), volume, 1e-12, "volume");
    let m = element.mass().expect("a density");
    let ends = |i: usize| if i < 4 { vec![i] } else { edges[i - 4].to_vec() };
    for i in 0..10 {
        for j in 0..10 {
            let (a, b) = (ends(i), ends(j));
            let shared = a.iter().filter(|end| b.contains(end)).count();
            let expected = match (a.len(), b.len(), shared) {
                (1, 1, 1) => 6.0,
                (1, 1, _) => 1.0,
                (2, 2, 2) => 32.0,
                (2, 2, 1) => 16.0,
                (2, 2, _) => 8.0,
                (_, _, 1) => -4.0,
                _ => -6.0,
            };
            let own = m[(3 * i, 3 * j)] / (3.0 * volume / 420.0);
            assert!((own - expected).abs() < 1e-9, "{i} {j}: {own} for {expected}");
            assert_eq!(m[(3 * i, 3 * j + 1)], 0.0, "x and y are apart");
            assert_eq!(m[(3 * i, 3 * j)], m[(3 * i + 2, 3 * j + 2)], "all axes alike");
        }
    }
    // Lumped on the edges, as Nastran does.
    let lumped = element.lumped_mass().expect("a density");
    assert_eq!(lumped[(0, 0)], 0.0, "corner");
    close(lumped[(29, 29)], 3.0 * volume / 6.0, 1e-9, "edge");
    assert!(solid(&corners, edges, 0.0).0.mass().is_none(), "nothing without a density");
}

/// Functions that reproduce quadratic polynomials integrate their products exactly.
#[test]
fn quadratic_boxes_and_wedges_have_the_moments_of_their_bodies() {
    let [a, b, c] = [1.2, 0.7, 2.1];
    let place = |x: f64, y: f64, z: f64| [a * x, b * y, c * z];
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let layer = |flat: &[[f64; 2]]| -> Vec<[f64; 3]> {
        [0.0, 1.0].iter().flat_map(|z| flat.iter().map(|[x, y]| place(*x, *y, *z))).collect()
    };
    let whole = solid(&layer(&square), crate::meshed::HEXA, 2.0);
    let half = solid(&layer(&[square[0], square[1], square[3]]), crate::meshed::WEDGE, 2.0);
    // Integrals of x^i y^j over the unit square and its half.
    let fact = |n: i32| f64::from((1..=n).product::<i32>());
    let of_square = |i: i32, j: i32| 1.0 / f64::from((i + 1) * (j + 1));
    let of_half = |i: i32, j: i32| fact(i) * fact(j) / fact(i + j + 2);
    let powers =
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1), (2, 0, 0), (0, 0, 2)];
    for ((element, at), flat) in [(whole, &of_square as &dyn Fn(i32, i32) -> f64), (half, &of_half)] {
        let m = element.mass().expect("a density");
        let at_nodes = |(i, j, k): (i32, i32, i32)| {
            let value = |p: &Vector3<f64>| p.x.powi(i) * p.y.powi(j) * p.z.powi(k);
            DVector::from_fn(3 * at.len(), |row, _| if row % 3 == 0 { value(&at[row / 3]) } else { 0.0 })
        };
        for p in powers {
            for q in powers {
                let (i, j, k) = (p.0 + q.0, p.1 + q.1, p.2 + q.2);
                let scale = 2.0 * a.powi(i + 1) * b.powi(j + 1) * c.powi(k + 1);
                let expected = scale * flat(i, j) / f64::from(k + 1);
                let own = at_nodes(p).dot(&(&*m * at_nodes(q)));
                close(own, expected, 1e-9, &format!("{} grids, {p:?} by {q:?}", at.len()));
            }
        }
    }
}

/// Lumped in proportion to the diagonal of the consistent mass: 6 to 32 in a square with eight grids and a triangle
/// with six.
#[test]
fn curved_shells_lump_their_mass_by_its_diagonal() {
    let mut section = plain();
    section.mass_kg_m2 = 5.0;
    for (corners, edges, area) in [
        (vec![[1.0, 0.0, 0.2], [3.0, 0.0, 0.2], [3.0, 1.0, 0.2], [1.0, 1.0, 0.2]], crate::meshed::QUAD, 2.0),
        (vec![[1.0, 0.0, 0.2], [3.0, 0.0, 0.2], [1.0, 1.0, 0.2]], crate::meshed::TRIANGLE, 1.0),
    ] {
        let corners: Vec<Vector3<f64>> = corners.into_iter().map(Vector3::from).collect();
        let middles = edges.iter().map(|[a, b]| (corners[*a] + corners[*b]) * 0.5);
        let points: Vec<Point3<f64>> = corners.iter().copied().chain(middles).map(Point3::from).collect();
        let n = corners.len();
        let place = CurvedPlace {
            nodes: (0..points.len()).collect(),
            points,
            sides: (0..n).collect(),
            offset_m: 0.0,
        };
        let axis = SectionAxis::Angle(0.0);
        let shell = CurvedShell::new(1, place, Arc::new(section), axis, &Span::generated("test"));
        let shell = shell.expect("a possible shell");
        close(shell.area_m2(), area, 1e-12, "area");
        let lumped = shell.lumped_mass().expect("a mass");
        for row in 0..12 * n {
            let share = if row / 6 < n { 6.0 } else { 32.0 } / (38.0 * n as f64);
            let expected = if row % 6 < 3 { share * 5.0 * area } else { 0.0 };
            assert!((lumped[(row, row)] - expected).abs() < 1e-9, "{row}: {} {expected}", lumped[(row, row)]);
        }
    }
}

/// A section 0.1 m thick of G = 1.
fn plain() -> ShellSection {
    let plane = Matrix3::new(3.0, 1.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 1.0);
    ShellSection {
        membrane: plane * 0.1,
        coupling: Matrix3::zeros(),
        bending: plane * (1e-3 / 12.0),
        shear: Matrix2::identity() * (0.1 * 5.0 / 6.0),
        mass_kg_m2: 0.0,
        nsm_kg_m2: 0.0,
        mass_moment_kg_m: 0.0,
        mass_inertia_kg: 0.0,
    }
}

#[test]
fn shear_that_is_stiffer_than_rigid_is_a_thousand_times_the_membranes() {
    let same = |own: &Matrix2<f64>, expected: &Matrix2<f64>, what: &str| {
        assert!((own - expected).amax() < 1e-9 * expected.amax(), "{what}: {own} {expected}");
    };
    let soft = plain();
    assert_eq!(soft.with_finite_shear(0.1).shear, soft.shear, "what is flexible stays");
    let with = |shear: Matrix2<f64>| ShellSection { shear, ..soft }.with_finite_shear(0.1).shear;
    let rigid = Matrix2::identity() * 100.0;
    for shear in [Matrix2::identity() * f64::INFINITY, Matrix2::zeros(), Matrix2::new(1.0, 2.0, 2.0, 1.0)] {
        same(&with(shear), &rigid, "rigid");
    }
    // 400 is four times too stiff: its row and column go by one half.
    let clipped = Matrix2::new(100.0, 2.0, 2.0, 50.0);
    same(&with(Matrix2::new(400.0, 4.0, 4.0, 50.0)), &clipped, "one axis");
    same(&with(Matrix2::new(400.0, 4.0, 4.0, 1600.0)), &Matrix2::new(100.0, 0.5, 0.5, 100.0), "both");
    // What only bends: G t = 12 D33 / t².
    let bends = ShellSection { membrane: Matrix3::zeros(), shear: Matrix2::zeros(), ..soft };
    same(&bends.with_finite_shear(0.1).shear, &rigid, "of bending");
    same(&bends.with_finite_shear(0.2).shear, &(rigid * 0.25), "twice as thick for the same bending");
}

#[test]
fn a_panel_is_the_same_whichever_corner_comes_first_and_wherever_it_stands() {
    let corners =
        [[0.0, 0.0, 0.05], [1.1, 0.1, -0.05], [0.9, 0.8, 0.05], [0.1, 0.6, -0.05]].map(Vector3::from);
    let k = |points: [Vector3<f64>; 4]| {
        let grid = |(at, p): (usize, &Vector3<f64>)| {
            format!("GRID,{},,{:.13},{:.13},{:.13}\n", at + 1, p.x, p.y, p.z)
        };
        let grids: String = points.iter().enumerate().map(grid).collect();
        let deck =
            format!("{grids}CSHEAR,1,1,1,2,3,4\nPSHEAR,1,1,.002,.5,.5,1.\nMAT1,1,7.02+10,2.7+10,.3,2700.\n");
        let model = Model::from_bulk(&parse_deck("t.bdf", &deck).expect("a deck")).expect("a model");
        model.elements[0].stiffness().expect("has stiffness").into_owned()
    };
    let first = k(corners);
    let next = k([1, 2, 3, 0].map(|at: usize| corners[at]));
    // F1 and F2 change places with the corners: what is left when both orders are turned twice.
    let opposite = k([2, 3, 0, 1].map(|at: usize| corners[at]));
    let moved = |i: usize, by: usize| 3 * ((i / 3 + by) % 4) + i % 3;
    let turn = nalgebra::Rotation3::from_scaled_axis(Vector3::new(0.4, -0.9, 0.3));
    let elsewhere = k(corners.map(|p| turn * p + Vector3::new(3.0, -2.0, 1.0)));
    let doubled = k(corners.map(|p| p * 2.0));
    assert!((next.trace() / first.trace() - 1.0).abs() < 0.5, "of one size");
    for i in 0..12 {
        for j in 0..12 {
            let other = opposite[(i, j)] - first[(moved(i, 2), moved(j, 2))];
            assert!(other.abs() < 1e-8 * first.amax(), "{i} {j}: {other}");
        }
    }
    for (a, b) in (0..16).map(|at| (3 * (at / 4), 3 * (at % 4))) {
        let turned = turn.matrix() * first.fixed_view::<3, 3>(a, b) * turn.matrix().transpose();
        let error = (elsewhere.fixed_view::<3, 3>(a, b) - turned).amax();
        assert!(error < 1e-8 * first.amax(), "{a} {b}: {error}");
    }
    // Without F1 and F2 as areas of width times thickness, a panel twice as large in its plane is as stiff.
    assert!((doubled - &first).amax() < 1e-8 * first.amax(), "the size does not matter");
}

#[test]
fn unit_loads_reduce_as_all_loads_do() {
    let tied = beam(1, 2, 2.0, 0.0) + &section() + "GRID,9,,.5,2.,.3\nRBE2,9,3,123456,9\nSPC1,1,123456,1\n";
    let system = system(&tied);
    let dofs: Vec<usize> = (0..6 * system.node_count()).collect();
    let all = system.reduce(Mat::<f64>::identity(dofs.len(), dofs.len()).as_ref());
    let units = system.reduce_units(&dofs);
    assert!((0..all.nrows()).all(|i| (0..all.ncols()).all(|j| units[(i, j)] == all[(i, j)])));
    // A force along z at the end of the arm turns its foot by the arm: x, y, z, then moments.
    let at = system.node_index(9).expect("it is there");
    let feet: Vec<f64> = (0..6).map(|c| units[(units.nrows() - 6 + c, 6 * at + 2)]).collect();
    assert_eq!(feet, [0.0, 0.0, 1.0, 0.0, -0.5, 0.0]);
}

#[test]
fn modes_are_counted_below_a_frequency_and_a_frequency_that_is_met_counts() {
    let point = |id: u32, k: f64| {
        format!("GRID,{id},,{id}.,0.,0.\nCONM2,{id},{id},,1.\nCELAS2,{},{k:?},{id},3\n", 10 + id)
    };
    let deck = point(1, 4.0) + &point(2, 9.0) + &point(3, 9.0) + "SPC1,1,12456,1,2,3\n";
    let system = system(&deck);
    for (omega, count) in [
        (f64::NAN, 0),
        (-1.0, 0),
        (0.0, 0),
        (1.999, 0),
        (2.0, 1),
        (2.001, 1),
        (2.999, 1),
        (3.0, 3),
        (3.001, 3),
    ] {
        assert_eq!(count_below(&system, omega).expect("it counts"), count, "{omega}");
    }
}

/// Frequencies go with the root of the stiffness, and rigid motions stay without any.
#[test]
fn a_free_beam_has_six_zero_frequencies_however_stiff_or_soft_it_is() {
    let base = normal_modes(&system(&(beam(1, 4, 2.0, 0.0) + &section())), 9).expect("modes").omega_rad_s;
    for power in [12, -12] {
        let scaled = section()
            .replace(
                &format!("{:.1E}", crate::common::E),
                &format!("{:.1E}", crate::common::E * 10_f64.powi(power)),
            )
            .replace(
                &format!("{:.1E}", crate::common::G),
                &format!("{:.1E}", crate::common::G * 10_f64.powi(power)),
            );
        let own = normal_modes(&system(&(beam(1, 4, 2.0, 0.0) + &scaled)), 9).expect("modes").omega_rad_s;
        assert_eq!(own[..6], [0.0; 6]);
        for (own, base) in own[6..].iter().zip(&base[6..]) {
            close(*own, base * 10_f64.powi(power / 2), 1e-5, "an elastic frequency");
        }
    }
}
