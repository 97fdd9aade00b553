//! What is left out of a fit is unseen: whatever is read there, the corrections that predict it are the same to the last
//! bit, and only the judgement of them moves.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{campaign, draw, loads, papers_kind, row, small_settings, small_wing};
use calibrate::{Campaign, StaticPoint, TipReading, calibrate};
use coupling::ElasticWing;

const ALPHAS_DEG: [f64; 5] = [-4.0, -2.0, 0.0, 2.0, 4.0];
const AIRSPEEDS_M_S: [f64; 3] = [22.0, 30.0, 40.0];

/// Readings of two days, some on the first alone, noise not declared and the zero of the tip free: offsets, scatter and
/// zero are all estimated, and all have a part in the means.
fn measured(wing: &ElasticWing) -> Campaign {
    let mut points: Vec<StaticPoint> = Vec::new();
    for v_m_s in AIRSPEEDS_M_S {
        let truth = papers_kind(wing, 0.02 * v_m_s);
        for block in ["day_1", "day_2"] {
            for (alpha, load) in ALPHAS_DEG.iter().zip(loads(wing, v_m_s, &ALPHAS_DEG, &truth)) {
                if block == "day_2" && *alpha == 4.0 {
                    continue;
                }
                let error = |c: usize| 0.05 * draw(10 * points.len() + c) + 0.3 * f64::from(block == "day_2");
                let mut point =
                    row(v_m_s, alpha.to_radians(), std::array::from_fn(|c| load[c] + error(c)), Some(block));
                point.tip_z_m = Some(1e-3 * (load[0] + error(4)));
                points.push(point);
            }
        }
    }
    Campaign { tip: TipReading::FreeZero, ..campaign(points, None) }
}

/// Other readings where `unseen` says so, no two changed alike; airspeeds stray by a share.
fn other(data: &Campaign, unseen: impl Fn(&StaticPoint) -> bool, stray: f64) -> Campaign {
    let mut data = data.clone();
    for (k, point) in data.points.iter_mut().enumerate().filter(|(_, point)| unseen(point)) {
        for (c, load) in point.loads.iter_mut().enumerate() {
            *load = load.map(|value| 1.3 * value + 2.0 * draw(100 * k + c));
        }
        point.tip_z_m = point.tip_z_m.map(|tip_m| tip_m + 0.004 * draw(100 * k + 9));
        point.v_m_s *= 1.0 + stray * draw(100 * k + 10);
        point.alpha_rad += 1e-4 * draw(100 * k + 11);
    }
    data
}

#[test]
fn readings_at_angles_that_are_left_out_move_nothing_but_the_judgement() {
    let wing = small_wing();
    let data = measured(&wing);
    let expected = calibrate(&wing, &data, &small_settings()).unwrap();
    for (index, v_m_s) in AIRSPEEDS_M_S.into_iter().enumerate() {
        let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
        let unseen =
            |point: &StaticPoint| near(point.v_m_s, v_m_s) && near(point.alpha_rad.to_degrees().abs(), 2.0);
        let found = calibrate(&wing, &other(&data, unseen, 1e-3), &small_settings()).unwrap();
        let [a, b] = [&found, &expected].map(|result| result.airspeeds[index].left_out.clone().unwrap());
        assert_eq!(a.corrections, b.corrections, "{v_m_s} m/s");
        assert!((a.objective_after - b.objective_after).abs() > 0.1, "{a:?} {b:?}");
    }
}

#[test]
fn readings_at_an_airspeed_that_is_left_out_move_nothing_but_the_judgement() {
    let wing = small_wing();
    let data = measured(&wing);
    let expected = calibrate(&wing, &data, &small_settings()).unwrap();
    for (index, v_m_s) in AIRSPEEDS_M_S.into_iter().enumerate() {
        // the schedule is asked at the airspeed itself, so that one stays
        let changed = other(&data, |point| (point.v_m_s - v_m_s).abs() < 1e-6, 0.0);
        let found = calibrate(&wing, &changed, &small_settings()).unwrap();
        let [a, b] =
            [&found, &expected].map(|result| result.airspeeds[index].left_out_airspeed.clone().unwrap());
        assert_eq!(a.corrections, b.corrections, "{v_m_s} m/s");
        assert!((a.objective_after - b.objective_after).abs() > 0.1, "{a:?} {b:?}");
    }
}
