//! Statistics beside `measured_against_calculated.json`, and verdicts on campaigns whose truth is known.

use crate::close::close;
use crate::common::{number, reference};
use loads::compare::statistics::{Interval, holm, wilson};
use loads::compare::{Comparison, Gauge, Judged, Point, Thresholds, Verdict, Zero, judge};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use serde_json::Value;

const ASKED: Thresholds = Thresholds { reliable_within: 0.05, bias_within_sigma: 2.0, large_from: 0.6 };

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().expect("numbers").iter().map(number).collect()
}

fn comparison(calculated: &[f64], measured: &[f64], sigma: Option<f64>) -> Comparison {
    let pairs = calculated.iter().zip(measured);
    let point = |(&calculated, &measured)| Point { calculated, measured, state_sigma: 0.0, fitted: false };
    Comparison {
        name: "root Mx".into(),
        unit: "N m",
        gauge: Gauge { sigma, factor_sigma: 0.0, zero: Zero::Known },
        points: pairs.map(point).collect(),
    }
}

fn of_reference(name: &str) -> (Comparison, Value) {
    let set = reference("measured_against_calculated.json")["sets"][name].clone();
    let comparison = comparison(&numbers(&set["calculated"]), &numbers(&set["measured"]), None);
    (comparison, set["expected"].clone())
}

fn one(comparison: &Comparison) -> Judged {
    judge(std::slice::from_ref(comparison), &ASKED).remove(0)
}

fn ends(ours: Interval, value: &Value, interval: &Value, what: &str) {
    close(ours.value, value, 1e-9, what);
    close(ours.low, &interval[0], 1e-9, &format!("lower end of {what}"));
    close(ours.high, &interval[1], 1e-9, &format!("upper end of {what}"));
}

#[test]
fn slopes_intercepts_bias_and_shares_with_their_intervals_are_those_of_the_reference() {
    for name in ["good", "unconservative", "few_points"] {
        let (comparison, expected) = of_reference(name);
        let ours = one(&comparison);
        let line = ours.line.unwrap();
        ends(line.slope, &expected["slope_measured_over_calculated"], &expected["slope_95"], "slope");
        ends(line.intercept, &expected["intercept"], &expected["intercept_95"], "intercept");
        let through = (&expected["slope_through_zero"], &expected["slope_through_zero_95"]);
        ends(line.slope_through_zero, through.0, through.1, "slope through zero");
        ends(ours.bias.unwrap(), &expected["bias_calculated_minus_measured"], &expected["bias_95"], "bias");
        close(line.r2, &expected["r2"], 1e-9, "r2");
        close(line.residual_sigma, &expected["residual_sigma"], 1e-9, "residual sigma");
        close(ours.rms_percent.unwrap(), &expected["rms_percent_of_measured_range"], 1e-9, "rms");
        let share = &expected["conservative"];
        assert_eq!(ours.conservative.k as u64, share["k"].as_u64().unwrap(), "{name}");
        ends(ours.conservative.share, &share["share"], &share["wilson_95"], "Wilson's interval");
        let large = expected["points_at_60_percent_of_largest"].as_array().unwrap().len();
        assert_eq!(ours.large, large, "{name}");
        close(
            ours.worst_ratio.unwrap(),
            &expected["smallest_ratio_calculated_over_measured_there"],
            1e-9,
            "smallest ratio at large loads",
        );
    }
}

#[test]
fn verdicts_of_the_reference_sets_are_what_was_planted() {
    let verdict = |name| one(&of_reference(name).0);
    assert_eq!(verdict("good").verdict, Verdict::Reliable, "{:?}", verdict("good").reasons);
    assert_eq!(verdict("unconservative").verdict, Verdict::Unconservative);
    assert_eq!(verdict("few_points").verdict, Verdict::Undetermined, "four points");
    // The same with the sigma that the residuals have, as a stated one.
    let (mut set, _) = of_reference("unconservative");
    set.gauge.sigma = Some(20.6);
    assert_eq!(one(&set).verdict, Verdict::Unconservative);
}

fn ramp(n: usize) -> Vec<f64> {
    (0..n).map(|at| -300.0 + 1300.0 * at as f64 / (n - 1) as f64).collect()
}

#[test]
fn a_slope_within_half_a_percent_of_sixty_points_is_reliable_and_large_loads_that_are_ample_are_conservative()
{
    let mut noise = Noise::new(7);
    for slope in [0.995, 1.005] {
        let calculated = ramp(60);
        let measured: Vec<f64> = calculated.iter().map(|c| slope * c + 3.0 * noise.next()).collect();
        let ours = one(&comparison(&calculated, &measured, Some(3.0)));
        assert_eq!(ours.verdict, Verdict::Reliable, "{:?}", ours.reasons);
        let ample: Vec<f64> = calculated.iter().map(|c| 0.8 * c + 3.0 * noise.next()).collect();
        let ours = one(&comparison(&calculated, &ample, Some(3.0)));
        assert_eq!(ours.verdict, Verdict::Conservative, "{:?}", ours.reasons);
    }
}

#[test]
fn points_that_fitted_corrections_never_count_and_without_others_nothing_is_determined() {
    let (mut set, _) = of_reference("unconservative");
    let judged = one(&set);
    let points = set.points.clone();
    set.points.extend(points.iter().map(|point| Point {
        measured: 9.0 * point.measured,
        fitted: true,
        ..*point
    }));
    let more = one(&set);
    assert_eq!((more.fitted, more.line, more.verdict), (points.len(), judged.line, judged.verdict));
    set.points.retain(|point| point.fitted);
    let none = one(&set);
    assert_eq!((none.verdict, none.points, none.line), (Verdict::Undetermined, 0, None));
    assert!(none.reasons[0].starts_with("0 points"), "{:?}", none.reasons);
}

#[test]
fn a_free_zero_is_found_with_the_slope_and_no_bias_is_judged() {
    let calculated = ramp(40);
    let mut noise = Noise::new(3);
    let measured: Vec<f64> = calculated.iter().map(|c| c + 80.0 + 2.0 * noise.next()).collect();
    let known = comparison(&calculated, &measured, Some(2.0));
    assert_ne!(one(&known).verdict, Verdict::Reliable, "an offset of 40 sigma");
    let free = Comparison { gauge: Gauge { zero: Zero::Free, ..known.gauge }, ..known };
    assert_eq!(one(&free).verdict, Verdict::Reliable, "{:?}", one(&free).reasons);
}

#[test]
fn calculated_loads_of_the_wrong_sign_are_unconservative() {
    let calculated = ramp(20);
    let measured: Vec<f64> = calculated.iter().map(|c| -c).collect();
    assert_eq!(one(&comparison(&calculated, &measured, Some(3.0))).verdict, Verdict::Unconservative);
}

#[test]
fn holms_steps_are_those_of_the_textbook_example_and_wilson_holds_at_the_ends() {
    // Holm (1979): 0.01, 0.04, 0.03, 0.005 at 0.05 leave the first and the last.
    assert_eq!(holm(&[0.01, 0.04, 0.03, 0.005], 0.05), [true, false, false, true]);
    assert_eq!(wilson(0, 0), Interval { value: 0.0, low: 0.0, high: 1.0 });
    // Of none of ten the upper end is z^2/(n + z^2).
    let z2 = 1.959_963_984_540_054f64.powi(2);
    assert!((wilson(0, 10).high - z2 / (10.0 + z2)).abs() < 1e-12);
}

struct Noise(ChaCha8Rng);

impl Noise {
    fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    fn next(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }
}

/// Errors of a drawn campaign, shares of the largest load or of the load.
#[derive(Clone, Copy)]
struct Errors {
    reading: f64,
    factor: f64,
    state: f64,
}

/// Three stations with three loads each, 24 points: measured over calculated is `slope` but for errors that the gauges state.
fn campaign(noise: &mut Noise, slope: f64, errors: Errors) -> Vec<Comparison> {
    let mut all = Vec::new();
    for station in 0..3 {
        for load in 0..3 {
            let largest = 100.0 * f64::from(station + 1) * f64::from(load + 1);
            let factor = 1.0 + errors.factor * noise.next();
            let point = |at: i32| {
                let truth = largest * (f64::from(at) / 12.0 - 1.0);
                let state_sigma = errors.state * truth.abs();
                Point {
                    calculated: truth / slope + state_sigma * noise.next(),
                    measured: factor * truth + errors.reading * largest * noise.next(),
                    state_sigma,
                    fitted: false,
                }
            };
            let points = (0..24).map(point).collect();
            let gauge = Gauge {
                sigma: Some(errors.reading * largest),
                factor_sigma: errors.factor,
                zero: Zero::Known,
            };
            all.push(Comparison { name: format!("{station} {load}"), unit: "N", gauge, points });
        }
    }
    all
}

/// How many of 1000 campaigns have a verdict `unconservative`.
fn alarms(seed: u64, slope: f64, errors: Errors) -> usize {
    let mut noise = Noise::new(seed);
    let is_alarm = |_: &usize| {
        let all = judge(&campaign(&mut noise, slope, errors), &ASKED);
        all.iter().any(|judged| judged.verdict == Verdict::Unconservative)
    };
    (0..1000).filter(is_alarm).count()
}

#[test]
fn of_a_thousand_campaigns_with_true_loads_at_most_every_fortieth_is_called_unconservative() {
    for errors in [
        Errors { reading: 0.03, factor: 0.0, state: 0.0 },
        Errors { reading: 0.03, factor: 0.02, state: 0.01 },
        Errors { reading: 0.01, factor: 0.04, state: 0.0 },
    ] {
        let found = alarms(1, 1.0, errors);
        println!("{found} of 1000 without a fault");
        assert!(wilson(found, 1000).low <= 0.025, "{found} of 1000");
    }
}

#[test]
fn even_where_loads_are_calculated_just_at_what_is_asked_at_most_every_fortieth_campaign_is() {
    // Calculated is 0.95 of the truth, the least that is no fault: every point is at the edge, which is the worst case of Holm's steps.
    let edge = 1.0 / (1.0 - ASKED.reliable_within);
    for errors in [
        Errors { reading: 0.03, factor: 0.0, state: 0.0 },
        Errors { reading: 0.03, factor: 0.02, state: 0.01 },
    ] {
        let mut noise = Noise::new(2);
        // The slope, 1.0526, is above 1 + r: that one is no false alarm and is not counted.
        let is_alarm = |_: &usize| {
            let all = judge(&campaign(&mut noise, edge, errors), &ASKED);
            let mut reasons = all.iter().flat_map(|judged| &judged.reasons);
            reasons.any(|why| why.contains("large loads calculated below"))
        };
        let found = (0..1000).filter(is_alarm).count();
        println!("{found} of 1000 at the edge");
        assert!(wilson(found, 1000).low <= 0.025, "{found} of 1000");
        assert!(alarms(3, 1.15, errors) > 900, "loads 15 % too small are found");
    }
}
