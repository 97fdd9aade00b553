//! What the wing that is known is the middle of, how noise beyond what is stated widens it, and what is proposed to
//! be measured next.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, row, small_settings, wing_with};
use aero::{Corrections, Flow};
use calibrate::campaign::ChannelNoise;
use calibrate::ensemble::ensemble;
use calibrate::posterior::next::{Suggestion, rank};
use calibrate::posterior::posterior;
use calibrate::posterior::predictions::Quantity;
use calibrate::{Campaign, CorrectionSet, Noise, Reading, Schedule, TipReading, calibrate};
use coupling::wing_file::CorrectionPrior;
use coupling::{ElasticWing, SteadyCase, SteadyModel};
use std::sync::LazyLock;

static WING: LazyLock<ElasticWing> = LazyLock::new(|| {
    wing_with(|planform| {
        planform.boxes.chordwise = 4;
        planform.boxes.spanwise = 14;
        for control in &mut planform.controls {
            control.strips = (control.strips.0.div_ceil(4), control.strips.1 / 4);
        }
    })
});

const V_M_S: f64 = 30.0;
const ALPHAS_DEG: [f64; 5] = [-2.0, 0.0, 2.0, 4.0, 6.0];

fn settings() -> calibrate::Settings {
    calibrate::Settings { chord_strips: 4, ..small_settings() }
}

fn noise() -> Noise {
    let static_point =
        ChannelNoise { fz_n: Some(0.05), mx_nm: Some(0.03), my_nm: Some(0.02), tip_z_m: Some(2e-4) };
    Noise { sample: static_point, static_point }
}

/// Loads of theory with controls that do 0.9 of what it says, at all angles and, if asked for, with each control at
/// 10 degrees up and down.
fn measured(deflected: bool, bend: impl Fn(f64) -> f64) -> Campaign {
    let neutral = Corrections::neutral(WING.correctable.len());
    let names = WING.control_names();
    let read = |alpha_deg: f64, control: Option<(usize, f64)>| {
        let mut case = SteadyCase::new(Flow { v_m_s: V_M_S, rho_kg_m3: RHO }, alpha_deg.to_radians());
        case.controls_rad = vec![0.0; names.len()];
        let mut controls_rad = Vec::new();
        if let Some((c, delta_deg)) = control {
            case.controls_rad[c] = 0.9 * f64::to_radians(delta_deg);
            controls_rad = vec![(names[c].clone(), f64::to_radians(delta_deg))];
        }
        let loads = WING.root_loads(&[case.clone()], &neutral).unwrap()[0].to_array();
        let mut point = row(V_M_S, case.alpha_rad, [loads[0] + bend(alpha_deg), loads[1], loads[2]], None);
        point.tip_z_m = Some(WING.tip_deflections(&[case], &neutral).unwrap()[0]);
        point.controls_rad = controls_rad;
        point
    };
    let mut points: Vec<_> = ALPHAS_DEG.iter().map(|&alpha_deg| read(alpha_deg, None)).collect();
    for c in 0..if deflected { names.len() } else { 0 } {
        points.extend([-10.0, 10.0].map(|delta_deg| read(2.0, Some((c, delta_deg)))));
    }
    campaign(points, Some(noise()))
}

/// Deflected rows say what controls do, so that the wing that is known is the mean; wings are about it evenly.
#[test]
fn the_middle_of_an_ensemble_is_the_mean() {
    let calibration = calibrate(&*WING, &measured(true, |_| 0.0), &settings()).unwrap();
    let prior = CorrectionPrior::default();
    let known = posterior(&WING, &calibration, &prior).unwrap();
    let mean = known[0].mean.as_ref().unwrap();
    assert!(mean.controls.iter().all(|factor| (factor - 0.9).abs() < 0.03), "{:?}", mean.controls);
    let calibration = calibration.with_means(&WING, &known).unwrap();
    let set = CorrectionSet { v_m_s: V_M_S, corrections: calibration.airspeeds[0].corrections.clone() };
    let schedule = Schedule {
        wing: String::new(),
        wing_hash: String::new(),
        sets: vec![set],
        found: calibration.found.clone(),
        unconverged: Vec::new(),
    };
    let members = ensemble(&WING, &prior, &schedule, &known).unwrap().members;
    let middle = |of: &dyn Fn(usize) -> f64| (0..members.len()).map(of).sum::<f64>() / members.len() as f64;
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-6, "{a} beside {b}");
    for (c, factor) in mean.controls.iter().enumerate() {
        near(middle(&|member| members[member].controls[c]), *factor);
    }
    for (i, log) in mean.log_flexibility.iter().enumerate() {
        near(middle(&|member| members[member].log_flexibility[i]), *log);
    }
    for b in [0, 17, 40] {
        near(middle(&|m| members[m].sets[0].corrections.force[b]), mean.corrections.force[b]);
        near(middle(&|m| members[m].sets[0].corrections.moment[b]), mean.corrections.moment[b]);
        let offset = middle(&|m| members[m].sets[0].corrections.pressure_offset[b]);
        near(offset, mean.corrections.pressure_offset[b]);
    }
    assert!(middle(&|member| (members[member].controls[0] - mean.controls[0]).abs()) > 1e-3);
}

/// Loads that no line follows are noisier than stated by the root of the test's F, and so is what hangs on them alone.
#[test]
fn root_loads_that_bend_are_as_noisy_as_lines_miss_them() {
    let prior = CorrectionPrior { reading: 0.0, ..CorrectionPrior::default() };
    let of = |bend: f64| {
        let curve = |alpha_deg: f64| bend * ((alpha_deg - 2.0).powi(2) - 8.0);
        let calibration = calibrate(&*WING, &measured(false, curve), &settings()).unwrap();
        let known = posterior(&WING, &calibration, &prior).unwrap();
        let root = Quantity::Reading(Reading::Shear { y_over_span: 0.0 });
        let sigma = known[0].predictions.iter().find(|p| p.quantity == root).unwrap().sigma;
        let test = calibration.airspeeds[0].line.nonlinearity[0].unwrap();
        (sigma, test.f, test.p_value < calibration.nonlinearity_level)
    };
    let ((even, _, is_even_told), (bent, f, is_bent_told)) = (of(0.0), of(0.05));
    assert!(!is_even_told && is_bent_told && f > 10.0, "{f}");
    assert!((bent / even / f.sqrt() - 1.0).abs() < 0.1, "{bent} beside {even} and {}", f.sqrt());
    // a little more than the lines' noise is noise
    let (odd, f, is_odd_told) = of(0.007);
    assert!(!is_odd_told && (odd / even - 1.0).abs() < 0.02, "{odd} {even} {f}");
}

fn ranked(campaign: &Campaign) -> Vec<Suggestion> {
    let calibration = calibrate(&*WING, campaign, &settings()).unwrap();
    let wanted = Quantity::Reading(Reading::Bending { y_over_span: 0.5 });
    rank(&WING, &calibration, &CorrectionPrior::default(), &wanted).unwrap()
}

#[test]
fn proposals_are_ranked_and_none_is_of_what_is_measured() {
    let tip = |all: &[Suggestion]| {
        all.iter().find(|one| one.measure.contains("the tip's height")).map(|one| one.measure.clone())
    };
    let mut campaign = measured(false, |_| 0.0);
    let declared = ranked(&campaign);
    assert_eq!(declared.len(), 1 + 4 + WING.control_names().len());
    assert!(declared.iter().is_sorted_by(|a, b| a.sigma_then <= b.sigma_then));
    assert!(declared.iter().all(|one| one.sigma_then <= one.sigma && one.sigma == declared[0].sigma));
    assert!(declared[0].sigma_then < 0.5 * declared[0].sigma, "a bridge there decides it: {declared:?}");
    assert!(declared[0].measure.contains("at 0.4") || declared[0].measure.contains("at 0.6"), "{declared:?}");
    assert!(tip(&declared).unwrap().contains("to 0.2 mm"), "{declared:?}");
    // where no noise of the tip is declared, a millimetre
    let unknown = ChannelNoise { tip_z_m: None, ..noise().static_point };
    campaign.noise = Some(Noise { sample: unknown, static_point: unknown });
    assert!(tip(&ranked(&campaign)).unwrap().contains("to 1.0 mm"));
    campaign.noise = Some(noise());
    campaign.tip = TipReading::Zeroed;
    assert_eq!(tip(&ranked(&campaign)), None);
}
