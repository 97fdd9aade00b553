//! Degrees of freedom: which are free, and how every motion follows from the free ones.
//!
//! The g-set has six a node, in the order of the nodes, components 1 to 6, basic axes. The f-set are the motions, in
//! the axes of each grid's displacement system, that are neither clamped nor dependent; `u_g` = T `u_f`.

use crate::constraints::{self, Combination};
use crate::model::{Model, Node};
use nalgebra::Matrix3;
use nastran::InputError;
use std::collections::BTreeMap;

/// Cosines of displacement axes and basic ones below this are round-off.
const ROUND_OFF: f64 = 1e-12;

/// The sets of a structure and the transformation T.
#[derive(Debug, Clone)]
pub(crate) struct DofMap {
    /// Each free motion: 6 * node + component - 1, in the grid's own axes.
    pub(crate) free: Vec<usize>,
    /// Rows of T: the free motions (position in the f-set) each degree of freedom of the g-set follows.
    pub(crate) rows: Vec<Combination>,
}

impl DofMap {
    /// Whether every motion is either free or clamped: none follows others.
    pub(crate) fn only_clamps(&self) -> bool {
        let is_own = |(dof, row): (usize, &Combination)| match row.as_slice() {
            [] => true,
            [(at, factor)] => self.free[*at] == dof && *factor == 1.0,
            _ => false,
        };
        self.rows.iter().enumerate().all(is_own)
    }
}

/// What a model says about its motions, before anything is known about stiffness.
#[derive(Debug, Clone)]
pub(crate) struct Sets {
    clamped: Vec<bool>,
    dependent: BTreeMap<usize, Combination>,
    axes: Vec<Option<Matrix3<f64>>>,
}

impl Sets {
    /// Of a model.
    pub(crate) fn of(model: &Model) -> Result<Self, InputError> {
        let dependent = constraints::resolved(&model.nodes, &model.dependents)?;
        let mut clamped = vec![false; 6 * model.nodes.len()];
        for clamp in &model.clamps {
            for component in &clamp.components {
                let dof = 6 * clamp.node + usize::from(*component) - 1;
                if dependent.contains_key(&dof) {
                    let grid = model.nodes[clamp.node].id;
                    let message =
                        format!("GRID {grid} component {component} is clamped, but it follows a rigid link");
                    let help =
                        "clamp what it follows (the independent grid), or take the component out of the link";
                    return Err(InputError::at(&clamp.span, message).with_help(help));
                }
                clamped[dof] = true;
            }
        }
        Ok(Self { clamped, dependent, axes: model.nodes.iter().map(turned).collect() })
    }

    /// Which motions are clamped or held.
    pub(crate) fn clamps(&self) -> &[bool] {
        &self.clamped
    }

    /// Clamped motions only, basic axes.
    pub(crate) fn clamped(clamped: Vec<bool>) -> Self {
        let axes = vec![None; clamped.len() / 6];
        Self { clamped, dependent: BTreeMap::new(), axes }
    }

    /// Of a model, what no element touches held; and for each motion whether it is touched or follows others.
    pub(crate) fn of_touched(model: &Model) -> Result<(Self, Vec<bool>), InputError> {
        let mut sets = Self::of(model)?;
        let mut touched = vec![false; 6 * model.nodes.len()];
        for element in model.elements() {
            element.dofs().into_iter().for_each(|dof| touched[dof] = true);
        }
        let touched = sets.hold_untouched(|dof| touched[dof]);
        Ok((sets, touched))
    }

    /// Holds motions that nothing touches: `is_touched` tells of a degree of freedom of the g-set (basic axes)
    /// whether an element has stiffness or mass there; along turned axes a motion is touched that has a part of a touched one. A
    /// motion that another one follows counts as touched. Gives for each motion whether it is touched or follows others.
    fn hold_untouched(&mut self, is_touched: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut touched = vec![false; self.clamped.len()];
        for (dof, mark) in touched.iter_mut().enumerate() {
            *mark = match &self.axes[dof / 6] {
                Some(axes) => (0..3).any(|basic| {
                    axes[(basic, dof % 3)].abs() > ROUND_OFF && is_touched(dof - dof % 3 + basic)
                }),
                None => is_touched(dof),
            };
        }
        for (dof, row) in &self.dependent {
            if touched[*dof] {
                for (source, _) in row {
                    touched[*source] = true;
                }
            }
        }
        // Dependent motions follow what they follow, touched or not.
        for dof in self.dependent.keys() {
            touched[*dof] = true;
        }
        for (clamped, touched) in self.clamped.iter_mut().zip(&touched) {
            *clamped |= !touched;
        }
        touched
    }

    /// The free motions and T.
    pub(crate) fn map(&self) -> DofMap {
        let is_free = |dof: &usize| !self.clamped[*dof] && !self.dependent.contains_key(dof);
        let free: Vec<usize> = (0..self.clamped.len()).filter(is_free).collect();
        let mut place = vec![None; self.clamped.len()];
        for (at, dof) in free.iter().enumerate() {
            place[*dof] = Some(at);
        }
        let to_free = |row: &[(usize, f64)]| -> Combination {
            row.iter().filter_map(|(dof, factor)| place[*dof].map(|at| (at, *factor))).collect()
        };
        let own: Vec<Combination> = (0..self.clamped.len())
            .map(|dof| self.dependent.get(&dof).map_or_else(|| to_free(&[(dof, 1.0)]), |row| to_free(row)))
            .collect();
        let rows = (0..own.len()).map(|dof| self.basic(&own, dof)).collect();
        DofMap { free, rows }
    }

    /// A row of T in basic axes from the rows in the grid's own axes.
    fn basic(&self, own: &[Combination], dof: usize) -> Combination {
        let Some(axes) = &self.axes[dof / 6] else { return own[dof].clone() };
        let mut sum: BTreeMap<usize, f64> = BTreeMap::new();
        for axis in 0..3 {
            let share = axes[(dof % 3, axis)];
            for (at, factor) in &own[dof - dof % 3 + axis] {
                *sum.entry(*at).or_default() += share * factor;
            }
        }
        sum.into_iter().filter(|(_, factor)| *factor != 0.0).collect()
    }
}

/// A node's displacement axes, if they are not the basic ones.
fn turned(node: &Node) -> Option<Matrix3<f64>> {
    (node.axes != Matrix3::identity()).then_some(node.axes)
}
