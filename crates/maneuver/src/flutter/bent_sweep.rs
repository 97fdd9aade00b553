//! Flutter of the wing that really bends over airspeed: every airspeed with its own equilibrium, so a mode may become
//! unstable and, where the wing bends further, stable again: a hump.
//!
//! Natural modes are followed from airspeed to airspeed by shape (MAC), roots by their distance from where they were going. A change
//! of stability is found by equilibria of its own between two airspeeds, no interpolation of matrices.

use super::bent::{BentFlutterError, BentPoint};
use aero::{Corrections, Flow};
use coupling::{CouplingError, LargeState, LargeWing, SteadyCase};
use faer::{Mat, c64};
use std::f64::consts::TAU;

/// Accuracy of a change of stability, m/s.
const ACCURACY_M_S: f64 = 0.02;
/// Equilibria spent on one.
const ROUNDS: usize = 5;
/// Distance of a root from where it was going, over its modulus, beyond which it is another one.
const NEAR: f64 = 0.25;
/// Likeness of shapes (MAC) below which a natural mode is not the one before.
const LIKE: f64 = 0.5;

/// A wing, its root and its modes.
#[derive(Debug, Clone, Copy)]
pub struct BentFlutter<'a> {
    /// The wing.
    pub wing: &'a LargeWing,
    /// Angle of attack of the root, rad.
    pub alpha_rad: f64,
    /// Density of the air, kg/m^3.
    pub rho_kg_m3: f64,
    /// Tangent modes kept.
    pub modes: usize,
    /// Damping ratio of the structure in each of them.
    pub damping_ratio: f64,
}

/// A change of stability over airspeed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentCrossing {
    /// The entry of [`BentPoint::roots`].
    pub branch: usize,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Frequency, Hz; zero without oscillation.
    pub frequency_hz: f64,
    /// Rise of the tip, m.
    pub tip_z_m: f64,
    /// Whether the wing becomes unstable there (and not stable again).
    pub unstable: bool,
}

/// What a sweep found.
#[derive(Debug)]
pub struct BentSweep {
    /// By airspeed.
    pub points: Vec<BentPoint>,
    /// Changes of stability in ascending airspeed.
    pub crossings: Vec<BentCrossing>,
    /// Why it ended before the last airspeed.
    pub ended: Option<CouplingError>,
}

impl BentSweep {
    /// Whether a root grows at the lowest airspeed already, so that the sweep does not see where that began.
    pub fn is_unstable_from_the_start(&self) -> bool {
        let first = self.points.first();
        first.is_some_and(|point| point.roots.iter().flatten().any(|root| root.re > 0.0))
    }
}

impl BentFlutter<'_> {
    /// Equilibria, modes and roots over ascending airspeeds (m/s), with the corrections of each (one entry for each correctable
    /// box). An airspeed without a stable equilibrium ends the sweep.
    ///
    /// # Errors
    /// If there is no equilibrium at the first airspeed, or modes, the lattice or the roots cannot be found.
    pub fn over(
        &self,
        airspeeds: &[f64],
        corrections: &dyn Fn(f64) -> Corrections,
    ) -> Result<BentSweep, BentFlutterError> {
        let mut sweep = BentSweep { points: Vec::new(), crossings: Vec::new(), ended: None };
        for v_m_s in airspeeds {
            let found = match sweep.points.as_slice() {
                [] => Ok(self.point(*v_m_s, corrections, None)?),
                [before @ .., last] => self.next(before.last(), last, *v_m_s, corrections),
            };
            match found {
                Ok(point) => sweep.points.push(point),
                Err(BentFlutterError::Coupling(error @ CouplingError::NotInEquilibrium { .. })) => {
                    sweep.ended = Some(error);
                    break;
                }
                Err(error) => return Err(error),
            }
        }
        for pair in sweep.points.windows(2) {
            for branch in 0..self.modes {
                sweep.crossings.extend(self.crossing(&pair[0], &pair[1], branch, corrections)?);
            }
        }
        sweep.crossings.sort_by(|a, b| a.v_m_s.total_cmp(&b.v_m_s));
        Ok(sweep)
    }

    /// A case by itself about an equilibrium that was found elsewhere, with its corrections (one entry for each correctable box);
    /// roots in the order of natural frequencies.
    ///
    /// # Errors
    /// If modes, the lattice or the roots cannot be found.
    pub fn about(
        &self,
        case: &SteadyCase,
        corrections: &Corrections,
        state: LargeState,
    ) -> Result<BentPoint, BentFlutterError> {
        BentPoint::new(self.wing, case, corrections, state, (self.modes, self.damping_ratio))
    }

    /// An airspeed by itself, its equilibrium continued from another's.
    fn point(
        &self,
        v_m_s: f64,
        corrections: &dyn Fn(f64) -> Corrections,
        known: Option<&BentPoint>,
    ) -> Result<BentPoint, BentFlutterError> {
        let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: self.rho_kg_m3 }, self.alpha_rad);
        let corrections = corrections(v_m_s);
        let state = match known {
            None => self.wing.solve(std::slice::from_ref(&case), &corrections)?.remove(0),
            Some(known) => self.wing.continued_from(&known.state, &known.case, &case, &corrections)?,
        };
        self.about(&case, &corrections, state)
    }

    /// An airspeed with its modes and roots in the order of the one before it; `earlier` tells where roots are going.
    fn next(
        &self,
        earlier: Option<&BentPoint>,
        last: &BentPoint,
        v_m_s: f64,
        corrections: &dyn Fn(f64) -> Corrections,
    ) -> Result<BentPoint, BentFlutterError> {
        let mut point = self.point(v_m_s, corrections, Some(last))?;
        let order = like(last, &point, self.wing.elastic.correctable.mean_chord_m());
        point.omega_rad_s = order.iter().map(|place| point.omega_rad_s[*place]).collect();
        point.shapes =
            Mat::from_fn(point.shapes.nrows(), order.len(), |row, i| point.shapes[(row, order[i])]);
        let guess = |branch: usize| {
            let now = last.roots[branch]?;
            let speed = |point: &BentPoint| point.case.flow.v_m_s;
            let before = earlier.and_then(|earlier| Some((earlier.roots[branch]?, speed(earlier))));
            Some(before.map_or(now, |(before, v)| {
                now + (now - before) * ((v_m_s - speed(last)) / (speed(last) - v))
            }))
        };
        let guesses: Vec<Option<c64>> = (0..self.modes).map(guess).collect();
        point.roots = nearest(&guesses, &point.roots);
        Ok(point)
    }

    /// Where a branch changes the sign of its growth rate between two airspeeds: false position on equilibria of its own.
    fn crossing(
        &self,
        slow: &BentPoint,
        fast: &BentPoint,
        branch: usize,
        corrections: &dyn Fn(f64) -> Corrections,
    ) -> Result<Option<BentCrossing>, BentFlutterError> {
        let (mut low, mut high) = (slow.clone(), fast.clone());
        let Some(mut found) = change(&low, &high, branch) else { return Ok(None) };
        for _ in 0..ROUNDS {
            let mut middle = self.point(found.v_m_s, corrections, Some(&low))?;
            let share = (found.v_m_s - low.case.flow.v_m_s) / (high.case.flow.v_m_s - low.case.flow.v_m_s);
            let between = |(a, b): (&Option<c64>, &Option<c64>)| Some((*a)? + ((*b)? - (*a)?) * share);
            let guesses: Vec<Option<c64>> = low.roots.iter().zip(&high.roots).map(between).collect();
            middle.roots = nearest(&guesses, &middle.roots);
            let Some(root) = middle.roots[branch] else { break };
            if (root.re > 0.0) == found.unstable {
                high = middle;
            } else {
                low = middle;
            }
            let Some(next) = change(&low, &high, branch) else { break };
            let moved = (next.v_m_s - found.v_m_s).abs();
            found = next;
            if moved < ACCURACY_M_S {
                break;
            }
        }
        Ok(Some(found))
    }
}

/// The change of stability of a branch between two points, linear between them.
fn change(low: &BentPoint, high: &BentPoint, branch: usize) -> Option<BentCrossing> {
    let (a, b) = (low.roots[branch]?, high.roots[branch]?);
    if (a.re > 0.0) == (b.re > 0.0) {
        return None;
    }
    let share = a.re / (a.re - b.re);
    let mix = |a: f64, b: f64| a + share * (b - a);
    Some(BentCrossing {
        branch,
        v_m_s: mix(low.case.flow.v_m_s, high.case.flow.v_m_s),
        frequency_hz: mix(a.im, b.im) / TAU,
        tip_z_m: mix(low.state.tip_m.z, high.state.tip_m.z),
        unstable: b.re > 0.0,
    })
}

/// Which natural mode of a point each of the one before has become. Spins count by what they move over a chord.
fn like(before: &BentPoint, now: &BentPoint, chord_m: f64) -> Vec<usize> {
    let product = |a: (&Mat<f64>, usize), b: (&Mat<f64>, usize)| -> f64 {
        let weight = |row: usize| if row % 6 < 3 { 1.0 } else { chord_m * chord_m };
        (0..a.0.nrows()).map(|row| weight(row) * a.0[(row, a.1)] * b.0[(row, b.1)]).sum()
    };
    let mac = |i: usize, j: usize| {
        let (a, b) = ((&before.shapes, i), (&now.shapes, j));
        product(a, b).powi(2) / (product(a, a) * product(b, b))
    };
    let count = before.shapes.ncols();
    let pairs = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
    let mut taken = matched(count, pairs.map(|(i, j)| (1.0 - mac(i, j), i, j)).collect(), 1.0 - LIKE);
    // A mode that is none of those before takes what is left, in the order of frequencies.
    let mut left: Vec<usize> = (0..count).filter(|j| !taken.contains(&Some(*j))).collect();
    taken.iter_mut().map(|place| place.unwrap_or_else(|| left.remove(0))).collect()
}

/// Roots in the order of guesses; none of two is the same.
fn nearest(guesses: &[Option<c64>], roots: &[Option<c64>]) -> Vec<Option<c64>> {
    let each = guesses.iter().enumerate().flat_map(|(i, guess)| {
        roots.iter().enumerate().filter_map(move |(j, root)| {
            let (guess, root) = ((*guess)?, (*root)?);
            Some(((root - guess).norm() / guess.norm().max(root.norm()), i, j))
        })
    });
    let taken = matched(guesses.len(), each.collect(), NEAR);
    taken.into_iter().map(|place| roots[place?]).collect()
}

/// For each of `count` the place that is nearest to it, nearest pairs first, none farther than `limit`.
fn matched(count: usize, mut pairs: Vec<(f64, usize, usize)>, limit: f64) -> Vec<Option<usize>> {
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut taken = vec![None; count];
    for (_, i, j) in pairs.into_iter().take_while(|pair| pair.0 <= limit) {
        if taken[i].is_none() && !taken.contains(&Some(j)) {
            taken[i] = Some(j);
        }
    }
    taken
}

#[cfg(test)]
mod laws;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_that_pass_each_other_keep_their_identity() {
        let root = |re: f64, im: f64| Some(c64::new(re, im));
        // Torsion falls through bending: p-k lists them by natural frequency, each is where it was going.
        let guesses = [root(-10.0, 190.0), root(-2.0, 196.0), None];
        let found = nearest(&guesses, &[root(-2.5, 194.0), root(-11.0, 188.0), root(-90.0, 600.0)]);
        assert_eq!(found, [root(-11.0, 188.0), root(-2.5, 194.0), None]);
        // One that jumped is not taken for another.
        assert_eq!(nearest(&[root(0.0, 100.0)], &[root(0.0, 140.0)]), [None]);
    }
}
