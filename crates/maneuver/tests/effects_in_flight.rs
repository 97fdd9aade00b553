//! What of a wing's effects travels: those of the air become corrections that do what the effect does in the tunnel, those
//! of control surfaces another deflection.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::flown::{effect, with};
use crate::common::{uneven, wing_with};
use aero::{Corrections, Flow};
use maneuver::effects::{Active, Inputs, Stimulus, acting_deflection, carry, library};
use maneuver::rom::ReducedOrderModel;
use maneuver::{Rig, RigSettings, Smooth};

const FLOW: Flow = Flow { v_m_s: 25.0, rho_kg_m3: 1.225 };

/// Angles without deflections.
fn angles(controls: usize) -> Stimulus {
    let still = vec![0.0; 3];
    let alpha = Smooth { value: vec![-0.05, 0.0, 0.1], rate: still.clone(), second: still.clone() };
    let inputs = Inputs { alpha, incidence_rad: still.clone(), controls_rad: vec![still; controls] };
    Stimulus { inputs, time_step_s: 0.01, steady: true, clock_h: 0.0 }
}

#[test]
fn effects_of_the_air_act_in_flight_as_they_do_in_the_tunnel() {
    let (file, wing) = wing_with(|_| ());
    let settings = RigSettings { modes: 40, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
    let rig = Rig::new(&wing, settings).unwrap();
    let plain_air = Corrections { pressure_offset: vec![0.0; wing.correctable.len()], ..uneven(&wing) };
    let rom = ReducedOrderModel::new(&rig, FLOW, &plain_air, None).unwrap();
    let stimulus = angles(rom.controls.len());
    let clean = with(&rom, &[], &stimulus).loads;
    // the last number: eight zones are no strips, and truncated modes keep the air they had
    let cases: [(&str, &[f64], f64); 5] = [
        ("lift_slope", &[-0.1], 0.01),
        ("tip_loss", &[0.3], 0.03),
        ("ac_shift", &[0.02], 0.01),
        ("camber", &[0.5, 0.02], 0.02),
        ("re_dependence", &[0.2, 1.0], 0.02),
    ];
    for (name, values, tolerance) in cases {
        let active = [Active::new(effect(&rom, name), values)];
        let tunnel = with(&rom, &active, &stimulus).loads;
        let mut corrections = plain_air.clone();
        let carried = carry(&active, &wing, FLOW.v_m_s, &mut corrections);
        assert_eq!((carried.carried, carried.tunnel.len() + carried.left.len()), (vec![name], 0));
        let flying = ReducedOrderModel::new(&rig, FLOW, &corrections, None).unwrap();
        let flight = with(&flying, &[], &stimulus).loads;
        for c in 0..3 {
            let added = |loads: &[Vec<f64>; 3], i: usize| loads[c][i] - clean[c][i];
            let largest = (0..3).map(|i| added(&tunnel, i).abs()).fold(0.0, f64::max);
            for i in 0..3 {
                let (a, b) = (added(&tunnel, i), added(&flight, i));
                assert!((a - b).abs() < tolerance * largest, "{name} channel {c} point {i}: {a} {b}");
            }
        }
    }
}

#[test]
fn a_saturated_aileron_turns_less_in_flight_too() {
    let controls = ["inner", "outer"].map(str::to_owned);
    let saturation = library(&controls).into_iter().find(|e| e.spec().name == "ctl_saturation").unwrap();
    let active = [Active::new(saturation, &[0.0, 2.0, 0.0])];
    let at = |control: &str, delta: f64| acting_deflection(&active, &controls, control, 30.0, delta);
    assert!((at("outer", 0.4) - (0.8_f64).tanh() / 2.0).abs() < 1e-12);
    assert!((at("outer", -0.4) + at("outer", 0.4)).abs() < 1e-15);
    assert!(at("inner", 0.4).to_bits() == 0.4_f64.to_bits());
}
