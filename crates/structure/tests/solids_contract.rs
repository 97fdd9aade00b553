//! What every solid must fulfil: symmetry, exactly six motions without energy, mass and moments of inertia of its
//! shape, indifference to the frame, to size and to where the numbering starts.
//!
//! Inertia beside the closed form of a tetrahedron with corners v: int x x^T dV = V/20 (sum v v^T + s s^T), s the
//! sum of the corners (shapes with plane faces are put together from tetrahedra), and of the box, m/12 (b^2 + c^2).

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use nalgebra::{DMatrix, DVector, Matrix3, Point3, Rotation3, Vector3};
use nastran::{Mat1, Mat9, Span};
use std::sync::Arc;
use structure::{Element, Solid, SolidMaterial};

const RHO: f64 = 1700.0;

fn span() -> Span {
    Span::generated("test")
}

fn isotropic() -> Mat1 {
    Mat1 { id: 1, e: 70e9, g: 0.0, nu: 0.3, rho: RHO, expansion: nastran::Expansion::default(), span: span() }
}

/// A timber-like material: three moduli, three Poisson's ratios, three shear moduli, all different.
fn orthotropic() -> Mat9 {
    let mut g = [0.0; 21];
    // 11 12 13, 22 23, 33, 44 55 66
    for (at, value) in [
        (0, 12e9),
        (1, 1.1e9),
        (2, 0.8e9),
        (6, 2e9),
        (7, 0.5e9),
        (11, 1e9),
        (15, 0.7e9),
        (18, 0.2e9),
        (20, 0.6e9),
    ] {
        g[at] = value;
    }
    Mat9 { id: 2, g, rho: RHO, expansion: nastran::Expansion::default(), span: span() }
}

fn turned_material(rotation: &Rotation3<f64>, is_orthotropic: bool) -> Arc<SolidMaterial> {
    let own = Rotation3::from_euler_angles(0.3, 0.5, -0.8);
    Arc::new(if is_orthotropic {
        SolidMaterial::from_mat9(&orthotropic(), (rotation * own).matrix()).unwrap()
    } else {
        SolidMaterial::from_mat1(&isotropic()).unwrap()
    })
}

fn points(of: &[[f64; 3]]) -> Vec<Point3<f64>> {
    of.iter().map(|p| Point3::from(*p)).collect()
}

fn solid(points: &[Point3<f64>], material: &Arc<SolidMaterial>) -> Solid {
    Solid::new(7, (0..points.len()).collect(), points, material, &span()).unwrap()
}

fn rigid(points: &[Point3<f64>]) -> DMatrix<f64> {
    let mut motions = DMatrix::zeros(3 * points.len(), 6);
    for (node, point) in points.iter().enumerate() {
        for axis in 0..3 {
            let unit = Vector3::ith(axis, 1.0);
            motions.view_mut((3 * node, axis), (3, 1)).copy_from(&unit);
            motions.view_mut((3 * node, 3 + axis), (3, 1)).copy_from(&unit.cross(&point.coords));
        }
    }
    motions
}

fn k(solid: &Solid) -> DMatrix<f64> {
    solid.stiffness().unwrap().into_owned()
}

fn m(solid: &Solid) -> DMatrix<f64> {
    solid.mass().unwrap().into_owned()
}

const BOX: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [3.0, 0.0, 0.0],
    [3.0, 2.0, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 0.0, 0.5],
    [3.0, 0.0, 0.5],
    [3.0, 2.0, 0.5],
    [0.0, 2.0, 0.5],
];
/// A truncated pyramid, leaning: plane faces, no two parallel edges of one length.
const TRUNK: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [3.0, 0.0, 0.0],
    [3.0, 2.0, 0.0],
    [0.0, 2.0, 0.0],
    [1.4, 0.5, 1.5],
    [2.9, 0.5, 1.5],
    [2.9, 1.5, 1.5],
    [1.4, 1.5, 1.5],
];
/// The inner element of MacNeal and Harder's patch: no plane faces.
const PATCH: [[f64; 3]; 8] = [
    [0.249, 0.342, 0.192],
    [0.826, 0.288, 0.288],
    [0.850, 0.649, 0.263],
    [0.273, 0.750, 0.230],
    [0.320, 0.186, 0.643],
    [0.677, 0.305, 0.683],
    [0.788, 0.693, 0.644],
    [0.165, 0.745, 0.702],
];
const WEDGE: [[f64; 3]; 6] =
    [[0.2, 0.1, 0.0], [1.2, 0.3, 0.0], [0.5, 0.9, 0.0], [0.2, 0.1, 0.4], [1.2, 0.3, 0.4], [0.5, 0.9, 0.4]];
/// Its upper triangle is half as large and moved: plane faces again.
const TAPERED_WEDGE: [[f64; 3]; 6] =
    [[0.2, 0.1, 0.0], [1.2, 0.3, 0.0], [0.5, 0.9, 0.0], [0.4, 0.2, 0.8], [0.9, 0.3, 0.8], [0.55, 0.6, 0.8]];
const TWISTED_WEDGE: [[f64; 3]; 6] =
    [[0.2, 0.1, 0.0], [1.2, 0.3, 0.1], [0.5, 0.9, -0.1], [0.5, 0.0, 0.8], [1.1, 0.6, 0.9], [0.3, 0.8, 0.7]];
const TETRA: [[f64; 3]; 4] = [[0.1, 0.2, 0.3], [1.1, 0.1, 0.2], [0.3, 1.3, 0.5], [0.4, 0.3, 0.9]];

const SHAPES: [&[[f64; 3]]; 7] = [&BOX, &TRUNK, &PATCH, &WEDGE, &TAPERED_WEDGE, &TWISTED_WEDGE, &TETRA];

/// Every shape with both materials, turned.
fn each(check: impl Fn(&[Point3<f64>], &dyn Fn(&Rotation3<f64>) -> Solid)) {
    for shape in SHAPES {
        for is_orthotropic in [false, true] {
            let corners = points(shape);
            check(&corners, &|rotation| {
                let turned: Vec<_> = corners.iter().map(|point| rotation * point).collect();
                solid(&turned, &turned_material(rotation, is_orthotropic))
            });
        }
    }
}

#[test]
fn stiffness_and_mass_are_exactly_symmetric() {
    each(|_, build| {
        let solid = build(&Rotation3::identity());
        assert_eq!(k(&solid), k(&solid).transpose());
        assert_eq!(m(&solid), m(&solid).transpose());
    });
}

#[test]
fn exactly_six_motions_have_no_energy() {
    each(|corners, build| {
        let k = k(&build(&Rotation3::identity()));
        let forces = &k * rigid(corners);
        assert!(forces.amax() < 1e-13 * k.amax(), "rigid motions: {:e}", forces.amax() / k.amax());
        let scale = DVector::from_fn(k.nrows(), |i, _| 1.0 / k[(i, i)].sqrt());
        let scaled = DMatrix::from_fn(k.nrows(), k.ncols(), |i, j| scale[i] * k[(i, j)] * scale[j]);
        let energies = scaled.symmetric_eigenvalues();
        assert_eq!(energies.iter().filter(|e| e.abs() < 1e-13).count(), 6, "{energies}");
        assert_eq!(energies.iter().filter(|e| **e > 1e-4).count(), k.nrows() - 6, "{energies}");
    });
}

#[test]
fn a_turned_element_has_the_turned_matrices() {
    let rotation = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    each(|corners, build| {
        let (straight, turned) = (build(&Rotation3::identity()), build(&rotation));
        let n = corners.len();
        let mut t = DMatrix::zeros(3 * n, 3 * n);
        for node in 0..n {
            t.view_mut((3 * node, 3 * node), (3, 3)).copy_from(rotation.matrix());
        }
        for (own, other) in [(k(&straight), k(&turned)), (m(&straight), m(&turned))] {
            let error = (other - &t * &own * t.transpose()).amax() / own.amax();
            assert!(error < 1e-14 * own.nrows() as f64, "{error:e}");
        }
    });
}

#[test]
fn a_larger_element_is_stiffer_by_its_length_and_heavier_by_its_volume() {
    let (size, far) = (40.0, Vector3::new(1000.0, -500.0, 300.0));
    for shape in SHAPES {
        let material = turned_material(&Rotation3::identity(), true);
        let small = solid(&points(shape), &material);
        let moved: Vec<_> = points(shape).iter().map(|point| point * size + far).collect();
        let large = solid(&moved, &material);
        // Places 1000 m away have 13 digits of an element's metre.
        assert!((k(&large) - k(&small) * size).amax() < 1e-12 * size * k(&small).amax());
        assert!((m(&large) - m(&small) * size.powi(3)).amax() < 1e-12 * size.powi(3) * m(&small).amax());
        assert!((large.volume_m3() / small.volume_m3() / size.powi(3) - 1.0).abs() < 1e-12);
    }
}

/// Orders in which a card may name the corners: another corner first, and the other sense.
#[test]
fn it_does_not_matter_where_the_numbering_starts_nor_its_sense() {
    let hexa: [[usize; 8]; 4] = [
        [1, 2, 3, 0, 5, 6, 7, 4],
        [0, 4, 5, 1, 3, 7, 6, 2],
        [0, 3, 2, 1, 4, 7, 6, 5],
        [4, 5, 6, 7, 0, 1, 2, 3],
    ];
    let wedge: [[usize; 6]; 3] = [[1, 2, 0, 4, 5, 3], [3, 5, 4, 0, 2, 1], [0, 2, 1, 3, 5, 4]];
    let tetra: [[usize; 4]; 2] = [[1, 2, 0, 3], [0, 2, 1, 3]];
    let orders = hexa.iter().map(|order| (&PATCH[..], &order[..]));
    let orders = orders.chain(wedge.iter().map(|order| (&TWISTED_WEDGE[..], &order[..])));
    let orders = orders.chain(tetra.iter().map(|order| (&TETRA[..], &order[..])));
    for (shape, order) in orders {
        let material = turned_material(&Rotation3::identity(), true);
        let own = solid(&points(shape), &material);
        let renumbered: Vec<_> = order.iter().map(|at| Point3::from(shape[*at])).collect();
        let other = solid(&renumbered, &material);
        let place = |i: usize| 3 * order[i / 3] + i % 3;
        for (a, b) in [(k(&own), k(&other)), (m(&own), m(&other))] {
            let expected = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(place(i), place(j))]);
            let error = (b - expected).amax() / a.amax();
            assert!(error < 1e-13, "{order:?}: {error:e}");
        }
    }
}

/// Volume, first and second moments, from tetrahedra.
fn moments(tetrahedra: &[[Point3<f64>; 4]]) -> (f64, Vector3<f64>, Matrix3<f64>) {
    let mut total = (0.0, Vector3::zeros(), Matrix3::zeros());
    for corners in tetrahedra {
        let edges: Vec<_> = corners[1..].iter().map(|corner| corner - corners[0]).collect();
        let volume = edges[0].cross(&edges[1]).dot(&edges[2]).abs() / 6.0;
        let sum: Vector3<f64> = corners.iter().map(|corner| corner.coords).sum();
        let squares: Matrix3<f64> = corners.iter().map(|c| c.coords * c.coords.transpose()).sum();
        total.0 += volume;
        total.1 += sum * (volume / 4.0);
        total.2 += (squares + sum * sum.transpose()) * (volume / 20.0);
    }
    total
}

/// Tetrahedra that fill a wedge or hexahedron with plane faces.
fn tetrahedra(corners: &[Point3<f64>]) -> Vec<[Point3<f64>; 4]> {
    let wedge = [[0, 1, 2, 5], [0, 1, 5, 4], [0, 4, 5, 3]];
    let of = |order: [usize; 6]| wedge.map(|t| t.map(|at| corners[order[at]]));
    match corners.len() {
        4 => vec![[corners[0], corners[1], corners[2], corners[3]]],
        6 => of([0, 1, 2, 3, 4, 5]).to_vec(),
        _ => [of([0, 1, 2, 4, 5, 6]), of([0, 2, 3, 4, 6, 7])].concat(),
    }
}

#[test]
fn mass_centre_and_moments_of_inertia_are_those_of_the_shape() {
    for shape in [&BOX[..], &TRUNK, &WEDGE, &TAPERED_WEDGE, &TETRA] {
        let corners = points(shape);
        let element = solid(&corners, &turned_material(&Rotation3::identity(), false));
        let (volume, first, second) = moments(&tetrahedra(&corners));
        let total = rigid(&corners).transpose() * m(&element) * rigid(&corners);
        assert!((element.volume_m3() / volume - 1.0).abs() < 1e-14 * 10.0);
        for axis in 0..3 {
            assert!((total[(axis, axis)] / (RHO * volume) - 1.0).abs() < 1e-13);
        }
        let coupling = total.fixed_view::<3, 3>(0, 3).into_owned() / RHO;
        assert!((coupling + first.cross_matrix()).norm() < 1e-13 * first.norm());
        let inertia = Matrix3::identity() * second.trace() - second;
        let own = total.fixed_view::<3, 3>(3, 3) / RHO;
        assert!((own - inertia).norm() < 1e-13 * inertia.norm(), "{own} {inertia}");

        let lumped = m(&element.with_lumped_mass());
        assert_eq!(lumped, DMatrix::from_diagonal(&lumped.diagonal()));
        let total = rigid(&corners).transpose() * lumped * rigid(&corners);
        assert!((total[(0, 0)] / (RHO * volume) - 1.0).abs() < 1e-13);
        let coupling = total.fixed_view::<3, 3>(0, 3).into_owned() / RHO;
        assert!((coupling + first.cross_matrix()).norm() < 1e-13 * first.norm(), "lumped: the same centre");
    }
}

#[test]
fn a_box_has_the_inertia_of_a_box() {
    let centred: Vec<_> = points(&BOX).iter().map(|point| point - Vector3::new(1.5, 1.0, 0.25)).collect();
    let total = rigid(&centred).transpose()
        * m(&solid(&centred, &turned_material(&Rotation3::identity(), false)))
        * rigid(&centred);
    let mass = RHO * 3.0;
    for (axis, (b, c)) in [(2.0_f64, 0.5_f64), (3.0, 0.5), (3.0, 2.0)].into_iter().enumerate() {
        let expected = mass / 12.0 * (b * b + c * c);
        assert!((total[(3 + axis, 3 + axis)] / expected - 1.0).abs() < 1e-13);
    }
}
