//! All p-k roots through a list of flows: those of the first flow are followed, and at every flow the list is compared with a
//! sweep, so that roots of rigid motions, roots that begin in the air and roots that were lost on the way are there too.

use super::curves::{Crossing, Root, share};
use super::pk::{Leg, Track, checked, root_of};
use super::root::{Place, State};
use super::{Aeroelastic, FlutterError};
use aero::Flow;

/// Roots nearer to each other than this share of themselves are one.
const SAME: f64 = 1e-6;

/// A root through the flows.
#[derive(Debug, Clone)]
pub struct Branch {
    /// Place of its first flow.
    pub first: usize,
    /// The root at each flow from there on, until it ends.
    pub roots: Vec<Root>,
}

impl Branch {
    /// The root at a flow.
    pub fn at(&self, flow: usize) -> Option<&Root> {
        self.roots.get(flow.checked_sub(self.first)?)
    }
}

/// All roots over the flows asked for.
#[derive(Debug, Clone)]
pub struct CompleteCurves {
    /// The flows, in the order asked for.
    pub flows: Vec<Flow>,
    /// The roots: of the first flow real ones, then by rising frequency; then those that begin later.
    pub branches: Vec<Branch>,
    /// Changes of stability, in the order of the flows and of the way between two.
    pub crossings: Vec<Crossing>,
    /// Branches that are unstable where they begin, behind the first flow: they became so on the way there.
    pub begun_unstable: Vec<usize>,
}

impl CompleteCurves {
    /// The first oscillation that becomes unstable.
    pub fn flutter(&self) -> Option<&Crossing> {
        self.crossings.iter().find(|crossing| crossing.unstable && crossing.omega_rad_s > 0.0)
    }

    /// The first root without oscillation that becomes unstable.
    pub fn divergence(&self) -> Option<&Crossing> {
        self.crossings.iter().find(|crossing| crossing.unstable && crossing.omega_rad_s == 0.0)
    }
}

impl Aeroelastic<'_> {
    /// All p-k roots at a list of flows, and where they change their stability. Coordinates may have no stiffness.
    ///
    /// # Errors
    /// If there is no flow, an airspeed or density is not positive, or eigenvalues do not converge.
    pub fn pk_complete(&self, flows: &[Flow]) -> Result<CompleteCurves, FlutterError> {
        checked(flows)?;
        let mut curves = CompleteCurves {
            flows: flows.to_vec(),
            branches: Vec::new(),
            crossings: Vec::new(),
            begun_unstable: Vec::new(),
        };
        let mut live: Vec<(usize, Track)> = Vec::new();
        for (place, flow) in flows.iter().enumerate() {
            let here = Place { flow: *flow, share: 1.0 };
            if place > 0 {
                let leg = Leg { from: Place { flow: flows[place - 1], share: 1.0 }, to: here };
                live = self.followed(live, leg, &mut curves)?;
            }
            let known: Vec<&State> = live.iter().map(|(_, track)| &track.state).collect();
            for state in self.all_roots(here, &known)? {
                let is_same = |other: &State| {
                    let near = (other.p - state.p).norm() <= SAME * self.modulus(state.p);
                    near && self.likeness(&other.u, &state.u) > 0.5
                };
                if live.iter().any(|(_, track)| is_same(&track.state)) {
                    continue;
                }
                if place > 0 && root_of(&state).is_growing() {
                    curves.begun_unstable.push(curves.branches.len());
                }
                live.push((curves.branches.len(), Track { state, before: None }));
                curves.branches.push(Branch { first: place, roots: Vec::new() });
            }
            for (branch, track) in &live {
                curves.branches[*branch].roots.push(root_of(&track.state));
            }
        }
        Ok(curves)
    }

    /// The branches at the end of a leg; those that end on the way are left out.
    fn followed(
        &self,
        live: Vec<(usize, Track)>,
        leg: Leg,
        curves: &mut CompleteCurves,
    ) -> Result<Vec<(usize, Track)>, FlutterError> {
        let mut arrived: Vec<(usize, Track)> = Vec::with_capacity(live.len());
        let mut found = Vec::new();
        for (branch, track) in live {
            let (next, crossing) = match self.march(track.clone(), leg, 1.0, branch) {
                Ok(next) => match self.crossing(&track, &next, leg, branch) {
                    Ok(crossing) => (next, crossing),
                    Err(FlutterError::Lost { .. }) => continue,
                    Err(error) => return Err(error),
                },
                Err(FlutterError::Lost { .. }) => continue,
                Err(error) => return Err(error),
            };
            // Two that arrive at one root: one of them has lost its way.
            let is_there = |(_, other): &(usize, Track)| {
                (other.state.p - next.state.p).norm() <= SAME * self.modulus(next.state.p)
                    && self.likeness(&other.state.u, &next.state.u) > 1.0 - SAME
            };
            if !arrived.iter().any(is_there) {
                found.extend(crossing);
                arrived.push((branch, next));
            }
        }
        let share = |crossing: &Crossing| share(&leg.from.flow, &leg.to.flow, &crossing.flow);
        found.sort_by(|a, b| share(a).total_cmp(&share(b)));
        curves.crossings.extend(found);
        Ok(arrived)
    }
}
