//! Point masses (CONM2): a rigid body fixed to a node.
//!
//! With the body's centre of gravity at r from the node, its velocity is u + theta x r, which gives the 6 x 6
//! matrix `[m E, -m [r]; m [r], I - m [r][r]]` about the node. The card's products of inertia are positive
//! integrals (I21 = int x1 x2 dm) and enter the inertia matrix with a minus sign, as in Nastran.

use crate::corotation::Corotation;
use crate::element::Element;
use nalgebra::{DMatrix, Matrix3, Point3, Vector3};
use nastran::{Conm2, Frames, InputError};
use std::borrow::Cow;

/// A rigid body at a node.
#[derive(Debug, Clone)]
pub struct PointMass {
    id: u32,
    node: [usize; 1],
    /// Components (0 to 5) that have inertia. A mere mass says nothing about rotations, which may not exist at a
    /// solid's node.
    moving: Vec<usize>,
    mass: DMatrix<f64>,
}

impl PointMass {
    /// A body of `mass_kg` whose centre is at `arm_m` from the node at position `node`, with the inertia matrix
    /// `inertia_kg_m2` about its centre; basic axes.
    pub fn new(
        id: u32,
        node: usize,
        mass_kg: f64,
        arm_m: &Vector3<f64>,
        inertia_kg_m2: &Matrix3<f64>,
    ) -> Self {
        let cross = arm_m.cross_matrix();
        let mut mass = DMatrix::zeros(6, 6);
        mass.view_mut((0, 0), (3, 3)).copy_from(&(Matrix3::identity() * mass_kg));
        mass.view_mut((0, 3), (3, 3)).copy_from(&(-cross * mass_kg));
        mass.view_mut((3, 0), (3, 3)).copy_from(&(cross * mass_kg));
        mass.view_mut((3, 3), (3, 3)).copy_from(&(inertia_kg_m2 - cross * cross * mass_kg));
        let moving: Vec<usize> = (0..6).filter(|i| mass.row(*i).iter().any(|value| *value != 0.0)).collect();
        let mass = DMatrix::from_fn(moving.len(), moving.len(), |i, j| mass[(moving[i], moving[j])]);
        Self { id, node: [node], moving, mass }
    }

    /// From a card; `node` is the position of its grid, `point` the grid's place in the basic system.
    ///
    /// # Errors
    /// If its coordinate system is not there, its mass is negative or its inertia no number.
    pub fn from_card(
        card: &Conm2,
        node: usize,
        point: &Point3<f64>,
        frames: &Frames,
    ) -> Result<Self, InputError> {
        if card.mass < 0.0 {
            let message = format!("CONM2 {} has the negative mass {}", card.id, card.mass);
            return Err(InputError::at(&card.span, message).with_help("a mass is zero or positive"));
        }
        let [i11, i21, i22, i31, i32, i33] = card.inertia;
        let own = Matrix3::new(i11, -i21, -i31, -i21, i22, -i32, -i31, -i32, i33);
        say_of_inertia(card, &own)?;
        let offset = card.offset;
        let Ok(cid) = u32::try_from(card.cid) else {
            // -1: the offset is the centre itself, in the basic system.
            return Ok(Self::new(card.id, node, card.mass, &(offset - point.coords), &own));
        };
        let axes = frames.axes_at_point(cid, point, &card.span)?;
        Ok(Self::new(card.id, node, card.mass, &(axes * offset), &(axes * own * axes.transpose())))
    }
}

/// An inertia that no body has is computed with and said, as Nastran does: what several cards or a rigid element sum up to may
/// well be a body's.
fn say_of_inertia(card: &Conm2, inertia: &Matrix3<f64>) -> Result<(), InputError> {
    if !inertia.norm().is_finite() {
        let message = format!("CONM2 {}: its inertia is beyond floating-point numbers", card.id);
        return Err(InputError::at(&card.span, message).with_help("look for an exponent too many"));
    }
    let least = inertia.symmetric_eigenvalues().min();
    if least < -1e-9 * inertia.norm() {
        tracing::warn!(
            "{}: CONM2 {} has an inertia with the negative principal value {least:.3e}, which no body has; I11, I22, I33 are about \
             the centre of gravity, not the grid, and I21, I31, I32 are positive integrals",
            card.span,
            card.id
        );
    }
    Ok(())
}

impl Element for PointMass {
    fn id(&self) -> u32 {
        self.id
    }
    fn nodes(&self) -> &[usize] {
        &self.node
    }
    fn dofs(&self) -> Vec<usize> {
        self.moving.iter().map(|component| 6 * self.node[0] + component).collect()
    }
    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        None
    }
    fn is_elastic(&self) -> bool {
        false
    }
    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        Some(Cow::Borrowed(&self.mass))
    }
    fn corotation(&self) -> Corotation {
        Corotation::Node(0)
    }
}
