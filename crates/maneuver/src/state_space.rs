//! The rig's equations as a linear system of first order.
//!
//! States: modal displacements, modal velocities, deflections, their rates, then the lags of the air: for every pole g of
//! a motion x `z' = x' - g V z`, so that z is `p/(p + g) x`.

use crate::linear::{Layout, Linear};
use crate::rig::{Actuator, Rig};
use crate::rig_model::{Inputs, RigModel};
use aero::Flow;
use faer::Mat;

/// What a column of a [`Linear`] is in the linear system: states and inputs with factors.
#[derive(Default)]
struct Translation {
    by_state: Vec<(usize, f64)>,
    by_input: Vec<(usize, f64)>,
}

/// Where the states stand.
#[derive(Clone, Copy)]
struct States {
    layout: Layout,
}

impl States {
    fn velocity(self, mode: usize) -> usize {
        self.layout.modes + mode
    }

    fn deflection(self, control: usize) -> usize {
        2 * self.layout.modes + control
    }

    fn deflection_rate(self, control: usize) -> usize {
        self.deflection(self.layout.controls) + control
    }

    fn lag(self, lag: usize) -> usize {
        self.deflection_rate(self.layout.controls) + lag
    }

    fn len(self) -> usize {
        self.lag(self.layout.lags())
    }
}

/// Two matrices whose rows are rows of a [`Linear`] in states and inputs.
struct Pair {
    by_state: Mat<f64>,
    by_input: Mat<f64>,
}

impl Pair {
    fn zeros(rows: usize, states: usize, inputs: usize) -> Self {
        Self { by_state: Mat::zeros(rows, states), by_input: Mat::zeros(rows, inputs) }
    }

    fn put(&mut self, at: usize, linear: &Linear, row: usize, columns: &[Translation]) {
        for (column, translation) in columns.iter().enumerate() {
            let value = linear.by[(row, column)];
            translation.by_state.iter().for_each(|(k, factor)| self.by_state[(at, *k)] += factor * value);
            translation.by_input.iter().for_each(|(k, factor)| self.by_input[(at, *k)] += factor * value);
        }
    }
}

/// Builds the system from the modal accelerations, the outputs and the poles of the air's families, 1/m.
pub(crate) fn state_space(
    rig: &Rig<'_>,
    flow: Flow,
    modal: &Linear,
    outputs: &[Linear],
    poles: [&[f64]; 2],
) -> RigModel {
    let layout = modal.layout;
    let states = States { layout };
    let inputs = Inputs::new(layout.controls);
    let columns = translations(states, rig.settings.actuator);
    let mut rates = Linear::zeros(layout.motions(), layout);
    for motion in 0..layout.motions() {
        rates.by[(motion, layout.motion(1).start + motion)] = 1.0;
    }
    let mut motion = Pair::zeros(states.len(), states.len(), inputs.len());
    for mode in 0..layout.modes {
        motion.by_state[(mode, states.velocity(mode))] = 1.0;
        motion.put(states.velocity(mode), modal, mode, &columns);
    }
    for (lag, (family, pole, of)) in layout.every_lag().enumerate() {
        let at = states.lag(lag);
        motion.put(at, &rates, of, &columns);
        motion.by_state[(at, at)] -= poles[family][pole] * flow.v_m_s;
    }
    put_actuators(&mut motion, states, rig.settings.actuator);
    let mut output =
        Pair::zeros(outputs.iter().map(|part| part.by.nrows()).sum(), states.len(), inputs.len());
    let rows = outputs.iter().flat_map(|part| (0..part.by.nrows()).map(move |row| (part, row)));
    for (at, (part, row)) in rows.enumerate() {
        output.put(at, part, row, &columns);
    }
    RigModel {
        a: motion.by_state,
        b: motion.by_input,
        c: output.by_state,
        d: output.by_input,
        inputs,
        controls: rig.wing.control_names(),
        sensors: rig.settings.sensors.iter().map(|(name, _)| name.clone()).collect(),
        loads: rig.operators.loads.names.clone(),
        flow,
        gravity_m_s2: rig.wing.gravity_m_s2,
        cutoff_hz: rig.settings.cutoff_hz,
    }
}

/// `d'' = w² (command - d) - 2 zeta w d'`
fn put_actuators(motion: &mut Pair, states: States, actuator: Actuator) {
    let omega = std::f64::consts::TAU * actuator.frequency_hz;
    for control in 0..states.layout.controls {
        let (at, rate) = (states.deflection(control), states.deflection_rate(control));
        motion.by_state[(at, rate)] = 1.0;
        motion.by_state[(rate, at)] = -omega * omega;
        motion.by_state[(rate, rate)] = -2.0 * actuator.damping_ratio * omega;
        motion.by_input[(rate, Inputs::CONTROLS + control)] = omega * omega;
    }
}

/// For every column of the layout; modal accelerations have none, they are expressed by the others already.
fn translations(states: States, actuator: Actuator) -> Vec<Translation> {
    let layout = states.layout;
    let omega = std::f64::consts::TAU * actuator.frequency_hz;
    let mut all: Vec<Translation> = (0..layout.len()).map(|_| Translation::default()).collect();
    for mode in 0..layout.modes {
        all[layout.motion(0).start + mode].by_state.push((mode, 1.0));
        all[layout.motion(1).start + mode].by_state.push((states.velocity(mode), 1.0));
    }
    let pitch = [Inputs::ALPHA, Inputs::ALPHA_RATE, Inputs::ALPHA_SECOND];
    for (derivative, input) in pitch.into_iter().enumerate() {
        all[layout.motion(derivative).start + layout.modes].by_input.push((input, 1.0));
    }
    for control in 0..layout.controls {
        let (at, rate) = (states.deflection(control), states.deflection_rate(control));
        let column = |derivative: usize| layout.motion(derivative).start + layout.modes + 1 + control;
        all[column(0)].by_state.push((at, 1.0));
        all[column(1)].by_state.push((rate, 1.0));
        all[column(2)].by_state.extend([(at, -omega * omega), (rate, -2.0 * actuator.damping_ratio * omega)]);
        all[column(2)].by_input.push((Inputs::CONTROLS + control, omega * omega));
    }
    for lag in 0..layout.lags() {
        all[layout.first_lag() + lag].by_state.push((states.lag(lag), 1.0));
    }
    all[layout.one()].by_input.push((Inputs::ONE, 1.0));
    // c = (g sin a, -g cos a, -a'')
    all[layout.field(0)].by_input.push((Inputs::G_SIN, 1.0));
    all[layout.field(1)].by_input.push((Inputs::G_COS, -1.0));
    all[layout.field(2)].by_input.push((Inputs::ALPHA_SECOND, -1.0));
    all
}
