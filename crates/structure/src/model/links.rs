//! Rigid elements, weighted means and constraint equations: cards to dependent motions.

use super::build::Builder;
use super::registry::TieCard;
use crate::constraints::Dependent;
use crate::constraints::average::{self, Member};
use crate::constraints::equation::solved_for;
use crate::constraints::joint::{Joint, whole};
use crate::constraints::rigid::{self, NodeMotion};
use crate::constraints::spline;
use nastran::{GridComponents, InputError, Mpc, Rbe2, Rbe3, RigidBody, Rrod, Rspline};
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

impl TieCard for RigidBody {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = self.name();
        let motions = |list: &[GridComponents]| -> Result<Vec<NodeMotion>, InputError> {
            let mut motions = Vec::new();
            for (grid, components) in list {
                let node = builder.node(*grid, &user, &self.span)?;
                motions.extend(components.iter().map(|digit| (node, usize::from(*digit) - 1)));
            }
            Ok(motions)
        };
        rigid::body(&builder.nodes, self, &motions(&self.independent)?, &motions(&self.dependent)?)
    }

    fn joint(&self, builder: &Builder) -> Result<Joint, InputError> {
        let [(from, components)] = &self.independent[..] else { return Ok(Joint::Linear) };
        let turning: Option<Vec<bool>> = self.dependent.iter().map(|(_, digits)| whole(digits)).collect();
        let turns = turning
            .filter(|_| whole(components) == Some(true))
            .filter(|turning| turning.iter().all(|turns| *turns == turning[0]) && !turning.is_empty());
        let Some(turns) = turns.map(|turning| turning[0]) else { return Ok(Joint::Linear) };
        let user = self.name();
        let followers: Vec<u32> = self.dependent.iter().map(|(grid, _)| *grid).collect();
        let from = builder.node(*from, &user, &self.span)?;
        Ok(Joint::Rigid { from, to: builder.nodes_of(&followers, &user, &self.span)?, turns })
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        let grids = self.grids();
        (self.id, grids[1..].iter().map(|grid| [grids[0], *grid]).collect())
    }
}

impl TieCard for Rrod {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("RROD {}", self.id);
        let ends = builder.nodes_of(&self.grids, &user, &self.span)?;
        rigid::rod(&builder.nodes, self, [ends[0], ends[1]])
    }

    fn joint(&self, _: &Builder) -> Result<Joint, InputError> {
        Ok(Joint::Linear)
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        (self.id, vec![self.grids])
    }
}

impl TieCard for Rspline {
    fn dependents(&self, builder: &Builder) -> Result<Vec<Dependent>, InputError> {
        let user = format!("RSPLINE {}", self.id);
        let grids: Vec<u32> = self.grids.iter().map(|(grid, _)| *grid).collect();
        spline::spline(&builder.nodes, self, &builder.nodes_of(&grids, &user, &self.span)?)
    }

    fn joint(&self, _: &Builder) -> Result<Joint, InputError> {
        Ok(Joint::Linear)
    }

    fn arms(&self) -> (u32, Vec<[u32; 2]>) {
        (self.id, self.grids.windows(2).map(|pair| [pair[0].0, pair[1].0]).collect())
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
