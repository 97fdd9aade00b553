//! Static points and runs of a reduced-order model with effects.

use super::active::Active;
use super::linear_flight::{LinearFlight, rows};
use super::model::{Model, Stimulus, needs, place};
use super::place::{Forces, Inputs, Loads, Needs, Place, WingState};
use super::spec::Stage;
use crate::rom::{Driven, ReducedOrderModel};

/// How often forces that depend on the state are put back into the wing; what stalls changes its own angle little.
const ROUNDS: usize = 4;
/// Rounds end when no lift changes by more than this share of the largest.
const SETTLED: f64 = 1e-4;

/// What a wing with effects shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Flown {
    /// Fz, Mx, My, N and N m.
    pub loads: [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_m: Vec<f64>,
}

/// Flies a stimulus. `model` is of the same rig and effects.
pub fn fly(rig: &ReducedOrderModel, model: &Model, effects: &[Active], stimulus: &Stimulus) -> Flown {
    fly_first(rig, model, effects, stimulus).0
}

/// The same, and what other flights of the stimulus may take from this one.
pub fn fly_first(
    rig: &ReducedOrderModel,
    model: &Model,
    effects: &[Active],
    stimulus: &Stimulus,
) -> (Flown, LinearFlight) {
    let place = place_of(rig, effects, stimulus);
    let (flight, inputs) = LinearFlight::first(&place, model, effects, stimulus);
    let linear = flight.answer(model, rig.outputs(), needs(effects), stimulus);
    (Answered { rig, model, effects, stimulus, place, inputs }.finished(linear), flight)
}

/// The same beside another flight of the stimulus by the same rig, from which it takes what is the same.
pub fn fly_beside(
    rig: &ReducedOrderModel,
    model: &Model,
    effects: &[Active],
    stimulus: &Stimulus,
    before: &LinearFlight,
) -> Flown {
    let place = place_of(rig, effects, stimulus);
    let inputs = before.turned(&place, effects, stimulus);
    let linear = before.answer_beside(model, rig.outputs(), needs(effects), stimulus, &inputs);
    Answered { rig, model, effects, stimulus, place, inputs }.finished(linear)
}

fn place_of<'a>(rig: &'a ReducedOrderModel, effects: &[Active], stimulus: &Stimulus) -> Place<'a> {
    place(rig, effects, stimulus.time_step_s, stimulus.steady, stimulus.clock_h)
}

/// A flight whose linear answer is known.
struct Answered<'a> {
    rig: &'a ReducedOrderModel,
    model: &'a Model,
    effects: &'a [Active],
    stimulus: &'a Stimulus,
    place: Place<'a>,
    /// What drives the wing, its controls behind their servos.
    inputs: Inputs,
}

impl Answered<'_> {
    /// What is recorded: with the forces that effects add, and with what they do on the way from the wing.
    fn finished(&self, linear: Vec<Vec<f64>>) -> Flown {
        let Self { effects, place, .. } = self;
        let answer = if needs(effects) == Needs::NONE { linear } else { self.with_forces(&linear) };
        let state = self.state(&answer);
        let mut loads = Loads { balance: state.loads.clone(), tip_m: state.tip_m.to_vec() };
        for stage in Stage::ALL {
            for active in effects.iter().filter(|active| active.effect.stage() == stage) {
                active.effect.loads(&active.values, place, &state, &mut loads);
            }
        }
        Flown { loads: loads.balance, tip_m: loads.tip_m }
    }

    /// The answer with the forces that depend on it.
    fn with_forces(&self, linear: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let Self { rig, model, effects, stimulus, place, inputs } = self;
        let rows = rows(rig.outputs(), needs(effects));
        let mut answer = linear.to_vec();
        let mut forces = Forces::none(rig.zones.len(), inputs.alpha.value.len());
        for _ in 0..ROUNDS {
            let wanted = forces_at(place, effects, self.state(&answer), &forces);
            let settled = settled(&forces, &wanted);
            forces = wanted;
            if settled {
                break;
            }
            let acts = |(_, values): &(usize, &Vec<f64>)| values.iter().any(|value| *value != 0.0);
            let lifts = forces.lift_n.iter().enumerate().map(|(z, v)| (rig.drive().lifts() + z, v));
            let modal = forces.modal.iter().enumerate().map(|(m, v)| (rig.drive().modal() + m, v));
            let drives: Vec<Driven> =
                lifts.chain(modal).filter(acts).map(|(column, v)| Driven::new(column, v.clone())).collect();
            // the wing is linear: what drives it answers as before
            answer.clone_from_slice(linear);
            model.add(&drives.iter().collect::<Vec<_>>(), stimulus, &rows, &mut answer);
        }
        answer
    }

    /// The rows of an answer by their kind.
    fn state<'b>(&'b self, answer: &'b [Vec<f64>]) -> WingState<'b> {
        let (needs, zones) = (needs(self.effects), self.rig.zones.len());
        let (loads, rest) = answer.split_first_chunk().expect("the balance's loads come first");
        let (tip_m, mut left) = rest.split_first().expect("the tip comes behind the balance");
        let mut next = |is_needed: bool| {
            let (own, after) = left.split_at(if is_needed { zones } else { 0 });
            left = after;
            own
        };
        let [lift_n, height_m, twist_rad] = [needs.lift, needs.height, needs.twist].map(&mut next);
        let outer_height_m: &[f64] = left.first().map_or(&[], Vec::as_slice);
        WingState { inputs: &self.inputs, loads, tip_m, lift_n, height_m, outer_height_m, twist_rad }
    }
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

#[cfg(test)]
mod tests;
