//! The wings of an ensemble: as far apart as the posterior says, with the root loads that were measured. Loads are computed with
//! each of them as any user would; the posterior's standard deviations are linear algebra of its own, checked in posterior.rs.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, draw, file_with, loads, papers_kind, row, small_settings, wing_of};
use aero::Flow;
use calibrate::campaign::ChannelNoise;
use calibrate::ensemble::ensemble;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{Prediction, posterior};
use calibrate::{Campaign, CorrectionSet, Ensemble, Noise, Reading, Schedule, TipReading, calibrate};
use coupling::wing_file::{CorrectionPrior, Departure, WingFile};
use coupling::{ElasticWing, SteadyCase, SteadyModel};

const V_M_S: f64 = 30.0;
const ALPHAS_DEG: [f64; 5] = [-2.0, 0.0, 2.0, 4.0, 6.0];
const SIGMA: [f64; 3] = [0.05, 0.03, 0.02];

fn file() -> WingFile {
    file_with(|planform| {
        planform.boxes.chordwise = 6;
        planform.boxes.spanwise = 14;
        for control in &mut planform.controls {
            control.strips = (control.strips.0.div_ceil(4), control.strips.1 / 4);
        }
    })
}

/// Root loads of a wing of the paper's kind, and nothing else.
fn measured(wing: &ElasticWing) -> Campaign {
    let truth = papers_kind(wing, 0.1);
    let [fz_n, mx_nm, my_nm] = SIGMA.map(Some);
    let static_point = ChannelNoise { fz_n, mx_nm, my_nm, tip_z_m: None };
    let loads = loads(wing, V_M_S, &ALPHAS_DEG, &truth);
    let points = loads.iter().enumerate().map(|(i, load)| {
        let noisy = std::array::from_fn(|c| load[c] + SIGMA[c] * draw(3 * i + c));
        row(V_M_S, ALPHAS_DEG[i].to_radians(), noisy, None)
    });
    let noise = Noise { sample: static_point, static_point };
    Campaign { tip: TipReading::Unused, ..campaign(points.collect(), Some(noise)) }
}

/// Root Fz, the tip, and the root's bending moment by a degree of the outer aileron, at the largest angle.
fn computed(wing: &ElasticWing, corrections: &aero::Corrections) -> [f64; 3] {
    let flow = Flow { v_m_s: V_M_S, rho_kg_m3: RHO };
    let neutral = SteadyCase::new(flow, 6.0_f64.to_radians());
    let outer = wing.control_names().iter().position(|name| name == "outer").unwrap();
    let mut deflected = neutral.clone();
    deflected.controls_rad = vec![0.0; wing.controls.len()];
    deflected.controls_rad[outer] = 1.0_f64.to_radians();
    let cases = [neutral, deflected];
    let loads = wing.root_loads(&cases, corrections).unwrap();
    let tip_m = wing.tip_deflections(&cases, corrections).unwrap()[0];
    let [at_rest, with] = [loads[0].to_array(), loads[1].to_array()];
    [at_rest[0], tip_m, with[1] - at_rest[1]]
}

fn of_member(file: &WingFile, ensemble: &Ensemble, member: usize) -> [f64; 3] {
    let member = &ensemble.members[member];
    let names = wing_of(file).control_names();
    let departure = Departure {
        log_flexibility: member.log_flexibility,
        controls: names.into_iter().zip(member.controls.iter().copied()).collect(),
    };
    let wing = wing_of(&WingFile { departure, ..file.clone() });
    computed(&wing, &member.sets[0].corrections)
}

#[test]
fn wings_of_an_ensemble_spread_as_far_as_the_posterior_says_and_keep_the_measured_loads() {
    let file = file();
    let wing = wing_of(&file);
    let calibration = calibrate(&wing, &measured(&wing), &small_settings()).unwrap();
    let prior = CorrectionPrior { reading: 0.0, ..CorrectionPrior::default() };
    let known = posterior(&wing, &calibration, &prior).unwrap();
    let corrections = calibration.airspeeds[0].corrections.clone();
    let schedule = Schedule {
        wing: file.name.clone(),
        wing_hash: file.hash.clone(),
        sets: vec![CorrectionSet { v_m_s: V_M_S, corrections: corrections.clone() }],
        found: None,
        unconverged: Vec::new(),
    };
    let ensemble = ensemble(&wing, &prior, &schedule, &known).unwrap();
    let centre = computed(&wing, &corrections);
    let members: Vec<[f64; 3]> =
        (0..ensemble.members.len()).map(|member| of_member(&file, &ensemble, member)).collect();
    let stated = |of: &dyn Fn(&Quantity) -> bool| -> &Prediction {
        known[0].predictions.iter().find(|p| of(&p.quantity)).unwrap()
    };
    let shear =
        |q: &Quantity| matches!(q, Quantity::Reading(Reading::Shear { y_over_span }) if *y_over_span == 0.0);
    let outer = |q: &Quantity| matches!(q, Quantity::ControlMx { control } if control == "outer");
    let predictions = [stated(&shear), stated(&|q| *q == Quantity::TipHeight), stated(&outer)];
    for (k, (prediction, what)) in predictions.iter().zip(["root Fz", "tip", "aileron"]).enumerate() {
        let squares: f64 = members.iter().map(|member| (member[k] - centre[k]).powi(2)).sum();
        let spread = (squares / members.len() as f64).sqrt();
        let ratio = spread / prediction.sigma;
        // of root Fz next to nothing is open, and the squares of what is large elsewhere reach it
        let allowed = if k == 0 { 0.5..3.0 } else { 0.85..1.15 };
        assert!(
            allowed.contains(&ratio),
            "{what}: wings spread {spread}, the posterior says {}",
            prediction.sigma
        );
        let mean = members.iter().map(|member| member[k]).sum::<f64>() / members.len() as f64;
        assert!(
            k == 0 || (mean - centre[k]).abs() < 0.35 * spread,
            "{what}: mean {mean}, calibrated {}",
            centre[k]
        );
    }
    let [fz, ..] = predictions;
    assert!(fz.sigma < 0.01 * fz.value.abs(), "root Fz was measured");
    // in free air all lift is off by what the stream may be, whatever was measured in it
    let mut rigid = wing.clone();
    rigid.supported = None;
    for member in &ensemble.members {
        assert!(((member.stream - 1.0).abs() - prior.stream).abs() < 1e-12);
        let [force, moment, offset] = [member.stream; 3];
        let sets = member.sets_in_flight();
        let (own, flown) = (&member.sets[0].corrections, &sets[0].corrections);
        assert_eq!(flown.force[3], force * own.force[3]);
        assert_eq!(flown.moment[3], moment * own.moment[3]);
        assert_eq!(flown.pressure_offset[3], offset * own.pressure_offset[3]);
        // a rigid wing's lift is that of its sections
        let lift_n = |corrections| computed(&rigid, corrections)[0];
        assert!((lift_n(flown) / lift_n(own) / member.stream - 1.0).abs() < 1e-9);
    }
    let ups = ensemble.members.iter().filter(|member| member.stream > 1.0).count();
    assert_eq!(ups, ensemble.members.len() / 2);
}

#[test]
fn an_ensemble_is_read_as_it_was_written_and_refused_for_other_corrections() {
    let set = |v_m_s: f64, force: f64| CorrectionSet {
        v_m_s,
        corrections: aero::Corrections { force: vec![force], moment: vec![1.0], pressure_offset: vec![0.0] },
    };
    let schedule = |airspeeds: &[f64]| Schedule {
        wing: "w".into(),
        wing_hash: "h".into(),
        sets: airspeeds.iter().map(|&v_m_s| set(v_m_s, 1.0)).collect(),
        found: None,
        unconverged: Vec::new(),
    };
    let member = calibrate::Member {
        log_flexibility: [0.01, -0.02],
        controls: vec![1.05],
        stream: 1.01,
        sets: vec![set(30.0, 0.9)],
    };
    let written =
        Ensemble { wing: "w".into(), wing_hash: "h".into(), corrections: "c".into(), members: vec![member] };
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("ensemble.ron");
    std::fs::write(&path, written.to_ron().unwrap()).unwrap();
    assert_eq!(Ensemble::read(&path, &schedule(&[30.0])).unwrap(), written);
    let refused = Ensemble::read(&path, &schedule(&[30.0, 40.0])).unwrap_err().to_string();
    assert!(refused.contains("wing 1 has other airspeeds or boxes"), "{refused}");
    std::fs::write(&path, Ensemble { members: Vec::new(), ..written }.to_ron().unwrap()).unwrap();
    let refused = Ensemble::read(&path, &schedule(&[30.0])).unwrap_err().to_string();
    assert!(refused.contains("0 wings"), "{refused}");
}
