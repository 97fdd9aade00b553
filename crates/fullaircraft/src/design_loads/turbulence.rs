//! Cases in continuous turbulence: limit loads about level flight, and the loads that go with each at its limit.

use crate::design_loads::fly::{Done, Nodal, refused};
use crate::design_loads::in_time::{InTime, unstable_words};
use crate::design_loads::instants::{FlownCase, FlownInstant, Limit, TurbulenceFacts, TurbulentLoad};
use crate::error::AircraftError;
use crate::flight::gust::GustAxis;
use crate::flight::held::Held;
use crate::flight::turbulence::{AtLimit, NetLoads, PANELS_A_DECADE, TurbulentLoads};
use crate::stations::along::DIRECTIONS;
use crate::stations::nodal::Component;
use loads::design::Attitude;
use loads::matrix::{Action, Case};
use loads::turbulence::{Grid, Mode, Turbulence};

impl InTime<'_> {
    /// Flies cases in turbulence.
    pub(super) fn turbulence<E: From<AircraftError>>(
        &self,
        cases: &[&Case],
        done: &mut Done<'_, E>,
    ) -> Result<(), E> {
        if cases.is_empty() {
            return Ok(());
        }
        let held = self.flight.held();
        let modes = held.modes().map_err(unstable_words);
        for case in cases {
            let flown =
                modes.as_ref().map_err(String::clone).and_then(|modes| self.rough(case, &held, modes));
            match flown {
                Ok((turbulent, u_sigma_m_s)) => {
                    let nodal: &Nodal<'_> = &|instant| {
                        let limit = at_limit(instant.limit?, self.axis);
                        Some(turbulent.at_limits(&[limit], u_sigma_m_s).nodal_loads(0))
                    };
                    done(self.limits(case, &turbulent, u_sigma_m_s), nodal)?;
                }
                Err(why) => done(refused(case, self.which, &why), &|_| None)?,
            }
        }
        Ok(())
    }

    /// The answer to a case's turbulence and its limit intensity, m/s TAS, or why there is none.
    fn rough(
        &self,
        case: &Case,
        held: &Held<'_>,
        modes: &[Mode],
    ) -> Result<(TurbulentLoads<'_>, f64), String> {
        let Action::Turbulence { u_sigma_m_s, scale_m, cut_off_hz, spectrum, .. } = case.action else {
            return Err("this is no turbulence".to_owned());
        };
        if cut_off_hz > self.highest_hz {
            return Err(format!(
                "the unsteady air is known up to {:.0} Hz at this airspeed, and the cut-off is {cut_off_hz} Hz",
                self.highest_hz
            ));
        }
        let v_m_s = self.flight.v_m_s();
        let grid = Grid::new(v_m_s, scale_m, cut_off_hz, modes, PANELS_A_DECADE);
        let turbulence = Turbulence { v_m_s, scale_m, spectrum };
        Ok((self.flight.in_turbulence(held, turbulence, grid), u_sigma_m_s))
    }

    /// Statistics of all loads, and an instant for each of those that are looked at, at both of its limits.
    fn limits(&self, case: &Case, turbulent: &TurbulentLoads<'_>, u_sigma_m_s: f64) -> FlownCase {
        let stations = self.plan.stations.len();
        let at_trim = |station: usize| self.flight.at_trim(station, Component::Net);
        let facts = facts(case, &turbulent.net, &at_trim, self.axis);
        let limits = limits(&facts, stations, self.axis);
        let wanted: Vec<AtLimit> = limits.iter().map(|limit| at_limit(*limit, self.axis)).collect();
        let flown = turbulent.at_limits(&wanted, u_sigma_m_s);
        let instants = limits.iter().enumerate().map(|(sample, limit)| FlownInstant {
            limit: Some(*limit),
            ..FlownInstant::of(&flown, stations, sample)
        });
        let instants = instants.collect();
        let turbulence = Some(facts);
        FlownCase { number: case.number, model: self.which, refused: None, instants, turbulence }.if_finite()
    }
}

/// A limit as turbulence knows it.
pub(super) fn at_limit(limit: Limit, axis: GustAxis) -> AtLimit {
    let Limit { station, direction, is_largest } = limit;
    AtLimit { station, along: axis.along()[direction], is_largest }
}

/// The limits that are looked at: both of each direction of a station that turbulence moves.
pub(super) fn limits(facts: &TurbulenceFacts, stations: usize, axis: GustAxis) -> Vec<Limit> {
    let moves = |station: usize, direction: usize| {
        let shares = axis.along()[direction].shares;
        facts.loads.iter().any(|load| load.station == station && shares[load.load] != 0.0)
    };
    let places = (0..stations).flat_map(|station| (0..DIRECTIONS).map(move |direction| (station, direction)));
    places
        .filter(|(station, direction)| moves(*station, *direction))
        .flat_map(|(station, direction)| {
            [false, true].map(|is_largest| Limit { station, direction, is_largest })
        })
        .collect()
}

/// Statistics of all loads of a case in turbulence; `at_trim` gives a station's net loads in level flight.
pub(super) fn facts(
    case: &Case,
    net: &NetLoads,
    at_trim: &dyn Fn(usize) -> [f64; 6],
    axis: GustAxis,
) -> TurbulenceFacts {
    let (attitude, u_sigma_m_s) = match case.action {
        Action::Turbulence { attitude, u_sigma_m_s, .. } => (attitude, u_sigma_m_s),
        _ => (Attitude::default(), 0.0),
    };
    let response = net.response();
    let something = net.is_something(&response);
    let of = 6 * net.stations();
    let one = |at: &usize| {
        let one_g = at_trim(at / 6)[at % 6];
        let (a_bar, n0_hz) = (response.a_bar(*at), response.n0_hz(*at));
        let tail_bound = response.tail_bound(*at);
        TurbulentLoad { station: at / 6, load: at % 6, one_g, a_bar, n0_hz, tail_bound }
    };
    let moved: Vec<usize> = (0..of).filter(|at| something[*at]).collect();
    let looked_at = |at: &usize| axis.along().iter().any(|along| along.shares[at % 6] != 0.0);
    let looked: Vec<usize> = (0..moved.len()).filter(|place| looked_at(&moved[*place])).collect();
    let pairs = looked.iter().enumerate();
    let pairs = pairs.flat_map(|(place, i)| looked[place + 1..].iter().map(move |j| (*i, *j)));
    let correlations = pairs.map(|(i, j)| (i, j, response.rho(moved[i], moved[j]))).collect();
    let load_factor =
        something.get(of).filter(|moves| **moves).map(|_| [response.a_bar(of), response.n0_hz(of)]);
    let loads = moved.iter().map(one).collect();
    TurbulenceFacts { u_sigma_m_s, loads, load_factor, correlations, attitude }
}
