//! A model of first order and one of second, in closed form.

use super::*;
use crate::growth::growing;

/// x' = -a x + inputs, y = c x + d u.
fn model(a: Mat<f64>) -> RigModel {
    let (n, inputs) = (a.nrows(), Inputs::new(2));
    RigModel {
        b: Mat::from_fn(n, 8, |i, k| 0.3 + i as f64 - 0.1 * k as f64),
        c: Mat::from_fn(6, n, |i, j| 1.0 + i as f64 + 2.0 * j as f64),
        d: Mat::from_fn(6, 8, |i, k| ((3 * i + 5 * k) as f64).sin()),
        a,
        inputs,
        controls: vec!["in".into(), "out".into()],
        sensors: vec!["tip".into()],
        loads: ["Fz_N", "Mx_Nm", "My_Nm", "Fz_strip_N"].map(String::from).to_vec(),
        flow: Flow { v_m_s: 20.0, rho_kg_m3: 1.2 },
        gravity_m_s2: 9.81,
        cutoff_hz: 25.0,
    }
}

fn first_order() -> RigModel {
    model(Mat::from_fn(1, 1, |_, _| -4.0))
}

#[test]
fn a_response_is_that_of_its_partial_fraction_and_pitch_brings_rates_and_gravity() {
    let model = first_order();
    let w = 3.0;
    let h = |i: usize, k: usize| model.c[(i, 0)] * model.b[(0, k)] / c64::new(4.0, w) + model.d[(i, k)];
    let (by_input, response) = (model.transfer(w), model.frequency_response(w));
    assert_eq!((response.nrows(), response.ncols()), (6, 3));
    for i in 0..6 {
        assert!((0..8).all(|k| (by_input[(i, k)] - h(i, k)).norm() < 1e-12));
        let pitch = h(i, 1) + c64::new(0.0, w) * h(i, 2) - w * w * h(i, 3) + 9.81 * h(i, 4);
        assert!((response[(i, 0)] - pitch).norm() < 1e-12);
        assert!((response[(i, 1)] - h(i, 6)).norm() < 1e-12 && (response[(i, 2)] - h(i, 7)).norm() < 1e-12);
    }
    let at_once = self::model(Mat::zeros(0, 0));
    assert!(at_once.equilibrium(&[1.0; 8]).is_empty() && at_once.transfer(w)[(2, 3)].re == at_once.d[(2, 3)]);
    let u = [1.0, 0.2, 0.0, 0.0, 2.0, 9.0, 0.1, -0.3];
    let forced: f64 = u.iter().enumerate().map(|(k, u)| model.b[(0, k)] * u).sum();
    assert!((model.equilibrium(&u)[0] - forced / 4.0).abs() < 1e-12);
}

#[test]
fn a_run_begins_at_rest_and_answers_a_ramp_of_a_control_as_a_first_order_does() {
    let model = first_order();
    let (dt, samples, alpha) = (0.1, 8, 0.2);
    let constant = |value: f64| vec![value; samples];
    let ramp: Vec<f64> = (0..samples).map(|k| 0.05 * k as f64).collect();
    let motion = Motion {
        time_step_s: dt,
        // derivatives of the first sample are not looked at
        alpha: Smooth {
            value: constant(alpha),
            rate: [&[7.0][..], &[0.0; 7]].concat(),
            second: [&[-5.0][..], &[0.0; 7]].concat(),
        },
        controls_rad: vec![constant(0.1), ramp.clone()],
    };
    let history = model.fly(&motion);
    let u = [1.0, alpha, 0.0, 0.0, 9.81 * alpha.sin(), 9.81 * alpha.cos(), 0.1, 0.0];
    let x = model.equilibrium(&u)[0];
    let names = ["Fz_N", "Mx_Nm", "My_Nm", "Fz_strip_N", "tip_z_m", "az_tip_m_s2"];
    for (row, name) in names.into_iter().enumerate() {
        let rest: f64 = model.c[(row, 0)] * x + (0..8).map(|k| model.d[(row, k)] * u[k]).sum::<f64>();
        for (k, value) in history.get(name).expect("a channel").iter().enumerate() {
            let t = dt * k as f64;
            let lagged = 0.5 * model.b[(0, 7)] * (t / 4.0 - (1.0 - (-4.0 * t).exp()) / 16.0);
            let wanted = rest + model.c[(row, 0)] * lagged + model.d[(row, 7)] * ramp[k];
            assert!((value - wanted).abs() < 1e-11, "{name} {k}: {value} {wanted}");
        }
    }
    let order: Vec<&str> = history.channels.iter().map(|channel| channel.name.as_str()).collect();
    let loads =
        ["Fz_N", "Mx_Nm", "My_Nm", "delta_in_deg", "delta_out_deg", "tip_z_m", "az_tip_m_s2", "Fz_strip_N"];
    assert_eq!(order, [&["V_m_s", "alpha_deg"][..], &loads].concat());
    let value = |name: &str| history.get(name).expect("a channel")[3];
    assert!((value("alpha_deg") - alpha.to_degrees()).abs() < 1e-12 && value("V_m_s") == 20.0);
    assert!(
        (value("delta_out_deg") - 0.15_f64.to_degrees()).abs() < 1e-12
            && (history.t_s[3] - 0.3).abs() < 1e-12
    );
    let short = model.fly(&Motion { controls_rad: vec![constant(0.1)], ..motion });
    assert_eq!(short.get("delta_out_deg"), Some(&constant(0.0)[..]));
    assert!((model.inputs.len(), model.inputs.is_empty()) == (8, false));
}

#[test]
fn what_grows_is_told_with_its_rate_and_frequency() {
    let swinging = |rate: f64| {
        model(Mat::from_fn(3, 3, |i, j| [[rate, 6.0, 0.0], [-6.0, rate, 0.0], [0.0, 0.0, -9.0]][i][j]))
    };
    assert_eq!((growing(&swinging(-0.1)), growing(&swinging(0.0))), (None, None));
    let found = growing(&swinging(0.2)).expect("a growing motion");
    assert!(
        (found.growth_per_s - 0.2).abs() < 1e-9
            && (found.frequency_hz - 6.0 / std::f64::consts::TAU).abs() < 1e-9
    );
    let straight = growing(&model(Mat::from_fn(1, 1, |_, _| 0.5))).expect("a growing motion");
    assert_eq!((straight.frequency_hz, straight.growth_per_s), (0.0, 0.5));
}
