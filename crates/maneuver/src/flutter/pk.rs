//! Modes followed through a list of flows, each from its last root in steps that are halved until nothing jumps.
//!
//! A step is taken if Newton's method converges from the extrapolated root, lands near it, and the shape is still that of
//! the step before. So branches that pass each other closely keep their identity. A root whose frequency goes to zero becomes
//! two real ones, of which the less stable one is followed; real roots that meet oscillate again.

use super::curves::{Crossing, FlutterCurves, Root, growth, in_order};
use super::root::{Missed, Place, State};
use super::{Aeroelastic, FlutterError};
use aero::Flow;
use faer::c64;
use std::f64::consts::TAU;
use structure::unsymmetric;

/// Likeness of shapes below which a step is too long.
const SAME_SHAPE: f64 = 0.9;
/// Distance of a root from its extrapolation, over its modulus, beyond which a step is too long.
const NEAR: f64 = 0.05;
/// Steps are halved down to this share of the way between two flows.
const SHORTEST: f64 = 1e-6;
/// Accuracy of a crossing, as a share of the way between two flows.
const CROSSING: f64 = 1e-12;

/// Crossings, each with the place of the flow before it.
type OnLegs = Vec<(usize, Crossing)>;

/// A branch on its way.
#[derive(Debug, Clone)]
pub(super) struct Track {
    pub(super) state: State,
    /// Change of p over the last step, and that step.
    pub(super) before: Option<(c64, f64)>,
}

/// Way between two places, from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    pub(super) from: Place,
    pub(super) to: Place,
}

impl Leg {
    fn at(&self, t: f64) -> Place {
        let mix = |a: f64, b: f64| if t == 1.0 { b } else { a + t * (b - a) };
        Place {
            flow: Flow {
                v_m_s: mix(self.from.flow.v_m_s, self.to.flow.v_m_s),
                rho_kg_m3: mix(self.from.flow.rho_kg_m3, self.to.flow.rho_kg_m3),
            },
            share: mix(self.from.share, self.to.share),
        }
    }
}

impl Aeroelastic<'_> {
    /// p-k roots of every mode through a list of flows, and where they change their stability.
    ///
    /// Airspeeds are positive. Between two flows both airspeed and density change in proportion, and a crossing is found to
    /// round-off; so a sweep may be one of airspeed, of density, or matched.
    ///
    /// # Errors
    /// If there is no flow, an airspeed or density is not positive, or a natural frequency is zero. A mode that cannot be
    /// followed to the end is no error, but stands in [`FlutterCurves::lost`].
    pub fn pk(&self, flows: &[Flow]) -> Result<FlutterCurves, FlutterError> {
        checked(flows)?;
        let mut curves = FlutterCurves {
            flows: flows.to_vec(),
            branches: Vec::new(),
            crossings: Vec::new(),
            lost: Vec::new(),
        };
        let mut found = Vec::new();
        for (branch, state) in self.modes()?.into_iter().enumerate() {
            let mut roots = Vec::with_capacity(flows.len());
            match self.follow(Track { state, before: None }, &curves.flows, branch, &mut roots) {
                Ok(crossings) => found.extend(crossings),
                Err((crossings, error @ FlutterError::Lost { .. })) => {
                    found.extend(crossings);
                    curves.lost.push(error);
                }
                Err((_, error)) => return Err(error),
            }
            curves.branches.push(roots);
        }
        curves.crossings = in_order(&curves.flows, found);
        Ok(curves)
    }

    /// Follows one mode, first from a vacuum into the first flow; what was found stands beside an error.
    fn follow(
        &self,
        start: Track,
        flows: &[Flow],
        branch: usize,
        roots: &mut Vec<Root>,
    ) -> Result<OnLegs, (OnLegs, FlutterError)> {
        let mut crossings = Vec::new();
        let still = |share: f64| Place { flow: flows[0], share };
        let vacuum = Leg { from: still(0.0), to: still(1.0) };
        let fail = |error| (Vec::new(), error);
        let mut track = self.march(start, vacuum, 1.0, branch).map_err(fail)?;
        track.before = None;
        roots.push(root_of(&track.state));
        for (at, pair) in flows.windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]].map(|flow| Place { flow, share: 1.0 });
            let leg = Leg { from, to };
            let next = match self.march(track.clone(), leg, 1.0, branch) {
                Ok(next) => next,
                Err(error) => return Err((crossings, error)),
            };
            match self.crossing(&track, &next, leg, branch) {
                Ok(found) => crossings.extend(found.map(|crossing| (at, crossing))),
                Err(error) => return Err((crossings, error)),
            }
            roots.push(root_of(&next.state));
            track = next;
        }
        Ok(crossings)
    }

    /// Modes in a vacuum, ascending.
    fn modes(&self) -> Result<Vec<State>, FlutterError> {
        let n = self.size();
        let undamped = self.mass().to_owned().partial_piv_lu();
        let matrix = faer::linalg::solvers::Solve::solve(&undamped, self.stiffness().to_owned());
        let (values, vectors) =
            unsymmetric::eigen(matrix.as_ref()).ok_or(FlutterError::Eigenvalues("the structure"))?;
        let mut states = Vec::with_capacity(n);
        for i in 0..n {
            let value = values[i];
            if !(value.re > 0.0 && value.im.abs() <= 1e-9 * value.re) {
                let expected = "positive (a coordinate without stiffness cannot be followed from rest)";
                return Err(FlutterError::Number {
                    what: "the square of a natural frequency",
                    value: value.re,
                    expected,
                });
            }
            let u = (0..n).map(|row| vectors[(row, i)]).collect();
            states.push(State { p: c64::new(0.0, value.re.sqrt()), u, real: false, beyond: false });
        }
        states.sort_by(|a, b| a.p.im.total_cmp(&b.p.im));
        Ok(states)
    }

    /// Follows a branch along a leg up to `end` of it.
    pub(super) fn march(
        &self,
        start: Track,
        leg: Leg,
        end: f64,
        branch: usize,
    ) -> Result<Track, FlutterError> {
        let (mut track, mut t, mut step) = (start, 0.0, end);
        // the last step's slope is in the units of the last leg: legs of one sweep are alike
        while t < end {
            let length = step.min(end - t);
            let to = if length == end - t { end } else { t + length };
            match self.step(&track, leg.at(to), length)? {
                Some(next) => {
                    track = next;
                    t = to;
                    step = 2.0 * length;
                }
                None if length > SHORTEST => step = 0.5 * length,
                None => {
                    let place = leg.at(to);
                    track = self.other_kind(&track, place).ok_or_else(|| FlutterError::Lost {
                        mode: branch + 1,
                        v_m_s: place.flow.v_m_s,
                        frequency_hz: track.state.p.im / TAU,
                    })?;
                    t = to;
                    step = length;
                }
            }
        }
        Ok(track)
    }

    /// One step, if it is short enough.
    fn step(&self, track: &Track, place: Place, length: f64) -> Result<Option<Track>, FlutterError> {
        let mut guess = track.state.clone();
        if let Some((change, over)) = track.before {
            guess.p += change * (length / over);
            if !guess.real && guess.p.im <= 0.0 {
                return Ok(None);
            }
        }
        match self.root(&guess, place) {
            Ok(state) => {
                let near = (state.p - guess.p).norm() <= NEAR * self.modulus(state.p).max(guess.p.norm());
                let same = self.likeness(&state.u, &track.state.u) > SAME_SHAPE;
                let before = Some((state.p - track.state.p, length));
                Ok((near && same).then_some(Track { state, before }))
            }
            Err(Missed::Far | Missed::Collapsed) => Ok(None),
            Err(Missed::Failed(error)) => Err(error),
        }
    }

    /// Where a branch ends: an oscillation as a real root, a real root as an oscillation; the candidate most like it.
    fn other_kind(&self, track: &Track, place: Place) -> Option<Track> {
        let forces = self.split(0.0, place.flow.v_m_s).ok()?;
        let mut found: Vec<State> = self
            .with_forces_held(&forces, place)?
            .into_iter()
            .filter(|state| state.real != track.state.real)
            .filter_map(|state| self.root(&state, place).ok())
            .filter(|state| self.likeness(&state.u, &track.state.u) > 0.5)
            .collect();
        found.sort_by(|a, b| b.p.re.total_cmp(&a.p.re));
        let state = if track.state.real {
            let distance = |state: &State| (state.p - track.state.p).norm();
            found.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?
        } else {
            found.into_iter().next()?
        };
        Some(Track { state, before: None })
    }

    /// Where a branch changes the sign of its growth rate between both ends of a leg.
    pub(super) fn crossing(
        &self,
        from: &Track,
        to: &Track,
        leg: Leg,
        branch: usize,
    ) -> Result<Option<Crossing>, FlutterError> {
        let (mut low, mut high) = ((0.0, growth(from.state.p)), (1.0, growth(to.state.p)));
        if (low.1 > 0.0) == (high.1 > 0.0) {
            return Ok(None);
        }
        let unstable = high.1 > 0.0;
        let mut at = to.clone();
        let mut weights = (low.1, high.1);
        for round in 0..200 {
            if high.0 - low.0 < CROSSING {
                break;
            }
            // false position with the kept end's weight halved (Illinois), every fourth time the middle
            let share = if round % 4 == 3 { 0.5 } else { weights.0 / (weights.0 - weights.1) };
            let t = low.0 + share.clamp(1e-3, 1.0 - 1e-3) * (high.0 - low.0);
            at = self.march(from.clone(), leg, t, branch)?;
            let rate = growth(at.state.p);
            if (rate > 0.0) == (low.1 > 0.0) {
                (low, weights) = ((t, rate), (rate, 0.5 * weights.1));
            } else {
                (high, weights) = ((t, rate), (0.5 * weights.0, rate));
            }
        }
        Ok(Some(Crossing {
            branch,
            flow: leg.at(0.5 * (low.0 + high.0)).flow,
            omega_rad_s: if at.state.real { 0.0 } else { at.state.p.im },
            unstable,
            beyond_table: at.state.beyond,
        }))
    }
}

/// Refuses an empty list, and airspeeds and densities that are not positive.
pub(super) fn checked(flows: &[Flow]) -> Result<(), FlutterError> {
    if flows.is_empty() {
        return Err(FlutterError::Empty("the list of flows"));
    }
    for (what, value) in flows.iter().flat_map(|f| [("airspeed", f.v_m_s), ("density", f.rho_kg_m3)]) {
        if !(value > 0.0 && value.is_finite()) {
            return Err(FlutterError::Number { what, value, expected: "positive" });
        }
    }
    Ok(())
}

pub(super) fn root_of(state: &State) -> Root {
    Root { p: state.p, beyond_table: state.beyond }
}

#[cfg(test)]
mod laws;

#[cfg(test)]
mod tests {
    use super::super::FormulaForces;
    use super::*;
    use faer::Mat;

    /// Whether one step from rest to a dynamic pressure is taken by the first of two modes, Q = (a, b; b, 0) without damping.
    fn is_taken(omega: [f64; 2], [a, b]: [f64; 2], q_pa: f64) -> bool {
        let formula = |_: f64| Mat::from_fn(2, 2, |i, j| c64::from([[a, b], [b, 0.0]][i][j]));
        let forces = FormulaForces { size: 2, range: (0.0, 1e4), formula };
        let system = Aeroelastic::of_modes(&omega, 0.0, &forces).expect("two modes");
        let state = system.modes().expect("modes in a vacuum").remove(0);
        let flow = Flow { v_m_s: 10.0, rho_kg_m3: 2.0 * q_pa / 100.0 };
        let track = Track { state, before: None };
        system.step(&track, Place { flow, share: 1.0 }, 1.0).expect("forces").is_some()
    }

    #[test]
    fn a_root_further_than_a_twentieth_from_its_guess_is_not_taken_for_the_next() {
        // omega² = 100 + 2 q, guessed at 10: the root moves by a twentieth of itself at q = (100/.95² - 100)/2 = 5.402
        let stiffening = |q_pa| is_taken([10.0, 30.0], [-2.0, 0.0], q_pa);
        assert!(stiffening(5.40) && !stiffening(5.41));
    }

    #[test]
    fn a_root_whose_shape_has_turned_is_not_taken_for_the_next() {
        // K = (100, q; q, 101): shapes turn by t with tan 2t = 2 q, the root by half a thousandth; cos² t = .9 at tan 2t = .75
        let coupled = |q_pa| is_taken([10.0, f64::sqrt(101.0)], [0.0, -1.0], q_pa);
        assert!(coupled(0.374) && !coupled(0.376));
    }
}
