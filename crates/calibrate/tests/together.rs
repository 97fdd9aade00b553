//! Airspeeds together: what is measured at one tells of the others as far as corrections are alike.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, row, small_settings, small_wing};
use aero::{Corrections, Flow};
use calibrate::campaign::ChannelNoise;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPosterior, Prediction, posterior};
use calibrate::{Campaign, Noise, Reading, Sensor, StaticPoint, Zero, calibrate};
use coupling::wing_file::CorrectionPrior;
use coupling::{ElasticWing, Rows, SteadyCase, station_rows};
use faer::Mat;
use std::sync::LazyLock;

static WING: LazyLock<ElasticWing> = LazyLock::new(small_wing);
const ALPHAS_DEG: [f64; 4] = [-2.0, 0.0, 2.0, 4.0];
/// The airspeed with a strain bridge, and others.
const READ_M_S: f64 = 30.0;

/// Lift that is gained and lost along the span, alike at all airspeeds: root loads hardly see it.
fn truth() -> Corrections {
    let boxes = &WING.correctable;
    Corrections {
        force: boxes.y_norm.iter().map(|y| 1.0 + 0.1 * (2.5 * y * std::f64::consts::PI).cos()).collect(),
        moment: vec![1.0; boxes.len()],
        pressure_offset: vec![0.0; boxes.len()],
    }
}

/// Root loads, and bending at mid-span.
fn read(v_m_s: f64, alpha_deg: f64) -> ([f64; 3], f64) {
    let flow = Flow { v_m_s, rho_kg_m3: RHO };
    let case = SteadyCase::new(flow, alpha_deg.to_radians());
    let mut point = WING.balance.point;
    point.y += 0.5 * WING.correctable.span_m();
    let station = station_rows(&WING.lattice, &WING.balance, &point);
    let rows = Rows { on_loads: station, on_structure: Mat::zeros(0, WING.tip_row().len()) };
    let operator = WING.at(flow, &truth()).unwrap();
    let loads = operator.solve(std::slice::from_ref(&case)).swap_remove(0).root.to_array();
    (loads, operator.values(&case, &rows)[1])
}

/// A campaign at some airspeeds with a bridge at mid-span that was read at one of them.
fn measured(airspeeds: &[f64]) -> Campaign {
    let points = airspeeds.iter().flat_map(|&v_m_s| {
        ALPHAS_DEG.map(|alpha_deg| {
            let (loads, bending_nm) = read(v_m_s, alpha_deg);
            let sensors = vec![(v_m_s == READ_M_S).then_some(bending_nm)];
            StaticPoint { sensors, ..row(v_m_s, alpha_deg.to_radians(), loads, None) }
        })
    });
    let reads = Reading::Bending { y_over_span: 0.5 };
    let bridge = Sensor {
        column: "bridge_Nm".into(),
        reads,
        sigma: 0.01,
        zero: Zero::WindOff,
        scale: 0.0,
        under: None,
    };
    let [fz_n, mx_nm, my_nm] = [0.02, 0.01, 0.01].map(Some);
    let noise = ChannelNoise { fz_n, mx_nm, my_nm, tip_z_m: None };
    let noise = Noise { sample: noise, static_point: noise };
    Campaign { sensors: vec![bridge], ..campaign(points.collect(), Some(noise)) }
}

fn known(airspeeds: &[f64], airspeeds_alike: f64) -> Vec<AirspeedPosterior> {
    let prior = CorrectionPrior { airspeeds_alike, reading: 0.0, ..CorrectionPrior::default() };
    let calibration = calibrate(&*WING, &measured(airspeeds), &small_settings()).unwrap();
    posterior(&WING, &calibration, &prior).unwrap()
}

fn mid_span(known: &AirspeedPosterior) -> Prediction {
    let quantity = Quantity::Reading(Reading::Bending { y_over_span: 0.5 });
    known.predictions.iter().find(|p| p.quantity == quantity).unwrap().clone()
}

/// Bending that was measured at one airspeed is known at another but for the share of its variance that the two do not have in common:
/// 1 - exp(-2 |ln V1/V2| / alike). Root loads are the same at both, so they change nothing in that.
#[test]
fn what_is_read_at_one_airspeed_narrows_another_by_their_correlation() {
    let airspeeds = [READ_M_S, 40.0];
    let apart = mid_span(&known(&airspeeds, 0.0)[1]);
    let true_nm = read(40.0, 4.0).1;
    for alike in [2.5, 0.8] {
        let together = mid_span(&known(&airspeeds, alike)[1]);
        let correlation = (-(40.0_f64 / READ_M_S).ln() / alike).exp();
        let expected = (1.0 - correlation * correlation).sqrt();
        let ratio = together.sigma / apart.sigma;
        assert!((ratio / expected - 1.0).abs() < 0.05, "{alike}: {ratio} {expected}");
        // the centre goes along, and holds the truth
        let [low, high] = together.interval();
        assert!((low..=high).contains(&true_nm), "{together:?} {true_nm}");
        assert!((together.value - true_nm).abs() < (apart.value - true_nm).abs(), "{together:?} {apart:?}");
    }
}

#[test]
fn airspeeds_that_are_not_alike_are_known_as_each_alone() {
    let (apart, alone) = (known(&[READ_M_S, 40.0], 0.0), known(&[READ_M_S], 2.5));
    for (a, b) in apart[0].predictions.iter().zip(&alone[0].predictions) {
        assert!((a.value - b.value).abs() < 1e-9 * b.value.abs().max(1.0), "{a:?} {b:?}");
        assert!((a.sigma - b.sigma).abs() < 1e-6 * b.sigma.max(1e-6), "{a:?} {b:?}");
    }
}
