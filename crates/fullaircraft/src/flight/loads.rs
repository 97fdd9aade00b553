//! Loads in flight by what they come from, at stations and at all nodes: the trim's, and how they change in small motions.
//!
//! ```text
//! s = s_0 + C x + D u     sources: every motion the air answers, accelerations felt, dynamic pressure, the stream's axes
//! f = f_trim + df/ds (s - s_0)
//! air      T Gᵀ P as a whole about the centre of gravity;   at a node  f' = T f,  m' = T (m + a x f) - a x T f
//! inertia  - M (rigid and elastic acceleration, less gravity)
//! damping  - M Phi 2 zeta w eta'
//! ```
//! Stations and nodes have the same derivatives, so sums of nodal loads are the stations' loads to rounding. Elastic accelerations
//! are those of the modes that are kept.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::flight::air::{FlightAir, RIGID};
use crate::flight::drive::Drive;
use crate::flight::equations::Evaluated;
use crate::flight::gust::{Gust, GustAxis};
use crate::flight::load_sources::{CHANGING, Derivatives, SIX, Sources, read};
use crate::flight::model::{FlyingAircraft, Rows};
use crate::flight::small_motions::FreeFlight;
use crate::flight::state::mode_state;
use crate::stations::nodal::{Component, NodalLoads};
use crate::stations::places::Station;
use crate::trim::model::{FlightModel, Trimmed};
use faer::{Mat, MatRef};
use maneuver::ExactStep;
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

/// A trimmed aircraft whose loads in small motions are asked for.
#[derive(Debug)]
pub struct FlightLoads<'a> {
    pub(crate) aircraft: &'a Aircraft,
    pub(crate) free: FreeFlight,
    step: ExactStep,
    time_step_s: f64,
    sources: Sources,
    pub(crate) stations: Vec<Station>,
    /// Loads of the stations by states and by inputs: three components of six loads each.
    pub(crate) by_state: Mat<f64>,
    pub(crate) by_input: Mat<f64>,
    nodal: Nodal,
    steady: NodalLoads,
    steady_at_stations: Vec<[[f64; SIX]; 5]>,
    /// Height of the right and left tip per unit of each mode, and in the trim, m.
    tips: [Vec<f64>; 2],
    tips_at_trim_m: [f64; 2],
}

/// What makes nodal loads of sources.
#[derive(Debug)]
struct Nodal {
    /// Pressures by the air's motions.
    pressures: Mat<f64>,
    /// Corrected box loads of these pressures per unit dynamic pressure, two a box: factors in.
    corrections: aero::Corrections,
    momentum: Arc<Mat<f64>>,
    /// Damping of each mode by its rate over V: what its momentum is multiplied by, m/s².
    damping: Vec<f64>,
    q_pa: f64,
    turn: Matrix3<f64>,
    /// Box loads at the start.
    start: Vec<f64>,
}

/// Loads of one flight.
#[derive(Debug)]
pub struct FlownLoads<'a> {
    of: &'a FlightLoads<'a>,
    /// Time, s.
    pub t_s: Vec<f64>,
    states: Mat<f64>,
    inputs: Mat<f64>,
    /// Changes of the stations' loads, rows as in `by_state`, a column a sample.
    changes: Mat<f64>,
}

/// What is to be flown: a trimmed model with its air, its drives and the loads of its trim.
#[derive(Debug)]
pub struct LoadedTrim<'a> {
    /// The model.
    pub model: &'a FlightModel<'a>,
    /// Its air.
    pub air: &'a FlightAir,
    /// Its trim.
    pub trimmed: &'a Trimmed,
    /// Nodal loads of the trim.
    pub steady: NodalLoads,
    /// What moves it.
    pub drives: Vec<Drive>,
    /// Which way the air of the gusts moves that it meets.
    pub axis: GustAxis,
}

impl<'a> FlightLoads<'a> {
    /// Airspeed of the trim, m/s.
    pub fn v_m_s(&self) -> f64 {
        self.free.v_m_s()
    }

    /// How long the fastest growing motion of level flight takes to double, s; none if nothing grows.
    pub fn doubling_s(&self) -> Option<f64> {
        self.free.doubling_s()
    }

    /// Linearises the flight of a trimmed aircraft that may meet gusts, in steps of `time_step_s`.
    ///
    /// # Errors
    /// If the trim is not of this aircraft.
    pub fn new(
        trim: LoadedTrim<'a>,
        stations: Vec<Station>,
        time_step_s: f64,
    ) -> Result<Self, AircraftError> {
        let LoadedTrim { model, air, trimmed, steady, drives, axis } = trim;
        let aircraft = model.aircraft;
        let met = Gust { velocity_m_s: 0.0, length_m: 1.0, start_s: 0.0 };
        let rows = Rows::new(model, air, trimmed, &drives, Some(axis));
        let flying = FlyingAircraft::meeting(model, air, trimmed, drives, Some((met, axis)))?;
        let equations = &flying.equations;
        let state = equations.trimmed();
        let at_trim = equations.evaluate(&state, &equations.no_inputs());
        let sources = Sources::of(&state, &at_trim);
        let v_m_s = equations.reference.v_m_s;
        let momentum = air.momentum(aircraft);
        let damping: Vec<f64> =
            equations.omega_rad_s.iter().map(|omega| 2.0 * equations.damping_ratio * omega * v_m_s).collect();
        let by_source = Derivatives {
            aircraft,
            sources: &sources,
            at_trim: &at_trim,
            momentum: &momentum,
            damping: &damping,
        }
        .of_stations(&stations, &rows, equations.layout.motions);
        let free = FreeFlight::showing(flying, read);
        let nodal = Nodal::new(model, trimmed, &rows, &at_trim, (momentum, damping));
        let points = aircraft.free.points();
        let steady_at_stations = stations
            .iter()
            .map(|station| Component::ALL.map(|component| station.sums(points, &steady.of(component))))
            .collect();
        Ok(Self {
            step: ExactStep::new(free.a.as_ref(), free.b.as_ref(), time_step_s),
            tips: [&aircraft.right, &aircraft.left].map(|wing| heights(aircraft, air, wing.tip)),
            tips_at_trim_m: trimmed.tip_deflection_m,
            by_state: &by_source * &free.c,
            by_input: &by_source * &free.d,
            aircraft,
            time_step_s,
            sources,
            stations,
            nodal,
            steady,
            steady_at_stations,
            free,
        })
    }

    /// The stations.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Fx, Fy, Fz (N), Mx, My, Mz (N m) of a component at a station in the trim.
    pub fn at_trim(&self, station: usize, component: Component) -> [f64; SIX] {
        let place = Component::ALL.iter().position(|other| *other == component).unwrap_or(0);
        self.steady_at_stations[station][place]
    }

    /// Flies commands (rad, a list of samples a drive; a missing list is zero) and a gust along the axis of its air.
    pub fn fly(&'a self, gust: Option<Gust>, commands_rad: &[Vec<f64>], samples: usize) -> FlownLoads<'a> {
        let t_s = self.times(samples);
        let of = |drive: usize| {
            let given = commands_rad.get(drive);
            (0..samples).map(|k| given.and_then(|list| list.get(k)).copied().unwrap_or(0.0)).collect()
        };
        let commands: Vec<Vec<f64>> = (0..self.free.flying.drives.len()).map(of).collect();
        let inputs = self.free.inputs(gust, &commands, &t_s);
        let states = self.step.run(&vec![0.0; self.free.a.nrows()], inputs.as_ref());
        self.flown(t_s, states, inputs)
    }

    /// Flies several gusts side by side, which takes far less time than one after the other.
    pub fn fly_gusts(&'a self, gusts: &[Gust], samples: usize) -> Vec<FlownLoads<'a>> {
        let t_s = self.times(samples);
        let still = vec![vec![0.0; samples]; self.free.flying.drives.len()];
        let inputs: Vec<Mat<f64>> =
            gusts.iter().map(|gust| self.free.inputs(Some(*gust), &still, &t_s)).collect();
        let (n, m) = (self.free.a.nrows(), self.free.b.ncols());
        let at = |sample: usize| Mat::from_fn(m, gusts.len(), |row, gust| inputs[gust][(row, sample)]);
        let mut states = vec![Mat::zeros(n, samples); gusts.len()];
        let mut x = Mat::<f64>::zeros(n, gusts.len());
        for sample in 1..samples {
            x = &self.step.transition * &x
                + &self.step.from_first * at(sample - 1)
                + &self.step.from_last * at(sample);
            for (gust, states) in states.iter_mut().enumerate() {
                states.col_as_slice_mut(sample).copy_from_slice(x.col_as_slice(gust));
            }
        }
        let flown = states.into_iter().zip(inputs);
        flown.map(|(states, inputs)| self.flown(t_s.clone(), states, inputs)).collect()
    }

    fn times(&self, samples: usize) -> Vec<f64> {
        (0..samples).map(|k| k as f64 * self.time_step_s).collect()
    }

    pub(crate) fn flown(&'a self, t_s: Vec<f64>, states: Mat<f64>, inputs: Mat<f64>) -> FlownLoads<'a> {
        let changes = &self.by_state * &states + &self.by_input * &inputs;
        FlownLoads { of: self, t_s, states, inputs, changes }
    }
}

impl FlownLoads<'_> {
    /// Fx, Fy, Fz (N), Mx, My, Mz (N m) of a component at a station at a sample.
    pub fn at_station(&self, station: usize, component: Component, sample: usize) -> [f64; SIX] {
        let mut loads = self.of.at_trim(station, component);
        for (at, changing) in CHANGING.iter().enumerate() {
            if component != *changing && component != Component::Net {
                continue;
            }
            let first = SIX * (CHANGING.len() * station + at);
            (0..SIX).for_each(|load| loads[load] += self.changes[(first + load, sample)]);
        }
        loads
    }

    /// Loads at all nodes at a sample.
    pub fn nodal_loads(&self, sample: usize) -> NodalLoads {
        let column = |of: &Mat<f64>| Mat::from_fn(of.nrows(), 1, |i, _| of[(i, sample)]);
        let (free, sources) = (&self.of.free, &self.of.sources);
        let change = &free.c * column(&self.states) + &free.d * column(&self.inputs);
        let change = change.col_as_slice(0);
        let mut all = self.of.steady.clone();
        self.of.nodal.air(self.of.aircraft, sources, change, &mut all.air);
        let Nodal { momentum, damping, .. } = &self.of.nodal;
        // rates of the modes over V stand after the motions and the rigid motions' rates
        let rates = free.flying.equations.layout.motions + RIGID;
        add(&mut all.inertia, (**momentum).as_ref(), &change[sources.felt.clone()]);
        let damped: Vec<f64> = damping.iter().zip(&change[rates..]).map(|(by, rate)| by * rate).collect();
        add(&mut all.damping, (**momentum).as_ref().subcols(6, damped.len()), &damped);
        all
    }

    /// Height of the right and left tip over the plane of the wing's root at a sample, m, by the modes that are kept.
    pub fn tip_deflection_m(&self, sample: usize) -> [f64; 2] {
        let eta = |mode: usize| self.states[(mode_state(mode) - 1, sample)];
        std::array::from_fn(|side| {
            let change = self.of.tips[side].iter().enumerate().map(|(mode, height)| height * eta(mode));
            self.of.tips_at_trim_m[side] + change.sum::<f64>()
        })
    }

    /// Sample of the smallest and of the largest of the net loads at a station, one of Fx to Mz.
    pub fn ends(&self, station: usize, load: usize) -> [usize; 2] {
        let value = |sample: usize| self.at_station(station, Component::Net, sample)[load];
        let mut ends = [0, 0];
        for sample in 1..self.t_s.len() {
            if value(sample) < value(ends[0]) {
                ends[0] = sample;
            }
            if value(sample) > value(ends[1]) {
                ends[1] = sample;
            }
        }
        ends
    }
}

/// Takes a matrix times values off a list.
fn add(list: &mut [f64], matrix: MatRef<'_, f64>, values: &[f64]) {
    for (column, value) in values.iter().enumerate() {
        list.iter_mut().zip(matrix.col(column).iter()).for_each(|(sum, entry)| *sum -= entry * value);
    }
}

/// Height of a node over the plane of the centre per unit of each mode.
fn heights(aircraft: &Aircraft, air: &FlightAir, node: usize) -> Vec<f64> {
    let points = aircraft.free.points();
    let arm = points[node] - points[aircraft.centre];
    let height = |mode: usize| {
        let part = |node: usize, from: usize| {
            Vector3::from_fn(|axis, _| air.modes.elastic_shape(6 * node + from + axis, mode))
        };
        (part(node, 0) - part(aircraft.centre, 0) - part(aircraft.centre, 3).cross(&arm)).z
    };
    (0..air.modes.elastic()).map(height).collect()
}

impl Nodal {
    /// By the mass times modal and rigid accelerations, and the damping.
    fn new(
        model: &FlightModel<'_>,
        trimmed: &Trimmed,
        rows: &Rows<'_>,
        at_trim: &Evaluated,
        (momentum, damping): (Arc<Mat<f64>>, Vec<f64>),
    ) -> Self {
        let pressures = rows.pressures();
        let cp = &pressures * Mat::from_fn(at_trim.air.len(), 1, |i, _| at_trim.air[i]);
        let loads = model.aircraft.flow.integration.corrected(&model.corrections);
        let change = loads.of_pressures(at_trim.q_pa, cp.as_ref());
        Self {
            start: trimmed.box_loads.iter().enumerate().map(|(k, load)| load + change[(k, 0)]).collect(),
            corrections: model.corrections.clone(),
            turn: at_trim.turn,
            q_pa: at_trim.q_pa,
            pressures,
            momentum,
            damping,
        }
    }

    /// Adds the change of the air's loads.
    fn air(&self, aircraft: &Aircraft, sources: &Sources, change: &[f64], sums: &mut [f64]) {
        let air = &change[sources.air.clone()];
        let cp = &self.pressures * Mat::from_fn(air.len(), 1, |i, _| air[i]);
        let loads = aircraft.flow.integration.corrected(&self.corrections);
        let mut loads = loads.of_pressures(self.q_pa, cp.as_ref());
        let share = change[sources.q_pa] / self.q_pa;
        (0..loads.nrows()).for_each(|k| loads[(k, 0)] += share * self.start[k]);
        let moved = aircraft.spline.loads(loads.as_ref());
        let start = aircraft.spline.loads(Mat::from_fn(self.start.len(), 1, |k, _| self.start[k]).as_ref());
        let turned = Matrix3::from_iterator(change[sources.turn.clone()].iter().copied());
        for (node, point) in aircraft.free.points().iter().enumerate() {
            let arm = point - aircraft.mass.centre;
            for (turn, of) in [(&self.turn, &moved), (&turned, &start)] {
                let part = |from: usize| Vector3::from_fn(|axis, _| of[(6 * node + from + axis, 0)]);
                let (force, moment) = (turn * part(0), turn * (part(3) + arm.cross(&part(0))));
                let moment = moment - arm.cross(&force);
                for axis in 0..3 {
                    sums[6 * node + axis] += force[axis];
                    sums[6 * node + 3 + axis] += moment[axis];
                }
            }
        }
    }
}
