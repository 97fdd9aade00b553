//! Load steps: as long as they converge, as short as they must be.

use super::acting::Acting;
use super::error::NonlinearError;
use super::joints::LINEAR_TURN;
use super::loads::Loads;
use super::newton::{Converged, JUMP, converge};
use super::rotation::logarithm;
use super::stability;
use super::state::State;
use super::structure::LargeDeflection;

/// A step that took fewer iterations lets the next one grow.
const FEW: usize = 7;

/// By how much.
const GROWTH: f64 = 1.5;

/// Steps shorter than this are given up, in units of the whole load.
const SHORTEST: f64 = 1e-4;

/// Two load factors around the loss of stability are brought as near to each other, in units of the whole load.
const BRACKET: f64 = 1e-3;

/// All iterations of a path: it ends.
const ITERATIONS: usize = 5000;

/// How the load is applied.
#[derive(Debug, Clone, PartialEq)]
pub struct Controls {
    /// Load factors at which equilibria are wanted, ascending, the last is the end; one if there are none.
    pub stops: Vec<f64>,
    /// The first step that is tried.
    pub first_step: f64,
    /// Goes on along unstable equilibria, instead of ending where the first one is found. (Under loads that follow the
    /// structure stability is not judged.)
    pub accepts_unstable: bool,
}

impl Default for Controls {
    fn default() -> Self {
        Self { stops: vec![1.0], first_step: 1.0, accepts_unstable: false }
    }
}

/// An equilibrium on the way.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Share of the load: zero is the set of loads begun with, one the set aimed at.
    pub load_factor: f64,
    /// Where everything is.
    pub state: State,
    /// Iterations since the last one, those of steps that failed among them.
    pub iterations: usize,
    /// Negative pivots of the tangent: zero for a stable equilibrium. Nothing if loads follow the structure: the
    /// symmetric tangent does not tell.
    pub negative_pivots: Option<usize>,
    /// The largest rotation of a node within an element, rad, and the element.
    pub largest_local_rotation: (f64, u32),
}

/// Equilibria over the load.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// All that were computed, in ascending load; the last one is the end.
    pub points: Vec<Point>,
}

impl Path {
    /// The end.
    ///
    /// # Panics
    /// Never: a path has at least its end.
    pub fn end(&self) -> &Point {
        self.points.last().expect("a path has its end")
    }

    /// The state at one of the load factors that were asked for.
    pub fn at(&self, load_factor: f64) -> Option<&Point> {
        self.points.iter().find(|point| point.load_factor == load_factor)
    }
}

impl LargeDeflection {
    /// From `start`, in equilibrium under the loads `from`, to the equilibrium under `to`: loads grow in proportion.
    ///
    /// # Errors
    /// If the structure is loose, the load cannot be carried or makes it unstable, or what holds for small rotations only
    /// turns too far; with the last load factor that was reached.
    pub fn path(
        &self,
        start: &State,
        from: &Loads,
        to: &Loads,
        controls: &Controls,
    ) -> Result<Path, NonlinearError> {
        let at =
            |factor: f64| -> Box<dyn Acting> { Box::new(from.times(1.0 - factor).and(&to.times(factor))) };
        self.walk(start, &at, from.following.is_empty() && to.following.is_empty(), controls)
    }

    /// The same under whatever acts, by the share that has been reached of the way from one to the other; stability is not
    /// judged ([`LargeDeflection::following_gain`] does).
    ///
    /// # Errors
    /// As [`LargeDeflection::path`].
    pub fn path_under<'a>(
        &self,
        start: &State,
        at: &dyn Fn(f64) -> Box<dyn Acting + 'a>,
        controls: &Controls,
    ) -> Result<Path, NonlinearError> {
        self.walk(start, at, false, controls)
    }

    fn walk<'a>(
        &self,
        start: &State,
        at: &dyn Fn(f64) -> Box<dyn Acting + 'a>,
        judged: bool,
        controls: &Controls,
    ) -> Result<Path, NonlinearError> {
        self.check_held()?;
        let mut walk = Walk { structure: self, at, work: 0.0, iterations: 0 };
        let mut points: Vec<Point> = Vec::new();
        let (mut reached, mut state, mut step) = (0.0, start.clone(), controls.first_step);
        let (mut pending, mut growing) = (0, true);
        let watched = judged && !controls.accepts_unstable;
        for stop in if controls.stops.is_empty() { &[1.0][..] } else { &controls.stops } {
            while reached < *stop {
                let rest: f64 = stop - reached;
                // No sliver is left over.
                let (tried, is_stop) =
                    if step > 0.999 * rest { (*stop, true) } else { (reached + step, false) };
                match walk.to(&state, tried) {
                    Ok(found) if watched && (found.negative > 0 || found.overshoot > JUMP) => {
                        let length = tried - reached;
                        if found.negative > 0 && length <= BRACKET {
                            return Err(self.unstable(&found, reached, tried));
                        }
                        // A step that jumps from one branch to another however short it is is no way.
                        if length < SHORTEST {
                            return Err(NonlinearError::Stalled { load_factor: reached, tried, negative: 0 });
                        }
                        (step, growing) = (0.5 * length, growing && found.negative == 0);
                        pending += found.iterations;
                    }
                    Ok(found) => {
                        self.check_turns(&found.state, tried)?;
                        let taken = tried - reached;
                        if found.iterations < FEW && growing {
                            step = GROWTH * if is_stop { step.max(taken) } else { taken };
                        }
                        points.push(Point {
                            load_factor: tried,
                            largest_local_rotation: self.largest_local_rotation(&found.state),
                            state: found.state.clone(),
                            iterations: pending + found.iterations,
                            negative_pivots: judged.then_some(found.negative),
                        });
                        (reached, state, pending) = (tried, found.state, 0);
                    }
                    Err(failed) => {
                        step = 0.5 * (tried - reached);
                        pending += failed.iterations;
                        if step < SHORTEST || walk.iterations > ITERATIONS {
                            let negative = failed.negative;
                            return Err(NonlinearError::Stalled { load_factor: reached, tried, negative });
                        }
                    }
                }
            }
        }
        Ok(Path { points })
    }

    /// The equilibrium under dead or following loads, from the undeformed state.
    ///
    /// # Errors
    /// As [`LargeDeflection::path`].
    pub fn under(&self, loads: &Loads) -> Result<Path, NonlinearError> {
        self.path(&self.undeformed(), &Loads::default(), loads, &Controls::default())
    }

    fn unstable(&self, found: &Converged, load_factor: f64, unstable: f64) -> NonlinearError {
        let (mode, most) = stability::weakest(self, &found.state, &found.factor);
        let (grid, component) = self.name(most);
        NonlinearError::Unstable { load_factor, unstable, grid, component, mode }
    }

    /// Refuses what holds for small rotations only and has turned farther.
    fn check_turns(&self, state: &State, load_factor: f64) -> Result<(), NonlinearError> {
        let turned = |owner: String, angle: f64, limit: f64| NonlinearError::Turned {
            owner,
            turned_deg: angle.to_degrees(),
            limit_deg: limit.to_degrees(),
            load_factor,
        };
        for tie in &self.joints.linear {
            let angles = tie.nodes.iter().map(|node| logarithm(state.rotation(*node)).norm());
            let angle = angles.fold(0.0, f64::max);
            if angle > LINEAR_TURN {
                return Err(turned(tie.owner.clone(), angle, LINEAR_TURN));
            }
        }
        for element in self.elastic.iter().map(|at| &self.elements[*at]) {
            if let Some((angle, limit)) = element.beyond_limit(state) {
                return Err(turned(format!("element {}", element.id), angle, limit));
            }
        }
        Ok(())
    }
}

/// What acts by the share reached.
struct Walk<'a, 'b> {
    structure: &'a LargeDeflection,
    at: &'a dyn Fn(f64) -> Box<dyn Acting + 'b>,
    /// Largest work of a first iteration so far.
    work: f64,
    iterations: usize,
}

impl Walk<'_, '_> {
    fn to(&mut self, state: &State, factor: f64) -> Result<Converged, super::newton::Failed> {
        let acting = (self.at)(factor);
        let result = converge(self.structure, state, acting.as_ref(), &mut self.work);
        self.iterations += match &result {
            Ok(found) => found.iterations,
            Err(failed) => failed.iterations,
        };
        result
    }
}
