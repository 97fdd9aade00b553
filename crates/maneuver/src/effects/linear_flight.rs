//! A stimulus in the linear wing: what drives it with effects, and what it answers. Most effects leave most of that as it is, so that a
//! flight takes from another one of the same stimulus what is the same.

use super::active::Active;
use super::model::{Model, Stimulus};
use super::place::{Inputs, Needs, Place};
use crate::rig::Actuator;
use crate::rom::{Drive, Driven, Outputs};
use faer::{Mat, c64};
use std::sync::{Arc, OnceLock};

/// See the module.
#[derive(Debug)]
pub struct LinearFlight {
    servos: Servos,
    /// By column of the responses: pitch, stream, gravity aft and down, controls.
    drives: Vec<Driven>,
    responses: Arc<[Mat<c64>]>,
    /// Answers by [`Outputs::kinds`], from when they are asked for.
    answers: [OnceLock<Vec<Vec<f64>>>; 4],
}

/// Commands in front of the servos, and the angles behind them.
#[derive(Debug)]
pub(super) struct Servos {
    actuator: Actuator,
    commands_rad: Vec<Vec<f64>>,
    angles_rad: Vec<Vec<f64>>,
}

impl LinearFlight {
    /// A stimulus with effects, and with what drives the wing: its controls behind their servos.
    pub(super) fn first(
        place: &Place<'_>,
        model: &Model,
        effects: &[Active],
        stimulus: &Stimulus,
    ) -> (Self, Inputs) {
        let (inputs, servos) = turned(place, effects, stimulus.inputs.clone(), None);
        // gravity follows the balance's own angle
        let gravity = |of: fn(f64) -> f64| {
            let along = stimulus.inputs.alpha.value.iter().map(|alpha| place.gravity_m_s2 * of(*alpha));
            along.collect::<Vec<f64>>()
        };
        let (sin, cos) = (gravity(f64::sin), gravity(f64::cos));
        let mut drives = vec![
            Driven::new(Drive::PITCH, inputs.alpha.value.clone()),
            Driven::new(Drive::INCIDENCE, inputs.incidence_rad.clone()),
            Driven::new(Drive::G_SIN, sin),
            Driven::new(Drive::G_COS, cos),
        ];
        let controls = inputs.controls_rad.iter().enumerate();
        drives.extend(controls.map(|(c, values)| Driven::new(Drive::CONTROLS + c, values.clone())));
        let responses = Arc::clone(&model.table.responses);
        (Self { servos, drives, responses, answers: Default::default() }, inputs)
    }

    /// What drives the wing in another flight of the stimulus.
    pub(super) fn turned(&self, place: &Place<'_>, effects: &[Active], stimulus: &Stimulus) -> Inputs {
        turned(place, effects, stimulus.inputs.clone(), Some(&self.servos)).0
    }

    /// Answers of the balance and the tip, then of the zones what effects look at.
    pub(super) fn answer(
        &self,
        model: &Model,
        outputs: Outputs,
        needs: Needs,
        stimulus: &Stimulus,
    ) -> Vec<Vec<f64>> {
        let kinds = outputs.kinds();
        let drives: Vec<&Driven> = self.drives.iter().collect();
        let of = |kind: usize| {
            self.answers[kind]
                .get_or_init(|| from_rest(model, &drives, stimulus, &kinds[kind].clone().collect::<Vec<_>>()))
        };
        let one = |row: usize| {
            let kind = kinds.iter().position(|kind| kind.contains(&row)).unwrap_or(0);
            of(kind)[row - kinds[kind].start].clone()
        };
        rows(outputs, needs).into_iter().map(one).collect()
    }

    /// The same of another flight, driven by `inputs`: where the linear wing is the same, what differs in its drives is added.
    pub(super) fn answer_beside(
        &self,
        model: &Model,
        outputs: Outputs,
        needs: Needs,
        stimulus: &Stimulus,
        inputs: &Inputs,
    ) -> Vec<Vec<f64>> {
        let given = |column: usize| match column {
            Drive::PITCH => &inputs.alpha.value,
            Drive::INCIDENCE => &inputs.incidence_rad,
            column => &inputs.controls_rad[column - Drive::CONTROLS],
        };
        let is_changed = |column: &usize| {
            !matches!(*column, Drive::G_SIN | Drive::G_COS)
                && *given(*column) != self.drives[*column].values()
        };
        let changed: Vec<Driven> = (0..self.drives.len())
            .filter(is_changed)
            .map(|column| Driven::new(column, given(column).clone()))
            .collect();
        if Arc::ptr_eq(&model.table.responses, &self.responses) {
            let mut answer = self.answer(model, outputs, needs, stimulus);
            let beyond: Vec<Driven> =
                changed.iter().map(|own| own.less(&self.drives[own.column()])).collect();
            model.add(&beyond.iter().collect::<Vec<_>>(), stimulus, &rows(outputs, needs), &mut answer);
            return answer;
        }
        let mut drives: Vec<&Driven> = self.drives.iter().collect();
        for own in &changed {
            drives[own.column()] = own;
        }
        from_rest(model, &drives, stimulus, &rows(outputs, needs))
    }
}

fn from_rest(model: &Model, drives: &[&Driven], stimulus: &Stimulus, rows: &[usize]) -> Vec<Vec<f64>> {
    let samples = stimulus.inputs.alpha.value.len();
    let mut answer: Vec<Vec<f64>> = rows.iter().map(|row| vec![model.table.rest[*row]; samples]).collect();
    model.add(drives, stimulus, rows, &mut answer);
    answer
}

/// What drives the wing, its controls behind their servos.
pub(super) fn turned(
    place: &Place<'_>,
    effects: &[Active],
    mut inputs: Inputs,
    before: Option<&Servos>,
) -> (Inputs, Servos) {
    for active in effects {
        active.effect.inputs(&active.values, place, &mut inputs);
    }
    let commands_rad = inputs.controls_rad.clone();
    let before = before.filter(|before| before.actuator == place.actuator);
    if !place.steady {
        for (c, control) in inputs.controls_rad.iter_mut().enumerate() {
            *control = match before.filter(|before| before.commands_rad[c] == *control) {
                Some(before) => before.angles_rad[c].clone(),
                None => place.actuator.follow(control, place.time_step_s),
            };
        }
    }
    let servos = Servos { actuator: place.actuator, commands_rad, angles_rad: inputs.controls_rad.clone() };
    for active in effects {
        active.effect.surfaces(&active.values, place, &mut inputs);
    }
    (inputs, servos)
}

/// Rows of the response that are needed: the balance, the tip, and of the zones what effects look at.
pub(super) fn rows(outputs: Outputs, needs: Needs) -> Vec<usize> {
    let [balance, lifts, heights, twists] = outputs.kinds();
    let outer = heights.clone().next_back().filter(|_| needs.outer_height);
    let of = |rows: std::ops::Range<usize>, is_needed: bool| rows.filter(move |_| is_needed);
    balance
        .chain(of(lifts, needs.lift))
        .chain(of(heights, needs.height))
        .chain(of(twists, needs.twist))
        .chain(outer)
        .collect()
}
