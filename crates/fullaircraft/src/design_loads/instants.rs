//! Instants of a flight that can drive a load: where one of the loads that are looked at is at an end, or a corner of two moments.

use crate::flight::gust::GustAxis;
use crate::flight::loads::FlownLoads;
use crate::stations::nodal::Component;
use loads::design::Attitude;
use serde::{Deserialize, Serialize};

/// Loads at an instant of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FlownInstant {
    /// From the start of the motion; zero in steady flight and in turbulence, s.
    pub t_s: f64,
    /// Gradient of the gust, m, if it is none of the plan's but was searched for.
    #[serde(default)]
    pub gradient_m: Option<f64>,
    /// Which load is at its limit, in turbulence.
    #[serde(default)]
    pub limit: Option<Limit>,
    /// Height of the right and left tip over the plane of the wing's root, m.
    pub tips_m: [f64; 2],
    /// By station and component (in the order of [`Component::ALL`]): Fx, Fy, Fz, N, Mx, My, Mz, N m.
    pub loads: Vec<[[f64; 6]; 5]>,
}

/// A load at its limit in turbulence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Limit {
    /// Place of the station.
    pub station: usize,
    /// Which of the directions that are looked at.
    pub direction: usize,
    /// Whether it is the largest, or the smallest.
    pub is_largest: bool,
}

impl Limit {
    /// In words.
    pub fn words(self, axis: GustAxis, stations: &[String]) -> String {
        let end = if self.is_largest { "largest" } else { "smallest" };
        format!("{} {} {end}", stations[self.station], axis.along()[self.direction].words)
    }
}

/// A case that was flown, or why it was not.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct FlownCase {
    /// Its number in the matrix.
    pub number: usize,
    /// Which of the two models: initial, updated.
    pub model: usize,
    /// Why it could not be flown.
    pub refused: Option<String>,
    /// Its instants in time.
    pub instants: Vec<FlownInstant>,
    /// What turbulence does, if it was flown in it.
    #[serde(default)]
    pub turbulence: Option<TurbulenceFacts>,
}

/// Statistics of loads in turbulence.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TurbulenceFacts {
    /// Limit intensity, m/s TAS.
    pub u_sigma_m_s: f64,
    /// The net loads of stations that turbulence moves.
    pub loads: Vec<TurbulentLoad>,
    /// Of the load factor, A (per m/s), N0 (Hz).
    pub load_factor: Option<[f64; 2]>,
    /// Correlations of the loads that are looked at: places of two in `loads`, rho.
    pub correlations: Vec<(usize, usize, f64)>,
    /// What keeps airspeed and attitude.
    pub attitude: Attitude,
}

/// A load in turbulence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TurbulentLoad {
    /// Place of the station.
    pub station: usize,
    /// Fx, Fy, Fz, Mx, My, Mz.
    pub load: usize,
    /// In level flight, N, N m.
    pub one_g: f64,
    /// Root mean square by that of the turbulence, N or N m per m/s.
    pub a_bar: f64,
    /// Crossings of its mean upwards, Hz, below the cut-off.
    pub n0_hz: f64,
    /// By how much A may grow beyond the cut-off, share of A; none if a mode is there.
    pub tail_bound: Option<f64>,
}

/// Of so many samples, in ascending order, those at which some station's net load (`net`: of a station at a sample), each over its
/// range, is furthest along one of the directions of an axis, either way.
pub(super) fn driving(
    net: &dyn Fn(usize, usize) -> [f64; 6],
    stations: usize,
    samples: usize,
    axis: GustAxis,
) -> Vec<usize> {
    let count = samples;
    let mut samples = Vec::new();
    for station in 0..stations {
        let loads: Vec<[f64; 6]> = (0..count).map(|sample| net(station, sample)).collect();
        let range: [f64; 6] = std::array::from_fn(|load| {
            let of = || loads.iter().map(|six| six[load]);
            let range = of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min);
            if range > 0.0 { range } else { 1.0 }
        });
        for direction in axis.along() {
            let far = |sample: &usize| -> f64 {
                (0..6).map(|load| direction.shares[load] * loads[*sample][load] / range[load]).sum()
            };
            let all = 0..loads.len();
            samples.extend(all.clone().min_by(|a, b| far(a).total_cmp(&far(b))));
            samples.extend(all.max_by(|a, b| far(a).total_cmp(&far(b))));
        }
    }
    samples.sort_unstable();
    samples.dedup();
    samples
}

impl FlownInstant {
    /// The loads of a flight at a sample.
    pub fn of(flown: &FlownLoads<'_>, stations: usize, sample: usize) -> Self {
        let at = |station| Component::ALL.map(|component| flown.at_station(station, component, sample));
        Self {
            t_s: flown.t_s[sample],
            gradient_m: None,
            limit: None,
            tips_m: flown.tip_deflection_m(sample),
            loads: (0..stations).map(at).collect(),
        }
    }

    /// Net loads of each station.
    pub fn net(&self) -> Vec<[f64; 6]> {
        self.loads.iter().map(|components| components[Component::ALL.len() - 1]).collect()
    }
}

#[cfg(test)]
mod tests;
