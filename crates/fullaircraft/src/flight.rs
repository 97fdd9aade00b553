//! Dynamic maneuvers: small motions of the free elastic aircraft about trimmed flight.
//!
//! ```text
//! eta'' + 2 zeta omega eta' + omega^2 eta = (G Phi)ᵀ P,   P = q W S Q (theta + (chord/4 theta' - h')/V + aileron)
//! ```
//! eta are the free aircraft's natural modes: six rigid motions and the elastic ones. An actuator of second order stands
//! between command and aileron.
//!
//! What is thin here: the air is quasi-steady (it answers at once, no wake, no apparent mass), which overstates
//! fast loads; rigid motions are linear (no gravity along the tilted axes, constant speed), which is fair for the one or
//! two seconds of a doublet and not for a long turn.

use crate::aircraft::{Aircraft, WingPlaces};
use crate::aircraft_file::{Chirp, Doublet};
use crate::error::AircraftError;
use crate::free_modes::FreeModes;
use crate::history::FlightHistory;
use crate::trim::{FlightModel, Trimmed};
use faer::{Mat, MatRef};
use maneuver::{ExactStep, Signal, signals};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Time step of commands and histories, s.
pub const TIME_STEP_S: f64 = 0.002;
/// Rows of the outputs: alpha, deflection, acceleration, three rates, three loads a side.
const OUTPUTS: usize = 12;

/// A trimmed aircraft, ready to answer one pair of ailerons.
#[derive(Debug)]
pub struct FreeFlight<'a> {
    aircraft: &'a Aircraft,
    trimmed: &'a Trimmed,
    a: Mat<f64>,
    b: Vec<f64>,
    /// Outputs by state, in the order of [`OUTPUTS`].
    outputs: Mat<f64>,
}

/// Box loads per unit of the modes, their velocities and the aileron: two rows a box.
struct BoxLoads {
    shape: Mat<f64>,
    rate: Mat<f64>,
    aileron: Mat<f64>,
}

/// What the modes make of the outputs: rows by modes.
struct Sensors {
    shape: Mat<f64>,
    velocity: Mat<f64>,
    acceleration: Mat<f64>,
}

impl<'a> FreeFlight<'a> {
    /// Small motions of `model` about `trimmed`, driven by the pair of ailerons called `control`.
    ///
    /// # Errors
    /// If there is no such pair.
    pub fn new(
        model: &FlightModel<'a>,
        modes: &FreeModes,
        trimmed: &'a Trimmed,
        control: &str,
    ) -> Result<Self, AircraftError> {
        let aircraft = model.aircraft;
        let loads = box_loads(model, modes, trimmed, aircraft.control_pair(control)?);
        let (m, n) = (modes.len(), 2 * modes.len() + 2);
        let generalised = |p: &Mat<f64>| modes.boxes.transpose() * p;
        let (shape, rate) = (generalised(&loads.shape), generalised(&loads.rate));
        let aileron = generalised(&loads.aileron);
        let actuator = &aircraft.file.actuator;
        let (omega_a, zeta_a) = (TAU * actuator.frequency_hz, actuator.damping_ratio);
        let mut a = Mat::zeros(n, n);
        for i in 0..m {
            let omega = modes.omega_rad_s[i];
            a[(i, m + i)] = 1.0;
            for j in 0..m {
                a[(m + i, j)] = shape[(i, j)];
                a[(m + i, m + j)] = rate[(i, j)];
            }
            a[(m + i, i)] -= omega * omega;
            a[(m + i, m + i)] -= 2.0 * aircraft.wing.damping_ratio * omega;
            a[(m + i, 2 * m)] = aileron[(i, 0)];
        }
        a[(2 * m, 2 * m + 1)] = 1.0;
        a[(2 * m + 1, 2 * m)] = -omega_a * omega_a;
        a[(2 * m + 1, 2 * m + 1)] = -2.0 * zeta_a * omega_a;
        let mut b = vec![0.0; n];
        b[2 * m + 1] = omega_a * omega_a;
        let outputs = outputs(aircraft, modes, trimmed, &loads, &a);
        Ok(Self { aircraft, trimmed, a, b, outputs })
    }

    /// Growth rate of the fastest growing motion without input, 1/s: the largest real part of the eigenvalues;
    /// `None` if they do not converge. Rigid motions that neither grow nor decay count as zero, and come out as
    /// a little more than that because their eigenvalue is a multiple one.
    pub fn growth_rate_per_s(&self) -> Option<f64> {
        let values = self.a.eigenvalues().ok()?;
        Some(values.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max))
    }

    /// A sentence if a motion doubles within `duration_s` without any input: rounding errors then grow, too.
    pub fn warning(&self, name: &str, duration_s: f64) -> Option<String> {
        let rate = self.growth_rate_per_s()?;
        (rate * duration_s > std::f64::consts::LN_2).then(|| {
            let doubling_s = std::f64::consts::LN_2 / rate;
            format!("{name}: the free aircraft is unstable, a motion doubles in {doubling_s:.2} s")
        })
    }

    /// The doublet of the aircraft's file.
    pub fn doublet(&self, doublet: &Doublet) -> FlightHistory {
        let command = signals::Doublet {
            height: doublet.amplitude_deg.to_radians(),
            frequency_hz: doublet.frequency_hz,
            start_s: doublet.start_s,
        };
        self.fly(&samples(doublet.duration_s, &command))
    }

    /// The chirp of the aircraft's file.
    pub fn chirp(&self, chirp: &Chirp) -> FlightHistory {
        let command = signals::Chirp {
            height: chirp.amplitude_deg.to_radians(),
            from_hz: chirp.from_hz,
            to_hz: chirp.to_hz,
            duration_s: chirp.duration_s,
            start_s: 0.0,
        };
        self.fly(&samples(chirp.duration_s, &command))
    }

    /// The answer to commands (rad, right trailing edge down), one every [`TIME_STEP_S`], linear between.
    pub fn fly(&self, command_rad: &[f64]) -> FlightHistory {
        let b = Mat::from_fn(self.b.len(), 1, |i, _| self.b[i]);
        let command = Mat::from_fn(1, command_rad.len(), |_, k| command_rad[k]);
        let at_rest = vec![0.0; self.a.nrows()];
        let states = ExactStep::new(self.a.as_ref(), b.as_ref(), TIME_STEP_S).run(&at_rest, command.as_ref());
        let y = &self.outputs * &states;
        let at = |row: usize, offset: f64| (0..y.ncols()).map(|k| y[(row, k)] + offset).collect::<Vec<f64>>();
        let degrees = |values: Vec<f64>| values.into_iter().map(f64::to_degrees).collect::<Vec<f64>>();
        let trimmed = self.trimmed;
        let sides = trimmed.root_loads.map(coupling::RootLoads::to_array);
        let loads = |side: usize| std::array::from_fn(|i| at(6 + 3 * side + i, sides[side][i]));
        let aileron = self.a.nrows() - 2;
        FlightHistory {
            t_s: (0..command_rad.len()).map(|k| k as f64 * TIME_STEP_S).collect(),
            command_deg: degrees(command_rad.to_vec()),
            aileron_deg: degrees((0..states.ncols()).map(|k| states[(aileron, k)]).collect()),
            alpha_deg: degrees(at(0, trimmed.alpha_rad)),
            tip_deflection_m: at(1, self.aircraft.sensor_deflection(trimmed)),
            tip_acceleration_m_s2: at(2, 0.0),
            tip_rates_deg_s: std::array::from_fn(|i| degrees(at(3 + i, 0.0))),
            root_right: loads(0),
            root_left: loads(1),
        }
    }
}

impl Aircraft {
    /// Height of the right tip's accelerometer over the plane of the centre in trimmed flight, m: carried rigidly
    /// by the tip-side spline node it is tied to.
    pub fn sensor_deflection(&self, trimmed: &Trimmed) -> f64 {
        let Some(held) = &self.flow.supported else { return 0.0 };
        let points = self.free.points();
        let at = points[self.right.sensor];
        let used: Vec<usize> = held.s_dofs.iter().filter(|dof| **dof % 6 == 2).map(|dof| dof / 6).collect();
        let near = used
            .into_iter()
            .filter(|node| self.right.nodes.contains(node))
            .min_by(|a, b| (points[*a] - at).norm().total_cmp(&(points[*b] - at).norm()));
        let Some(node) = near else { return 0.0 };
        let part = |component: usize| {
            held.s_dofs.binary_search(&(6 * node + component)).map_or(0.0, |at| trimmed.displacement[at])
        };
        let arm = at - points[node];
        part(2) + part(3) * arm.y - part(4) * arm.x
    }
}

/// Samples of a command.
fn samples(duration_s: f64, command: &dyn Signal) -> Vec<f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the file allows 0 to 600 s")]
    let count = (duration_s / TIME_STEP_S).round() as usize + 1;
    signals::sampled(command, TIME_STEP_S, count)
}

fn box_loads(model: &FlightModel<'_>, modes: &FreeModes, trimmed: &Trimmed, pair: [usize; 2]) -> BoxLoads {
    let flow = model.flow(&trimmed.point);
    let wing = &model.aircraft.flow;
    let loads =
        |cp: MatRef<'_, f64>| wing.k_loads_of_pressures(flow.dynamic_pressure_pa(), cp, &model.corrections);
    let cp_rate = Mat::from_fn(modes.cp_rate.nrows(), modes.len(), |j, i| modes.cp_rate[(j, i)] / flow.v_m_s);
    let controls = wing.pressures_by_control();
    let antisymmetric =
        Mat::from_fn(wing.lattice.len(), 1, |j, _| controls[(j, pair[0])] - controls[(j, pair[1])]);
    BoxLoads {
        shape: loads(modes.cp_shape.as_ref()),
        rate: loads(cp_rate.as_ref()),
        aileron: loads(antisymmetric.as_ref()),
    }
}

/// Outputs by state: modes, velocities, aileron and its rate; accelerations are those of the state equation.
fn outputs(
    aircraft: &Aircraft,
    modes: &FreeModes,
    trimmed: &Trimmed,
    loads: &BoxLoads,
    a: &Mat<f64>,
) -> Mat<f64> {
    let (m, n) = (modes.len(), a.nrows());
    let sensors = sensors(aircraft, modes, trimmed.point.v_m_s, loads);
    let mut rows = &sensors.acceleration * a.as_ref().submatrix(m, 0, m, n);
    for row in 0..OUTPUTS {
        for i in 0..m {
            rows[(row, i)] += sensors.shape[(row, i)];
            rows[(row, m + i)] += sensors.velocity[(row, i)];
        }
    }
    for (side, wing) in [&aircraft.right, &aircraft.left].into_iter().enumerate() {
        let aileron = aircraft.wing_root_rows(wing) * &loads.aileron;
        for i in 0..3 {
            rows[(6 + 3 * side + i, 2 * m)] += aileron[(i, 0)];
        }
    }
    rows
}

fn sensors(aircraft: &Aircraft, modes: &FreeModes, v_m_s: f64, loads: &BoxLoads) -> Sensors {
    let m = modes.len();
    let zeros = || Mat::<f64>::zeros(OUTPUTS, m);
    let (mut by_mode, mut by_velocity, mut by_acceleration) = (zeros(), zeros(), zeros());
    let (centre, sensor) = (aircraft.centre, aircraft.right.sensor);
    let arm = aircraft.free.points()[sensor] - aircraft.free.points()[centre];
    for i in 0..m {
        let part =
            |node: usize, from: usize| Vector3::from_fn(|axis, _| modes.shapes[(6 * node + from + axis, i)]);
        let (moved, turned) = (part(centre, 0), part(centre, 3));
        by_mode[(0, i)] = turned.y;
        by_velocity[(0, i)] = -moved.z / v_m_s;
        by_mode[(1, i)] = (part(sensor, 0) - moved - turned.cross(&arm)).z;
        by_acceleration[(2, i)] = part(sensor, 0).z;
        let rates = part(sensor, 3);
        for (axis, rate) in [-rates.x, rates.y, -rates.z].into_iter().enumerate() {
            by_velocity[(3 + axis, i)] = rate;
        }
    }
    let momentum = aircraft.free.inertia_loads(modes.shapes.as_ref());
    for (side, wing) in [&aircraft.right, &aircraft.left].into_iter().enumerate() {
        add_root_loads(
            aircraft,
            wing,
            6 + 3 * side,
            loads,
            [&mut by_mode, &mut by_velocity, &mut by_acceleration],
            &momentum,
        );
    }
    Sensors { shape: by_mode, velocity: by_velocity, acceleration: by_acceleration }
}

/// Root loads of a wing into rows from `first` on: air loads by mode and velocity, minus inertia by acceleration.
fn add_root_loads(
    aircraft: &Aircraft,
    wing: &WingPlaces,
    first: usize,
    loads: &BoxLoads,
    [by_mode, by_velocity, by_acceleration]: [&mut Mat<f64>; 3],
    momentum: &Mat<f64>,
) {
    let rows = aircraft.wing_root_rows(wing);
    let (shape, rate) = (&rows * &loads.shape, &rows * &loads.rate);
    let inertia = aircraft.wing_nodal_loads(wing, momentum.as_ref());
    for row in 0..3 {
        for i in 0..inertia.ncols() {
            by_mode[(first + row, i)] = shape[(row, i)];
            by_velocity[(first + row, i)] = rate[(row, i)];
            by_acceleration[(first + row, i)] = -inertia[(row, i)];
        }
    }
}
