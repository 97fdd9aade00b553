//! Effects against closed forms: what each adds to the loads is what its equation says, computed here by hand.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::flown::{effect, points, rom, run, swing, with};
use crate::common::wing_with;
use aero::{Corrections, Flow};
use maneuver::effects::{Active, Effect, Inputs, Loads, Place, Stimulus, WingState, library};
use maneuver::rom::{Change, Drive, Outputs, PointMass, ReducedOrderModel, Zones};
use maneuver::{Rig, RigSettings, Smooth};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Loads with one effect, and without any.
fn beside(rom: &ReducedOrderModel, name: &str, values: &[f64], stimulus: &Stimulus) -> [[Vec<f64>; 3]; 2] {
    let active = Active::new(effect(rom, name), values);
    [with(rom, &[active], stimulus).loads, with(rom, &[], stimulus).loads]
}

#[test]
fn a_body_on_the_balance_adds_its_inertia_and_its_weight() {
    let rom = rom(30.0);
    let stimulus = run(rom.controls.len());
    let (mx, iyy, mz, my) = (0.04, 0.1, 0.2, -0.3);
    let [ours, clean] = beside(&rom, "joiner_inertia", &[mx, iyy, mz, my], &stimulus);
    let (alpha, g) = (&stimulus.inputs.alpha, rom.gravity_m_s2());
    for i in 0..alpha.value.len() {
        let (a, second) = (alpha.value[i], alpha.second[i]);
        // force of inertia and weight of a point at (x, y, z) in axes that turn nose up by a, less the tare
        let fz = mx * second;
        let my_added = -iyy * second + mz * g * a.sin() + mx * g * (a.cos() - 1.0);
        let mx_added = my * g * (1.0 - a.cos());
        for (c, added) in [fz, mx_added, my_added].into_iter().enumerate() {
            assert!((ours[c][i] - clean[c][i] - added).abs() < 1e-9, "channel {c} sample {i}");
        }
    }
}

#[test]
fn channels_of_the_balance_do_what_their_formulas_say() {
    let rom = rom(30.0);
    for stimulus in [run(rom.controls.len()), points(rom.controls.len())] {
        let [ours, y] = beside(&rom, "gain", &[0.1, -0.2, 0.05], &stimulus);
        let [bent, _] = beside(&rom, "balance_nonlin", &[0.001, 0.0, -0.002], &stimulus);
        let [mixed, _] = beside(&rom, "crosstalk", &[0.0, 0.01, 0.02, 0.0, -0.03, 0.04], &stimulus);
        for i in 0..y[0].len() {
            let [fz, mx, my] = [0, 1, 2].map(|c| y[c][i]);
            let pairs = [
                (ours[0][i], 1.1 * fz),
                (ours[1][i], 0.8 * mx),
                (ours[2][i], 1.05 * my),
                (bent[0][i], fz + 0.001 * fz * fz),
                (bent[1][i], mx),
                (bent[2][i], my - 0.002 * my * my),
                (mixed[0][i], fz + 0.01 * my),
                (mixed[1][i], mx + 0.02 * fz),
                (mixed[2][i], my - 0.03 * fz + 0.04 * mx),
            ];
            for (a, b) in pairs {
                assert!((a - b).abs() < 1e-9, "sample {i}: {a} {b}");
            }
        }
    }
}

#[test]
fn friction_and_cables_pull_against_the_turning_and_the_angle() {
    let rom = rom(30.0);
    let stimulus = run(rom.controls.len());
    let alpha = &stimulus.inputs.alpha;
    let [rubbed, clean] = beside(&rom, "friction", &[-0.3], &stimulus);
    let [held, _] = beside(&rom, "cable_stiffness", &[4.0], &stimulus);
    for (i, my) in clean[2].iter().enumerate() {
        if alpha.rate[i].abs() > 0.1 {
            assert!((rubbed[2][i] - my + 0.3 * alpha.rate[i].signum()).abs() < 1e-12);
        }
        assert!((held[2][i] - my + 4.0 * alpha.value[i]).abs() < 1e-12);
    }
}

/// Loads with a form of an effect, and without any.
fn beside_form(
    rom: &ReducedOrderModel,
    [name, form]: [&str; 2],
    values: &[f64],
    stimulus: &Stimulus,
) -> [[Vec<f64>; 3]; 2] {
    let is = |effect: &Arc<dyn Effect>| effect.spec().name == name && effect.form() == form;
    let effect = library(&rom.controls).into_iter().find(is).unwrap();
    [with(rom, &[Active::new(effect, values)], stimulus).loads, with(rom, &[], stimulus).loads]
}

/// Both forms turn against the motion; the smooth one has tanh 1 of it at the rate at which it levels off, all of it far above.
#[test]
fn friction_that_levels_off_is_the_dry_one_far_above_its_rate_and_less_below() {
    let rom = rom(30.0);
    let mut stimulus = run(rom.controls.len());
    let at_rad_s = [0.02 + 0.1, 10.0, -10.0, 0.0];
    stimulus.inputs.alpha.rate[..4].copy_from_slice(&at_rad_s);
    let [rubbed, clean] = beside_form(&rom, ["friction", "smooth"], &[-0.3, 0.1], &stimulus);
    let expected = [-0.3 * 1f64.tanh(), -0.3, 0.3, 0.0];
    for (i, expected) in expected.into_iter().enumerate() {
        let added = rubbed[2][i] - clean[2][i];
        assert!((added - expected).abs() < 1e-9, "{} rad/s: {added} {expected}", at_rad_s[i]);
    }
}

/// `1 - exp(-t / .5 h)` of the parameter, t the clock: the run begins half an hour after the zeros.
#[test]
fn a_balance_that_warms_up_has_come_two_thirds_of_its_way_after_half_an_hour() {
    let rom = rom(30.0);
    let stimulus = run(rom.controls.len());
    let [ours, y] = beside_form(&rom, ["drift", "warming up"], &[1.0, 0.0, -0.5], &stimulus);
    let share = |i: usize| 1.0 - (-(stimulus.clock_h + i as f64 * stimulus.time_step_s / 3600.0) / 0.5).exp();
    assert!((stimulus.clock_h - 0.5).abs() < 1e-12 && (share(0) - 0.632).abs() < 1e-3);
    for i in [0, 57, y[0].len() - 1] {
        assert!(
            (ours[0][i] - y[0][i] - share(i)).abs() < 1e-9
                && (ours[2][i] - y[2][i] + 0.5 * share(i)).abs() < 1e-9
        );
        assert!((ours[1][i] - y[1][i]).abs() < 1e-12);
    }
}

/// A linear wing at rest: its loads by a deflection are those by a deflection that is half the gap smaller.
#[test]
fn a_surface_that_the_air_presses_back_lacks_half_its_gap() {
    let rom = rom(30.0);
    let still = crate::common::flown::rom(0.0);
    let at = |delta_deg: f64| {
        let mut stimulus = points(rom.controls.len());
        stimulus.inputs.controls_rad.iter_mut().for_each(|control| control.fill(delta_deg.to_radians()));
        stimulus
    };
    let pressed = |delta_deg: f64| {
        beside_form(&rom, ["backlash", "pressed by the air"], &[1.5], &at(delta_deg))[0][0].clone()
    };
    let plain = |delta_deg: f64| with(&rom, &[], &at(delta_deg)).loads[0].clone();
    for (commanded, acting) in [(5.0, 4.25), (-5.0, -4.25), (0.5, 0.0)] {
        for (ours, theirs) in pressed(commanded).iter().zip(plain(acting)) {
            assert!((ours - theirs).abs() < 1e-9, "{commanded} degrees: {ours} N, {theirs} N");
        }
    }
    let [loose, tight] = beside_form(&still, ["backlash", "pressed by the air"], &[1.5], &at(5.0));
    assert!(loose == tight, "no air presses a surface without wind");
}

#[test]
fn a_late_balance_shows_the_run_of_a_while_ago() {
    let rom = rom(30.0);
    let stimulus = run(rom.controls.len());
    let [late, clean] = beside(&rom, "delay", &[3.0 * stimulus.time_step_s], &stimulus);
    for (late, clean) in late.iter().zip(&clean) {
        for (late, clean) in late[3..].iter().zip(clean) {
            assert!((late - clean).abs() < 1e-9);
        }
    }
}

#[test]
fn an_error_of_dynamic_pressure_is_another_density_of_the_air() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(
        &wing,
        RigSettings { modes: 40, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) },
    )
    .unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let at = |rho_kg_m3: f64| {
        ReducedOrderModel::new(&rig, Flow { v_m_s: 30.0, rho_kg_m3 }, &neutral, None).unwrap()
    };
    let (thin, dense) = (at(1.225), at(1.225 * 1.05));
    let none = Change::none(thin.zones.len());
    let more = Change { pressure: 0.05, ..none.clone() };
    let omegas = [0.0, 3.0 * TAU, 8.0 * TAU];
    let (ours, theirs) = (thin.responses(&more, &omegas, true), dense.responses(&none, &omegas, true));
    for (ours, theirs) in ours.iter().zip(&theirs) {
        for row in 0..=Outputs::TIP {
            for column in [Drive::PITCH, Drive::INCIDENCE, Drive::CONTROLS] {
                // the static residual of the modes beyond the fortieth stays that of the thin air
                let (a, b) = (ours[(row, column)], theirs[(row, column)]);
                assert!((a - b).norm() < 2e-3 * b.norm().max(1e-3), "{row} by {column}: {a} {b}");
            }
        }
    }
}

#[test]
fn camber_is_an_inclined_stream_and_a_compliant_balance_closes_its_loop() {
    let rom = rom(30.0);
    let stimulus = points(rom.controls.len());
    let [cambered, _] = beside(&rom, "camber", &[0.4, 0.0], &stimulus);
    let [inclined, clean] = beside(&rom, "alpha_offset", &[0.4], &stimulus);
    assert_eq!(cambered, inclined);
    // My = My_0 + My_alpha k My, all of it: what camber and controls do at rest as well
    let by_incidence: [f64; 3] =
        std::array::from_fn(|c| (inclined[c][0] - clean[c][0]) / 0.4_f64.to_radians());
    let k = 5e-4;
    let [soft, _] = beside(&rom, "balance_compliance", &[k], &stimulus);
    for i in 0..soft[0].len() {
        for c in 0..3 {
            let expected = clean[c][i] + by_incidence[c] * k * soft[2][i];
            assert!((soft[c][i] - expected).abs() < 1e-9 * swing(&clean[c]), "channel {c} point {i}");
        }
    }
}

#[test]
fn a_mass_at_the_tip_lowers_the_first_frequency_as_rayleigh_says() {
    // without air: the response of the first mode peaks where its stiffness and masses say
    let rom = rom(0.0);
    let peak = |change: &Change| {
        let omegas: Vec<f64> = (0..2000).map(|i| TAU * (2.0 + 0.003 * f64::from(i))).collect();
        let responses = rom.responses(change, &omegas, false);
        let height = |k: usize| responses[k][(Outputs::TIP, Drive::G_COS)].norm();
        omegas[(0..omegas.len()).max_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap()]
    };
    let none = Change::none(rom.zones.len());
    // where the outermost zone's height is that of the mass
    let y_norm = rom.zones.y_norm[rom.zones.len() - 1];
    let point = PointMass { mass_kg: 0.02, y_norm, aft_over_c: 0.2 };
    let before = peak(&none);
    let after = peak(&Change { points: vec![point], ..none.clone() });
    // the mode's height at the outermost zone per unit of modal mass: the compliance of a force there, less all other modes'
    let everything = rom.responses(&none, &[0.0], true);
    let zone = rom.zones.len() - 1;
    let by_modal = everything[0][(rom.outputs().heights() + zone, rom.drive().modal())].re;
    let shape = by_modal * before * before;
    let rayleigh = before / (1.0 + point.mass_kg * shape * shape).sqrt();
    assert!(
        after < before && ((before - after) / (before - rayleigh) - 1.0).abs() < 0.1,
        "{before} {after} {rayleigh}"
    );
}

#[test]
fn slope_and_loss_towards_the_tip_are_correction_factors_of_the_steady_wing() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(
        &wing,
        RigSettings { modes: 40, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) },
    )
    .unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let flow = Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };
    let plain = ReducedOrderModel::new(&rig, flow, &neutral, None).unwrap();
    let boxes = &wing.correctable;
    let by = |factor: &dyn Fn(f64) -> f64| {
        let factors: Vec<f64> = boxes.y_norm.iter().map(|y| factor(*y)).collect();
        let corrections = Corrections { force: factors.clone(), moment: factors, ..neutral.clone() };
        ReducedOrderModel::new(&rig, flow, &corrections, None).unwrap()
    };
    // (effect, value, how far zones are from strips), and the factor along the span
    let cases = [("lift_slope", -0.1, 1e-3), ("tip_loss", 0.3, 6e-3)];
    let factors: [fn(f64) -> f64; 2] = [|_| 0.9, |y| 1.0 - 0.3 * y * y];
    let still = vec![0.0; 2];
    let alpha = Smooth { value: vec![0.0, 0.06], rate: still.clone(), second: still.clone() };
    let inputs =
        Inputs { alpha, incidence_rad: still.clone(), controls_rad: vec![still; plain.controls.len()] };
    let stimulus = Stimulus { inputs, time_step_s: 0.01, steady: true, clock_h: 0.0 };
    for ((name, value, tolerance), factor) in cases.into_iter().zip(factors) {
        let [ours, clean] = beside(&plain, name, &[value], &stimulus);
        let theirs = with(&by(&factor), &[], &stimulus).loads;
        for c in 0..3 {
            let [a, b, before] = [&ours, &theirs, &clean].map(|loads| loads[c][1] - loads[c][0]);
            assert!((a - b).abs() < tolerance * before.abs(), "{name} channel {c}: {a} {b} before {before}");
            assert!((b - before).abs() > 0.03 * before.abs(), "{name} channel {c}");
        }
    }
}

/// What large deflection does to a strip's loads where all lift sits at the end of a circular arc.
#[test]
fn an_arc_under_a_load_at_its_end_has_the_moment_of_the_circle() {
    let (count, length, force, theta) = (400_usize, 2.0, 50.0, 0.25_f64);
    let along: Vec<f64> = (1..=count).map(|i| length * i as f64 / count as f64).collect();
    let radius = length / theta;
    // heights over the undeformed arm, as a linear structure has them: the slope is the angle
    let height_m: Vec<Vec<f64>> = along.iter().map(|s| vec![0.5 * s * s / radius]).collect();
    let mut lift_n = vec![vec![0.0]; count];
    lift_n[count - 1][0] = force;
    let each = |value: f64| vec![value; count];
    let zones = Zones {
        boxes: vec![Vec::new(); count],
        y_norm: along.iter().map(|s| s / length).collect(),
        y_m: along,
        x_m: each(0.0),
        chord_m: each(0.2),
        area_m2: each(0.01),
        width_m: each(0.05),
    };
    let place = Place {
        flow: Flow { v_m_s: 30.0, rho_kg_m3: 1.225 },
        zones: &zones,
        controls: &[],
        time_step_s: 0.01,
        steady: true,
        clock_h: 0.0,
        actuator: maneuver::Actuator { frequency_hz: 15.0, damping_ratio: 0.8 },
        gravity_m_s2: 9.81,
        balance_y_m: 0.0,
        outer_shape: 0.0,
        first_stiffness: 0.0,
    };
    let still = || vec![0.0];
    let alpha = Smooth { value: still(), rate: still(), second: still() };
    let inputs = Inputs { alpha, incidence_rad: still(), controls_rad: Vec::new() };
    let balance = [vec![force], vec![force * length], still()];
    let seen = WingState {
        inputs: &inputs,
        loads: &balance,
        tip_m: &[0.0],
        lift_n: &lift_n,
        height_m: &height_m,
        outer_height_m: &[],
        twist_rad: &[],
    };
    let mut loads = Loads { balance: balance.clone(), tip_m: still() };
    let effect =
        maneuver::effects::library(&[]).into_iter().find(|e| e.spec().name == "large_deflection").unwrap();
    effect.loads(&[1.0], &place, &seen, &mut loads);
    // a follower load at angle theta: Fz = F cos(theta), Mx = F R sin(theta); equal to second order of theta
    let (fz, mx) = (force * theta.cos(), force * radius * theta.sin());
    let second = 0.5 * theta * theta * force;
    assert!((loads.balance[0][0] - fz).abs() < 0.02 * second, "{} {fz}", loads.balance[0][0]);
    assert!((loads.balance[1][0] - mx).abs() < 0.02 * second * length, "{} {mx}", loads.balance[1][0]);
}

#[test]
fn stall_bends_a_rigid_wing_s_lift_to_the_piecewise_line() {
    let (file, wing) = wing_with(|planform| planform.structure = None);
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let flow = Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };
    let rom = ReducedOrderModel::new(&rig, flow, &neutral, None).unwrap();
    let stimulus = points(rom.controls.len());
    let (earlier, k) = (13.0, 0.5);
    let [ours, clean] = beside(&rom, "stall", &[earlier, k], &stimulus);
    // every zone's own lift from the response, its limit from its area
    let none = Change::none(rom.zones.len());
    let response = &rom.responses(&none, &[0.0], true)[0];
    let rest = rom.at_rest(&none, &maneuver::rom::Constants::default(), true);
    let mut bends = false;
    for (i, alpha) in stimulus.inputs.alpha.value.iter().enumerate() {
        let mut lost = 0.0;
        for zone in 0..rom.zones.len() {
            let row = rom.outputs().lifts() + zone;
            let controls = (0..rom.controls.len()).map(|c| 0.1 * response[(row, Drive::CONTROLS + c)].re);
            let lift = rest[row] + response[(row, Drive::PITCH)].re * alpha + controls.sum::<f64>();
            let limit =
                (16.0 - earlier).to_radians() * TAU * flow.dynamic_pressure_pa() * rom.zones.area_m2[zone];
            lost += k / (1.0 + k) * (lift.abs() - limit).max(0.0) * lift.signum();
        }
        bends |= lost.abs() > 0.0;
        assert!(
            (clean[0][i] - lost - ours[0][i]).abs() < 1e-6,
            "{alpha}: {} {lost} {}",
            clean[0][i],
            ours[0][i]
        );
    }
    assert!(bends, "no zone stalls");
}
