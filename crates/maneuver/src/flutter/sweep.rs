//! All p-k roots of one flow, without a start from a vacuum: so free aircraft and roots that begin in the air are found too.
//!
//! With the forces held at kappa the equation is an eigenvalue problem. Its frequencies, sorted from the largest down, are
//! continuous in kappa, so that between two values of kappa every root `Im p = kappa V` shows as a change of sign of one of
//! them less kappa V. Such a root is closed in by halving, until Newton's method finds it there. Real roots are the real eigenvalues at
//! kappa = 0.

use super::root::{Place, State};
use super::{Aeroelastic, FlutterError, SplitForces};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use structure::unsymmetric;

/// Values of kappa that are looked at, from zero to beyond the fastest motion.
const LOOKS: u32 = 32;
/// The largest of them over the frequency of the fastest motion.
const BEYOND: f64 = 1.5;
/// Halvings of the way between two of them; then the eigenvalue is the root to round-off.
const HALVINGS: usize = 45;
/// An oscillation slower than this share of the fastest motion is a real root.
const NOT_AT_REST: f64 = 1e-9;

/// A frequency less kappa V that changes its sign between two values of kappa.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    kappas: [f64; 2],
    /// Its place among the frequencies, the largest first.
    rank: usize,
    /// Whether it is above kappa V at the first.
    is_above: bool,
}

impl Aeroelastic<'_> {
    /// The matrix of x' = A x, the forces held as given.
    fn state_matrix(&self, forces: &SplitForces, place: Place) -> Mat<f64> {
        let n = self.size();
        let at = |p: f64| self.matrix(c64::from(p), forces, place.flow, place.share);
        let (rest, rate) = (at(0.0), self.slope(c64::default(), forces, place.flow, place.share));
        let mass = self.mass().to_owned().partial_piv_lu();
        let right =
            Mat::from_fn(n, 2 * n, |i, j| if j < n { -rest[(i, j)].re } else { -rate[(i, j - n)].re });
        let lower = mass.solve(right);
        Mat::from_fn(2 * n, 2 * n, |i, j| match i.checked_sub(n) {
            None => f64::from(u8::from(j == i + n)),
            Some(row) => lower[(row, j)],
        })
    }

    /// Eigenvalues that do not swing backwards, with shapes, the forces held as given.
    pub(super) fn with_forces_held(&self, forces: &SplitForces, place: Place) -> Option<Vec<State>> {
        let n = self.size();
        let (values, vectors) = unsymmetric::eigen(self.state_matrix(forces, place).as_ref())?;
        let states = (0..2 * n).filter_map(|k| {
            let p = values[k];
            let real = is_real(p);
            let u = (0..n).map(|i| vectors[(i, k)]).collect();
            let p = if real { c64::from(p.re) } else { p };
            (p.im >= 0.0).then_some(State { p, u, real, beyond: forces.beyond })
        });
        Some(states.collect())
    }

    /// All roots at a place but those at rest, which are taken for rigid motions on which no air acts: real ones first, then by
    /// rising frequency. Between two values of kappa that have as many known roots as there are, these are taken for them.
    pub(super) fn all_roots(&self, place: Place, known: &[&State]) -> Result<Vec<State>, FlutterError> {
        let v = place.flow.v_m_s;
        let slowest = self.slowest_rad_s();
        let is_moving = |state: &State| state.p.norm() > self.at_rest_rad_s();
        let still = self.held_at(0.0, place)?;
        let fastest = still.first().map_or(0.0, |state| state.p.im).max(slowest);
        let mut roots: Vec<State> =
            still.iter().filter(|state| state.real && is_moving(state)).cloned().collect();
        roots.sort_by(|a, b| a.p.re.total_cmp(&b.p.re));
        let mut oscillating: Vec<State> = Vec::new();
        let frequency = |state: &State| if is_moving(state) { state.p.im } else { 0.0 };
        let mut before = (0.0, still.iter().map(frequency).collect::<Vec<f64>>());
        for look in 1..=LOOKS {
            let kappa = BEYOND * fastest / v * (f64::from(look) / f64::from(LOOKS)).powi(2);
            let after = (kappa, self.frequencies_at(kappa, place)?);
            let here = brackets(&before, &after, v);
            let is_here = |state: &&&State| {
                !state.real && (before.0 * v..kappa * v).contains(&state.p.im) && is_moving(state)
            };
            let there: Vec<&&State> = known.iter().filter(is_here).collect();
            if there.len() == here.len() {
                oscillating.extend(there.into_iter().map(|state| (*state).clone()));
                before = after;
                continue;
            }
            for bracket in here {
                let root = self.closed_in(bracket, place, &oscillating)?;
                // At kappa = 0 itself it is a real root, which is there already.
                if root.p.im > NOT_AT_REST * fastest {
                    oscillating.push(root);
                }
            }
            before = after;
        }
        oscillating.retain(is_moving);
        oscillating.sort_by(|a, b| a.p.im.total_cmp(&b.p.im));
        roots.extend(oscillating);
        Ok(roots)
    }

    /// Frequencies with the forces at kappa, rad/s, the fastest first; zero for motions that do not oscillate.
    fn frequencies_at(&self, kappa: f64, place: Place) -> Result<Vec<f64>, FlutterError> {
        let forces = self.split(kappa, place.flow.v_m_s)?;
        let values = unsymmetric::eigenvalues(self.state_matrix(&forces, place).as_ref())
            .ok_or(FlutterError::Eigenvalues("the structure in the air"))?;
        let mut all: Vec<f64> = values
            .into_iter()
            .filter(|p| p.im >= 0.0 || is_real(*p))
            .map(|p| if is_real(p) { 0.0 } else { p.im })
            .collect();
        all.sort_by(|a, b| b.total_cmp(a));
        Ok(all)
    }

    /// Eigenvalues with the forces at kappa, the fastest first.
    fn held_at(&self, kappa: f64, place: Place) -> Result<Vec<State>, FlutterError> {
        let forces = self.split(kappa, place.flow.v_m_s)?;
        let states = self.with_forces_held(&forces, place);
        let mut states = states.ok_or(FlutterError::Eigenvalues("the structure in the air"))?;
        states.sort_by(|a, b| b.p.im.total_cmp(&a.p.im));
        Ok(states)
    }

    /// The root in a bracket; Newton's method may not lead to one that is known.
    fn closed_in(&self, bracket: Bracket, place: Place, known: &[State]) -> Result<State, FlutterError> {
        let v = place.flow.v_m_s;
        let Bracket { kappas: [mut low, mut high], rank, is_above } = bracket;
        let mut nearest = None;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let states = self.held_at(middle, place)?;
            let Some(state) = states.into_iter().nth(rank).filter(|state| !state.real) else {
                // Slower than any kappa: below.
                if is_above {
                    high = middle;
                } else {
                    low = middle;
                }
                continue;
            };
            let mut guess = state.clone();
            guess.p.im = middle * v;
            if let Ok(root) = self.root(&guess, place) {
                let kappa = root.p.im / v;
                let is_known = known.iter().any(|other| (other.p - root.p).norm() <= 1e-9 * root.p.norm());
                if low <= kappa && kappa <= high && !is_known && self.likeness(&root.u, &state.u) > 0.5 {
                    return Ok(root);
                }
            }
            if (state.p.im > middle * v) == is_above {
                low = middle;
            } else {
                high = middle;
            }
            nearest = Some(state);
        }
        nearest.ok_or(FlutterError::Eigenvalues("the structure in the air"))
    }
}

fn is_real(p: c64) -> bool {
    p.im.abs() <= 1e-9 * p.norm()
}

/// The changes of sign between two values of kappa, given with the frequencies there.
fn brackets(before: &(f64, Vec<f64>), after: &(f64, Vec<f64>), v_m_s: f64) -> Vec<Bracket> {
    let excess = |(kappa, frequencies): &(f64, Vec<f64>), rank: usize| {
        frequencies.get(rank).copied().unwrap_or(0.0) - kappa * v_m_s
    };
    let most = before.1.len().max(after.1.len());
    let ranks = (0..most).filter_map(|rank| {
        let [first, second] = [excess(before, rank), excess(after, rank)];
        let is_above = first > 0.0;
        (is_above != (second > 0.0)).then_some(Bracket { kappas: [before.0, after.0], rank, is_above })
    });
    ranks.collect()
}

#[cfg(test)]
mod laws;
#[cfg(test)]
mod tests;
