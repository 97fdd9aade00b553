//! Splines: how boxes follow the structure, and how box loads reach it.
//!
//! A spline is one matrix G, used both ways: displacements of the k-set (two a box: h along the box normal at its
//! midpoint, theta nose up about its pitch axis) are `u_k = G u_g`, and the loads on the structure are
//! `f_g = Gᵀ P_k`, so virtual work is the same on both sides. Both splines here are exact for rigid motions.

use aero::{AeroBox, Lattice};
use faer::{Mat, MatRef};
use nalgebra::{DMatrix, Point3, Vector3};
use structure::nonlinear::CarriedPoint;

/// Displacement of the boxes by the structure: sparse rows of G, two a box, columns in the g-set
/// (6 a node: translations, then rotations, basic axes).
#[derive(Debug, Clone)]
pub struct Spline {
    rows: Vec<Vec<(usize, f64)>>,
    g_size: usize,
}

/// Six rows (u_x, u_y, u_z, r_x, r_y, r_z) of one point, each a list of (g dof, coefficient).
type PointMotion = [Vec<(usize, f64)>; 6];

impl Spline {
    /// Every box moves rigidly with the node nearest to its midpoint (Loads Kernel's `nearest_neighbour`).
    ///
    /// `nodes` are indices into `points` that take part; of equally near ones the first is taken.
    pub fn nearest_node(lattice: &Lattice, points: &[Point3<f64>], nodes: &[usize]) -> Self {
        let rows = lattice.boxes.iter().flat_map(|panel| {
            let mid = panel.mid_point();
            let nearest = nearest_of(points, nodes, &mid);
            let motion = nearest.map_or_else(PointMotion::default, unit_motion);
            let origin = nearest.map_or(mid, |node| points[node]);
            box_rows(panel, &mid, &origin, &motion)
        });
        Self { rows: rows.collect(), g_size: 6 * points.len() }
    }

    /// A beam spline with rotations: between neighbouring nodes of the axis the deflection is the cubic of the
    /// beam element (its slope is the nodes' rotation), twist and axial motion are linear; the box is carried
    /// rigidly from the foot of the perpendicular to the axis. Beyond the ends the end node carries the box.
    ///
    /// `nodes` are indices into `points` in order along the axis. Incidence is built from the beam's rotation
    /// alone (bending slope and twist separately), as Nastran's SPLINE2 does, not from the gradient of the
    /// interpolated surface.
    pub fn beam(lattice: &Lattice, points: &[Point3<f64>], nodes: &[usize]) -> Self {
        if nodes.len() < 2 {
            return Self::nearest_node(lattice, points, nodes);
        }
        let rows = lattice.boxes.iter().flat_map(|panel| {
            let mid = panel.mid_point();
            let (foot, _, motion) = motion_on_axis(points, nodes, &mid);
            box_rows(panel, &mid, &foot, &motion)
        });
        Self { rows: rows.collect(), g_size: 6 * points.len() }
    }

    /// Splines of consecutive parts of a lattice as one, each part on its own nodes of the same structure with
    /// `g_size` degrees of freedom.
    pub fn joined(parts: impl IntoIterator<Item = Self>, g_size: usize) -> Self {
        Self { rows: parts.into_iter().flat_map(|part| part.rows).collect(), g_size }
    }

    /// From rows of G, two a box, each a list of (g degree of freedom, coefficient).
    pub fn from_rows(rows: Vec<Vec<(usize, f64)>>, g_size: usize) -> Self {
        Self { rows, g_size }
    }

    /// Rows of G, 2 a box.
    pub fn rows(&self) -> &[Vec<(usize, f64)>] {
        &self.rows
    }

    /// Degrees of freedom of the g-set.
    pub fn g_size(&self) -> usize {
        self.g_size
    }

    /// Degrees of freedom of the g-set that any box depends on, ascending.
    pub fn used_dofs(&self) -> Vec<usize> {
        let mut used: Vec<usize> = self.rows.iter().flatten().map(|&(dof, _)| dof).collect();
        used.sort_unstable();
        used.dedup();
        used
    }

    /// `u_k = G u_g`: 2 rows a box from 6 rows a node, column by column.
    pub fn displace(&self, u_g: MatRef<'_, f64>) -> Mat<f64> {
        Mat::from_fn(self.rows.len(), u_g.ncols(), |row, column| {
            self.rows[row].iter().map(|&(dof, value)| value * u_g[(dof, column)]).sum()
        })
    }

    /// `f_g = Gᵀ P_k`: 6 rows a node from 2 rows a box, column by column.
    pub fn loads(&self, p_k: MatRef<'_, f64>) -> Mat<f64> {
        let mut f_g = Mat::zeros(self.g_size, p_k.ncols());
        for column in 0..p_k.ncols() {
            for (row, entries) in self.rows.iter().enumerate() {
                for &(dof, value) in entries {
                    f_g[(dof, column)] += value * p_k[(row, column)];
                }
            }
        }
        f_g
    }
}

/// The point of the axis that [`Spline::beam`] ties each box to, with the two nodes it moves between.
pub(crate) fn feet_on_axis(lattice: &Lattice, points: &[Point3<f64>], nodes: &[usize]) -> Vec<CarriedPoint> {
    if nodes.len() < 2 {
        return nearest_nodes(lattice, points, nodes);
    }
    let foot = |panel: &AeroBox| {
        let (origin, ends, motion) = motion_on_axis(points, nodes, &panel.mid_point());
        CarriedPoint { origin, nodes: ends.to_vec(), rows: dense(&motion, &ends) }
    };
    lattice.boxes.iter().map(foot).collect()
}

/// The node that [`Spline::nearest_node`] ties each box to.
pub(crate) fn nearest_nodes(lattice: &Lattice, points: &[Point3<f64>], nodes: &[usize]) -> Vec<CarriedPoint> {
    let tied = |panel: &AeroBox| {
        let node = nearest_of(points, nodes, &panel.mid_point()).unwrap_or(0);
        CarriedPoint { origin: points[node], nodes: vec![node], rows: dense(&unit_motion(node), &[node]) }
    };
    lattice.boxes.iter().map(tied).collect()
}

/// The nearest of the nodes; of equally near ones the first.
fn nearest_of(points: &[Point3<f64>], nodes: &[usize], to: &Point3<f64>) -> Option<usize> {
    let far = |node: usize| (points[node] - to).norm_squared();
    nodes.iter().copied().min_by(|&a, &b| far(a).total_cmp(&far(b)))
}

/// Rows over the motions of some nodes, six columns each.
fn dense(motion: &PointMotion, nodes: &[usize]) -> DMatrix<f64> {
    let mut rows = DMatrix::zeros(6, 6 * nodes.len());
    for (row, entries) in motion.iter().enumerate() {
        for &(dof, value) in entries {
            for (at, _) in nodes.iter().enumerate().filter(|(_, node)| **node == dof / 6) {
                rows[(row, 6 * at + dof % 6)] += value;
            }
        }
    }
    rows
}

/// The motion of a node itself.
fn unit_motion(node: usize) -> PointMotion {
    std::array::from_fn(|component| vec![(6 * node + component, 1.0)])
}

/// The two rows of a box that is tied rigidly to a point moving as `motion`.
fn box_rows(
    panel: &AeroBox,
    mid: &Point3<f64>,
    origin: &Point3<f64>,
    motion: &PointMotion,
) -> [Vec<(usize, f64)>; 2] {
    let normal = panel.normal();
    let axis = panel.pitch_axis();
    // n . (u + r x arm) = n . u + r . (arm x n)
    let lever = (mid - origin).cross(&normal);
    let heave = combine(motion, [normal.x, normal.y, normal.z, lever.x, lever.y, lever.z]);
    let pitch = combine(motion, [0.0, 0.0, 0.0, axis.x, axis.y, axis.z]);
    [heave, pitch]
}

/// The linear combination of a point's six motions, entries of one degree of freedom merged, zeros dropped.
fn combine(motion: &PointMotion, weights: [f64; 6]) -> Vec<(usize, f64)> {
    let mut entries: Vec<(usize, f64)> = Vec::new();
    for (component, weight) in motion.iter().zip(weights) {
        if weight == 0.0 {
            continue;
        }
        for &(dof, value) in component {
            match entries.iter_mut().find(|(seen, _)| *seen == dof) {
                Some((_, sum)) => *sum += weight * value,
                None => entries.push((dof, weight * value)),
            }
        }
    }
    entries.retain(|&(_, value)| value != 0.0);
    entries.sort_unstable_by_key(|&(dof, _)| dof);
    entries
}

/// The foot of the perpendicular from `point` on the axis, the nodes before and behind it, and how that foot moves with them.
fn motion_on_axis(
    points: &[Point3<f64>],
    nodes: &[usize],
    point: &Point3<f64>,
) -> (Point3<f64>, [usize; 2], PointMotion) {
    let mut best: Option<(f64, usize, f64)> = None;
    for (segment, pair) in nodes.windows(2).enumerate() {
        let along = points[pair[1]] - points[pair[0]];
        let fraction = (point - points[pair[0]]).dot(&along) / along.norm_squared();
        let clamped = fraction.clamp(0.0, 1.0);
        let distance = (point - (points[pair[0]] + along * clamped)).norm();
        if best.is_none_or(|(least, _, _)| distance < least) {
            best = Some((distance, segment, clamped));
        }
    }
    let (_, segment, fraction) = best.unwrap_or((0.0, 0, 0.0));
    let (a, b) = (nodes[segment], nodes[segment + 1]);
    let along = points[b] - points[a];
    (points[a] + along * fraction, [a, b], beam_motion(a, b, &along, fraction))
}

/// Motion of the point at fraction xi of a beam from node a to node b: cubic transverse, linear axial and twist.
fn beam_motion(a: usize, b: usize, along: &Vector3<f64>, xi: f64) -> PointMotion {
    let length = along.norm();
    let x = along / length;
    let linear = [1.0 - xi, xi];
    let deflect = [1.0 - 3.0 * xi * xi + 2.0 * xi * xi * xi, 3.0 * xi * xi - 2.0 * xi * xi * xi];
    let rotate = [length * (xi - 2.0 * xi * xi + xi * xi * xi), length * (xi * xi * xi - xi * xi)];
    let deflect_slope = [6.0 * (xi * xi - xi) / length, 6.0 * (xi - xi * xi) / length];
    let rotate_slope = [1.0 - 4.0 * xi + 3.0 * xi * xi, 3.0 * xi * xi - 2.0 * xi];
    let mut motion = PointMotion::default();
    for (end, node) in [a, b].into_iter().enumerate() {
        for column in 0..3 {
            let unit = Vector3::ith(column, 1.0);
            let axial = x * x.dot(&unit);
            // translation of the node: axial part linear, transverse part cubic; its slope turns the section
            let moved = axial * linear[end] + (unit - axial) * deflect[end];
            let turned = x.cross(&((unit - axial) * deflect_slope[end]));
            // rotation of the node: twist linear, bending slope (r x x) by the cubic's rotation functions
            let bend = unit.cross(&x);
            let moved_by_rotation = bend * rotate[end];
            let turned_by_rotation = axial * linear[end] + x.cross(&(bend * rotate_slope[end]));
            for row in 0..3 {
                push(&mut motion[row], 6 * node + column, moved[row]);
                push(&mut motion[row + 3], 6 * node + column, turned[row]);
                push(&mut motion[row], 6 * node + 3 + column, moved_by_rotation[row]);
                push(&mut motion[row + 3], 6 * node + 3 + column, turned_by_rotation[row]);
            }
        }
    }
    motion
}

fn push(entries: &mut Vec<(usize, f64)>, dof: usize, value: f64) {
    if value != 0.0 {
        entries.push((dof, value));
    }
}

#[cfg(test)]
mod tests;
