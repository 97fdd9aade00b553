//! Degrees of freedom: which are free, and how every motion follows from the free ones.
//!
//! The g-set has six a node, in the order of the nodes, components 1 to 6, basic axes. The f-set are those of
//! them that are neither clamped nor dependent; `u_g` = T `u_f`.

use crate::model::Model;
use crate::rigid::{self, Combination};
use nastran::InputError;
use std::collections::BTreeMap;

/// The sets of a structure and the transformation T.
#[derive(Debug, Clone)]
pub(crate) struct DofMap {
    /// Position in the g-set of each free degree of freedom.
    pub(crate) free: Vec<usize>,
    /// Rows of T: the free degrees of freedom (position in the f-set) each of the g-set follows.
    pub(crate) rows: Vec<Combination>,
}

impl DofMap {
    /// The sets of a model.
    pub(crate) fn of(model: &Model) -> Result<Self, InputError> {
        let dependent = rigid::dependence(model)?;
        let mut clamped = vec![false; 6 * model.nodes.len()];
        for clamp in &model.clamps {
            for component in &clamp.components {
                let dof = 6 * clamp.node + usize::from(*component) - 1;
                if dependent.contains_key(&dof) {
                    let grid = model.nodes[clamp.node].id;
                    let message =
                        format!("GRID {grid} component {component} is clamped, but it follows a rigid link");
                    let help = "clamp the independent grid of the RBE2, or take the component out of it";
                    return Err(InputError::at(&clamp.span, message).with_help(help));
                }
                clamped[dof] = true;
            }
        }
        Ok(Self::new(&clamped, &dependent))
    }

    /// From the clamped ones and what the dependent ones follow.
    pub(crate) fn new(clamped: &[bool], dependent: &BTreeMap<usize, Combination>) -> Self {
        let is_free = |dof: &usize| !clamped[*dof] && !dependent.contains_key(dof);
        let free: Vec<usize> = (0..clamped.len()).filter(is_free).collect();
        let mut place = vec![None; clamped.len()];
        for (at, dof) in free.iter().enumerate() {
            place[*dof] = Some(at);
        }
        let to_free = |row: &Combination| -> Combination {
            row.iter().filter_map(|(dof, factor)| place[*dof].map(|at| (at, *factor))).collect()
        };
        let rows = (0..clamped.len())
            .map(|dof| match dependent.get(&dof) {
                Some(row) => to_free(row),
                None => to_free(&vec![(dof, 1.0)]),
            })
            .collect();
        Self { free, rows }
    }
}
