//! The deformed shape of the boxes, for pictures: displacements of the structure, splined to each box, moved to its
//! corners.

use aero::Lattice;
use nalgebra::Point3;

use crate::supported::SupportedStructure;

/// Corners of all boxes, deformed by a displacement of the s-set (m and rad): each corner is moved along its box's normal
/// by the mean of what the boxes around it say, so that neighbours stay joined. The angle of attack is not in it.
pub fn deformed_boxes(
    lattice: &Lattice,
    held: &SupportedStructure,
    displacement: &[f64],
) -> Vec<[Point3<f64>; 4]> {
    let moved = |row: usize| -> f64 {
        held.spline_rows[row].iter().map(|&(at, value)| value * displacement[at]).sum()
    };
    // The box's own plane at a point `x_m`: up by h, nose up by theta.
    let height =
        |j: usize, x_m: f64| moved(2 * j) - moved(2 * j + 1) * (x_m - lattice.boxes[j].mid_point().x);
    let mut deformed = Vec::with_capacity(lattice.len());
    for surface in &lattice.surfaces {
        let at = |strip: usize, row: usize| surface.first_box + strip * surface.chordwise + row;
        for strip in 0..surface.spanwise {
            for row in 0..surface.chordwise {
                let j = at(strip, row);
                let normal = lattice.boxes[j].normal();
                let beside = [strip.saturating_sub(1), (strip + 1).min(surface.spanwise - 1)];
                let corner = |index: usize, side: usize, aft: usize| {
                    let corner = lattice.boxes[j].corners[index];
                    let rows = [(row + aft).saturating_sub(1), (row + aft).min(surface.chordwise - 1)];
                    let around = [strip, beside[side]].into_iter().flat_map(|s| rows.map(|r| at(s, r)));
                    let sum: f64 = around.map(|k| height(k, corner.x)).sum();
                    corner + normal * (0.25 * sum)
                };
                deformed.push([corner(0, 0, 0), corner(1, 0, 1), corner(2, 1, 1), corner(3, 1, 0)]);
            }
        }
    }
    deformed
}
