//! Decks of straight beams, written card by card.

#![expect(
    clippy::unwrap_used,
    clippy::format_push_string,
    unreachable_pub,
    reason = "helpers of the tests in this folder"
)]
#![allow(dead_code, reason = "not every test file uses every helper")]

use faer::Mat;
use nastran::parse_deck;
use structure::{Flexibility, Model, System};

/// Young's modulus of every test beam, Pa.
pub const E: f64 = 70e9;
/// Shear modulus, Pa.
pub const G: f64 = 27e9;
/// Density, kg/m^3.
pub const RHO: f64 = 2700.0;
/// Area, m^2.
pub const AREA: f64 = 1e-4;
/// Moments of inertia of planes 1 and 2, torsion constant, m^4.
pub const I: [f64; 3] = [4e-9, 1e-9, 2e-9];

/// The system of a deck.
pub fn system(deck: &str) -> System {
    let bulk = parse_deck("test.bdf", deck).unwrap();
    System::assemble(&Model::from_bulk(&bulk).unwrap()).unwrap()
}

/// Material and section, one card a line.
pub fn section() -> String {
    format!("MAT1,1,{E:.1E},{G:.1E},,{RHO:?}\nPBAR,1,1,{AREA:.1E},{:.1E},{:.1E},{:.1E}\n", I[0], I[1], I[2])
}

/// A beam of `n` elements along y from (x, 0, 0), grids from `first`; plane 1 is y-z.
pub fn beam(first: usize, n: usize, length: f64, x: f64) -> String {
    let mut deck = String::new();
    for node in 0..=n {
        deck += &format!("GRID,{},,{x:?},{:.12},0.\n", first + node, length * node as f64 / n as f64);
    }
    for element in 0..n {
        let grid = first + element;
        deck += &format!("CBAR,{grid},1,{grid},{},0.,0.,1.\n", grid + 1);
    }
    deck
}

/// Displacements of all nodes (g-set) under loads given as (grid, component, value).
pub fn displaced(system: &System, loads: &[(u32, usize, f64)]) -> Mat<f64> {
    let mut load = Mat::zeros(6 * system.node_count(), 1);
    for (grid, component, value) in loads {
        load[(6 * system.node_index(*grid).unwrap() + component - 1, 0)] += value;
    }
    let flexibility = Flexibility::new(system).unwrap();
    system.expand(flexibility.displacements(system.reduce(load.as_ref()).as_ref()).as_ref())
}

/// One component of a g-set motion.
pub fn at(system: &System, motion: &Mat<f64>, grid: u32, component: usize) -> f64 {
    motion[(6 * system.node_index(grid).unwrap() + component - 1, 0)]
}

/// Relative agreement.
#[track_caller]
pub fn close(got: f64, expected: f64, relative: f64, what: &str) {
    assert!((got - expected).abs() <= relative * expected.abs(), "{what}: {got} instead of {expected}");
}
