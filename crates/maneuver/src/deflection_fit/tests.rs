//! The sums of the fit by hand, and a fit whose model only multiplies.

use super::*;
use crate::rig_model::Inputs;
use aero::Flow;
use faer::Mat;

fn channel(x: &[f64], y: &[f64]) -> Channel {
    Channel { x: x.to_vec(), y: y.to_vec() }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-10 * b.abs().max(1.0)
}

#[test]
fn the_scale_is_the_weighted_least_squares_one() {
    let channels = [
        channel(&[1.0, 2.0], &[2.0, 1.0]),
        channel(&[0.0, 3.0], &[5.0, 4.0]),
        channel(&[-1.0, 1.0], &[1.0, 3.0]),
    ];
    // x y: 4, 12, 2; x x: 5, 9, 2
    let (factor, information) = scale(&channels, [2.0, 0.5, 3.0]);
    assert!(near(information, 20.5) && near(factor, 20.0 / 20.5), "{factor} {information}");
    assert!(near(channels[0].squares(0.5), 1.5_f64.powi(2)));
    assert_eq!((centred(vec![1.0, 2.0, 6.0]), centred(Vec::new())), (vec![-2.0, -1.0, 3.0], Vec::new()));
    assert_eq!(dot(&[1.0, 2.0, 3.0], &[4.0, -5.0, 6.0]), 12.0);
}

#[test]
fn without_declared_noise_channels_weigh_by_what_is_left_of_them() {
    // y = 0.7 x + e with e across x: whatever the first weights, e is left
    let x = [1.0, -1.0, 1.0, -1.0];
    let with =
        |size: f64| x.iter().zip([1.0, 1.0, -1.0, -1.0]).map(|(x, e)| 0.7 * x + size * e).collect::<Vec<_>>();
    let channels = [channel(&x, &with(0.5)), channel(&x, &with(2.0)), channel(&x, &with(0.1))];
    for (weight, wanted) in residual_weights(&channels).into_iter().zip([4.0, 0.25, 100.0]) {
        assert!(near(weight, wanted), "{weight} {wanted}");
    }
    let nothing = || channel(&[0.0; 4], &[0.0; 4]);
    assert!(near(residual_weights(&[channel(&x, &with(0.5)), nothing(), nothing()])[1], 1.0));
}

#[test]
fn scores_count_with_falling_weights_up_to_the_lag() {
    let ones = [1.0; 4];
    let zero = || channel(&[0.0; 4], &[0.0; 4]);
    let of =
        |lag: f64| bartlett(&[channel(&ones, &[1.0, 2.0, 3.0, 4.0]), zero(), zero()], [1.0; 3], 0.0, lag);
    // products at the distances 0, 1, 2, 3: 30, 20, 11, 4
    assert!(near(of(0.5), 30.0) && near(of(1.0), 30.0) && near(of(2.0), 50.0));
    assert!(near(of(2.5), 30.0 + 1.2 * 20.0 + 0.4 * 11.0));
    assert!(near(of(9.0), 30.0 + 2.0 * (8.0 * 20.0 + 7.0 * 11.0 + 6.0 * 4.0) / 9.0));
    // scores: 2 (1) (3 - .5), 3 (2) (1 - 1), 5 (-1) (2 + .5)
    let three = [channel(&[1.0], &[3.0]), channel(&[2.0], &[1.0]), channel(&[-1.0], &[2.0])];
    assert!(near(bartlett(&three, [2.0, 3.0, 5.0], 0.5, 1.0), (5.0_f64 - 12.5).powi(2)));
}

fn fit(control: &str, [v_m_s, commanded_rad, factor, standard_error, information]: [f64; 5]) -> DoubletFit {
    DoubletFit {
        doublet: MeasuredDoublet { control: control.into(), commanded_rad },
        v_m_s,
        factor,
        standard_error,
        noise_error: None,
        gap: None,
        information,
    }
}

#[test]
fn repeats_are_pooled_by_information_and_their_scatter_is_believed_where_it_is_larger() {
    let both = [fit("a", [20.0, 0.1, 1.0, 0.1, 1.0]), fit("a", [20.2, 0.101, 1.2, 0.05, 3.0])];
    let scattered = pool(&[&both[0], &both[1]]);
    assert!(
        near(scattered.factor, 1.15) && near(scattered.v_m_s, 20.1) && near(scattered.commanded_rad, 0.1005)
    );
    assert!(near(scattered.standard_error, 0.075) && scattered.runs == 2, "{scattered:?}");
    let unsure = [fit("a", [20.0, 0.1, 1.0, 0.4, 1.0]), fit("a", [20.0, 0.1, 1.2, 0.2, 3.0])];
    assert!(near(pool(&[&unsure[0], &unsure[1]]).standard_error, (0.16_f64 + 0.36).sqrt() / 4.0));
    let alone = pool(&[&both[1]]);
    assert!(near(alone.standard_error, 0.05) && near(alone.factor, 1.2) && alone.runs == 1);
}

#[test]
fn groups_are_of_one_surface_airspeed_and_deflection_and_in_their_order() {
    let fits = [
        fit("b", [30.0, 0.2, 0.9, 0.1, 1.0]),
        fit("a", [30.0, 0.1, 0.8, 0.1, 1.0]),
        fit("b", [20.0, 0.2, 0.7, 0.1, 1.0]),
        fit("b", [30.0, 0.1, 0.6, 0.1, 1.0]),
        fit("b", [30.0, 0.1019, 0.5, 0.1, 1.0]),
        fit("b", [30.0, 0.1030, 0.4, 0.1, 1.0]),
    ];
    let all = pooled(&fits);
    let said: Vec<(&str, f64, usize)> = all.iter().map(|f| (f.control.as_str(), f.v_m_s, f.runs)).collect();
    assert_eq!(said, [("b", 20.0, 1), ("b", 30.0, 2), ("b", 30.0, 1), ("b", 30.0, 1), ("a", 30.0, 1)]);
    assert!(near(all[1].factor, 0.55) && near(all[2].factor, 0.4) && near(all[3].factor, 0.9), "{all:?}");
    assert_eq!(all[1].control, "b");
}

#[test]
fn tables_take_factors_from_zero_to_five_and_gather_rows_by_airspeed() {
    let of = |control: &str, v_m_s: f64, degrees: f64, factor: f64| FittedFactor {
        control: control.into(),
        v_m_s,
        commanded_rad: degrees.to_radians(),
        factor,
        standard_error: 0.1,
        runs: 1,
    };
    for factor in [-0.001, 5.001, f64::NAN] {
        let said = tables(&[of("a", 20.0, 4.0, factor)]).expect_err("no factor").to_string();
        assert!(said.contains("of a at 20.0 m/s and 4.0 degrees"), "{said}");
    }
    let list = [
        of("a", 20.000_4, 4.0, 0.5),
        of("a", 20.000_4, 8.0, 5.0),
        of("a", 30.0, 4.0, 0.0),
        of("b", 30.0, 2.0, 1.234_567_8),
    ];
    let all = tables(&list).expect("factors that can be");
    assert_eq!((all.len(), all[0].rows.len(), all[1].rows.len()), (2, 2, 1));
    assert_eq!((all[0].control.as_str(), all[1].control.as_str(), all[0].odd), ("a", "b", true));
    assert_eq!((all[0].rows[0].v_m_s, &all[0].rows[0].commanded_deg), (20.0, &vec![4.0, 8.0]));
    assert_eq!(all[0].rows[0].equivalent_deg, Some(vec![2.0, 40.0]));
    assert_eq!(all[1].rows[0].equivalent_deg, Some(vec![2.46914]));
}

#[test]
fn the_gap_is_a_root_mean_square_over_sigma_and_noise_leaves_what_the_filter_lets_through() {
    let runs = [(2, ByLoad { fz: 1.0, mx: 2.0, my: 3.0 }), (3, ByLoad { fz: 2.0, mx: 2.0, my: 2.0 })];
    let sigma = ByLoad { fz: 1.0, mx: 2.0, my: 4.0 };
    let squares = 2.0 * (1.0 + 1.0 + 0.5625) + 3.0 * (4.0 + 1.0 + 0.25);
    assert!(near(gap(&runs, sigma), (squares / 15.0_f64).sqrt()) && gap(&[], sigma) == 0.0);
    // Parseval: the mean over frequencies of the filter's square
    let (dt, cutoff) = (0.005, 20.0);
    let power = |w: f64| (2.0 - 2.0 * w.cos()).powi(3);
    let lambda = (2.0_f64.sqrt() - 1.0) / power(std::f64::consts::TAU * dt * cutoff);
    let count = 2000;
    let mean = (0..count)
        .map(|k| {
            (1.0 + lambda * power(std::f64::consts::PI * (f64::from(k) + 0.5) / f64::from(count))).powi(-2)
        })
        .sum::<f64>()
        / f64::from(count);
    assert!((noise_gap(dt, cutoff) - mean.sqrt()).abs() < 1e-9);
    assert!(near(noise_gap(0.5, 1.0), 1.0));
}

/// A run in which `a` does a doublet of .1 rad, and a model that gives its loads at once by the deflection.
fn flown() -> (Run, RigModel) {
    let samples = 40;
    let delta: Vec<f64> = (0..samples).map(|k| [0.0, 0.1, -0.1, 0.0][k / 10]).collect();
    let by = [50.0, -20.0, 8.0];
    let trim = [3.0, 1.0, -2.0];
    let error = |k: usize| [0.2, -0.2][(k / 5) % 2];
    let load =
        |c: usize| (0..samples).map(|k| trim[c] + 0.8 * by[c] * delta[k] + error(k)).collect::<Vec<f64>>();
    let inputs = Inputs::new(2);
    let d = Mat::from_fn(4, inputs.len(), |row, k| match (row, k) {
        (row, 6) if row < 3 => by[row],
        (row, 1) => 2.0 + row as f64,
        (row, 0) => 0.3 * row as f64,
        _ => 0.0,
    });
    let model = RigModel {
        a: Mat::zeros(0, 0),
        b: Mat::zeros(0, inputs.len()),
        c: Mat::zeros(4, 0),
        d,
        inputs,
        controls: vec!["a".into(), "b".into()],
        sensors: Vec::new(),
        loads: ["Fz_N", "Mx_Nm", "My_Nm"].map(String::from).to_vec(),
        flow: Flow { v_m_s: 20.0, rho_kg_m3: 1.2 },
        gravity_m_s2: 9.81,
        cutoff_hz: 60.0,
    };
    let run = Run {
        name: "run".into(),
        t_s: (0..samples).map(|k| 0.01 * k as f64).collect(),
        time_step_s: 0.01,
        v_m_s: 20.0,
        alpha_rad: vec![0.02; samples],
        loads: Some([load(0), load(1), load(2)]),
        some_loads: [None, None, None],
        controls_rad: vec![("b".into(), vec![0.0; samples]), ("a".into(), delta)],
        tip_z_m: None,
        accelerations: Vec::new(),
    };
    (run, model)
}

#[test]
fn a_model_that_multiplies_is_scaled_back_with_the_error_of_a_regression() {
    let (run, model) = flown();
    let sigma = ByLoad { fz: 0.5, mx: 0.25, my: 0.1 };
    let fit = fit_doublet(&run, &model, Some(sigma), Path::new("run.csv")).expect("a doublet");
    // the error goes up and down twice in each half: across the doublet
    assert!(near(fit.factor, 0.8) && fit.v_m_s == 20.0, "{fit:?}");
    assert_eq!((fit.doublet.control.as_str(), fit.doublet.commanded_rad), ("a", 0.1));
    let weights = [4.0, 16.0, 100.0];
    let information: f64 =
        weights.iter().zip([50.0, -20.0, 8.0]).map(|(w, x): (&f64, f64)| w * 0.2 * x * x).sum();
    assert!(near(fit.information / information, 1.0), "{}", fit.information);
    let noise = fit.noise_error.expect("declared noise");
    assert!(near(noise * information.sqrt(), 1.0), "{noise}");
    assert!(fit.standard_error >= noise);
    let [before, after] = fit.gap.expect("declared noise");
    let errors: f64 = weights.iter().map(|w| w * 0.04 * 40.0).sum();
    assert!(
        near(after, (errors / 120.0).sqrt()) && near(before, ((errors + 0.04 * information) / 120.0).sqrt())
    );
    let alone = fit_doublet(&run, &model, None, Path::new("run.csv")).expect("a doublet");
    assert!(near(alone.factor, 0.8) && alone.noise_error.is_none() && alone.gap.is_none());
    let simulated = model.fly(&motion_of(&run, &model, Path::new("run.csv")).expect("controls"));
    let rms = change_rms(&run, &simulated, 60.0).expect("loads");
    for (load, by) in Load::ALL.into_iter().zip([50.0, -20.0, 8.0]) {
        assert!(near(rms[load], (0.04 + 0.04 * by * by * 0.005_f64).sqrt()), "{rms:?}");
    }
}

#[test]
fn other_runs_are_no_doublets_and_are_refused() {
    let (run, model) = flown();
    let refused =
        |run: &Run| fit_doublet(run, &model, None, Path::new("run.csv")).expect_err("no fit").to_string();
    assert!(refused(&Run { v_m_s: 0.0, ..run.clone() }).contains("no doublet"));
    assert!(refused(&Run { loads: None, ..run.clone() }).contains("no measured loads"));
    let moved = |name: &str| ((name.to_owned()), run.controls_rad[1].1.clone());
    assert!(
        refused(&Run { controls_rad: vec![moved("a"), moved("b")], ..run.clone() }).contains("no doublet")
    );
    assert!(refused(&Run { controls_rad: vec![moved("b")], ..run.clone() }).contains("does nothing"));
    let step = Run { controls_rad: vec![("a".into(), vec![0.1; 40])], ..run };
    assert!(doublet_of(&step).is_none());
}
