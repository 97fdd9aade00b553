//! Calibration of the two shipped campaigns (made by the virtual wind tunnel): where it must end.
//!
//! The limits are those the project set itself before the campaigns were made: the objective within 2 % of the
//! straight-line floor and 2 % of the noise floor, a tenth of its start, six cone programs, unseen angles predicted.

use calibrate::{Calibration, Campaign, Ending, Settings, calibrate};
use coupling::{ElasticWing, WingFile};
use std::sync::OnceLock;
use validation::data;

fn wing() -> &'static (WingFile, ElasticWing) {
    static WING: OnceLock<(WingFile, ElasticWing)> = OnceLock::new();
    WING.get_or_init(|| ElasticWing::read(&data("tuflex/wing.ron")).expect("the shipped wing"))
}

fn calibrated(folder: &str) -> Calibration {
    let (file, wing) = wing();
    let campaign = Campaign::read(&data(folder)).expect("a shipped campaign");
    calibrate(wing, &campaign, &Settings::of_wing(&file.correction)).expect("a calibration")
}

fn measured() -> &'static Calibration {
    static RESULT: OnceLock<Calibration> = OnceLock::new();
    RESULT.get_or_init(|| calibrated("tuflex/measured"))
}

#[test]
fn every_airspeed_reaches_its_floor_in_at_most_six_cone_programs() {
    let speeds: Vec<f64> = measured().airspeeds.iter().map(|a| a.data.v_m_s.round()).collect();
    assert_eq!(speeds, [18.0, 22.0, 30.0, 34.0, 40.0]);
    for airspeed in &measured().airspeeds {
        let (fit, v) = (&airspeed.fit, airspeed.data.v_m_s);
        let noise = airspeed.noise_floor.expect("the campaign declares its noise");
        assert!(fit.objective[1] <= 1.02 * airspeed.line_floor + 0.02 * noise, "{v}: {:?}", fit.objective);
        assert!(
            fit.objective[1] < (0.1 * fit.objective[0]).max(airspeed.line_floor),
            "{v}: {:?}",
            fit.objective
        );
        assert!(fit.cone_programs <= 6, "{v}: {} programs", fit.cone_programs);
        assert_eq!(fit.ending, Ending::Converged);
    }
}

#[test]
fn angles_left_out_of_a_fit_are_predicted() {
    for airspeed in &measured().airspeeds {
        let left_out = airspeed.left_out.as_ref().expect("five angles");
        let alphas: Vec<f64> = left_out.alphas_rad.iter().map(|alpha| alpha.to_degrees().round()).collect();
        assert_eq!(alphas, [-2.0, 2.0]);
        let limit = (left_out.objective_before / 5.0).max(1.5 * left_out.line_error);
        assert!(left_out.objective_after <= limit, "{}: {left_out:?}", airspeed.data.v_m_s);
    }
}

#[test]
fn corrections_respect_the_neighbour_bound_and_the_least_factor_at_every_box() {
    let (file, wing) = wing();
    for airspeed in &measured().airspeeds {
        let c = &airspeed.corrections;
        assert_eq!(c.len(), 672);
        for b in 0..c.len() {
            assert!(c.force[b] >= 0.05 && c.moment[b] >= 0.05);
            if wing.correctable.chord_row[b] == 0 {
                continue;
            }
            for family in [&c.force, &c.moment, &c.pressure_offset] {
                let difference = (family[b] - family[b - 1]).abs();
                assert!(difference <= file.correction.neighbour_bound, "box {b} at {}", airspeed.data.v_m_s);
            }
        }
    }
}

#[test]
fn the_second_campaigns_curvature_is_reported_and_not_fitted() {
    let curved = calibrated("tuflex/measured_curved");
    for airspeed in &curved.airspeeds {
        let found = airspeed.line.nonlinearity.iter().flatten();
        assert!(
            found.clone().count() == 3
                && found.into_iter().any(|test| test.p_value < curved.nonlinearity_level)
        );
        // the model itself is straight but for the weight's 1 - cos(alpha)
        assert!(airspeed.fit.objective[1] >= 0.98 * airspeed.line_floor, "{:?}", airspeed.fit.objective);
        assert!(
            airspeed.fit.objective[1]
                <= 1.02 * airspeed.line_floor + 0.02 * airspeed.noise_floor.unwrap_or(0.0)
        );
    }
    // the first campaign leaves it out
    for airspeed in &measured().airspeeds {
        let level = measured().nonlinearity_level;
        assert!(airspeed.line.nonlinearity.iter().flatten().all(|test| test.p_value > level));
    }
}
