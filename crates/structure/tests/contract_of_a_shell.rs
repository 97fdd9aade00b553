//! The contract of an element, run for shells; patch tests of a section with membrane, bending and coupling.

use crate::contract::{Specimen, contract};
use nalgebra::{Matrix3, Point3, Rotation3, Vector3};
use nastran::{Mat8, Span};
use std::sync::Arc;
use structure::{PlacedPly, PlaneMaterial, ShearModel, Shell, ShellSection};

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
