//! Elements that are a small matrix over some motions: springs, bushes, rods, general elements, mass matrices.

use crate::corotation::Corotation;
use crate::element::Element;
use nalgebra::DMatrix;
use std::borrow::Cow;

/// A matrix over some motions.
#[derive(Debug, Clone, PartialEq)]
pub struct MatrixElement {
    id: u32,
    nodes: Vec<usize>,
    dofs: Vec<usize>,
    stiffness: Option<DMatrix<f64>>,
    mass: Option<DMatrix<f64>>,
    corotation: Corotation,
}

impl MatrixElement {
    /// A stiffness (N/m, Nm/rad) over `dofs` of the g-set; motions without any stiffness are left out.
    pub fn spring(id: u32, dofs: &[usize], stiffness: &DMatrix<f64>) -> Self {
        let (dofs, matrix) = without_empty(dofs, stiffness);
        Self {
            id,
            nodes: nodes_of(&dofs),
            dofs,
            stiffness: Some(matrix),
            mass: None,
            corotation: Corotation::Fit,
        }
    }

    /// A mass (kg, kg m^2) over `dofs` of the g-set; motions without any mass are left out.
    pub fn mass(id: u32, dofs: &[usize], mass: &DMatrix<f64>) -> Self {
        let (dofs, matrix) = without_empty(dofs, mass);
        Self {
            id,
            nodes: nodes_of(&dofs),
            dofs,
            stiffness: None,
            mass: Some(matrix),
            corotation: Corotation::Fit,
        }
    }

    /// Stiffness and mass over the same motions; those without either are left out.
    pub fn new(id: u32, dofs: &[usize], stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Self {
        let is_used = |i: &usize| [stiffness, mass].iter().any(|matrix| matrix.row(*i).amax() != 0.0);
        let used: Vec<usize> = (0..dofs.len()).filter(is_used).collect();
        let small = |matrix: &DMatrix<f64>| matrix.select_rows(&used).select_columns(&used);
        let dofs: Vec<usize> = used.iter().map(|i| dofs[*i]).collect();
        Self {
            id,
            nodes: nodes_of(&dofs),
            dofs,
            stiffness: Some(small(stiffness)),
            mass: Some(small(mass)),
            corotation: Corotation::Fit,
        }
    }

    /// The same matrices, turning in another way than with the best fit of the nodes.
    #[must_use]
    pub fn turning(self, corotation: Corotation) -> Self {
        Self { corotation, ..self }
    }
}

fn nodes_of(dofs: &[usize]) -> Vec<usize> {
    let mut nodes: Vec<usize> = dofs.iter().map(|dof| dof / 6).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

fn without_empty(dofs: &[usize], matrix: &DMatrix<f64>) -> (Vec<usize>, DMatrix<f64>) {
    let kept: Vec<usize> =
        (0..dofs.len()).filter(|i| matrix.row(*i).iter().any(|value| *value != 0.0)).collect();
    let small = DMatrix::from_fn(kept.len(), kept.len(), |i, j| {
        0.5 * (matrix[(kept[i], kept[j])] + matrix[(kept[j], kept[i])])
    });
    (kept.into_iter().map(|i| dofs[i]).collect(), small)
}

impl Element for MatrixElement {
    fn id(&self) -> u32 {
        self.id
    }
    fn nodes(&self) -> &[usize] {
        &self.nodes
    }
    fn dofs(&self) -> Vec<usize> {
        self.dofs.clone()
    }
    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        self.stiffness.as_ref().map(Cow::Borrowed)
    }
    fn is_elastic(&self) -> bool {
        self.stiffness.is_some()
    }
    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        self.mass.as_ref().map(Cow::Borrowed)
    }
    fn corotation(&self) -> Corotation {
        self.corotation.clone()
    }
}
