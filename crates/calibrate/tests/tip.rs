//! Tip deflections beside root loads or instead of them, with planted truths: the campaigns are made by the model
//! itself, so the right answer is known.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, draw, loads, papers_kind, row, small_settings, small_wing, wing_with};
use aero::{Corrections, Flow};
use calibrate::campaign::{ChannelNoise, TIP};
use calibrate::{Campaign, Ending, Noise, Sets, StaticPoint, TipReading, Weight, calibrate};
use coupling::{ElasticWing, SteadyCase, SteadyModel};

const ALPHAS_DEG: [f64; 5] = [-4.0, -2.0, 0.0, 2.0, 4.0];

fn noise() -> Noise {
    let static_point =
        ChannelNoise { fz_n: Some(0.05), mx_nm: Some(0.03), my_nm: Some(0.02), tip_z_m: Some(2e-4) };
    Noise { sample: static_point, static_point }
}

fn tip_m(wing: &ElasticWing, v_m_s: f64, alpha_deg: f64, truth: &Corrections) -> f64 {
    let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: RHO }, alpha_deg.to_radians());
    wing.tip_deflections(&[case], truth).unwrap()[0]
}

/// Root loads and tip deflections without error at one airspeed, the tip's zero shifted.
fn with_tip(wing: &ElasticWing, v_m_s: f64, truth: &Corrections, zero_m: f64) -> Vec<StaticPoint> {
    let values = loads(wing, v_m_s, &ALPHAS_DEG, truth);
    let point = |(alpha, load): (&f64, &[f64; 3])| {
        let mut point = row(v_m_s, alpha.to_radians(), *load, None);
        point.tip_z_m = Some(tip_m(wing, v_m_s, *alpha, truth) + zero_m);
        point
    };
    ALPHAS_DEG.iter().zip(&values).map(point).collect()
}

fn beside_loads(wing: &ElasticWing, truth: &Corrections, zero_m: f64, tip: TipReading) -> Campaign {
    Campaign { tip, ..campaign(with_tip(wing, 40.0, truth, zero_m), Some(noise())) }
}

/// A sweep of airspeed at 3 degrees (block A) and 5 degrees (block B), tip readings only, on planted lift.
fn sweep(wing: &ElasticWing, factor: f64, zeros_m: [f64; 2], error: impl Fn(usize) -> f64) -> Campaign {
    let boxes = wing.correctable.len();
    let truth = Corrections {
        force: vec![factor; boxes],
        moment: vec![factor; boxes],
        pressure_offset: vec![0.0; boxes],
    };
    let mut points = Vec::new();
    for (block, alpha) in [("A", 3.0_f64), ("B", 5.0)] {
        for step in 0..15_u32 {
            let v_m_s = 6.0 + 2.0 * f64::from(step);
            let mut point = row(v_m_s, alpha.to_radians(), [0.0; 3], Some(block));
            point.loads = [None; 3];
            let zero_m = zeros_m[usize::from(block == "B")];
            point.tip_z_m = Some(tip_m(wing, v_m_s, alpha, &truth) + zero_m + error(points.len()));
            point.span.line = points.len() + 1;
            points.push(point);
        }
    }
    Campaign { channels: [false; 3], tip: TipReading::FreeZero, sets: Sets::Common, ..campaign(points, None) }
}

#[test]
fn a_tip_that_is_not_asked_for_changes_nothing_to_the_last_bit() {
    let wing = small_wing();
    let truth = papers_kind(&wing, 0.5);
    let with = beside_loads(&wing, &truth, 0.0, TipReading::Unused);
    let mut without = with.clone();
    for point in &mut without.points {
        point.tip_z_m = None;
    }
    let results = [with, without].map(|data| calibrate(&wing, &data, &small_settings()).unwrap());
    assert_eq!(results[0].airspeeds[0].corrections, results[1].airspeeds[0].corrections);
    assert_eq!(results[0].airspeeds[0].fit.objective, results[1].airspeeds[0].fit.objective);
}

#[test]
fn the_tip_beside_root_loads_determines_more_and_a_known_zero_more_still() {
    let wing = small_wing();
    let truth = papers_kind(&wing, 0.5);
    let mut directions = Vec::new();
    for tip in [TipReading::Unused, TipReading::FreeZero, TipReading::Zeroed] {
        let zero_m = if tip == TipReading::FreeZero { 0.008 } else { 0.0 };
        let result = calibrate(&wing, &beside_loads(&wing, &truth, zero_m, tip), &small_settings()).unwrap();
        let airspeed = &result.airspeeds[0];
        assert_eq!(airspeed.fit.ending, Ending::Converged, "{tip:?}: {:?}", airspeed.fit.history);
        directions.push(airspeed.identifiability.as_ref().unwrap().determined_directions);
        if tip != TipReading::Unused {
            // a share of the tip's bending counts as the same share of Mx
            assert!(airspeed.fit.rmse[1][TIP] < 0.05 * airspeed.fit.rmse[0][TIP], "{:?}", airspeed.fit.rmse);
        }
    }
    // slopes and offsets of three loads; the tip's slope; the tip's offset
    assert_eq!(directions, [6, 7, 8]);
}

#[test]
fn a_zero_of_eight_millimetres_is_not_lift() {
    let wing = small_wing();
    let found = |zeros_m| calibrate(&wing, &sweep(&wing, 1.1, zeros_m, |_| 0.0), &small_settings()).unwrap();
    let result = found([0.008, -0.005]);
    let common = result.common.as_ref().unwrap();
    assert!(result.airspeeds.is_empty() && result.failures().is_empty(), "{:?}", common.fit);
    let lift = common.lift.as_ref().unwrap();
    assert!((lift.factor - 1.1).abs() < 1e-9, "{lift:?}");
    assert!((lift.tip_zeros[0].0 - 0.008).abs() < 1e-9 && (lift.tip_zeros[1].0 + 0.005).abs() < 1e-9);
    assert_eq!(result.data.block_names, ["A", "B"]);
    // the corrections themselves carry it: nothing is left
    assert!((common.mean_force_factor - 1.1).abs() < 1e-9, "{}", common.mean_force_factor);
    assert!(common.fit.objective[1] < 1e-6 * common.fit.objective[0], "{:?}", common.fit);
    let other = found([0.0, 0.0]);
    let other = other.common.as_ref().unwrap().lift.as_ref().unwrap();
    assert!((other.factor - lift.factor).abs() < 1e-9);
}

#[test]
fn the_lift_factor_misses_by_as_much_as_its_uncertainty_says_with_slow_errors() {
    let wing = small_wing();
    let (mut pulls, mut wider) = (0.0, 0.0);
    let draws = 40;
    for seed in 0..draws {
        // errors of 3 mm that remember 0.7 of the one before, as hysteresis does
        let mut errors = vec![0.0; 30];
        for k in 1..30 {
            errors[k] =
                0.7 * errors[k - 1] + 0.003 * 0.51_f64.sqrt() * 3.0_f64.sqrt() * draw(1000 * seed + k);
        }
        let data = sweep(&wing, 0.9, [0.004, 0.0], |k| errors[k]);
        let result = calibrate(&wing, &data, &small_settings()).unwrap();
        let lift = result.common.unwrap().lift.unwrap();
        pulls += ((lift.factor - 0.9) / lift.sigma).powi(2) / draws as f64;
        wider += lift.widening() / draws as f64;
    }
    println!("rms of (found - true) / sigma: {}, mean widening {wider}", pulls.sqrt());
    // independent rows would have been taken for nearly twice as certain as they are
    assert!((0.6..1.6).contains(&pulls.sqrt()), "rms pull {}", pulls.sqrt());
    assert!(wider > 1.3, "{wider}");
}

#[test]
fn a_tip_alone_determines_one_direction_and_says_so() {
    let wing = small_wing();
    let errors = |k: usize| 0.002 * draw(k);
    let result = calibrate(&wing, &sweep(&wing, 1.0, [0.0, 0.0], errors), &small_settings()).unwrap();
    let common = result.common.unwrap();
    let told = common.identifiability.as_ref().unwrap();
    assert!((1..=2).contains(&told.determined_directions), "{:?}", told.singular_values);
    let [before, after] = told.mean_force_sigma;
    // the whole wing's lift factor is known better than the mean of an unknown distribution of factors
    let sigma = common.lift.as_ref().unwrap().sigma;
    assert!(after < before && after > sigma, "{before} {after} {sigma}");
    assert_eq!(told.undetermined(), ["moment"]);
}

#[test]
fn a_rigid_wing_has_no_tip_to_calibrate() {
    let rigid = wing_with(|planform| planform.structure = None);
    let points = with_tip(&small_wing(), 40.0, &Corrections::neutral(84), 0.0);
    let data = Campaign { tip: TipReading::Zeroed, ..campaign(points, Some(noise())) };
    let error = calibrate(&rigid, &data, &small_settings()).unwrap_err().to_string();
    assert!(error.contains("the wing is rigid"), "{error}");
}

/// Writes a campaign folder and reads it.
fn read(name: &str, campaign: &str, statics: &str) -> Result<Campaign, nastran::InputError> {
    let folder = std::env::temp_dir().join(format!("wingroot_tip_{}_{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("campaign.ron"), campaign).unwrap();
    std::fs::write(folder.join("static.csv"), statics).unwrap();
    let read = Campaign::read(&folder);
    std::fs::remove_dir_all(&folder).unwrap();
    read
}

#[test]
fn columns_of_loads_are_optional_but_one_channel_must_be_there() {
    let file =
        |more: &str| format!("Campaign(name: \"x\", rho_kg_m3: 1.2, static_cases: \"static.csv\", {more})");
    let tip = "V_m_s,alpha_deg,tip_z_m\n10,1,0.001\n";
    let alone = read("alone", &file("sets: Common"), tip).unwrap();
    assert_eq!((alone.tip, alone.sets), (TipReading::FreeZero, Sets::Common));
    assert_eq!(alone.fitted(), [false, false, false, true]);
    let beside = read("beside", &file(""), "V_m_s,alpha_deg,Fz_N,tip_z_m\n10,1,2,0.001\n").unwrap();
    assert_eq!(beside.fitted(), [true, false, false, false]);
    let wrong = [
        ("nothing", file(""), "V_m_s,alpha_deg\n10,1\n", "none of the columns"),
        ("no_tip", file("tip: Zeroed"), "V_m_s,alpha_deg,Fz_N\n10,1,2\n", "no column tip_z_m"),
        (
            "no_noise",
            file("noise: Some((sample: (), static_point: (fz_N: 1.0)))"),
            tip,
            "not given for tip_z_m",
        ),
        ("few", file("sets: Common"), tip, "at least three"),
    ];
    for (name, campaign, statics, message) in wrong {
        let error = match read(name, &campaign, statics) {
            Ok(campaign) => calibrate(&small_wing(), &campaign, &small_settings()).unwrap_err().to_string(),
            Err(error) => format!("{error} {error:?}"),
        };
        assert!(error.contains(message), "{name}: {error}");
    }
}

/// A sweep whose tip deflects less than in proportion, as a wing that bends far does: by `share` at the largest deflection.
fn bent_far(wing: &ElasticWing, share: f64) -> Campaign {
    let mut campaign = sweep(wing, 1.2, [0.0; 2], |k| 1e-4 * draw(k));
    let heights = campaign.points.iter().filter_map(|point| point.tip_z_m);
    let most_m = heights.fold(0.0_f64, |most, z| most.max(z.abs()));
    assert!(most_m > 0.2 * wing.correctable.span_m(), "{most_m}");
    for point in &mut campaign.points {
        point.tip_z_m = point.tip_z_m.map(|z| z * (1.0 - share * (z / most_m).powi(2)));
    }
    campaign
}

#[test]
fn a_lift_that_falls_with_the_deflection_is_said_to_be_the_deflections() {
    let wing = small_wing();
    for share in [0.1, 0.2, 0.4] {
        let result = calibrate(&wing, &bent_far(&wing, share), &small_settings()).unwrap();
        let said = result.said(&[Weight::Suspicion, Weight::Defect]).join("; ");
        let lift = result.common.as_ref().unwrap().lift.as_ref();
        assert!(said.contains("it is the deflection and not the lift"), "{share}: {said} {lift:?}");
        let factors = result.common.unwrap().corrections.force;
        let least = factors.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(least > 0.1 || said.contains("the least that is allowed"), "{share}: {least}: {said}");
    }
    let straight = calibrate(&wing, &bent_far(&wing, 0.0), &small_settings()).unwrap();
    assert!(straight.said(&[Weight::Suspicion, Weight::Defect]).is_empty(), "{:?}", straight.findings);
}
