//! A flight in time: changes from a state at rest, by the average acceleration of a step (Newmark 1959).

use super::GRAVITY_M_S2;
use super::coupled::{Coupled, Rest};
use crate::air::Memory;
use nalgebra::{DMatrix, DVector, Dyn, LU};

/// Swing of the tip in hundredths of the half span beyond which damping does not grow.
const MOST_SWING: f64 = 4.0;

/// What moves, by step.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    /// Angle of attack, its rate and second derivative: rad, s.
    pub alpha: [Vec<f64>; 3],
    /// Deflection of every control with rate and second derivative.
    pub controls: Vec<[Vec<f64>; 3]>,
}

/// What happened, by step.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Flight {
    /// Fz, Mx, My, from the wing level in still air.
    pub loads: [Vec<f64>; 3],
    /// Height of the tip from the wing level in still air, m.
    pub tip_z_m: Vec<f64>,
    /// Lift of strips, N, step by step; only if asked for.
    pub lift_n: Vec<Vec<f64>>,
    /// Height of the strips' quarter points from the wing level in still air, m, likewise.
    pub height_m: Vec<Vec<f64>>,
}

/// Matrices of a step.
struct Step {
    solver: LU<f64, Dyn, Dyn>,
    by_position: DMatrix<f64>,
    by_velocity: DMatrix<f64>,
    /// Generalised forces by circulations and integrals, and by the integrals' rates.
    forces: [DMatrix<f64>; 2],
    /// Balance loads likewise.
    loads: [DMatrix<f64>; 2],
    /// Columns of the operator: positions times the airspeed, rates.
    positions: DMatrix<f64>,
    rates: DMatrix<f64>,
    /// Strips' own incidence.
    strips: DMatrix<f64>,
    /// Factor of strips' apparent mass beyond one, for the rows of the integrals.
    apparent: DVector<f64>,
}

impl Coupled<'_> {
    fn step(&self) -> Step {
        let (modes, dt) = (self.structure.omega_rad_s.len(), self.time_step_s);
        let (count, motions) = (self.operator.strips, self.operator.motions);
        let positions = self.operator.by_motion.columns(0, motions) * self.v_m_s;
        let rates = self.operator.by_motion.columns(motions, motions).into_owned();
        let forces = [&self.generalised * &self.by_state, &self.generalised * &self.by_rate];
        let loads = [&self.balance * &self.by_state, &self.balance * &self.by_rate];
        let by_position = &forces[0] * positions.columns(0, modes);
        let by_velocity = &forces[0] * rates.columns(0, modes) + &forces[1] * positions.columns(0, modes);
        let strips = &self.rig.lattice.strips;
        let apparent = DVector::from_fn(3 * count, |row, _| {
            let eta = strips[row % count].y_m / self.rig.wing.planform.semispan_m;
            // the factor of the lift is not one of the apparent mass
            self.setting.apparent.at(eta) / self.setting.lift.at(eta) - 1.0
        });
        let carried = DMatrix::from_fn(3 * count, modes, |i, j| rates[(i, j)] * (1.0 + apparent[i]));
        let by_acceleration = &forces[1] * carried;
        let effective = DMatrix::from_fn(modes, modes, |i, j| {
            let (omega, zeta) = (self.structure.omega_rad_s[i], self.structure.damping[i]);
            let own = if i == j { 1.0 + dt * zeta * omega + 0.25 * (dt * omega).powi(2) } else { 0.0 };
            own - by_acceleration[(i, j)]
                - 0.5 * dt * by_velocity[(i, j)]
                - 0.25 * dt * dt * by_position[(i, j)]
        });
        let strips = &self.operator.by_strip * self.v_m_s;
        Step {
            solver: effective.lu(),
            by_position,
            by_velocity,
            forces,
            loads,
            positions,
            rates,
            strips,
            apparent,
        }
    }

    /// Flies from rest in the inputs' first step.
    pub fn fly(&self, inputs: &Inputs, strips_too: bool) -> Flight {
        let deltas: Vec<f64> = inputs.controls.iter().map(|control| control[0][0]).collect();
        let rest = self.at_rest(inputs.alpha[0][0], &deltas);
        let mut march = March::new(self, &rest, strips_too);
        let mut flight = Flight::default();
        march.record(&mut flight);
        for i in 1..inputs.alpha[0].len() {
            march.advance(inputs, i);
            march.record(&mut flight);
        }
        flight
    }
}

/// The state of a flight: changes from rest.
struct March<'a> {
    coupled: &'a Coupled<'a>,
    rest: &'a Rest,
    step: Step,
    memory: Memory<'a>,
    modal: [DVector<f64>; 3],
    /// Incidence of strips beside that of rest: lost, play and walls, and its change in the last step.
    own: DVector<f64>,
    lost: DVector<f64>,
    loads: [f64; 3],
    lift_n: DVector<f64>,
    /// Whether the strips' lift is asked for.
    strips_too: bool,
    /// Amplitude of modes that is one for the growth of damping.
    amplitude: Vec<f64>,
}

impl<'a> March<'a> {
    fn new(coupled: &'a Coupled<'a>, rest: &'a Rest, strips_too: bool) -> Self {
        let modes = coupled.structure.omega_rad_s.len();
        let hundredth_m = 0.01 * coupled.rig.wing.planform.semispan_m;
        let none = DVector::zeros(modes);
        Self {
            step: coupled.step(),
            memory: Memory::new(&coupled.operator, &coupled.rig.lattice.rows),
            modal: [none.clone(), none.clone(), none],
            own: DVector::zeros(coupled.operator.strips),
            lost: rest.lost.clone(),
            loads: rest.loads,
            lift_n: rest.lift_n.clone(),
            amplitude: coupled.structure.tip.iter().map(|tip| hundredth_m / tip.abs().max(1e-9)).collect(),
            coupled,
            rest,
            strips_too,
        }
    }

    /// Inputs of the rigid motions at a step, changes from rest: positions, rates, accelerations of pitch and controls.
    fn moved(inputs: &Inputs, i: usize) -> [DVector<f64>; 3] {
        std::array::from_fn(|derivative| {
            let change = |values: &[Vec<f64>; 3]| {
                values[derivative][i] - if derivative == 0 { values[0][0] } else { 0.0 }
            };
            let all = std::iter::once(change(&inputs.alpha)).chain(inputs.controls.iter().map(change));
            DVector::from_iterator(1 + inputs.controls.len(), all)
        })
    }

    /// Incidences of strips beside the rigid motion, from what is known of the step before.
    fn strips(&mut self, alpha_rad: f64) -> (DVector<f64>, DVector<f64>) {
        let coupled = self.coupled;
        let before = self.own.clone();
        let (setting, dt) = (&coupled.setting, coupled.time_step_s);
        if let Some(stall) = setting.stall {
            let modal = &self.rest.modal + &self.modal[0];
            let angles = coupled.angles(alpha_rad, &modal, &self.modal[1]);
            for (s, angle) in angles.iter().enumerate() {
                let chord_m = coupled.rig.lattice.strips[s].chord_m;
                let share = 1.0 - (-dt * coupled.v_m_s / (stall.chords * chord_m)).exp();
                self.lost[s] += share * (coupled.lost(*angle) - self.lost[s]);
            }
        }
        let play = coupled.play(self.loads[2]) - coupled.play(self.rest.loads[2]);
        for s in 0..self.own.len() {
            let wall = coupled.wall(self.loads[0] - self.rest.loads[0], s);
            self.own[s] = self.lost[s] - self.rest.lost[s] + play + wall;
        }
        let rate = (&self.own - before) / dt;
        (self.own.clone(), rate)
    }

    fn advance(&mut self, inputs: &Inputs, i: usize) {
        let (coupled, dt) = (self.coupled, self.coupled.time_step_s);
        let modes = self.modal[0].len();
        let own = coupled.strips_turn().then(|| self.strips(inputs.alpha[0][i]));
        let rigid = Self::moved(inputs, i);
        let step = &self.step;
        let (wake, wake_rate) = self.memory.begin(dt);
        let others = rigid[0].len();
        let columns = |matrix: &DMatrix<f64>, by: &DVector<f64>| matrix.columns(modes, others) * by;
        let mut state = wake + columns(&step.positions, &rigid[0]) + columns(&step.rates, &rigid[1]);
        let mut rate = wake_rate + columns(&step.positions, &rigid[1]);
        let carried = columns(&step.rates, &rigid[2]);
        if let Some((own, own_rate)) = own {
            state += &step.strips * own;
            rate += &step.strips * own_rate;
        }
        rate += &carried + carried.component_mul(&step.apparent);
        // where the modes would be without acceleration at the step's end
        let position = &self.modal[0] + &self.modal[1] * dt + &self.modal[2] * (0.25 * dt * dt);
        let velocity = &self.modal[1] + &self.modal[2] * (0.5 * dt);
        let mut force = &step.forces[0] * &state
            + &step.forces[1] * &rate
            + &step.by_position * &position
            + &step.by_velocity * &velocity;
        let pull = GRAVITY_M_S2 * (inputs.alpha[0][i].cos() - inputs.alpha[0][0].cos());
        force += coupled.structure.fields.column(0) * pull
            + coupled.structure.fields.column(1) * inputs.alpha[2][i];
        for mode in 0..modes {
            let (omega, zeta) = (coupled.structure.omega_rad_s[mode], coupled.structure.damping[mode]);
            // by the rate: what is merely held bent does not swing
            let swing = (self.modal[1][mode] / omega).abs() / self.amplitude[mode];
            let grown = 1.0 + coupled.setting.damping_growth * swing.min(MOST_SWING);
            force[mode] -= omega * omega * position[mode] + 2.0 * zeta * omega * grown * velocity[mode];
        }
        let acceleration =
            step.solver.solve(&force).unwrap_or_else(|| DVector::from_element(modes, f64::NAN));
        self.modal = [
            position + &acceleration * (0.25 * dt * dt),
            velocity + &acceleration * (0.5 * dt),
            acceleration,
        ];
        let flexible = |matrix: &DMatrix<f64>, by: &DVector<f64>| matrix.columns(0, modes) * by;
        state += flexible(&step.positions, &self.modal[0]) + flexible(&step.rates, &self.modal[1]);
        rate += flexible(&step.positions, &self.modal[1]);
        let carried = flexible(&step.rates, &self.modal[2]);
        rate += &carried + carried.component_mul(&step.apparent);
        self.memory.end(&state.as_slice()[..coupled.operator.strips]);
        let inertia = &coupled.structure.balance * &self.modal[2];
        let air = &step.loads[0] * &state + &step.loads[1] * &rate;
        for channel in 0..3 {
            let [pulled, turned] = [0, 1].map(|of| coupled.structure.rigid[of][channel]);
            self.loads[channel] = self.rest.loads[channel] + air[channel] - inertia[channel]
                + pulled * pull
                + turned * inputs.alpha[2][i];
        }
        if self.strips_too {
            let count = coupled.operator.strips;
            let lift = coupled.by_state.rows(0, count) * state + coupled.by_rate.rows(0, count) * rate;
            self.lift_n = &self.rest.lift_n + lift;
        }
    }

    fn record(&self, flight: &mut Flight) {
        for (record, load) in flight.loads.iter_mut().zip(self.loads) {
            record.push(load);
        }
        let structure = &self.coupled.structure;
        flight.tip_z_m.push(self.rest.tip_z_m + structure.tip.dot(&self.modal[0]));
        if self.strips_too {
            let modal = &self.rest.modal + &self.modal[0] - &structure.sag;
            flight.lift_n.push(self.lift_n.iter().copied().collect());
            flight.height_m.push((&structure.height * modal).iter().copied().collect());
        }
    }
}
