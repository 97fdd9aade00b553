//! Solids and materials that cannot be: each gives one sentence that names the card, and nothing panics.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use nalgebra::{Matrix3, Point3, Rotation3};
use nastran::{Mat1, Mat9, Span};
use std::sync::Arc;
use structure::{Solid, SolidMaterial};

fn span() -> Span {
    Span::generated("deck.bdf")
}

fn mat1(e: f64, nu: f64, rho: f64) -> Mat1 {
    Mat1 { id: 5, e, g: 0.0, nu, rho, expansion: nastran::Expansion::default(), span: span() }
}

fn cube() -> Vec<[f64; 3]> {
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
        .map(|corner: [i32; 3]| corner.map(f64::from))
        .to_vec()
}

fn complaint(nodes: &[usize], points: &[[f64; 3]]) -> String {
    let material = Arc::new(SolidMaterial::from_mat1(&mat1(70e9, 0.3, 1.0)).unwrap());
    let points: Vec<_> = points.iter().map(|point| Point3::from(*point)).collect();
    let error = Solid::new(12, nodes.to_vec(), &points, &material, &span()).unwrap_err();
    assert!(error.span.is_some() && error.help.is_some(), "{error}");
    error.message
}

fn complaint_at(points: &[[f64; 3]]) -> String {
    complaint(&(0..points.len()).collect::<Vec<_>>(), points)
}

#[test]
fn solids_without_a_proper_volume_are_refused_by_name() {
    let mut swapped = cube();
    swapped.swap(1, 2);
    assert!(complaint_at(&swapped).starts_with("CHEXA 12: it is "), "{}", complaint_at(&swapped));
    // The opposite face runs the other way round.
    let mut crossed = cube();
    crossed.swap(5, 7);
    assert!(complaint_at(&crossed).starts_with("CHEXA 12: it is "));
    let flat: Vec<_> = cube().iter().map(|[x, y, z]| [x + 0.3 * z, y + 0.2 * z, 0.0]).collect();
    assert_eq!(complaint_at(&flat), "CHEXA 12: it is flat, at least in a part of it");
    let mut pushed_through = cube();
    pushed_through[6] = [0.2, 0.2, 0.2];
    assert!(complaint_at(&pushed_through).contains("inside out"));
    let mut collapsed = cube();
    collapsed[1] = collapsed[0];
    assert_eq!(complaint_at(&collapsed), "CHEXA 12: its corners 1 and 2 are at the same place");
    assert!(complaint_at(&[[0.0; 3]; 6]).starts_with("CPENTA 12: "));
    let plane = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    assert_eq!(complaint_at(&plane), "CTETRA 12: it is flat, at least in a part of it");
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let mut points = cube();
        points[3][1] = bad;
        assert!(complaint_at(&points).starts_with("CHEXA 12: "));
    }
}

#[test]
fn repeated_grids_and_wrong_numbers_of_grids_are_refused() {
    let message = complaint(&[0, 1, 2, 3, 4, 5, 1, 7], &cube());
    assert_eq!(message, "CHEXA 12: its corners 2 and 7 are the same grid");
    assert_eq!(complaint_at(&cube()[..5]), "solid 12 has 5 corners and 5 points");
    assert_eq!(complaint(&[1, 2, 3, 4], &cube()), "solid 12 has 4 corners and 8 points");
}

#[test]
fn materials_that_give_energy_are_refused() {
    for (e, nu) in
        [(0.0, 0.3), (-1.0, 0.3), (1.0, 0.5), (1.0, 0.6), (1.0, -1.0), (1.0, -1.5), (f64::NAN, 0.3)]
    {
        let error = SolidMaterial::from_mat1(&mat1(e, nu, 1.0)).unwrap_err();
        assert!(error.message.contains("MAT1 5") && error.span == Some(span()), "{error}");
    }
    assert!(SolidMaterial::from_mat1(&mat1(1.0, 0.4999, 0.0)).is_ok());
    assert!(SolidMaterial::from_mat1(&mat1(1.0, -0.9, 0.0)).is_ok());
    assert!(SolidMaterial::from_mat1(&mat1(1.0, 0.3, -1.0)).unwrap_err().message.contains("density -1"));
    let mut g = [0.0; 21];
    for at in [0, 6, 11, 15, 18, 20] {
        g[at] = 1.0;
    }
    let honest = Mat9 { id: 8, g, rho: 0.0, expansion: nastran::Expansion::default(), span: span() };
    assert!(SolidMaterial::from_mat9(&honest, &Matrix3::identity()).is_ok());
    for (at, value) in [(0, 0.0), (1, 1.0), (20, -1.0), (7, 2.0), (3, f64::NAN)] {
        let mut card = honest.clone();
        card.g[at] = value;
        let error = SolidMaterial::from_mat9(&card, &Matrix3::identity()).unwrap_err();
        assert!(error.message.contains("MAT9 8"), "{error}");
    }
}

#[test]
fn an_isotropic_mat9_is_the_mat1_in_any_axes() {
    let (e, nu) = (3.0, 0.2);
    let isotropic = SolidMaterial::from_mat1(&mat1(e, nu, 1.0)).unwrap();
    let mut card =
        Mat9 { id: 8, g: [0.0; 21], rho: 1.0, expansion: nastran::Expansion::default(), span: span() };
    let shear = e / (2.0 * (1.0 + nu));
    let lame = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    for at in [0, 6, 11] {
        card.g[at] = lame + 2.0 * shear;
    }
    for at in [1, 2, 7] {
        card.g[at] = lame;
    }
    for at in [15, 18, 20] {
        card.g[at] = shear;
    }
    let axes = Rotation3::from_euler_angles(1.0, 0.4, -0.7);
    let turned = SolidMaterial::from_mat9(&card, axes.matrix()).unwrap();
    assert!((turned.stiffness - isotropic.stiffness).amax() < 1e-14 * e * 2.0);
}

#[test]
fn the_fibres_of_a_turned_material_lie_along_the_axes_given() {
    let mut card =
        Mat9 { id: 8, g: [0.0; 21], rho: 1.0, expansion: nastran::Expansion::default(), span: span() };
    for (at, value) in [(0, 10.0), (6, 2.0), (11, 3.0), (15, 0.4), (18, 0.5), (20, 0.6)] {
        card.g[at] = value;
    }
    // Material x along basic z, y along x, z along y.
    let axes = Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0);
    let c = SolidMaterial::from_mat9(&card, &axes).unwrap().stiffness;
    assert_eq!(c.diagonal().as_slice(), &[2.0, 3.0, 10.0, 0.5, 0.6, 0.4]);
}
