//! Laws of the rig: steady limits, inertia, damping.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{uneven, wing_with};
use aero::{Corrections, Flow};
use coupling::{ElasticWing, Mount, SteadyCase, WingFile};
use maneuver::motion::{About, Doublet, OneMinusCosine, Signal, Step, sampled};
use maneuver::{AirModel, Motion, Rig, RigSettings, Smooth};

const RHO: f64 = 1.225;

/// Stiffer by a factor, in every panel of the deck.
fn stiffened(factor: f64) -> (WingFile, ElasticWing) {
    let (file, _) = wing_with(|_| ());
    let mut bulk = file.bulk(Mount::Tunnel).unwrap();
    for material in bulk.materials.values_mut() {
        material.e *= factor;
        material.g *= factor;
    }
    let wing = ElasticWing::from_bulk(&file, &bulk).unwrap();
    (file, wing)
}

fn settings(file: &WingFile) -> RigSettings {
    RigSettings::new(file.damping_ratio, file.pitch_axis_x())
}

fn flow(v_m_s: f64) -> Flow {
    Flow { v_m_s, rho_kg_m3: RHO }
}

fn motion(alpha: &dyn Signal, samples: usize, controls_rad: Vec<Vec<f64>>) -> Motion {
    let h = 0.005;
    let times = (0..samples).map(|i| i as f64 * h);
    Motion {
        time_step_s: h,
        alpha: Smooth {
            value: times.clone().map(|t| alpha.at(t)).collect(),
            rate: times.clone().map(|t| alpha.rate(t)).collect(),
            second: times.map(|t| alpha.second(t)).collect(),
        },
        controls_rad,
    }
}

#[test]
fn the_first_sample_of_any_run_equals_the_static_loads() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let rig = Rig::new(&wing, settings(&file)).unwrap();
    let alpha = About(0.0227, OneMinusCosine::new(0.065, 2.0, -0.1));
    for v_m_s in [18.0, 40.0] {
        let controls = vec![vec![0.05; 10], vec![-0.02; 10], vec![0.03; 10]];
        let history = rig.at(flow(v_m_s), &corrections).unwrap().fly(&motion(&alpha, 10, controls));
        let case =
            SteadyCase { flow: flow(v_m_s), alpha_rad: alpha.at(0.0), controls_rad: vec![0.05, -0.02, 0.03] };
        let state = &wing.at(case.flow, &corrections).unwrap().solve(&[case])[0];
        for (name, expected) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().zip(state.root.to_array()) {
            let got = history.get(name).unwrap()[0];
            assert!((got - expected).abs() < 1e-9 * expected.abs().max(1.0), "{name} {got} {expected}");
        }
        assert!((history.get("tip_z_m").unwrap()[0] - state.tip_z_m).abs() < 1e-9);
    }
}

#[test]
fn steady_results_do_not_depend_on_the_number_of_modes() {
    let (file, wing) = wing_with(|_| ());
    let corrections = uneven(&wing);
    let still = motion(&Step { height: 0.05, start_s: 0.0 }, 3, Vec::new());
    let loads = |modes: usize| {
        let rig = Rig::new(&wing, RigSettings { modes, ..settings(&file) }).unwrap();
        let history = rig.at(flow(40.0), &corrections).unwrap().fly(&still);
        ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"].map(|name| history.get(name).unwrap()[2])
    };
    let reference = loads(20);
    for modes in [1, 4, 60] {
        for (a, b) in loads(modes).into_iter().zip(reference) {
            assert!((a - b).abs() < 1e-8 * b.abs().max(1.0), "{modes} modes: {a} {b}");
        }
    }
}

#[test]
fn a_very_slow_pitch_run_equals_the_static_loads_within_half_a_per_cent() {
    let (file, wing) = wing_with(|_| ());
    let neutral = Corrections::neutral(wing.correctable.len());
    let rig = Rig::new(&wing, settings(&file)).unwrap();
    let alpha = About(0.02, OneMinusCosine::new(0.06, 0.02, 0.0));
    let history = rig.at(flow(30.0), &neutral).unwrap().fly(&motion(&alpha, 10_000, Vec::new()));
    let operator = wing.at(flow(30.0), &neutral).unwrap();
    let channels = ["Fz_N", "Mx_Nm", "My_Nm"];
    let peak = channels.map(|name| history.get(name).unwrap().iter().fold(0.0, |m: f64, v| m.max(v.abs())));
    for i in (0..10_000).step_by(500) {
        let state = &operator.solve(&[SteadyCase::new(flow(30.0), alpha.at(i as f64 * 0.005))])[0];
        for (c, expected) in state.root.to_array().into_iter().enumerate() {
            let got = history.get(channels[c]).unwrap()[i];
            assert!(
                (got - expected).abs() < 0.005 * peak[c],
                "{} at sample {i}: {got} {expected}",
                channels[c]
            );
        }
    }
}

#[test]
fn wind_off_pitch_of_a_stiffened_wing_gives_rigid_body_inertia() {
    // the first bending at 456 kHz: nothing is left of its ringing after one sample; without the mass of the air around
    let (file, wing) = stiffened(1e10);
    let rig = Rig::new(&wing, RigSettings { air: AirModel::QuasiSteady, ..settings(&file) }).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let alpha = About(0.02, OneMinusCosine::new(0.06, 2.0, 0.0));
    let history = rig.at(flow(0.0), &neutral).unwrap().fly(&motion(&alpha, 100, Vec::new()));
    // closed form: every mass m at (x, y) moves z = -(x - x_p) alpha, so F = -m z'' = m (x - x_p) alpha''
    let (system, _) = wing.structure.as_ref().unwrap();
    let about_balance = system.rigid_body(&wing.balance.point);
    let mass = about_balance.transpose() * system.inertia_loads(about_balance.as_ref());
    let properties = system.mass_properties();
    let arm = properties.centre - wing.balance.point;
    let g = coupling::GRAVITY_M_S2;
    for i in 1..100 {
        let t = i as f64 * 0.005;
        let (a, second) = (alpha.at(t), alpha.second(t));
        let weight = properties.mass_kg * g * (1.0 - a.cos());
        let fz = properties.mass_kg * arm.x * second + weight;
        let my = -mass[(4, 4)] * second - arm.x * weight + arm.z * properties.mass_kg * g * a.sin();
        let mx = -mass[(3, 4)] * second + arm.y * weight;
        for (name, expected) in [("Fz_N", fz), ("Mx_Nm", mx), ("My_Nm", my)] {
            let got = history.get(name).unwrap()[i];
            assert!((got - expected).abs() < 1e-5, "{name} at {t}: {got} {expected}");
        }
    }
}

#[test]
fn accelerometers_of_a_stiffened_wing_go_down_by_their_arm_aft_of_the_pitch_axis() {
    let (file, wing) = stiffened(1e10);
    let (system, _) = wing.structure.as_ref().unwrap();
    let grids = file.planform().unwrap().sensor_grids();
    let sensors = grids.into_iter().map(|(name, id)| (name, system.node_index(id).unwrap())).collect();
    let settings = RigSettings { air: AirModel::QuasiSteady, sensors, ..settings(&file) };
    let rig = Rig::new(&wing, settings).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let alpha = About(0.02, OneMinusCosine::new(0.06, 2.0, 0.0));
    let history = rig.at(flow(0.0), &neutral).unwrap().fly(&motion(&alpha, 100, Vec::new()));
    // 40 % of the chord behind the leading edge, at the spans of wing_beam.ron
    for (name, y_m) in [("imu_1", 0.45), ("imu_2", 0.90), ("imu_3", 1.35), ("imu_4", 1.75)] {
        let chord_m = 0.30 - 0.15 * y_m / 1.8;
        let x_m = 0.075 + y_m * f64::to_radians(20.0).tan() + 0.15 * chord_m;
        let arm_m = x_m - file.pitch_axis_x();
        assert!(arm_m > 0.1, "{name} is aft of the axis");
        let felt = history.get(&format!("az_{name}_m_s2")).unwrap();
        for (i, felt) in felt.iter().enumerate().skip(1) {
            let expected = -arm_m * alpha.second(i as f64 * 0.005);
            assert!((felt - expected).abs() < 1e-4, "{name} sample {i}: {felt} m/s2 for {expected} m/s2");
        }
    }
}

#[test]
fn a_doublet_rings_in_the_first_mode_and_wind_damps_it() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, settings(&file)).unwrap();
    let first_hz = rig.omega_rad_s()[0] / std::f64::consts::TAU;
    // 4.56 Hz: documented with the stand-in wing, independent program
    assert!((first_hz / 4.56 - 1.0).abs() < 0.03, "{first_hz}");
    let neutral = Corrections::neutral(wing.correctable.len());
    let doublet = sampled(&Doublet { height: 0.09, frequency_hz: 4.0, start_s: 0.1 }, 0.005, 600);
    let moved = |delta: Vec<f64>| {
        let still = motion(&Step { height: 0.02, start_s: 0.0 }, 600, vec![vec![0.0; 600], delta]);
        let history = rig.at(flow(30.0), &neutral).unwrap().fly(&still);
        let mx = history.get("Mx_Nm").unwrap().to_vec();
        mx.iter().map(|value| value - mx[0]).collect::<Vec<f64>>()
    };
    let drift = moved(vec![0.0; 600]).iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    assert!(drift < 1e-7, "no input, no motion: {drift:e} N m of some 60");
    let loads = moved(doublet);
    let largest = |range: std::ops::Range<usize>| loads[range].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    // log decrement beyond the structure's own 2 %: ringing dies faster than without wind
    let periods = 1.0 * first_hz;
    let decay = (largest(100..160) / largest(300..360)).ln() / periods / std::f64::consts::TAU;
    assert!(decay > 0.05, "{decay}");
}
