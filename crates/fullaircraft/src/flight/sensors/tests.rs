//! Instruments of an aircraft made by hand: what a point of a body feels follows from where it goes.

use super::{FIXED, PER_UNIT, Sensors, Unit, felt};
use crate::flight::equations::AirRows;
use crate::flight::equations::tests::{equations, evaluated, state};
use crate::flight::state::{attitude, euler_angles, mode_state, vector};
use faer::Mat;
use nalgebra::{UnitQuaternion, Vector3};

fn unit() -> Unit {
    Unit {
        name: "tip".to_owned(),
        arm: Vector3::new(0.7, 1.9, -0.3),
        moved: vec![Vector3::new(0.2, -0.1, 1.1)],
        turned: vec![Vector3::new(0.3, -0.8, 0.5)],
        height: vec![1.4],
        height_at_trim_m: 0.06,
        slope_at_trim: Vector3::zeros(),
    }
}

/// Velocity of the unit's place in the axes of now, so much later.
fn velocity(unit: &Unit, state: &[f64], t_s: f64) -> Vector3<f64> {
    let rates = evaluated().accelerations;
    let at = |from: usize| Vector3::new(rates[from], rates[from + 1], rates[from + 2]);
    let (v, omega) = (vector(state, 0) + at(0) * t_s, vector(state, 3) + at(3) * t_s);
    let turned = UnitQuaternion::from_scaled_axis(vector(state, 3) * t_s + at(3) * (0.5 * t_s * t_s));
    let rate = state[equations().layout.mode_rate(0)];
    let (eta, eta_rate) = (rate * t_s + 0.5 * rates[6] * t_s * t_s, rate + rates[6] * t_s);
    turned * (v + omega.cross(&(unit.arm + unit.moved[0] * eta)) + unit.moved[0] * eta_rate)
}

#[test]
fn a_unit_feels_the_change_of_its_velocity_less_gravity() {
    let (unit, mut state, h_s) = (unit(), state(), 1e-5);
    state[mode_state(0)] = 0.0;
    let now = evaluated();
    let change = (velocity(&unit, &state, h_s) - velocity(&unit, &state, -h_s)) / (2.0 * h_s);
    let law = change - now.gravity;
    let shown = unit.read(&equations(), &state, &now);
    for axis in 0..3 {
        assert!((shown[1 + axis] - law[axis]).abs() < 1e-5 * law.norm(), "{shown:?} {law:?}");
    }
}

#[test]
fn a_unit_turns_with_the_structure_and_shows_rates_as_flight_mechanics_does() {
    let (equations, now, mut state) = (equations(), evaluated(), state());
    state[mode_state(0)] = 0.0;
    let still = unit().read(&equations, &state, &now);
    let felt = Vector3::new(still[1], still[2], still[3]);
    let slope = Vector3::new(2e-6, -1e-6, 3e-6);
    let seen = UnitQuaternion::from_scaled_axis(-slope) * felt - felt;
    let at_trim = Unit { slope_at_trim: slope, ..unit() }.read(&equations, &state, &now);
    state[mode_state(0)] = 2e-6;
    let bent = Unit { turned: vec![slope / 2e-6], ..unit() };
    let flown = bent.read(&equations, &state, &now);
    for axis in 0..3 {
        assert!((at_trim[1 + axis] - still[1 + axis] - seen[axis]).abs() < 1e-9, "{at_trim:?}");
        assert!((flown[1 + axis] - still[1 + axis] - seen[axis]).abs() < 1e-9, "{flown:?}");
    }
    let rate = state[equations.layout.mode_rate(0)];
    let law = vector(&state, 3) + bent.turned[0] * rate;
    let shown = [-flown[4], flown[5], -flown[6]];
    assert!((Vector3::from(shown) - law).norm() < 1e-12, "right wing down, nose up, nose right: {shown:?}");
    assert!((flown[0] - 0.06 - 1.4 * 2e-6).abs() < 1e-15, "height {}", flown[0]);
}

#[test]
fn accelerations_felt_are_those_against_free_fall_then_modes_then_products_of_rates() {
    let (now, state) = (evaluated(), state());
    let (v, w) = (vector(&state, 0), vector(&state, 3));
    let all = felt(&state, &now);
    assert_eq!(all.len(), 6 + 1 + 6);
    let law = Vector3::new(w.y * v.z - w.z * v.y, w.z * v.x - w.x * v.z, w.x * v.y - w.y * v.x);
    for axis in 0..3 {
        let law = now.accelerations[axis] + law[axis] - now.gravity[axis];
        assert!((all[axis] - law).abs() < 1e-12 * law.abs(), "axis {axis}");
        assert_eq!(all[3 + axis], now.accelerations[3 + axis]);
    }
    assert_eq!(all[6], now.accelerations[6]);
    assert_eq!(all[7..], [w.x * w.x, w.y * w.y, w.z * w.z, w.x * w.y, w.x * w.z, w.y * w.z]);
}

/// Two parts, their air in six rows each.
fn sensors() -> Sensors {
    let columns = 9 * 5;
    let row = |i: usize, j: usize| 0.01 * (0.9 * (5 * i + 2 * j) as f64).cos();
    Sensors {
        units: vec![unit()],
        outermost: 0,
        parts: vec!["one".to_owned(), "two".to_owned()],
        to_centre: vec![Vector3::new(0.2, -0.5, 0.1), Vector3::new(-0.3, 0.4, 0.6)],
        loads: AirRows {
            constant: (0..12).map(|i| row(i, 70)).collect(),
            by: Mat::from_fn(12, columns, row),
        },
        inertia: Mat::from_fn(6, 13, |i, j| row(j, i)),
        pitch: vec![0.7],
        alpha_at_trim_rad: 0.25,
        shift: (0..6).map(|i| f64::from(i) - 2.5).collect(),
    }
}

#[test]
fn outputs_are_the_stream_attitude_place_drives_units_and_the_loads_of_parts_about_their_points() {
    let (sensors, equations, now, state) = (sensors(), equations(), evaluated(), state());
    let out = sensors.read(&equations, &state, &now);
    assert_eq!((out.len(), sensors.count(1)), (FIXED + 1 + PER_UNIT + 6, FIXED + 1 + PER_UNIT + 6));
    assert_eq!([Sensors::unit(1, 0), Sensors::unit(1, 2)], [FIXED + 1, FIXED + 1 + 2 * PER_UNIT]);
    assert_eq!(sensors.first_load(1), FIXED + 1 + PER_UNIT);
    let v = vector(&state, 0);
    let law = 0.25 + (-v.z).atan2(-v.x) - 0.1 + 0.7 * state[mode_state(0)];
    assert!((out[0] - v.norm()).abs() < 1e-12 && (out[1] - law).abs() < 1e-14, "{out:?}");
    assert!((out[2] - (v.y / v.norm()).asin()).abs() < 1e-14);
    let lift = now.q_pa * equations.generalised.at(&now.air)[2];
    assert!((out[3] - lift / (12.0 * 9.8)).abs() < 1e-12, "load factor {}", out[3]);
    assert_eq!(out[4..7], [-state[3], state[4], -state[5]]);
    assert_eq!(out[7..10], euler_angles(&attitude(&state)));
    assert_eq!(out[10..13], state[10..13]);
    assert_eq!(out[13], state[equations.layout.drive(0)]);
    assert_eq!(out[14..21], unit().read(&equations, &state, &now));
    let (air, felt) = (sensors.loads.at(&now.air), felt(&state, &now));
    for part in 0..2 {
        let arm = sensors.to_centre[part];
        let of = |from: usize| now.turn * vector(&air, 6 * part + from) * now.q_pa;
        let (force, about_centre) = (of(0), of(3));
        let about = Vector3::new(
            about_centre.x + arm.y * force.z - arm.z * force.y,
            about_centre.y + arm.z * force.x - arm.x * force.z,
            0.0,
        );
        for (row, air) in [force.z, about.x, about.y].into_iter().enumerate() {
            let inertia: f64 = (0..13).map(|j| sensors.inertia[(3 * part + row, j)] * felt[j]).sum();
            let law = air - inertia + sensors.shift[3 * part + row];
            let shown = out[sensors.first_load(1) + 3 * part + row];
            assert!((shown - law).abs() < 1e-9 * law.abs().max(1.0), "part {part}, row {row}: {shown} {law}");
        }
    }
}
