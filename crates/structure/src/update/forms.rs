//! Quadratic forms of a region's elements: x^T `A_p` y, element by element, without assembling `A_p`.

use super::measurements::{Parameter, Quantity};
use crate::assemble;
use crate::model::Model;
use faer::MatRef;
use nalgebra::DVector;
use rayon::prelude::*;

/// `left_j^T A_p right_j` for each column j; g-set motions in the columns.
pub(super) fn forms(
    model: &Model,
    parameter: &Parameter,
    left: MatRef<'_, f64>,
    right: MatRef<'_, f64>,
) -> Vec<f64> {
    let of_element = |place: &usize| -> Vec<f64> {
        let element = &model.elements[*place];
        let dofs = element.dofs();
        let [k, m] = assemble::matrices(model, element, &dofs);
        let matrix = match parameter.quantity {
            Quantity::Stiffness => k,
            Quantity::Mass => m,
        };
        let Some(matrix) = matrix else { return vec![0.0; left.ncols()] };
        let own = |motions: MatRef<'_, f64>, j: usize| {
            DVector::from_iterator(dofs.len(), dofs.iter().map(|dof| motions[(*dof, j)]))
        };
        (0..left.ncols()).map(|j| own(left, j).dot(&(&matrix * own(right, j)))).collect()
    };
    let parts: Vec<Vec<f64>> = parameter.elements.par_iter().map(of_element).collect();
    let mut sums = vec![0.0; left.ncols()];
    // In the order of the elements: the same on any number of threads.
    for part in parts {
        for (sum, value) in sums.iter_mut().zip(part) {
            *sum += value;
        }
    }
    sums
}
