//! A small model with effects of one's own: what answers and what is asked again, in closed form.

use super::super::effect::Effect;
use super::super::linear_flight::turned;
use super::super::spec::{Parameter, Spec};
use super::*;
use crate::rom::tests::small;
use crate::rom::{Change, Constants};
use crate::smoothing::Smooth;
use std::sync::Arc;

/// Acts as its name says, all with its one value.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Act {
    Mass,
    Constants,
    /// Lift of the second zone.
    Lift,
    /// Force on the second mode.
    Modal,
    /// Lift of the first zone by that which it has.
    LiftByLift,
    DoubledCommand,
    AddedAngle,
    FasterServo,
    AddedLoad,
    MultipliedReading,
}

impl Effect for Act {
    fn spec(&self) -> &'static Spec {
        &Spec::NONE
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("p", -9.0..=9.0, 1.0)]
    }

    fn inputs(&self, p: &[f64], _place: &Place<'_>, inputs: &mut Inputs) {
        if *self == Self::DoubledCommand {
            inputs.deflections().for_each(|delta| *delta *= p[0]);
        }
    }

    fn servos(&self, p: &[f64], servos: &mut crate::rig::Actuator) {
        if *self == Self::FasterServo {
            servos.frequency_hz *= p[0];
        }
    }

    fn surfaces(&self, p: &[f64], _place: &Place<'_>, angles: &mut Inputs) {
        if *self == Self::AddedAngle {
            angles.deflections().for_each(|delta| *delta += p[0]);
        }
    }

    fn change(&self, p: &[f64], _place: &Place<'_>, change: &mut Change) {
        if *self == Self::Mass {
            change.mass += p[0];
        }
    }

    fn constants(&self, p: &[f64], _place: &Place<'_>, constants: &mut Constants) {
        if *self == Self::Constants {
            constants.upwash_rad_m += p[0];
        }
    }

    fn needs(&self) -> Needs {
        if matches!(self, Self::Lift | Self::Modal | Self::LiftByLift) { Needs::LIFT } else { Needs::NONE }
    }

    fn forces(&self, p: &[f64], _place: &Place<'_>, state: &WingState<'_>, forces: &mut Forces) {
        match self {
            Self::Lift => forces.lift_n[1].iter_mut().for_each(|lift| *lift += p[0]),
            Self::Modal => forces.modal[1].iter_mut().for_each(|force| *force += p[0]),
            Self::LiftByLift => {
                let own = state.lift_n[0].iter();
                forces.lift_n[0].iter_mut().zip(own).for_each(|(lift, own)| *lift += p[0] * own);
            }
            _ => (),
        }
    }

    fn loads(&self, p: &[f64], _place: &Place<'_>, _state: &WingState<'_>, loads: &mut Loads) {
        for value in loads.balance.iter_mut().flatten() {
            match self {
                Self::AddedLoad => *value += p[0],
                Self::MultipliedReading => *value *= p[0],
                _ => (),
            }
        }
    }

    fn stage(&self) -> Stage {
        if *self == Self::MultipliedReading { Stage::Reading } else { Stage::Load }
    }
}

fn acting(acts: &[(Act, f64)]) -> Vec<Active> {
    acts.iter().map(|(act, value)| Active::new(Arc::new(*act), &[*value])).collect()
}

fn stimulus(alpha: &[f64], steady: bool) -> Stimulus {
    let still = vec![0.0; alpha.len()];
    let rising = |by: f64| (0..alpha.len()).map(|i| by * i as f64).collect::<Vec<f64>>();
    let smooth = Smooth { value: alpha.to_vec(), rate: still.clone(), second: still };
    let inputs =
        Inputs { alpha: smooth, incidence_rad: rising(0.01), controls_rad: vec![rising(0.2), rising(-0.1)] };
    Stimulus { inputs, time_step_s: 0.02, steady, clock_h: 0.0 }
}

#[test]
fn a_linear_part_serves_effects_that_ask_nothing_else_of_it() {
    let rom = small(25.0);
    let model = |acts: &[(Act, f64)]| Model::new(&rom, &acting(acts), None);
    let plain = model(&[]);
    let (mass, constants, zones) = ([(Act::Mass, 0.1)], [(Act::Constants, 0.1)], [(Act::Lift, 0.1)]);
    let serves = |model: &Model, acts: &[(Act, f64)]| model.serves(&rom, &acting(acts));
    assert!(serves(&plain, &[]) && serves(&plain, &[(Act::AddedLoad, 1.0), (Act::Mass, 0.0)]));
    assert!(!serves(&plain, &mass) && !serves(&plain, &constants) && !serves(&plain, &zones));
    assert!(serves(&model(&mass), &mass) && !serves(&model(&mass), &[(Act::Mass, 0.2)]));
    assert!(!serves(&model(&mass), &[]) && !serves(&model(&mass), &constants));
    assert!(serves(&model(&constants), &constants) && !serves(&model(&constants), &[]));
    assert!(serves(&model(&zones), &zones) && serves(&model(&zones), &[]), "zones are there beside the rest");
    // what does not serve is not taken
    let next = Model::new(&rom, &acting(&mass), Some(&plain));
    assert_eq!(next.table.rest, model(&mass).table.rest);
    assert_ne!(next.table.responses[0], plain.table.responses[0]);
}

#[test]
fn static_points_are_linear_in_what_drives_them() {
    let rom = small(25.0);
    let stimulus = stimulus(&[0.3, -0.2, 0.0], true);
    for (acts, lift_n, modal) in [(vec![], 0.0, 0.0), (vec![(Act::Lift, 2.0), (Act::Modal, 3.0)], 2.0, 3.0)] {
        let effects = acting(&acts);
        let model = Model::new(&rom, &effects, None);
        let flown = fly(&rom, &model, &effects, &stimulus);
        let response = &model.table.responses[0];
        for (i, alpha) in stimulus.inputs.alpha.value.iter().enumerate() {
            let samples = i as f64;
            // pitch, stream, gravity aft and down, both controls, then the lift of three zones and two modes
            let mut drives = vec![alpha.to_owned(), 0.01 * samples, 9.81 * alpha.sin(), 9.81 * alpha.cos()];
            drives.extend([0.2 * samples, -0.1 * samples, 0.0, lift_n, 0.0, 0.0, modal]);
            for (row, shown) in flown.loads.iter().chain([&flown.tip_m]).enumerate() {
                let by = (0..response.ncols()).map(|k| response[(row, k)].re * drives[k]);
                let wanted = model.table.rest[row] + by.sum::<f64>();
                assert!(
                    (shown[i] - wanted).abs() < 1e-9 * wanted.abs().max(1.0),
                    "{row} {i}: {} {wanted}",
                    shown[i]
                );
            }
        }
    }
}

/// Lift of a zone less a share of what it would have without that: the share of what the linear wing has.
#[test]
fn forces_by_the_state_see_it_without_themselves() {
    let rom = small(25.0);
    let stimulus = stimulus(&[0.3, -0.2], true);
    let (share, effects) = (0.25, acting(&[(Act::LiftByLift, 0.25)]));
    let model = Model::new(&rom, &effects, None);
    let flown = fly(&rom, &model, &effects, &stimulus);
    let response = &model.table.responses[0];
    let (lift, drive) = (rom.outputs().lifts(), rom.drive().lifts());
    let none = Model::new(&rom, &[], None);
    let clean = fly(&rom, &none, &[], &stimulus);
    for (i, alpha) in stimulus.inputs.alpha.value.iter().enumerate() {
        let samples = i as f64;
        let drives =
            [*alpha, 0.01 * samples, 9.81 * alpha.sin(), 9.81 * alpha.cos(), 0.2 * samples, -0.1 * samples];
        let plain = model.table.rest[lift] + (0..6).map(|k| response[(lift, k)].re * drives[k]).sum::<f64>();
        // the wing answers the force with lift of its own: L = plain + r F, F = share (L - F)
        let r = response[(lift, drive)].re;
        let (mut force, mut own) = (0.0, plain);
        for _ in 0..ROUNDS {
            force = share * (own - force);
            own = plain + r * force;
        }
        for row in 0..3 {
            let wanted = clean.loads[row][i] + response[(row, drive)].re * force;
            assert!((flown.loads[row][i] - wanted).abs() < 1e-2 * force.abs(), "{row} {i}");
        }
        assert!(force.abs() > 1e-3);
    }
}

#[test]
fn forces_settle_when_none_changes_by_a_ten_thousandth_of_the_largest() {
    let forces = |lift: f64, modal: f64| Forces { lift_n: vec![vec![lift]], modal: vec![vec![modal]] };
    assert!(settled(&forces(10.0009, -4.0), &forces(10.0, -4.0)));
    assert!(!settled(&forces(10.0011, -4.0), &forces(10.0, -4.0)));
    assert!(settled(&forces(2.0, -9.9991), &forces(2.0, -10.0)));
    assert!(!settled(&forces(2.0, -9.9989), &forces(2.0, -10.0)));
    assert!(settled(&forces(0.0, 0.0), &forces(0.0, 0.0)) && !settled(&forces(1.0, 0.0), &forces(0.0, 0.0)));
}

#[test]
fn the_lift_that_effects_see_is_without_the_forces_of_the_round_before() {
    let rom = small(25.0);
    let effects = acting(&[(Act::LiftByLift, 1.0)]);
    let place = place(&rom, &effects, 0.01, true, 0.0);
    let inputs = stimulus(&[0.0, 0.0], true).inputs;
    let (still, lift_n) = (vec![0.0; 2], vec![vec![10.0, 20.0], vec![1.0; 2], vec![1.0; 2]]);
    let loads = [still.clone(), still.clone(), still.clone()];
    let state = WingState {
        inputs: &inputs,
        loads: &loads,
        tip_m: &still,
        lift_n: &lift_n,
        height_m: &[],
        outer_height_m: &[],
        twist_rad: &[],
    };
    let mut before = Forces::none(3, 2);
    before.lift_n[0] = vec![4.0, 5.0];
    let after = forces_at(&place, &effects, state, &before);
    assert_eq!((after.lift_n[0].clone(), after.lift_n[1].clone()), (vec![6.0, 15.0], vec![0.0; 2]));
}

#[test]
fn commands_pass_the_changed_servo_between_inputs_and_surfaces_but_not_at_static_points() {
    let rom = small(25.0);
    let effects = acting(&[(Act::AddedAngle, 0.5), (Act::FasterServo, 2.0), (Act::DoubledCommand, 3.0)]);
    let command: Vec<f64> = (0..30).map(|i| 0.01 * f64::from(i)).collect();
    let mut inputs = stimulus(&[0.0; 30], false).inputs;
    inputs.controls_rad = vec![command.clone(), vec![0.0; 30]];
    let tripled: Vec<f64> = command.iter().map(|delta| 3.0 * delta).collect();
    for steady in [true, false] {
        let place = place(&rom, &effects, 0.02, steady, 1.5);
        assert_eq!((place.actuator.frequency_hz, place.time_step_s, place.clock_h), (14.0, 0.02, 1.5));
        let turned = turned(&place, &effects, inputs.clone(), None).0;
        let servo = crate::rig::Actuator { frequency_hz: 14.0, damping_ratio: 0.7 };
        let followed = if steady { tripled.clone() } else { servo.follow(&tripled, 0.02) };
        for (found, wanted) in turned.controls_rad[0].iter().zip(&followed) {
            assert!((found - wanted - 0.5).abs() < 1e-12, "{steady}: {found} {wanted}");
        }
        assert!(turned.controls_rad[1].iter().all(|delta| (delta - 0.5).abs() < 1e-12));
    }
}

#[test]
fn loads_change_on_their_way_in_the_order_of_its_stages() {
    let rom = small(25.0);
    let stimulus = stimulus(&[0.1, 0.2], true);
    let clean = fly(&rom, &Model::new(&rom, &[], None), &[], &stimulus);
    for acts in [
        [(Act::AddedLoad, 5.0), (Act::MultipliedReading, 3.0)],
        [(Act::MultipliedReading, 3.0), (Act::AddedLoad, 5.0)],
    ] {
        let effects = acting(&acts);
        let flown = fly(&rom, &Model::new(&rom, &effects, None), &effects, &stimulus);
        for (shown, clean) in flown.loads.iter().flatten().zip(clean.loads.iter().flatten()) {
            assert!((shown - 3.0 * (clean + 5.0)).abs() < 1e-9);
        }
        assert_eq!(flown.tip_m, clean.tip_m);
    }
}

#[test]
fn a_run_in_which_nothing_drives_the_wing_rests() {
    let rom = ReducedOrderModel { gravity_m_s2: 0.0, ..small(25.0) };
    let mut still = stimulus(&[0.0; 3], false);
    still.inputs.incidence_rad = vec![0.0; 3];
    still.inputs.controls_rad = vec![vec![0.0; 3]; 2];
    let model = Model::new(&rom, &[], None);
    let flown = fly(&rom, &model, &[], &still);
    for (row, shown) in flown.loads.iter().enumerate() {
        assert_eq!(*shown, vec![model.table.rest[row]; 3]);
    }
    // what moves does not rest
    let moving = fly(&rom, &model, &[], &stimulus(&[0.0, 0.3, 0.1], false));
    assert!(moving.loads[0].iter().any(|load| (load - model.table.rest[0]).abs() > 1e-6));
}

#[test]
fn a_flight_beside_another_is_the_flight_alone() {
    let rom = small(25.0);
    let all = [
        Act::Mass,
        Act::Constants,
        Act::Lift,
        Act::Modal,
        Act::LiftByLift,
        Act::DoubledCommand,
        Act::AddedAngle,
        Act::FasterServo,
        Act::AddedLoad,
    ];
    let bumps: Vec<f64> = (0..90).map(|i| 0.2 * (0.3 * f64::from(i)).sin()).collect();
    for (steady, own) in all.iter().flat_map(|own| [(true, *own), (false, *own)]) {
        let stimulus = stimulus(&bumps, steady);
        let mut first = acting(&[(own, 1.2)]);
        let whole = Model::whole(&rom, &first);
        let (_, before) = fly_first(&rom, &whole, &first, &stimulus);
        for next in all {
            first.truncate(1);
            first.extend(acting(&[(next, 1.3)]));
            let model = Model::new(&rom, &first, Some(&whole));
            let alone = fly(&rom, &model, &first, &stimulus);
            let beside = fly_beside(&rom, &model, &first, &stimulus, &before);
            for (alone, beside) in alone.loads.iter().zip(&beside.loads) {
                let largest = alone.iter().fold(0.0, |largest: f64, load| largest.max(load.abs()));
                let off = alone.iter().zip(beside).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(largest > 1e-3 && off < 1e-11 * largest, "{own:?} {next:?}: {off} of {largest}");
            }
        }
    }
}
