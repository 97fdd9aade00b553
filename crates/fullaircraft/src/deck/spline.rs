//! The beam spline of SPLINE2: an infinite beam in bending and a rod in torsion, with rigid arms to the grids.
//!
//! ```text
//! w(y) = a0 + a1 y + sum P_j |y - y_j|^3 / 12,   phi(y) = b0 - DTOR/2 sum T_j |y - y_j|
//! u_i = w(y_i) - x_i phi(y_i),   about x: w',   about y: phi      (EI = 1, GJ = 1/DTOR)
//! ```
//! Sources follow from each attachment by virtual work and are in balance; checked by HA144A's published loads, which another
//! beam spline does not give to six digits.
//! A box's incidence is built from w' and phi as a rotation; the term x phi' of the surface's gradient is left out, as there.

use crate::deck::box_rows::{BoxRows, nodes};
use crate::deck::plate;
use aero::{AeroBox, Lattice, StreamAxes};
use coupling::Spline;
use faer::Mat;
use faer::linalg::solvers::Solve;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{BulkData, Frames, InputError, SplineCard, SplineKind};

/// What of a grid is attached.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    Heave,
    AboutX,
    AboutY,
}

/// One attachment: node, part, place in the spline's axes and flexibility.
struct Attachment {
    node: usize,
    part: Part,
    x: f64,
    y: f64,
    flexibility: f64,
}

impl Attachment {
    fn new(node: usize, part: Part, at: &Vector3<f64>, flexibility: f64) -> Self {
        Self { node, part, x: at.x, y: at.y, flexibility }
    }

    /// w and w' at y per unit source.
    fn bending(&self, y: f64) -> [f64; 2] {
        let d = y - self.y;
        match self.part {
            Part::Heave => [d.abs().powi(3) / 12.0, d.abs() * d / 4.0],
            Part::AboutX => [-d.abs() * d / 4.0, -d.abs() / 2.0],
            Part::AboutY => [0.0; 2],
        }
    }

    /// Torque per unit source.
    fn torque(&self) -> f64 {
        match self.part {
            Part::Heave => -self.x,
            Part::AboutX => 0.0,
            Part::AboutY => 1.0,
        }
    }

    /// What is attached, of w, w' and phi at its place.
    fn value(&self, w: [f64; 2], phi: f64) -> f64 {
        let bending = match self.part {
            Part::Heave => w[0],
            Part::AboutX => w[1],
            Part::AboutY => 0.0,
        };
        bending + self.torque() * phi
    }
}

/// The splines of a deck.
#[derive(Debug)]
pub(crate) struct Splined {
    /// Motion of the boxes by those of the structure.
    pub(crate) spline: Spline,
    /// Boxes without a spline.
    pub(crate) loose: Vec<u32>,
}

/// The splines of a deck: SPLINE2 and SPLINE5 as described above, SPLINE1 and SPLINE4 as [`crate::deck::plate`] says; a box without one neither moves nor loads the structure.
///
/// # Errors
/// If no box has a spline or one has two, or a spline names a set, grid or system that is not there.
pub(crate) fn splines(
    bulk: &BulkData,
    lattice: &Lattice,
    ids: &[u32],
    points: &[Point3<f64>],
    stream: &StreamAxes,
) -> Result<Splined, InputError> {
    let seen: Vec<Point3<f64>> = points.iter().map(|point| stream.seen(point)).collect();
    let points = seen.as_slice();
    let mut rows: Vec<Option<Vec<(usize, f64)>>> = vec![None; 2 * lattice.len()];
    for card in bulk.splines.values() {
        let boxes = boxes(bulk, card, lattice)?;
        let pairs = match card.kind {
            SplineKind::Plate => plate::rows(bulk, card, lattice, &boxes, ids, points)?,
            SplineKind::Beam { .. } => beam(bulk, card, lattice, &boxes, ids, points, stream)?,
        };
        for (place, pair) in boxes.iter().zip(pairs) {
            for (k, row) in pair.into_iter().enumerate() {
                if rows[2 * place + k].replace(row).is_some() {
                    let message = format!("box {} has two splines", lattice.boxes[*place].id);
                    return Err(InputError::at(&card.span, message).with_help("name each box in one spline"));
                }
            }
        }
    }
    let loose: Vec<u32> =
        (0..lattice.len()).filter(|&j| rows[2 * j].is_none()).map(|j| lattice.boxes[j].id).collect();
    if loose.len() == lattice.len() {
        return Err(InputError::general("no box of the deck has a spline")
            .with_help("name the boxes in a SPLINE1, SPLINE2, SPLINE4 or SPLINE5"));
    }
    let rows = rows.into_iter().map(|row| in_basic_axes(row.unwrap_or_default(), stream)).collect();
    Ok(Splined { spline: Spline::from_rows(rows, 6 * points.len()), loose })
}

/// A row over motions of the nodes along the stream's axes as one over those along the basic axes.
fn in_basic_axes(row: Vec<(usize, f64)>, stream: &StreamAxes) -> Vec<(usize, f64)> {
    if stream.is_basic() {
        return row;
    }
    let mut turned = std::collections::BTreeMap::new();
    for (dof, value) in row {
        for axis in 0..3 {
            *turned.entry(dof / 3 * 3 + axis).or_insert(0.0) += stream.axes[(axis, dof % 3)] * value;
        }
    }
    turned.into_iter().collect()
}

/// Places of a spline's boxes: its list (SPLINE4, SPLINE5), a rectangle (SPLINE1), or a range of numbers (SPLINE2).
fn boxes(bulk: &BulkData, card: &SplineCard, lattice: &Lattice) -> Result<Vec<usize>, InputError> {
    let blame = |message: String| InputError::at(&card.span, message);
    let Some(list) = card.list else {
        let range = card.boxes.0..=card.boxes.1;
        return match card.kind {
            SplineKind::Plate => plate::boxes(card, lattice),
            SplineKind::Beam { .. } => {
                Ok((0..lattice.len()).filter(|&j| range.contains(&lattice.boxes[j].id)).collect())
            }
        };
    };
    let listed = bulk.box_lists.get(&list).ok_or_else(|| blame(format!("AELIST {list} is not there")))?;
    let place = |id: &u32| {
        let at = lattice.index_of(*id);
        at.ok_or_else(|| blame(format!("box {id} of AELIST {list} is not there")))
    };
    listed.boxes.iter().map(place).collect()
}

fn beam(
    bulk: &BulkData,
    card: &SplineCard,
    lattice: &Lattice,
    boxes: &[usize],
    ids: &[u32],
    points: &[Point3<f64>],
    stream: &StreamAxes,
) -> Result<Vec<BoxRows>, InputError> {
    let blame = |message: String| InputError::at(&card.span, message);
    let SplineKind::Beam { system, torsional_ratio, attachment } = card.kind else { return Ok(Vec::new()) };
    let Some(first) = boxes.first() else {
        return Err(blame(format!("spline {} has no boxes", card.id)));
    };
    let frames = Frames::resolve(bulk)?;
    let axes = axes(
        &lattice.boxes[*first],
        &(stream.axes.transpose() * frames.axes_at(system, &card.span)?.column(1)),
    );
    let origin = stream.seen(&frames.origin(system, &card.span)?);
    let mut attached = Vec::new();
    for node in nodes(bulk, card, ids)? {
        let at = axes.transpose() * (points[node] - origin);
        attached.push(Attachment::new(node, Part::Heave, &at, card.flexibility));
        for (part, flexibility) in [Part::AboutX, Part::AboutY].into_iter().zip(attachment) {
            if flexibility >= 0.0 {
                attached.push(Attachment::new(node, part, &at, flexibility));
            }
        }
    }
    let weights = weights(&attached, torsional_ratio, lattice, boxes, &axes, &origin);
    if weights.col_iter().any(|column| column.iter().any(|value| !value.is_finite())) {
        return Err(blame(format!("the grids of spline {} do not determine it", card.id))
            .with_help("expected grids apart along the spline's y axis, or DTHX attached"));
    }
    Ok((0..boxes.len()).map(|at| [0, 1].map(|k| row(&attached, &axes, &weights, 2 * at + k))).collect())
}

/// Spline axes as columns: z the panel's normal, y the given axis in the panel's plane.
fn axes(panel: &AeroBox, along: &Vector3<f64>) -> Matrix3<f64> {
    let z = panel.normal();
    let y = (along - z * z.dot(along)).normalize();
    Matrix3::from_columns(&[y.cross(&z), y, z])
}

/// Coefficients of each attachment (rows) for heave and pitch of each box (columns).
fn weights(
    attached: &[Attachment],
    ratio: f64,
    lattice: &Lattice,
    boxes: &[usize],
    axes: &Matrix3<f64>,
    origin: &Point3<f64>,
) -> Mat<f64> {
    let n = attached.len();
    // w, w' and phi at y by each unknown: sources, then a0, a1, b0
    let fields = |y: f64| -> Vec<([f64; 2], f64)> {
        let sources = attached.iter().map(|a| (a.bending(y), -0.5 * ratio * a.torque() * (y - a.y).abs()));
        sources.chain([([1.0, 0.0], 0.0), ([y, 1.0], 0.0), ([0.0, 0.0], 1.0)]).collect()
    };
    let mut matrix = Mat::zeros(n + 3, n + 3);
    for (i, a) in attached.iter().enumerate() {
        for (j, (w, phi)) in fields(a.y).into_iter().enumerate() {
            matrix[(i, j)] = a.value(w, phi);
            if j >= n {
                matrix[(j, i)] = matrix[(i, j)];
            }
        }
        matrix[(i, i)] += a.flexibility;
    }
    let mut wanted = Mat::zeros(n + 3, 2 * boxes.len());
    for (at, &place) in boxes.iter().enumerate() {
        let panel = &lattice.boxes[place];
        let local = axes.transpose() * (panel.mid_point() - origin);
        let axis = axes.transpose() * panel.pitch_axis();
        for (j, (w, phi)) in fields(local.y).into_iter().enumerate() {
            wanted[(j, 2 * at)] = w[0] - local.x * phi;
            wanted[(j, 2 * at + 1)] = w[1] * axis.x + phi * axis.y;
        }
    }
    // the matrix is symmetric, so this is E A^-1 transposed
    matrix.partial_piv_lu().solve(&wanted)
}

/// One row of G.
fn row(attached: &[Attachment], axes: &Matrix3<f64>, weights: &Mat<f64>, column: usize) -> Vec<(usize, f64)> {
    let mut entries = std::collections::BTreeMap::new();
    for (i, a) in attached.iter().enumerate() {
        let (from, axis) = match a.part {
            Part::Heave => (0, 2),
            Part::AboutX => (3, 0),
            Part::AboutY => (3, 1),
        };
        for component in 0..3 {
            let value = weights[(i, column)] * axes[(component, axis)];
            if value != 0.0 {
                *entries.entry(6 * a.node + from + component).or_insert(0.0) += value;
            }
        }
    }
    entries.into_iter().collect()
}

#[cfg(test)]
mod laws;
#[cfg(test)]
mod tests;
