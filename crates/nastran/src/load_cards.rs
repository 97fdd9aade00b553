//! Loads at grids out: FORCE and MOMENT in the basic system, in 16-character fields always, so that numbers keep ten digits.

use crate::real;
use std::fmt::Write as _;

/// What is not above this share of the largest number of its kind is zero: at 1e-12 the moments left out of a wing of shells, alike in sign, move
/// its tip by 1e-9.
const NOTHING: f64 = 1e-13;
/// Width of a field.
const WIDTH: usize = 16;

/// FORCE* and MOMENT* of loads at grids: `loads` has six numbers a grid (forces, then moments, along the basic axes).
///
/// Forces and moments up to 1e-13 of the largest force or moment are left out.
pub fn load_cards(set: u32, grids: &[u32], loads: &[f64]) -> String {
    let largest = |from: usize| {
        let of = loads.chunks_exact(6).flat_map(|six| &six[from..from + 3]);
        of.fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    let mut text = String::new();
    for (name, from, largest) in [("FORCE*", 0, largest(0)), ("MOMENT*", 3, largest(3))] {
        for (grid, six) in grids.iter().zip(loads.chunks_exact(6)) {
            let kept = |value: &f64| if value.abs() > NOTHING * largest { *value } else { 0.0 };
            let vector: Vec<f64> = six[from..from + 3].iter().map(kept).collect();
            if vector.iter().all(|value| *value == 0.0) {
                continue;
            }
            let [x, y, z] = [0, 1, 2].map(|axis| real::format(vector[axis], WIDTH));
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{name:<8}{set:>16}{grid:>16}{:>16}{:>16}", 0, "1.");
            let _ = writeln!(text, "*       {x:>16}{y:>16}{z:>16}");
        }
    }
    text
}
