//! Shear panels beside Garvey's closed forms, and tubes.

use crate::common::{at, close, displaced, system};
use crate::contract::rigid;
use nalgebra::{DMatrix, Point3};
use nastran::parse_deck;
use std::fmt::Write;
use structure::{MassProperties, Model};

const G: f64 = 27e9;
const NU: f64 = 0.3;
const T: f64 = 0.002;
const MATERIAL: &str = "MAT1,1,7.02+10,2.7+10,.3,2700.\n";

/// Stiffness of a panel over three displacements a corner; F1 and F2 as given.
fn panel(corners: &[[f64; 3]; 4], factors: &str) -> DMatrix<f64> {
    let mut grids = String::new();
    for (id, [x, y, z]) in (1..).zip(corners) {
        writeln!(grids, "GRID,{id},,{x:.12},{y:.12},{z:.12}").expect("a string");
    }
    let deck = format!("{grids}CSHEAR,1,1,1,2,3,4\nPSHEAR,1,1,{T},.5,{factors}\n{MATERIAL}");
    let bulk = parse_deck("test.bdf", &deck).expect("a deck");
    let model = Model::from_bulk(&bulk).expect("a model");
    let element = model.elements().next().expect("one element");
    element.stiffness().expect("has stiffness").into_owned()
}

/// A panel has one state of stress: the trace of its stiffness is the square of the corner forces of a unit shear flow over twice its energy.
#[track_caller]
fn has(stiffness: &DMatrix<f64>, expected: f64, relative: f64, what: &str) {
    close(stiffness.trace(), expected, relative, what);
    let others = stiffness.clone().symmetric_eigenvalues();
    let largest = others.max();
    assert_eq!(others.iter().filter(|value| value.abs() > 1e-9 * largest).count(), 1, "{what}: one state");
}

#[test]
fn a_rectangle_is_sheared_as_a_plate_between_stiff_edges() {
    let (a, b) = (0.8, 0.5);
    let deck = format!(
        "GRID,1,,0.,0.,0.\nGRID,2,,{a},0.,0.\nGRID,3,,{a},{b},0.\nGRID,4,,0.,{b},0.\nCSHEAR,1,1,1,2,3,4\n\
         PSHEAR,1,1,{T}\n{MATERIAL}CROD,2,2,2,3\nPROD,2,1,1.\nSPC1,1,123,1,4\nSPC1,1,13,2,3\n"
    );
    let system = system(&deck);
    let moved = displaced(&system, &[(2, 2, 300.0), (3, 2, 300.0)]);
    close(at(&system, &moved, 3, 2), 600.0 * a / (G * T * b), 1e-9, "deflection of the loaded edge");
    let mass = MassProperties::of_model(
        &Model::from_bulk(&parse_deck("t.bdf", &deck).expect("a deck")).expect("a model"),
    );
    close(mass.mass_kg, 2700.0 * (a * b * T + b), 1e-12, "mass of panel and rod");
}

/// Energy A (1 + 2 tan^2 / (1 + nu)) / (2 G t) of a unit shear flow, the angle that of the skew (Garvey 1951).
#[test]
fn a_parallelogram_has_garveys_energy() {
    for skew in [0.0_f64, 0.2, 0.7] {
        let (a, b) = (0.8, 0.5);
        let (lean, up) = (b * skew.sin(), b * skew.cos());
        let corners = [[0.0, 0.0, 0.1], [a, 0.0, 0.1], [a + lean, up, 0.1], [lean, up, 0.1]];
        let energy = a * up * (1.0 + 2.0 * skew.tan().powi(2) / (1.0 + NU)) / (G * T);
        // Each corner has half of its two sides' forces, which are their lengths: the forces' squares are those of the diagonals.
        let long = (a + lean).powi(2) + up * up;
        let short = (a - lean).powi(2) + up * up;
        has(&panel(&corners, ""), 0.5 * (long + short) / energy, 1e-9, &format!("skew {skew}"));
    }
}

/// Two parallel sides at x1 and x2, the others on the lines y = m x and -m x: shear 1/x^2 and stress 2 y/x^3 across leave the sides without direct
/// stress and are in equilibrium.
#[test]
fn a_trapezium_has_garveys_energy() {
    // The energy is integrated by points: the more a panel tapers, the more remains.
    for (near, far, m, relative) in [(1.0, 1.05, 0.5_f64, 1e-9), (1.0, 2.0, 0.4, 1e-7), (0.5, 3.0, 0.2, 1e-4)]
    {
        let corners =
            [[near, -m * near, 0.0], [far, -m * far, 0.0], [far, m * far, 0.0], [near, m * near, 0.0]];
        let reach = 0.5 * (1.0 / (near * near) - 1.0 / (far * far));
        let energy = (2.0 * m + 8.0 * m.powi(3) / 3.0 / (2.0 * (1.0 + NU))) * reach / (G * T);
        // Sides' forces: 2 m / x on the parallel ones, and on the others what keeps the balance.
        let (at_near, at_far) = (2.0 * m / near, 2.0 * m / far);
        let slanted = (at_near - at_far) / (2.0 * m.atan().sin());
        let (cos, sin) = (m.atan().cos(), m.atan().sin());
        let corner = |parallel: f64, sign: f64| {
            (0.5 * slanted * cos).powi(2) + (0.5 * parallel - sign * 0.5 * slanted * sin).powi(2)
        };
        let squares = 2.0 * (corner(at_near, 1.0) + corner(at_far, -1.0));
        has(&panel(&corners, ""), squares / energy, relative, &format!("from {near} to {far}, slope {m}"));
    }
}

#[test]
fn a_rigid_motion_meets_no_force_in_a_warped_panel_of_any_form() {
    let corners = [[0.0, 0.0, 0.1], [1.1, 0.1, -0.1], [0.9, 0.8, 0.2], [0.1, 0.6, -0.05]];
    let k = panel(&corners, ".5,1.");
    let all = rigid(&corners.map(Point3::from));
    let rows: Vec<usize> = (0..24).filter(|row| row % 6 < 3).collect();
    let forces = &k * all.select_rows(&rows);
    assert!(forces.amax() < 1e-10 * k.amax(), "{:e}", forces.amax() / k.amax());
}

/// F1 of one: half of the panel is a rod on either side, both together as stiff as the sheet.
#[test]
fn a_panel_whose_factors_are_one_carries_tension_as_a_sheet() {
    let (a, b) = (0.8, 0.5);
    for (factor, area) in [(1.0, T * b), (2.0, 2.0 * T * T)] {
        let deck = format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,{a},0.,0.\nGRID,3,,{a},{b},0.\nGRID,4,,0.,{b},0.\nCSHEAR,1,1,1,2,3,4\n\
             PSHEAR,1,1,{T},,{factor:?},0.\n{MATERIAL}SPC1,1,123,1,4\nSPC1,1,23,2,3\n"
        );
        let system = system(&deck);
        let moved = displaced(&system, &[(2, 1, 300.0), (3, 1, 300.0)]);
        close(at(&system, &moved, 2, 1), 600.0 * a / (7.02e10 * area), 1e-9, "stretch");
    }
}

#[test]
fn tubes_stretch_and_twist_by_their_rings() {
    let tube = |section: &str| {
        system(&format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,1.5,0.,0.\nCTUBE,1,1,1,2\nPTUBE,1,1,{section}\n{MATERIAL}SPC1,1,123456,1\nSPC1,1,2356,2\n"
        ))
    };
    let pi = std::f64::consts::PI;
    for (section, area, j) in [
        (".05,.004", pi / 4.0 * (2.5e-3 - 0.042_f64.powi(2)), pi / 32.0 * (6.25e-6 - 0.042_f64.powi(4))),
        (".05", pi / 4.0 * 2.5e-3, pi / 32.0 * 6.25e-6),
        (".05,,,.03", pi / 8.0 * (2.5e-3 + 9e-4), pi / 64.0 * (6.25e-6 + 8.1e-7)),
    ] {
        let system = tube(section);
        let moved = displaced(&system, &[(2, 1, 1000.0), (2, 4, 10.0)]);
        close(at(&system, &moved, 2, 1), 1000.0 * 1.5 / (7.02e10 * area), 1e-9, "stretch");
        close(at(&system, &moved, 2, 4), 10.0 * 1.5 / (G * j), 1e-9, "twist");
    }
    let error = parse_deck("t.bdf", "PTUBE,1,1,.05,.03\n").expect_err("too thick").to_string();
    assert!(error.contains("`.03` in field T of PTUBE is not a thickness of at most half"), "{error}");
}

#[test]
fn a_panel_that_goes_not_around_is_refused_by_a_sentence() {
    let deck = format!(
        "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\nCSHEAR,1,1,1,3,2,4\nPSHEAR,1,1,{T}\n{MATERIAL}"
    );
    let error =
        Model::from_bulk(&parse_deck("t.bdf", &deck).expect("a deck")).expect_err("crossed").to_string();
    assert!(error.contains("CSHEAR 1 has no area, or a corner of 180 degrees or more"), "{error}");
}
