//! A structure that bends far: forces and tangent at any state.

use super::corotated::{Corotated, Placed};
use super::joints::Joints;
use super::loads::Loads;
use super::near::Near;
use super::state::State;
use crate::assemble::{Free, free_motions};
use crate::dofs::{DofMap, Sets};
use crate::factor::{self, Analysis, Factor, Room, Scaled};
use crate::flexibility::SingularStructure;
use crate::model::{Model, Node};
use crate::sparse::{self, Mirrored, Pattern, Sparse};
use nalgebra::{DMatrix, DVector};
use nastran::InputError;
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};

/// Elements whose matrices are in memory at a time.
const BATCH: usize = 256;

/// Largest entry (m, rad) of the motion by which following loads are differenced.
const DIFFERENCE: f64 = 1e-7;

/// A structure whose deflections may be large.
#[derive(Debug, Clone)]
pub struct LargeDeflection {
    pub(super) nodes: Vec<Node>,
    pub(super) elements: Vec<Corotated>,
    /// Places of the elastic elements in the list.
    pub(super) elastic: Vec<usize>,
    /// Places of those with mass.
    massive: Vec<usize>,
    pub(super) joints: Joints,
    pub(super) pattern: Pattern,
    /// Its both triangles.
    both: Arc<Mirrored>,
    pub(super) analysis: Arc<Analysis>,
    /// Nodes that may turn about two axes and not about the third.
    pub(super) half_held: Vec<usize>,
    /// Whether the undeformed structure is held, once it was asked.
    held: OnceLock<Result<(), SingularStructure>>,
}

/// Inner forces at a state.
pub(super) struct Inner {
    /// Frames and small motions of the elastic elements.
    pub(super) placed: Vec<Placed>,
    /// K d of each.
    pub(super) local: Vec<DVector<f64>>,
    /// Their sum on the nodes, g-set.
    pub(super) forces: Vec<f64>,
}

impl LargeDeflection {
    /// Of a model. Motions without any stiffness are held, as in [`crate::System::assemble`].
    ///
    /// # Errors
    /// If rigid links contradict each other or form a circle, an element cannot tell how it turns, or the undeformed
    /// structure can move without force.
    pub fn new(model: &Model) -> Result<Self, InputError> {
        let (sets, _) = Sets::of_touched(model)?;
        let joints = Joints::of(model, &sets)?;
        let made: Result<Vec<Option<Corotated>>, InputError> =
            model.elements.par_iter().map(|element| Corotated::of(model, element)).collect();
        let elements: Vec<Corotated> = made?.into_iter().flatten().collect();
        let of = |wanted: &dyn Fn(&Corotated) -> bool| -> Vec<usize> {
            elements.iter().enumerate().filter(|(_, e)| wanted(e)).map(|(at, _)| at).collect()
        };
        let (elastic, massive) = (of(&Corotated::is_elastic), of(&|element| element.mass.is_some()));
        let map = joints.map(&joints.rows(&State::undeformed(&model.nodes)));
        let mut lists: Vec<Vec<usize>> =
            elements.iter().map(|element| free_motions(&element.dofs(), &map).list()).collect();
        lists.extend(joints.arm_dofs().iter().map(|dofs| free_motions(dofs, &map).list()));
        let pattern = Pattern::of(map.free.len(), &lists);
        let both = Arc::new(Mirrored::of(&pattern));
        let analysis = Arc::new(factor::analysed(both.symbolic()));
        let nodes = model.nodes.clone();
        let half_held = (0..nodes.len()).filter(|node| is_half_held(&map, *node)).collect();
        let held = OnceLock::new();
        Ok(Self { nodes, elements, elastic, massive, joints, pattern, both, analysis, half_held, held })
    }

    /// The undeformed state.
    pub fn undeformed(&self) -> State {
        State::undeformed(&self.nodes)
    }

    /// The grids, in the order of a state's lists.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Number of free motions.
    pub fn free_count(&self) -> usize {
        self.joints.free.len()
    }

    /// Moves the free motions (displacements and spins, own axes of the grids) on, and all that follows them.
    pub fn moved(&self, state: &State, du_f: &[f64]) -> State {
        let map = self.map(state);
        let mut state = state.clone();
        self.move_on(&mut state, &map, du_f);
        state
    }

    pub(super) fn map(&self, state: &State) -> DofMap {
        self.joints.map(&self.joints.rows(state))
    }

    /// The motion of all nodes that was made.
    pub(super) fn move_on(&self, state: &mut State, map: &DofMap, du_f: &[f64]) -> Vec<f64> {
        let du: Vec<f64> =
            map.rows.iter().map(|row| row.iter().map(|(at, factor)| factor * du_f[*at]).sum()).collect();
        state.moved(&du);
        self.joints.place(state);
        du
    }

    /// Forces (N, Nm; g-set) with which loads act on the nodes at a state.
    pub fn load_forces(&self, state: &State, loads: &Loads) -> Vec<f64> {
        let mut sum = loads.at(state);
        if loads.gravity_m_s2.norm() == 0.0 {
            return sum;
        }
        let one = |at: &usize| {
            let element = &self.elements[*at];
            let mass = element.turned(element.mass.as_ref()?, state);
            let of = |i: usize| {
                if i % element.per_node < 3 { loads.gravity_m_s2[i % element.per_node] } else { 0.0 }
            };
            Some(mass * DVector::from_fn(element.dofs().len(), |i, _| of(i)))
        };
        let weights: Vec<Option<DVector<f64>>> = self.massive.par_iter().map(one).collect();
        for (at, weight) in self.massive.iter().zip(weights) {
            for (dof, value) in self.elements[*at].dofs().into_iter().zip(weight.iter().flatten()) {
                sum[dof] += value;
            }
        }
        sum
    }

    /// What a motion of the free ones changes following loads by, with the sign of a stiffness: by the difference from those `here`,
    /// at the state itself. One side is enough for directions of Newton's method and for gains, and these are what a lattice is solved for most.
    pub(super) fn following_stiffness(
        &self,
        state: &State,
        map: &DofMap,
        near: &dyn Near,
        here: &[f64],
        v: &[f64],
    ) -> Vec<f64> {
        let size = v.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        if size == 0.0 {
            return vec![0.0; v.len()];
        }
        let step = DIFFERENCE / size;
        let motion: Vec<f64> = v.iter().map(|v| step * v).collect();
        let mut moved = state.clone();
        self.move_on(&mut moved, map, &motion);
        let there = near.following(&moved);
        let change: Vec<f64> = here.iter().zip(there).map(|(here, there)| (here - there) / step).collect();
        Self::reduced(map, &change)
    }

    /// Forces (N, Nm; g-set, moments over spins) with which the nodes hold the elements at a state.
    pub fn inner_forces(&self, state: &State) -> Vec<f64> {
        self.inner(state).forces
    }

    pub(super) fn inner(&self, state: &State) -> Inner {
        let one = |at: &usize| {
            let element = &self.elements[*at];
            let placed = element.placed(state);
            let local = element.local_force(&placed).expect("it is elastic");
            let force = element.force(&placed, &local);
            (placed, local, force)
        };
        let all: Vec<_> = self.elastic.par_iter().map(one).collect();
        let mut inner = Inner {
            placed: Vec::with_capacity(all.len()),
            local: Vec::with_capacity(all.len()),
            forces: Vec::new(),
        };
        let mut forces = vec![0.0; 6 * self.nodes.len()];
        for (at, (placed, local, force)) in self.elastic.iter().zip(all) {
            for (dof, value) in self.elements[*at].dofs().into_iter().zip(force.iter()) {
                forces[dof] += value;
            }
            inner.placed.push(placed);
            inner.local.push(local);
        }
        inner.forces = forces;
        inner
    }

    /// What the free motions are short of equilibrium by: T^T (inner forces - loads).
    pub(super) fn reduced(map: &DofMap, forces: &[f64]) -> Vec<f64> {
        let mut reduced = vec![0.0; map.free.len()];
        for (row, force) in map.rows.iter().zip(forces) {
            for (at, factor) in row {
                reduced[*at] += factor * force;
            }
        }
        reduced
    }

    /// The factor of [`Self::tangent`], scaled by the size of its diagonal; `None` if a pivot is exactly zero.
    pub(super) fn factored_tangent(
        &self,
        state: &State,
        map: &DofMap,
        placed: &[Placed],
        local: &[DVector<f64>],
        unbalanced: &[f64],
    ) -> Option<Factor> {
        let k = self.tangent(state, map, placed, local, unbalanced);
        let size: Vec<f64> = sparse::diagonal(k.as_ref()).iter().map(|d| d.abs()).collect();
        let (pattern, values) = k.into_parts();
        Factor::indefinite(&self.analysis, &Scaled::of(pattern.as_ref(), values, &size), Room::default())
    }

    /// The tangent over the free motions, its symmetric part: `local` are the forces of the geometric terms, `unbalanced` (g-set) what the
    /// arms of rigid links carry.
    pub(super) fn tangent(
        &self,
        state: &State,
        map: &DofMap,
        placed: &[Placed],
        local: &[DVector<f64>],
        unbalanced: &[f64],
    ) -> Sparse {
        let mut values = self.pattern.clone().values();
        let mut add = |free: &Free, k: &DMatrix<f64>, reduced: Option<&DMatrix<f64>>| match free {
            Free::Places(places) => values.add_where(places, Some(k), None),
            Free::Combined { dofs, .. } => values.add(dofs, reduced, None),
        };
        for first in (0..self.elastic.len()).step_by(BATCH) {
            let range = first..(first + BATCH).min(self.elastic.len());
            let one = |at: usize| {
                let element = &self.elements[self.elastic[at]];
                let k = element.tangent(&placed[at], &local[at]).expect("it is elastic");
                let k = (&k + k.transpose()) * 0.5;
                let free = free_motions(&element.dofs(), map);
                let reduced = free.reduce(Some(&k));
                (free, k, reduced)
            };
            let batch: Vec<_> = range.into_par_iter().map(one).collect();
            for (free, k, reduced) in &batch {
                add(free, k, reduced.as_ref());
            }
        }
        for (dofs, term) in self.joints.turning_arms(state, unbalanced) {
            let free = free_motions(&dofs, map);
            let reduced = free.reduce(Some(&term));
            add(&free, &term, reduced.as_ref());
        }
        values.stiffness(&self.both)
    }

    /// What the free motions are short of equilibrium by (N, Nm, own axes of the grids): elastic forces less loads.
    pub fn residual(&self, state: &State, loads: &Loads) -> Vec<f64> {
        let map = self.map(state);
        let outer = self.load_forces(state, loads);
        let short: Vec<f64> = self.inner_forces(state).iter().zip(&outer).map(|(i, o)| i - o).collect();
        Self::reduced(&map, &short)
    }

    /// The symmetric part of the tangent over the free motions, for loads fixed in space.
    pub fn stiffness(&self, state: &State, loads: &Loads) -> faer::sparse::SparseColMat<usize, f64> {
        let (map, inner) = (self.map(state), self.inner(state));
        let outer = self.load_forces(state, loads);
        let short: Vec<f64> = inner.forces.iter().zip(&outer).map(|(i, o)| i - o).collect();
        self.tangent(state, &map, &inner.placed, &inner.local, &short)
    }

    /// Forces and moments (N, Nm; g-set, own axes of the grids) that the ground gives at the clamps in equilibrium.
    pub fn reactions(&self, state: &State, loads: &Loads) -> Vec<f64> {
        let outer = self.load_forces(state, loads);
        let unbalanced: Vec<f64> = self.inner_forces(state).iter().zip(&outer).map(|(i, o)| i - o).collect();
        self.joints.reactions(state, &unbalanced)
    }

    /// The largest rotation of a node against the frame of its element, rad, and the element.
    pub(super) fn largest_local_rotation(&self, state: &State) -> (f64, u32) {
        let one = |at: &usize| (self.elements[*at].largest_turn(state), self.elements[*at].id);
        let all: Vec<(f64, u32)> = self.elastic.par_iter().map(one).collect();
        all.into_iter().fold((0.0, 0), |most, own| if own.0 > most.0 { own } else { most })
    }

    /// Grid and component of each motion that no stiffness holds in the undeformed place.
    pub(super) fn check_held(&self) -> Result<(), SingularStructure> {
        self.held.get_or_init(|| self.looked_at_held()).clone()
    }

    fn looked_at_held(&self) -> Result<(), SingularStructure> {
        let state = self.undeformed();
        let inner = self.inner(&state);
        let k = self.tangent(&state, &self.map(&state), &inner.placed, &inner.local, &inner.forces);
        let factor = Factor::held(&self.analysis, k.as_ref());
        if factor.loose.is_empty() {
            return Ok(());
        }
        let mut loose: Vec<(u32, u8)> = factor.loose.iter().map(|free| self.name(*free)).collect();
        loose.sort_unstable();
        Err(SingularStructure { loose })
    }

    /// Grid and component (1 to 6) of a free motion.
    pub fn name(&self, free: usize) -> (u32, u8) {
        let dof = self.joints.free[free];
        (self.nodes[dof / 6].id, [1, 2, 3, 4, 5, 6][dof % 6])
    }
}

/// Whether a node's rotations are two free motions.
fn is_half_held(map: &DofMap, node: usize) -> bool {
    let mut free: Vec<usize> =
        map.rows[6 * node + 3..6 * node + 6].iter().flatten().map(|(at, _)| *at).collect();
    free.sort_unstable();
    free.dedup();
    free.len() == 2
}
