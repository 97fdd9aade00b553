//! Calibration of a wing that bends far, tip deflections only: the lift of other codes' deflections, and a planted one.

#![expect(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, path, row};
use crate::large::{SEMISPAN_M, without_skin};
use aero::{Corrections, Flow, MirrorPlane};
use calibrate::{Campaign, LiftFactor, Sets, Settings, StaticPoint, TipReading, calibrate};
use coupling::{LargeWing, SteadyCase, SteadyModel};

const ALPHA_DEG: f64 = 5.0;
/// Settings of `data/pazy/wing.ron`.
const SETTINGS: fn() -> Settings = || Settings { chord_strips: 2, span_order: 2, ..Settings::default() };

fn wing() -> LargeWing {
    without_skin([4, 12], MirrorPlane::Symmetric { y_m: 0.0 })
}

/// Readings of the tip (m) over airspeed, their zero unknown.
fn sweep(readings: impl Iterator<Item = (f64, f64)>) -> Campaign {
    let point = |(at, (v_m_s, tip_z_m)): (usize, (f64, f64))| {
        let mut point = row(v_m_s, ALPHA_DEG.to_radians(), [0.0; 3], None);
        point.loads = [None; 3];
        point.tip_z_m = Some(tip_z_m);
        point.span.line = at + 2;
        point
    };
    let points: Vec<StaticPoint> = readings.enumerate().map(point).collect();
    Campaign { channels: [false; 3], tip: TipReading::FreeZero, sets: Sets::Common, ..campaign(points, None) }
}

fn lift<M: SteadyModel>(model: &M, campaign: &Campaign) -> LiftFactor {
    calibrate(model, campaign, &SETTINGS()).unwrap().common.unwrap().lift.unwrap()
}

#[test]
fn one_lift_factor_serves_other_codes_deflections_up_to_thirty_percent_of_the_semispan() {
    let file = std::fs::read_to_string(path("published/nl_pazy__static_aeroelastic_aoa5.json")).unwrap();
    let case: serde_json::Value = serde_json::from_str(&file).unwrap();
    let rows = case["expected"]["skin0_UMNAST_VLM_zyx"].as_array().unwrap();
    let readings = rows.iter().map(|row| (row[0].as_f64().unwrap(), row[1].as_f64().unwrap()));
    let readings = readings.filter(|(v_m_s, _)| (7.5..=50.0).contains(v_m_s));
    let campaign = sweep(readings.map(|(v_m_s, percent)| (v_m_s, 0.01 * percent * SEMISPAN_M)));
    let wing = wing();
    let [large, small] = [lift(&wing.model(), &campaign), lift(&wing.elastic, &campaign)];
    for (name, lift) in [("large", &large), ("small", &small)] {
        println!(
            "{name} deflections: {:.4} +- {:.4}, change {:.4?}",
            lift.factor,
            lift.sigma,
            lift.trend.unwrap()
        );
    }
    let ((change, _), (asked, sigma)) = (large.trend.unwrap(), small.trend.unwrap());
    assert!(change.abs() < 0.02, "the lift changes by {change} with large deflections");
    assert!(asked < -0.1 && asked.abs() > 3.0 * sigma, "linear theory asks for {asked} +- {sigma}");
    assert!((large.factor - 1.0).abs() < 0.04, "the codes' lift is {} times ours", large.factor);
}

#[test]
fn a_planted_lift_is_found_to_the_last_digits_on_a_wing_that_bends_by_a_third() {
    let (wing, factor, zero_m) = (wing(), 0.93, 0.006);
    let (model, count) = (wing.model(), wing.elastic.correctable.len());
    let planted = Corrections {
        force: vec![factor; count],
        moment: vec![factor; count],
        pressure_offset: vec![0.0; count],
    };
    let tip = |v_m_s: f64| {
        let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: RHO }, ALPHA_DEG.to_radians());
        model.tip_deflections(&[case], &planted).unwrap()[0]
    };
    assert!(tip(56.0) > 0.33 * SEMISPAN_M, "{}", tip(56.0));
    let campaign = sweep((2..=14).map(|step| 4.0 * f64::from(step)).map(|v| (v, tip(v) + zero_m)));
    let found = lift(&model, &campaign);
    println!("{found:?}");
    assert!(
        (found.factor - factor).abs() < 1e-6 && (found.tip_zeros[0].0 - zero_m).abs() < 1e-7,
        "{found:?}"
    );
    assert!(found.trend.unwrap().0.abs() < 1e-5, "{found:?}");
}

#[test]
fn the_measured_tips_of_the_pazy_wing_ask_for_one_lift_at_all_deflections() {
    if std::env::var_os("RUN_SLOW_TESTS").is_none() {
        println!("left out: minutes; RUN_SLOW_TESTS=1 runs it");
        return;
    }
    let (file, wing) = LargeWing::read(&path("pazy/wing.ron")).unwrap();
    for name in ["tip_3deg", "tip_5deg", "tip_5deg_by_airspeed"] {
        let start = std::time::Instant::now();
        let campaign = Campaign::read(&path("pazy").join(name)).unwrap();
        let fitted = |bends_far: bool| {
            let settings = Settings::of_wing(&file.correction);
            let found = if bends_far {
                calibrate(&wing.model(), &campaign, &settings)
            } else {
                calibrate(&wing.elastic, &campaign, &settings)
            };
            found.unwrap().common.unwrap().lift.unwrap()
        };
        let [small, large] = [false, true].map(fitted);
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{name}: small {:.4} +- {:.4}, change {:.4?}",
            small.factor,
            small.sigma,
            small.trend.unwrap()
        );
        println!("    large {:.4} +- {:.4}, change {:.4?}", large.factor, large.sigma, large.trend.unwrap());
        println!("    zeros {:.5?} {:.5?}; {seconds:.0} s", small.tip_zeros, large.tip_zeros);
        let (change, sigma) = large.trend.unwrap();
        assert!(change.abs() < 2.0 * sigma, "{name}: the lift changes by {change} +- {sigma}");
    }
}
