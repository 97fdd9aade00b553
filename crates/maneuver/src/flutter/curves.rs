//! Results of a stability analysis: roots over airspeed, and where they change their stability.

use super::FlutterError;
use aero::Flow;
use faer::c64;
use std::f64::consts::TAU;

/// A root at one flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// Root, 1/s: growth rate and frequency in rad/s (zero for one that does not oscillate).
    pub p: c64,
    /// Whether its frequency is beyond the table of forces, so that apparent mass and damping of the table's end are held.
    pub beyond_table: bool,
}

impl Root {
    /// Frequency, Hz.
    pub fn frequency_hz(&self) -> f64 {
        self.p.im / TAU
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
        self.crossings.iter().find(|crossing| crossing.unstable && crossing.omega_rad_s > 0.0)
    }

    /// Sorts the crossings along the flows.
    pub(super) fn sort(&mut self) {
        let flows = &self.flows;
        let leg = |crossing: &Crossing| {
            flows.windows(2).position(|pair| {
                let inside = |of: fn(&Flow) -> f64| {
                    let (a, b, x) = (of(&pair[0]), of(&pair[1]), of(&crossing.flow));
                    a.min(b) <= x && x <= a.max(b)
                };
                inside(|flow| flow.v_m_s) && inside(|flow| flow.rho_kg_m3)
            })
        };
        self.crossings.sort_by(|a, b| {
            let same_leg = leg(a).cmp(&leg(b));
            same_leg.then(a.flow.dynamic_pressure_pa().total_cmp(&b.flow.dynamic_pressure_pa()))
        });
    }
}

#[cfg(test)]
mod tests;
