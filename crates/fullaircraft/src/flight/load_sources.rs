//! What loads in flight follow from, and how loads at stations follow from it: the derivatives of `loads.rs`.

use crate::aircraft::assembly::Aircraft;
use crate::flight::air::RIGID;
use crate::flight::equations::Evaluated;
use crate::flight::model::{FlyingAircraft, Rows};
use crate::flight::sensors::felt;
use crate::stations::nodal::Component;
use crate::stations::places::Station;
use faer::Mat;
use nalgebra::Vector3;
use std::ops::Range;

/// Components that change in flight, in the order of a station's rows.
pub(crate) const CHANGING: [Component; 3] = [Component::Air, Component::Inertia, Component::Damping];
/// Loads of a component at a station.
pub(crate) const SIX: usize = 6;

/// Where the sources stand in one list.
#[derive(Debug, Clone)]
pub(crate) struct Sources {
    pub(crate) air: Range<usize>,
    pub(crate) felt: Range<usize>,
    pub(crate) q_pa: usize,
    pub(crate) turn: Range<usize>,
}

impl Sources {
    /// Of an aircraft's state.
    pub(crate) fn of(state: &[f64], evaluated: &Evaluated) -> Self {
        let (n_air, n_felt) = (evaluated.air.len(), felt(state, evaluated).len());
        let q_pa = n_air + n_felt;
        Self { air: 0..n_air, felt: n_air..q_pa, q_pa, turn: q_pa + 1..q_pa + 1 + evaluated.turn.len() }
    }
}

/// All sources at a moment.
pub(crate) fn read(_: &FlyingAircraft, state: &[f64], evaluated: &Evaluated) -> Vec<f64> {
    let mut all = evaluated.air.clone();
    all.extend(felt(state, evaluated));
    all.push(evaluated.q_pa);
    all.extend(evaluated.turn.iter());
    all
}

/// What loads at stations are made from.
pub(crate) struct Derivatives<'a> {
    pub(crate) aircraft: &'a Aircraft,
    pub(crate) sources: &'a Sources,
    pub(crate) at_trim: &'a Evaluated,
    pub(crate) momentum: &'a Mat<f64>,
    /// Damping of each mode by its rate over V: what its momentum is multiplied by, m/s².
    pub(crate) damping: &'a [f64],
}

impl Derivatives<'_> {
    /// Loads of all stations by sources; `motions` is the number of motions the air answers.
    pub(crate) fn of_stations(&self, stations: &[Station], rows: &Rows<'_>, motions: usize) -> Mat<f64> {
        let mut all = Mat::zeros(SIX * CHANGING.len() * stations.len(), self.sources.turn.end);
        let system = &self.aircraft.free;
        for (at, station) in stations.iter().enumerate() {
            let first = SIX * CHANGING.len() * at;
            self.put_air(station, rows, &mut all, first);
            let own = station.motions(system, &station.point);
            let inertia = own.transpose() * self.momentum;
            for load in 0..SIX {
                for (column, place) in self.sources.felt.clone().enumerate() {
                    all[(first + SIX + load, place)] = -inertia[(load, column)];
                }
                for (mode, damping) in self.damping.iter().enumerate() {
                    all[(first + 2 * SIX + load, motions + RIGID + mode)] =
                        -inertia[(load, 6 + mode)] * damping;
                }
            }
        }
        all
    }

    /// Six rows of a station's air from `first` on: `d(T q p) = T q by d(air) + T p dq + dT q p`, then about the station's point.
    fn put_air(&self, station: &Station, rows: &Rows<'_>, all: &mut Mat<f64>, first: usize) {
        let (aircraft, at_trim, sources) = (self.aircraft, self.at_trim, self.sources);
        let motions = station.motions(&aircraft.free, &aircraft.mass.centre);
        let boxes = aircraft.spline.displace(motions.as_ref());
        let air = rows.of(&boxes.transpose().to_owned());
        let at_start = air.at(&at_trim.air);
        let arm = aircraft.mass.centre - station.point;
        let mut put = |column: usize, force: Vector3<f64>, moment: Vector3<f64>| {
            let moment = moment + arm.cross(&force);
            for axis in 0..3 {
                all[(first + axis, column)] = force[axis];
                all[(first + 3 + axis, column)] = moment[axis];
            }
        };
        let parts = |of: &[f64]| [0, 3].map(|from| Vector3::new(of[from], of[from + 1], of[from + 2]));
        for column in sources.air.clone() {
            let [force, moment] =
                parts(air.by.col_as_slice(column)).map(|part| at_trim.turn * part * at_trim.q_pa);
            put(column, force, moment);
        }
        let start = parts(&at_start);
        let [force, moment] = start.map(|part| at_trim.turn * part);
        put(sources.q_pa, force, moment);
        for (at, column) in sources.turn.clone().enumerate() {
            // entries of the turn, column by column
            let unit = |part: Vector3<f64>| Vector3::ith(at % 3, part[at / 3] * at_trim.q_pa);
            put(column, unit(start[0]), unit(start[1]));
        }
    }
}
