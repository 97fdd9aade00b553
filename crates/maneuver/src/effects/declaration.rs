//! How an effect's file declares it: one literal a form, with functions where the effect acts.

use super::effect::Effect;
use super::flight_air::{Flight, FlightAir};
use super::place::{Forces, Inputs, Loads, Needs, Place, WingState};
use super::spec::{Known, Parameter, Spec, Stage};
use crate::rig::Actuator;
use crate::rom::{Change, Constants};

/// One form of an effect. Its fields are the methods of [`Effect`]; those that [`Declaration::NONE`] is left to fill in do
/// nothing.
#[derive(Debug, Clone, Copy)]
pub(super) struct Declaration {
    pub(super) spec: Spec,
    pub(super) form: &'static str,
    /// By the names of the wing's controls; none: the effect is not of this wing.
    pub(super) parameters: fn(&[String]) -> Vec<Parameter>,
    /// How well a wing's file says that the parameters are known.
    pub(super) known: fn(&Known, &mut [Parameter]),
    pub(super) starts: &'static [&'static [f64]],
    pub(super) constrain: fn(&mut [f64]),
    pub(super) is_itself: fn(&[f64]) -> bool,
    pub(super) inputs: fn(&[f64], &Place<'_>, &mut Inputs),
    pub(super) servos: fn(&[f64], &mut Actuator),
    pub(super) surfaces: fn(&[f64], &Place<'_>, &mut Inputs),
    pub(super) change: fn(&[f64], &Place<'_>, &mut Change),
    pub(super) constants: fn(&[f64], &Place<'_>, &mut Constants),
    pub(super) needs: Needs,
    pub(super) forces: fn(&[f64], &Place<'_>, &WingState<'_>, &mut Forces),
    pub(super) loads: fn(&[f64], &Place<'_>, &WingState<'_>, &mut Loads),
    pub(super) stage: Stage,
    pub(super) splits_stiffness: bool,
    pub(super) holds_at_rest_only: bool,
    pub(super) excludes_deflection_correction: bool,
    pub(super) flight: Flight,
    pub(super) correct: fn(&[f64], &mut FlightAir<'_>),
}

impl Declaration {
    /// What an effect's file does not mention.
    pub(super) const NONE: Self = Self {
        spec: Spec::NONE,
        form: "",
        parameters: |_| Vec::new(),
        known: |_, _| (),
        starts: &[],
        constrain: |_| (),
        is_itself: |_| true,
        inputs: |_, _, _| (),
        servos: |_, _| (),
        surfaces: |_, _, _| (),
        change: |_, _, _| (),
        constants: |_, _, _| (),
        needs: Needs::NONE,
        forces: |_, _, _, _| (),
        loads: |_, _, _, _| (),
        stage: Stage::Load,
        splits_stiffness: false,
        holds_at_rest_only: false,
        excludes_deflection_correction: false,
        flight: Flight::Left,
        correct: |_, _| (),
    };
}

/// A declared effect on a wing with certain controls.
#[derive(Debug)]
pub(super) struct Declared {
    declaration: &'static Declaration,
    parameters: Vec<Parameter>,
}

impl Declared {
    /// None if the effect is not of a wing with these controls.
    pub(super) fn new(declaration: &'static Declaration, controls: &[String], known: &Known) -> Option<Self> {
        let mut parameters = (declaration.parameters)(controls);
        (declaration.known)(known, &mut parameters);
        (!parameters.is_empty()).then_some(Self { declaration, parameters })
    }
}

impl Effect for Declared {
    fn spec(&self) -> &'static Spec {
        &self.declaration.spec
    }

    fn parameters(&self) -> Vec<Parameter> {
        self.parameters.clone()
    }

    fn form(&self) -> &'static str {
        self.declaration.form
    }

    fn starts(&self) -> Vec<Vec<f64>> {
        self.declaration.starts.iter().map(|start| start.to_vec()).collect()
    }

    fn constrain(&self, p: &mut [f64]) {
        (self.declaration.constrain)(p);
    }

    fn is_itself(&self, p: &[f64]) -> bool {
        (self.declaration.is_itself)(p)
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        (self.declaration.inputs)(p, place, inputs);
    }

    fn servos(&self, p: &[f64], servos: &mut Actuator) {
        (self.declaration.servos)(p, servos);
    }

    fn surfaces(&self, p: &[f64], place: &Place<'_>, angles: &mut Inputs) {
        (self.declaration.surfaces)(p, place, angles);
    }

    fn change(&self, p: &[f64], place: &Place<'_>, change: &mut Change) {
        (self.declaration.change)(p, place, change);
    }

    fn constants(&self, p: &[f64], place: &Place<'_>, constants: &mut Constants) {
        (self.declaration.constants)(p, place, constants);
    }

    fn needs(&self) -> Needs {
        self.declaration.needs
    }

    fn forces(&self, p: &[f64], place: &Place<'_>, state: &WingState<'_>, forces: &mut Forces) {
        (self.declaration.forces)(p, place, state, forces);
    }

    fn loads(&self, p: &[f64], place: &Place<'_>, state: &WingState<'_>, loads: &mut Loads) {
        (self.declaration.loads)(p, place, state, loads);
    }

    fn stage(&self) -> Stage {
        self.declaration.stage
    }

    fn splits_stiffness(&self) -> bool {
        self.declaration.splits_stiffness
    }

    fn holds_at_rest_only(&self) -> bool {
        self.declaration.holds_at_rest_only
    }

    fn excludes_deflection_correction(&self) -> bool {
        self.declaration.excludes_deflection_correction
    }

    fn flight(&self) -> Flight {
        self.declaration.flight
    }

    fn correct(&self, p: &[f64], air: &mut FlightAir<'_>) {
        (self.declaration.correct)(p, air);
    }
}

#[cfg(test)]
mod tests;
