//! The equations of flight: six rigid degrees of freedom in mean axes, the elastic modes and the lags of the air.
//!
//! ```text
//! m (v' + omega x v)     = T F + m g                       F, M: air on the box normals, about the centre of gravity
//! J omega' + omega x J omega = T M + M_hold
//! eta'' + 2 zeta w eta' + w² eta = Phiᵀ G_kᵀ (P - P_trim)
//! z' = x' - g V z        for every pole g of every motion x of the air
//! P  = q/q_0 P_trim + q W S [c_0 dx + c_1 x'/V + c_2 x''/V² + sum d z]
//! ```
//! Source of the mean axes' equations: Waszak and Schmidt, J. Aircraft 25(6), 1988; their inertia is that of the undeformed
//! aircraft, and no mode feels the rates. V and q are those of the moment; `T` turns the air's loads as a whole
//! so that the force is perpendicular to the stream: no drag, as the trim has no thrust. `M_hold` is what the trim leaves unbalanced (only for
//! wings alone). Accelerations on the right (apparent mass) are solved for in every evaluation.

use crate::flight::air::RIGID;
use crate::flight::state::{PLACE, StateLayout, attitude, attitude_rate, mode_state, vector};
use faer::Mat;
use maneuver::air::RationalAir;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix5x6, Vector3};

/// What drives an aircraft at a moment: commanded angles (rad) and, per station, the gust's velocity over V and its rate.
#[derive(Debug, Clone, Default)]
pub(crate) struct Inputs {
    pub(crate) command_rad: Vec<f64>,
    pub(crate) gust_m_s: Vec<f64>,
    pub(crate) gust_rate_m_s2: Vec<f64>,
}

/// Rates of the states, and what sensors need beside them.
#[derive(Debug, Clone)]
pub(crate) struct Evaluated {
    pub(crate) derivative: Vec<f64>,
    /// Of the velocity in the mean axes (without `omega x v`), of the rates, and of the modes.
    pub(crate) accelerations: DVector<f64>,
    /// q, and every motion, rate and lag the air answers, in the order of [`AirRows`].
    pub(crate) q_pa: f64,
    pub(crate) air: Vec<f64>,
    /// Gravity in the mean axes, m/s².
    pub(crate) gravity: Vector3<f64>,
    /// Turns forces and moments of the box normals' axes so that they are perpendicular to the stream.
    pub(crate) turn: Matrix3<f64>,
}

/// Rows of air loads per unit dynamic pressure: a constant, then motions, rates over V, second rates over V², lags.
#[derive(Debug, Clone)]
pub(crate) struct AirRows {
    pub(crate) constant: Vec<f64>,
    pub(crate) by: Mat<f64>,
}

impl AirRows {
    pub(crate) fn new(constant: Vec<f64>, air: &RationalAir) -> Self {
        let n = air.steady.ncols();
        let parts: Vec<&Mat<f64>> =
            [&air.steady, &air.rate, &air.second].into_iter().chain(&air.lags).collect();
        let by =
            Mat::from_fn(air.steady.nrows(), n * parts.len(), |i, column| parts[column / n][(i, column % n)]);
        Self { constant, by }
    }

    /// Per unit dynamic pressure.
    pub(crate) fn at(&self, air: &[f64]) -> Vec<f64> {
        let mut sums = self.constant.clone();
        for (column, value) in air.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            for (sum, entry) in sums.iter_mut().zip(self.by.col_as_slice(column)) {
                *sum += entry * value;
            }
        }
        sums
    }
}

/// The state the aircraft is trimmed in.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reference {
    pub(crate) v_m_s: f64,
    /// Of the mean axes.
    pub(crate) alpha_rad: f64,
    pub(crate) pitch_rate_rad_s: f64,
}

/// See the module.
#[derive(Debug, Clone)]
pub(crate) struct Equations {
    pub(crate) layout: StateLayout,
    pub(crate) reference: Reference,
    pub(crate) rho_kg_m3: f64,
    pub(crate) gravity_m_s2: f64,
    pub(crate) mass_kg: f64,
    pub(crate) inertia: Matrix3<f64>,
    pub(crate) omega_rad_s: Vec<f64>,
    pub(crate) damping_ratio: f64,
    /// Natural frequency (rad/s) and damping ratio.
    pub(crate) actuator: [f64; 2],
    pub(crate) poles_per_m: Vec<f64>,
    /// Forces and moments about the centre of gravity, then generalised forces of the modes.
    pub(crate) generalised: AirRows,
    /// Moment that is held against, N m.
    pub(crate) hold: Vector3<f64>,
}

/// Air angles and airspeed.
struct Stream {
    v: f64,
    alpha: f64,
    beta: f64,
    /// Unit vectors of the stream's axes in the mean axes.
    turn: Matrix3<f64>,
    /// Rates of the five rigid motions by the accelerations of velocity and rates.
    jacobian: Matrix5x6<f64>,
}

impl Stream {
    fn new(velocity: &Vector3<f64>, omega: &Vector3<f64>) -> Self {
        let (u, w) = (-velocity.x, -velocity.z);
        let (v, in_plane) = (velocity.norm(), u.hypot(w));
        let (alpha, beta) = (w.atan2(u), (velocity.y / v).asin());
        let (sine, cosine) = alpha.sin_cos();
        let along = -velocity / v;
        let up = Vector3::new(-sine, 0.0, cosine);
        let turn = Matrix3::from_columns(&[along, up.cross(&along), up]);
        let mut jacobian = Matrix5x6::zeros();
        jacobian[(0, 0)] = w / (in_plane * in_plane);
        jacobian[(0, 2)] = -u / (in_plane * in_plane);
        for axis in 0..3 {
            let speed_rate = velocity[axis] / v;
            let side = f64::from(u8::from(axis == 1)) - speed_rate * velocity.y / v;
            jacobian[(1, axis)] = side / in_plane;
            for rate in 0..3 {
                jacobian[(2 + rate, axis)] = -omega[rate] * speed_rate / (v * v);
            }
            jacobian[(2 + axis, 3 + axis)] = 1.0 / v;
        }
        Self { v, alpha, beta, turn, jacobian }
    }
}

impl Equations {
    /// The trimmed state.
    pub(crate) fn trimmed(&self) -> Vec<f64> {
        let mut state = vec![0.0; self.layout.len()];
        let (sine, cosine) = self.reference.alpha_rad.sin_cos();
        state[0] = -self.reference.v_m_s * cosine;
        state[2] = -self.reference.v_m_s * sine;
        state[4] = self.reference.pitch_rate_rad_s;
        // level: the nose is as high over the horizon as over the stream
        let (sine, cosine) = (0.5 * self.reference.alpha_rad).sin_cos();
        state[6] = cosine;
        state[8] = sine;
        state
    }

    /// No commands, no gust.
    pub(crate) fn no_inputs(&self) -> Inputs {
        let gusts = self.layout.motions - RIGID - self.layout.modes - self.layout.drives;
        Inputs {
            command_rad: vec![0.0; self.layout.drives],
            gust_m_s: vec![0.0; gusts],
            gust_rate_m_s2: vec![0.0; gusts],
        }
    }

    /// Airspeed, angle of attack and sideslip of a state.
    pub(crate) fn stream_of(state: &[f64]) -> [f64; 3] {
        let stream = Stream::new(&vector(state, 0), &vector(state, 3));
        [stream.v, stream.alpha, stream.beta]
    }

    /// Rates of all states.
    pub(crate) fn evaluate(&self, state: &[f64], inputs: &Inputs) -> Evaluated {
        let layout = self.layout;
        let (velocity, omega) = (vector(state, 0), vector(state, 3));
        let stream = Stream::new(&velocity, &omega);
        let q_pa = 0.5 * self.rho_kg_m3 * stream.v * stream.v;
        let turn = attitude(state);
        let gravity = turn.inverse() * Vector3::new(0.0, 0.0, -self.gravity_m_s2);
        let mut air = self.known_air(state, inputs, &stream, &omega);
        let accelerations = self.accelerations(state, &stream, q_pa, &air, &gravity);
        let motions = layout.motions;
        let rigid_rates = stream.jacobian * accelerations.fixed_rows::<6>(0);
        for motion in 0..RIGID {
            air[motions + motion] = rigid_rates[motion] / stream.v;
        }
        for mode in 0..layout.modes {
            air[2 * motions + RIGID + mode] = accelerations[6 + mode] / (stream.v * stream.v);
        }
        let mut derivative = vec![0.0; layout.len()];
        derivative[..6].copy_from_slice(&accelerations.as_slice()[..6]);
        derivative[6..PLACE].copy_from_slice(&attitude_rate(state, &omega));
        derivative[PLACE..PLACE + 3].copy_from_slice((turn * velocity).as_slice());
        for mode in 0..layout.modes {
            derivative[mode_state(mode)] = state[layout.mode_rate(mode)];
            derivative[layout.mode_rate(mode)] = accelerations[6 + mode];
        }
        for drive in 0..layout.drives {
            derivative[layout.drive(drive)] = state[layout.drive_rate(drive)];
            derivative[layout.drive_rate(drive)] = self.drive_acceleration(state, inputs, drive);
        }
        for (pole, g) in self.poles_per_m.iter().enumerate() {
            for motion in 0..motions {
                let at = layout.lag(pole, motion);
                derivative[at] = stream.v * (air[motions + motion] - g * state[at]);
            }
        }
        Evaluated { derivative, accelerations, q_pa, air, gravity, turn: stream.turn }
    }

    fn drive_acceleration(&self, state: &[f64], inputs: &Inputs, drive: usize) -> f64 {
        let [omega, zeta] = self.actuator;
        let (at, rate) = (state[self.layout.drive(drive)], state[self.layout.drive_rate(drive)]);
        omega * omega * (inputs.command_rad[drive] - at) - 2.0 * zeta * omega * rate
    }

    /// What the air answers, but for the accelerations that are to be found.
    fn known_air(&self, state: &[f64], inputs: &Inputs, stream: &Stream, omega: &Vector3<f64>) -> Vec<f64> {
        let (layout, reference) = (self.layout, &self.reference);
        let n = layout.motions;
        let mut air = vec![0.0; n * (3 + layout.poles)];
        air[0] = stream.alpha - reference.alpha_rad;
        air[1] = stream.beta;
        for axis in 0..3 {
            air[2 + axis] = omega[axis] / stream.v;
        }
        air[3] -= reference.pitch_rate_rad_s / reference.v_m_s;
        for mode in 0..layout.modes {
            air[RIGID + mode] = state[mode_state(mode)];
            air[n + RIGID + mode] = state[layout.mode_rate(mode)] / stream.v;
        }
        for drive in 0..layout.drives {
            let motion = RIGID + layout.modes + drive;
            air[motion] = state[layout.drive(drive)];
            air[n + motion] = state[layout.drive_rate(drive)] / stream.v;
            air[2 * n + motion] = self.drive_acceleration(state, inputs, drive) / (stream.v * stream.v);
        }
        let first_gust = RIGID + layout.modes + layout.drives;
        for (station, (w, rate)) in inputs.gust_m_s.iter().zip(&inputs.gust_rate_m_s2).enumerate() {
            air[first_gust + station] = w / stream.v;
            air[n + first_gust + station] = rate / (stream.v * stream.v);
        }
        air[3 * n..].copy_from_slice(&state[layout.lag(0, 0)..]);
        air
    }

    /// Of the velocity, the rates and the modes.
    fn accelerations(
        &self,
        state: &[f64],
        stream: &Stream,
        q_pa: f64,
        air: &[f64],
        gravity: &Vector3<f64>,
    ) -> DVector<f64> {
        let layout = self.layout;
        let (velocity, omega) = (vector(state, 0), vector(state, 3));
        let size = 6 + layout.modes;
        let loads = self.generalised.at(air);
        let mut right = DVector::from_fn(size, |i, _| q_pa * loads[i]);
        let mut by_acceleration = self.apparent_mass(stream, q_pa);
        for part in [0, 3] {
            let turned = stream.turn * right.fixed_rows::<3>(part);
            right.fixed_rows_mut::<3>(part).copy_from(&turned);
            let turned = stream.turn * by_acceleration.fixed_rows::<3>(part);
            by_acceleration.fixed_rows_mut::<3>(part).copy_from(&turned);
        }
        let mut left = -by_acceleration;
        for i in 0..3 {
            left[(i, i)] += self.mass_kg;
            for j in 0..3 {
                left[(3 + i, 3 + j)] += self.inertia[(i, j)];
            }
        }
        let force = (gravity - omega.cross(&velocity)) * self.mass_kg;
        let moment = self.hold - omega.cross(&(self.inertia * omega));
        for axis in 0..3 {
            right[axis] += force[axis];
            right[3 + axis] += moment[axis];
        }
        let q_0 = 0.5 * self.rho_kg_m3 * self.reference.v_m_s * self.reference.v_m_s;
        for mode in 0..layout.modes {
            let w = self.omega_rad_s[mode];
            left[(6 + mode, 6 + mode)] += 1.0;
            right[6 + mode] -= q_0 * self.generalised.constant[6 + mode]
                + w * w * state[mode_state(mode)]
                + 2.0 * self.damping_ratio * w * state[layout.mode_rate(mode)];
        }
        // a positive definite mass plus a small apparent one: never singular in flight
        left.lu().solve(&right).unwrap_or_else(|| DVector::from_element(size, f64::NAN))
    }

    /// Loads per acceleration, N and N m, in the box normals' axes.
    fn apparent_mass(&self, stream: &Stream, q_pa: f64) -> DMatrix<f64> {
        let (n, size) = (self.layout.motions, 6 + self.layout.modes);
        let by = &self.generalised.by;
        DMatrix::from_fn(size, size, |i, j| {
            if j < 6 {
                let sum: f64 =
                    (0..RIGID).map(|motion| by[(i, n + motion)] * stream.jacobian[(motion, j)]).sum();
                q_pa / stream.v * sum
            } else {
                q_pa / (stream.v * stream.v) * by[(i, 2 * n + RIGID + j - 6)]
            }
        })
    }
}

#[cfg(test)]
pub(crate) mod tests;
