//! A rig at one flow as a linear system, and what it does with inputs in time.

use crate::history::TimeHistory;
use crate::smoothing::Smooth;
use crate::step::ExactStep;
use aero::Flow;
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

/// Where the inputs of the linear system stand: one, alpha, alpha', alpha'', g sin(alpha), g cos(alpha), commands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Inputs {
    controls: usize,
}

impl Inputs {
    /// Always one: camber, pressure offset, tare.
    pub const ONE: usize = 0;
    /// Angle of attack, rad.
    pub const ALPHA: usize = 1;
    /// Its rate, rad/s.
    pub const ALPHA_RATE: usize = 2;
    /// Its second derivative, rad/s².
    pub const ALPHA_SECOND: usize = 3;
    /// Gravity along x of the balance, m/s².
    pub const G_SIN: usize = 4;
    /// Gravity against z of the balance, m/s².
    pub const G_COS: usize = 5;
    /// First commanded deflection, rad.
    pub const CONTROLS: usize = 6;

    pub(crate) fn new(controls: usize) -> Self {
        Self { controls }
    }

    /// Number of inputs.
    pub fn len(self) -> usize {
        Self::CONTROLS + self.controls
    }

    /// Never true.
    pub fn is_empty(self) -> bool {
        false
    }
}

/// `x' = A x + B u`, `y = C x + D u`; outputs are the loads (Fz, Mx, My first), tip z, then the
/// sensors' vertical accelerations.
#[derive(Debug, Clone)]
pub struct RigModel {
    /// States by states: modal displacements and velocities, deflections and their rates, lags of the air.
    pub a: Mat<f64>,
    /// States by inputs.
    pub b: Mat<f64>,
    /// Outputs by states.
    pub c: Mat<f64>,
    /// Outputs by inputs.
    pub d: Mat<f64>,
    /// Where the inputs stand.
    pub inputs: Inputs,
    /// Names of the controls.
    pub controls: Vec<String>,
    /// Names of the sensors.
    pub sensors: Vec<String>,
    /// Channels of the loads: the balance's `Fz_N`, `Mx_Nm`, `My_Nm`, then those of stations and strips.
    pub loads: Vec<String>,
    /// The flow.
    pub flow: Flow,
    pub(crate) gravity_m_s2: f64,
    /// Cutoff of the smoothing of measured inputs and of the filter on loads that are compared, Hz.
    pub cutoff_hz: f64,
}

/// What moves the rig: angle of attack with its derivatives, and commanded deflections in the wing's order, rad.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Time step, s.
    pub time_step_s: f64,
    /// Angle of attack and derivatives.
    pub alpha: Smooth,
    /// Commanded deflections; missing controls are zero.
    pub controls_rad: Vec<Vec<f64>>,
}

impl RigModel {
    /// Flies a motion from the steady state of its first sample (at rest there, whatever its derivatives say).
    pub fn fly(&self, motion: &Motion) -> TimeHistory {
        let samples = motion.alpha.value.len();
        let mut inputs = Mat::zeros(self.inputs.len(), samples);
        for i in 0..samples {
            let alpha = motion.alpha.value[i];
            inputs[(Inputs::ONE, i)] = 1.0;
            inputs[(Inputs::ALPHA, i)] = alpha;
            inputs[(Inputs::G_SIN, i)] = self.gravity_m_s2 * alpha.sin();
            inputs[(Inputs::G_COS, i)] = self.gravity_m_s2 * alpha.cos();
            if i > 0 {
                inputs[(Inputs::ALPHA_RATE, i)] = motion.alpha.rate[i];
                inputs[(Inputs::ALPHA_SECOND, i)] = motion.alpha.second[i];
            }
            for (control, values) in motion.controls_rad.iter().enumerate().take(self.controls.len()) {
                inputs[(Inputs::CONTROLS + control, i)] = values[i];
            }
        }
        // what differs from the first sample, so that a wing at rest stays there to the last digit
        let first = inputs.as_ref().subcols(0, 1).to_owned();
        let change = Mat::from_fn(inputs.nrows(), samples, |k, i| inputs[(k, i)] - first[(k, 0)]);
        let at_rest = self.equilibrium(first.col_as_slice(0));
        let at_rest = &self.c * Mat::from_fn(at_rest.len(), 1, |i, _| at_rest[i]) + &self.d * &first;
        let step = ExactStep::new(self.a.as_ref(), self.b.as_ref(), motion.time_step_s);
        let still = vec![0.0; self.a.nrows()];
        let mut outputs = step.outputs(&still, change.as_ref(), self.c.as_ref(), self.d.as_ref());
        for i in 0..samples {
            for row in 0..outputs.nrows() {
                outputs[(row, i)] += at_rest[(row, 0)];
            }
        }
        self.history(motion, &outputs)
    }

    /// The state that constant inputs lead to.
    pub fn equilibrium(&self, inputs: &[f64]) -> Vec<f64> {
        let states = self.a.nrows();
        if states == 0 {
            return Vec::new();
        }
        let forcing = Mat::from_fn(states, 1, |i, _| {
            -(0..inputs.len()).map(|k| self.b[(i, k)] * inputs[k]).sum::<f64>()
        });
        let x = self.a.partial_piv_lu().solve(&forcing);
        (0..states).map(|i| x[(i, 0)]).collect()
    }

    /// Outputs by inputs at a frequency: amplitudes for inputs of amplitude one, `C (i omega - A)⁻¹ B + D`.
    pub fn transfer(&self, omega_rad_s: f64) -> Mat<c64> {
        let n = self.a.nrows();
        let complex = |m: &Mat<f64>| Mat::from_fn(m.nrows(), m.ncols(), |i, j| c64::from(m[(i, j)]));
        let direct = complex(&self.d);
        if n == 0 {
            return direct;
        }
        let resolvent =
            Mat::from_fn(n, n, |i, j| c64::new(-self.a[(i, j)], if i == j { omega_rad_s } else { 0.0 }));
        complex(&self.c) * resolvent.partial_piv_lu().solve(complex(&self.b)) + direct
    }

    /// Outputs by root pitch and commanded deflections swinging at a frequency, per rad: [`RigModel::transfer`] with angle
    /// of attack, its derivatives and gravity's share (linear in it) taken together.
    pub fn frequency_response(&self, omega_rad_s: f64) -> Mat<c64> {
        let by_input = self.transfer(omega_rad_s);
        let pitch = |row: usize| {
            by_input[(row, Inputs::ALPHA)] + by_input[(row, Inputs::ALPHA_RATE)] * c64::new(0.0, omega_rad_s)
                - by_input[(row, Inputs::ALPHA_SECOND)] * omega_rad_s.powi(2)
                + by_input[(row, Inputs::G_SIN)] * self.gravity_m_s2
        };
        Mat::from_fn(by_input.nrows(), 1 + self.controls.len(), |row, motion| match motion {
            0 => pitch(row),
            control => by_input[(row, Inputs::CONTROLS + control - 1)],
        })
    }

    /// The columns of a run's file; deflections are commands there, so that a simulated run can be flown again.
    fn history(&self, motion: &Motion, outputs: &Mat<f64>) -> TimeHistory {
        let samples = outputs.ncols();
        let row = |row: usize| -> Vec<f64> { (0..samples).map(|i| outputs[(row, i)]).collect() };
        let degrees = 1.0_f64.to_degrees();
        let mut history = TimeHistory {
            t_s: (0..samples).map(|i| i as f64 * motion.time_step_s).collect(),
            channels: Vec::new(),
        };
        history.push("V_m_s", vec![self.flow.v_m_s; samples]);
        history.push("alpha_deg", motion.alpha.value.iter().map(|alpha| alpha * degrees).collect());
        for (index, name) in self.loads.iter().enumerate().take(3) {
            history.push(name, row(index));
        }
        for (control, name) in self.controls.iter().enumerate() {
            let commanded = motion.controls_rad.get(control);
            let commanded = commanded.map(|values| values.iter().map(|delta| delta * degrees).collect());
            history.push(format!("delta_{name}_deg"), commanded.unwrap_or_else(|| vec![0.0; samples]));
        }
        let tip = self.loads.len();
        history.push("tip_z_m", row(tip));
        for (sensor, name) in self.sensors.iter().enumerate() {
            history.push(format!("az_{name}_m_s2"), row(tip + 1 + sensor));
        }
        for (index, name) in self.loads.iter().enumerate().skip(3) {
            history.push(name, row(index));
        }
        history
    }
}

#[cfg(test)]
mod tests;
