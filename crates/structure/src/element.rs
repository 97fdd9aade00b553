//! What every finite element is to the rest of the crate: nodes, a stiffness and a mass.
//!
//! Assembly, flexibility and modes know only this; a new kind of element is a new file that implements it and
//! one line in [`crate::Model`].

use nalgebra::DMatrix;

/// A finite element with six degrees of freedom a node (three displacements, three rotations, basic axes).
pub trait Element {
    /// Identification number, for messages.
    fn id(&self) -> u32;
    /// Positions of its nodes in the model's list of nodes.
    fn nodes(&self) -> &[usize];
    /// Stiffness, 6 n x 6 n for n nodes, N/m and Nm/rad, symmetric; `None` if it has none.
    fn stiffness(&self) -> Option<&DMatrix<f64>>;
    /// Mass, 6 n x 6 n, kg and kg m^2, symmetric; `None` if it has none.
    fn mass(&self) -> Option<&DMatrix<f64>>;
}
