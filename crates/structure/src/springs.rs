//! Springs, bushes, rods, general elements and mass matrices: cards to matrices in basic axes.

use crate::corotation::Corotation;
use crate::element::Element;
use crate::matrix_element::MatrixElement;
use crate::model::Node;
use nalgebra::{DMatrix, DVector, Matrix3, Point3, Vector3};
use nastran::{Conm1, Crod, Genel, InputError, Mat1, Pbush, Prod, Span};

/// Motions as degrees of freedom of the g-set, and a matrix over them.
pub(crate) type OverMotions = (Vec<usize>, DMatrix<f64>);

/// One motion of a node in its own axes (component 0 to 5) as degrees of freedom of the g-set.
pub(crate) fn motion(nodes: &[Node], node: usize, component: usize) -> [(usize, f64); 3] {
    let axis = nodes[node].axes.column(component % 3);
    let first = 6 * node + component - component % 3;
    [0, 1, 2].map(|k| (first + k, axis[k]))
}

/// `value` times the square of the difference of two motions (one, if the other is the ground).
pub(crate) fn scalar(nodes: &[Node], ends: [Option<(usize, usize)>; 2], value: f64) -> OverMotions {
    let (mut dofs, mut difference) = (Vec::new(), Vec::new());
    for (end, sign) in ends.into_iter().zip([1.0, -1.0]) {
        for (dof, factor) in end.into_iter().flat_map(|(node, component)| motion(nodes, node, component)) {
            if let Some(at) = dofs.iter().position(|other| *other == dof) {
                difference[at] += sign * factor;
            } else {
                dofs.push(dof);
                difference.push(sign * factor);
            }
        }
    }
    let difference = DVector::from_vec(difference);
    (dofs, &difference * difference.transpose() * value)
}

/// Six values (stiffness or damping) of a bush at `place` between two nodes, or a node and the ground, as a matrix over all motions of
/// these. Columns of `axes` are its x, y, z.
pub(crate) fn bush(nodes: &[Node], place: &BushPlace, values: &[f64; 6]) -> OverMotions {
    let all = place.nodes();
    let dofs: Vec<usize> = all.iter().flat_map(|node| (0..6).map(move |c| 6 * node + c)).collect();
    let mut strain = DMatrix::zeros(6, dofs.len());
    // The motion of the spring's ends at its place: displacement u + theta x r, rotation theta.
    for (end, node) in all.iter().enumerate() {
        let sign = if end == 0 { -1.0 } else { 1.0 };
        let lever = -(place.point - nodes[*node].point).cross_matrix();
        let turn = place.axes.transpose() * sign;
        strain.view_mut((0, 6 * end), (3, 3)).copy_from(&turn);
        strain.view_mut((0, 6 * end + 3), (3, 3)).copy_from(&(turn * lever));
        strain.view_mut((3, 6 * end + 3), (3, 3)).copy_from(&turn);
    }
    let diagonal = DMatrix::from_diagonal(&DVector::from_column_slice(values));
    (dofs, strain.transpose() * diagonal * &strain)
}

/// Where a bush is.
pub(crate) struct BushPlace {
    /// Its nodes; without a second one it ends at the ground.
    pub(crate) ends: (usize, Option<usize>),
    /// Place of the spring.
    pub(crate) point: Point3<f64>,
    /// Columns are its x, y, z.
    pub(crate) axes: Matrix3<f64>,
    /// Share of its mass at the second end; the rest is at the first.
    pub(crate) mass_at_b: f64,
}

impl BushPlace {
    fn nodes(&self) -> Vec<usize> {
        [Some(self.ends.0), self.ends.1].into_iter().flatten().collect()
    }

    /// A bush with the stiffness and mass of a property. Its axes turn with end A; nodes are listed in ascending order, and an end that
    /// meets no stiffness is not among them.
    pub(crate) fn element(&self, id: u32, nodes: &[Node], property: &Pbush) -> MatrixElement {
        let (dofs, k) = bush(nodes, self, &property.stiffness);
        let element = if property.mass > 0.0 {
            MatrixElement::new(id, &dofs, &k, &self.mass(property.mass))
        } else {
            MatrixElement::spring(id, &dofs, &k)
        };
        let turning = match element.nodes().iter().position(|node| *node == self.ends.0) {
            Some(node) if self.ends.1.is_some() => Corotation::Node(node),
            _ => Corotation::Ground,
        };
        element.turning(turning)
    }

    /// Its mass at the ends, the ground's share left out (QRG, PBUSH, remark 13).
    fn mass(&self, mass: f64) -> DMatrix<f64> {
        let shares = [1.0 - self.mass_at_b, self.mass_at_b];
        let own = |i: usize| if i % 6 < 3 { shares[i / 6] * mass } else { 0.0 };
        DMatrix::from_diagonal(&DVector::from_fn(6 * self.nodes().len(), |i, _| own(i)))
    }
}

/// What stretches and twists a line between two nodes: rows over their twelve motions.
///
/// # Errors
/// If it has no length; `user` is the card.
fn along_line(
    nodes: &[Node],
    ends: [usize; 2],
    user: &str,
    span: &Span,
) -> Result<[DVector<f64>; 2], InputError> {
    let [a, b] = ends.map(|node| nodes[node].point);
    let Some(x) = (b - a).try_normalize(1e-12 * (a.coords.norm() + b.coords.norm())) else {
        let message = format!("{user} has no length: both ends are at ({}, {}, {})", a.x, a.y, a.z);
        return Err(InputError::at(span, message).with_help("check its two grids"));
    };
    let along = |from: usize| {
        DVector::from_fn(12, |i, _| {
            let sign = if i < 6 { -1.0 } else { 1.0 };
            if (from..from + 3).contains(&(i % 6)) { sign * x[i % 6 - from] } else { 0.0 }
        })
    };
    Ok([along(0), along(3)])
}

/// All motions of two nodes.
fn motions_of(ends: [usize; 2]) -> Vec<usize> {
    ends.iter().flat_map(|node| (0..6).map(move |c| 6 * node + c)).collect()
}

/// A stretching and a twisting value (stiffness or damping) of a line between two nodes, over all motions of these.
///
/// # Errors
/// If the line has no length; `user` is the card.
pub(crate) fn line(
    nodes: &[Node],
    ends: [usize; 2],
    [stretching, twisting]: [f64; 2],
    user: &str,
    span: &Span,
) -> Result<OverMotions, InputError> {
    let [stretch, twist] = along_line(nodes, ends, user, span)?;
    let matrix = &stretch * stretch.transpose() * stretching + &twist * twist.transpose() * twisting;
    Ok((motions_of(ends), matrix))
}

/// A rod: stretch and twist, and its mass on the displacements.
///
/// # Errors
/// If it has no length.
pub(crate) fn rod(
    card: &Crod,
    nodes: &[Node],
    ends: [usize; 2],
    property: &Prod,
    material: &Mat1,
) -> Result<MatrixElement, InputError> {
    let length = (nodes[ends[1]].point - nodes[ends[0]].point).norm();
    let per_length = [material.e * property.area, material.g * property.j].map(|value| value / length);
    let (dofs, k) = line(nodes, ends, per_length, &format!("CROD {}", card.id), &card.span)?;
    let mass = (material.rho * property.area + property.nsm) * length;
    let m = DMatrix::from_fn(12, 12, |i, j| {
        let same = i % 6 == j % 6 && i % 6 < 3;
        if same { mass / if i == j { 3.0 } else { 6.0 } } else { 0.0 }
    });
    Ok(MatrixElement::new(card.id, &dofs, &k, &m))
}

/// A value (stiffness or damping) along one direction between two nodes, or a node and the ground, over their displacements.
pub(crate) fn along(ends: (usize, Option<usize>), direction: &Vector3<f64>, value: f64) -> OverMotions {
    let all: Vec<usize> = [Some(ends.0), ends.1].into_iter().flatten().collect();
    let dofs = all.iter().flat_map(|node| (0..3).map(move |c| 6 * node + c)).collect();
    let difference =
        DVector::from_fn(3 * all.len(), |i, _| if i < 3 { -direction[i] } else { direction[i - 3] });
    (dofs, &difference * difference.transpose() * value)
}

/// A general element: K over (ui, ud) = `[k, -k S; -S^T k, S^T k S]`, k the given stiffness or the inverse of the given
/// flexibility. Without S it follows from the rigid motions that the six ud determine; without ud, k is over ui alone.
///
/// # Errors
/// If the flexibility cannot be inverted, or S is left to ud that do not determine a rigid motion.
pub(crate) fn general(
    card: &Genel,
    nodes: &[Node],
    ui: &[(usize, usize)],
    ud: &[(usize, usize)],
) -> Result<MatrixElement, InputError> {
    let n = ui.len();
    let given = DMatrix::from_fn(n, n, |i, j| 0.5 * (card.matrix[i][j] + card.matrix[j][i]));
    let k = if card.is_flexibility { given.cholesky().map(|factor| factor.inverse()) } else { Some(given) };
    let Some(k) = k.filter(|k| k.iter().all(|value| value.is_finite())) else {
        let message = format!("GENEL {}: its flexibility Z is not positive definite", card.id);
        return Err(
            InputError::at(&card.span, message).with_help("a force must move its own point along itself")
        );
    };
    let motions = |of: &[(usize, usize)]| -> Vec<[(usize, f64); 3]> {
        of.iter().map(|(node, component)| motion(nodes, *node, *component)).collect()
    };
    let (ui, ud) = (motions(ui), motions(ud));
    let s = match (card.s.is_empty(), ud.is_empty()) {
        (false, _) => DMatrix::from_fn(n, ud.len(), |i, j| card.s[i][j]),
        (true, true) => DMatrix::zeros(n, 0),
        (true, false) => carried_along(card, nodes, &ui, &ud)?,
    };
    // Elastic motion: ui less what the support's motion carries along.
    let elastic = DMatrix::from_fn(n, n + ud.len(), |i, j| match j.checked_sub(n) {
        None => f64::from(u8::from(i == j)),
        Some(j) => -s[(i, j)],
    });
    let local = elastic.transpose() * k * &elastic;
    let motions = [ui, ud].concat();
    let mut dofs: Vec<usize> =
        motions.iter().flatten().filter(|(_, f)| *f != 0.0).map(|(dof, _)| *dof).collect();
    dofs.sort_unstable();
    dofs.dedup();
    let mut t = DMatrix::<f64>::zeros(motions.len(), dofs.len());
    for (row, parts) in motions.iter().enumerate() {
        for (dof, factor) in parts.iter().filter(|(_, f)| *f != 0.0) {
            t[(row, dofs.binary_search(dof).expect("every motion is in the list"))] += factor;
        }
    }
    let element = MatrixElement::spring(card.id, &dofs, &(t.transpose() * local * &t));
    let why = format!("GENEL {}: its matrix does not tell how it turns with large deflections", card.id);
    Ok(if turns_with_its_grids(&element, nodes) {
        element
    } else {
        element.turning(Corotation::Refused(why))
    })
}

/// S of a general element that leaves it out: how ui move where the six ud determine a rigid motion (QRG, GENEL).
fn carried_along(
    card: &Genel,
    nodes: &[Node],
    ui: &[[(usize, f64); 3]],
    ud: &[[(usize, f64); 3]],
) -> Result<DMatrix<f64>, InputError> {
    let points = || ui.iter().chain(ud).map(|parts| nodes[parts[0].0 / 6].point);
    let about = points().next().unwrap_or_else(Point3::origin);
    let size = points().map(|point| (point - about).norm()).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let rigid = |of: &[[(usize, f64); 3]]| -> DMatrix<f64> {
        DMatrix::from_fn(of.len(), 6, |i, rigid| {
            of[i]
                .iter()
                .map(|(dof, factor)| factor * rigid_motion(nodes, *dof, rigid, &about, size))
                .sum::<f64>()
        })
    };
    let inverse = (ud.len() == 6).then(|| rigid(ud)).and_then(|ud| {
        let singular = ud.singular_values();
        (singular.min() > 1e-9 * singular.max()).then(|| ud.try_inverse()).flatten()
    });
    inverse.map(|inverse| rigid(ui) * inverse).ok_or_else(|| {
        let message = format!("GENEL {}: without S, UD has six motions that determine a rigid one", card.id);
        InputError::at(&card.span, message)
            .with_help("give S, or six motions of UD, such as 1 to 6 of one grid")
    })
}

/// What a rigid motion (three displacements, then three rotations about `about` in units of `size`) is in a degree of freedom of
/// the g-set.
fn rigid_motion(nodes: &[Node], dof: usize, rigid: usize, about: &Point3<f64>, size: f64) -> f64 {
    let component = dof % 6;
    let unit = Vector3::ith(rigid % 3, 1.0);
    match (component < 3, rigid < 3) {
        (true, true) => unit[component],
        (true, false) => unit.cross(&(nodes[dof / 6].point - about))[component] / size,
        (false, false) => unit[component - 3] / size,
        (false, true) => 0.0,
    }
}

/// Whether the grids of an element are not in one line and a rigid motion of theirs meets no force.
fn turns_with_its_grids(element: &MatrixElement, nodes: &[Node]) -> bool {
    let (Some(k), dofs) = (element.stiffness(), element.dofs()) else { return false };
    let about = element.nodes().first().map_or_else(Point3::origin, |node| nodes[*node].point);
    let arms: Vec<Vector3<f64>> = element.nodes().iter().map(|node| nodes[*node].point - about).collect();
    let spread: Matrix3<f64> = arms.iter().map(|arm| arm * arm.transpose()).sum();
    let mut squares: Vec<f64> = spread.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    let size = squares[2].sqrt();
    // Rotations in units of the size: one unit for the whole matrix.
    let scale: Vec<f64> = dofs.iter().map(|dof| if dof % 6 < 3 { 1.0 } else { 1.0 / size }).collect();
    let scaled = DMatrix::from_fn(dofs.len(), dofs.len(), |i, j| scale[i] * k[(i, j)] * scale[j]);
    let rigid = DMatrix::from_fn(dofs.len(), 6, |i, rigid| {
        rigid_motion(nodes, dofs[i], rigid, &about, size) / scale[i]
    });
    squares[1] > 1e-6 * squares[2] && (&scaled * rigid).amax() <= 1e-6 * scaled.amax()
}

/// A mass matrix at a node, its axes the columns of `axes`.
pub(crate) fn mass_matrix(card: &Conm1, node: usize, axes: &Matrix3<f64>) -> MatrixElement {
    let mut turn = DMatrix::zeros(6, 6);
    turn.view_mut((0, 0), (3, 3)).copy_from(axes);
    turn.view_mut((3, 3), (3, 3)).copy_from(axes);
    let own = DMatrix::from_fn(6, 6, |i, j| card.mass[i][j]);
    let dofs: Vec<usize> = (0..6).map(|component| 6 * node + component).collect();
    let mass = MatrixElement::mass(card.id, &dofs, &(&turn * own * turn.transpose()));
    mass.turning(Corotation::Node(0))
}

/// Axes of a bush from its line and an orientation vector: x along, y in the plane of the vector.
pub(crate) fn line_axes(along: &Vector3<f64>, orientation: Option<&Vector3<f64>>) -> Option<Matrix3<f64>> {
    let x = along.try_normalize(0.0)?;
    let any = if x.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
    let z = x.cross(orientation.unwrap_or(&any)).try_normalize(1e-9)?;
    Some(Matrix3::from_columns(&[x, z.cross(&x), z]))
}

#[cfg(test)]
mod tests;
