//! Normals that the shells at a grid share (Nastran's PARAM SNORM).
//!
//! Flat elements on a curved surface meet at small angles, and what is a rotation about the normal of one, which bends
//! nothing, has a part in the plane of the next, which bends it. With a normal of the grid n and the corner's own rotation t,
//! the element is bent by `t - n d / (n . s)`: s is the surface's normal at the corner and d what t turns about it beyond the
//! membrane's own rotation. This is t but for its part along n, which the membrane gives: rotations about n bend no element, and turning
//! the whole body strains none (MacNeal, Wilson, Harder and Hoff, The treatment of shell normals in finite element analysis,
//! Finite Elements in Analysis and Design 30, 1998, have the same aim).

use nalgebra::{RowSVector, SMatrix, Vector3};

/// Least product of a grid's normal with the surface's at a corner for the corner to follow it: 60 degrees.
const LEAST: f64 = 0.5;

/// The motions that bend an element by those of its corners; `None` if no corner has a normal of its grid. `normals` are in the
/// element's axes, `drilling` gives the rotation about the surface's normal less the membrane's own at a corner.
pub(super) fn bending_motions<const D: usize>(
    normals: &[Option<Vector3<f64>>],
    drilling: impl Fn(usize) -> RowSVector<f64, D>,
) -> Option<SMatrix<f64, D, D>> {
    let mut motions = SMatrix::<f64, D, D>::identity();
    for (corner, normal) in normals.iter().enumerate().filter_map(|(at, normal)| Some((at, (*normal)?))) {
        let (first, row) = (6 * corner + 3, drilling(corner));
        let along: f64 = (0..3).map(|axis| row[first + axis] * normal[axis]).sum();
        if along.abs() > LEAST {
            for axis in 0..3 {
                motions.row_mut(first + axis).zip_apply(&row, |own, d| *own -= normal[axis] / along * d);
            }
        }
    }
    normals.iter().any(Option::is_some).then_some(motions)
}
