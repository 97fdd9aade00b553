//! The true wing with its effects, flown at 400 Hz.

use crate::at_speed::{AtSpeed, STEP_S};
use crate::design::{CHIRP_S, CHIRP_TO_HZ, DOUBLET_HZ};
use crate::design::{Move, Planned, RHO_KG_M3, START_S, STEPS_PER_SAMPLE};
use crate::effects::{Effect, WingView};
use crate::flown::{At, Flown, Zones};
use crate::physics::Physics;
use crate::separated::fly_separated;
use crate::servo::Servo;
use crate::strips::ZONES;
use crate::system::{Inputs, Parts, ZonesOf};
use faer::Mat;
use maneuver::ExactStep;
use maneuver::motion::{About, Chirp, Doublet, OneMinusCosine, Signal};

/// The wing of a case: all it needs but the airspeed.
pub(crate) struct TrueWing<'a> {
    pub(crate) parts: &'a Parts,
    /// The wing of this case before effects, by airspeed.
    pub(crate) jittered: &'a (dyn Fn(f64) -> Physics + Sync),
    pub(crate) effects: &'a [Effect],
    pub(crate) servo: Servo,
}

/// What is commanded: angle of attack with derivatives (rad), and deflections by control.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Commands {
    pub(crate) alpha: [Vec<f64>; 3],
    pub(crate) controls: Vec<Vec<f64>>,
}

impl Commands {
    /// The motion of a run at every step of the simulation.
    pub(crate) fn of(planned: &Planned, controls: usize) -> Self {
        let steps = (planned.samples() - 1) * STEPS_PER_SAMPLE + 1;
        let base = planned.alpha_deg.to_radians();
        let sampled = |value: &dyn Fn(f64) -> f64| (0..steps).map(|i| value(i as f64 * STEP_S)).collect();
        let mut all = vec![vec![0.0; steps]; controls];
        let mut alpha = [vec![base; steps], vec![0.0; steps], vec![0.0; steps]];
        match planned.motion {
            Move::Pitch { height_deg, frequency_hz } => {
                let height = height_deg.to_radians();
                let pitch = About(base, OneMinusCosine::new(height, frequency_hz, START_S));
                alpha =
                    [sampled(&|t| pitch.at(t)), sampled(&|t| pitch.rate(t)), sampled(&|t| pitch.second(t))];
            }
            Move::Doublet { control, deflection_deg } => {
                let height = deflection_deg.to_radians();
                let doublet = Doublet { height, frequency_hz: DOUBLET_HZ, start_s: START_S };
                all[control] = sampled(&|t| doublet.at(t));
            }
            Move::Chirp { control, deflection_deg } => {
                let height = deflection_deg.to_radians();
                let (to_hz, duration_s) = (CHIRP_TO_HZ, CHIRP_S);
                let chirp = Chirp { height, from_hz: 0.0, to_hz, duration_s, start_s: START_S };
                all[control] = sampled(&|t| chirp.at(t));
            }
        }
        Self { alpha, controls: all }
    }

    /// One steady point.
    pub(crate) fn steady(alpha_rad: f64, controls: usize) -> Self {
        Self { alpha: [vec![alpha_rad], vec![0.0], vec![0.0]], controls: vec![vec![0.0]; controls] }
    }
}

impl TrueWing<'_> {
    fn zones(&self) -> ZonesOf {
        if self.effects.iter().any(|effect| (effect.kind.separation)(&effect.values).is_some()) {
            return ZonesOf::Both;
        }
        let asked = self.effects.iter().any(|effect| (effect.kind.needs_zones)(&effect.values));
        if asked { ZonesOf::Outputs } else { ZonesOf::Nothing }
    }

    /// Everything about an airspeed.
    pub(crate) fn at(&self, v_m_s: f64) -> AtSpeed {
        let parts = self.parts;
        let wing = WingView { strips: &parts.strips, omega_rad_s: &parts.structure.omega_rad_s };
        let mut physics = (self.jittered)(v_m_s);
        for effect in self.effects {
            (effect.kind.physics)(&effect.values, wing, v_m_s, &mut physics);
        }
        let linear = parts.at(v_m_s, RHO_KG_M3, &physics, self.zones());
        let step = ExactStep::new(linear.a.as_ref(), linear.b.as_ref(), STEP_S);
        AtSpeed { v_m_s, linear, step }
    }

    /// What an effect may know of a flight.
    pub(crate) fn here<'c>(at: &AtSpeed, commands: &'c Commands, (start_s, record): (f64, u64)) -> At<'c> {
        At {
            v_m_s: at.v_m_s,
            q_pa: 0.5 * RHO_KG_M3 * at.v_m_s * at.v_m_s,
            start_s,
            time_step_s: STEP_S,
            record,
            alpha_rad: &commands.alpha[0],
            alpha_rate: &commands.alpha[1],
            alpha_second: &commands.alpha[2],
        }
    }

    /// What the wing does with commands, everything at rest before: the same for all records of a run.
    pub(crate) fn fly(&self, at: &AtSpeed, commands: &Commands) -> Flown {
        let here = Self::here(at, commands, (0.0, 0));
        let inputs = self.inputs(at.linear.inputs, &here, commands);
        let separation = self.effects.iter().find_map(|effect| (effect.kind.separation)(&effect.values));
        let outputs = match separation {
            Some(separation) => fly_separated(self.parts, at, inputs, &separation),
            None => fly_linear(at, &inputs),
        };
        self.flown(&outputs)
    }

    /// What balance and data acquisition make of it in one record.
    pub(crate) fn measure(&self, here: &At<'_>, flown: &mut Flown) {
        for effect in self.effects {
            (effect.kind.balance)(&effect.values, here, flown);
        }
        for effect in self.effects {
            (effect.kind.sensor)(&effect.values, here, flown);
        }
    }

    /// Inputs of the linear system by sample.
    fn inputs(&self, places: Inputs, here: &At<'_>, commands: &Commands) -> Mat<f64> {
        let samples = commands.alpha[0].len();
        let mut inputs = Mat::zeros(places.len(), samples);
        for i in 0..samples {
            let alpha = commands.alpha[0][i];
            inputs[(Inputs::ONE, i)] = 1.0;
            for derivative in 0..3 {
                inputs[(Inputs::ALPHA + derivative, i)] = commands.alpha[derivative][i];
            }
            inputs[(Inputs::G_SIN, i)] = self.parts.gravity_m_s2 * alpha.sin();
            inputs[(Inputs::G_COS, i)] = self.parts.gravity_m_s2 * alpha.cos();
        }
        for (control, command) in commands.controls.iter().enumerate() {
            let mut delta = command.clone();
            for effect in self.effects {
                (effect.kind.command)(&effect.values, here, control, &mut delta);
            }
            let mut delta = self.servo.follow(&delta, STEP_S);
            for effect in self.effects {
                (effect.kind.deflection)(&effect.values, here, control, &mut delta);
            }
            let rate = slopes(&delta);
            let second = slopes(&rate);
            for i in 0..samples {
                for (derivative, values) in [&delta, &rate, &second].into_iter().enumerate() {
                    inputs[(places.control(derivative, control), i)] = values[i];
                }
            }
        }
        inputs
    }

    fn flown(&self, outputs: &Mat<f64>) -> Flown {
        let row = |row: usize| (0..outputs.ncols()).map(|i| outputs[(row, i)]).collect::<Vec<f64>>();
        let strips = &self.parts.strips;
        let zones = (outputs.nrows() > 4).then(|| Zones {
            lift_n: (0..ZONES).map(|zone| row(4 + zone)).collect(),
            height_m: (0..ZONES).map(|zone| row(4 + ZONES + zone)).collect(),
            twist_rad: (0..ZONES).map(|zone| row(4 + 2 * ZONES + zone)).collect(),
            area_m2: std::array::from_fn(|zone| strips.area_of_zone_m2(zone)),
            y_m: std::array::from_fn(|zone| strips.middle_of_zone_m(zone)),
        });
        Flown { loads: [row(0), row(1), row(2)], tip_z_m: row(3), zones }
    }
}

/// Central differences; zero at the ends, where everything is at rest.
fn slopes(values: &[f64]) -> Vec<f64> {
    let mut slopes = vec![0.0; values.len()];
    for i in 1..values.len().saturating_sub(1) {
        slopes[i] = (values[i + 1] - values[i - 1]) / (2.0 * STEP_S);
    }
    slopes
}

/// The steady state of the first sample, and the outputs of all samples from there.
fn fly_linear(at: &AtSpeed, inputs: &Mat<f64>) -> Mat<f64> {
    let (linear, samples) = (&at.linear, inputs.ncols());
    let first = inputs.as_ref().subcols(0, 1).to_owned();
    let state = linear.equilibrium(first.col_as_slice(0));
    let at_rest = &linear.c * Mat::from_fn(state.len(), 1, |i, _| state[i]) + &linear.d * &first;
    let change = Mat::from_fn(inputs.nrows(), samples, |k, i| inputs[(k, i)] - first[(k, 0)]);
    let still = vec![0.0; state.len()];
    let mut outputs = at.step.outputs(&still, change.as_ref(), linear.c.as_ref(), linear.d.as_ref());
    for i in 0..samples {
        for row in 0..outputs.nrows() {
            outputs[(row, i)] += at_rest[(row, 0)];
        }
    }
    outputs
}
