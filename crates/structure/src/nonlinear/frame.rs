//! The rotation that fits a group of nodes best, and its spin.
//!
//! With X the undeformed arms from the middle, x those of now and R the rotations of the nodes, Q maximises tr(Q^T M),
//! M = sum w x X^T + sum b R: the least squares of w |x - Q X|^2 + b |R - Q|^2 (2 b |theta|^2 of a small rotation). As M = Q S with S symmetric,
//! a change of M turns Q by the spin D^-1 axial(Q^T dM), D = tr(S) 1 - S. The fit does not depend on the numbering of
//! the nodes, turns with a rigid motion exactly, and is the same for lines, surfaces, bodies and weighted means.

use super::rotation::axial;
use nalgebra::{Matrix3, Matrix4, Rotation3, Vector3};

/// The undeformed group and how much each node counts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Group {
    /// Arms from the (weighted) middle, undeformed, m.
    pub(crate) arms: Vec<Vector3<f64>>,
    /// Weight of each place, for the middle and the fit.
    pub(crate) places: Vec<f64>,
    /// Whether places have a say about the rotation.
    pub(crate) fits_places: bool,
    /// Weight of each rotation, m^2.
    pub(crate) rotations: Vec<f64>,
    /// Whether the places alone do not determine a rotation.
    is_line: bool,
}

/// Rotation weight of nodes in one line, in units of the squared length: small, so that the line points from end to end, and only
/// the roll about it is the nodes'.
const ROLL: f64 = 1e-3;

/// The smallest breadth over length of a group that is no line.
const BREADTH: f64 = 1e-3;

impl Group {
    /// Of nodes that count alike; `turns` if the element has rotations of theirs. A line without them has no roll.
    pub(crate) fn of(points: &[Vector3<f64>], turns: bool) -> Self {
        let mut group = Self::weighted(points, vec![1.0; points.len()], vec![0.0; points.len()]);
        if group.is_line() && turns {
            let square: f64 = group.arms.iter().map(Vector3::norm_squared).sum();
            let weight = if square > 0.0 { ROLL * square } else { 1.0 };
            group.rotations = vec![weight; points.len()];
        }
        group
    }

    /// With weights of places and of rotations.
    pub(crate) fn weighted(points: &[Vector3<f64>], places: Vec<f64>, rotations: Vec<f64>) -> Self {
        let mut group = Self { arms: points.to_vec(), places, fits_places: true, rotations, is_line: false };
        let middle = group.middle(points);
        group.arms.iter_mut().for_each(|arm| *arm -= middle);
        group.is_line = are_in_line(&group.arms, &group.places);
        group
    }

    /// Turning with one node alone.
    pub(crate) fn with_node(points: &[Vector3<f64>], node: usize) -> Self {
        let mut rotations = vec![0.0; points.len()];
        rotations[node] = 1.0;
        Self { fits_places: false, ..Self::weighted(points, vec![1.0; points.len()], rotations) }
    }

    /// The weighted middle of places.
    pub(crate) fn middle(&self, points: &[Vector3<f64>]) -> Vector3<f64> {
        let total: f64 = self.places.iter().sum();
        points.iter().zip(&self.places).map(|(point, weight)| point * *weight).sum::<Vector3<f64>>() / total
    }

    /// Whether the places alone do not determine a rotation.
    pub(crate) fn is_line(&self) -> bool {
        self.is_line
    }

    /// Share of a place in the fit.
    pub(crate) fn weight(&self, node: usize) -> f64 {
        if self.fits_places { self.places[node] } else { 0.0 }
    }

    /// The rotation of a line without roll; its spin has no part along the line.
    fn line(&self, arms: &[Vector3<f64>]) -> Fit {
        let longest = (0..arms.len()).max_by(|a, b| self.arms[*a].norm().total_cmp(&self.arms[*b].norm()));
        let (before, now) = longest.map_or((Vector3::x(), Vector3::x()), |at| (self.arms[at], arms[at]));
        let q = Rotation3::rotation_between(&before, &now).unwrap_or_else(|| {
            // Half a turn about any normal.
            let normal = before.cross(&Vector3::ith(before.iamin(), 1.0)).normalize();
            Rotation3::from_scaled_axis(normal * std::f64::consts::PI)
        });
        let size: f64 =
            self.arms.iter().zip(arms).map(|(before, now)| before.dot(&(q.inverse() * now))).sum();
        let along = before.try_normalize(0.0).unwrap_or_else(Vector3::x);
        let across = Matrix3::identity() - along * along.transpose();
        Fit { q: *q.matrix(), inverse: if size == 0.0 { Matrix3::zeros() } else { across / size } }
    }

    /// The best fit to arms and rotations of now.
    pub(crate) fn fit(&self, arms: &[Vector3<f64>], rotations: &[Rotation3<f64>]) -> Fit {
        if self.rotations.iter().all(|weight| *weight == 0.0) && self.is_line() {
            return self.line(arms);
        }
        let mut m = Matrix3::zeros();
        for (node, arm) in arms.iter().enumerate() {
            m += arm * self.arms[node].transpose() * self.weight(node);
            if self.rotations[node] != 0.0 {
                m += rotations[node].matrix() * self.rotations[node];
            }
        }
        let mut q = best_rotation(&m);
        let mut fit = Fit::of(&m, &q);
        // The eigenvector is good to round-off over the gap; one step of Newton's method makes it good to round-off.
        let spin = fit.inverse * axial(&(q.transpose() * m));
        q *= Rotation3::from_scaled_axis(spin).matrix();
        fit = Fit::of(&m, &q);
        fit
    }
}

/// Whether weighted arms from their middle do not determine a rotation.
fn are_in_line(arms: &[Vector3<f64>], weights: &[f64]) -> bool {
    let inertia: Matrix3<f64> =
        arms.iter().zip(weights).map(|(arm, weight)| arm * arm.transpose() * *weight).sum();
    let mut squares: Vec<f64> = inertia.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares[1] <= BREADTH * BREADTH * squares[2]
}

/// A fitted rotation with what its spin is computed from.
#[derive(Debug, Clone)]
pub(crate) struct Fit {
    /// The rotation.
    pub(crate) q: Matrix3<f64>,
    /// D^-1.
    pub(crate) inverse: Matrix3<f64>,
}

impl Fit {
    fn of(m: &Matrix3<f64>, q: &Matrix3<f64>) -> Self {
        let s = q.transpose() * m;
        let s = (s + s.transpose()) * 0.5;
        let d = Matrix3::identity() * s.trace() - s;
        Self { q: *q, inverse: d.try_inverse().unwrap_or_else(Matrix3::zeros) }
    }
}

/// What a node's local rotation R adds to the spin's numerator: axial(`[a]` R) = (tr(R) 1 - R) a.
pub(crate) fn spin_of_rotation(r: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * r.trace() - r
}

/// The rotation that maximises tr(Q^T M), by the largest eigenvalue over unit quaternions (Horn, J. Opt. Soc. Am. A 4, 1987).
fn best_rotation(m: &Matrix3<f64>) -> Matrix3<f64> {
    let size = m.amax();
    if size == 0.0 {
        return Matrix3::identity();
    }
    let m = m / size;
    let v = axial(&m);
    let mut n = Matrix4::zeros();
    n[(0, 0)] = m.trace();
    for i in 0..3 {
        n[(0, i + 1)] = v[i];
        n[(i + 1, 0)] = v[i];
        for j in 0..3 {
            n[(i + 1, j + 1)] = m[(i, j)] + m[(j, i)];
        }
        n[(i + 1, i + 1)] -= m.trace();
    }
    let eigen = n.symmetric_eigen();
    let best = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned();
    let quaternion = nalgebra::Quaternion::new(best[0], best[1], best[2], best[3]);
    *nalgebra::UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().matrix()
}

#[cfg(test)]
mod tests;
