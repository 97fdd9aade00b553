//! Rigid elements, weighted means and constraint equations: cards to dependent motions.

use super::build::Builder;
use super::registry::TieCard;
use crate::constraints::average::{self, Member};
use crate::constraints::equation::solved_for;
use crate::constraints::{Dependent, rigid};
use nastran::{InputError, Mpc, Rbar, Rbe2, Rbe3};

impl TieCard for Rbe2 {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("RBE2 {}", self.id);
        let independent = builder.node(self.independent, &user, &self.span)?;
        let dependent = builder.nodes_of(&self.dependent, &user, &self.span)?;
        Ok(rigid::link(&builder.nodes, self, independent, &dependent))
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        (self.id, self.dependent.iter().map(|grid| [self.independent, *grid]).collect())
    }
}

impl TieCard for Rbar {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("RBAR {}", self.id);
        let a = builder.node(self.grids[0], &user, &self.span)?;
        let b = builder.node(self.grids[1], &user, &self.span)?;
        rigid::bar(&builder.nodes, self, [a, b])
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        (self.id, vec![self.grids])
    }
}

impl TieCard for Rbe3 {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("RBE3 {}", self.id);
        let reference = builder.node(self.reference, &user, &self.span)?;
        let mut members = Vec::new();
        for group in &self.groups {
            if !(group.weight > 0.0 && group.weight.is_finite()) {
                let message = format!("{user} has a group of weight {}", group.weight);
                return Err(InputError::at(&self.span, message).with_help("weights are positive"));
            }
            for node in builder.nodes_of(&group.grids, &user, &self.span)? {
                members.extend(group.components.iter().map(|component| Member {
                    node,
                    component: usize::from(*component) - 1,
                    weight: group.weight,
                }));
            }
        }
        let mut um = Vec::new();
        for (grid, components) in &self.um {
            let node = builder.node(*grid, &user, &self.span)?;
            um.extend(components.iter().map(|component| 6 * node + usize::from(*component) - 1));
        }
        average::mean(&builder.nodes, self, reference, &members, &um)
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        let grids = self.groups.iter().flat_map(|group| &group.grids);
        (self.id, grids.map(|grid| [self.reference, *grid]).collect())
    }
}

impl TieCard for Mpc {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("MPC of set {}", self.set);
        let mut equation = Vec::with_capacity(self.terms.len());
        for (motion, factor) in &self.terms {
            let (node, component) = builder.motion(*motion, &user, &self.span)?;
            equation.push((6 * node + component, *factor));
        }
        let Some((dependent, _)) = equation.first().copied() else { return Ok(Vec::new()) };
        solved_for(&[equation], &[dependent], &user, &self.span)
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        (self.set, Vec::new())
    }
}
