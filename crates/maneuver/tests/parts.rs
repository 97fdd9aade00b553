//! Exact stepping, smoothing and signals against closed forms.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use faer::Mat;
use maneuver::motion::{About, Chirp, Doublet, OneMinusCosine, Signal, Step, ThreeTwoOneOne, sampled};
use maneuver::step::{ExactStep, exponential};
use maneuver::{Run, smooth_from_rest, zero_phase};
use std::cmp::Ordering;
use std::f64::consts::TAU;

#[test]
fn the_exponential_of_a_rotation_is_a_rotation() {
    let angle = 37.0;
    let turn = Mat::from_fn(2, 2, |i, j| match i.cmp(&j) {
        Ordering::Equal => 0.0,
        Ordering::Less => angle,
        Ordering::Greater => -angle,
    });
    let e = exponential(turn.as_ref());
    for (i, j, expected) in
        [(0, 0, angle.cos()), (0, 1, angle.sin()), (1, 0, -angle.sin()), (1, 1, angle.cos())]
    {
        assert!((e[(i, j)] - expected).abs() < 1e-12, "{i} {j}");
    }
}

#[test]
fn a_damped_oscillator_answers_a_ramp_exactly_at_any_step() {
    // x'' + 2 z w x' + w² x = w² t from rest: x = t - 2z/w + e^(-z w t) (2z/w cos wd t + (2z²-1)/wd sin wd t)
    let (w, z) = (30.0, 0.1_f64);
    let a = Mat::from_fn(2, 2, |i, j| [[0.0, 1.0], [-w * w, -2.0 * z * w]][i][j]);
    let b = Mat::from_fn(2, 1, |i, _| [0.0, w * w][i]);
    for h in [0.001, 0.05, 0.5] {
        let ramp = Mat::from_fn(1, 20, |_, i| i as f64 * h);
        let x = ExactStep::new(a.as_ref(), b.as_ref(), h).run(&[0.0, 0.0], ramp.as_ref());
        let wd = w * (1.0 - z * z).sqrt();
        for i in 0..20 {
            let t = i as f64 * h;
            let swing = 2.0 * z / w * (wd * t).cos() + (2.0 * z * z - 1.0) / wd * (wd * t).sin();
            let exact = t - 2.0 * z / w + (-z * w * t).exp() * swing;
            assert!((x[(0, i)] - exact).abs() < 1e-12, "{h} {t}");
        }
    }
}

#[test]
fn outputs_block_by_block_are_those_of_all_states_step_by_step() {
    let (states, inputs, outputs) = (5, 2, 3);
    let number = |i: usize, j: usize| ((7 * i + 3 * j) as f64).sin();
    let a = Mat::from_fn(states, states, |i, j| number(i, j) - if i == j { 4.0 } else { 0.0 });
    let b = Mat::from_fn(states, inputs, |i, j| number(i + 2, j));
    let c = Mat::from_fn(outputs, states, |i, j| number(i, j + 9));
    let d = Mat::from_fn(outputs, inputs, |i, j| number(i + 1, j + 4));
    let step = ExactStep::new(a.as_ref(), b.as_ref(), 0.02);
    let x0 = [0.3, -0.2, 0.5, 0.1, 0.7];
    for samples in [1, 2, 31, 32, 33, 64, 1000] {
        let u = Mat::from_fn(inputs, samples, |i, k| number(i + 5, k));
        let x = step.run(&x0, u.as_ref());
        let expected = &c * &x + &d * &u;
        let got = step.outputs(&x0, u.as_ref(), c.as_ref(), d.as_ref());
        assert_eq!((got.nrows(), got.ncols()), (outputs, samples));
        let apart = (&got - &expected).norm_max();
        assert!(apart < 1e-12, "{samples} samples: {apart:e}");
    }
}

#[test]
fn signals_are_what_their_formulas_say() {
    let bump = About(1.3, OneMinusCosine::new(3.7, 2.0, 0.5));
    assert_eq!(bump.at(0.0), 1.3);
    assert!((bump.at(0.75) - 5.0).abs() < 1e-12);
    let doublet = Doublet { height: 2.0, frequency_hz: 5.0, start_s: 1.0 };
    assert_eq!([0.99, 1.05, 1.15, 1.25].map(|t| doublet.at(t)), [0.0, 2.0, -2.0, 0.0]);
    assert_eq!([0.0, 1.0].map(|t| Step { height: 1.0, start_s: 0.5 }.at(t)), [0.0, 1.0]);
    let steps = ThreeTwoOneOne { height: 1.0, unit_s: 1.0, start_s: 0.0 };
    assert_eq!(sampled(&steps, 1.0, 8), [1.0, 1.0, 1.0, -1.0, -1.0, 1.0, -1.0, 0.0]);
    for signal in [
        &bump as &dyn Signal,
        &Chirp { height: 1.0, from_hz: 0.0, to_hz: 10.0, duration_s: 30.0, start_s: 0.0 },
    ] {
        let (t, e) = (0.83, 1e-5);
        assert!((signal.rate(t) - (signal.at(t + e) - signal.at(t - e)) / (2.0 * e)).abs() < 1e-5);
        assert!((signal.second(t) - (signal.rate(t + e) - signal.rate(t - e)) / (2.0 * e)).abs() < 1e-4);
    }
}

#[test]
fn s45_the_chirp_passes_the_first_bending_near_the_middle() {
    let chirp = Chirp { height: 0.09, from_hz: 0.0, to_hz: 10.0, duration_s: 30.0, start_s: 0.0 };
    assert_eq!(chirp.frequency_hz(15.0), 5.0);
    assert!((chirp.frequency_hz(13.68) - 4.56).abs() < 1e-12);
}

#[test]
fn s35_reduced_frequencies_of_the_pitch_runs() {
    // published: 0.0118, 0.0471, 0.0943 for 0.5, 2 and 4 Hz at 30 m/s with the mean chord of 0.225 m
    for (f_hz, k) in [(0.5, 0.0118), (2.0, 0.0471), (4.0, 0.0943)] {
        let flow = aero::Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };
        let reduced = TAU * f_hz * 0.225 / (2.0 * flow.v_m_s);
        // printed with three digits; the last, 0.09425, was rounded twice
        assert!((reduced - k).abs() < 5.3e-5, "{reduced}");
    }
}

#[test]
fn the_smoother_is_three_decibels_down_at_its_cutoff_and_has_no_phase() {
    let (h, f) = (0.005, 10.0);
    let wave: Vec<f64> = (0..2000).map(|i| (TAU * f * f64::from(i) * h).sin()).collect();
    let amplitude = |cutoff_hz: f64| {
        let smooth = zero_phase(&wave, h, cutoff_hz);
        let project = |shift: f64| -> f64 {
            let of = |i: usize| smooth[i] * (TAU * f * i as f64 * h + shift).sin();
            (600..1400).map(of).sum::<f64>() / 400.0
        };
        (project(0.0), project(std::f64::consts::FRAC_PI_2))
    };
    let (at_cutoff, quadrature) = amplitude(f);
    assert!((at_cutoff - std::f64::consts::FRAC_1_SQRT_2).abs() < 1e-6, "{at_cutoff}");
    assert!(quadrature.abs() < 1e-6);
    assert!(amplitude(25.0).0 > 0.995 && amplitude(4.0).0 < 0.01);
}

#[test]
fn smoothing_a_noisy_angle_leaves_what_its_filter_lets_through() {
    // 2 Hz one-minus-cosine with 0.01 degrees of noise at 200 Hz. The noise left on the second derivative is
    // s/h² sqrt(1/pi integral of w⁴ H(w)²), H of the module: differencing the raw signal would leave s/h² sqrt(6).
    let (h, count, sigma) = (0.005, 400, 0.01);
    let signal = About(1.3, OneMinusCosine::new(3.7, 2.0, 0.5));
    let draw = |k: usize| {
        let x = (k as f64 * 12.9898).sin() * 43_758.545_3;
        (x - x.floor() - 0.5) * 12.0_f64.sqrt()
    };
    let measured: Vec<f64> = (0..count).map(|i| signal.at(i as f64 * h) + sigma * draw(i)).collect();
    let smooth = smooth_from_rest(&measured, h, 25.0);
    let range = 40..360;
    let error = |i: usize| (smooth.second[i] - signal.second(i as f64 * h)).powi(2);
    let corners = |i: &usize| (i.abs_diff(100) > 12) && (i.abs_diff(200) > 12);
    let kept: Vec<usize> = range.filter(corners).collect();
    let rms = (kept.iter().map(|&i| error(i)).sum::<f64>() / kept.len() as f64).sqrt();
    let cut = TAU * 25.0 * h;
    let lambda = (2.0_f64.sqrt() - 1.0) / (2.0 - 2.0 * cut.cos()).powi(3);
    let steps = 4000;
    let through: f64 = (0..steps)
        .map(|k| {
            let w = std::f64::consts::PI * (f64::from(k) + 0.5) / f64::from(steps);
            w.powi(4) / (1.0 + lambda * (2.0 - 2.0 * w.cos()).powi(3)).powi(2) / f64::from(steps)
        })
        .sum();
    let expected = sigma / (h * h) * through.sqrt();
    assert!((rms / expected - 1.0).abs() < 0.3, "{rms} {expected}");
    assert!(expected < 0.1 * sigma / (h * h) * 6.0_f64.sqrt());
    assert_eq!((smooth.rate[0], smooth.second[0]), (0.0, 0.0));
}

#[test]
fn below_thirteen_hertz_the_second_derivative_of_a_noisy_angle_is_good_to_five_per_cent_of_its_peak() {
    // the same signal and noise; noise on the second derivative grows with the cutoff to the power 5/2, so at 25 Hz
    // (a quarter of the peak) it is what the filter must let through. The corners, where the second derivative
    // jumps, belong to no smooth curve.
    let (h, count, sigma) = (0.005, 400, 0.01);
    let signal = About(1.3, OneMinusCosine::new(3.7, 2.0, 0.5));
    let draw = |k: usize| {
        let x = (k as f64 * 12.9898).sin() * 43_758.545_3;
        (x - x.floor() - 0.5) * 12.0_f64.sqrt()
    };
    let measured: Vec<f64> = (0..count).map(|i| signal.at(i as f64 * h) + sigma * draw(i)).collect();
    let kept: Vec<usize> = (40..360_usize).filter(|i| i.abs_diff(100) > 12 && i.abs_diff(200) > 12).collect();
    let peak = 0.5 * 3.7 * (TAU * 2.0).powi(2);
    let share = |cutoff_hz: f64| {
        let smooth = smooth_from_rest(&measured, h, cutoff_hz);
        let square = |i: &usize| (smooth.second[*i] - signal.second(*i as f64 * h)).powi(2);
        (kept.iter().map(square).sum::<f64>() / kept.len() as f64).sqrt() / peak
    };
    for cutoff_hz in [8.0, 10.0, 12.0] {
        assert!(share(cutoff_hz) < 0.05, "{cutoff_hz} Hz: {}", share(cutoff_hz));
    }
}

fn run(name: &str, text: &str) -> Result<Run, nastran::InputError> {
    let folder = std::env::temp_dir().join(format!("wingroot-run-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("run.csv");
    std::fs::write(&path, text).unwrap();
    let result = Run::read(&path);
    std::fs::remove_dir_all(&folder).unwrap();
    result
}

#[test]
fn a_run_with_a_changing_time_step_is_refused_at_its_line() {
    let text = "t_s,V_m_s,alpha_deg\n0,30,1\n0.005,30,1\n0.010,30,1\n0.016,30,1\n";
    let message = run("step", text).unwrap_err().to_string();
    assert!(
        message.contains("run.csv:5:1: the time step changes from 0.005000 s to 0.006000 s"),
        "{message}"
    );
}

#[test]
fn a_misspelt_column_and_a_changing_airspeed_are_refused() {
    let misspelt = run("column", "t_s,V_m_s,alpha_deg,dleta_inner_deg\n0,30,1,0\n0.01,30,1,0\n0.02,30,1,0\n")
        .unwrap_err();
    assert!(misspelt.to_string().contains("run.csv:1:21"), "{misspelt}");
    let windy = run("wind", "t_s,V_m_s,alpha_deg\n0,30,1\n0.01,30,1\n0.02,33,1\n").unwrap_err();
    assert!(windy.to_string().contains("2 %"), "{windy}");
}

#[test]
fn a_history_is_written_with_its_channels() {
    let mut history = maneuver::TimeHistory { t_s: vec![0.0, 0.1], channels: Vec::new() };
    history.push("Fz_N", vec![1.0, -2.5]);
    assert_eq!(history.to_csv(), "t_s,Fz_N\n0,1\n0.1,-2.5\n");
}
