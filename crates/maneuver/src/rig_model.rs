//! A rig at one flow as a linear system, and what it does with inputs in time.

use crate::history::TimeHistory;
use crate::smoothing::Smooth;
use crate::step::ExactStep;
use aero::Flow;
use faer::Mat;
use faer::linalg::solvers::Solve;

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

/// `x' = A x + B u`, `y = C x + D u`; outputs Fz, Mx, My, tip z, then the sensors' vertical accelerations.
#[derive(Debug, Clone)]
pub struct RigModel {
    /// States by states: modal displacements and velocities, deflections and their rates.
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
    /// The flow.
    pub flow: Flow,
    pub(crate) gravity_m_s2: f64,
    pub(crate) cutoff_hz: f64,
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
        let first: Vec<f64> = (0..self.inputs.len()).map(|k| inputs[(k, 0)]).collect();
        let step = ExactStep::new(self.a.as_ref(), self.b.as_ref(), motion.time_step_s);
        let states = step.run(&self.equilibrium(&first), inputs.as_ref());
        let outputs = &self.c * &states + &self.d * &inputs;
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
        for (index, name) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().enumerate() {
            history.push(name, row(index));
        }
        for (control, name) in self.controls.iter().enumerate() {
            let commanded = motion.controls_rad.get(control);
            let commanded = commanded.map(|values| values.iter().map(|delta| delta * degrees).collect());
            history.push(format!("delta_{name}_deg"), commanded.unwrap_or_else(|| vec![0.0; samples]));
        }
        history.push("tip_z_m", row(3));
        for (sensor, name) in self.sensors.iter().enumerate() {
            history.push(format!("az_{name}_m_s2"), row(4 + sensor));
        }
        history
    }
}
