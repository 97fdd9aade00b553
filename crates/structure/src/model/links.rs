//! Rigid elements, weighted means and constraint equations: cards to dependent motions.

use super::build::Builder;
use super::registry::TieCard;
use crate::constraints::average::{self, Member};
use crate::constraints::equation::solved_for;
use crate::constraints::joint::{Joint, whole};
use crate::constraints::{Dependent, rigid};
use nastran::{InputError, Mpc, Rbar, Rbe2, Rbe3};
use std::collections::BTreeSet;

impl TieCard for Rbe2 {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("RBE2 {}", self.id);
        let independent = builder.node(self.independent, &user, &self.span)?;
        let dependent = builder.nodes_of(&self.dependent, &user, &self.span)?;
        Ok(rigid::link(&builder.nodes, self, independent, &dependent))
    }

    fn joint(&self, builder: &Builder) -> Result<Joint, InputError> {
        let user = format!("RBE2 {}", self.id);
        let Some(turns) = whole(&self.components) else { return Ok(Joint::Linear) };
        let from = builder.node(self.independent, &user, &self.span)?;
        Ok(Joint::Rigid { from, to: builder.nodes_of(&self.dependent, &user, &self.span)?, turns })
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

    fn joint(&self, builder: &Builder) -> Result<Joint, InputError> {
        let user = format!("RBAR {}", self.id);
        let Some(end) = (0..2).find(|end| whole(&self.independent[*end]) == Some(true)) else {
            return Ok(Joint::Linear);
        };
        let dependent = &self.dependent[1 - end];
        let turns = if dependent.is_empty() { Some(true) } else { whole(dependent) };
        let Some(turns) = turns.filter(|_| self.dependent[end].is_empty()) else { return Ok(Joint::Linear) };
        let from = builder.node(self.grids[end], &user, &self.span)?;
        Ok(Joint::Rigid { from, to: vec![builder.node(self.grids[1 - end], &user, &self.span)?], turns })
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

    fn joint(&self, builder: &Builder) -> Result<Joint, InputError> {
        let user = format!("RBE3 {}", self.id);
        let groups: Option<Vec<bool>> = self.groups.iter().map(|group| whole(&group.components)).collect();
        let (Some(turns), Some(turning)) = (whole(&self.components), groups) else {
            return Ok(Joint::Linear);
        };
        if !self.um.is_empty() {
            return Ok(Joint::Linear);
        }
        let reference = builder.node(self.reference, &user, &self.span)?;
        let mut members = Vec::new();
        for (group, has_rotations) in self.groups.iter().zip(turning) {
            for node in builder.nodes_of(&group.grids, &user, &self.span)? {
                members.push((node, group.weight, if has_rotations { group.weight } else { 0.0 }));
            }
        }
        let about = builder.nodes[reference].point;
        let grids: BTreeSet<usize> = members.iter().map(|(node, _, _)| *node).collect();
        let distances = grids.iter().map(|node| (builder.nodes[*node].point - about).norm());
        let square = average::mean_radius(distances).powi(2);
        for (_, _, weight) in &mut members {
            *weight *= square;
        }
        Ok(Joint::Mean { reference, turns, members })
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

    fn joint(&self, builder: &Builder) -> Result<Joint, InputError> {
        let user = format!("MPC of set {}", self.set);
        let mut sum = 0.0;
        let mut first = None;
        for ((grid, component), factor) in &self.terms {
            let axes = builder.nodes[builder.node(*grid, &user, &self.span)?].axes;
            let own = (*component, axes);
            if !(1..=3).contains(component) || *first.get_or_insert(own) != own {
                return Ok(Joint::Linear);
            }
            sum += factor;
        }
        let is_difference = sum.abs() <= 1e-12 * self.terms.iter().map(|(_, f)| f.abs()).sum::<f64>();
        Ok(if is_difference { Joint::Difference } else { Joint::Linear })
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        (self.set, Vec::new())
    }
}
