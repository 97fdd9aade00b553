//! Effects that lag, remember, drift or grow with airspeed, against laws and closed forms.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::wing_with;
use aero::{Corrections, Flow};
use faer::c64;
use maneuver::effects::{
    Active, Effect, Forces, Inputs, Loads, Place, WingState, acting_deflection, library,
};
use maneuver::rom::{Change, Drive, ReducedOrderModel, Zones};
use maneuver::{Actuator, AirModel, Rig, RigSettings, Smooth};
use std::f64::consts::TAU;
use std::sync::Arc;

const FLOW: Flow = Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };

fn controls() -> Vec<String> {
    ["inner", "outer"].map(str::to_owned).to_vec()
}

/// Every form of an effect.
fn forms(name: &str) -> Vec<Arc<dyn Effect>> {
    library(&controls()).into_iter().filter(|effect| effect.spec().name == name).collect()
}

fn place(zones: &Zones, time_step_s: f64, steady: bool, clock_h: f64) -> Place<'_> {
    Place {
        flow: FLOW,
        zones,
        controls: &[],
        time_step_s,
        steady,
        clock_h,
        actuator: Actuator { frequency_hz: 15.0, damping_ratio: 0.8 },
        gravity_m_s2: 9.81,
        balance_y_m: 0.0,
        outer_shape: 0.0,
        first_stiffness: 0.0,
    }
}

/// Inputs at rest but for control surfaces.
fn inputs(samples: usize, controls_rad: Vec<Vec<f64>>) -> Inputs {
    let still = vec![0.0; samples];
    let alpha = Smooth { value: still.clone(), rate: still.clone(), second: still.clone() };
    Inputs { alpha, incidence_rad: still, controls_rad }
}

#[test]
fn a_lagging_servo_of_any_form_follows_a_ramp_its_time_constant_later() {
    // u = t through 1/(1 + tau s), or 1/(1 + tau s + tau² s²/2): t - tau when the beginning is forgotten
    let (time_step_s, tau_s, zones) = (0.002, 0.05, Zones::default());
    let ramp: Vec<f64> = (0..800).map(|i| f64::from(i) * time_step_s).collect();
    let forms = forms("act_lag");
    assert_eq!(forms.len(), 3);
    for effect in forms.into_iter().filter(|effect| effect.parameters().len() == 1) {
        let mut driven = inputs(800, vec![ramp.clone(), vec![0.0; 800]]);
        effect.inputs(&[tau_s], &place(&zones, time_step_s, false, 0.0), &mut driven);
        let behind_s = ramp[799] - driven.controls_rad[0][799];
        assert!((behind_s / tau_s - 1.0).abs() < 1e-3, "{}: {behind_s} s for {tau_s} s", effect.form());
        assert!(driven.controls_rad[1].iter().all(|delta| *delta == 0.0));
    }
}

/// A low pass of two poles of Butterworth with the corner `1/p` is late by `sqrt 2 p/(2 pi)`, and all forms alike, however fast
/// they are beside the sample rate.
#[test]
fn a_filter_of_any_form_follows_a_ramp_the_same_delay_later() {
    let zones = Zones::default();
    let forms = forms("daq_filter");
    assert_eq!(
        forms.iter().map(|effect| effect.form()).collect::<Vec<_>>(),
        ["two poles", "four poles", "Bessel"]
    );
    for (p, time_step_s) in [(0.01, 0.01), (0.03, 0.01), (0.1, 0.01), (0.3, 0.01), (0.1, 0.002)] {
        let ramp: Vec<f64> = (0..3000).map(|i| f64::from(i) * time_step_s).collect();
        for effect in &forms {
            let driven = inputs(3000, Vec::new());
            let channels = [ramp.clone(), ramp.clone(), ramp.clone()];
            let state = WingState {
                inputs: &driven,
                loads: &channels,
                tip_m: &[],
                lift_n: &[],
                height_m: &[],
                outer_height_m: &[],
                twist_rad: &[],
            };
            let mut loads = Loads { balance: channels.clone(), tip_m: Vec::new() };
            effect.loads(&[p], &place(&zones, time_step_s, false, 0.0), &state, &mut loads);
            let (behind_s, delay_s) = (ramp[2999] - loads.balance[1][2999], 2.0_f64.sqrt() * p / TAU);
            assert!(
                (behind_s / delay_s - 1.0).abs() < 1e-5,
                "{} {p}: {behind_s} for {delay_s}",
                effect.form()
            );
        }
    }
}

/// A servo of second order follows a ramp `2 zeta / w` later; one without a period follows at once.
#[test]
fn another_servo_follows_a_ramp_as_late_as_its_period_and_damping_say() {
    let time_step_s = 0.002;
    let ramp: Vec<f64> = (0..800).map(|i| f64::from(i) * time_step_s).collect();
    let form = forms("act_lag").into_iter().find(|effect| effect.form() == "servo").unwrap();
    for (shares, late_s) in [
        ([0.0, 0.0], 1.6 / (TAU * 15.0)),
        ([15.0 / 16.6 - 1.0, 0.875 / 0.8 - 1.0], 1.75 / (TAU * 16.6)),
        ([-1.0, 0.0], 0.0),
    ] {
        let mut servo = Actuator { frequency_hz: 15.0, damping_ratio: 0.8 };
        form.servos(&shares, &mut servo);
        let behind_s = ramp[400] - servo.follow(&ramp, time_step_s)[400];
        assert!((behind_s - late_s).abs() < 1e-5, "{shares:?}: {behind_s} s, expected {late_s} s");
    }
}

/// Behind the servo a surface holds what a stop leaves it, and comes off the stop as the servo does; a bent command is a smaller
/// command, whose shape the servo keeps. Differential equation `d'' = w² (u - d) - 2 zeta w d'` of a unit step in closed form.
#[test]
fn a_stop_behind_the_servo_cuts_what_the_servo_turned() {
    let time_step_s = 0.002;
    let (servo, zones) = (Actuator { frequency_hz: 15.0, damping_ratio: 0.8 }, Zones::default());
    let (w, zeta, step, start) = (TAU * servo.frequency_hz, servo.damping_ratio, 0.4, 100);
    let wd = w * (1.0 - zeta * zeta).sqrt();
    let turned = |t: f64| {
        let swing = (wd * t).cos() + zeta * w / wd * (wd * t).sin();
        if t > 0.0 { step * (1.0 - (-zeta * w * t).exp() * swing) } else { 0.0 }
    };
    let command: Vec<f64> = (0..400).map(|i| if i < start { 0.0 } else { step }).collect();
    let inverse = 3.0;
    for form in forms("ctl_saturation").into_iter().filter(|effect| effect.form().starts_with("tanh")) {
        let behind = form.form() == "tanh behind the servo";
        let mut driven = inputs(400, vec![command.clone(), vec![0.0; 400]]);
        let here = place(&zones, time_step_s, false, 0.0);
        let p = [inverse, 0.0, 0.0];
        form.inputs(&p, &here, &mut driven);
        driven.controls_rad.iter_mut().for_each(|control| *control = servo.follow(control, time_step_s));
        form.surfaces(&p, &here, &mut driven);
        // a sampled step is one half a step earlier, between two samples
        for i in [110, 115, 125, 160, 300] {
            let t = (f64::from(i) - f64::from(start) + 0.5) * time_step_s;
            let expected = if behind {
                (inverse * turned(t)).tanh() / inverse
            } else {
                (inverse * step).tanh() / inverse * turned(t) / step
            };
            let got = driven.controls_rad[0][usize::try_from(i).unwrap()];
            assert!((got - expected).abs() < 2e-3 * step, "{}: {i} {got} {expected}", form.form());
        }
    }
}

#[test]
fn hysteresis_remembers_whether_the_flow_was_separated() {
    let (share, area_m2) = (0.3, 0.05);
    let zones = Zones { area_m2: vec![area_m2], y_norm: vec![0.5], ..Zones::default() };
    // lost beyond 4 degrees, until 2.5 degrees
    let sweep = [
        (0.0, false),
        (3.0, false),
        (3.9, false),
        (4.1, true),
        (6.0, true),
        (3.9, true),
        (2.6, true),
        (2.4, false),
        (3.9, false),
        (-3.9, false),
        (-5.0, true),
        (-2.6, true),
        (-1.0, false),
    ];
    let by_angle = TAU * FLOW.dynamic_pressure_pa() * area_m2;
    let lift_n = vec![sweep.iter().map(|(deg, _)| by_angle * f64::to_radians(*deg)).collect::<Vec<f64>>()];
    let still = vec![0.0; sweep.len()];
    let driven = inputs(sweep.len(), Vec::new());
    let state = WingState {
        inputs: &driven,
        loads: &[still.clone(), still.clone(), still.clone()],
        tip_m: &still,
        lift_n: &lift_n,
        height_m: &[],
        outer_height_m: &[],
        twist_rad: &[],
    };
    let effect = forms("static_hysteresis").remove(0);
    for steady in [false, true] {
        let mut forces = Forces::none(1, sweep.len());
        effect.forces(&[share], &place(&zones, 0.01, steady, 0.0), &state, &mut forces);
        for (i, (deg, remembered)) in sweep.into_iter().enumerate() {
            // static points have no before
            let separated = if steady { deg.abs() > 4.0 } else { remembered };
            let beyond = f64::to_radians(deg.abs() - 2.5) * deg.signum();
            let expected = if separated { -share * by_angle * beyond } else { 0.0 };
            let lost = forces.lift_n[0][i];
            assert!(
                (lost - expected).abs() < 1e-12 * by_angle,
                "sample {i}, {deg} deg: {lost} N for {expected} N"
            );
        }
    }
}

#[test]
fn zeros_drift_by_their_rate_times_the_clock() {
    let (rates, clock_h, zones) = ([1.2, -0.8, 0.4], 2.5, Zones::default());
    let effect = forms("drift").remove(0);
    let reading = [vec![10.0; 3], vec![-5.0; 3], vec![2.0; 3]];
    let still = vec![0.0; 3];
    let driven = inputs(3, Vec::new());
    let state = WingState {
        inputs: &driven,
        loads: &reading,
        tip_m: &still,
        lift_n: &[],
        height_m: &[],
        outer_height_m: &[],
        twist_rad: &[],
    };
    let mut loads = Loads { balance: reading.clone(), tip_m: still.clone() };
    // half an hour between samples
    effect.loads(&rates, &place(&zones, 1800.0, false, clock_h), &state, &mut loads);
    for (channel, rate) in rates.into_iter().enumerate() {
        for (i, hours) in [2.5, 3.0, 3.5].into_iter().enumerate() {
            let expected = reading[channel][i] + rate * hours;
            assert!(
                (loads.balance[channel][i] - expected).abs() < 1e-12,
                "channel {channel} after {hours} h"
            );
        }
    }
}

#[test]
fn control_surfaces_saturate_more_by_the_power_of_airspeed() {
    let (controls, delta) = (controls(), 0.25);
    let at = |effect: &Arc<dyn Effect>, values: &[f64], v_m_s: f64| {
        acting_deflection(&[Active::new(effect.clone(), values)], &controls, "outer", v_m_s, delta)
    };
    let forms = forms("ctl_saturation");
    let by_form = |name: &str| forms.iter().find(|effect| effect.form() == name).unwrap();
    for (v_m_s, power) in [(15.0, 2.0), (30.0, 2.0), (45.0, 1.0), (15.0, -1.0), (45.0, 0.0)] {
        let grown = f64::powf(v_m_s / 30.0, power);
        // delta_eff = s tanh(delta/s), 1/s = 2 per rad at 30 m/s
        let s = 1.0 / (2.0 * grown);
        let bent = at(by_form("tanh"), &[0.0, 2.0, power], v_m_s);
        assert!((bent - s * (delta / s).tanh()).abs() < 1e-14, "{v_m_s} m/s, power {power}: {bent}");
        // K = 1 + dK, dK at 14.3 degrees straight between that at 5 and that at 15 degrees
        let share = (f64::to_degrees(delta) - 5.0) / 10.0;
        let dk = grown * (0.1 + share * (-0.2 - 0.1));
        let table = at(by_form("table"), &[0.0, 0.0, 0.0, 0.1, -0.2, -0.4, power], v_m_s);
        assert!((table - delta * (1.0 + dk)).abs() < 1e-14, "{v_m_s} m/s, power {power}: {table}");
    }
}

/// R = steady + rate + wake; only the wake's memory of an incidence changes, to that of an oscillation (1 + dlag) times as fast. Two incidences
/// are tried. Pitch about two axes differs by heave, whose rate h' is an incidence of -h'/V everywhere, like that of pitch at rest; what
/// the rate of pitch does beside that is the other one.
#[test]
fn a_wake_that_remembers_longer_answers_an_incidence_as_the_wake_does_to_a_faster_one() {
    let (file, wing) = wing_with(|planform| planform.structure = None);
    let effect = forms("aero_lag").remove(0);
    let axes_m = [0.05, 0.15];
    let roms = axes_m.map(|axis_x_m| {
        let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, axis_x_m)).unwrap();
        ReducedOrderModel::new(&rig, FLOW, &Corrections::neutral(wing.correctable.len()), None).unwrap()
    });
    let added = |dlag: f64, omega: f64| {
        let [first, second] = roms.each_ref().map(|rom| {
            let [later, plain] = [dlag, 0.0].map(|dlag| {
                let mut change = Change::none(rom.zones.len());
                effect.change(&[dlag], &place(&rom.zones, 0.01, false, 0.0), &mut change);
                rom.responses(&change, &[omega], false)[0][(0, Drive::PITCH)]
            });
            later - plain
        });
        let p = c64::new(0.0, omega / FLOW.v_m_s);
        let everywhere = (first - second) / (p * (axes_m[1] - axes_m[0]));
        [everywhere, (first - everywhere) / p]
    };
    for omega in [1.0, 5.0, 20.0] {
        for (one, other) in [(0.5, 1.0), (1.0, -0.25), (-0.5, 0.4)] {
            let both = (1.0 + one) * (1.0 + other) - 1.0;
            let (first, then) = (added(one, omega), added(other, (1.0 + one) * omega));
            for (incidence, found) in added(both, omega).into_iter().enumerate() {
                let (law, size) = (first[incidence] + then[incidence], first[incidence].norm());
                let at = format!("incidence {incidence}, {omega} rad/s, {one} and {other}");
                assert!((found - law).norm() < 1e-7 * size, "{at}: {found} for {law}");
            }
        }
    }
}

#[test]
fn a_gain_multiplies_all_that_is_unsteady_with_the_lags_of_the_wake_as_changed() {
    let (file, wing) = wing_with(|planform| planform.structure = None);
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let rom = ReducedOrderModel::new(&rig, FLOW, &neutral, None).unwrap();
    let effect = forms("aero_lag").remove(0);
    let lift = |dlag: f64, omega: f64| {
        let mut change = Change::none(rom.zones.len());
        effect.change(&[dlag], &place(&rom.zones, 0.01, false, 0.0), &mut change);
        rom.responses(&change, &[omega], false)[0][(0, Drive::INCIDENCE)]
    };
    let added = |dlag: f64, omega: f64| lift(dlag, omega) - lift(0.0, omega);
    // all that is unsteady is what air without memory lacks
    let with_gain = &forms("aero_lag")[1];
    let changed = |p: [f64; 2], omega: f64| {
        let mut change = Change::none(rom.zones.len());
        with_gain.change(&p, &place(&rom.zones, 0.01, false, 0.0), &mut change);
        rom.responses(&change, &[omega], false)[0][(0, Drive::INCIDENCE)] - lift(0.0, omega)
    };
    let settings = RigSettings {
        air: AirModel::QuasiSteady,
        ..RigSettings::new(file.damping_ratio, file.pitch_axis_x())
    };
    let without_memory =
        ReducedOrderModel::new(&Rig::new(&wing, settings).unwrap(), FLOW, &neutral, None).unwrap();
    for omega in [1.0, 5.0, 20.0] {
        let unsteady = changed([0.0, 1.0], omega);
        for (dlag, dgain) in [(0.0, -0.5), (0.5, 0.0), (1.0, 0.3), (-0.4, -0.2)] {
            let law = added(dlag, omega) + (unsteady + added(dlag, omega)) * dgain;
            let found = changed([dlag, dgain], omega);
            assert!((found - law).norm() < 1e-9 * unsteady.norm(), "{omega} rad/s: {found} for {law}");
        }
        let instant = without_memory.responses(&Change::none(rom.zones.len()), &[omega], false)[0]
            [(0, Drive::INCIDENCE)];
        let lacking = lift(0.0, omega) - instant;
        assert!(
            (unsteady - lacking).norm() < 1e-9 * lacking.norm(),
            "{omega} rad/s: {unsteady} for {lacking}"
        );
    }
    // at rest there is no memory
    assert!(changed([1.0, 1.0], 1e-9).norm() < 1e-9 * lift(0.0, 0.0).norm());
    // Wagner: lift comes late, and later behind a longer wake
    let (slow, later) = (lift(0.0, 1.0), added(1.0, 1.0));
    assert!(slow.re > 0.0 && later.im < 0.0 && later.im.abs() > 1e-3 * slow.re, "{slow} {later}");
}
