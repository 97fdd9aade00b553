//! Dynamic maneuvers: small motions of the free elastic aircraft in unsteady air about trimmed, straight flight.
//!
//! The equations of `flight_equations.rs` linearised about the trim, `x' = A x + B u`, `y = y_0 + C x + D u`, by central
//! differences (the equations are linear but for products of rates, angles and airspeed, so the differences are exact to
//! rounding), and stepped exactly with inputs that are linear between samples. An actuator of second order stands between
//! command and surface. [`FlyingAircraft::fly`](crate::FlyingAircraft::fly) flies the same aircraft without the linearisation.

use crate::error::AircraftError;
use crate::flight::air::FlightAir;
use crate::flight::equations::{Evaluated, Inputs};
use crate::flight::gust::Gust;
use crate::flight::history::FlightHistory;
use crate::flight::model::FlyingAircraft;
use crate::flight::state::{self, vector};
use crate::trim::model::{FlightModel, Trimmed};
use faer::Mat;
use maneuver::motion::{MotionSpec, sampled};
use maneuver::{ExactStep, Signal};
use nalgebra::Vector3;
use structure::unsymmetric::eigenvalues;

/// Time step of commands and histories, s: a peak at 13 Hz is then seen within 0.1 %.
pub const TIME_STEP_S: f64 = 0.001;
/// Steps of the central differences; states and inputs of ordinary flight are of order one.
const DIFFERENCE: f64 = 1e-4;

/// A trimmed aircraft, ready for small motions.
#[derive(Debug)]
pub struct FreeFlight {
    pub(crate) flying: FlyingAircraft,
    pub(crate) a: Mat<f64>,
    pub(crate) b: Mat<f64>,
    pub(crate) c: Mat<f64>,
    pub(crate) d: Mat<f64>,
    y_0: Vec<f64>,
}

impl FreeFlight {
    /// Small motions of `model` about `trimmed`, driven by the control called `control`.
    ///
    /// # Errors
    /// If there is no such control.
    pub fn new(
        model: &FlightModel<'_>,
        air: &FlightAir,
        trimmed: &Trimmed,
        control: &str,
    ) -> Result<Self, AircraftError> {
        let drive = model.aircraft.drive(control)?;
        Ok(Self::of(FlyingAircraft::new(model, air, trimmed, vec![drive], None)?))
    }

    /// Linearises an aircraft's equations about its trim.
    pub fn of(flying: FlyingAircraft) -> Self {
        Self::showing(flying, FlyingAircraft::read)
    }

    /// Linearises an aircraft's equations about its trim, with outputs of one's own.
    pub(crate) fn showing(
        flying: FlyingAircraft,
        read: impl Fn(&FlyingAircraft, &[f64], &Evaluated) -> Vec<f64>,
    ) -> Self {
        let equations = &flying.equations;
        let layout = equations.layout;
        let at_trim = equations.trimmed();
        let still = equations.no_inputs();
        let evaluate = |state: &[f64], inputs: &Inputs| {
            let evaluated = equations.evaluate(state, inputs);
            let rates = vector(state, 3) - Vector3::new(0.0, equations.reference.pitch_rate_rad_s, 0.0);
            (state::small_rates(&evaluated.derivative, &rates), read(&flying, state, &evaluated))
        };
        let (_, y_0) = evaluate(&at_trim, &still);
        let (n, outputs, inputs) = (layout.small(), y_0.len(), input_count(&still));
        let (mut a, mut c) = (Mat::zeros(n, n), Mat::zeros(outputs, n));
        let (mut b, mut d) = (Mat::zeros(n, inputs), Mat::zeros(outputs, inputs));
        let slope = |from: &mut Mat<f64>, column: usize, up: &[f64], down: &[f64]| {
            for i in 0..up.len() {
                from[(i, column)] = (up[i] - down[i]) / (2.0 * DIFFERENCE);
            }
        };
        for state in 0..n {
            let [up, down] =
                [DIFFERENCE, -DIFFERENCE].map(|h| evaluate(&state::moved(&at_trim, state, h), &still));
            slope(&mut a, state, &up.0, &down.0);
            slope(&mut c, state, &up.1, &down.1);
        }
        for input in 0..inputs {
            let [up, down] = [DIFFERENCE, -DIFFERENCE].map(|h| evaluate(&at_trim, &moved(&still, input, h)));
            slope(&mut b, input, &up.0, &down.0);
            slope(&mut d, input, &up.1, &down.1);
        }
        Self { flying, a, b, c, d, y_0 }
    }

    /// Growth rate of the fastest growing motion without input, 1/s: the largest real part of the eigenvalues;
    /// `None` if they do not converge. Motions that neither grow nor decay count as zero, and come out as
    /// a little more than that because their eigenvalue is a multiple one.
    pub fn growth_rate_per_s(&self) -> Option<f64> {
        let values = eigenvalues(self.a.as_ref())?;
        Some(values.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max))
    }

    /// Eigenvalues of small motions, 1/s (real and imaginary part); `None` if they do not converge.
    pub fn eigenvalues(&self) -> Option<Vec<[f64; 2]>> {
        Some(eigenvalues(self.a.as_ref())?.iter().map(|value| [value.re, value.im]).collect())
    }

    /// Number of states.
    pub fn states(&self) -> usize {
        self.a.nrows()
    }

    /// A sentence if a motion doubles within `duration_s` without any input: rounding errors then grow, too.
    pub fn warning(&self, name: &str, duration_s: f64) -> Option<String> {
        let doubling_s = self.doubling_s().filter(|doubling_s| *doubling_s < duration_s)?;
        Some(format!("{name}: the free aircraft is unstable, a motion doubles in {doubling_s:.2} s"))
    }

    /// Airspeed of the trim, m/s.
    pub fn v_m_s(&self) -> f64 {
        self.flying.equations.reference.v_m_s
    }

    /// How long the fastest growing motion takes to double, s; none if nothing grows.
    pub fn doubling_s(&self) -> Option<f64> {
        let rate = self.growth_rate_per_s()?;
        (rate > 0.0).then(|| std::f64::consts::LN_2 / rate)
    }

    /// The answer to a motion of what moves the aircraft.
    pub fn fly_motion(&self, motion: &MotionSpec) -> FlightHistory {
        self.fly(&samples(motion.record_s(), motion.kind()))
    }

    /// The answer to commands of the first drive (rad), one every [`TIME_STEP_S`], linear between.
    pub fn fly(&self, command_rad: &[f64]) -> FlightHistory {
        self.fly_at(TIME_STEP_S, &[command_rad.to_vec()], command_rad.len())
    }

    /// The answer to commands (rad, a list a drive; missing ones are zero), one every `time_step_s`, linear between.
    pub fn fly_at(&self, time_step_s: f64, commands_rad: &[Vec<f64>], samples: usize) -> FlightHistory {
        let flying = &self.flying;
        let drives = flying.drives.len();
        let v = flying.equations.reference.v_m_s;
        let commands: Vec<Vec<f64>> = (0..drives)
            .map(|drive| {
                let given = commands_rad.get(drive);
                (0..samples).map(|k| given.and_then(|list| list.get(k)).copied().unwrap_or(0.0)).collect()
            })
            .collect();
        let t_s: Vec<f64> = (0..samples).map(|k| k as f64 * time_step_s).collect();
        let inputs = self.inputs(flying.gust, &commands, &t_s);
        let at_rest = vec![0.0; self.a.nrows()];
        let mut y = ExactStep::new(self.a.as_ref(), self.b.as_ref(), time_step_s).outputs(
            &at_rest,
            inputs.as_ref(),
            self.c.as_ref(),
            self.d.as_ref(),
        );
        for k in 0..samples {
            for (row, from) in self.y_0.iter().enumerate() {
                y[(row, k)] += from;
            }
            // the place counts from the trim's, which moves on
            y[(crate::flight::sensors::FIXED - 3, k)] -= v * t_s[k];
        }
        flying.history(t_s, &y, &commands)
    }
}

impl FreeFlight {
    /// Inputs (a column a sample) of commands (rad, a list a drive) and a gust that is met at the trim's airspeed.
    pub(crate) fn inputs(&self, gust: Option<Gust>, commands_rad: &[Vec<f64>], t_s: &[f64]) -> Mat<f64> {
        let v_m_s = self.flying.equations.reference.v_m_s;
        let mut inputs = Mat::zeros(self.b.ncols(), t_s.len());
        for (k, t) in t_s.iter().enumerate() {
            let commands = commands_rad.iter().map(|list| list[k]).collect();
            let at = self.flying.inputs_in(gust, commands, v_m_s * t, v_m_s);
            let values = at.command_rad.iter().chain(&at.gust_m_s).chain(&at.gust_rate_m_s2);
            values.enumerate().for_each(|(row, value)| inputs[(row, k)] = *value);
        }
        inputs
    }
}

fn input_count(inputs: &Inputs) -> usize {
    inputs.command_rad.len() + 2 * inputs.gust_m_s.len()
}

/// Inputs with one of them moved by h.
fn moved(inputs: &Inputs, at: usize, h: f64) -> Inputs {
    let mut moved = inputs.clone();
    let Inputs { command_rad, gust_m_s, gust_rate_m_s2 } = &mut moved;
    if let Some(value) = command_rad.iter_mut().chain(gust_m_s).chain(gust_rate_m_s2).nth(at) {
        *value += h;
    }
    moved
}

/// Samples of a command.
pub(crate) fn samples<S: Signal + ?Sized>(duration_s: f64, command: &S) -> Vec<f64> {
    sampled(command, TIME_STEP_S, count(duration_s))
}

/// Number of samples of a duration.
pub(crate) fn count(duration_s: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the file allows 0 to 600 s")]
    let steps = (duration_s / TIME_STEP_S).round() as usize;
    steps + 1
}
