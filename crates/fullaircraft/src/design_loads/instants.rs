//! Instants of a flight that can drive a load: where Fz, Mx or My of a station is at an end, or a corner of Mx with My.

use crate::flight::loads::FlownLoads;
use crate::stations::nodal::Component;
use serde::{Deserialize, Serialize};

/// Loads at an instant of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FlownInstant {
    /// From the start of the motion; zero in steady flight, s.
    pub t_s: f64,
    /// Height of the right and left tip over the plane of the wing's root, m.
    pub tips_m: [f64; 2],
    /// By station and component (in the order of [`Component::ALL`]): Fx, Fy, Fz, N, Mx, My, Mz, N m.
    pub loads: Vec<[[f64; 6]; 5]>,
}

/// A case that was flown, or why it was not.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FlownCase {
    /// Its number in the matrix.
    pub number: usize,
    /// Which of the two models: initial, updated.
    pub model: usize,
    /// Why it could not be flown.
    pub refused: Option<String>,
    /// Its instants in time.
    pub instants: Vec<FlownInstant>,
}

/// Directions in the plane of each load over its range that are looked along: Fz, Mx, My, and both diagonals of Mx and My.
const ALONG: [[f64; 3]; 5] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]];

/// Of the first samples, in ascending order, those at which some station's net load is furthest along one of the directions, either way.
pub fn driving(flown: &FlownLoads<'_>, stations: usize, first: usize) -> Vec<usize> {
    let mut samples = Vec::new();
    for station in 0..stations {
        let loads: Vec<[f64; 3]> = (0..first.min(flown.t_s.len()))
            .map(|sample| {
                let six = flown.at_station(station, Component::Net, sample);
                [six[2], six[3], six[4]]
            })
            .collect();
        let range: [f64; 3] = std::array::from_fn(|load| {
            let of = || loads.iter().map(|three| three[load]);
            let range = of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min);
            if range > 0.0 { range } else { 1.0 }
        });
        for direction in ALONG {
            let far = |sample: &usize| -> f64 {
                (0..3).map(|load| direction[load] * loads[*sample][load] / range[load]).sum()
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
            tips_m: flown.tip_deflection_m(sample),
            loads: (0..stations).map(at).collect(),
        }
    }

    /// Net loads of each station.
    pub fn net(&self) -> Vec<[f64; 6]> {
        self.loads.iter().map(|components| components[Component::ALL.len() - 1]).collect()
    }
}
