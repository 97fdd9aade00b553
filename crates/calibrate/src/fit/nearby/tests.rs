//! A wing whose loads bend, found on the straight one that is put right about it.

use super::*;
use crate::calibration::Context;
use crate::fit::Ending;
use crate::objective::{line_fit, objective};
use crate::statics::StaticData;
use crate::tests::{RHO, Toy, campaign, point, settings};
use aero::Flow;
use std::sync::atomic::{AtomicUsize, Ordering};

/// By how much readings are less than those of [`Toy`], over their squares: 1/N, 1/(N m), 1/m.
const BENDS: f64 = 4e-3;

/// A toy whose readings r are r - BENDS r^2; asks are counted.
struct Bent {
    toy: Toy,
    asked: AtomicUsize,
}

impl Bent {
    fn new() -> Self {
        Self { toy: Toy::new(3, 2), asked: AtomicUsize::new(0) }
    }

    fn bent(case: &RootSensitivity) -> RootSensitivity {
        let less = |value: f64| value - BENDS * value * value;
        let readings = case.readings();
        let scaled = |by: &Mat<f64>| {
            Mat::from_fn(4, by.ncols(), |c, b| by[(c, b)] * (1.0 - 2.0 * BENDS * readings[c]))
        };
        let [fz_n, mx_nm, my_nm, tip_z_m] = readings.map(less);
        RootSensitivity {
            loads: RootLoads { fz_n, mx_nm, my_nm },
            tip_z_m,
            by_force: scaled(&case.by_force),
            by_moment: scaled(&case.by_moment),
            by_offset: scaled(&case.by_offset),
        }
    }
}

impl SteadyModel for Bent {
    fn correctable(&self) -> &CorrectableBoxes {
        self.toy.correctable()
    }

    fn bends_far(&self) -> bool {
        true
    }

    fn nearby(&self) -> Option<&dyn SteadyModel> {
        Some(&self.toy)
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        self.asked.fetch_add(1, Ordering::Relaxed);
        Ok(self.toy.sensitivities(cases, corrections)?.iter().map(Self::bent).collect())
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        self.toy.pressure_coefficients(case)
    }
}

fn cases(v_m_s: f64) -> Vec<SteadyCase> {
    let flow = Flow { v_m_s, rho_kg_m3: RHO };
    [-0.1, 0.02, 0.1].map(|alpha_rad| SteadyCase::new(flow, alpha_rad)).to_vec()
}

/// Exact where it was put right, readings and derivatives, and off by the square of the way from there.
#[test]
fn it_is_the_model_to_first_order() {
    let (bent, about) = (Bent::new(), Bent::new().toy.uniform(0.8));
    let groups = [cases(10.0), cases(14.0)];
    let own: Vec<RootSensitivity> =
        groups.iter().flat_map(|cases| bent.sensitivities(cases, &about).expect("it is defined")).collect();
    let model = Nearby::new(&bent.toy, about.clone(), &groups, &own).expect("it is defined");
    let mut moved = about.clone();
    let all = moved.force.iter_mut().chain(&mut moved.moment).chain(&mut moved.pressure_offset);
    all.enumerate().for_each(|(at, value)| *value += 0.1 * (at as f64).sin());
    let off = |share: f64| -> f64 {
        let between = |a: &[f64], b: &[f64]| -> Vec<f64> {
            a.iter().zip(b).map(|(a, b)| a + share * (b - a)).collect()
        };
        let at = Corrections {
            force: between(&about.force, &moved.force),
            moment: between(&about.moment, &moved.moment),
            pressure_offset: between(&about.pressure_offset, &moved.pressure_offset),
        };
        let worst = groups.iter().map(|cases| {
            let found = model.sensitivities(cases, &at).expect("it is defined");
            let want = bent.sensitivities(cases, &at).expect("it is defined");
            let one = |(found, want): (&RootSensitivity, &RootSensitivity)| {
                (0..4).map(|c| (found.readings()[c] - want.readings()[c]).abs()).fold(0.0, f64::max)
            };
            found.iter().zip(&want).map(one).fold(0.0, f64::max)
        });
        worst.fold(0.0, f64::max)
    };
    assert!(off(0.0) < 1e-12, "{}", off(0.0));
    let (whole, half) = (off(1.0), off(0.5));
    assert!(whole > 1e-4 && (whole / half - 4.0).abs() < 0.2, "{whole} {half}");
    let found = model.sensitivities(&groups[1], &about).expect("it is defined");
    for (found, want) in found.iter().zip(&own[3..]) {
        for (found, want) in [
            (&found.by_force, &want.by_force),
            (&found.by_moment, &want.by_moment),
            (&found.by_offset, &want.by_offset),
        ] {
            assert!((found - want).norm_max() < 1e-12 * want.norm_max());
        }
    }
}

/// Readings that no straight line follows are met, and the model is asked where the search came to alone.
#[test]
fn a_fit_meets_readings_that_bend_and_asks_the_model_a_few_times() {
    let bent = Bent::new();
    let truth = bent.toy.uniform(1.3);
    let alphas = [-0.1, -0.05, 0.0, 0.05, 0.1];
    let cases: Vec<SteadyCase> =
        alphas.map(|alpha| SteadyCase::new(Flow { v_m_s: 12.0, rho_kg_m3: RHO }, alpha)).to_vec();
    let read = bent.sensitivities(&cases, &truth).expect("it is defined");
    let rows = cases.iter().zip(&read).enumerate();
    let points =
        rows.map(|(at, (case, read))| point(at + 2, 12.0, case.alpha_rad, read.readings())).collect();
    let data =
        StaticData::from_campaign(&campaign(points, Some([0.02, 0.02, 0.01, 1e-3]))).expect("it is sound");
    let settings = settings(2);
    let context = Context::new(&bent, RHO, &data, &settings);
    let metric = context.metric(&data.airspeeds).expect("it is defined");
    let line = line_fit(&data, &data.airspeeds[0]);
    let problem = context.problem(&data.airspeeds[0], &line, &metric).expect("it is defined");
    bent.asked.store(0, Ordering::Relaxed);
    let fit = problem.fit().expect("it is defined");
    let of_lines = objective(line.rmse, problem.weights);
    assert!(matches!(fit.ending, Ending::Converged | Ending::AtNoiseFloor), "{fit:?}");
    assert!(of_lines > 0.01 * fit.objective[0], "no straight line follows them: {of_lines}");
    assert!(fit.objective[1] < 0.1 * of_lines, "{} of {of_lines}", fit.objective[1]);
    assert!(fit.floor <= fit.objective[1], "{fit:?}");
    let asked = bent.asked.load(Ordering::Relaxed);
    assert!(asked <= 4 && asked == fit.history.len(), "{asked} {fit:?}");
}
