//! Results of a stability analysis: roots over airspeed, and where they change their stability.

use super::FlutterError;
use aero::Flow;
use faer::c64;
use std::f64::consts::TAU;

/// Growth over the modulus of a root up to which it is round-off: a mode on which no air acts and that nothing damps has that of
/// its computation, of either sign, and would flutter wherever it changes.
const ROUND_OFF: f64 = 1e-11;

/// A root at one flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// Root, 1/s: growth rate and frequency in rad/s (zero for one that does not oscillate).
    pub p: c64,
    /// Whether its frequency is beyond the table of forces, so that Re Q and Im Q/kappa of the table's end are held.
    pub beyond_table: bool,
}

/// How fast a root grows, 1/s, above what is round-off; below zero if it does not.
pub(super) fn growth(p: c64) -> f64 {
    p.re - ROUND_OFF * p.norm()
}

impl Root {
    /// Frequency, Hz.
    pub fn frequency_hz(&self) -> f64 {
        self.p.im / TAU
    }

    /// Whether it grows, by more than round-off.
    pub fn is_growing(&self) -> bool {
        growth(self.p) > 0.0
    }

    /// Damping g as in V-g diagrams: twice the growth rate over the frequency, negative if stable; `None` without
    /// oscillation.
    pub fn damping_g(&self) -> Option<f64> {
        (self.p.im > 0.0).then(|| 2.0 * self.p.re / self.p.im)
    }
}

/// A change of stability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The mode it is a branch of, counted from 0.
    pub branch: usize,
    /// Where.
    pub flow: Flow,
    /// Frequency, rad/s; zero for divergence.
    pub omega_rad_s: f64,
    /// Whether it becomes unstable there (and not stable again).
    pub unstable: bool,
    /// Whether its frequency is beyond the table of forces: then it is a hint and no result.
    pub beyond_table: bool,
}

impl Crossing {
    /// Frequency, Hz; zero for divergence.
    pub fn frequency_hz(&self) -> f64 {
        self.omega_rad_s / TAU
    }
}

/// Roots of each mode over the flows asked for.
#[derive(Debug, Clone)]
pub struct FlutterCurves {
    /// The flows, in the order asked for.
    pub flows: Vec<Flow>,
    /// A list for each mode in ascending frequency: its root at each flow. A list that is shorter than the flows belongs to a
    /// mode that could not be followed further.
    pub branches: Vec<Vec<Root>>,
    /// Changes of stability, in the order of the flows.
    pub crossings: Vec<Crossing>,
    /// Why modes could not be followed to the last flow.
    pub lost: Vec<FlutterError>,
}

impl FlutterCurves {
    /// The first oscillation that becomes unstable.
    pub fn flutter(&self) -> Option<&Crossing> {
        first_flutter(&self.crossings)
    }
}

/// The first of changes of stability at which an oscillation becomes unstable.
pub fn first_flutter(changes: &[Crossing]) -> Option<&Crossing> {
    changes.iter().find(|crossing| crossing.unstable && crossing.omega_rad_s > 0.0)
}

/// What was found, each with its leg (the place of the flow before it), in the order of the way.
pub(super) fn in_order(flows: &[Flow], mut found: Vec<(usize, Crossing)>) -> Vec<Crossing> {
    let share = |(leg, crossing): &(usize, Crossing)| share(&flows[*leg], &flows[*leg + 1], &crossing.flow);
    found.sort_by(|a, b| a.0.cmp(&b.0).then(share(a).total_cmp(&share(b))));
    found.into_iter().map(|(_, crossing)| crossing).collect()
}

/// How far along the way between two flows, along which airspeed and density change in proportion, a flow of it stands: from 0 to 1.
pub(super) fn share(from: &Flow, to: &Flow, flow: &Flow) -> f64 {
    let along = |of: fn(&Flow) -> f64| {
        let (a, b, x) = (of(from), of(to), of(flow));
        let size = a.max(b);
        [(b - a) / size, (x - a) / size]
    };
    let [v, rho] = [along(|flow| flow.v_m_s), along(|flow| flow.rho_kg_m3)];
    (v[0] * v[1] + rho[0] * rho[1]) / (v[0] * v[0] + rho[0] * rho[0])
}

#[cfg(test)]
mod tests;
