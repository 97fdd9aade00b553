//! What instruments on board show at a moment of flight, from the states and their rates.
//!
//! An inertial unit is fixed to a node: it turns with the aircraft and with the structure's slope there. It feels the
//! acceleration of its place less gravity (9.81 m/s² upwards at rest) along its own axes, x aft, y right, z up, and the
//! rotation rates of its node, which are reported as flight mechanics does (right wing down, nose up, nose right).
//! Its deflection is its height over the plane of the centre, the fuselage's grid at the wing's root.

use crate::aircraft::assembly::{Aircraft, WingPlaces};
use crate::flight::equations::{AirRows, Equations, Evaluated};
use crate::flight::modes::FreeModes;
use crate::flight::rows::{LoadParts, PRODUCTS};
use crate::flight::state::{PLACE, attitude, euler_angles, mode_state, vector};
use crate::trim::model::Trimmed;
use faer::Mat;
use nalgebra::Vector3;

/// Outputs before those of drives, units and loads: airspeed, angle of attack of the centre, sideslip, load factor, three rates,
/// three angles, three places.
pub(crate) const FIXED: usize = 13;
/// Outputs of a unit: deflection, three accelerations, three rates.
pub(crate) const PER_UNIT: usize = 7;

/// An inertial unit.
#[derive(Debug, Clone)]
pub(crate) struct Unit {
    pub(crate) name: String,
    /// From the centre of gravity, m.
    arm: Vector3<f64>,
    /// Displacement and rotation per unit of each elastic mode.
    moved: Vec<Vector3<f64>>,
    turned: Vec<Vector3<f64>>,
    /// Height over the plane of the centre per unit of each mode, and in the trim, m.
    height: Vec<f64>,
    height_at_trim_m: f64,
    /// Rotation of the structure in the trim, rad.
    slope_at_trim: Vector3<f64>,
}

/// All instruments of an aircraft.
#[derive(Debug, Clone)]
pub(crate) struct Sensors {
    pub(crate) units: Vec<Unit>,
    /// Which unit is the outermost of the right wing.
    pub(crate) outermost: usize,
    pub(crate) parts: Vec<String>,
    to_centre: Vec<Vector3<f64>>,
    loads: AirRows,
    inertia: Mat<f64>,
    /// Pitch of the centre per unit of each mode.
    pitch: Vec<f64>,
    alpha_at_trim_rad: f64,
    /// What is added to loads so that the first sample is the trim's.
    shift: Vec<f64>,
}

impl Sensors {
    /// Instruments of a trimmed aircraft; `eta` are the modes' amplitudes in the trim.
    pub(crate) fn new(
        aircraft: &Aircraft,
        modes: &FreeModes,
        trimmed: &Trimmed,
        eta: &[f64],
        parts: LoadParts,
        loads: AirRows,
        equations: &Equations,
    ) -> Self {
        let (units, outermost) = units(aircraft, modes, trimmed, eta);
        let pitch =
            (0..modes.elastic()).map(|mode| modes.elastic_shape(6 * aircraft.centre + 4, mode)).collect();
        let LoadParts { names: parts, to_centre, inertia, .. } = parts;
        let shift = vec![0.0; inertia.nrows()];
        let alpha_at_trim_rad = trimmed.alpha_rad;
        let mut sensors =
            Self { units, outermost, parts, to_centre, loads, inertia, pitch, alpha_at_trim_rad, shift };
        let state = equations.trimmed();
        let found = sensors.loads_at(&state, &equations.evaluate(&state, &equations.no_inputs()));
        let known: Vec<f64> = trimmed.root_loads.iter().flat_map(|loads| loads.to_array()).collect();
        for (row, known) in known.iter().enumerate() {
            sensors.shift[row] = known - found[row];
        }
        sensors
    }

    /// Number of outputs.
    pub(crate) fn count(&self, drives: usize) -> usize {
        self.first_load(drives) + 3 * self.parts.len()
    }

    /// First output of a unit.
    pub(crate) fn unit(drives: usize, unit: usize) -> usize {
        FIXED + drives + PER_UNIT * unit
    }

    /// First output of the loads.
    pub(crate) fn first_load(&self, drives: usize) -> usize {
        Self::unit(drives, self.units.len())
    }

    /// All outputs.
    pub(crate) fn read(&self, equations: &Equations, state: &[f64], evaluated: &Evaluated) -> Vec<f64> {
        let layout = equations.layout;
        let [v, alpha, beta] = Equations::stream_of(state);
        let pitch: f64 = self.pitch.iter().enumerate().map(|(i, p)| p * state[mode_state(i)]).sum();
        let lift = evaluated.q_pa * equations.generalised.at(&evaluated.air)[2];
        let omega = vector(state, 3);
        let mut out = Vec::with_capacity(self.count(layout.drives));
        out.extend([
            v,
            self.alpha_at_trim_rad + alpha - equations.reference.alpha_rad + pitch,
            beta,
            lift / (equations.mass_kg * equations.gravity_m_s2),
        ]);
        out.extend([-omega.x, omega.y, -omega.z]);
        out.extend(euler_angles(&attitude(state)));
        out.extend(&state[PLACE..PLACE + 3]);
        out.extend((0..layout.drives).map(|drive| state[layout.drive(drive)]));
        for unit in &self.units {
            out.extend(unit.read(equations, state, evaluated));
        }
        let loads = self.loads_at(state, evaluated);
        out.extend(loads.iter().zip(&self.shift).map(|(load, shift)| load + shift));
        out
    }

    /// Sums of air and inertia over the parts.
    fn loads_at(&self, state: &[f64], evaluated: &Evaluated) -> Vec<f64> {
        let accelerations = felt(state, evaluated);
        let air = self.loads.at(&evaluated.air);
        let mut loads = Vec::with_capacity(self.inertia.nrows());
        for (part, arm) in self.to_centre.iter().enumerate() {
            let of = |from: usize| evaluated.turn * vector(&air, 6 * part + from) * evaluated.q_pa;
            let (force, moment) = (of(0), of(3));
            let moment = moment + arm.cross(&force);
            loads.extend([force.z, moment.x, moment.y]);
        }
        for (row, load) in loads.iter_mut().enumerate() {
            *load -= accelerations.iter().enumerate().map(|(j, a)| self.inertia[(row, j)] * a).sum::<f64>();
        }
        loads
    }
}

/// Accelerations against free fall in the order of the inertia's columns.
pub(crate) fn felt(state: &[f64], evaluated: &Evaluated) -> Vec<f64> {
    let (velocity, omega) = (vector(state, 0), vector(state, 3));
    let turning = omega.cross(&velocity) - evaluated.gravity;
    let mut all: Vec<f64> = evaluated.accelerations.iter().copied().collect();
    for axis in 0..3 {
        all[axis] += turning[axis];
    }
    all.extend(PRODUCTS.iter().map(|&(i, j)| omega[i] * omega[j]));
    all
}

impl Unit {
    fn read(&self, equations: &Equations, state: &[f64], evaluated: &Evaluated) -> [f64; PER_UNIT] {
        let layout = equations.layout;
        let (velocity, omega) = (vector(state, 0), vector(state, 3));
        let of = |shapes: &[Vector3<f64>], value: &dyn Fn(usize) -> f64| {
            shapes.iter().enumerate().map(|(mode, shape)| shape * value(mode)).sum::<Vector3<f64>>()
        };
        let eta = |mode: usize| state[mode_state(mode)];
        let rate = |mode: usize| state[layout.mode_rate(mode)];
        let second = |mode: usize| evaluated.accelerations[6 + mode];
        let a = &evaluated.accelerations;
        let (linear, angular) = (Vector3::new(a[0], a[1], a[2]), Vector3::new(a[3], a[4], a[5]));
        let acceleration = linear
            + omega.cross(&velocity)
            + angular.cross(&self.arm)
            + omega.cross(&omega.cross(&self.arm))
            + omega.cross(&of(&self.moved, &rate)) * 2.0
            + of(&self.moved, &second);
        let slope = self.slope_at_trim + of(&self.turned, &eta);
        let felt = acceleration - evaluated.gravity;
        let felt = felt - slope.cross(&felt);
        let rates = omega + of(&self.turned, &rate);
        let height = self.height_at_trim_m
            + self.height.iter().enumerate().map(|(mode, height)| height * eta(mode)).sum::<f64>();
        [height, felt.x, felt.y, felt.z, -rates.x, rates.y, -rates.z]
    }
}

/// The wing's accelerometers on both sides and one at the centre, and which is the outermost of the right wing.
fn units(aircraft: &Aircraft, modes: &FreeModes, trimmed: &Trimmed, eta: &[f64]) -> (Vec<Unit>, usize) {
    let (right, left) = (&aircraft.right, &aircraft.left);
    let listed = aircraft.wing.planform().map_or_else(Vec::new, coupling::planform::Planform::sensor_grids);
    let mut nodes: Vec<(String, usize)> = listed
        .into_iter()
        .filter_map(|(name, id)| Some((name, aircraft.free.node_index(id)?)))
        .filter(|(_, node)| right.nodes.contains(node))
        .collect();
    if nodes.iter().all(|(_, node)| *node != right.sensor) {
        nodes.push(("tip".to_owned(), right.sensor));
    }
    let outermost = nodes.iter().position(|(_, node)| *node == right.sensor).unwrap_or(0);
    let mut units = Vec::new();
    for (name, node) in &nodes {
        let height = aircraft.static_height(trimmed, right, *node);
        units.push(unit(aircraft, modes, eta, format!("{name}_right"), *node, height));
    }
    // nodes of both wings stand in the same order
    for (name, node) in &nodes {
        let Ok(at) = right.nodes.binary_search(node) else { continue };
        let node = left.nodes[at];
        let height = aircraft.static_height(trimmed, left, node);
        units.push(unit(aircraft, modes, eta, format!("{name}_left"), node, height));
    }
    units.push(unit(aircraft, modes, eta, "centre".to_owned(), aircraft.centre, 0.0));
    (units, outermost)
}

fn unit(
    aircraft: &Aircraft,
    modes: &FreeModes,
    eta: &[f64],
    name: String,
    node: usize,
    height_at_trim_m: f64,
) -> Unit {
    let points = aircraft.free.points();
    let part = |node: usize, from: usize, mode: usize| {
        Vector3::from_fn(|axis, _| modes.elastic_shape(6 * node + from + axis, mode))
    };
    let each = 0..modes.elastic();
    let moved: Vec<_> = each.clone().map(|mode| part(node, 0, mode)).collect();
    let turned: Vec<_> = each.clone().map(|mode| part(node, 3, mode)).collect();
    let from_centre = points[node] - points[aircraft.centre];
    let height = each
        .map(|mode| {
            let (centre, pitch) = (part(aircraft.centre, 0, mode), part(aircraft.centre, 3, mode));
            (moved[mode] - centre - pitch.cross(&from_centre)).z
        })
        .collect();
    let slope_at_trim = turned.iter().zip(eta).map(|(turn, eta)| turn * *eta).sum();
    let arm = points[node] - aircraft.mass.centre;
    Unit { name, arm, moved, turned, height, height_at_trim_m, slope_at_trim }
}

impl Aircraft {
    /// Height of a node of a wing over the plane of the centre in trimmed flight, m: carried rigidly by the nearest
    /// node that boxes follow.
    fn static_height(&self, trimmed: &Trimmed, wing: &WingPlaces, node: usize) -> f64 {
        let Some(held) = &self.flow.supported else { return 0.0 };
        let points = self.free.points();
        let at = points[node];
        let used = held.s_dofs.iter().filter(|dof| **dof % 6 == 2).map(|dof| dof / 6);
        let near = used
            .filter(|other| wing.nodes.binary_search(other).is_ok())
            .min_by(|a, b| (points[*a] - at).norm().total_cmp(&(points[*b] - at).norm()));
        let Some(near) = near else { return 0.0 };
        let part = |component: usize| {
            held.s_dofs.binary_search(&(6 * near + component)).map_or(0.0, |at| trimmed.displacement[at])
        };
        let arm = at - points[near];
        part(2) + part(3) * arm.y - part(4) * arm.x
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod whole;
