//! The linear part of a wing with effects, and what it is flown through.

use super::active::Active;
use super::place::{Inputs, Needs, Place};
use crate::rom::{Change, Constants, Driven, ReducedOrderModel, ResponseTable};

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

/// The linear part of a wing with effects at one flow.
#[derive(Debug, Clone)]
pub struct Model {
    change: Change,
    constants: Constants,
    everything: bool,
    pub(super) table: ResponseTable,
}

impl Model {
    /// Computes responses, or takes those of `before` if the effects change nothing in them.
    pub fn new(rig: &ReducedOrderModel, effects: &[Active], before: Option<&Self>) -> Self {
        if let Some(before) = before.filter(|before| before.serves(rig, effects)) {
            return before.clone();
        }
        let (change, constants, everything) = asked(rig, effects);
        Self::with(rig, change, constants, everything)
    }

    /// That serves whatever more these effects and others look at.
    pub fn whole(rig: &ReducedOrderModel, effects: &[Active]) -> Self {
        let (change, constants, _) = asked(rig, effects);
        Self::with(rig, change, constants, true)
    }

    fn with(rig: &ReducedOrderModel, change: Change, constants: Constants, everything: bool) -> Self {
        let table = ResponseTable::new(rig, &change, &constants, everything);
        Self { change, constants, everything, table }
    }

    /// Whether it is the linear part for these effects, too.
    pub fn serves(&self, rig: &ReducedOrderModel, effects: &[Active]) -> bool {
        let (change, constants, everything) = asked(rig, effects);
        self.change == change && self.constants == constants && (self.everything || !everything)
    }

    /// Adds what drives make of some outputs (rows of the responses).
    pub(super) fn add(&self, drives: &[&Driven], stimulus: &Stimulus, rows: &[usize], sums: &mut [Vec<f64>]) {
        if stimulus.steady {
            self.table.add_steady(drives, rows, sums);
        } else {
            self.table.add_flown(drives, stimulus.time_step_s, rows, sums);
        }
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

pub(super) fn needs(effects: &[Active]) -> Needs {
    effects.iter().fold(Needs::NONE, |needs, active| needs.with(active.effect.needs()))
}

pub(super) fn place<'a>(
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
