//! What every element must fulfil, written once: symmetry, exactly six motions without energy, exact mass and inertia under
//! rigid motions, indifference to the frame.

#![expect(unreachable_pub, reason = "helpers of the tests in this folder")]
#![allow(dead_code, reason = "not every test file uses every helper")]

use faer::{Mat, Side};
use nalgebra::{DMatrix, DVector, Matrix3, Point3, Rotation3, Vector3};
use structure::Element;

/// An element in a given attitude, with what it must weigh.
pub struct Specimen<E> {
    /// The element.
    pub element: E,
    /// Its nodes in the straight attitude.
    pub points: Vec<Point3<f64>>,
    /// What it must weigh.
    pub mass_kg: f64,
    /// Moment of inertia (about the origin) and first moment of the mass, if a closed form is known.
    pub inertia: Option<(Matrix3<f64>, Vector3<f64>)>,
}

/// The six rigid motions about the origin over six motions a node.
pub fn rigid(points: &[Point3<f64>]) -> DMatrix<f64> {
    let mut motions = DMatrix::zeros(6 * points.len(), 6);
    for (node, point) in points.iter().enumerate() {
        for axis in 0..3 {
            let mut unit = Vector3::zeros();
            unit[axis] = 1.0;
            motions[(6 * node + axis, axis)] = 1.0;
            motions[(6 * node + 3 + axis, 3 + axis)] = 1.0;
            motions.view_mut((6 * node, 3 + axis), (3, 1)).copy_from(&unit.cross(&point.coords));
        }
    }
    motions
}

/// The contract. `build` makes the element in the attitude it is given.
#[track_caller]
pub fn contract<E: Element>(build: impl Fn(&Rotation3<f64>) -> Specimen<E>) {
    let straight = build(&Rotation3::identity());
    assert!(straight.element.is_elastic(), "an element with a stiffness says so");
    let k = straight.element.stiffness().expect("has stiffness").into_owned();
    let m = straight.element.mass().expect("has mass").into_owned();
    assert_eq!(k, k.transpose(), "the stiffness is symmetric");
    assert_eq!(m, m.transpose(), "the mass is symmetric");

    // Elements of displacements alone have no rows for rotations.
    let per_node = k.nrows() / straight.points.len();
    let all = rigid(&straight.points);
    let kept = (0..all.nrows()).filter(|row| row % 6 < per_node);
    let motions = all.select_rows(kept.collect::<Vec<_>>().iter());
    let forces = &k * &motions;
    assert!(forces.amax() < 1e-12 * k.amax(), "rigid motions meet no force: {:e}", forces.amax() / k.amax());
    let scale = DVector::from_fn(k.nrows(), |i, _| 1.0 / k[(i, i)].sqrt());
    let scaled = Mat::from_fn(k.nrows(), k.ncols(), |i, j| scale[i] * k[(i, j)] * scale[j]);
    let energies = scaled.self_adjoint_eigenvalues(Side::Lower).expect("finite entries");
    assert_eq!(
        energies.iter().filter(|e| e.abs() < 1e-12).count(),
        6,
        "six motions without energy: {energies:?}"
    );
    assert!(energies.iter().all(|e| *e > -1e-12), "no motion with negative energy: {energies:?}");

    let total = motions.transpose() * &m * &motions;
    for axis in 0..3 {
        let relative = total[(axis, axis)] / straight.mass_kg - 1.0;
        assert!(relative.abs() < 1e-13, "the mass along axis {axis} is exact: {relative:e}");
    }
    if let Some((inertia, first)) = straight.inertia {
        let about_origin = total.fixed_view::<3, 3>(3, 3);
        assert!((about_origin - inertia).norm() < 1e-12 * inertia.norm(), "{about_origin} {inertia}");
        let coupling = total.fixed_view::<3, 3>(0, 3).into_owned();
        assert!((coupling + first.cross_matrix()).norm() < 1e-12 * first.norm(), "{coupling}");
    }

    let rotation = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let turned = build(&rotation);
    let blocks = k.nrows() / 3;
    let mut t = DMatrix::zeros(k.nrows(), k.nrows());
    for block in 0..blocks {
        t.view_mut((3 * block, 3 * block), (3, 3)).copy_from(rotation.matrix());
    }
    for (own, other) in [(&k, turned.element.stiffness()), (&m, turned.element.mass())] {
        let expected = &t * own * t.transpose();
        let error = (other.expect("as before").into_owned() - &expected).amax() / own.amax();
        assert!(error < 1e-13, "a turned element is the turned matrix: {error:e}");
    }
}
