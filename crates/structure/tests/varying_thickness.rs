//! Shells whose corners have thicknesses of their own (T1 to T4): energies of constant strains, mass.

use crate::common::close;
use nalgebra::DVector;
use nastran::parse_deck;
use structure::{MassProperties, Model};

const E: f64 = 70e9;
const NU: f64 = 0.3;
/// Thickness at x = 0 and at x = A of a rectangle of A by B.
const T: [f64; 2] = [0.004, 0.01];
const A: f64 = 1.2;
const B: f64 = 0.5;

fn model(element: &str) -> Model {
    let deck = format!(
        "GRID,1,,0.,0.,0.\nGRID,2,,{A},0.,0.\nGRID,3,,{A},{B},0.\nGRID,4,,0.,{B},0.\n{element}\n\
         PSHELL,1,1,.008,1,,1,,.7\nMAT1,1,{E:.1E},,{NU},2700.\n"
    );
    Model::from_bulk(&parse_deck("test.bdf", &deck).expect("a deck")).expect("a model")
}

/// Energy of an element whose grids move as the field says.
fn energy(model: &Model, field: impl Fn(f64, f64) -> [f64; 6]) -> f64 {
    let element = model.elements().next().expect("one element");
    let moved = element.nodes().iter().flat_map(|node| {
        let point = model.nodes[*node].point;
        field(point.x, point.y)
    });
    let moved = DVector::from_iterator(6 * element.nodes().len(), moved);
    0.5 * moved.dot(&(&*element.stiffness().expect("has stiffness") * &moved))
}

const QUAD: &str = "CQUAD4,1,1,1,2,3,4\n,,,.004,.01,.01,.004";

#[test]
fn tension_takes_the_harmonic_mean_of_thickness_and_bending_that_of_its_cube() {
    let [thin, thick] = T;
    let area = A * B;
    for element in [QUAD, "CQUAD4,1,1,1,2,3,4\n,,1,.5,1.25,1.25,.5"] {
        let model = model(element);
        let stretch = energy(&model, |x, y| [1e-3 * x, -1e-3 * NU * y, 0.0, 0.0, 0.0, 0.0]);
        // The strip's own: the same force in all of it, so that strains are larger where it is thin. The element's modes find nearly that.
        let strip = (thick - thin) / (thick / thin).ln();
        close(stretch, 0.5 * E * 1e-6 * area * strip, 0.015, "energy of tension");
        // Curvature k along x, -nu k along y: no moment across.
        let bend =
            energy(&model, |x, y| [0.0, 0.0, -0.5e-3 * (x * x - NU * y * y), 1e-3 * NU * y, 1e-3 * x, 0.0]);
        let cube = (thick.powi(4) - thin.powi(4)) / (4.0 * (thick - thin));
        close(bend, 0.5 * E * 1e-6 * area * cube / 12.0, 1e-10, "energy of bending");
        let mass = MassProperties::of_model(&model);
        close(
            mass.mass_kg,
            (2700.0 * 0.5 * (thin + thick) + 0.7) * area,
            1e-12,
            "mass, its non-structural part once",
        );
        let centre = 2700.0 * (thin * 0.5 + (thick - thin) / 3.0) * A + 0.7 * 0.5 * A;
        close(mass.centre.x, centre * area / mass.mass_kg, 1e-12, "its centre");
    }
}

#[test]
fn a_triangle_takes_the_mean_of_its_three_and_a_corner_without_one_the_propertys() {
    for name in ["CTRIA3", "CTRIAR"] {
        let model = model(&format!("{name},1,1,1,2,3\n,,,.004,,.01"));
        let stretch = energy(&model, |x, y| [1e-3 * x, -1e-3 * NU * y, 0.0, 0.0, 0.0, 0.0]);
        let mean = (0.004 + 0.008 + 0.01) / 3.0;
        close(stretch, 0.5 * E * 1e-6 * 0.5 * A * B * mean, 1e-10, name);
    }
}

#[test]
fn laminates_and_curved_shells_of_varying_thickness_are_refused_by_a_sentence() {
    let refused = |cards: &str| {
        let deck = format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\nGRID,5,,.5,0.,0.\n{cards}\n\
             PCOMP,2\n,1,.008\nPSHELL,1,1,.008,1\nMAT1,1,7.+10,,.3\n"
        );
        Model::from_bulk(&parse_deck("test.bdf", &deck).expect("a deck")).expect_err("refused").to_string()
    };
    let laminate = refused("CQUAD4,1,2,1,2,3,4\n,,,.004,.01,.01,.004");
    assert!(
        laminate.contains("CQUAD4 1: its corner thicknesses are not its property's, which a laminate has"),
        "{laminate}"
    );
    let curved = refused("CQUAD8,1,1,1,2,3,4,5,\n,,,.004,.01,.01,.004");
    assert!(
        curved.contains("CQUAD8 1: its corner thicknesses are not its property's, which a shell with grids"),
        "{curved}"
    );
}
