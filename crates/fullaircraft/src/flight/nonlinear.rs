//! Nonlinear flight: the equations of flight as they are, by the explicit Runge-Kutta method of Dormand and Prince, order
//! 5(4), with error control and dense output of order 4 (library `ode_solvers`, after Hairer, Norsett and Wanner).

use crate::error::AircraftError;
use crate::flight::equations::{Equations, Inputs};
use crate::flight::history::FlightHistory;
use crate::flight::model::FlyingAircraft;
use crate::flight::small_motions::TIME_STEP_S;
use crate::flight::state::{PLACE, vector};
use faer::Mat;
use maneuver::Signal;
use ode_solvers::dop_shared::{IntegrationError, OutputType, System};
use ode_solvers::{DVector, Dopri5};

/// How nonlinear flight is integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integration {
    /// Step of the histories, s; the integrator chooses its own.
    pub time_step_s: f64,
    /// Error of a step relative to each state.
    pub relative: f64,
    /// Error of a step in the states' own units.
    pub absolute: f64,
    /// Longest step, s: no shorter pulse of an input may be stepped over.
    pub longest_step_s: f64,
}

impl Default for Integration {
    fn default() -> Self {
        Self { time_step_s: TIME_STEP_S, relative: 1e-7, absolute: 1e-9, longest_step_s: 0.01 }
    }
}

/// Safety factor, PI controller's beta and limits of the change of step: the values of Hairer, Norsett and Wanner.
const SAFETY: f64 = 0.9;
const BETA: f64 = 0.04;
const STEP_FACTORS: [f64; 2] = [0.2, 10.0];
const MOST_STEPS: u32 = 5_000_000;

struct Motion<'a, F: Fn(f64, &[f64]) -> Inputs> {
    equations: &'a Equations,
    inputs: F,
}

impl<F: Fn(f64, &[f64]) -> Inputs> System<f64, DVector<f64>> for Motion<'_, F> {
    fn system(&self, t_s: f64, state: &DVector<f64>, rates: &mut DVector<f64>) {
        let state = state.as_slice();
        let evaluated = self.equations.evaluate(state, &(self.inputs)(t_s, state));
        rates.copy_from_slice(&evaluated.derivative);
    }
}

/// States at `samples` times from 0.
fn integrate(
    equations: &Equations,
    start: &[f64],
    inputs: impl Fn(f64, &[f64]) -> Inputs,
    samples: usize,
    settings: &Integration,
) -> Result<Vec<DVector<f64>>, AircraftError> {
    let step = settings.time_step_s;
    // half a step beyond the last sample, which rounding must not cut off
    let end_s = step * (samples as f64 - 0.5);
    let mut solver = Dopri5::from_param(
        Motion { equations, inputs },
        0.0,
        end_s,
        step,
        DVector::from_column_slice(start),
        settings.relative,
        settings.absolute,
        SAFETY,
        BETA,
        STEP_FACTORS[0],
        STEP_FACTORS[1],
        settings.longest_step_s,
        0.0,
        MOST_STEPS,
        // the fast lags of the air limit steps to some milliseconds: no reason to stop
        u32::MAX,
        OutputType::Dense,
    );
    solver.integrate().map_err(|error| {
        let t_s = match error {
            IntegrationError::MaxNumStepReached { x, .. }
            | IntegrationError::StepSizeUnderflow { x }
            | IntegrationError::StiffnessDetected { x } => x,
        };
        AircraftError::Flight { t_s, why: error.to_string() }
    })?;
    let states = solver.y_out();
    let finite = |state: &&DVector<f64>| state.iter().all(|value| value.is_finite());
    let good: Vec<DVector<f64>> = states.iter().take_while(finite).take(samples).cloned().collect();
    if good.len() < samples {
        let t_s = good.len() as f64 * step;
        return Err(AircraftError::Flight { t_s, why: "a state is no longer a number".into() });
    }
    Ok(good)
}

impl FlyingAircraft {
    /// Flies commands (a signal in rad for each drive, in their order; missing ones are zero) from the trim.
    ///
    /// # Errors
    /// [`AircraftError::Flight`] if the integrator cannot go on.
    pub fn fly(
        &self,
        commands: &[&dyn Signal],
        duration_s: f64,
        settings: &Integration,
    ) -> Result<FlightHistory, AircraftError> {
        let equations = &self.equations;
        let step = settings.time_step_s;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "durations are short")]
        let samples = (duration_s / step).round().max(1.0) as usize + 1;
        let command = |drive: usize, t_s: f64| commands.get(drive).map_or(0.0, |signal| signal.at(t_s));
        let at = |t_s: f64, state: &[f64]| {
            let angles = (0..self.drives.len()).map(|drive| command(drive, t_s)).collect();
            self.inputs(angles, -state[PLACE], vector(state, 0).norm())
        };
        let start = equations.trimmed();
        let states = integrate(equations, &start, at, samples, settings)?;
        let t_s: Vec<f64> = (0..samples).map(|k| k as f64 * step).collect();
        let mut y = Mat::zeros(self.sensors.count(self.drives.len()), samples);
        for (k, (state, t)) in states.iter().zip(&t_s).enumerate() {
            let state = state.as_slice();
            let values = self.read(state, &equations.evaluate(state, &at(*t, state)));
            values.iter().enumerate().for_each(|(row, value)| y[(row, k)] = *value);
        }
        let commanded: Vec<Vec<f64>> =
            (0..self.drives.len()).map(|drive| t_s.iter().map(|t| command(drive, *t)).collect()).collect();
        Ok(self.history(t_s, &y, &commanded))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flight::equations::{AirRows, Reference};
    use crate::flight::state::{StateLayout, attitude};
    use nalgebra::{Matrix3, Vector3};

    /// A rigid body with three different moments of inertia and a product, in a vacuum.
    fn body() -> Equations {
        let layout = StateLayout { modes: 0, drives: 0, motions: 5, poles: 0 };
        Equations {
            layout,
            reference: Reference { v_m_s: 20.0, alpha_rad: 0.05, pitch_rate_rad_s: 2.0 },
            rho_kg_m3: 0.0,
            gravity_m_s2: 9.806_65,
            mass_kg: 20.0,
            inertia: Matrix3::new(1.9, 0.0, 0.2, 0.0, 2.6, 0.0, 0.2, 0.0, 4.4),
            omega_rad_s: Vec::new(),
            damping_ratio: 0.0,
            actuator: [100.0, 0.7],
            poles_per_m: Vec::new(),
            generalised: AirRows { constant: vec![0.0; 6], by: Mat::zeros(6, 15) },
            hold: Vector3::zeros(),
        }
    }

    #[test]
    fn without_air_energy_and_angular_momentum_stay_and_the_path_is_a_parabola() {
        let equations = body();
        let mut start = equations.trimmed();
        // about the middle axis of inertia, where a rotation tumbles over
        start[3] = 0.02;
        let settings = Integration { relative: 1e-10, absolute: 1e-12, ..Integration::default() };
        let none = |_: f64, _: &[f64]| Inputs::default();
        let states = integrate(&equations, &start, none, 10_001, &settings).unwrap();
        let of = |state: &[f64]| {
            let (velocity, omega) = (vector(state, 0), vector(state, 3));
            let momentum = equations.inertia * omega;
            let energy = 0.5 * equations.mass_kg * velocity.norm_squared()
                + 0.5 * omega.dot(&momentum)
                + equations.mass_kg * equations.gravity_m_s2 * state[PLACE + 2];
            (energy, attitude(state) * momentum, attitude(state) * velocity, vector(state, PLACE))
        };
        let (energy, momentum, velocity, _) = of(&start);
        let mut furthest = 0.0_f64;
        for (k, state) in states.iter().enumerate() {
            let t = TIME_STEP_S * k as f64;
            let (now, turned, _, place) = of(state.as_slice());
            assert!((now - energy).abs() < 1e-8 * energy, "{t}: {now} {energy}");
            assert!((turned - momentum).norm() < 1e-8 * momentum.norm(), "{t}");
            let fallen = velocity * t - Vector3::z() * 0.5 * equations.gravity_m_s2 * t * t;
            assert!((place - fallen).norm() < 1e-6, "{t}: {place} {fallen}");
            furthest = furthest.max(state[3].abs());
        }
        assert!(furthest > 1.0, "it did not tumble: {furthest}");
    }

    #[test]
    fn the_lag_of_a_gust_that_rises_steadily_is_that_of_first_order() {
        // z' = x' - g V z with x' = w'/V from rest: z = w'/(g V²) (1 - exp(-g V t))
        let (rise_m_s2, pole_per_m) = (5.0, 0.4);
        let layout = StateLayout { modes: 0, drives: 0, motions: 6, poles: 1 };
        let equations = Equations {
            layout,
            gravity_m_s2: 0.0,
            reference: Reference { pitch_rate_rad_s: 0.0, ..body().reference },
            poles_per_m: vec![pole_per_m],
            generalised: AirRows { constant: vec![0.0; 6], by: Mat::zeros(6, 24) },
            ..body()
        };
        let gust = |t_s: f64, _: &[f64]| Inputs {
            gust_m_s: vec![rise_m_s2 * t_s],
            gust_rate_m_s2: vec![rise_m_s2],
            ..Inputs::default()
        };
        let states = integrate(&equations, &equations.trimmed(), gust, 501, &Integration::default()).unwrap();
        let v = equations.reference.v_m_s;
        for k in [10, 100, 500] {
            let t_s = TIME_STEP_S * k as f64;
            let expected = rise_m_s2 / (pole_per_m * v * v) * (1.0 - (-pole_per_m * v * t_s).exp());
            let lag = states[k][layout.lag(0, 5)];
            assert!((lag - expected).abs() < 1e-7 * expected, "{t_s} s: {lag} {expected}");
            let air = equations.evaluate(states[k].as_slice(), &gust(t_s, &[])).air;
            assert!((air[5] - rise_m_s2 * t_s / v).abs() < 1e-12, "its incidence is w/V");
        }
    }

    /// A rigid body in air that answers angles, rates and their rates of change, sideways as well.
    fn in_air() -> (Equations, Vec<f64>) {
        let wave = |k: usize| 0.3 * (1.7 * k as f64 + 0.4).sin();
        let equations = Equations {
            rho_kg_m3: 1.2,
            generalised: AirRows {
                constant: (0..6).map(wave).collect(),
                by: Mat::from_fn(6, 15, |i, j| wave(15 * i + j)),
            },
            ..body()
        };
        let mut state = equations.trimmed();
        for (k, value) in [(0, -1.0), (1, 2.5), (2, -1.4), (3, 0.8), (4, -0.5), (5, 0.6)] {
            state[k] += value;
        }
        (equations, state)
    }

    #[test]
    fn the_air_answers_the_rates_at_which_its_angles_change() {
        let (equations, state) = in_air();
        let rigid = |state: &[f64]| {
            let [v, alpha, beta] = Equations::stream_of(state);
            let omega = vector(state, 3);
            [alpha, beta, omega.x / v, omega.y / v, omega.z / v]
        };
        let evaluated = equations.evaluate(&state, &Inputs::default());
        let later = |h: f64| -> [f64; 5] {
            let moved = state.iter().zip(&evaluated.derivative).map(|(value, rate)| value + h * rate);
            rigid(&moved.collect::<Vec<f64>>())
        };
        let (h, [v, ..]) = (1e-5, Equations::stream_of(&state));
        for (motion, (after, before)) in later(h).into_iter().zip(later(-h)).enumerate() {
            let (change, rate) = ((after - before) / (2.0 * h), v * evaluated.air[5 + motion]);
            assert!(rate.abs() > 1e-3 && (rate - change).abs() < 1e-7, "motion {motion}: {rate} {change}");
        }
    }

    #[test]
    fn mass_times_acceleration_is_gravity_and_the_air_turned_with_the_stream() {
        // Newton and Euler for a rigid body; the air's axes: along the stream, and up in the plane of symmetry
        let (equations, state) = in_air();
        let evaluated = equations.evaluate(&state, &Inputs::default());
        let (velocity, omega) = (vector(&state, 0), vector(&state, 3));
        let along = -velocity.normalize();
        let up = along.cross(&Vector3::y()).normalize();
        let turn = Matrix3::from_columns(&[along, up.cross(&along), up]);
        let air = equations.generalised.at(&evaluated.air);
        let on_body = |from: usize| turn * vector(&air, from) * evaluated.q_pa;
        let gravity = attitude(&state).inverse() * Vector3::new(0.0, 0.0, -equations.gravity_m_s2);
        let accelerations = evaluated.derivative.as_slice();
        let momentum = (vector(accelerations, 0) + omega.cross(&velocity)) * equations.mass_kg;
        let force = on_body(0) + gravity * equations.mass_kg;
        assert!((momentum - force).norm() < 1e-9 * force.norm(), "{momentum} {force}");
        let turned = equations.inertia * vector(accelerations, 3) + omega.cross(&(equations.inertia * omega));
        let moment = on_body(3);
        assert!((turned - moment).norm() < 1e-9 * moment.norm(), "{turned} {moment}");
    }
}
