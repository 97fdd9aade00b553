//! Newton's method from one state to the equilibrium under given loads, in mixed form.
//!
//! The tangent's geometric terms take the forces that the last linear step promised, the residual the true ones (Magisano,
//! Leonetti and Garcea, Int. J. Numer. Meth. Eng. 109, 2017): stiff stretching no longer spoils the
//! prediction of bending, which takes a tenth to a half of the iterations.

use super::acting::Acting;
use super::krylov;
use super::near::Near;
use super::state::State;
use super::structure::LargeDeflection;
use crate::dofs::DofMap;
use crate::factor::Factor;
use faer::Mat;
use nalgebra::DVector;
use rayon::prelude::*;

/// Iterations of one load step.
const ITERATIONS: usize = 15;

/// Work of the last step in units of the largest first one, or of the energy that is stored if that is more: what is added
/// to a loaded structure may be next to nothing.
const WORK: f64 = 1e-12;

/// Largest last spin, rad, and displacement in units of the structure's size.
const STEP: f64 = 1e-7;

/// Spin of one iteration beyond which a linear prediction means nothing, rad.
const SPIN: f64 = 1.5;

/// Spin of the last iteration, rad, below which the tangent of a structure under loads that follow is the same still. (Thin shells turned by
/// a thousandth would stretch to the size of their bending; without such loads the tangent's signs are judged, so it is always that of now.)
const SAME_TANGENT: f64 = 1e-4;

/// Residuals of the linear equations of a step that is not solved directly, relative: the least, and the most. A step is not solved
/// better than it can predict, which its last spin (rad) times [`FORCING`] says (Eisenstat and Walker, SIAM J. Sci. Comput. 17, 1996).
const RESIDUALS: [f64; 2] = [1e-8, 1e-4];

/// See there, 1/rad.
const FORCING: f64 = 1e-2;

/// A way that grows by more than this over the mean of the stiffnesses at its ends went across a limit of the load.
pub(super) const JUMP: f64 = 1.5;

/// An equilibrium.
pub(super) struct Converged {
    pub(super) state: State,
    pub(super) iterations: usize,
    /// Of the tangent.
    pub(super) negative: usize,
    /// Where a tangent on the way had negative pivots: work of the added load on its displacement over what the tangents
    /// of both ends say. Beyond [`JUMP`] it has come to another branch.
    pub(super) overshoot: f64,
    /// The tangent's factor.
    pub(super) factor: Factor,
}

/// No equilibrium was reached.
pub(super) struct Failed {
    /// Negative pivots of the last tangent.
    pub(super) negative: usize,
    pub(super) iterations: usize,
}

/// From `start` to the equilibrium under what acts. `work` is the largest work of a first step so far, N m.
pub(super) fn converge(
    structure: &LargeDeflection,
    start: &State,
    acting: &dyn Acting,
    work: &mut f64,
) -> Result<Converged, Failed> {
    let mut state = start.clone();
    let mut promised: Option<Vec<DVector<f64>>> = None;
    let (mut added, mut way, mut first_work): (Vec<f64>, Vec<f64>, f64) = (Vec::new(), Vec::new(), 0.0);
    let (mut negative, mut on_the_way, size) = (0, 0, extent(start));
    let (mut kept, mut last_spin): (Option<Factor>, f64) = (None, f64::INFINITY);
    for iteration in 1..=ITERATIONS {
        let map = structure.map(&state);
        let inner = structure.inner(&state);
        let failed = |negative| Failed { negative, iterations: iteration };
        let Some(near) = acting.at(structure, &state) else { return Err(failed(negative)) };
        let short: Vec<f64> = inner.forces.iter().zip(near.forces()).map(|(i, o)| i - o).collect();
        let same = kept.take().filter(|_| acting.follows() && last_spin < SAME_TANGENT);
        let local = promised.as_ref().unwrap_or(&inner.local);
        let factored = || structure.factored_tangent(&state, &map, &inner.placed, local, &short);
        let Some(factor) = same.or_else(factored) else { return Err(failed(negative)) };
        negative = factor.pivots().iter().filter(|(_, pivot)| *pivot < 0.0).count();
        on_the_way = on_the_way.max(negative);
        let r = LargeDeflection::reduced(&map, &short);
        let following = acting.follows().then_some(near.as_ref());
        let residual = (FORCING * last_spin).clamp(RESIDUALS[0], RESIDUALS[1]);
        let du = linear_step(structure, &state, &map, following, &short, &factor, residual);
        let moved = structure.move_on(&mut state, &map, &du);
        let (shift, spin) = largest(&moved);
        if !(shift.is_finite() && spin.is_finite()) || spin > SPIN {
            return Err(failed(negative));
        }
        let own: f64 = du.iter().zip(&r).map(|(u, r)| u * r).sum::<f64>().abs();
        tracing::trace!(iteration, own, shift, spin, negative, "iteration");
        if iteration == 1 {
            (*work, first_work) = (work.max(own), own);
            (added, way) = (r.clone(), vec![0.0; r.len()]);
        }
        way.iter_mut().zip(&du).for_each(|(way, du)| *way += du);
        let stored: f64 =
            inner.placed.iter().zip(&inner.local).map(|(at, local)| 0.5 * at.motion.dot(local)).sum();
        if own <= WORK * work.max(stored) && spin < STEP && shift < STEP * size {
            let product = |u: &[f64]| added.iter().zip(u).map(|(f, u)| f * u).sum::<f64>().abs();
            let mean = 0.5 * (first_work + product(&symmetric_step(&factor, &added)));
            let overshoot = if on_the_way > 0 { product(&way) / mean } else { 0.0 };
            return Ok(Converged { state, iterations: iteration, negative, overshoot, factor });
        }
        let one = |at: usize| {
            let element = &structure.elements[structure.elastic[at]];
            let motion = element.dofs().into_iter().map(|dof| moved[dof]);
            let motion = DVector::from_iterator(inner.local[at].len(), motion);
            let change = element.promised(&inner.placed[at], &motion).expect("it is elastic");
            &inner.local[at] + change
        };
        promised = Some((0..inner.local.len()).into_par_iter().map(one).collect());
        (kept, last_spin) = (Some(factor), spin);
    }
    Err(Failed { negative, iterations: ITERATIONS })
}

/// -K^-1 r.
fn symmetric_step(factor: &Factor, r: &[f64]) -> Vec<f64> {
    factor.solve(Mat::from_fn(r.len(), 1, |i, _| -r[i]).as_ref()).col(0).iter().copied().collect()
}

/// The same of what the nodes are `short` of equilibrium by, with what is not in the tangent: means that turn, supports that hold one rotation
/// of three, and loads that follow.
fn linear_step(
    structure: &LargeDeflection,
    state: &State,
    map: &DofMap,
    following: Option<&dyn Near>,
    short: &[f64],
    factor: &Factor,
    residual: f64,
) -> Vec<f64> {
    let r = LargeDeflection::reduced(map, short);
    let has_means = structure.joints.has_means();
    let supports = if has_means { None } else { structure.support_moments(state, short) };
    if following.is_none() && !has_means && supports.is_none() {
        return symmetric_step(factor, &r);
    }
    let following = following.map(|near| (near, near.following_here()));
    let product = |v: &[f64]| {
        let mut all = structure.turning_means(state, map, short, v);
        if let Some(moments) = &supports {
            let own = LargeDeflection::turning_supports(map, moments, v);
            all.iter_mut().zip(own).for_each(|(all, own)| *all -= own);
        }
        if let Some((near, here)) = &following {
            let loads = structure.following_stiffness(state, map, *near, here, v);
            all.iter_mut().zip(loads).for_each(|(all, own)| *all += own);
        }
        all
    };
    krylov::solve(&r, &|b: &[f64]| symmetric_step(factor, b), product, residual)
}

/// Largest displacement and spin of a motion of the g-set.
fn largest(motion: &[f64]) -> (f64, f64) {
    let most = |first: usize| {
        let parts = motion.chunks_exact(6).map(|m| m[first].hypot(m[first + 1]).hypot(m[first + 2]));
        // What is no number stays so.
        parts.fold(0.0, |most: f64, own| if most.is_nan() || own <= most { most } else { own })
    };
    (most(0), most(3))
}

/// The diagonal of the box around all nodes, m.
fn extent(state: &State) -> f64 {
    let mut square = 0.0;
    for axis in 0..3 {
        let all = state.places.iter().map(|place| place[axis]);
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        square += (high - low) * (high - low);
    }
    f64::sqrt(square)
}

#[cfg(test)]
mod tests;
