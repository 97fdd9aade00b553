//! A declared effect does what its declaration says, and what it leaves out does nothing.

use super::*;
use crate::rom::Zones;
use crate::small::goland;
use crate::smoothing::Smooth;
use aero::{Corrections, Flow};

/// Each function acts with its parameter times the clock, somewhere of its own.
const EVERYTHING: Declaration = Declaration {
    spec: Spec {
        name: "everything",
        title: "",
        side: super::super::Side::Control,
        rivals: &[],
        experiment: "",
    },
    form: "all of it",
    parameters: |controls| {
        controls.iter().map(|name| Parameter::new(name.as_str(), -1.0..=8.0, 0.1)).collect()
    },
    known: |known, parameters| {
        if let Some(first) = parameters.first_mut() {
            first.know(super::super::Calibration::Mass, known.to.mass);
        }
    },
    starts: &[&[0.5, 0.25], &[2.0]],
    constrain: |p| p[0] = 7.0,
    is_itself: |p| p[0] > 1.0,
    inputs: |p, place, inputs| inputs.incidence_rad[0] += p[0] * place.clock_h,
    servos: |p, servos| servos.frequency_hz += p[0],
    surfaces: |p, place, inputs| inputs.alpha.value[0] += p[0] * place.clock_h,
    change: |p, place, change| change.mass += p[0] * place.clock_h,
    constants: |p, place, constants| constants.upwash_rad_m += p[0] * place.clock_h,
    needs: Needs::LIFT,
    forces: |p, place, state, forces| forces.modal[0][0] += p[0] * place.clock_h * state.tip_m[0],
    loads: |p, place, state, loads| loads.tip_m[0] += p[0] * place.clock_h * state.tip_m[0],
    stage: Stage::Record,
    splits_stiffness: true,
    holds_at_rest_only: true,
    excludes_deflection_correction: true,
    flight: Flight::Deflection,
    correct: |p, air| air.corrections.force[0] += p[0] * air.v_m_s,
};

const NOTHING: Declaration =
    Declaration { parameters: |_| vec![Parameter::new("p", -1.0..=1.0, 0.1)], ..Declaration::NONE };

/// What an effect changes with the parameter 3, the clock at 2 h and the tip at .5 m: of parameters, inputs, servos,
/// surfaces, the linear wing, constants, forces, loads, corrections at 10 m/s.
fn changes(effect: &dyn Effect) -> [f64; 9] {
    let zones = Zones::default();
    let mut actuator = Actuator { frequency_hz: 1.0, damping_ratio: 1.0 };
    let place = Place {
        flow: Flow { v_m_s: 10.0, rho_kg_m3: 1.2 },
        zones: &zones,
        controls: &[],
        time_step_s: 0.01,
        steady: true,
        clock_h: 2.0,
        actuator,
        gravity_m_s2: 9.81,
        balance_y_m: 0.0,
        outer_shape: 0.0,
        first_stiffness: 0.0,
    };
    let still = || vec![0.0];
    let mut inputs = Inputs {
        alpha: Smooth { value: still(), rate: still(), second: still() },
        incidence_rad: still(),
        controls_rad: Vec::new(),
    };
    let p = [3.0, 0.0];
    let mut moved = [3.0];
    effect.constrain(&mut moved);
    effect.inputs(&p, &place, &mut inputs);
    effect.servos(&p, &mut actuator);
    effect.surfaces(&p, &place, &mut inputs);
    let (mut change, mut constants) = (Change::none(0), Constants::default());
    effect.change(&p, &place, &mut change);
    effect.constants(&p, &place, &mut constants);
    let (driven, tip_m) = (inputs.clone(), [0.5]);
    let loads = [still(), still(), still()];
    let state = WingState {
        inputs: &driven,
        loads: &loads,
        tip_m: &tip_m,
        lift_n: &[],
        height_m: &[],
        outer_height_m: &[],
        twist_rad: &[],
    };
    let (mut forces, mut shown) = (Forces::none(0, 1), Loads { balance: loads.clone(), tip_m: vec![0.0] });
    effect.forces(&p, &place, &state, &mut forces);
    effect.loads(&p, &place, &state, &mut shown);
    let wing = goland().elastic;
    let mut corrections = Corrections::neutral(wing.correctable.len());
    effect.correct(&p, &mut FlightAir { wing: &wing, v_m_s: 10.0, corrections: &mut corrections });
    [
        moved[0],
        inputs.incidence_rad[0],
        actuator.frequency_hz,
        inputs.alpha.value[0],
        change.mass,
        constants.upwash_rad_m,
        forces.modal[0][0],
        shown.tip_m[0],
        corrections.force[0],
    ]
}

/// What an effect says of itself with yes or no.
fn says(effect: &dyn Effect) -> [bool; 4] {
    [
        effect.needs() != Needs::NONE,
        effect.splits_stiffness(),
        effect.holds_at_rest_only(),
        effect.excludes_deflection_correction(),
    ]
}

#[test]
fn a_declared_effect_acts_and_speaks_as_it_is_declared() {
    let controls = ["in", "out"].map(str::to_owned);
    let known =
        Known { to: coupling::wing_file::KnownTo { mass: 0.02, ..Default::default() }, ..Known::default() };
    let effect = Declared::new(&EVERYTHING, &controls, &known).expect("of this wing");
    assert_eq!(changes(&effect), [7.0, 6.0, 4.0, 6.0, 6.0, 6.0, 3.0, 3.0, 31.0]);
    assert_eq!(
        (says(&effect), effect.stage(), effect.flight()),
        ([true; 4], Stage::Record, Flight::Deflection)
    );
    assert_eq!((effect.spec().name, effect.form()), ("everything", "all of it"));
    assert_eq!(effect.starts(), [vec![0.5, 0.25], vec![2.0]]);
    assert!(effect.is_itself(&[1.5]) && !effect.is_itself(&[0.5]));
    let parameters = effect.parameters();
    let names: Vec<&str> = parameters.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names, ["in", "out"]);
    assert_eq!(parameters[0].calibrated.map(|known| known.sigma), Some(0.02));
    assert_eq!(parameters[1].calibrated, None);
    assert!(Declared::new(&EVERYTHING, &[], &Known::default()).is_none(), "no controls, no parameters");
}

/// An effect that says its name alone.
#[derive(Debug)]
struct Bare;

impl Effect for Bare {
    fn spec(&self) -> &'static Spec {
        &Spec::NONE
    }

    fn parameters(&self) -> Vec<Parameter> {
        Vec::new()
    }
}

#[test]
fn what_is_not_said_does_nothing() {
    let declared = Declared::new(&NOTHING, &[], &Known::default()).expect("of any wing");
    for effect in [&declared as &dyn Effect, &Bare] {
        assert_eq!(changes(effect), [3.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        assert_eq!((says(effect), effect.stage(), effect.flight()), ([false; 4], Stage::Load, Flight::Left));
        assert_eq!((effect.form(), effect.spec().name, effect.starts().len()), ("", "", 0));
        assert!(effect.is_itself(&[3.0]) && effect.is_itself(&[0.0]));
    }
}
