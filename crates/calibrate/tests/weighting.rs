//! What counts how much: replicates, blocks, change from theory, and the bounds that hold where data pull beyond them.
//! Expected values are stationarity, tables of distributions and estimators as textbooks print them.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, draw, loads, papers_kind, row, small_settings, small_wing, wing_with};
use aero::{Corrections, Flow};
use calibrate::campaign::ChannelNoise;
use calibrate::objective::line_fit;
use calibrate::statics::Angle;
use calibrate::{
    AirspeedData, Campaign, Noise, Sets, Settings, StaticData, StaticPoint, TipReading, calibrate,
};
use coupling::{ByLoad, ElasticWing, SteadyCase, SteadyModel};
use nastran::Span;

const ALPHAS_DEG: [f64; 5] = [-4.0, -2.0, 0.0, 2.0, 4.0];

fn noise(times: f64) -> Noise {
    let [fz_n, mx_nm, my_nm] = [0.05, 0.03, 0.02].map(|sigma| Some(times * sigma));
    let static_point = ChannelNoise { fz_n, mx_nm, my_nm, tip_z_m: Some(times * 2e-4) };
    Noise { sample: static_point, static_point }
}

/// One factor at every box.
fn uniform(wing: &ElasticWing, factor: f64) -> Corrections {
    let boxes = wing.correctable.len();
    Corrections { force: vec![factor; boxes], moment: vec![factor; boxes], pressure_offset: vec![0.0; boxes] }
}

fn rows(wing: &ElasticWing, v_m_s: f64, truth: &Corrections) -> Vec<StaticPoint> {
    let values = loads(wing, v_m_s, &ALPHAS_DEG, truth);
    ALPHAS_DEG.iter().zip(values).map(|(alpha, load)| row(v_m_s, alpha.to_radians(), load, None)).collect()
}

/// A wing that does not bend: its loads are exactly affine in the corrections.
fn rigid_wing() -> ElasticWing {
    wing_with(|planform| {
        planform.boxes.chordwise = 6;
        planform.boxes.spanwise = 14;
        planform.controls.clear();
        planform.structure = None;
    })
}

#[test]
fn k_replicates_with_root_k_times_the_noise_say_what_one_row_says() {
    let wing = small_wing();
    // curvature, so that the tests for it have something to say
    let mut points = rows(&wing, 30.0, &papers_kind(&wing, 0.3));
    for (k, point) in points.iter_mut().enumerate() {
        for (c, load) in point.loads.iter_mut().enumerate() {
            *load = load.map(|value| value + 0.05 * draw(10 * k + c));
        }
    }
    let once = campaign(points.clone(), Some(noise(1.0)));
    let nine_times = campaign(points.iter().cycle().take(45).cloned().collect(), Some(noise(3.0)));
    let results = [once, nine_times].map(|data| calibrate(&wing, &data, &small_settings()).unwrap());
    let [a, b] = [&results[0].airspeeds[0], &results[1].airspeeds[0]];
    let same = |what: &str, a: f64, b: f64| assert!((a - b).abs() < 1e-6 * a.abs(), "{what}: {a} and {b}");
    same("noise floor", a.noise_floor.unwrap(), b.noise_floor.unwrap());
    for c in 0..3 {
        let [x, y] = [a, b].map(|airspeed| airspeed.line.nonlinearity[c].unwrap());
        same("F", x.f, y.f);
        same("p", x.p_value, y.p_value);
        let [x, y] = [a, b].map(|airspeed| airspeed.identifiability.as_ref().unwrap());
        same("singular value", x.singular_values[c], y.singular_values[c]);
        same("predicted spread", x.predicted_sigma[c], y.predicted_sigma[c]);
    }
}

#[test]
fn the_lift_factor_is_where_the_weighted_squares_are_least_and_as_uncertain_as_their_curvature_says() {
    let wing = small_wing();
    let mut points = Vec::new();
    // rows that ask for different factors, one to four times
    for (k, (v_m_s, factor)) in [(20.0, 0.9), (26.0, 1.1), (32.0, 1.0), (38.0, 0.97)].into_iter().enumerate()
    {
        let load = loads(&wing, v_m_s, &[4.0], &uniform(&wing, factor))[0];
        points.extend(std::iter::repeat_n(row(v_m_s, 4.0_f64.to_radians(), load, None), k + 1));
    }
    let replicates = [1.0, 2.0, 3.0, 4.0];
    let measured: Vec<_> = [0, 1, 3, 6].iter().map(|&k: &usize| points[k].clone()).collect();
    let data = Campaign { sets: Sets::Common, ..campaign(points, Some(noise(1.0))) };
    let found = calibrate(&wing, &data, &small_settings()).unwrap().common.unwrap().lift.unwrap();
    let sigma = noise(1.0).static_point.to_array();
    let squares = |factor: f64| -> f64 {
        let row = |(point, count): (&StaticPoint, &f64)| {
            let load = loads(&wing, point.v_m_s, &[4.0], &uniform(&wing, factor))[0];
            (0..3).map(|c| count * ((load[c] - point.loads[c].unwrap()) / sigma[c]).powi(2)).sum::<f64>()
        };
        measured.iter().zip(&replicates).map(row).sum()
    };
    let h = 1e-4;
    let [down, here, up] = [-h, 0.0, h].map(|step| squares(found.factor + step));
    // half the slope over half the curvature is how far the least lies from here
    let off = 0.5 * h * (up - down) / (up - 2.0 * here + down);
    assert!(off.abs() < 1e-4, "the least is {off} away from {found:?}");
    let curvature = 0.5 * (up - 2.0 * here + down) / (h * h);
    let expected = (here / 11.0).sqrt() * found.widening() / curvature.sqrt();
    // Gauss and Newton leave out the second derivative of the residuals, which are large here
    assert!((found.sigma / expected - 1.0).abs() < 0.05, "{} beside {expected}", found.sigma);
}

#[test]
fn factors_stay_at_the_least_one_where_data_ask_for_less() {
    let wing = small_wing();
    let settings = Settings { least_factor: 0.5, ..small_settings() };
    // Loads at a fifth of theory's slope: as little as is allowed is best, everywhere and for both factors.
    let data = campaign(rows(&wing, 30.0, &uniform(&wing, 0.2)), Some(noise(1.0)));
    let result = calibrate(&wing, &data, &settings).unwrap();
    let force = &result.airspeeds[0].corrections.force;
    let (least, most) = force.iter().fold((1.0_f64, 0.0_f64), |(l, m), &w| (l.min(w), m.max(w)));
    assert!(least >= 0.5 && most < 0.505, "force factors from {least} to {most}");
    // One set for all starts from one factor, which must not lie below it either.
    let mut points = Vec::new();
    for v_m_s in [18.0, 24.0, 30.0, 36.0, 40.0] {
        points.extend(rows(&wing, v_m_s, &uniform(&wing, 0.2)));
    }
    let data = Campaign { sets: Sets::Common, ..campaign(points, Some(noise(1.0))) };
    let common = calibrate(&wing, &data, &settings).unwrap().common.unwrap();
    let force = &common.corrections.force;
    let (least, most) = force.iter().fold((1.0_f64, 0.0_f64), |(l, m), &w| (l.min(w), m.max(w)));
    assert!(least >= 0.5 && most < 0.505, "force factors of one set from {least} to {most}");
}

/// Offsets of days measured at the same angles, by name.
fn offsets(days: &[f64], each: usize, sigma: f64) -> Vec<f64> {
    let mut points = Vec::new();
    for alpha_deg in ALPHAS_DEG {
        for (day, offset) in days.iter().enumerate() {
            for _ in 0..each {
                let name = format!("day_{day}");
                points.push(row(30.0, alpha_deg.to_radians(), [alpha_deg + offset; 3], Some(&name)));
            }
        }
    }
    let channel = Some(sigma);
    let static_point = ChannelNoise { fz_n: channel, mx_nm: channel, my_nm: channel, tip_z_m: None };
    let data = campaign(points, Some(Noise { sample: static_point, static_point }));
    StaticData::from_campaign(&data).unwrap().blocks.iter().map(|block| block.offset[0]).collect()
}

/// The best linear unbiased predictor of a balanced one-way random model, as Searle, Casella and McCulloch ("Variance
/// Components", 1992, section 3.4) give it: the offset from the mean of all, times `s² / (s² + sigma²/n)`, with the
/// variance `s²` between groups from the analysis of variance.
#[test]
fn offsets_of_blocks_are_the_predictions_of_random_effects() {
    for days in [vec![-0.4, 0.4], vec![-0.5, -0.1, 0.6], vec![0.4, -0.7, 0.5, -0.2]] {
        let (each, sigma) = (2, 0.9);
        let rows = (5 * each) as f64;
        let groups = days.len() as f64;
        let between = days.iter().map(|offset| offset * offset).sum::<f64>() / (groups - 1.0);
        let variance = between - sigma * sigma / rows;
        let share = variance / (variance + sigma * sigma / rows);
        assert!(share > 0.0 && share < 0.9, "{share}");
        for (found, offset) in offsets(&days, each, sigma).iter().zip(&days) {
            assert!((found - share * offset).abs() < 1e-12, "{found} beside {} of {days:?}", share * offset);
        }
        // no more than noise gives: nothing is taken out
        assert!(offsets(&days, each, 9.0).iter().all(|offset| *offset == 0.0));
    }
}

/// Straight-line tests of readings at angles -2 to 2 (any unit), noise from `noise_dof` degrees of freedom or unknown.
fn p_and_f(readings: &[f64], sigma: Option<f64>, noise_dof: Option<usize>) -> (f64, f64) {
    let half = 0.5 * (readings.len() - 1) as f64;
    let angle = |(k, reading): (usize, &f64)| Angle {
        alpha_rad: k as f64 - half,
        loads: ByLoad::from_fn(|_| *reading),
        tip_z_m: 0.0,
        block: 0,
        line: k,
        replicates: 1,
    };
    let airspeed = AirspeedData {
        v_m_s: 30.0,
        angles: readings.iter().enumerate().map(angle).collect(),
        span: Span::generated("test"),
    };
    let data = StaticData {
        channels: [true, false, false, false],
        tip: TipReading::Unused,
        sets: Sets::EachAirspeed,
        block_names: Vec::new(),
        airspeeds: Vec::new(),
        blocks: Vec::new(),
        block_sigma: [0.0; 4],
        point_sigma: sigma.map(|sigma| [sigma; 4]),
        noise_dof,
        weight_tares: Vec::new(),
        sensors: Vec::new(),
        further: Vec::new(),
    };
    let found = line_fit(&data, &airspeed).nonlinearity[0].unwrap();
    (found.p_value, found.f)
}

#[test]
fn tests_for_curvature_agree_with_the_tables_of_their_distributions() {
    // contrasts that no straight line has a share of: parabola and cubic on five equidistant angles, squares 14 and 10
    let parabola = [2.0, -1.0, -2.0, -1.0, 2.0];
    let cubic = [-1.0, 2.0, 0.0, -2.0, 1.0];
    let reading = |a: f64, b: f64| -> Vec<f64> {
        (0..5).map(|k| 0.3 + 0.7 * k as f64 + a * parabola[k] + b * cubic[k]).collect()
    };
    // tables at 5 %: F(3, 10) = 3.708, chi²(3) = 7.815, F(1, 2) = 18.513
    let close = |what: &str, (p, f): (f64, f64), expected: f64| {
        assert!((f - expected).abs() < 1e-9 * expected, "{what}: F = {f}");
        assert!((p - 0.05).abs() < 5e-5, "{what}: p = {p} at F = {f}");
    };
    let a = (3.708_f64 * 3.0 / 14.0).sqrt();
    close("noise from replicates", p_and_f(&reading(a, 0.0), Some(1.0), Some(10)), 3.708);
    let a = (7.815_f64 / 14.0).sqrt();
    close("declared noise", p_and_f(&reading(a, 0.0), Some(1.0), None), 7.815 / 3.0);
    let a = (18.513_f64 * 10.0 / 2.0 / 14.0).sqrt();
    close("noise from the parabola's scatter", p_and_f(&reading(a, 1.0), None, None), 18.513);
}

/// Area-weighted mean square of the theoretical pressures over the angles.
fn mean_square_pressure(wing: &ElasticWing, v_m_s: f64) -> f64 {
    let flow = Flow { v_m_s, rho_kg_m3: RHO };
    let at = |alpha: &f64| {
        let cp = wing.pressure_coefficients(&SteadyCase::new(flow, alpha.to_radians())).unwrap();
        cp.iter().zip(&wing.correctable.area_share).map(|(cp, share)| share * cp * cp).sum::<f64>()
    };
    ALPHAS_DEG.iter().map(at).sum::<f64>() / 5.0
}

#[test]
fn without_a_word_from_the_data_offsets_are_as_uncertain_as_factors_times_the_theoretical_pressure() {
    let wing = small_wing();
    let data = campaign(rows(&wing, 30.0, &papers_kind(&wing, 0.3)), Some(noise(1e7)));
    let result = calibrate(&wing, &data, &small_settings()).unwrap();
    let calibrate::ByFamily { force, moment, pressure_offset: offset } =
        result.airspeeds[0].identifiability.as_ref().unwrap().posterior_sigma;
    assert!((moment / force - 1.0).abs() < 1e-6, "{force} {moment}");
    let expected = mean_square_pressure(&wing, 30.0).sqrt();
    assert!((offset / force / expected - 1.0).abs() < 1e-6, "{} beside {expected}", offset / force);
}

#[test]
fn one_cone_program_weighs_data_and_change_of_pressure_as_the_settings_say() {
    let wing = rigid_wing();
    // so much weight on theory that nothing is met exactly, and every error is smooth
    let settings =
        Settings { change_weight: 300.0, most_cone_programs: 1, neighbour_bound: 9.0, ..small_settings() };
    let mut truth = papers_kind(&wing, 0.3);
    truth.moment.iter_mut().enumerate().for_each(|(b, w)| *w += 0.1 * draw(b));
    let data = campaign(rows(&wing, 30.0, &truth), Some(noise(1.0)));
    let result = calibrate(&wing, &data, &settings).unwrap();
    let found = &result.airspeeds[0].corrections;
    let at = |share: f64| {
        let on_the_way = |one: f64, values: &[f64]| values.iter().map(|w| one + share * (w - one)).collect();
        let corrections = Corrections {
            force: on_the_way(1.0, &found.force),
            moment: on_the_way(1.0, &found.moment),
            pressure_offset: on_the_way(0.0, &found.pressure_offset),
        };
        let simulated = loads(&wing, 30.0, &ALPHAS_DEG, &corrections);
        let mean_square = |c: usize| {
            let miss = |(load, point): (&[f64; 3], &StaticPoint)| (load[c] - point.loads[c].unwrap()).powi(2);
            simulated.iter().zip(&data.points).map(miss).sum::<f64>() / 5.0
        };
        (0..3).map(|c| mean_square(c).sqrt()).sum::<f64>()
    };
    let square = mean_square_pressure(&wing, 30.0);
    let change: f64 = (0..found.len())
        .map(|b| {
            let factors = (found.force[b] - 1.0).powi(2) + (found.moment[b] - 1.0).powi(2);
            wing.correctable.area_share[b] * (factors + found.pressure_offset[b].powi(2) / square)
        })
        .sum();
    // On the way from theory (share 0) to what was found (share 1), F + mu change share² is least at 1.
    let h = 1e-3;
    let slope = (at(1.0 + h) - at(1.0 - h)) / (2.0 * h);
    let weight = -slope / (2.0 * change);
    let expected = settings.change_weight * at(0.0);
    assert!(change > 1e-5 && at(1.0) < 0.99 * at(0.0), "nothing was moved: {change}");
    assert!((weight / expected - 1.0).abs() < 1e-3, "{weight} beside {expected}");
}
