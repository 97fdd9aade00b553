//! The infinite plate of SPLINE1 (Harder and Desmarais, 1972).
//!
//! ```text
//! w(x, y) = a0 + a1 x + a2 y + sum F_i r_i² ln r_i²,   sum F_i = sum x_i F_i = sum y_i F_i = 0,   w(x_i, y_i) + 16 pi DZ F_i = u_i
//! ```
//! x along the stream and y along the span in the panel's plane, w and u_i along its normal. A box heaves by w at its midpoint and
//! pitches by the slope along the stream there. Boxes of a SPLINE1 are the rectangle of its panel with BOX1 and BOX2 at its
//! corners.

use crate::deck::box_rows::{BoxRows, nodes};
use aero::Lattice;
use faer::Mat;
use faer::linalg::solvers::Solve;
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, InputError, SplineCard};
use std::collections::BTreeMap;

/// The boxes of a SPLINE1: a rectangle of its panel.
///
/// # Errors
/// If the panel is not there or has not got the boxes.
pub(crate) fn boxes(card: &SplineCard, lattice: &Lattice) -> Result<Vec<usize>, InputError> {
    let blame = |message: String| InputError::at(&card.span, message);
    let surface = lattice
        .surfaces
        .iter()
        .find(|surface| surface.id == card.panel)
        .ok_or_else(|| blame(format!("CAERO1 {} of SPLINE1 {} is not there", card.panel, card.id)))?;
    let place = |id: u32| {
        let at = (id as usize).checked_sub(surface.id as usize);
        at.filter(|at| *at < surface.chordwise * surface.spanwise)
            .map(|at| (at % surface.chordwise, at / surface.chordwise))
            .ok_or_else(|| blame(format!("CAERO1 {} has no box {id}", card.panel)))
    };
    let ((c1, s1), (c2, s2)) = (place(card.boxes.0)?, place(card.boxes.1)?);
    let chord = c1.min(c2)..=c1.max(c2);
    let at = |s: usize, c: usize| surface.first_box + s * surface.chordwise + c;
    Ok((s1..=s2).flat_map(|s| chord.clone().map(move |c| (s, c))).map(|(s, c)| at(s, c)).collect())
}

/// Heave and pitch of each box by the grids of the card's set.
///
/// # Errors
/// If there are no boxes, a grid is not there, or the grids lie on one line.
pub(crate) fn rows(
    bulk: &BulkData,
    card: &SplineCard,
    lattice: &Lattice,
    boxes: &[usize],
    ids: &[u32],
    points: &[Point3<f64>],
) -> Result<Vec<BoxRows>, InputError> {
    let nodes = nodes(bulk, card, ids)?;
    let (Some(first), Some(corner)) = (boxes.first(), nodes.first()) else {
        return Err(InputError::at(&card.span, format!("spline {} has no boxes or no grids", card.id)));
    };
    let (normal, along) = (lattice.boxes[*first].normal(), lattice.boxes[*first].pitch_axis());
    let stream = along.cross(&normal);
    let origin = points[*corner];
    let flat = |p: &Point3<f64>| [(p - origin).dot(&stream), (p - origin).dot(&along)];
    let grids: Vec<[f64; 2]> = nodes.iter().map(|&node| flat(&points[node])).collect();
    // lengths in units of the set's extent, or constants and r² ln r² are of very different size
    let unit = grids.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    let grids: Vec<[f64; 2]> = grids.into_iter().map(|at| at.map(|x| x / unit)).collect();
    let n = grids.len();
    let mut matrix = Mat::zeros(n + 3, n + 3);
    for (i, at) in grids.iter().enumerate() {
        for (j, value) in fields(&grids, *at).into_iter().enumerate() {
            matrix[(i, j)] = value[0];
            if j >= n {
                matrix[(j, i)] = value[0];
            }
        }
    }
    for i in 0..n {
        // The plate's own flexibility is r² ln r² / 16 pi with a bending stiffness of one.
        matrix[(i, i)] += 16.0 * std::f64::consts::PI * card.flexibility / (unit * unit);
    }
    let mut wanted = Mat::zeros(n + 3, 2 * boxes.len());
    for (k, &place) in boxes.iter().enumerate() {
        let panel = &lattice.boxes[place];
        let at = flat(&panel.mid_point()).map(|x| x / unit);
        // nose up is a slope down along the stream
        for (j, value) in fields(&grids, at).into_iter().enumerate() {
            wanted[(j, 2 * k)] = value[0];
            wanted[(j, 2 * k + 1)] = -value[1] / unit;
        }
    }
    // the matrix is symmetric, so this is E A^-1 transposed
    let weights = matrix.partial_piv_lu().solve(&wanted);
    let right = weights.col_iter().all(|column| column.iter().all(|value| value.is_finite()));
    if !right || spread(&grids) < 1e-9 {
        let message = format!("the grids of spline {} do not determine a plate", card.id);
        return Err(InputError::at(&card.span, message)
            .with_help("expected three grids or more that do not lie on one line along the panel"));
    }
    Ok((0..boxes.len()).map(|k| [0, 1].map(|part| row(&nodes, &normal, &weights, 2 * k + part))).collect())
}

/// w and its slope along x at a place by each unknown: sources at the grids, then a0, a1, a2.
fn fields(grids: &[[f64; 2]], at: [f64; 2]) -> Vec<[f64; 2]> {
    let source = |grid: &[f64; 2]| {
        let (x, y) = (at[0] - grid[0], at[1] - grid[1]);
        let r2 = x * x + y * y;
        if r2 > 0.0 { [r2 * r2.ln(), 2.0 * x * (1.0 + r2.ln())] } else { [0.0; 2] }
    };
    grids.iter().map(source).chain([[1.0, 0.0], [at[0], 1.0], [at[1], 0.0]]).collect()
}

/// Twice the area of the largest triangle of the first grid with two others: zero if all lie on one line.
fn spread(grids: &[[f64; 2]]) -> f64 {
    let side = |at: &[f64; 2]| [at[0] - grids[0][0], at[1] - grids[0][1]];
    let mut largest = 0.0_f64;
    for (i, one) in grids.iter().enumerate() {
        for other in &grids[..i] {
            let (a, b) = (side(one), side(other));
            largest = largest.max((a[0] * b[1] - a[1] * b[0]).abs());
        }
    }
    largest
}

/// One row of G: the grids' motions along the normal.
fn row(nodes: &[usize], normal: &Vector3<f64>, weights: &Mat<f64>, column: usize) -> Vec<(usize, f64)> {
    let mut entries = BTreeMap::new();
    for (i, node) in nodes.iter().enumerate() {
        for component in 0..3 {
            let value = weights[(i, column)] * normal[component];
            if value != 0.0 {
                *entries.entry(6 * node + component).or_insert(0.0) += value;
            }
        }
    }
    entries.into_iter().collect()
}
