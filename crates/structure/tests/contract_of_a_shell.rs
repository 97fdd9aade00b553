//! The contract of an element, run for shells; patch tests of a section with membrane, bending and coupling.

use crate::contract::{Specimen, contract};
use nalgebra::{DVector, Matrix3, Point3, Rotation3, Vector3};
use nastran::{Mat8, Span};
use std::sync::Arc;
use structure::{Element, PlacedPly, PlaneMaterial, ShearModel, Shell, ShellSection};

/// An unsymmetric laminate of two plies with non-structural mass.
fn section() -> Arc<ShellSection> {
    let card = Mat8 {
        id: 1,
        e1: 138e9,
        e2: 9e9,
        nu12: 0.3,
        g12: 5e9,
        g1z: 5e9,
        g2z: 3e9,
        rho: 1600.0,
        expansion: nastran::Expansion::default(),
        span: Span::generated("test"),
    };
    let material = PlaneMaterial::ply(&card).expect("a sound material");
    let ply = |angle_deg: f64, low: f64, high: f64| PlacedPly {
        material,
        angle_rad: angle_deg.to_radians(),
        z_low_m: low,
        z_high_m: high,
    };
    Arc::new(ShellSection::laminate(
        &[ply(0.0, -0.01, 0.0), ply(35.0, 0.0, 0.02)],
        0.7,
        ShearModel::Equilibrium,
    ))
}

const PER_AREA: f64 = 1600.0 * 0.03 + 0.7;

fn shell(rotation: &Rotation3<f64>, points: &[Point3<f64>], offset_m: f64) -> Shell {
    let turned: Vec<Point3<f64>> = points.iter().map(|point| rotation * point).collect();
    let nodes = (0..points.len()).collect();
    Shell::new(3, nodes, &turned, offset_m, section(), 0.4, &Span::generated("test"))
        .expect("a possible shell")
}

fn keeps_the_contract(points: &[Point3<f64>], offset_m: f64, area_m2: f64) {
    contract(|rotation| Specimen {
        element: shell(rotation, points, offset_m),
        points: points.to_vec(),
        mass_kg: PER_AREA * area_m2,
        inertia: None,
    });
}

#[test]
fn a_quadrilateral_keeps_the_contract() {
    let points = [[0.1, 0.2, 0.0], [1.3, 0.1, 0.0], [1.1, 0.9, 0.0], [0.0, 0.7, 0.0]].map(Point3::from);
    let area = 0.5 * ((1.1 - 0.1) * (0.7 - 0.1) - (0.0 - 1.3) * (0.9 - 0.2));
    keeps_the_contract(&points, 0.0, area);
    keeps_the_contract(&points, 0.05, area);
}

#[test]
fn a_warped_quadrilateral_keeps_the_contract() {
    let points = [[0.1, 0.2, 0.1], [1.3, 0.1, -0.1], [1.1, 0.9, 0.2], [0.0, 0.7, -0.1]].map(Point3::from);
    let (one, other) = (points[2] - points[0], points[3] - points[1]);
    keeps_the_contract(&points, 0.0, 0.5 * one.cross(&other).norm());
}

#[test]
fn a_triangle_keeps_the_contract() {
    let points = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.1], [0.4, 0.9, 0.5]].map(Point3::from);
    let area = 0.5 * (points[1] - points[0]).cross(&(points[2] - points[0])).norm();
    keeps_the_contract(&points, -0.03, area);
}

#[test]
fn a_triangle_with_drilling_keeps_the_contract() {
    let points = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.1], [0.4, 0.9, 0.5]].map(Point3::from);
    let area = 0.5 * (points[1] - points[0]).cross(&(points[2] - points[0])).norm();
    contract(|rotation| Specimen {
        element: shell(rotation, &points, -0.03).with_drilling(),
        points: points.to_vec(),
        mass_kg: PER_AREA * area,
        inertia: None,
    });
}

/// As Nastran's, with a grid's normal 10 degrees off at each corner but one: no force for rigid motions, whichever way it is turned; and no
/// moment about the normal of a grid but the tie's.
#[test]
fn shells_with_normals_of_their_grids_keep_the_contract() {
    let triangle = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.1], [0.4, 0.9, 0.5]].map(Point3::from);
    let warped = [[0.1, 0.2, 0.1], [1.3, 0.1, -0.1], [1.1, 0.9, 0.2], [0.0, 0.7, -0.1]].map(Point3::from);
    for points in [&triangle[..], &warped] {
        let flat = shell(&Rotation3::identity(), points, 0.02);
        let normal = flat.axes().row(2).transpose();
        let leaning = |at: usize| {
            let axis = nalgebra::Unit::new_normalize(points[(at + 1) % points.len()] - points[at]);
            Rotation3::from_axis_angle(&axis, 10_f64.to_radians()) * normal
        };
        let normals: Vec<_> = (0..points.len()).map(|at| (at != 1).then(|| leaning(at))).collect();
        let made = |rotation: &Rotation3<f64>, tie: f64| {
            let normals = normals.iter().map(|normal| normal.map(|normal| rotation * normal));
            shell(rotation, points, 0.02)
                .as_nastran()
                .with_drilling_tie(tie)
                .with_grid_normals(normals.collect::<Vec<_>>())
        };
        let free = made(&Rotation3::identity(), 0.0).stiffness().expect("a shell").into_owned();
        let mut turned = DVector::zeros(free.nrows());
        turned.fixed_rows_mut::<3>(3).copy_from(&normals[0].expect("the first corner has one"));
        // The offset's arm moves the membrane where the grid turns about another axis than the element's normal: without it.
        let level = shell(&Rotation3::identity(), points, 0.0).as_nastran().with_drilling_tie(0.0);
        let k = level.clone().with_grid_normals(normals.clone()).stiffness().expect("a shell").into_owned();
        assert!(
            (&k * &turned).norm() < 1e-9 * k.norm(),
            "turning about the grid's normal: {}",
            (&k * &turned).norm()
        );
        let own = level.stiffness().expect("a shell").into_owned();
        assert!((own * &turned).norm() > 1e-6 * k.norm(), "the element's own normal is another");
        contract(|rotation| Specimen {
            element: made(rotation, 1e-4),
            points: points.to_vec(),
            mass_kg: PER_AREA * flat.area_m2(),
            inertia: None,
        });
    }
}

/// Of an unsymmetric laminate off its grids: the masses of a displacement's row stand at its grid, and nothing else.
#[test]
fn lumped_masses_are_the_sums_of_the_rows() {
    let triangle = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.1], [0.4, 0.9, 0.5]].map(Point3::from);
    let warped = [[0.1, 0.2, 0.1], [1.3, 0.1, -0.1], [1.1, 0.9, 0.2], [0.0, 0.7, -0.1]].map(Point3::from);
    for points in [&triangle[..], &warped] {
        let turned = Rotation3::from_euler_angles(0.3, -0.7, 1.1);
        let shell = shell(&turned, points, 0.05);
        let (whole, lumped) = (shell.mass().expect("a shell"), shell.lumped_mass().expect("a shell"));
        for (i, j) in (0..lumped.nrows()).flat_map(|i| (0..lumped.ncols()).map(move |j| (i, j))) {
            let sum: f64 = (i % 6..whole.ncols()).step_by(6).map(|j| whole[(i, j)]).sum();
            let expected = if i == j && i % 6 < 3 { sum } else { 0.0 };
            assert!((lumped[(i, j)] - expected).abs() < 1e-13 * whole.amax(), "{i} {j} of {}", points.len());
        }
    }
}

#[test]
fn a_rectangle_has_the_inertia_of_a_plate() {
    let (a, b) = (1.2, 0.5);
    let points = [[0.0, 0.0, 0.0], [a, 0.0, 0.0], [a, b, 0.0], [0.0, b, 0.0]].map(Point3::from);
    let m = PER_AREA * a * b;
    // Plies from -.01 to .02: second moment of the density about the reference surface, first moment likewise.
    let (second, first) = (1600.0 * a * b * (8e-6 + 1e-6) / 3.0, 1600.0 * a * b * (4e-4 - 1e-4) / 2.0);
    let moment = Vector3::new(0.5 * a * m, 0.5 * b * m, first);
    let products = [-m * a * b / 4.0, -first * a / 2.0, -first * b / 2.0];
    let inertia = Matrix3::new(
        m * b * b / 3.0 + second,
        products[0],
        products[1],
        products[0],
        m * a * a / 3.0 + second,
        products[2],
        products[1],
        products[2],
        m * (a * a + b * b) / 3.0,
    );
    contract(|rotation| Specimen {
        element: shell(rotation, &points, 0.0),
        points: points.to_vec(),
        mass_kg: m,
        inertia: Some((inertia, moment)),
    });
}
