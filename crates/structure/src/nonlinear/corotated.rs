//! An element carried by its frame: force and exact tangent at any places and rotations of its nodes.
//!
//! With the frame Q, x the arms from the middle and d = (Q^T x - X, theta(Q^T R)) the small motion, the energy is d^T K d / 2; theta is the
//! rotation vector, in shells tilt and twist of the normal (`rotation.rs`). Its
//! change gives f = T P^T H^T K d, T = diag(Q), H = diag(1, L), and P = 1 - U V^T, which takes the rigid part off a
//! motion: U the six rigid motions about the middle, V the mean displacement and the frame's spin G. The tangent is
//!
//! T (P^T (H^T K H + diag(0, l - N)) P - F_nm G - G^T F_n^T P) T^T
//!
//! with l the change of L^T m by the node's spin (Nour-Omid and Rankin 1991). N is what G changes by where rotations of nodes
//! have a say about the frame; with it the tangent is exact for every frame and at any strain.

use super::frame::{Fit, Group, spin_of_rotation};
use super::rotation::{Measure, Turn, axial};
use super::state::State;
use crate::assemble;
use crate::corotation::Corotation;
use crate::element::Element;
use crate::model::Model;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use nastran::InputError;
use std::sync::Arc;

/// What an element's displacements are measured from.
#[derive(Debug, Clone)]
enum Frame {
    Moving(Group),
    /// Fixed axes; rotations of the nodes up to so many rad.
    Fixed(f64),
}

/// Rotations that an element in fixed axes may see, rad.
const SMALL_TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// Rotations that an element on the ground may see: their vector ends at half a turn, rad.
const HALF_TURN: f64 = 170.0 * std::f64::consts::PI / 180.0;

/// An element with its matrices over all motions of its nodes: three a node if rotations have no part in it, else six.
#[derive(Debug, Clone)]
pub(crate) struct Corotated {
    pub(crate) id: u32,
    pub(crate) nodes: Vec<usize>,
    pub(crate) per_node: usize,
    points: Vec<Vector3<f64>>,
    frame: Frame,
    /// How rotations are measured, node by node; the logarithm beyond the list.
    measures: Vec<Measure>,
    k: Option<DMatrix<f64>>,
    pub(crate) mass: Option<DMatrix<f64>>,
}

/// An element at a state: its frame and its small motion.
pub(crate) struct Placed {
    pub(super) q: Matrix3<f64>,
    /// Q^T x.
    arms: Vec<Vector3<f64>>,
    /// Q^T R, of elements with rotations.
    turns: Vec<Turn>,
    fit: Option<Fit>,
    /// d.
    pub(crate) motion: DVector<f64>,
}

impl Corotated {
    /// Of an element of a model; nothing for one without stiffness and mass.
    pub(crate) fn of(model: &Model, element: &Arc<dyn Element>) -> Result<Option<Self>, InputError> {
        let dofs = element.dofs();
        let nodes = element.nodes().to_vec();
        let [k, mass] = assemble::matrices(model, element, &dofs);
        if k.is_none() && mass.is_none() {
            return Ok(None);
        }
        let points: Vec<Vector3<f64>> = nodes.iter().map(|node| model.nodes[*node].point.coords).collect();
        // What turns with a node hangs on its rotation, though its matrices may be over displacements alone.
        let turns_with_node = matches!(element.corotation(), Corotation::Node(_));
        let per_node = if turns_with_node || dofs.iter().any(|dof| dof % 6 > 2) { 6 } else { 3 };
        let frame = match element.corotation() {
            Corotation::Fit => Frame::Moving(Group::of(&points, per_node == 6)),
            Corotation::Node(node) => Frame::Moving(Group::with_node(&points, node)),
            Corotation::Ground => Frame::Fixed(HALF_TURN),
            Corotation::Axes => Frame::Fixed(SMALL_TURN),
            Corotation::Refused(why) => {
                let help = "analyse it with small deflections, or model the part by elements";
                return Err(InputError::general(why).with_help(help));
            }
        };
        let place = |dof: &usize| {
            let node = nodes.iter().position(|node| *node == dof / 6).expect("dofs are of the nodes");
            per_node * node + dof % 6
        };
        let places: Vec<usize> = dofs.iter().map(place).collect();
        let size = per_node * nodes.len();
        let whole = |matrix: DMatrix<f64>| {
            let mut whole = DMatrix::zeros(size, size);
            for (j, column) in places.iter().enumerate() {
                for (i, row) in places.iter().enumerate() {
                    whole[(*row, *column)] += matrix[(i, j)];
                }
            }
            whole
        };
        let (k, mass) = (k.map(whole), mass.map(whole));
        let measures = element.directors().into_iter().map(Measure::Tilt).collect();
        Ok(Some(Self { id: element.id(), nodes, per_node, points, frame, measures, k, mass }))
    }

    /// Nodes that carry something, without stiffness and mass of their own.
    pub(super) fn carrier(nodes: &[usize], all: &[Vector3<f64>]) -> Self {
        let points: Vec<Vector3<f64>> = nodes.iter().map(|node| all[*node]).collect();
        let frame = Frame::Moving(Group::of(&points, true));
        Self {
            id: 0,
            nodes: nodes.to_vec(),
            per_node: 6,
            points,
            frame,
            measures: Vec::new(),
            k: None,
            mass: None,
        }
    }

    /// The same on a state of its own nodes alone.
    pub(super) fn alone(&self) -> Self {
        Self { nodes: (0..self.nodes.len()).collect(), ..self.clone() }
    }

    /// Whether it gives forces.
    pub(crate) fn is_elastic(&self) -> bool {
        self.k.is_some()
    }

    /// Degrees of freedom of the g-set.
    pub(crate) fn dofs(&self) -> Vec<usize> {
        self.nodes.iter().flat_map(|node| (0..self.per_node).map(move |c| 6 * node + c)).collect()
    }

    /// Frame and small motion at a state.
    pub(crate) fn placed(&self, state: &State) -> Placed {
        let places: Vec<Vector3<f64>> = self.nodes.iter().map(|node| state.places[*node]).collect();
        let rotations: Vec<_> = self.nodes.iter().map(|node| state.rotations[*node]).collect();
        let (q, arms, undeformed, fit) = match &self.frame {
            Frame::Moving(group) => {
                let middle = group.middle(&places);
                let arms: Vec<_> = places.iter().map(|place| place - middle).collect();
                let fit = group.fit(&arms, &rotations);
                let local = arms.iter().map(|arm| fit.q.transpose() * arm).collect();
                (fit.q, local, &group.arms, Some(fit))
            }
            Frame::Fixed(_) => (Matrix3::identity(), places, &self.points, None),
        };
        let mut motion = DVector::zeros(self.per_node * self.nodes.len());
        let mut turns = Vec::new();
        for (node, arm) in arms.iter().enumerate() {
            let at = self.per_node * node;
            motion.fixed_rows_mut::<3>(at).copy_from(&(arm - undeformed[node]));
            if self.per_node == 6 {
                let measure = self.measures.get(node).copied().unwrap_or(Measure::Logarithm);
                let turn = Turn::of(q.transpose() * rotations[node].matrix(), measure);
                motion.fixed_rows_mut::<3>(at + 3).copy_from(&turn.theta);
                turns.push(turn);
            }
        }
        Placed { q, arms, turns, fit, motion }
    }

    /// K d, in the frame, before it is carried to the nodes.
    pub(crate) fn local_force(&self, placed: &Placed) -> Option<DVector<f64>> {
        self.k.as_ref().map(|k| k * &placed.motion)
    }

    /// Forces on the nodes (basic axes) from K d: T P^T H^T.
    pub(crate) fn force(&self, placed: &Placed, local: &DVector<f64>) -> DVector<f64> {
        let mut force = self.balanced(placed, local);
        for at in (0..force.len()).step_by(3) {
            let turned = placed.q * force.fixed_rows::<3>(at);
            force.fixed_rows_mut::<3>(at).copy_from(&turned);
        }
        force
    }

    /// P^T H^T of a local force.
    pub(super) fn balanced(&self, placed: &Placed, local: &DVector<f64>) -> DVector<f64> {
        let mut own = local.clone();
        for (node, turn) in placed.turns.iter().enumerate() {
            let at = 6 * node + 3;
            let moment = turn.by_spin.transpose() * local.fixed_rows::<3>(at);
            own.fixed_rows_mut::<3>(at).copy_from(&moment);
        }
        if let Some((u, v)) = self.projector(placed) {
            own -= &v * (u.transpose() * &own);
        }
        own
    }

    /// How the local force changes with a motion of the nodes (basic axes, spins): K H P T^T du.
    pub(crate) fn promised(&self, placed: &Placed, du: &DVector<f64>) -> Option<DVector<f64>> {
        let k = self.k.as_ref()?;
        let mut local = du.clone();
        for at in (0..local.len()).step_by(3) {
            let turned = placed.q.transpose() * local.fixed_rows::<3>(at);
            local.fixed_rows_mut::<3>(at).copy_from(&turned);
        }
        if let Some((u, v)) = self.projector(placed) {
            local -= &u * (v.transpose() * &local);
        }
        for (node, turn) in placed.turns.iter().enumerate() {
            let at = 6 * node + 3;
            let vector = turn.by_spin * local.fixed_rows::<3>(at);
            local.fixed_rows_mut::<3>(at).copy_from(&vector);
        }
        Some(k * local)
    }

    /// U and V with P = 1 - U V^T; nothing in fixed axes.
    pub(super) fn projector(&self, placed: &Placed) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
        let (Frame::Moving(group), Some(fit)) = (&self.frame, &placed.fit) else { return None };
        let size = placed.motion.len();
        let (mut u, mut v) = (DMatrix::zeros(size, 6), DMatrix::zeros(size, 6));
        let share = 1.0 / (self.nodes.len() as f64);
        for (node, arm) in placed.arms.iter().enumerate() {
            let at = self.per_node * node;
            u.fixed_view_mut::<3, 3>(at, 0).copy_from(&Matrix3::identity());
            v.fixed_view_mut::<3, 3>(at, 0).copy_from(&(Matrix3::identity() * share));
            u.fixed_view_mut::<3, 3>(at, 3).copy_from(&-arm.cross_matrix());
            let spin = fit.inverse * group.arms[node].cross_matrix() * group.weight(node);
            v.fixed_view_mut::<3, 3>(at, 3).copy_from(&spin.transpose());
            if let Some(turn) = placed.turns.get(node) {
                u.fixed_view_mut::<3, 3>(at + 3, 3).copy_from(&Matrix3::identity());
                if group.rotations[node] != 0.0 {
                    let spin = fit.inverse * spin_of_rotation(&turn.rotation) * group.rotations[node];
                    v.fixed_view_mut::<3, 3>(at + 3, 3).copy_from(&spin.transpose());
                }
            }
        }
        Some((u, v))
    }

    /// The change of [`Corotated::force`] with displacements and spins of the nodes (basic axes), with the geometric terms of
    /// the local force given (the true one, or the one a step of Newton's method promised).
    pub(crate) fn tangent(&self, placed: &Placed, local: &DVector<f64>) -> Option<DMatrix<f64>> {
        let mut a = self.k.as_ref()?.clone();
        let projector = self.projector(placed);
        // H^T K H and the change of H^T.
        for (node, turn) in placed.turns.iter().enumerate() {
            let (at, l) = (6 * node + 3, turn.by_spin);
            let columns = a.fixed_columns::<3>(at) * l;
            a.fixed_columns_mut::<3>(at).copy_from(&columns);
            let rows = l.transpose() * a.fixed_rows::<3>(at);
            a.fixed_rows_mut::<3>(at).copy_from(&rows);
            let moment = local.fixed_rows::<3>(at).into_owned();
            let mut block = a.fixed_view_mut::<3, 3>(at, at);
            block += turn.moment_by_spin(&moment);
        }
        if let Some((u, v)) = &projector {
            self.spin_change(placed, local, u, &mut a);
            let force = self.balanced(placed, local);
            project(&mut a, u, v);
            self.turning(&force, u, v, &mut a);
        }
        turn(&mut a, &placed.q);
        Some(a)
    }

    /// Takes off N: the frame's spin G changes with the rotations that have a say about it.
    fn spin_change(&self, placed: &Placed, local: &DVector<f64>, u: &DMatrix<f64>, a: &mut DMatrix<f64>) {
        let (Frame::Moving(group), Some(fit)) = (&self.frame, &placed.fit) else { return };
        if placed.turns.is_empty() || group.rotations.iter().all(|weight| *weight == 0.0) {
            return;
        }
        let mut own = local.clone();
        for (node, turn) in placed.turns.iter().enumerate() {
            let at = 6 * node + 3;
            let moment = turn.by_spin.transpose() * local.fixed_rows::<3>(at);
            own.fixed_rows_mut::<3>(at).copy_from(&moment);
        }
        let s = u.columns(3, 3).transpose() * own;
        let q = fit.inverse.transpose() * Vector3::new(s[0], s[1], s[2]);
        for (node, turn) in placed.turns.iter().enumerate() {
            let r = &turn.rotation;
            let n = (q * axial(r).transpose() + r.transpose() * q.cross_matrix()) * -group.rotations[node];
            let mut block = a.fixed_view_mut::<3, 3>(6 * node + 3, 6 * node + 3);
            block -= n;
        }
    }

    /// Takes off F_nm G and G^T F_n^T P.
    fn turning(&self, force: &DVector<f64>, u: &DMatrix<f64>, v: &DMatrix<f64>, a: &mut DMatrix<f64>) {
        let size = force.len();
        let (mut f_nm, mut f_n) = (DMatrix::zeros(size, 3), DMatrix::zeros(size, 3));
        for at in (0..size).step_by(3) {
            let cross = force.fixed_rows::<3>(at).into_owned().cross_matrix();
            f_nm.fixed_view_mut::<3, 3>(at, 0).copy_from(&cross);
            if at % self.per_node == 0 {
                f_n.fixed_view_mut::<3, 3>(at, 0).copy_from(&cross);
            }
        }
        let g_t = v.columns(3, 3).into_owned();
        a.gemm(-1.0, &f_nm, &g_t.transpose(), 1.0);
        // F_n^T P = F_n^T - (F_n^T U) V^T
        let mut right = f_n.transpose();
        let inner = &right * u;
        right.gemm(-1.0, &inner, &v.transpose(), 1.0);
        a.gemm(-1.0, &g_t, &right, 1.0);
    }

    /// A matrix in the frame (its mass) turned to basic axes.
    pub(crate) fn turned(&self, matrix: &DMatrix<f64>, state: &State) -> DMatrix<f64> {
        let mut turned = matrix.clone();
        if matches!(self.frame, Frame::Moving(_)) {
            turn(&mut turned, &self.placed(state).q);
        }
        turned
    }

    /// The largest rotation of a node against the frame that meets stiffness, rad.
    pub(crate) fn largest_turn(&self, state: &State) -> f64 {
        let Some(k) = &self.k else { return 0.0 };
        let is_met = |node: usize| k.fixed_rows::<3>(6 * node + 3).amax() > 0.0;
        let turns = self.placed(state).turns;
        let met = turns.iter().enumerate().filter(|(node, _)| is_met(*node));
        met.map(|(_, turn)| turn.theta.norm()).fold(0.0, f64::max)
    }

    /// In fixed axes with rotations: how far these go, and how far they may, rad.
    pub(crate) fn beyond_limit(&self, state: &State) -> Option<(f64, f64)> {
        let Frame::Fixed(limit) = self.frame else { return None };
        let turned = self.largest_turn(state);
        (self.is_elastic() && turned > limit).then_some((turned, limit))
    }
}

/// P^T A P with P = 1 - U V^T.
fn project(a: &mut DMatrix<f64>, u: &DMatrix<f64>, v: &DMatrix<f64>) {
    let (au, ua) = (&*a * u, u.transpose() * &*a);
    let inner = u.transpose() * &au;
    a.gemm(-1.0, v, &ua, 1.0);
    // (A U - V (U^T A U)) V^T
    let mut left = au;
    left.gemm(-1.0, v, &inner, 1.0);
    a.gemm(-1.0, &left, &v.transpose(), 1.0);
}

/// T A T^T with T = diag(Q).
fn turn(a: &mut DMatrix<f64>, q: &Matrix3<f64>) {
    let q_t = q.transpose();
    for j in (0..a.ncols()).step_by(3) {
        for i in (0..a.nrows()).step_by(3) {
            let mut block = a.fixed_view_mut::<3, 3>(i, j);
            let turned = q * &block * q_t;
            block.copy_from(&turned);
        }
    }
}

#[cfg(test)]
mod tests;
