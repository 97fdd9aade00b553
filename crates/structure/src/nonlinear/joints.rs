//! Ties under finite rotation: what follows is placed exactly, and its spins follow by the arms of now.
//!
//! `du_g` = T(x) `du_f` over displacements and spins. A rigid arm gives dx = dx_m - [a] dw_m; a mean gives
//! the weighted displacement of its group and the spin of the group's best fit. Forces on what follows go back the same way,
//! and where a rigid arm carries the force f from its independent node, turning the arm changes its moment: [f][a] is
//! added to the tangent. The like term of a mean would fill the tangent: its products are differences (`super::adjoint`).

mod carried;
mod mean;

use super::frame::Group;
use super::state::State;
use crate::constraints::joint::Joint;
use crate::dofs::{DofMap, Sets};
use crate::model::Model;
use mean::blocks;
use nalgebra::{DMatrix, Matrix3, Vector3};
use nastran::InputError;
use std::collections::{BTreeMap, BTreeSet};

/// A motion as a combination of independent ones.
type Row = Vec<(usize, f64)>;

/// One tie, or one linear row, in the order in which they are placed.
#[derive(Debug, Clone)]
enum Step {
    Rigid { from: usize, to: usize, turns: bool, arm: Vector3<f64> },
    Mean { reference: usize, turns: bool, members: Vec<usize>, group: Group, arm: Vector3<f64> },
    Row { dof: usize, row: Row },
}

/// A linear tie: its card and nodes, whose rotations must stay small.
#[derive(Debug, Clone)]
pub(crate) struct Linear {
    pub(crate) owner: String,
    pub(crate) nodes: Vec<usize>,
}

/// Rotation up to which linear ties hold, rad.
pub(crate) const LINEAR_TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// All ties of a structure, and which motions are free.
#[derive(Debug, Clone)]
pub(crate) struct Joints {
    steps: Vec<Step>,
    pub(crate) linear: Vec<Linear>,
    pub(crate) axes: Vec<Option<Matrix3<f64>>>,
    /// Place among the free motions of each own motion.
    places: Vec<Option<usize>>,
    pub(crate) free: Vec<usize>,
    pub(crate) clamped: Vec<bool>,
}

impl Joints {
    /// Of a model with its sets; motions that no element touches are held already.
    pub(crate) fn of(model: &Model, sets: &Sets) -> Result<Self, InputError> {
        let free = sets.map().free;
        let mut places = vec![None; 6 * model.nodes.len()];
        free.iter().enumerate().for_each(|(at, dof)| places[*dof] = Some(at));
        let mut linear = Vec::new();
        let mut open: Vec<(Step, Vec<usize>, Vec<usize>)> = Vec::new();
        for tie in &model.ties {
            let rows = &model.dependents[tie.rows.clone()];
            match &tie.joint {
                Joint::Rigid { from, to, turns } => open.extend(to.iter().map(|to| {
                    let arm = model.nodes[*to].point - model.nodes[*from].point;
                    let step = Step::Rigid { from: *from, to: *to, turns: *turns, arm };
                    (step, motions(*to, if *turns { 6 } else { 3 }), motions(*from, 6))
                })),
                Joint::Mean { reference, turns, members } if mean(model, *reference, members).is_some() => {
                    let (group, arm) = mean(model, *reference, members).expect("asked just before");
                    let sources =
                        members.iter().flat_map(|(node, _, w)| motions(*node, if *w > 0.0 { 6 } else { 3 }));
                    let nodes = members.iter().map(|(node, _, _)| *node).collect();
                    let sources = sources.collect();
                    let step =
                        Step::Mean { reference: *reference, turns: *turns, members: nodes, group, arm };
                    open.push((step, motions(*reference, if *turns { 6 } else { 3 }), sources));
                }
                joint => {
                    let all =
                        rows.iter().flat_map(|row| row.row.iter().map(|(dof, _)| *dof).chain([row.dof]));
                    let nodes = all.map(|dof| dof / 6).collect();
                    if *joint != Joint::Difference {
                        linear.push(Linear { owner: tie.owner.clone(), nodes });
                    }
                    open.extend(rows.iter().map(|row| {
                        let sources = row.row.iter().map(|(dof, _)| *dof).collect();
                        (Step::Row { dof: row.dof, row: row.row.clone() }, vec![row.dof], sources)
                    }));
                }
            }
        }
        let steps = ordered(open, model)?;
        let axes = model.nodes.iter().map(|n| (n.axes != Matrix3::identity()).then_some(n.axes)).collect();
        Ok(Self { steps, linear, axes, places, free, clamped: sets.clamps().to_vec() })
    }

    /// Every motion of the g-set (basic axes) as a combination of independent ones (own axes), clamped ones among them.
    pub(crate) fn rows(&self, state: &State) -> Vec<Row> {
        let mut own: Vec<Row> = (0..self.places.len()).map(|dof| vec![(dof, 1.0)]).collect();
        for step in &self.steps {
            match step {
                Step::Row { dof, row } => {
                    own[*dof] = sum(row.iter().map(|(other, factor)| (*factor, &own[*other])));
                }
                Step::Rigid { from, to, turns, .. } => {
                    let arm = (state.places[*to] - state.places[*from]).cross_matrix();
                    let source: Vec<Row> = (0..6).map(|c| self.basic(&own, 6 * from + c)).collect();
                    let moved = (0..3).map(|i| {
                        let spins = (0..3).map(|j| (-arm[(i, j)], &source[3 + j]));
                        sum(spins.chain([(1.0, &source[i])]))
                    });
                    let mut basic: Vec<Row> = moved.collect();
                    basic.extend(source[3..if *turns { 6 } else { 3 }].iter().cloned());
                    self.store(&mut own, *to, &basic);
                }
                Step::Mean { reference, turns, members, group, .. } => {
                    let basic = self.mean_rows(&own, state, members, group, *reference);
                    self.store(&mut own, *reference, &basic[..if *turns { 6 } else { 3 }]);
                }
            }
        }
        (0..own.len()).map(|dof| self.basic(&own, dof)).collect()
    }

    /// The same over free motions only.
    pub(crate) fn map(&self, rows: &[Row]) -> DofMap {
        let to_free =
            |row: &Row| row.iter().filter_map(|(d, f)| self.places[*d].map(|at| (at, *f))).collect();
        DofMap { free: self.free.clone(), rows: rows.iter().map(to_free).collect() }
    }

    /// Places what follows where it belongs.
    pub(crate) fn place(&self, state: &mut State) {
        for step in &self.steps {
            match step {
                Step::Row { .. } => {}
                Step::Rigid { from, to, turns, arm } => {
                    state.places[*to] = state.places[*from] + state.rotations[*from] * arm;
                    if *turns {
                        state.rotations[*to] = state.rotations[*from];
                    }
                }
                Step::Mean { reference, turns, members, group, arm } => {
                    let places: Vec<_> = members.iter().map(|node| state.places[*node]).collect();
                    let rotations: Vec<_> = members.iter().map(|node| state.rotations[*node]).collect();
                    let middle = group.middle(&places);
                    let arms: Vec<_> = places.iter().map(|place| place - middle).collect();
                    let q = group.fit(&arms, &rotations).q;
                    state.places[*reference] = middle + q * arm;
                    if *turns {
                        state.rotations[*reference] = nalgebra::Rotation3::from_matrix_unchecked(q);
                    }
                }
            }
        }
    }

    /// What the ground gives at clamped motions (own axes).
    pub(crate) fn reactions(&self, state: &State, unbalanced: &[f64]) -> Vec<f64> {
        let mut reactions = vec![0.0; unbalanced.len()];
        for (row, force) in self.rows(state).iter().zip(unbalanced) {
            for (dof, factor) in row.iter().filter(|(dof, _)| self.clamped[*dof]) {
                reactions[*dof] += factor * force;
            }
        }
        reactions
    }

    /// What turning rigid arms adds to the tangent under forces on the nodes (g-set): degrees of freedom and matrix.
    pub(crate) fn turning_arms(&self, state: &State, forces: &[f64]) -> Vec<([usize; 3], DMatrix<f64>)> {
        let mut carried = forces.to_vec();
        let mut terms = Vec::new();
        for step in self.steps.iter().rev() {
            let Step::Rigid { from, to, turns, .. } = step else { continue };
            let arm = state.places[*to] - state.places[*from];
            let force = Vector3::from_column_slice(&carried[6 * to..6 * to + 3]);
            let mut moment = arm.cross(&force);
            if *turns {
                moment += Vector3::from_column_slice(&carried[6 * to + 3..6 * to + 6]);
            }
            for i in 0..3 {
                carried[6 * from + i] += force[i];
                carried[6 * from + 3 + i] += moment[i];
            }
            let term = force.cross_matrix() * arm.cross_matrix();
            let term = DMatrix::from_fn(3, 3, |i, j| 0.5 * (term[(i, j)] + term[(j, i)]));
            terms.push(([3, 4, 5].map(|c| 6 * from + c), term));
        }
        terms
    }

    /// Whether there are weighted means among them.
    pub(crate) fn has_means(&self) -> bool {
        self.steps.iter().any(|step| matches!(step, Step::Mean { .. }))
    }

    /// Nodes on whose rotations turning arms act, whatever the state.
    pub(crate) fn arm_dofs(&self) -> Vec<[usize; 3]> {
        let of = |step: &Step| match step {
            Step::Rigid { from, .. } => Some([3, 4, 5].map(|c| 6 * from + c)),
            _ => None,
        };
        self.steps.iter().filter_map(of).collect()
    }

    /// Displacement and spin of a mean's reference by the motions of its group, six rows in basic axes.
    fn mean_rows(
        &self,
        own: &[Row],
        state: &State,
        members: &[usize],
        group: &Group,
        reference: usize,
    ) -> Vec<Row> {
        let places: Vec<_> = members.iter().map(|node| state.places[*node]).collect();
        let rotations: Vec<_> = members.iter().map(|node| state.rotations[*node]).collect();
        let mut parts: Vec<Vec<(f64, Row)>> = vec![Vec::new(); 6];
        for (node, blocks) in members.iter().zip(blocks(group, &places, &rotations, &state.places[reference]))
        {
            for (first, block) in [0, 3].into_iter().zip([Some(blocks.by_place), blocks.by_spin]) {
                let Some([moved, spun]) = block else { continue };
                for j in 0..3 {
                    let row = self.basic(own, 6 * node + first + j);
                    for i in 0..3 {
                        parts[i].push((moved[(i, j)], row.clone()));
                        parts[3 + i].push((spun[(i, j)], row.clone()));
                    }
                }
            }
        }
        parts.iter().map(|parts| sum(parts.iter().map(|(factor, row)| (*factor, row)))).collect()
    }

    /// A row in basic axes from those in a node's own.
    fn basic(&self, own: &[Row], dof: usize) -> Row {
        let Some(axes) = &self.axes[dof / 6] else { return own[dof].clone() };
        sum((0..3).map(|axis| (axes[(dof % 3, axis)], &own[dof - dof % 3 + axis])))
    }

    /// Keeps rows given in basic axes in the node's own.
    fn store(&self, own: &mut [Row], node: usize, basic: &[Row]) {
        for (component, row) in basic.iter().enumerate() {
            own[6 * node + component] = match &self.axes[node] {
                None => row.clone(),
                Some(axes) => {
                    let first = component - component % 3;
                    sum((0..3).map(|i| (axes[(i, component % 3)], &basic[first + i])))
                }
            };
        }
    }
}

/// Forces and moments (g-set, own axes of the grids) that the ground gives at the clamps of the undeformed structure, from what
/// the elements ask of the nodes less the loads (N, Nm; g-set, basic axes): ties carry theirs to what they follow.
///
/// # Errors
/// As [`crate::System::assemble`].
pub fn reactions_of(model: &Model, unbalanced: &[f64]) -> Result<Vec<f64>, InputError> {
    let (sets, _) = Sets::of_touched(model)?;
    let joints = Joints::of(model, &sets)?;
    Ok(joints.reactions(&State::undeformed(&model.nodes), unbalanced))
}

/// The group of a weighted mean and the arm of its reference from the middle; nothing if places do not determine a
/// rotation.
fn mean(model: &Model, reference: usize, members: &[(usize, f64, f64)]) -> Option<(Group, Vector3<f64>)> {
    let points: Vec<_> = members.iter().map(|(node, _, _)| model.nodes[*node].point.coords).collect();
    let places = members.iter().map(|(_, weight, _)| *weight).collect();
    let rotations = members.iter().map(|(_, _, weight)| 0.5 * weight).collect();
    let group = Group::weighted(&points, places, rotations);
    let has_rotations = members.iter().any(|(_, _, weight)| *weight > 0.0);
    let arm = model.nodes[reference].point.coords - group.middle(&points);
    (has_rotations || !group.is_line()).then_some((group, arm))
}

fn motions(node: usize, count: usize) -> Vec<usize> {
    (6 * node..6 * node + count).collect()
}

/// Each after what it follows. Zero factors stay: the pattern of the matrices is the same at every state.
fn ordered(mut open: Vec<(Step, Vec<usize>, Vec<usize>)>, model: &Model) -> Result<Vec<Step>, InputError> {
    let mut waiting: BTreeSet<usize> = open.iter().flat_map(|(_, own, _)| own.iter().copied()).collect();
    let mut steps = Vec::with_capacity(open.len());
    while !open.is_empty() {
        let (ready, rest): (Vec<_>, Vec<_>) =
            open.into_iter().partition(|(_, _, sources)| !sources.iter().any(|dof| waiting.contains(dof)));
        if ready.is_empty() {
            let dof = rest[0].1[0];
            let message =
                format!("the ties of GRID {} follow each other in a circle", model.nodes[dof / 6].id);
            let help = "with large deflections a rigid element needs all motions of the node it follows";
            return Err(InputError::general(message).with_help(help));
        }
        for (step, own, _) in ready {
            waiting.retain(|dof| !own.contains(dof));
            steps.push(step);
        }
        open = rest;
    }
    Ok(steps)
}

fn sum<'a>(parts: impl Iterator<Item = (f64, &'a Row)>) -> Row {
    let mut sum: BTreeMap<usize, f64> = BTreeMap::new();
    for (factor, row) in parts {
        for (dof, f) in row {
            *sum.entry(*dof).or_default() += factor * f;
        }
    }
    sum.into_iter().collect()
}

#[cfg(test)]
mod tests;
