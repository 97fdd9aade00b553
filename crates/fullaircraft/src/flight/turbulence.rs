//! Loads in continuous turbulence: transfer functions of all net loads at stations, and the state that goes with a load at its limit.
//!
//! What goes with a load i is `+- U_sigma int Re(x conj H_i) Phi dOmega/A_i` for every state and input x. Loads at stations and nodes
//! are linear in these, so cards made of that state sum up to the limit load of i and to the companions of all others.

use crate::flight::held::Held;
use crate::flight::load_sources::{CHANGING, SIX};
use crate::flight::loads::{FlightLoads, FlownLoads};
use crate::stations::along::Along;
use coupling::GRAVITY_M_S2;
use faer::{Mat, c64};
use loads::turbulence::{Grid, Response, Turbulence};

/// Panels of the grid of frequencies a decade: half as many change A by less than 1e-9 on the shipped aircraft, whose modes have panels
/// of their own.
pub const PANELS_A_DECADE: f64 = 3.0;
/// A load whose A is less than this share of the largest force or moment is nothing but rounding.
const NOTHING: f64 = 1e-9;

/// A load at its limit: of a station, along a direction, the larger or the smaller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtLimit {
    /// Place of the station.
    pub station: usize,
    /// What is at its limit; each load over its own A.
    pub along: Along,
    /// Whether it is the largest.
    pub is_largest: bool,
}

/// Net loads of stations and the load factor in turbulence, per m/s.
#[derive(Debug)]
pub(crate) struct NetLoads {
    pub(crate) grid: Grid,
    turbulence: Turbulence,
    stations: usize,
    /// Net loads of the stations, six each, then the load factor if the whole is one of them, at the frequencies of the grid.
    loads: Vec<Vec<c64>>,
}

/// An aircraft in turbulence.
#[derive(Debug)]
pub struct TurbulentLoads<'a> {
    flight: &'a FlightLoads<'a>,
    pub(crate) net: NetLoads,
    states: Vec<Vec<c64>>,
    inputs: Vec<Vec<c64>>,
}

impl NetLoads {
    /// Of stations, six each, then the load factor if there is one.
    pub(crate) fn new(grid: Grid, turbulence: Turbulence, stations: usize, loads: Vec<Vec<c64>>) -> Self {
        Self { grid, turbulence, stations, loads }
    }

    /// Root mean squares, crossings and correlations of all.
    pub(crate) fn response(&self) -> Response<'_> {
        self.response_of(&self.loads)
    }

    /// The same of others.
    pub(crate) fn response_of<'l>(&'l self, loads: &'l [Vec<c64>]) -> Response<'l> {
        Response::new(&self.grid, self.turbulence, loads)
    }

    /// How many stations there are.
    pub(crate) fn stations(&self) -> usize {
        self.stations
    }

    /// Which loads are more than rounding.
    pub(crate) fn is_something(&self, response: &Response<'_>) -> Vec<bool> {
        let stations = SIX * self.stations;
        let kind = |at: usize| if at < stations { 1 + at % SIX / 3 } else { 0 };
        let largest = |of: usize| {
            let own = (0..self.loads.len()).filter(|at| kind(*at) == of);
            own.map(|at| response.a_bar(at)).fold(0.0, f64::max)
        };
        let by_kind = [largest(0), largest(1), largest(2)];
        (0..self.loads.len()).map(|at| response.a_bar(at) > NOTHING * by_kind[kind(at)]).collect()
    }

    /// What is at its limit, each load over its own A.
    pub(crate) fn at_limits(&self, limits: &[AtLimit]) -> Vec<Vec<c64>> {
        let response = self.response();
        let something = self.is_something(&response);
        let combined = |limit: &AtLimit| -> Vec<c64> {
            let first = SIX * limit.station;
            let mut sum = vec![c64::ZERO; self.grid.omega_rad_s.len()];
            for (load, share) in limit.along.shares.iter().enumerate() {
                if *share != 0.0 && something[first + load] {
                    let share = share / response.a_bar(first + load);
                    sum.iter_mut().zip(&self.loads[first + load]).for_each(|(sum, h)| *sum += h * share);
                }
            }
            sum
        };
        limits.iter().map(combined).collect()
    }
}

impl<'a> FlightLoads<'a> {
    /// The aircraft with airspeed and attitude held.
    pub fn held(&self) -> Held<'_> {
        Held::new(&self.free)
    }

    /// Its answer to turbulence at the frequencies of a grid, per m/s.
    pub fn in_turbulence(
        &'a self,
        held: &Held<'_>,
        turbulence: Turbulence,
        grid: Grid,
    ) -> TurbulentLoads<'a> {
        let waves = held.waves(&grid.omega_rad_s);
        let real = |of: &[Vec<c64>], part: fn(&c64) -> f64| {
            Mat::from_fn(of.len(), grid.omega_rad_s.len(), |i, k| part(&of[i][k]))
        };
        let both = |part: fn(&c64) -> f64| {
            &self.by_state * real(&waves.states, part) + &self.by_input * real(&waves.inputs, part)
        };
        let changes = [both(|value| value.re), both(|value| value.im)];
        let row = |at: usize, k: usize| c64::new(changes[0][(at, k)], changes[1][(at, k)]);
        let frequencies = || 0..grid.omega_rad_s.len();
        let net = |at: usize| -> Vec<c64> {
            let first = SIX * CHANGING.len() * (at / SIX) + at % SIX;
            frequencies().map(|k| (0..CHANGING.len()).map(|part| row(first + SIX * part, k)).sum()).collect()
        };
        let mut loads: Vec<Vec<c64>> = (0..SIX * self.stations.len()).map(net).collect();
        let weight_n = self.aircraft.mass.mass_kg * GRAVITY_M_S2;
        let whole =
            self.stations.iter().position(|station| station.nodes.len() == self.aircraft.free.node_count());
        loads.extend(whole.map(|whole| {
            frequencies().map(|k| row(SIX * CHANGING.len() * whole + 2, k) / weight_n).collect()
        }));
        let net = NetLoads::new(grid, turbulence, self.stations.len(), loads);
        TurbulentLoads { flight: self, net, states: waves.states, inputs: waves.inputs }
    }
}

impl<'a> TurbulentLoads<'a> {
    /// Frequencies with their weights.
    pub fn grid(&self) -> &Grid {
        &self.net.grid
    }

    /// A net load (Fx, Fy, Fz, Mx, My, Mz) of a station at the frequencies of the grid, per m/s, the gust's phase zero at the foremost
    /// station of the gust: change from the trim.
    pub fn transfer(&self, station: usize, load: usize) -> &[c64] {
        &self.net.loads[SIX * station + load]
    }

    /// Root mean squares, crossings and correlations: Fx, Fy, Fz, Mx, My, Mz of each station, then the load factor (of the air's lift)
    /// if one of the stations is the whole.
    pub fn response(&self) -> Response<'_> {
        self.net.response()
    }

    /// Which loads are more than rounding.
    pub fn is_something(&self, response: &Response<'_>) -> Vec<bool> {
        self.net.is_something(response)
    }

    /// Loads with each of these at its limit for an intensity, m/s TAS: a sample each, in the order given, at no time.
    pub fn at_limits(&self, limits: &[AtLimit], u_sigma_m_s: f64) -> FlownLoads<'a> {
        let wanted = self.net.at_limits(limits);
        let of_wanted = self.net.response_of(&wanted);
        let goes = |of: &[Vec<c64>]| {
            Mat::from_fn(of.len(), limits.len(), |i, limit| {
                let sign = if limits[limit].is_largest { 1.0 } else { -1.0 };
                sign * u_sigma_m_s * of_wanted.companion(&of[i], limit)
            })
        };
        self.flight.flown(vec![0.0; limits.len()], goes(&self.states), goes(&self.inputs))
    }
}

#[cfg(test)]
mod tests;
