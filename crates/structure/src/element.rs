//! What every finite element is to the rest of the crate: motions it joins, a stiffness and a mass.
//!
//! Assembly, flexibility and modes know only this; a new kind of element is a new file that implements it and
//! one line in `model/registry.rs` (the crate's README shows how). Matrices may be computed when they are asked for (a solid's would fill the memory
//! of a large model) or kept.

use crate::corotation::Corotation;
use nalgebra::{DMatrix, Vector3};
use std::borrow::Cow;
use std::fmt::Debug;

/// A finite element.
pub trait Element: Debug + Send + Sync {
    /// Identification number, for messages.
    fn id(&self) -> u32;
    /// Positions of its nodes in the model's list of nodes.
    fn nodes(&self) -> &[usize];
    /// The motions its matrices belong to, as degrees of freedom of the g-set (6 * node + component - 1, basic axes).
    /// By default all six of each node, in the order of the nodes.
    fn dofs(&self) -> Vec<usize> {
        self.nodes().iter().flat_map(|node| (0..6).map(move |component| 6 * node + component)).collect()
    }
    /// Stiffness over [`Element::dofs`], N/m and Nm/rad, symmetric; `None` if it has none.
    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>>;
    /// Whether it has a stiffness, which need not be computed to say so.
    fn is_elastic(&self) -> bool {
        true
    }
    /// Mass over [`Element::dofs`], kg and kg m^2, symmetric; `None` if it has none.
    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>>;
    /// Mass as points at its ends, if the element knows better than the sums of [`Element::mass`]'s rows (off the grids, by offsets,
    /// points have inertia about them) or has these sums without it.
    fn lumped_mass(&self) -> Option<DMatrix<f64>> {
        None
    }

    /// Of a shell, the unit normal at each of its nodes (basic axes): what bends is the tilt of it, while rotations about it meet next to nothing.
    fn directors(&self) -> Vec<Vector3<f64>> {
        Vec::new()
    }

    /// How it turns with nodes that turn far.
    fn corotation(&self) -> Corotation {
        Corotation::Fit
    }
}
