//! What effects see and change, by hand.

use super::*;

fn place(zones: &Zones, v_m_s: f64, outer_shape: f64) -> Place<'_> {
    Place {
        flow: Flow { v_m_s, rho_kg_m3: 1.2 },
        zones,
        controls: &[],
        time_step_s: 0.01,
        steady: false,
        clock_h: 0.0,
        actuator: Actuator { frequency_hz: 5.0, damping_ratio: 0.7 },
        gravity_m_s2: 9.81,
        balance_y_m: 0.0,
        outer_shape,
        first_stiffness: 0.0,
    }
}

fn inputs(samples: usize) -> Inputs {
    let still = vec![0.0; samples];
    let alpha = Smooth { value: still.clone(), rate: still.clone(), second: still.clone() };
    Inputs {
        alpha,
        incidence_rad: vec![0.25; samples],
        controls_rad: vec![vec![0.1; samples], vec![-0.3; samples]],
    }
}

#[test]
fn pressures_are_those_of_the_stream() {
    let zones = Zones::default();
    let there = place(&zones, 45.0, 0.0);
    assert!((there.q_over_reference() - 2.25).abs() < 1e-12 && (there.q_pa() - 1215.0).abs() < 1e-9);
    let still = place(&zones, 0.0, 0.0);
    assert_eq!((still.q_over_reference(), still.q_pa()), (0.0, 0.0));
}

#[test]
fn a_stream_is_inclined_where_there_is_one() {
    let zones = Zones::default();
    let mut driven = inputs(2);
    driven.incline(&place(&zones, 0.0, 0.0), 0.5);
    assert_eq!(driven.incidence_rad, [0.25; 2]);
    driven.incline(&place(&zones, 1e-3, 0.0), 0.5);
    assert_eq!(driven.incidence_rad, [0.75; 2]);
    driven.deflections().for_each(|delta| *delta += 1.0);
    assert_eq!(driven.controls_rad, [[1.1; 2], [0.7; 2]]);
}

#[test]
fn a_force_on_the_first_mode_is_by_the_outermost_height_over_its_shape() {
    let zones = Zones::default();
    let (driven, still) = (inputs(2), vec![0.0; 2]);
    let loads = [still.clone(), still.clone(), still.clone()];
    let outer = [0.2, -0.4];
    let state = WingState {
        inputs: &driven,
        loads: &loads,
        tip_m: &still,
        lift_n: &[],
        height_m: &[],
        outer_height_m: &outer,
        twist_rad: &[],
    };
    assert_eq!((state.len(), state.is_empty()), (2, false));
    let mut forces = Forces::none(3, 2);
    assert_eq!(forces.lift_n, vec![vec![0.0; 2]; 3]);
    assert_eq!(forces.modal, vec![vec![0.0; 2]; 2]);
    forces.modal[0] = vec![1.0, 2.0];
    forces.push_first_mode(&place(&zones, 30.0, -0.5), &state, |z| 3.0 * z);
    assert!((forces.modal[0][0] + 0.2).abs() < 1e-12 && (forces.modal[0][1] - 4.4).abs() < 1e-12);
    assert_eq!(forces.modal[1], [0.0; 2]);
    // a rigid wing has no mode, and without heights there is nothing to go by
    let before = forces.clone();
    forces.push_first_mode(&place(&zones, 30.0, 0.0), &state, |z| 3.0 * z);
    forces
        .push_first_mode(&place(&zones, 30.0, 1.0), &WingState { outer_height_m: &[], ..state }, |z| 3.0 * z);
    assert_eq!(forces, before);
    let nobody = inputs(0);
    assert!(WingState { inputs: &nobody, ..state }.is_empty());
}

#[test]
fn readings_change_by_channel_sample_and_themselves() {
    let mut loads = Loads { balance: [vec![1.0, 2.0], vec![3.0, 4.0], vec![5.0, 6.0]], tip_m: vec![0.1; 2] };
    loads.add_to_readings(&[0.5, 10.0], |p, i, value| p * value + 100.0 * i as f64);
    assert_eq!(loads.balance, [vec![1.5, 103.0], vec![33.0, 144.0], vec![5.0, 6.0]]);
    assert_eq!(loads.tip_m, [0.1; 2]);
}
