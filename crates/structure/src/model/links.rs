//! Rigid elements, weighted means and constraint equations: cards to dependent motions.

use super::build::Builder;
use crate::constraints::average::{self, Member};
use crate::constraints::equation::solved_for;
use crate::constraints::{Dependent, rigid};
use nastran::InputError;

impl Builder<'_> {
    pub(super) fn dependents(&self) -> Result<Vec<Dependent>, InputError> {
        let mut all = Vec::new();
        for card in self.bulk.rigid.values() {
            let user = format!("RBE2 {}", card.id);
            let independent = self.node(card.independent, &user, &card.span)?;
            let dependent = self.nodes_of(&card.dependent, &user, &card.span)?;
            let owner = (user.as_str(), &card.span);
            all.extend(rigid::link(&self.nodes, owner, independent, &card.components, &dependent));
        }
        for card in self.bulk.rigid_bars.values() {
            let user = format!("RBAR {}", card.id);
            let a = self.node(card.grids[0], &user, &card.span)?;
            let b = self.node(card.grids[1], &user, &card.span)?;
            all.extend(rigid::bar(&self.nodes, card, [a, b])?);
        }
        self.averages(&mut all)?;
        for card in &self.bulk.equations {
            let user = format!("MPC of set {}", card.set);
            let mut equation = Vec::with_capacity(card.terms.len());
            for ((grid, component), factor) in &card.terms {
                let node = self.node(*grid, &user, &card.span)?;
                equation.push((6 * node + usize::from(*component).saturating_sub(1), *factor));
            }
            let Some((dependent, _)) = equation.first().copied() else { continue };
            all.extend(solved_for(&[equation], &[dependent], &user, &card.span)?);
        }
        Ok(all)
    }

    fn averages(&self, all: &mut Vec<Dependent>) -> Result<(), InputError> {
        for card in self.bulk.averages.values() {
            let user = format!("RBE3 {}", card.id);
            let reference = self.node(card.reference, &user, &card.span)?;
            let mut members = Vec::new();
            for group in &card.groups {
                if !(group.weight > 0.0 && group.weight.is_finite()) {
                    let message = format!("{user} has a group of weight {}", group.weight);
                    return Err(InputError::at(&card.span, message).with_help("weights are positive"));
                }
                for node in self.nodes_of(&group.grids, &user, &card.span)? {
                    members.extend(group.components.iter().map(|component| Member {
                        node,
                        component: usize::from(*component) - 1,
                        weight: group.weight,
                    }));
                }
            }
            let mut um = Vec::new();
            for (grid, components) in &card.um {
                let node = self.node(*grid, &user, &card.span)?;
                um.extend(components.iter().map(|component| 6 * node + usize::from(*component) - 1));
            }
            all.extend(average::mean(&self.nodes, card, reference, &members, &um)?);
        }
        Ok(())
    }
}
