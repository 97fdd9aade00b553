//! The equations of flight of an aircraft made by hand: Newton's and Euler's laws, and rates that are those along the
//! path.

use super::{AirRows, Equations, Evaluated, Inputs, Reference};
use crate::flight::state::{ATTITUDE, PLACE, StateLayout, attitude, mode_state, vector};
use faer::Mat;
use maneuver::air::RationalAir;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// Motions: five rigid ones, a mode, a drive, two stations of a gust.
const MOTIONS: usize = 9;
const LAYOUT: StateLayout = StateLayout { modes: 1, drives: 1, motions: MOTIONS, poles: 2 };
const H_S: f64 = 1e-6;

fn uneven(i: usize, j: usize) -> f64 {
    (1.3 * (7 * i + 3 * j + 1) as f64).sin()
}

/// An aircraft whose air answers every motion in every row.
pub(crate) fn equations() -> Equations {
    let part = |shift: usize| Mat::from_fn(7, MOTIONS, |i, j| 0.02 * uneven(i + shift, j));
    let air = RationalAir {
        poles_per_m: vec![0.4, 1.7],
        steady: part(0),
        rate: part(11),
        second: part(23),
        lags: vec![part(37), part(41)],
    };
    Equations {
        layout: LAYOUT,
        reference: Reference { v_m_s: 20.0, alpha_rad: 0.1, pitch_rate_rad_s: 0.07 },
        rho_kg_m3: 1.1,
        gravity_m_s2: 9.8,
        mass_kg: 12.0,
        inertia: Matrix3::new(3.0, 0.1, -0.2, 0.1, 4.0, 0.3, -0.2, 0.3, 5.0),
        omega_rad_s: vec![30.0],
        damping_ratio: 0.03,
        actuator: [50.0, 0.6],
        poles_per_m: air.poles_per_m.clone(),
        generalised: AirRows::new((0..7).map(|i| 0.3 * uneven(i, 50)).collect(), &air),
        hold: Vector3::new(0.5, -0.7, 0.9),
    }
}

/// A state in which everything moves.
pub(crate) fn state() -> Vec<f64> {
    let mut state: Vec<f64> = (0..LAYOUT.len()).map(|at| 0.05 * uneven(at, 3)).collect();
    state[..6].copy_from_slice(&[-21.0, 2.0, -4.0, 0.4, -0.3, 0.6]);
    let turned = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.5, 0.9));
    crate::flight::state::put_attitude(&mut state, &turned);
    state
}

fn inputs(t_s: f64) -> Inputs {
    let rate = vec![4.0, -7.0];
    Inputs { command_rad: vec![0.2], gust_m_s: vec![1.5 + 4.0 * t_s, -0.8 - 7.0 * t_s], gust_rate_m_s2: rate }
}

pub(crate) fn evaluated() -> Evaluated {
    equations().evaluate(&state(), &inputs(0.0))
}

/// What the air answers so much later along the path.
fn later(t_s: f64) -> Evaluated {
    let (equations, from) = (equations(), state());
    let rates = equations.evaluate(&from, &inputs(0.0)).derivative;
    let moved: Vec<f64> = from.iter().zip(&rates).map(|(x, rate)| x + rate * t_s).collect();
    equations.evaluate(&moved, &inputs(t_s))
}

fn assert_same(what: &str, ours: f64, law: f64, share: f64) {
    assert!((ours - law).abs() <= share * law.abs().max(1e-3), "{what}: {ours}, the law says {law}");
}

#[test]
fn rates_of_all_the_air_answers_are_those_along_the_path() {
    let (now, v_m_s) = (evaluated(), vector(&state(), 0).norm());
    let [before, after] = [-H_S, H_S].map(|t_s| later(t_s).air);
    for motion in 0..MOTIONS {
        // a gust's rate is that of its velocity; the airspeed's own change is left out there
        let rate = match motion {
            gust if gust >= 7 => inputs(0.0).gust_rate_m_s2[gust - 7] / v_m_s,
            _ => (after[motion] - before[motion]) / (2.0 * H_S),
        };
        assert_same(&format!("rate of motion {motion}"), now.air[MOTIONS + motion] * v_m_s, rate, 1e-5);
        for (pole, g) in [0.4, 1.7].into_iter().enumerate() {
            let at = LAYOUT.lag(pole, motion);
            let law = rate - g * v_m_s * state()[at];
            assert_same(&format!("lag {pole} of motion {motion}"), now.derivative[at], law, 1e-5);
            assert_eq!(now.air[(3 + pole) * MOTIONS + motion], state()[at]);
        }
    }
    // second rates of a mode and a drive, over V²
    for (motion, rate) in [(5, LAYOUT.mode_rate(0)), (6, LAYOUT.drive_rate(0))] {
        let law = now.derivative[rate];
        assert_same("a second rate", now.air[2 * MOTIONS + motion] * v_m_s * v_m_s, law, 1e-12);
    }
}

#[test]
fn what_the_air_answers_are_angles_rates_over_airspeed_modes_drives_and_the_gust_over_airspeed() {
    let (now, state) = (evaluated(), state());
    let v_m_s = (21.0_f64 * 21.0 + 4.0 + 16.0).sqrt();
    let laws = [
        4.0_f64.atan2(21.0) - 0.1,
        (2.0 / v_m_s).asin(),
        0.4 / v_m_s,
        -0.3 / v_m_s - 0.07 / 20.0,
        0.6 / v_m_s,
        state[mode_state(0)],
        state[LAYOUT.drive(0)],
        1.5 / v_m_s,
        -0.8 / v_m_s,
    ];
    for (motion, law) in laws.into_iter().enumerate() {
        assert_same(&format!("motion {motion}"), now.air[motion], law, 1e-12);
    }
    let [v, alpha, beta] = Equations::stream_of(&state);
    assert_same("airspeed", v, v_m_s, 1e-14);
    assert_same("angle of attack", alpha, 4.0_f64.atan2(21.0), 1e-14);
    assert_same("sideslip", beta, (2.0 / v_m_s).asin(), 1e-14);
    assert_same("dynamic pressure", now.q_pa, 0.5 * 1.1 * v_m_s * v_m_s, 1e-14);
}

#[test]
fn forces_are_mass_times_acceleration_moments_the_change_of_spin_and_modes_oscillate() {
    let (equations, now, state) = (equations(), evaluated(), state());
    let loads: Vec<f64> = equations.generalised.at(&now.air).iter().map(|load| load * now.q_pa).collect();
    let (velocity, omega) = (vector(&state, 0), vector(&state, 3));
    let [v_rate, omega_rate] = [0, 3].map(|from| vector(&now.derivative, from));
    let down = attitude(&state).inverse() * Vector3::new(0.0, 0.0, -9.8);
    assert!((now.gravity - down).norm() < 1e-12, "{:?}", now.gravity);
    let force = now.turn * vector(&loads, 0) + down * 12.0;
    assert!((force - (v_rate + omega.cross(&velocity)) * 12.0).norm() < 1e-9, "Newton");
    let moment = now.turn * vector(&loads, 3) + equations.hold;
    let spin = equations.inertia * omega;
    assert!((moment - equations.inertia * omega_rate - omega.cross(&spin)).norm() < 1e-9, "Euler");
    // the trim's air bends the structure that much already
    let held = equations.generalised.constant[6] * 0.5 * 1.1 * 400.0;
    let (eta, rate) = (state[mode_state(0)], state[LAYOUT.mode_rate(0)]);
    let law = loads[6] - held - 900.0 * eta - 2.0 * 0.03 * 30.0 * rate;
    assert_same("the mode", now.derivative[LAYOUT.mode_rate(0)], law, 1e-9);
    assert_eq!(now.derivative[mode_state(0)], rate);
    assert_eq!(now.accelerations[6], now.derivative[LAYOUT.mode_rate(0)]);
    let (at, rate) = (state[LAYOUT.drive(0)], state[LAYOUT.drive_rate(0)]);
    let law = 2500.0 * (0.2 - at) - 2.0 * 0.6 * 50.0 * rate;
    assert_same("the drive", now.derivative[LAYOUT.drive_rate(0)], law, 1e-12);
    assert_eq!(now.derivative[LAYOUT.drive(0)], rate);
}

#[test]
fn the_air_s_axes_follow_the_stream_and_place_and_attitude_follow_velocity_and_rates() {
    let (now, state) = (evaluated(), state());
    let (velocity, omega) = (vector(&state, 0), vector(&state, 3));
    assert!((now.turn.transpose() * now.turn - Matrix3::identity()).norm() < 1e-14);
    assert!((now.turn.determinant() - 1.0).abs() < 1e-14);
    assert!((now.turn.column(0) + velocity / velocity.norm()).norm() < 1e-14, "aft along the stream");
    assert!(now.turn[(1, 2)] == 0.0 && now.turn[(2, 2)] > 0.0, "lift stays in the plane of symmetry");
    let path = attitude(&state) * velocity;
    assert!((vector(&now.derivative, PLACE) - path).norm() < 1e-12);
    let mut moved = state.clone();
    for (value, rate) in moved.iter_mut().zip(&now.derivative).take(PLACE).skip(ATTITUDE) {
        *value += rate * H_S;
    }
    let law = attitude(&state) * UnitQuaternion::from_scaled_axis(omega * H_S);
    assert!(attitude(&moved).angle_to(&law) < 1e-11, "{}", attitude(&moved).angle_to(&law));
}

#[test]
fn a_trimmed_state_flies_level_ahead_without_any_change_of_the_air() {
    let equations = equations();
    let state = equations.trimmed();
    let [v, alpha, beta] = Equations::stream_of(&state);
    assert_same("airspeed", v, 20.0, 1e-14);
    assert_same("angle of attack", alpha, 0.1, 1e-13);
    assert_eq!([beta, state[4]], [0.0, 0.07]);
    assert!((attitude(&state) * vector(&state, 0) + Vector3::new(20.0, 0.0, 0.0)).norm() < 1e-13);
    let still = equations.no_inputs();
    assert_eq!([still.command_rad.len(), still.gust_m_s.len(), still.gust_rate_m_s2.len()], [1, 2, 2]);
    let air = equations.evaluate(&state, &still).air;
    assert!(air[..MOTIONS].iter().all(|motion| motion.abs() < 1e-15), "{air:?}");
}

#[test]
fn rows_of_the_air_add_a_constant_motions_rates_second_rates_and_lags() {
    let part = |value: f64| Mat::from_fn(2, 3, |i, j| value + (10 * i + j) as f64);
    let air = RationalAir {
        poles_per_m: vec![1.0],
        steady: part(100.0),
        rate: part(200.0),
        second: part(300.0),
        lags: vec![part(400.0)],
    };
    let rows = AirRows::new(vec![5.0, -6.0], &air);
    let mut motions = vec![0.0; 12];
    (motions[1], motions[5], motions[6], motions[11]) = (2.0, -1.0, 3.0, 0.5);
    let law = |i: f64| 2.0 * (101.0 + i) - (202.0 + i) + 3.0 * (300.0 + i) + 0.5 * (402.0 + i);
    assert_eq!(rows.at(&motions), vec![5.0 + law(0.0), -6.0 + law(10.0)]);
}
