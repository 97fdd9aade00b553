//! What belongs to a calibration beside its fits, worked out by hand.

use super::*;
use crate::tests::{RHO, SLOPE, SOFT_M_NM, Toy, near, noise, point, settings};
use coupling::{CorrectableBoxes, RootLoads, RootSensitivity};

const ALPHAS: [f64; 4] = [-0.1, 0.0, 0.05, 0.1];

fn of_toy(toy: &Toy) -> Campaign {
    let mut campaign = toy.measured(&[10.0, 20.0], &ALPHAS, &toy.uniform(1.0));
    campaign.noise = Some(noise([0.1, 0.1, 0.1, 1e-3]));
    campaign
}

/// A metre of the tip counts as the bending moment that belongs to it, times the setting.
#[test]
fn the_tip_weighs_as_the_moment_that_belongs_to_it() {
    let toy = Toy::new(3, 2);
    let mut campaign = of_toy(&toy);
    let settings = Settings { tip_weight: 3.0, weights: ByLoad { fz: 2.0, mx: 0.5, my: 4.0 }, ..settings(2) };
    let flows = [10.0, 30.0].map(|v_m_s| Flow { v_m_s, rho_kg_m3: RHO });
    let found = |campaign: &Campaign| {
        let data = StaticData::from_campaign(campaign).expect("it is sound");
        Context::new(&toy, RHO, &data, &settings).weights(&flows).expect("it is linear")
    };
    assert_eq!(found(&campaign), [2.0, 0.5, 4.0, 0.0]);
    campaign.tip = TipReading::Zeroed;
    let [fz, mx, my, tip] = found(&campaign);
    assert_eq!([fz, mx, my], [2.0, 0.5, 4.0]);
    near(tip, 3.0 / SOFT_M_NM, 1e-9);
}

/// Of offsets the metric is over the mean square of theory's pressures: even pressures `SLOPE alpha` here.
#[test]
fn offsets_are_measured_in_theoretical_pressures() {
    let toy = Toy::new(3, 2);
    let data = StaticData::from_campaign(&of_toy(&toy)).expect("it is sound");
    let settings = settings(2);
    let context = Context::new(&toy, RHO, &data, &settings);
    let metric = context.metric(&data.airspeeds).expect("it is linear");
    let mean_square = SLOPE * SLOPE * (0.01 + 0.0 + 0.0025 + 0.01) / 4.0;
    // two strips of half of the area each
    for (family, weight) in [1.0, 1.0, 1.0 / mean_square].into_iter().enumerate() {
        let first = context.basis.column(family, 1);
        near(metric[(first, first)], 0.5 * weight, 1e-12);
    }
}

#[test]
fn tares_are_compared_with_the_weight_of_the_model() {
    let mut toy = Toy::new(2, 2);
    toy.weight_n = 20.0;
    let mut campaign = of_toy(&toy);
    let tare = |campaign: &Campaign| {
        let data = StaticData::from_campaign(campaign).expect("it is sound");
        weight_tare(&toy, RHO, &data).expect("it is linear")
    };
    assert_eq!(tare(&campaign), None);
    for (alpha_rad, off) in [(0.0, 3.0), (0.5, -4.0), (1.0, 0.0)] {
        let [fz, mx, my, _] = toy.reads(0.0, alpha_rad, &toy.uniform(1.0));
        campaign.points.push(point(9, 0.0, alpha_rad, [fz + off, mx - 2.0 * off, my, 0.0]));
    }
    let found = tare(&campaign).expect("three rows");
    assert_eq!(found.points, 3);
    let rms = (25.0 / 3.0_f64).sqrt();
    let over = found.rms_over_noise.expect("it is declared");
    for (a, b) in
        [(found.rms.fz, rms), (found.rms.mx, 2.0 * rms), (over.fz, 10.0 * rms), (over.mx, 20.0 * rms)]
    {
        near(a, b, 1e-9);
    }
    assert!(found.rms.my < 1e-9);
    campaign.noise = None;
    assert_eq!(tare(&campaign).expect("three rows").rms_over_noise, None);
}

/// A level shared by all tests: one of each load at each airspeed.
#[test]
fn the_level_of_a_test_is_the_settings_over_their_number() {
    let toy = Toy::new(3, 2);
    let settings = Settings { significance: 0.06, ..settings(2) };
    let found = calibrate(&toy, &of_toy(&toy), &settings).expect("it is sound");
    near(found.nonlinearity_level, 0.01, 1e-12);
    assert!(found.failures().is_empty() && found.faults().is_empty() && found.cone_programs() == 0);
    // a right wing needs no corrections
    assert!(found.airspeeds.iter().all(|at| at.corrections == Corrections::neutral(6)));
}

#[test]
fn endings_and_defects_are_faults_and_cone_programs_add_up() {
    let toy = Toy::new(3, 2);
    let mut found = calibrate(&toy, &of_toy(&toy), &settings(2)).expect("it is sound");
    for (ending, good) in [
        (Ending::Converged, true),
        (Ending::AtNoiseFloor, true),
        (Ending::PosteriorMean, true),
        (Ending::Stalled, false),
        (Ending::InfeasibleBounds, false),
        (Ending::Diverged, false),
    ] {
        found.airspeeds[1].fit.ending = ending;
        let failures = if good { vec![] } else { vec![(20.0, ending)] };
        assert_eq!(found.failures(), failures);
        let faults = found.faults();
        assert_eq!(faults.len(), failures.len());
        assert!(good || faults[0].contains(&format!("20 m/s: {ending:?}")), "{faults:?}");
    }
    found.findings = vec![
        Finding { sentence: "wrong".into(), weight: Weight::Defect },
        Finding { sentence: "odd".into(), weight: Weight::Suspicion },
    ];
    assert_eq!(found.faults()[0], "wrong");
    assert_eq!((found.faults().len(), found.said(&[Weight::Suspicion])), (2, vec!["odd".to_owned()]));
    (found.airspeeds[0].fit.cone_programs, found.airspeeds[1].fit.cone_programs) = (3, 4);
    assert_eq!(found.cone_programs(), 7);
}

#[test]
fn strips_of_corrections_are_as_many_as_boxes_along_the_chord_at_most() {
    let toy = Toy::new(3, 2);
    let of = |strips: usize| calibrate(&toy, &of_toy(&toy), &settings(strips)).is_ok();
    assert_eq!([0, 1, 2, 3].map(of), [false, true, true, false]);
}

/// A wing that diverges beyond an airspeed.
struct Weak(Toy, f64);

impl SteadyModel for Weak {
    fn correctable(&self) -> &CorrectableBoxes {
        self.0.correctable()
    }

    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError> {
        let q_pa = cases[0].flow.dynamic_pressure_pa();
        if q_pa > self.1 {
            return Err(CouplingError::Diverged { q_pa, divergence_pa: Some(self.1) });
        }
        self.0.root_loads(cases, corrections)
    }

    fn has_tip(&self) -> bool {
        false
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        self.0.sensitivities(cases, corrections)
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        self.0.pressure_coefficients(case)
    }
}

#[test]
fn an_airspeed_beyond_divergence_and_a_tip_without_structure_are_refused() {
    let weak = Weak(Toy::new(3, 2), 0.5 * RHO * 15.0 * 15.0);
    let mut campaign = of_toy(&weak.0);
    let said =
        |campaign: &Campaign| calibrate(&weak, campaign, &settings(2)).expect_err("refused").to_string();
    let diverged = said(&campaign);
    assert!(diverged.contains("diverges at 20 m/s, its divergence speed is 15.00 m/s"), "{diverged}");
    campaign.points.truncate(4);
    assert!(calibrate(&weak, &campaign, &settings(2)).is_ok());
    campaign.tip = TipReading::Zeroed;
    assert!(said(&campaign).contains("the wing is rigid"));
    campaign.tip = TipReading::Unused;
    let reads = crate::sensors::Reading::Twist { y_over_span: 0.5 };
    let mut sensor = crate::sensors::Sensor {
        column: "twist".into(),
        reads,
        sigma: 1.0,
        zero: crate::sensors::Zero::WindOff,
        scale: 0.0,
        under: None,
    };
    campaign.sensors = vec![sensor.clone()];
    assert!(said(&campaign).contains("`twist` reads the wing's shape"));
    sensor.reads = crate::sensors::Reading::Shear { y_over_span: 0.5 };
    campaign.sensors = vec![sensor];
    assert!(calibrate(&weak, &campaign, &settings(2)).is_ok());
}
