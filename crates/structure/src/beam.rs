//! Three-dimensional beam element (CBAR, CBEAM), built from the flexibility of its sections.
//!
//! With end A held, loads at end B give section forces by equilibrium alone, s(x) = H(x) p; the flexibility of
//! end B is F = L int H^T f H dx/L with the section flexibility f, and K = G^T F^-1 G, where G u is the
//! displacement of B relative to the rigid motion of A (Przemieniecki, *Theory of Matrix Structural Analysis*,
//! ch. 5-6). This is the Euler-Bernoulli (with shear factors: Timoshenko) element for a uniform section, and for
//! a tapered one it is the exact solution up to the quadrature, where averaged stations would only converge.
//!
//! Element axes: x from end A to end B (after the offsets), y in plane 1, the plane of x and the orientation
//! vector, z = x x y. I1 resists bending in plane 1, I2 in plane 2 (x-z). Pin flags are released at the element's
//! ends, in element axes, by static condensation. The neutral axis' offset from the shear centre acts with the
//! mean of its values at A and B.

use crate::beam_mass;
use crate::element::Element;
use crate::section::Section;
use nalgebra::{DMatrix, Matrix3, Matrix6, Point3, SMatrix, SVector, Vector3};
use nastran::{BeamProperty, InputError, Mat1, Span};
use std::borrow::Cow;

pub(crate) type Matrix12 = SMatrix<f64, 12, 12>;

/// How a beam stands in space; everything in basic axes.
#[derive(Debug, Clone, PartialEq)]
pub struct BeamPlacement {
    /// The grids of ends A and B.
    pub grids: [Point3<f64>; 2],
    /// Offsets from the grids to the element's ends.
    pub offsets: [Vector3<f64>; 2],
    /// Orientation vector: with the element axis it spans plane 1. Its length does not matter.
    pub orientation: Vector3<f64>,
    /// Released components at A and B in element axes, digits 1 to 6.
    pub pins: [Vec<u8>; 2],
}

/// A beam element with its matrices at the grids, basic axes.
#[derive(Debug, Clone)]
pub struct Beam {
    id: u32,
    nodes: [usize; 2],
    length_m: f64,
    axes: Matrix3<f64>,
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    lumped_mass: DMatrix<f64>,
}

impl Beam {
    /// Builds the element between the nodes at positions `nodes` of the model. `span` is the element's card.
    ///
    /// # Errors
    /// If the element has no length, its orientation vector is along it, or its section or material is impossible.
    pub fn new(
        id: u32,
        nodes: [usize; 2],
        placement: &BeamPlacement,
        property: &BeamProperty,
        material: &Mat1,
        span: &Span,
    ) -> Result<Self, InputError> {
        let section = Section { property, material };
        section.check()?;
        let (length_m, axes) = element_axes(id, placement, span)?;
        let local = stiffness(section, length_m).ok_or_else(|| {
            InputError::at(span, format!("beam {id}: its stiffness cannot be computed"))
                .with_help("look for a property or material many orders of magnitude off")
        })?;
        let local = release(local, &placement.pins, &mut SVector::zeros());
        let to_local = grid_to_element(&axes, &placement.offsets);
        Ok(Self {
            id,
            nodes,
            length_m,
            axes,
            stiffness: at_grids(&local, &to_local),
            mass: at_grids(&beam_mass::consistent(section, length_m), &to_local),
            lumped_mass: at_grids(&beam_mass::lumped(section, length_m, property.is_beam), &to_local),
        })
    }

    /// The same with Nastran's masses: bars have twisting inertia only where `bars_twist`.
    pub(crate) fn with_nastran_masses(
        self,
        placement: &BeamPlacement,
        property: &BeamProperty,
        material: &Mat1,
        bars_twist: bool,
    ) -> Self {
        let to_local = grid_to_element(&self.axes, &placement.offsets);
        let (section, has_twisting) = (Section { property, material }, property.is_beam || bars_twist);
        let consistent = beam_mass::as_nastran(section, self.length_m, has_twisting);
        let lumped = beam_mass::lumped(section, self.length_m, has_twisting);
        Self { mass: at_grids(&consistent, &to_local), lumped_mass: at_grids(&lumped, &to_local), ..self }
    }

    /// Length between the element's ends, m.
    pub fn length_m(&self) -> f64 {
        self.length_m
    }

    /// The element's axes x, y, z as columns, basic system.
    pub fn axes(&self) -> &Matrix3<f64> {
        &self.axes
    }
}

impl Element for Beam {
    fn id(&self) -> u32 {
        self.id
    }
    fn nodes(&self) -> &[usize] {
        &self.nodes
    }
    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        Some(Cow::Borrowed(&self.stiffness))
    }
    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        Some(Cow::Borrowed(&self.mass))
    }
    fn lumped_mass(&self) -> Option<DMatrix<f64>> {
        Some(self.lumped_mass.clone())
    }
}

/// Length and axes (x, y, z as columns, basic system) of an element.
///
/// # Errors
/// If it has no length, or its orientation vector is along it.
pub(crate) fn element_axes(
    id: u32,
    placement: &BeamPlacement,
    span: &Span,
) -> Result<(f64, Matrix3<f64>), InputError> {
    let [a, b] = [0, 1].map(|end| placement.grids[end] + placement.offsets[end]);
    let along = b - a;
    let length = along.norm();
    let scale = a.coords.norm().max(b.coords.norm());
    if length <= 1e-12 * scale || !length.is_finite() {
        let message = format!("beam {id} has no length: both ends are at ({}, {}, {})", a.x, a.y, a.z);
        return Err(InputError::at(span, message).with_help("check its two grids and the offset vectors"));
    }
    let x = along / length;
    let normal = x.cross(&placement.orientation);
    let sine = normal.norm() / placement.orientation.norm();
    if sine < 1e-8 || !sine.is_finite() {
        let v = placement.orientation;
        let message =
            format!("beam {id}: orientation vector ({}, {}, {}) is zero or along the beam", v.x, v.y, v.z);
        let help = "give a vector that spans bending plane 1 together with the element axis";
        return Err(InputError::at(span, message).with_help(help));
    }
    let z = normal.normalize();
    Ok((length, Matrix3::from_columns(&[x, z.cross(&x), z])))
}

/// Section forces by loads so far outboard on the element's axis.
pub(crate) fn section_forces(section: Section, arm: f64) -> Matrix6<f64> {
    let offset = 0.5 * (section.neutral_axis(0.0) + section.neutral_axis(1.0));
    let mut forces = Matrix6::identity();
    forces[(4, 2)] = -arm;
    forces[(5, 1)] = arm;
    forces[(4, 0)] = -offset.y;
    forces[(5, 0)] = offset.x;
    forces
}

/// Stiffness of end B with end A held, or `None` if the flexibility cannot be inverted in floating-point numbers.
pub(crate) fn end_stiffness(section: Section, length: f64) -> Option<Matrix6<f64>> {
    let offset = 0.5 * (section.neutral_axis(0.0) + section.neutral_axis(1.0));
    let mut flexibility = Matrix6::<f64>::zeros();
    for (x, weight) in section.quadrature() {
        let forces = section_forces(section, (1.0 - x) * length);
        flexibility += forces.transpose() * section.flexibility(x) * forces * (weight * length);
    }
    let mut carried = section.carried();
    // Without bending stiffness a force off the neutral axis is not carried either.
    carried[0] &= (carried[1] || offset.x == 0.0) && (carried[2] || offset.y == 0.0);
    for (component, kept) in carried.iter().enumerate() {
        if !kept {
            flexibility.row_mut(component).fill(0.0);
            flexibility.column_mut(component).fill(0.0);
            flexibility[(component, component)] = 1.0;
        }
    }
    // Scaled by the diagonal: forces and moments, slender and stout parts differ by many orders.
    let scale = flexibility.diagonal().map(|f| 1.0 / f.sqrt());
    let scaled = Matrix6::from_fn(|i, j| scale[i] * flexibility[(i, j)] * scale[j]);
    let inverse = scaled.cholesky()?.inverse();
    let kept = |i, j| if carried[i] && carried[j] { scale[i] * inverse[(i, j)] * scale[j] } else { 0.0 };
    Some(Matrix6::from_fn(kept))
}

/// Local stiffness, or `None` if the flexibility cannot be inverted in floating-point numbers.
pub(crate) fn stiffness(section: Section, length: f64) -> Option<Matrix12> {
    let end_b = end_stiffness(section, length)?;
    let mut relative = SMatrix::<f64, 6, 12>::zeros();
    for i in 0..6 {
        relative[(i, i)] = -1.0;
        relative[(i, 6 + i)] = 1.0;
    }
    relative[(1, 5)] = -length;
    relative[(2, 4)] = length;
    let k = relative.transpose() * end_b * relative;
    k.iter().all(|value| value.is_finite()).then_some(k)
}

/// Static condensation of the released components, one after the other; a component that has already lost its
/// stiffness (both ends of a bar free to twist) stays without. What `load` has there goes to the other components.
pub(crate) fn release(mut k: Matrix12, pins: &[Vec<u8>; 2], load: &mut SVector<f64, 12>) -> Matrix12 {
    let original = k.diagonal();
    for (end, components) in pins.iter().enumerate() {
        for component in components.iter().filter(|c| (1..=6).contains(*c)) {
            let p = 6 * end + usize::from(*component) - 1;
            if k[(p, p)] > 1e-10 * original[p] {
                let column = k.column(p).into_owned();
                *load -= column * (load[p] / column[p]);
                k -= column * column.transpose() / column[p];
            }
            k.row_mut(p).fill(0.0);
            k.column_mut(p).fill(0.0);
        }
    }
    k
}

/// Displacements of the element's ends in element axes from those of the grids in basic axes.
pub(crate) fn grid_to_element(axes: &Matrix3<f64>, offsets: &[Vector3<f64>; 2]) -> Matrix12 {
    let mut t = Matrix12::zeros();
    let to_local = axes.transpose();
    for (end, offset) in offsets.iter().enumerate() {
        let at = 6 * end;
        // u_end = u + theta x w = u - [w] theta
        t.fixed_view_mut::<3, 3>(at, at).copy_from(&to_local);
        t.fixed_view_mut::<3, 3>(at, at + 3).copy_from(&(-to_local * offset.cross_matrix()));
        t.fixed_view_mut::<3, 3>(at + 3, at + 3).copy_from(&to_local);
    }
    t
}

fn at_grids(local: &Matrix12, to_local: &Matrix12) -> DMatrix<f64> {
    let full = to_local.transpose() * local * to_local;
    DMatrix::from_fn(12, 12, |i, j| 0.5 * (full[(i, j)] + full[(j, i)]))
}
