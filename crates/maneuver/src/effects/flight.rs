//! Static points and runs of a reduced-order model with effects.

use super::active::Active;
use super::place::{Forces, Inputs, Loads, Needs, Place, WingState};
use super::spec::Stage;
use crate::rom::{Change, Constants, Drive, Outputs, ReducedOrderModel, ResponseTable};

/// How often forces that depend on the state are put back into the wing; what stalls changes its own angle little.
const ROUNDS: usize = 4;
/// Rounds end when no lift changes by more than this share of the largest.
const SETTLED: f64 = 1e-4;

/// What drives a wing: a run, or static points one beside the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Stimulus {
    /// Angle and commands.
    pub inputs: Inputs,
    /// Time step, s.
    pub time_step_s: f64,
    /// Whether samples are static points.
    pub steady: bool,
    /// Clock time of the first sample, h.
    pub clock_h: f64,
}

/// What a wing with effects shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Flown {
    /// Fz, Mx, My, N and N m.
    pub loads: [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_m: Vec<f64>,
}

/// The linear part of a wing with effects at one flow.
#[derive(Debug, Clone)]
pub struct Model {
    change: Change,
    constants: Constants,
    everything: bool,
    table: ResponseTable,
}

impl Model {
    /// Computes responses, or takes those of `before` if the effects change nothing in them.
    pub fn new(rig: &ReducedOrderModel, effects: &[Active], before: Option<&Self>) -> Self {
        if let Some(before) = before.filter(|before| before.serves(rig, effects)) {
            return before.clone();
        }
        let (change, constants, everything) = asked(rig, effects);
        let table = ResponseTable::new(rig, &change, &constants, everything);
        Self { change, constants, everything, table }
    }

    /// Whether it is the linear part for these effects, too.
    pub fn serves(&self, rig: &ReducedOrderModel, effects: &[Active]) -> bool {
        let (change, constants, everything) = asked(rig, effects);
        self.change == change && self.constants == constants && (self.everything || !everything)
    }
}

/// What effects ask of the linear wing.
fn asked(rig: &ReducedOrderModel, effects: &[Active]) -> (Change, Constants, bool) {
    let place = place(rig, effects, 0.0, true, 0.0);
    let mut change = Change::none(rig.zones.len());
    let mut constants = Constants::default();
    for active in effects {
        active.effect.change(&active.values, &place, &mut change);
        active.effect.constants(&active.values, &place, &mut constants);
    }
    (change, constants, needs(effects) != Needs::NONE)
}

fn needs(effects: &[Active]) -> Needs {
    effects.iter().fold(Needs::NONE, |needs, active| needs.with(active.effect.needs()))
}

fn place<'a>(
    rig: &'a ReducedOrderModel,
    effects: &[Active],
    time_step_s: f64,
    steady: bool,
    clock_h: f64,
) -> Place<'a> {
    let mut actuator = rig.actuator;
    for active in effects {
        active.effect.servos(&active.values, &mut actuator);
    }
    Place {
        flow: rig.flow,
        zones: &rig.zones,
        controls: &rig.controls,
        time_step_s,
        steady,
        clock_h,
        actuator,
        gravity_m_s2: rig.gravity_m_s2(),
        balance_y_m: rig.balance_y_m(),
        outer_shape: rig.outer_shape(),
        first_stiffness: rig.first_stiffness(),
    }
}

/// Flies a stimulus. `model` is of the same rig and effects.
pub fn fly(rig: &ReducedOrderModel, model: &Model, effects: &[Active], stimulus: &Stimulus) -> Flown {
    let place = place(rig, effects, stimulus.time_step_s, stimulus.steady, stimulus.clock_h);
    let inputs = turned(&place, effects, stimulus.inputs.clone());
    let samples = inputs.alpha.value.len();
    let g = rig.gravity_m_s2();
    // gravity follows the balance's own angle
    let g_sin: Vec<f64> = stimulus.inputs.alpha.value.iter().map(|a| g * a.sin()).collect();
    let g_cos: Vec<f64> = stimulus.inputs.alpha.value.iter().map(|a| g * a.cos()).collect();
    let mut drives: Vec<(usize, &[f64])> = vec![
        (Drive::PITCH, &inputs.alpha.value),
        (Drive::INCIDENCE, &inputs.incidence_rad),
        (Drive::G_SIN, &g_sin),
        (Drive::G_COS, &g_cos),
    ];
    let controls = inputs.controls_rad.iter().enumerate();
    drives.extend(controls.map(|(c, values)| (Drive::CONTROLS + c, values.as_slice())));
    drives.retain(|(_, values)| values.iter().any(|value| *value != 0.0));
    let needs = needs(effects);
    let rows = rows(rig.outputs(), needs, rig.zones.len());
    let add = |drives: &[(usize, &[f64])], sums: &mut [Vec<f64>]| {
        if stimulus.steady {
            model.table.add_steady(drives, &rows, sums);
        } else {
            model.table.add_flown(drives, stimulus.time_step_s, &rows, sums);
        }
    };
    let mut linear: Vec<Vec<f64>> = rows.iter().map(|row| vec![model.table.rest[*row]; samples]).collect();
    add(&drives, &mut linear);
    let mut answer = linear.clone();
    if needs != Needs::NONE {
        let mut forces = Forces::none(rig.zones.len(), samples);
        for _ in 0..ROUNDS {
            let split = Split::new(needs, rig.zones.len(), &answer);
            let wanted = forces_at(&place, effects, split.state(&inputs), &forces);
            let settled = settled(&forces, &wanted);
            forces = wanted;
            if settled {
                break;
            }
            let lifts =
                forces.lift_n.iter().enumerate().map(|(z, v)| (rig.drive().lifts() + z, v.as_slice()));
            let modal = forces.modal.iter().enumerate().map(|(m, v)| (rig.drive().modal() + m, v.as_slice()));
            let mut drives: Vec<(usize, &[f64])> = lifts.chain(modal).collect();
            drives.retain(|(_, values)| values.iter().any(|value| *value != 0.0));
            // the wing is linear: what drives it answers as before
            answer.clone_from(&linear);
            add(&drives, &mut answer);
        }
    }
    let split = Split::new(needs, rig.zones.len(), &answer);
    let state = split.state(&inputs);
    let mut loads = Loads { balance: split.loads.clone(), tip_m: split.tip_m.to_vec() };
    for stage in Stage::ALL {
        for active in effects.iter().filter(|active| active.effect.stage() == stage) {
            active.effect.loads(&active.values, &place, &state, &mut loads);
        }
    }
    Flown { loads: loads.balance, tip_m: loads.tip_m }
}

/// What drives the wing, its controls behind their servos.
fn turned(place: &Place<'_>, effects: &[Active], mut inputs: Inputs) -> Inputs {
    for active in effects {
        active.effect.inputs(&active.values, place, &mut inputs);
    }
    if !place.steady {
        for control in &mut inputs.controls_rad {
            *control = place.actuator.follow(control, place.time_step_s);
        }
    }
    for active in effects {
        active.effect.surfaces(&active.values, place, &mut inputs);
    }
    inputs
}

/// The forces of a state; effects see the lift without the forces of the round before.
fn forces_at(place: &Place<'_>, effects: &[Active], state: WingState<'_>, before: &Forces) -> Forces {
    let without =
        |(lift, added): (&Vec<f64>, &Vec<f64>)| lift.iter().zip(added).map(|(l, a)| l - a).collect();
    let lift_n: Vec<Vec<f64>> = state.lift_n.iter().zip(&before.lift_n).map(without).collect();
    let state = WingState { lift_n: &lift_n, ..state };
    let mut forces = Forces::none(place.zones.len(), state.len());
    for active in effects {
        active.effect.forces(&active.values, place, &state, &mut forces);
    }
    forces
}

fn settled(before: &Forces, after: &Forces) -> bool {
    let largest = after.values().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    before.values().zip(after.values()).all(|(a, b)| (a - b).abs() <= SETTLED * largest)
}

/// Rows of the response that are needed: the balance, the tip, and of the zones what effects look at.
fn rows(outputs: Outputs, needs: Needs, zones: usize) -> Vec<usize> {
    let of = |first: usize, is_needed: bool| (first..first + zones).filter(move |_| is_needed);
    let outer = (outputs.heights()..outputs.twists()).next_back().filter(|_| needs.outer_height);
    (0..outputs.lifts())
        .chain(of(outputs.lifts(), needs.lift))
        .chain(of(outputs.heights(), needs.height))
        .chain(of(outputs.twists(), needs.twist))
        .chain(outer)
        .collect()
}

/// Those rows by their kind.
struct Split<'a> {
    loads: [Vec<f64>; 3],
    tip_m: &'a [f64],
    lift_n: &'a [Vec<f64>],
    height_m: &'a [Vec<f64>],
    twist_rad: &'a [Vec<f64>],
    outer_height_m: &'a [f64],
}

impl<'a> Split<'a> {
    fn new(needs: Needs, zones: usize, answer: &'a [Vec<f64>]) -> Self {
        let mut left = &answer[Outputs::TIP + 1..];
        let mut next = |is_needed: bool| {
            let (own, after) = left.split_at(if is_needed { zones } else { 0 });
            left = after;
            own
        };
        let [lift_n, height_m, twist_rad] = [needs.lift, needs.height, needs.twist].map(&mut next);
        Self {
            loads: std::array::from_fn(|c| answer[c].clone()),
            tip_m: &answer[Outputs::TIP],
            lift_n,
            height_m,
            twist_rad,
            outer_height_m: left.first().map_or(&[], Vec::as_slice),
        }
    }

    fn state<'b>(&'b self, inputs: &'b Inputs) -> WingState<'b> {
        WingState {
            inputs,
            loads: &self.loads,
            tip_m: self.tip_m,
            lift_n: self.lift_n,
            height_m: self.height_m,
            outer_height_m: self.outer_height_m,
            twist_rad: self.twist_rad,
        }
    }
}

#[cfg(test)]
mod tests;
