//! Structures that bend far, written card by card.

#![expect(
    clippy::unwrap_used,
    clippy::format_push_string,
    unreachable_pub,
    reason = "helpers of the tests in this folder"
)]
#![allow(dead_code, reason = "not every test file uses every helper")]

use nalgebra::{Rotation3, Vector3};
use nastran::parse_deck;
use serde_json::Value;
use structure::Model;
use structure::nonlinear::{LargeDeflection, Loads, NodeLoad, Path};

/// The structure of a deck.
pub fn large(deck: &str) -> LargeDeflection {
    LargeDeflection::new(&model(deck)).unwrap()
}

/// The model of a deck.
pub fn model(deck: &str) -> Model {
    Model::from_bulk(&parse_deck("test.bdf", deck).unwrap()).unwrap()
}

/// The equilibria from the undeformed state to these loads.
pub fn path(wing: &LargeDeflection, loads: &Loads) -> Path {
    wing.under(loads).unwrap()
}

/// A force at the node at a position.
pub fn force(node: usize, newton: [f64; 3]) -> NodeLoad {
    NodeLoad { node, force: Vector3::from(newton), moment: Vector3::zeros() }
}

/// A moment at the node at a position.
pub fn moment(node: usize, newton_m: [f64; 3]) -> NodeLoad {
    NodeLoad { node, force: Vector3::zeros(), moment: Vector3::from(newton_m) }
}

/// The rotation vector of a small rotation, to its third power.
pub fn spin(rotation: &Rotation3<f64>) -> Vector3<f64> {
    Vector3::new(
        rotation[(2, 1)] - rotation[(1, 2)],
        rotation[(0, 2)] - rotation[(2, 0)],
        rotation[(1, 0)] - rotation[(0, 1)],
    ) * 0.5
}

/// A line of `count` bars along x from the origin, grids from 1, a rectangular section (height along z, breadth along
/// y), no shear flexibility, Poisson's ratio zero.
pub fn beam_along_x(count: usize, length: f64, e: f64, [height, breadth]: [f64; 2]) -> String {
    let mut deck = format!("MAT1,1,{e:?},{:?},,1.0\n", 0.5 * e);
    let (area, i1, i2) = (height * breadth, breadth * height.powi(3) / 12.0, height * breadth.powi(3) / 12.0);
    deck += &format!("PBAR,1,1,{area:.6E},{i1:.8E},{i2:.8E},{:.8E}\n", 4.0 * i1.min(i2));
    for node in 0..=count {
        deck += &format!("GRID,{},,{:.10},0.,0.\n", node + 1, length * node as f64 / count as f64);
    }
    for grid in 1..=count {
        deck += &format!("CBAR,{grid},1,{grid},{},0.,0.,1.\n", grid + 1);
    }
    deck
}

/// By what share a number is off another.
#[track_caller]
pub fn share_off(own: f64, of: f64) -> f64 {
    let off = (own / of - 1.0).abs();
    // A largest one of several does not see what is no number.
    assert!(off.is_finite(), "{own} for {of}");
    off
}

/// A case of `data/published`.
pub fn published(name: &str) -> Value {
    let path = format!("{}/../../data/published/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// A column of its expected values.
pub fn tabled(case: &Value, column: &str) -> Vec<f64> {
    numbers(&case["expected"][column])
}

/// A list of numbers.
pub fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
}

/// The inextensible cantilever under an end force (Bisshopp and Drucker, Q. Appl. Math. 3, 1945): P L^2 / E I, shortening and deflection
/// over length.
pub fn elastica() -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let case = published("nl_beam__elastica_end_shear");
    (tabled(&case, "alpha"), tabled(&case, "shortening_over_L"), tabled(&case, "deflection_over_L"))
}
