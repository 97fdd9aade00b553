//! Faults that static campaigns of users have: each is answered in a sentence that says where and how much, and campaigns
//! without a fault in none. Loads are made by the model with planted corrections and drawn noise; the fault is put in by hand.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{campaign, draw, loads, papers_kind, row, small_settings, small_wing};
use aero::Corrections;
use calibrate::campaign::ChannelNoise;
use calibrate::{Calibration, Campaign, Noise, StaticPoint, Weight, calibrate};
use coupling::ElasticWing;
use std::sync::LazyLock;

static WING: LazyLock<ElasticWing> = LazyLock::new(small_wing);
const AIRSPEEDS_M_S: [f64; 3] = [18.0, 26.0, 34.0];
const ALPHAS_DEG: [f64; 6] = [-4.0, -2.0, 0.0, 2.0, 4.0, 6.0];
/// One standard deviation of a row.
const SIGMA: [f64; 3] = [0.05, 0.03, 0.02];

fn noise() -> Noise {
    let [fz_n, mx_nm, my_nm] = SIGMA.map(Some);
    let static_point = ChannelNoise { fz_n, mx_nm, my_nm, tip_z_m: None };
    Noise { sample: static_point, static_point }
}

/// A number of roughly unit variance.
fn normal(k: usize) -> f64 {
    (0..12).map(|i| draw(12 * k + i)).sum::<f64>() / 2.0
}

/// Two rows an angle at three airspeeds and wind-off rows, changed by hand.
fn measured(truth: &Corrections, change: impl Fn(&mut StaticPoint)) -> Campaign {
    let mut rows = Vec::new();
    for (v, &v_m_s) in [0.0].iter().chain(&AIRSPEEDS_M_S).enumerate() {
        for (i, load) in loads(&WING, v_m_s, &ALPHAS_DEG, truth).iter().enumerate() {
            for repeat in 0..2 {
                let k = 3 * (repeat + 2 * (i + 6 * v));
                let noisy = std::array::from_fn(|c| load[c] + SIGMA[c] * normal(k + c));
                let mut point = row(v_m_s, ALPHAS_DEG[i].to_radians(), noisy, None);
                point.span.line = rows.len() + 2;
                rows.push(point);
            }
        }
    }
    rows.iter_mut().for_each(change);
    campaign(rows, Some(noise()))
}

fn result(campaign: &Campaign) -> Calibration {
    calibrate(&*WING, campaign, &small_settings()).unwrap()
}

/// Corrections as measured wings have them: 5 % less lift, more of it lost at the tip, and a little camber.
fn mild() -> Corrections {
    let boxes = &WING.correctable;
    Corrections {
        force: boxes.y_norm.iter().map(|y| 1.0 - 0.12 * y * y).collect(),
        moment: vec![1.0; boxes.len()],
        pressure_offset: boxes.y_norm.iter().map(|y| 0.03 * (1.0 - y)).collect(),
    }
}

/// Loads times factors, by channel.
fn times(by: [f64; 3]) -> impl Fn(&mut StaticPoint) {
    move |point| point.loads = std::array::from_fn(|c| point.loads[c].map(|load| load * by[c]))
}

#[track_caller]
fn says(result: &Calibration, weight: Weight, words: &[&str]) {
    let said = result.said(&[weight]);
    let found = said.iter().any(|sentence| words.iter().all(|word| sentence.contains(word)));
    assert!(found, "{words:?} not in {:?}", result.findings);
}

#[test]
fn campaigns_without_a_fault_are_not_blamed() {
    let wing = &*WING;
    let boxes = &wing.correctable;
    let mut truths = vec![mild(), papers_kind(wing, 0.0), papers_kind(wing, 1.0)];
    for seed in 0..12 {
        let random = |k: usize| draw(100 * seed + k);
        let shape = |k: usize, b: usize| {
            let (x, y) = (boxes.chord_row[b] as f64 / 5.0 - 0.5, boxes.y_norm[b]);
            random(k) + random(k + 1) * x + random(k + 2) * (y - 0.5) + random(k + 3) * (y * y - 0.3)
        };
        truths.push(Corrections {
            force: (0..boxes.len()).map(|b| 1.0 + 0.2 * shape(0, b)).collect(),
            moment: vec![1.0; boxes.len()],
            pressure_offset: (0..boxes.len()).map(|b| 0.1 * shape(10, b)).collect(),
        });
    }
    for (i, truth) in truths.iter().enumerate() {
        let result = result(&measured(truth, |_| {}));
        assert!(result.said(&[Weight::Defect]).is_empty(), "truth {i}: {:?}", result.findings);
        assert!(result.set_aside.is_empty(), "truth {i}: {:?}", result.findings);
    }
}

#[test]
fn one_row_that_is_30_n_off_is_named_and_set_aside() {
    let right = result(&measured(&mild(), |_| {}));
    let wrong = result(&measured(&mild(), |point| {
        if point.span.line == 30 {
            point.loads[0] = point.loads[0].map(|fz_n| fz_n + 30.0);
        }
    }));
    says(&wrong, Weight::Suspicion, &["line 30 of the static cases", "Fz_N", "above", "26 m/s", "set aside"]);
    assert_eq!(wrong.set_aside, [30]);
    assert!(wrong.faults().is_empty(), "{:?}", wrong.faults());
    for (a, b) in right.airspeeds.iter().zip(&wrong.airspeeds) {
        assert!(
            (a.fit.objective[1] - b.fit.objective[1]).abs() < 0.05,
            "{:?} {:?}",
            a.fit.objective,
            b.fit.objective
        );
    }
}

#[test]
fn a_wing_that_stalls_at_the_last_angle_keeps_its_row() {
    // one row an angle, so that nothing at the last one tells stall from a wrong reading
    let mut campaign = measured(&mild(), |point| {
        if point.alpha_rad > 0.1 {
            point.loads = point.loads.map(|load| load.map(|load| 0.9 * load));
        }
    });
    let mut seen: Vec<(u64, u64)> = Vec::new();
    campaign.points.retain(|point| {
        let place = (point.v_m_s.to_bits(), point.alpha_rad.to_bits());
        let is_new = !seen.contains(&place);
        seen.push(place);
        is_new
    });
    let result = result(&campaign);
    says(&result, Weight::Suspicion, &["it stays", "may stall", "or the row is wrong"]);
    assert!(result.set_aside.is_empty() && result.faults().is_empty(), "{:?}", result.findings);
}

#[test]
fn a_wing_that_stalls_over_several_angles_is_bent_and_no_more() {
    for repeated in [true, false] {
        let mut campaign = measured(&mild(), |point| {
            let beyond = (point.alpha_rad - 1.0_f64.to_radians()).max(0.0);
            point.loads = point.loads.map(|load| load.map(|load| load * (1.0 - 1.5 * beyond)));
        });
        if !repeated {
            campaign.points.retain(|point| point.span.line % 2 == 0);
        }
        let result = result(&campaign);
        assert!(result.faults().is_empty(), "{repeated}: {:?}", result.findings);
        assert!(result.set_aside.is_empty(), "{repeated}: {:?}", result.findings);
        assert!(result.airspeeds[2].line.nonlinearity[0].unwrap().p_value < result.nonlinearity_level);
    }
}

#[test]
fn exact_loads_are_not_blamed_for_their_rounding() {
    let mut rows = Vec::new();
    for v_m_s in AIRSPEEDS_M_S {
        for (alpha, load) in ALPHAS_DEG.iter().zip(loads(&WING, v_m_s, &ALPHAS_DEG, &mild())) {
            rows.push(row(v_m_s, alpha.to_radians(), load, None));
        }
    }
    let result = result(&campaign(rows, None));
    assert!(result.set_aside.is_empty() && result.faults().is_empty(), "{:?}", result.findings);
}

#[test]
fn thousands_of_rows_without_a_fault_are_not_blamed() {
    let mut campaign = measured(&mild(), |_| {});
    let few = campaign.points.clone();
    for k in 1..60 {
        for point in &few {
            let mut point = point.clone();
            let number = 7000 * k + 3 * point.span.line;
            point.loads = std::array::from_fn(|c| {
                point.loads[c].map(|load| load + 0.3 * SIGMA[c] * normal(number + c))
            });
            point.span.line += few.len() * k;
            campaign.points.push(point);
        }
    }
    let result = result(&campaign);
    assert!(campaign.points.len() > 2500 && result.set_aside.is_empty(), "{:?}", result.findings);
}

#[test]
fn an_angle_whose_rows_agree_and_are_all_wrong_is_no_calibration() {
    let result = result(&measured(&mild(), |point| {
        if point.v_m_s > 30.0 && point.alpha_rad.abs() < 0.01 {
            point.loads[0] = point.loads[0].map(|fz_n| fz_n + 5.0);
        }
    }));
    says(&result, Weight::Defect, &["V_m_s = 34", "alpha_deg = 0.00", "Fz_N", "above", "smooth curve"]);
    assert!(
        result.faults().iter().any(|fault| fault.contains("contradict the other angles")),
        "{:?}",
        result.faults()
    );
}

#[test]
fn noise_five_times_what_is_declared_is_said_and_counts() {
    let mut k = 5000;
    let campaign = {
        let mut campaign = measured(&mild(), |_| {});
        for point in &mut campaign.points {
            k += 3;
            point.loads =
                std::array::from_fn(|c| point.loads[c].map(|load| load + 5.0 * SIGMA[c] * normal(k + c)));
        }
        campaign
    };
    let result = result(&campaign);
    says(&result, Weight::Suspicion, &["Fz_N: repeated rows scatter by", "campaign.ron declares"]);
    assert!(result.faults().is_empty(), "{:?} {:?}", result.faults(), result.airspeeds[0].fit);
    let ratio = result.data.point_sigma.unwrap()[0] / SIGMA[0];
    assert!((3.5..7.0).contains(&ratio), "{ratio}");
}

#[test]
fn a_load_that_is_not_there_and_a_tip_that_is_not_used_are_said() {
    let mut campaign = measured(&mild(), |point| {
        point.loads[1] = None;
        point.loads[2] = None;
        point.tip_z_m = Some(0.1);
    });
    campaign.channels = [true, false, false];
    let result = result(&campaign);
    says(&result, Weight::Open, &["no Mx_Nm", "along the span stays at theory"]);
    says(&result, Weight::Open, &["no My_Nm", "stay at theory"]);
    says(&result, Weight::Open, &["tip_z_m of the static cases is not used"]);
}

#[test]
fn rows_of_many_airspeeds_with_one_label_are_no_calibration() {
    let mut rows = Vec::new();
    for (i, v_m_s) in [18.0, 22.0, 26.0, 30.0, 34.0, 40.0].into_iter().enumerate() {
        for (j, load) in loads(&WING, v_m_s, &ALPHAS_DEG, &mild()).iter().enumerate() {
            let noisy = std::array::from_fn(|c| load[c] + SIGMA[c] * normal(3 * (6 * i + j) + c));
            rows.push(row(30.0, ALPHAS_DEG[j].to_radians(), noisy, None));
        }
    }
    let result = result(&campaign(rows, Some(noise())));
    says(&result, Weight::Defect, &["V_m_s = 30", "all too large or all too small together"]);
    assert!(!result.faults().is_empty());
}

/// A fault put into a row.
type Change = Box<dyn Fn(&mut StaticPoint)>;

#[test]
fn signs_swaps_units_and_other_places_are_told_from_each_other() {
    let wing_arm_m = {
        let load = loads(&WING, 26.0, &[0.0, 2.0], &mild());
        (load[1][1] - load[0][1]) / (load[1][0] - load[0][0])
    };
    let chord_m = WING.correctable.mean_chord_m();
    let foot = 0.3048;
    let pound = 4.448_221_615;
    let span = 0.55;
    let cases: Vec<(Change, &str)> = vec![
        (Box::new(times([1.0, 1.0, -1.0])), "My_Nm has the other sign"),
        (Box::new(times([1.0, -1.0, 1.0])), "Mx_Nm has the other sign"),
        (Box::new(|point: &mut StaticPoint| point.loads.swap(1, 2)), "Mx_Nm and My_Nm are swapped"),
        (Box::new(times([1.0 / pound, 1.0 / pound / foot, 1.0 / pound / foot])), "lbf and lbf ft"),
        (Box::new(times([0.514_444_f64.powi(2); 3])), "V_m_s is in knots"),
        (
            // My = -(x - dx) Fz: a point 0.5 chords aft of the wing file's
            Box::new(move |point: &mut StaticPoint| {
                point.loads[2] = Some(point.loads[2].unwrap() + 0.5 * chord_m * point.loads[0].unwrap());
            }),
            "m aft of the wing file's balance",
        ),
        (Box::new(times([span, span * span, span])), "times the span"),
    ];
    for (change, words) in &cases {
        let result = result(&measured(&mild(), change));
        says(&result, Weight::Defect, &[words]);
        assert!(!result.faults().is_empty());
    }
    assert!(wing_arm_m > 0.0);
}

#[test]
fn a_weight_that_was_not_tared_is_named_with_its_size_unless_wind_off_rows_show_it() {
    // the wing's weight and its moments, from its own deck
    let file = coupling::WingFile::read(&crate::common::path("tuflex/wing_beam.ron")).unwrap();
    let model = structure::Model::from_bulk(&file.bulk(coupling::Mount::Tunnel).unwrap()).unwrap();
    let mass = structure::MassProperties::of_model(&model);
    let weight_n = 9.80665 * mass.mass_kg;
    let wind_on = |mut campaign: Campaign| {
        campaign.points.retain(|point| point.v_m_s > 0.0);
        campaign
    };
    let untared = |point: &mut StaticPoint| {
        point.loads[0] = point.loads[0].map(|fz_n| fz_n - weight_n);
        point.loads[1] = point.loads[1].map(|mx_nm| mx_nm - weight_n * mass.centre.y);
        point.loads[2] = point.loads[2].map(|my_nm| my_nm + weight_n * mass.centre.x);
    };
    let several = result(&wind_on(measured(&mild(), untared)));
    says(&several, Weight::Defect, &["weight", "not tared", &format!("{weight_n:.1} N")]);
    let mut one = wind_on(measured(&mild(), untared));
    one.points.retain(|point| point.v_m_s == 18.0);
    says(&result(&one), Weight::Suspicion, &["weight", "not tared", "zero-lift angle", "V_m_s = 0"]);
}

#[test]
fn an_airspeed_that_is_12_percent_wrong_and_a_lift_of_080_are_named_together() {
    let result = result(&measured(&mild(), times([0.8; 3])));
    says(&result, Weight::Suspicion, &["lift slope", "dynamic pressure", "do not tell them apart"]);
}
