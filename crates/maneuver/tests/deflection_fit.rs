//! Planted deflection corrections come back from noisy doublets, with errors as large as they say.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{Corrections, Flow};
use coupling::ByLoad;
use coupling::wing_file::{DeflectionRow, DeflectionTable, OutsideAirspeeds};
use maneuver::deflection_fit::{DoubletFit, doublet_of, fit_doublet, noise_gap, pooled, tables};
use maneuver::motion::{Chirp, Doublet, Signal, sampled};
use maneuver::{
    DeflectionAt, DeflectionCorrection, Motion, Rig, RigModel, RigSettings, Run, Smooth, fly_commanded,
};
use std::path::Path;

const SIGMA: ByLoad<f64> = ByLoad { fz: 0.2, mx: 0.12, my: 0.05 };
const TIME_STEP_S: f64 = 0.005;
const SAMPLES: usize = 601;

/// Normal numbers from a fixed seed: the middle bits of a multiplicative congruence (Knuth's MMIX), Box and Muller.
struct Normal(u64);

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as f64 + 0.5) / f64::from(1_u32 << 31)
    }

    fn next(&mut self, sigma: f64) -> f64 {
        sigma * (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

/// Three ailerons at two airspeeds: two that saturate, one whose factor first rises above one.
fn planted() -> Vec<DeflectionTable> {
    let row = |v_m_s: f64, factor: [f64; 3]| DeflectionRow {
        v_m_s,
        commanded_deg: vec![5.0, 15.0, 25.0],
        equivalent_deg: None,
        factor: Some(factor.to_vec()),
    };
    let table = |control: &str, slow: [f64; 3], fast: [f64; 3]| DeflectionTable {
        control: control.to_owned(),
        odd: true,
        outside: OutsideAirspeeds::Refuse,
        rows: vec![row(18.0, slow), row(30.0, fast)],
    };
    vec![
        table("inner", [0.99, 0.91, 0.74], [0.97, 0.86, 0.68]),
        table("middle", [1.0, 0.93, 0.79], [0.98, 0.9, 0.72]),
        table("outer", [1.22, 1.05, 0.86], [1.15, 0.98, 0.81]),
    ]
}

fn model(wing: &coupling::ElasticWing, file: &coupling::WingFile, v_m_s: f64) -> RigModel {
    let rig = Rig::new(wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    rig.at(Flow { v_m_s, rho_kg_m3: 1.225 }, &crate::common::uneven(wing)).unwrap()
}

/// A run as measured: the planted correction, noise, and a day's offset that no model has.
fn measured(
    model: &RigModel,
    correction: &DeflectionAt,
    control: &str,
    signal: &dyn Signal,
    noise: &mut Normal,
) -> Run {
    let commanded = sampled(signal, TIME_STEP_S, SAMPLES);
    let place = model.controls.iter().position(|name| name == control).unwrap();
    let mut controls_rad = vec![vec![0.0; SAMPLES]; model.controls.len()];
    controls_rad[place].clone_from(&commanded);
    let still = vec![0.0; SAMPLES];
    let alpha = Smooth { value: vec![1.3_f64.to_radians(); SAMPLES], rate: still.clone(), second: still };
    let history = fly_commanded(model, &Motion { time_step_s: TIME_STEP_S, alpha, controls_rad }, correction);
    let loads = std::array::from_fn(|c| {
        let clean = history.get(["Fz_N", "Mx_Nm", "My_Nm"][c]).unwrap();
        clean.iter().map(|value| value + 0.08 + noise.next(SIGMA.to_array()[c])).collect()
    });
    Run {
        name: control.to_owned(),
        t_s: history.t_s,
        time_step_s: TIME_STEP_S,
        v_m_s: model.flow.v_m_s,
        alpha_rad: vec![1.3_f64.to_radians(); SAMPLES],
        loads: Some(loads),
        some_loads: [None, None, None],
        controls_rad: vec![(control.to_owned(), commanded)],
        tip_z_m: None,
        accelerations: Vec::new(),
    }
}

fn doublet(degrees: f64) -> Doublet {
    Doublet { height: degrees.to_radians(), frequency_hz: 1.0, start_s: 0.5 }
}

#[test]
fn planted_corrections_come_back_within_three_standard_errors_and_two_percent() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let truth = planted();
    let correction = DeflectionCorrection::new(truth.clone());
    let mut noise = Normal(7);
    let mut fits: Vec<DoubletFit> = Vec::new();
    for v_m_s in [18.0, 30.0] {
        let model = model(&wing, &file, v_m_s);
        for control in ["inner", "middle", "outer"] {
            for degrees in [5.0, 15.0, 25.0] {
                let run =
                    measured(&model, &correction.at(v_m_s).unwrap(), control, &doublet(degrees), &mut noise);
                fits.push(fit_doublet(&run, &model, Some(SIGMA), Path::new("run.csv")).unwrap());
            }
        }
    }
    let found = tables(&pooled(&fits)).unwrap();
    assert_eq!(found.len(), 3);
    let mut fit = fits.iter();
    for v in 0..2 {
        for (found, truth) in found.iter().zip(&truth) {
            assert_eq!((found.control.as_str(), found.rows.len()), (truth.control.as_str(), 2));
            assert_eq!(found.rows[v].commanded_deg, truth.rows[v].commanded_deg);
            for (k, planted) in found.rows[v].factors().into_iter().zip(truth.rows[v].factors()) {
                let error = fit.next().unwrap().standard_error;
                let off = k - planted;
                // the table has five decimals of a degree
                assert!(
                    off.abs() < 3.0 * error + 1e-5,
                    "{}: {k} for {planted}, error {error}",
                    truth.control
                );
                assert!(off.abs() < 0.02 * planted, "{}: {k} for {planted}", truth.control);
            }
        }
    }
}

#[test]
fn standard_errors_are_as_large_as_the_scatter() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model(&wing, &file, 18.0);
    let correction = DeflectionCorrection::new(planted()).at(18.0).unwrap();
    let mut noise = Normal(11);
    let (mut pulls, mut noise_pulls, mut blind_pulls) = (0.0, 0.0, 0.0);
    let runs = 60;
    for _ in 0..runs {
        let run = measured(&model, &correction, "inner", &doublet(5.0), &mut noise);
        let fit = fit_doublet(&run, &model, Some(SIGMA), Path::new("run.csv")).unwrap();
        let off = fit.factor - 0.99;
        pulls += (off / fit.standard_error).powi(2) / f64::from(runs);
        noise_pulls += (off / fit.noise_error.unwrap()).powi(2) / f64::from(runs);
        // without declared noise: weights and error from the residuals
        let blind = fit_doublet(&run, &model, None, Path::new("run.csv")).unwrap();
        blind_pulls += ((blind.factor - 0.99) / blind.standard_error).powi(2) / f64::from(runs);
        let [before, after] = fit.gap.unwrap();
        assert!(
            after <= before && (after / noise_gap(TIME_STEP_S, 25.0) - 1.0).abs() < 0.1,
            "{before} {after}"
        );
    }
    // chi-square over its 60 degrees of freedom: mean 1, standard deviation sqrt(2/60) = 0.18; three of them
    assert!((noise_pulls - 1.0).abs() < 0.55, "exact for white noise: {noise_pulls}");
    // the larger of two estimates is rather too large than too small
    assert!(pulls < 1.3 && pulls > 0.3, "{pulls}");
    assert!(blind_pulls < 1.9 && blind_pulls > 0.4, "{blind_pulls}");
}

#[test]
fn repeats_are_pooled_and_their_error_shrinks() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model(&wing, &file, 30.0);
    let correction = DeflectionCorrection::new(planted()).at(30.0).unwrap();
    let mut noise = Normal(3);
    let fits: Vec<DoubletFit> = (0..16)
        .map(|_| {
            let run = measured(&model, &correction, "outer", &doublet(15.0), &mut noise);
            fit_doublet(&run, &model, Some(SIGMA), Path::new("run.csv")).unwrap()
        })
        .collect();
    let all = pooled(&fits);
    assert_eq!((all.len(), all[0].runs), (1, 16));
    assert!((all[0].factor - 0.98).abs() < 3.0 * all[0].standard_error);
    let ratio = all[0].standard_error / fits[0].standard_error;
    assert!(ratio > 0.15 && ratio < 0.45, "a quarter, but for scatter: {ratio}");
}

#[test]
fn repeats_that_scatter_more_than_their_errors_say_have_the_standard_error_of_a_mean() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model(&wing, &file, 30.0);
    let factors = [0.80, 0.85, 1.00, 0.95];
    let fits: Vec<DoubletFit> = factors
        .map(|factor| {
            let row = DeflectionRow {
                v_m_s: 30.0,
                commanded_deg: vec![15.0],
                equivalent_deg: None,
                factor: Some(vec![factor]),
            };
            let table = DeflectionTable {
                control: "outer".to_owned(),
                odd: true,
                outside: OutsideAirspeeds::Refuse,
                rows: vec![row],
            };
            let correction = DeflectionCorrection::new(vec![table]).at(30.0).unwrap();
            // hardly any noise: what differs between the runs is the deflection itself
            let noise = &mut Normal(5);
            let mut run = measured(&model, &correction, "outer", &doublet(15.0), noise);
            let clean = fly_commanded(
                &model,
                &maneuver::motion_of(&run, &model, Path::new("run.csv")).unwrap(),
                &correction,
            );
            run.loads = Some(["Fz_N", "Mx_Nm", "My_Nm"].map(|name| clean.get(name).unwrap().to_vec()));
            fit_doublet(&run, &model, Some(SIGMA), Path::new("run.csv")).unwrap()
        })
        .to_vec();
    for (fit, factor) in fits.iter().zip(factors) {
        assert!((fit.factor - factor).abs() < 1e-9 && fit.standard_error < 0.01, "{fit:?}");
    }
    // deviations -.1, -.05, .1, .05 from .9: s² = .025/3, and the mean's standard error is s/sqrt(4)
    let all = pooled(&fits);
    assert!((all[0].factor - 0.9).abs() < 1e-9, "{}", all[0].factor);
    let expected = (0.025_f64 / 3.0 / 4.0).sqrt();
    assert!(
        (all[0].standard_error / expected - 1.0).abs() < 1e-6,
        "{} for {expected}",
        all[0].standard_error
    );
}

#[test]
fn only_doublets_of_one_surface_in_the_wind_are_taken() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model(&wing, &file, 30.0);
    let mut noise = Normal(1);
    let chirp = Chirp { height: 0.1, from_hz: 0.0, to_hz: 10.0, duration_s: 2.0, start_s: 0.5 };
    let none = DeflectionAt::default();
    let swept = measured(&model, &none, "inner", &chirp, &mut noise);
    assert_eq!(doublet_of(&swept), None);
    assert!(
        fit_doublet(&swept, &model, None, Path::new("run.csv")).unwrap_err().message.contains("no doublet")
    );
    let good = measured(&model, &none, "middle", &doublet(15.0), &mut noise);
    let found = doublet_of(&good).unwrap();
    assert_eq!(found.control, "middle");
    assert!((found.commanded_rad.to_degrees() - 15.0).abs() < 1e-12);
    // doublets that begin with the trailing edge up are doublets, too
    assert!(doublet_of(&measured(&model, &none, "middle", &doublet(-15.0), &mut noise)).is_some());
    let mut two = good.clone();
    two.controls_rad.push(("outer".to_owned(), good.controls_rad[0].1.clone()));
    assert_eq!(doublet_of(&two), None);
    assert_eq!(doublet_of(&Run { v_m_s: 0.0, ..good.clone() }), None);
    let unmeasured = Run { loads: None, ..good };
    assert!(
        fit_doublet(&unmeasured, &model, None, Path::new("run.csv"))
            .unwrap_err()
            .message
            .contains("no measured loads")
    );
}

#[test]
fn a_factor_that_cannot_be_is_refused() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model(&wing, &file, 30.0);
    let mut run = measured(&model, &DeflectionAt::default(), "inner", &doublet(15.0), &mut Normal(1));
    // the column's sign is wrong
    run.controls_rad[0].1.iter_mut().for_each(|delta| *delta = -*delta);
    let fit = fit_doublet(&run, &model, Some(SIGMA), Path::new("run.csv")).unwrap();
    let error = tables(&pooled(&[fit])).unwrap_err();
    assert!(error.message.contains("inner at 30.0 m/s and 15.0 degrees give K = -1.0"), "{error}");
}

#[test]
fn neutral_corrections_of_loads_and_deflections_give_a_factor_of_one() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let model = rig.at(Flow { v_m_s: 22.0, rho_kg_m3: 1.225 }, &neutral).unwrap();
    let mut run = measured(&model, &DeflectionAt::default(), "inner", &doublet(15.0), &mut Normal(1));
    let clean = model.fly(&maneuver::motion_of(&run, &model, Path::new("run.csv")).unwrap());
    run.loads = Some(["Fz_N", "Mx_Nm", "My_Nm"].map(|name| clean.get(name).unwrap().to_vec()));
    let fit = fit_doublet(&run, &model, Some(SIGMA), Path::new("run.csv")).unwrap();
    assert!((fit.factor - 1.0).abs() < 1e-9, "{}", fit.factor);
}
