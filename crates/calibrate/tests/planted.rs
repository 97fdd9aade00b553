//! Campaigns with planted corrections, weights, block offsets and tare errors: what must come back, and what must
//! not. The campaigns are made by the model itself, so the right answer is known.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{campaign, draw, loads, papers_kind, row, small_settings, small_wing, wing_with};
use aero::Corrections;
use calibrate::campaign::ChannelNoise;
use calibrate::{Campaign, Ending, Noise, Settings, StaticPoint, calibrate};
use coupling::ElasticWing;

const ALPHAS_DEG: [f64; 5] = [-4.0, -2.0, 0.0, 2.0, 4.0];

fn noise() -> Noise {
    let static_point = ChannelNoise { fz_n: Some(0.05), mx_nm: Some(0.03), my_nm: Some(0.02), tip_z_m: None };
    Noise { sample: static_point, static_point }
}

fn rows(
    wing: &ElasticWing,
    v_m_s: f64,
    truth: &Corrections,
    block: Option<&str>,
    error: impl Fn(usize, usize) -> f64,
) -> Vec<StaticPoint> {
    let values = loads(wing, v_m_s, &ALPHAS_DEG, truth);
    let noisy = |(i, load): (usize, &[f64; 3])| {
        row(v_m_s, ALPHAS_DEG[i].to_radians(), std::array::from_fn(|c| load[c] + error(i, c)), block)
    };
    values.iter().enumerate().map(noisy).collect()
}

fn exact(wing: &ElasticWing, v_m_s: f64, truth: &Corrections) -> Campaign {
    campaign(rows(wing, v_m_s, truth, None, |_, _| 0.0), Some(noise()))
}

#[test]
fn planted_loads_are_met_to_the_floor_in_few_cone_programs() {
    let wing = small_wing();
    for (v_m_s, offset) in [(18.0, 1.0), (40.0, 0.0)] {
        let result =
            calibrate(&wing, &exact(&wing, v_m_s, &papers_kind(&wing, offset)), &small_settings()).unwrap();
        let airspeed = &result.airspeeds[0];
        let target = 1.02 * airspeed.line_floor + 0.02 * airspeed.noise_floor.unwrap();
        assert!(airspeed.fit.objective[1] <= target, "{:?}", airspeed.fit.objective);
        assert!(airspeed.fit.objective[1] < 0.1 * airspeed.fit.objective[0]);
        assert_eq!(airspeed.fit.ending, Ending::Converged);
        assert!(airspeed.fit.cone_programs <= 6, "{}", airspeed.fit.cone_programs);
    }
}

#[test]
fn random_truths_are_met_to_the_floor_too() {
    let wing = small_wing();
    let boxes = &wing.correctable;
    for seed in 0..16 {
        let random = |k: usize| draw(100 * seed + k);
        let shape = |k: usize, b: usize| {
            let (x, y) = (boxes.chord_row[b] as f64 / 5.0 - 0.5, boxes.y_norm[b]);
            random(k) + random(k + 1) * x + random(k + 2) * (y - 0.5) + random(k + 3) * (y * y - 0.3)
        };
        let truth = Corrections {
            force: (0..boxes.len()).map(|b| 1.0 + 0.2 * shape(0, b)).collect(),
            moment: vec![1.0; boxes.len()],
            pressure_offset: (0..boxes.len()).map(|b| 0.1 * shape(10, b)).collect(),
        };
        let v_m_s = [18.0, 30.0, 40.0][seed % 3];
        let data =
            campaign(rows(&wing, v_m_s, &truth, None, |i, c| 0.01 * random(20 + 3 * i + c)), Some(noise()));
        let result = calibrate(&wing, &data, &small_settings()).unwrap();
        let fit = &result.airspeeds[0].fit;
        assert_eq!(fit.ending, Ending::Converged, "seed {seed}: {:?}", fit.history);
        assert!(fit.cone_programs <= 6, "seed {seed}: {:?}", fit.history);
    }
}

#[test]
fn corrections_respect_every_bound_at_every_box() {
    let wing = small_wing();
    let settings = small_settings();
    let result = calibrate(&wing, &exact(&wing, 18.0, &papers_kind(&wing, 1.0)), &settings).unwrap();
    let c = &result.airspeeds[0].corrections;
    for b in 0..c.len() {
        assert!(c.force[b] >= settings.least_factor && c.moment[b] >= settings.least_factor);
        if wing.correctable.chord_row[b] > 0 {
            for family in [&c.force, &c.moment, &c.pressure_offset] {
                assert!((family[b] - family[b - 1]).abs() <= settings.neighbour_bound, "box {b}");
            }
        }
    }
}

#[test]
fn a_wing_that_is_right_already_is_left_alone() {
    let wing = small_wing();
    let neutral = Corrections::neutral(wing.correctable.len());
    let result = calibrate(&wing, &exact(&wing, 30.0, &neutral), &small_settings()).unwrap();
    assert_eq!(result.airspeeds[0].fit.cone_programs, 0);
    assert_eq!(result.airspeeds[0].corrections, neutral);
}

#[test]
fn six_directions_are_determined_and_the_moment_factor_is_not() {
    let wing = small_wing();
    let result = calibrate(&wing, &exact(&wing, 40.0, &papers_kind(&wing, 0.5)), &small_settings()).unwrap();
    let told = result.airspeeds[0].identifiability.as_ref().unwrap();
    // three channels, each affine in alpha: slope and offset (S25). The weight's 1 - cos(alpha) adds nothing.
    assert_eq!(told.determined_directions, 6, "{:?}", told.singular_values);
    assert!(told.singular_values[6] < 1e-3 * told.singular_values[5], "{:?}", told.singular_values);
    assert_eq!(told.undetermined(), ["moment"]);
    // S31: local box moments are little of My
    assert!(told.leverage.moment[2] < 0.05, "{:?}", told.leverage);
}

#[test]
fn a_planted_weight_does_not_go_into_the_corrections() {
    // Twice the mass in truth and model: the sag changes incidence, weight changes the balance; both are modelled.
    let heavy = wing_with(|planform| {
        planform.boxes.chordwise = 6;
        planform.boxes.spanwise = 14;
        planform.controls.clear();
        let masses = planform.structure.as_mut().unwrap().point_masses_mut();
        for mass in masses {
            mass.mass_kg *= 4.0;
        }
    });
    let neutral = Corrections::neutral(heavy.correctable.len());
    let known = calibrate(&heavy, &exact(&heavy, 40.0, &neutral), &small_settings()).unwrap();
    assert_eq!(known.airspeeds[0].corrections, neutral);
    // A model that does not know the weight must not pass unnoticed: it puts the sag's incidence into corrections ...
    let light = small_wing();
    let mut data = exact(&heavy, 40.0, &neutral);
    let off: Vec<[f64; 3]> = loads(&heavy, 0.0, &[-20.0, 20.0], &neutral);
    data.points.push(row(0.0, (-20.0_f64).to_radians(), off[0], None));
    data.points.push(row(0.0, 20.0_f64.to_radians(), off[1], None));
    let unknown = calibrate(&light, &data, &small_settings()).unwrap();
    assert!(unknown.airspeeds[0].fit.objective[0] > 1.0);
    // ... and the weight tares say that the weight is wrong.
    let tare = unknown.weight_tare.unwrap();
    assert_eq!(tare.points, 2);
    assert!(tare.rms_over_noise.unwrap().fz > 5.0, "{tare:?}");
    let mut checked = exact(&heavy, 40.0, &neutral);
    checked.points.extend_from_slice(&data.points[5..]);
    let right = calibrate(&heavy, &checked, &small_settings()).unwrap().weight_tare.unwrap();
    assert!(right.rms_over_noise.unwrap().fz < 1e-6);
}

/// Three replicates in two blocks at two airspeeds, block B off by `offset`.
fn in_two_blocks(wing: &ElasticWing, truth: &Corrections, offset: [f64; 3]) -> Campaign {
    let sigma = noise().static_point.to_array();
    let mut points = Vec::new();
    for (k, v_m_s) in [22.0, 40.0].into_iter().enumerate() {
        for (replicate, block) in ["A", "A", "B"].into_iter().enumerate() {
            let shift = if block == "B" { offset } else { [0.0; 3] };
            let error =
                |i: usize, c: usize| shift[c] + sigma[c] * draw(1000 * k + 100 * replicate + 10 * i + c);
            points.extend(rows(wing, v_m_s, truth, Some(block), error));
        }
    }
    campaign(points, None)
}

#[test]
fn a_block_offset_is_taken_out_and_does_not_move_the_corrections() {
    let wing = small_wing();
    let truth = papers_kind(&wing, 0.5);
    let planted = [2.0, -1.0, 0.7];
    let with = calibrate(&wing, &in_two_blocks(&wing, &truth, planted), &small_settings()).unwrap();
    let without = calibrate(&wing, &in_two_blocks(&wing, &truth, [0.0; 3]), &small_settings()).unwrap();
    for (c, shift) in planted.into_iter().enumerate() {
        let difference = with.data.blocks[1].offset[c] - with.data.blocks[0].offset[c];
        assert!((difference - shift).abs() < 0.05 * shift.abs(), "{difference} for {shift}");
        // offsets sum to zero over blocks: half of a two-block difference stays as a common offset
        assert!((with.data.blocks[0].offset[c] + with.data.blocks[1].offset[c]).abs() < 1e-12);
        // noise is estimated within blocks, so the offset does not inflate it
        let (a, b) = (with.data.point_sigma.unwrap()[c], without.data.point_sigma.unwrap()[c]);
        assert!((a - b).abs() < 1e-9 * b.max(1.0) + 0.05 * b, "{a} {b}");
    }
    for (a, b) in with.airspeeds.iter().zip(&without.airspeeds) {
        // the corrected wing is the same up to the half of the offset that both blocks share, at every angle
        let (with, without) = (
            loads(&wing, a.data.v_m_s, &ALPHAS_DEG, &a.corrections),
            loads(&wing, b.data.v_m_s, &ALPHAS_DEG, &b.corrections),
        );
        for (angle, (x, y)) in with.iter().zip(&without).enumerate() {
            for c in 0..3 {
                let moved = x[c] - y[c] - 0.5 * planted[c];
                assert!(moved.abs() < 0.1 * planted[c].abs(), "angle {angle} channel {c}: {moved}");
            }
        }
        assert!(a.fit.objective[1] <= 1.02 * a.line_floor + 0.02 * a.noise_floor.unwrap());
    }
}

#[test]
fn a_tare_error_common_to_all_blocks_goes_into_offset_and_spread_not_into_slopes() {
    let wing = small_wing();
    let truth = papers_kind(&wing, 0.5);
    let mut shifted = in_two_blocks(&wing, &truth, [2.0, -1.0, 0.7]);
    for point in &mut shifted.points {
        for (c, load) in point.loads.iter_mut().enumerate() {
            *load = load.map(|value| value + [1.0, -0.6, 0.2][c]);
        }
    }
    let tared = calibrate(&wing, &in_two_blocks(&wing, &truth, [2.0, -1.0, 0.7]), &small_settings()).unwrap();
    let wrong = calibrate(&wing, &shifted, &small_settings()).unwrap();
    let quiet = calibrate(&wing, &in_two_blocks(&wing, &truth, [0.0; 3]), &small_settings()).unwrap();
    for (a, b) in tared.airspeeds.iter().zip(&wrong.airspeeds) {
        // it is followed (no residual is left to tell it by) ...
        assert!(b.fit.objective[1] <= 1.02 * b.line_floor + 0.02 * b.noise_floor.unwrap());
        // ... by offsets, at the angle's slope unchanged
        let slope = |corrections: &Corrections| {
            let l = loads(&wing, a.data.v_m_s, &[-4.0, 4.0], corrections);
            l[1][0] - l[0][0]
        };
        assert!((slope(&a.corrections) / slope(&b.corrections) - 1.0).abs() < 2e-3);
    }
    // The spread of the blocks says how large an offset common to all of them may be: it is in the predicted spread.
    let spread = |result: &calibrate::Calibration| {
        result.airspeeds[1].identifiability.as_ref().unwrap().predicted_sigma
    };
    for c in 0..3 {
        assert!(spread(&tared)[c] > 3.0 * spread(&quiet)[c], "{:?} {:?}", spread(&tared), spread(&quiet));
    }
}

#[test]
fn curvature_is_reported_and_not_fitted() {
    // Without gravity the model is exactly affine in alpha; with it, 1 - cos(alpha) of the weight is curved a little.
    let mut wing = small_wing();
    wing.gravity_m_s2 = 0.0;
    let truth = papers_kind(&wing, 0.2);
    let error = |i: usize, c: usize| [0.05, 0.04, 0.01][c] * (ALPHAS_DEG[i] * ALPHAS_DEG[i] - 8.0);
    let data = campaign(rows(&wing, 30.0, &truth, None, error), Some(noise()));
    let result = calibrate(&wing, &data, &small_settings()).unwrap();
    let airspeed = &result.airspeeds[0];
    let found = airspeed.line.nonlinearity[0].unwrap();
    assert!(found.p_value < result.nonlinearity_level);
    let planted = 0.05 * 1.0_f64.to_degrees().powi(2);
    assert!((found.curvature_per_rad2 / planted - 1.0).abs() < 1e-6, "{found:?} {planted}");
    assert!(airspeed.fit.objective[1] >= airspeed.line_floor * (1.0 - 1e-6));
    let straight = calibrate(&wing, &exact(&wing, 30.0, &truth), &small_settings()).unwrap();
    let level = straight.nonlinearity_level;
    assert!(straight.airspeeds[0].line.nonlinearity.iter().flatten().all(|test| test.p_value > level));
}

#[test]
fn left_out_angles_are_predicted() {
    let wing = small_wing();
    let result = calibrate(&wing, &exact(&wing, 22.0, &papers_kind(&wing, 0.8)), &small_settings()).unwrap();
    let left_out = result.airspeeds[0].left_out.as_ref().unwrap();
    assert_eq!(left_out.alphas_rad.len(), 2);
    assert!(left_out.objective_after < left_out.objective_before / 5.0, "{left_out:?}");
}

#[test]
fn bounds_that_contradict_theory_are_infeasible_not_a_panic() {
    let wing = small_wing();
    let settings = Settings { neighbour_bound: -0.1, ..small_settings() };
    let result = calibrate(&wing, &exact(&wing, 30.0, &papers_kind(&wing, 0.5)), &settings).unwrap();
    assert_eq!(result.airspeeds[0].fit.ending, Ending::InfeasibleBounds);
    assert_eq!(result.failures().len(), 1);
}

#[test]
fn an_airspeed_beyond_divergence_is_an_error() {
    let wing = wing_with(|planform| {
        planform.boxes.chordwise = 4;
        planform.boxes.spanwise = 14;
        planform.controls.clear();
        planform.fairing = None;
        planform.quarter_chord_sweep_deg = -30.0;
    });
    let neutral = Corrections::neutral(wing.correctable.len());
    let v_d = wing.divergence_speed(crate::common::RHO, &neutral).unwrap().unwrap();
    let points = ALPHAS_DEG.iter().map(|a| row(1.1 * v_d, a.to_radians(), [*a, *a, *a], None)).collect();
    let settings = Settings { chord_strips: 4, ..Settings::default() };
    let error = calibrate(&wing, &campaign(points, Some(noise())), &settings).unwrap_err();
    assert!(matches!(error, coupling::CouplingError::Input(_)), "{error}");
    let v_d = format!("divergence speed is {v_d:.2} m/s");
    assert!(error.to_string().contains("the wing diverges") && error.to_string().contains(&v_d), "{error}");
}
