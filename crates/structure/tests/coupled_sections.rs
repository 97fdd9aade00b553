//! PSHELL with a material that couples membrane and bending (MID4), beside the laminate that it stands for.

use crate::common::close;
use nalgebra::{DVector, Matrix3};
use nastran::parse_deck;
use structure::Model;

const GRIDS: &str =
    "GRID,1,,0.,0.,0.\nGRID,2,,1.2,0.,0.\nGRID,3,,1.2,.5,0.\nGRID,4,,0.,.5,0.\nCQUAD4,1,1,1,2,3,4\n";

/// Plane stress of an isotropic material.
fn plane(e: f64, nu: f64) -> Matrix3<f64> {
    let share = e / (1.0 - nu * nu);
    Matrix3::new(share, nu * share, 0.0, nu * share, share, 0.0, 0.0, 0.0, e / (2.0 * (1.0 + nu)))
}

fn mat2(id: u32, g: &Matrix3<f64>) -> String {
    let [a, b, c, d, e, f] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|at| g[at]);
    format!("MAT2,{id},{a:.9E},{b:.9E},{c:.9E},{d:.9E},{e:.9E},{f:.9E}\n")
}

/// Energy of a constant strain and curvature.
fn energy(cards: &str, strain: f64, curvature: f64) -> f64 {
    let model = Model::from_bulk(&parse_deck("test.bdf", &format!("{GRIDS}{cards}")).expect("a deck"))
        .expect("a model");
    let element = model.elements().next().expect("one element");
    let moved = element.nodes().iter().flat_map(|node| {
        let x = model.nodes[*node].point.x;
        [strain * x, 0.0, -0.5 * curvature * x * x, 0.0, curvature * x, 0.0]
    });
    let moved = DVector::from_iterator(24, moved);
    0.5 * moved.dot(&(&*element.stiffness().expect("has stiffness") * &moved))
}

#[test]
fn a_section_of_four_materials_is_the_laminate_that_it_stands_for() {
    // Two unlike layers: 3 mm from -4 to -1 mm, 5 mm above.
    let (lower, upper) = (plane(70e9, 0.3), plane(12e9, 0.2));
    let heights = [-0.004_f64, -0.001, 0.004];
    let moment = |power: i32| {
        let of = |low: f64, high: f64| (high.powi(power + 1) - low.powi(power + 1)) / f64::from(power + 1);
        lower * of(heights[0], heights[1]) + upper * of(heights[1], heights[2])
    };
    let t = 0.008_f64;
    // As NASTRAN defines them: integrals of G, z^2 G and -z G over T, T^3/12 and T^2.
    let shell = format!(
        "PSHELL,1,11,.008,12,,13\n,,,14\nMAT1,13,7.+10,,.3\n{}{}{}",
        mat2(11, &(moment(0) / t)),
        mat2(12, &(moment(2) * 12.0 / t.powi(3))),
        mat2(14, &(-moment(1) / t.powi(2)))
    );
    let laminate = "PCOMP,1,-.004\n,1,.003,,,2,.005\nMAT1,1,7.+10,,.3\nMAT1,2,1.2+10,,.2\n";
    for (strain, curvature) in [(1e-3, 0.0), (0.0, 0.1), (1e-3, 0.1), (1e-3, -0.1)] {
        let (one, other) = (energy(&shell, strain, curvature), energy(laminate, strain, curvature));
        close(one, other, 1e-6, &format!("strain {strain}, curvature {curvature}"));
        let closed = 0.5
            * 0.6
            * (strain * strain * moment(0)[(0, 0)]
                + 2.0 * strain * curvature * moment(1)[(0, 0)]
                + curvature * curvature * moment(2)[(0, 0)]);
        close(other, closed, 1e-9, "the laminate's own");
    }
}

#[test]
fn a_coupling_that_has_negative_energy_is_refused_by_a_sentence() {
    let deck = format!("{GRIDS}PSHELL,1,1,.008,1,,1\n,,,2\nMAT1,1,7.+10,,.3\nMAT1,2,7.+10,,.3\n");
    let error =
        Model::from_bulk(&parse_deck("test.bdf", &deck).expect("a deck")).expect_err("too much").to_string();
    assert!(
        error.contains("PSHELL 1: MID4 couples membrane and bending so that some strain has negative energy"),
        "{error}"
    );
}
