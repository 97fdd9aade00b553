//! How the forces that ties carry to the free motions change as the ties turn.
//!
//! Forces on what follows go back from tie to tie. Each tie hands on what it carries by its arms, and adds what turning its arms
//! makes of it (the product rule): nothing of the whole structure's rows is made again.

use super::mean::{Blocks, blocks};
use super::{Joints, Step};
use crate::nonlinear::differences::differenced;
use crate::nonlinear::frame::Group;
use crate::nonlinear::state::State;
use nalgebra::{Matrix3, Rotation3, Vector3};

/// A force and a moment on a node, basic axes.
type Wrench = [Vector3<f64>; 2];

/// Forces on all motions, and their changes, both in the own axes of the grids.
struct Carried<'a> {
    axes: &'a [Option<Matrix3<f64>>],
    forces: Vec<f64>,
    changes: Vec<f64>,
}

impl Joints {
    /// The change of T^T F by a motion of all nodes (g-set, basic axes; dependent ones included), for forces F that stay (N, Nm; g-set,
    /// basic axes): over the free motions, own axes.
    pub(crate) fn change_of_carried(&self, state: &State, forces: &[f64], motion: &[f64]) -> Vec<f64> {
        let mut all =
            Carried { axes: &self.axes, forces: vec![0.0; forces.len()], changes: vec![0.0; forces.len()] };
        for (node, six) in forces.chunks_exact(6).enumerate() {
            all.give(node, [0, 3].map(|first| vector(six, first)), [Vector3::zeros(); 2]);
        }
        for step in self.steps.iter().rev() {
            match step {
                Step::Row { dof, row } => all.by_row(*dof, row),
                Step::Rigid { from, to, turns, .. } => {
                    let (force, change) = all.take(*to, *turns);
                    let arm = state.places[*to] - state.places[*from];
                    let moved = vector(motion, 6 * to) - vector(motion, 6 * from);
                    let turned = moved.cross(&force[0]) + arm.cross(&change[0]) + change[1];
                    all.give(*from, [force[0], force[1] + arm.cross(&force[0])], [change[0], turned]);
                }
                Step::Mean { reference, turns, members, group, .. } => {
                    let nodes: Vec<usize> = members.iter().copied().chain([*reference]).collect();
                    let taken = all.take(*reference, *turns);
                    all.by_mean(group, &nodes, state, motion, taken);
                }
            }
        }
        self.free.iter().map(|dof| all.changes[*dof]).collect()
    }
}

impl Carried<'_> {
    fn give(&mut self, node: usize, force: Wrench, change: Wrench) {
        for (list, wrench) in [(&mut self.forces, force), (&mut self.changes, change)] {
            for (first, part) in [0, 3].into_iter().zip(wrench) {
                let own = self.axes[node].map_or(part, |axes| axes.tr_mul(&part));
                (0..3).for_each(|axis| list[6 * node + first + axis] += own[axis]);
            }
        }
    }

    /// What a node hands on, with its moment or without.
    fn take(&mut self, node: usize, turns: bool) -> (Wrench, Wrench) {
        let parts = if turns { 2 } else { 1 };
        let [force, change] = [&mut self.forces, &mut self.changes].map(|list| {
            let mut wrench = [Vector3::zeros(); 2];
            for (part, wrench) in wrench.iter_mut().enumerate().take(parts) {
                let own = vector(list, 6 * node + 3 * part);
                *wrench = self.axes[node].map_or(own, |axes| axes * own);
                list[6 * node + 3 * part..][..3].fill(0.0);
            }
            wrench
        });
        (force, change)
    }

    fn by_row(&mut self, dof: usize, row: &[(usize, f64)]) {
        for list in [&mut self.forces, &mut self.changes] {
            let own = std::mem::take(&mut list[dof]);
            for (other, factor) in row {
                list[*other] += factor * own;
            }
        }
    }

    /// To the group of a mean (its nodes, the reference last) what acts on its reference: a force and its change.
    fn by_mean(
        &mut self,
        group: &Group,
        nodes: &[usize],
        state: &State,
        motion: &[f64],
        (force, change): (Wrench, Wrench),
    ) {
        let members = &nodes[..nodes.len() - 1];
        let places: Vec<_> = nodes.iter().map(|node| state.places[*node]).collect();
        let rotations: Vec<_> = members.iter().map(|node| state.rotations[*node]).collect();
        let of = |places: &[Vector3<f64>], rotations: &[Rotation3<f64>]| {
            blocks(group, &places[..members.len()], rotations, &places[members.len()])
        };
        let handed = |blocks: &[Blocks], wrench: &Wrench| -> Vec<Wrench> {
            blocks.iter().map(|blocks| blocks.handed(wrench)).collect()
        };
        let local: Vec<f64> = nodes.iter().flat_map(|node| motion[6 * node..][..6].to_vec()).collect();
        let turned = differenced(&local, |local| {
            let sixes = || local.chunks_exact(6);
            let places: Vec<_> = places.iter().zip(sixes()).map(|(at, six)| at + vector(six, 0)).collect();
            let turned =
                |(own, six): (&Rotation3<f64>, &[f64])| Rotation3::from_scaled_axis(vector(six, 3)) * own;
            let rotations: Vec<_> = rotations.iter().zip(sixes()).map(turned).collect();
            let all = handed(&of(&places, &rotations), &force);
            all.iter().flatten().flat_map(|part| [part.x, part.y, part.z]).collect()
        });
        let here = of(&places, &rotations);
        let each = handed(&here, &force).into_iter().zip(handed(&here, &change));
        for ((node, (force, change)), turned) in members.iter().zip(each).zip(turned.chunks_exact(6)) {
            self.give(*node, force, [change[0] + vector(turned, 0), change[1] + vector(turned, 3)]);
        }
    }
}

fn vector(list: &[f64], first: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&list[first..first + 3])
}
