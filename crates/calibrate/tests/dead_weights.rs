//! Deflections under dead weights with wind off: they tell the stiffness, as the formulas of a cantilever say.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, loads, path, row, small_settings, wing_of};
use aero::{Corrections, Flow};
use calibrate::campaign::ChannelNoise;
use calibrate::ensemble::ensemble;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPosterior, posterior};
use calibrate::{
    Campaign, CorrectionSet, DeadWeight, Noise, Reading, Schedule, Sensor, StaticPoint, Zero, calibrate,
};
use coupling::wing_file::{CorrectionPrior, Departure, Source};
use coupling::{ElasticWing, GRAVITY_M_S2, SteadyCase, SteadyModel, WingFile};
use std::path::PathBuf;
use std::sync::LazyLock;

const V_M_S: f64 = 30.0;
const ALPHAS_DEG: [f64; 4] = [-2.0, 0.0, 2.0, 4.0];
/// Stiffness as drawn, N m²; span and chord, m; the elastic axis at 0.38 of the chord.
const EI_N_M2: f64 = 200.0;
const GJ_N_M2: f64 = 100.0;
const SPAN_M: f64 = 1.8;
const CHORD_M: f64 = 0.3;
const AXIS: f64 = 0.38;
/// Logarithms of the true flexibility over that.
const SOFTER: [f64; 2] = [0.06, -0.07];

/// A straight wing of even chord and stiffness.
static FILE: LazyLock<WingFile> = LazyLock::new(|| {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("dead_weights");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::copy(path("tuflex/e214.dat"), folder.join("e214.dat")).unwrap();
    let station = |y_m: f64| format!("{y_m},{EI_N_M2},20000,{GJ_N_M2},0.6,0.004,0.45,{AXIS}\n");
    let head = "y_m,EI_flap_Nm2,EI_lag_Nm2,GJ_Nm2,mass_per_span_kg_m,Itheta_kgm,xcg_over_c,xea_over_c\n";
    std::fs::write(
        folder.join("beam_distribution.csv"),
        format!("{head}{}{}", station(0.0), station(SPAN_M)),
    )
    .unwrap();
    std::fs::copy(path("tuflex/wing_beam.ron"), folder.join("wing.ron")).unwrap();
    let mut file = WingFile::read(&folder.join("wing.ron")).unwrap();
    let Source::Parametric(planform) = &mut file.source else { panic!("the shipped wing is parametric") };
    (planform.quarter_chord_sweep_deg, planform.tip_chord_m) = (0.0, CHORD_M);
    (planform.boxes.chordwise, planform.boxes.spanwise) = (6, 14);
    planform.controls.clear();
    file
});

static WING: LazyLock<ElasticWing> = LazyLock::new(|| wing_of(&FILE));

/// Height of a uniform cantilever at `read_m` under a force at `at_m` further out.
fn height_m(force_n: f64, at_m: f64, read_m: f64) -> f64 {
    force_n * read_m * read_m * (3.0 * at_m - read_m) / (6.0 * EI_N_M2)
}

const WEIGHT: DeadWeight = DeadWeight { mass_kg: 1.2, y_over_span: 0.75, x_over_c: 0.8 };

/// A marker on the axis and an inclinometer, both inboard of the weight.
fn sensors() -> Vec<Sensor> {
    let sensor = |column: &str, reads: Reading, sigma: f64| Sensor {
        column: column.into(),
        reads,
        sigma,
        zero: Zero::WindOff,
        scale: 0.0,
        under: Some(WEIGHT),
    };
    vec![
        sensor("marker_m", Reading::Height { y_over_span: 0.5, x_over_c: AXIS }, 5e-5),
        sensor("turned_deg", Reading::Twist { y_over_span: 0.5 }, 5e-3),
    ]
}

/// What they read on a cantilever of the stiffness as drawn: m and degrees.
fn formulas() -> [f64; 2] {
    let weight_n = WEIGHT.mass_kg * GRAVITY_M_S2;
    let [at_m, read_m] = [WEIGHT.y_over_span, 0.5].map(|share| share * SPAN_M);
    // what hangs behind the axis turns the nose up
    let torque_nm = weight_n * (WEIGHT.x_over_c - AXIS) * CHORD_M;
    [-height_m(weight_n, at_m, read_m), (torque_nm * read_m / GJ_N_M2).to_degrees()]
}

/// Root loads of a softer wing, and, if it was hung with a weight, what the formulas say of it.
fn measured(hung: bool) -> (Campaign, ElasticWing) {
    let departure = Departure { log_flexibility: SOFTER, controls: Vec::new() };
    let truth = wing_of(&WingFile { departure, ..FILE.clone() });
    let neutral = Corrections::neutral(truth.correctable.len());
    let of = |alpha_deg: f64, loads: [f64; 3], cells: Vec<Option<f64>>, v_m_s: f64| StaticPoint {
        sensors: cells,
        ..row(v_m_s, alpha_deg.to_radians(), loads, None)
    };
    let blown = loads(&truth, V_M_S, &ALPHAS_DEG, &neutral);
    let mut points: Vec<StaticPoint> =
        ALPHAS_DEG.iter().zip(blown).map(|(alpha, loads)| of(*alpha, loads, vec![None; 2], V_M_S)).collect();
    // the balance feels the weight: no tare
    points.push(of(0.0, [0.0; 3], vec![None; 2], 0.0));
    if hung {
        let [bending, torsion] = SOFTER.map(f64::exp);
        let [marker_m, turned_deg] = formulas();
        let cells = vec![Some(marker_m * bending), Some(turned_deg * torsion)];
        points.push(of(0.0, [-11.8, -15.9, -1.0], cells, 0.0));
    }
    let noise = ChannelNoise { fz_n: Some(0.05), mx_nm: Some(0.03), my_nm: Some(0.02), tip_z_m: None };
    let noise = Noise { sample: noise, static_point: noise };
    (Campaign { sensors: sensors(), ..campaign(points, Some(noise)) }, truth)
}

fn known(campaign: &Campaign) -> AirspeedPosterior {
    let calibration = calibrate(&*WING, campaign, &small_settings()).unwrap();
    assert_eq!(calibration.weight_tare.as_ref().map(|tare| tare.points), Some(1));
    posterior(&WING, &calibration, &CorrectionPrior::default()).unwrap().swap_remove(0)
}

#[test]
fn a_cantilever_bends_and_turns_under_a_weight_as_the_formulas_say() {
    let rows = |reads: Reading| {
        let [height, incidence] = match reads {
            Reading::Height { y_over_span, x_over_c } => WING.point_rows(y_over_span, x_over_c),
            other => WING.point_rows(other.y_over_span(), 0.5),
        };
        let row = if matches!(reads, Reading::Twist { .. }) { incidence } else { height };
        faer::Mat::from_fn(1, row.len(), |_, i| row[i])
    };
    let place = [WEIGHT.y_over_span, WEIGHT.x_over_c];
    for (sensor, (formula, unit)) in
        sensors().iter().zip(formulas().into_iter().zip([1.0, 180.0 / std::f64::consts::PI]))
    {
        let (read, [by_bending, by_torsion]) =
            WING.under_weight(WEIGHT.mass_kg * GRAVITY_M_S2, place, &rows(sensor.reads));
        assert!((read[0] * unit / formula - 1.0).abs() < 5e-3, "{}: {read:?} {formula}", sensor.column);
        // all of the one is bending, all of the other torsion
        let [whole, none] =
            if sensor.column == "marker_m" { [by_bending, by_torsion] } else { [by_torsion, by_bending] };
        assert!((whole[0] / read[0] - 1.0).abs() < 1e-3 && (none[0] / read[0]).abs() < 1e-3);
    }
}

#[test]
fn dead_weights_tell_the_stiffness_and_narrow_the_tip() {
    let (campaign, truth) = measured(true);
    let told = known(&campaign);
    let found = told.mean.as_ref().unwrap().log_flexibility;
    for ((found, softer), most) in found.into_iter().zip(SOFTER).zip([0.01, 0.015]) {
        assert!((found - softer).abs() < most, "{found} {softer}");
    }
    let alone = known(&measured(false).0);
    let tip = |known: &AirspeedPosterior| {
        known.predictions.iter().find(|p| p.quantity == Quantity::TipHeight).unwrap().clone()
    };
    let flow = Flow { v_m_s: V_M_S, rho_kg_m3: RHO };
    let case = SteadyCase::new(flow, told.alpha_rad);
    let true_m = truth.tip_deflections(&[case], &Corrections::neutral(truth.correctable.len())).unwrap()[0];
    let ([low, high], before) = (tip(&told).interval(), tip(&alone));
    assert!((low..=high).contains(&true_m), "{:?} {true_m}", tip(&told));
    assert!(tip(&told).sigma < 0.8 * before.sigma, "{:?} {before:?}", tip(&told));
    assert!((tip(&told).value - true_m).abs() < 0.5 * (before.value - true_m).abs());
}

/// Whatever is computed with the wings of the ensemble has the stiffness that was measured, not the drawing's.
#[test]
fn wings_of_the_ensemble_are_about_the_stiffness_that_was_found() {
    let calibration = calibrate(&*WING, &measured(true).0, &small_settings()).unwrap();
    let prior = CorrectionPrior::default();
    let known = posterior(&WING, &calibration, &prior).unwrap();
    let calibration = calibration.with_means(&WING, &known).unwrap();
    let corrections = calibration.airspeeds[0].corrections.clone();
    let schedule = Schedule {
        wing: FILE.name.clone(),
        wing_hash: FILE.hash.clone(),
        sets: vec![CorrectionSet { v_m_s: V_M_S, corrections }],
        found: calibration.found.clone(),
        unconverged: Vec::new(),
    };
    let members = ensemble(&WING, &prior, &schedule, &known).unwrap().members;
    let mean = known[0].mean.as_ref().unwrap();
    let found = calibration.found.as_ref().unwrap();
    assert!((0..2).all(|i| (found.log_flexibility[i] - mean.log_flexibility[i]).abs() < 1e-7));
    for i in 0..2 {
        let all: f64 = members.iter().map(|member| member.log_flexibility[i]).sum();
        assert!((all / members.len() as f64 - mean.log_flexibility[i]).abs() < 1e-6);
    }
    let force = |b: usize| members.iter().map(|m| m.sets[0].corrections.force[b]).sum::<f64>() / 8.0;
    assert!((0..mean.corrections.len()).all(|b| (force(b) - mean.corrections.force[b]).abs() < 1e-6));
}

#[test]
fn a_weight_that_cannot_be_is_refused_with_its_place() {
    let read = |name: &str, sensors: &str, rows: &str| {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("dead_weights-{name}"));
        std::fs::create_dir_all(&folder).unwrap();
        let file =
            format!("(name: \"x\", rho_kg_m3: 1.2, static_cases: \"static.csv\", sensors: [{sensors}])");
        std::fs::write(folder.join("campaign.ron"), file).unwrap();
        std::fs::write(folder.join("static.csv"), format!("V_m_s,alpha_deg,Fz_N,a,b\n{rows}")).unwrap();
        Campaign::read(&folder)
    };
    let sensor = |column: &str, reads: &str, mass_kg: f64| {
        format!(
            "(column: \"{column}\", reads: {reads}, sigma: 0.001, under: (mass_kg: {mass_kg:?}, y_over_span: 1.0, x_over_c: 0.4)),"
        )
    };
    let height = "Height(y_over_span: 1.0, x_over_c: 0.4)";
    let both = format!("{}{}", sensor("a", height, 1.0), sensor("b", "Twist(y_over_span: 1.0)", 1.0));
    let good = read("good", &both, "0,0,0,-0.07,0.1\n20,0,1,,\n").unwrap();
    assert_eq!(good.points[0].sensors, [Some(-0.07), Some(0.1)]);
    let other = format!("{}{}", sensor("a", height, 1.0), sensor("b", "Twist(y_over_span: 1.0)", 2.0));
    for (i, (sensors, rows, words)) in [
        (&both, "20,0,1,-0.07,\n", "rows with V_m_s = 0"),
        (&other, "0,0,0,-0.07,0.1\n", "under another weight"),
        (&sensor("a", "Bending(y_over_span: 0.4)", 1.0), "0,0,0,1,\n", "a dead weight has a positive mass"),
        (&sensor("a", height, 0.0), "0,0,0,1,\n", "a dead weight has a positive mass"),
    ]
    .into_iter()
    .enumerate()
    {
        let error = read(&format!("bad-{i}"), sensors, rows).unwrap_err().to_string();
        assert!(error.contains(words), "{words}: {error}");
    }
}

/// A column whose rows scatter by far more than its noise is named, and only that one.
#[test]
fn readings_under_a_weight_that_scatter_are_named_by_their_own_column() {
    let (mut campaign, _) = measured(true);
    let hung = campaign.points.pop().unwrap();
    for off_deg in [0.2, -0.2, 0.2, -0.2, 0.2, -0.2] {
        let mut point = hung.clone();
        point.sensors[1] = point.sensors[1].map(|turned_deg| turned_deg + off_deg);
        campaign.points.push(point);
    }
    let beyond = known(&campaign).beyond;
    assert_eq!(beyond.iter().map(|(column, _)| column.as_str()).collect::<Vec<_>>(), ["turned_deg"]);
    // six squares of 40 standard deviations over four degrees of freedom
    assert!((beyond[0].1 / (40.0 * 1.5_f64.sqrt()) - 1.0).abs() < 0.05, "{beyond:?}");
}
