//! What a fit has not seen, worked out by hand.

use super::*;
use crate::calibration::calibrate;
use crate::campaign::TipReading;
use crate::tests::{AREA_M2, RHO, SLOPE, Toy, near, noise, settings};
use coupling::ByLoad;

fn angle(alpha_rad: f64, read: [f64; 4]) -> Angle {
    Angle {
        alpha_rad,
        loads: ByLoad::from_array([read[0], read[1], read[2]]),
        tip_z_m: read[3],
        block: 0,
        line: 2,
        replicates: 1,
    }
}

#[test]
fn readings_about_a_line_through_others_are_what_lies_off_it() {
    let on = |alpha: f64| [3.0 + 2.0 * alpha, -1.0 + 4.0 * alpha, 5.0, 0.5 * alpha];
    // the line through readings that scatter evenly about it is the same
    let kept: Vec<Angle> = [(-0.1, 0.2), (0.1, -0.4), (0.3, 0.2)]
        .map(|(alpha, off)| angle(alpha, on(alpha).map(|value| value + off)))
        .to_vec();
    let unseen = [angle(0.2, on(0.2).map(|value| value + 0.7)), angle(-0.3, on(-0.3))];
    let found = line_through(&kept, &unseen, [true, true, false, true]);
    for (row, off) in found.iter().zip([0.7, 0.0]) {
        for c in [0, 1, 3] {
            assert!((row[c] - off).abs() < 1e-12, "{row:?}");
        }
        assert_eq!(row[2], 0.0);
    }
}

#[test]
fn a_zero_is_the_mean_of_the_tip_and_of_nothing_else() {
    let mut rows = [[1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0, 10.0]];
    assert_eq!(mean_tip(&rows), 7.0);
    take_out(&mut rows, 7.0);
    assert_eq!(rows, [[1.0, 2.0, 3.0, -3.0], [5.0, 6.0, 7.0, 3.0]]);
}

#[test]
fn residuals_are_simulated_less_measured() {
    let toy = Toy::new(3, 2);
    let flow = Flow { v_m_s: 10.0, rho_kg_m3: RHO };
    let corrections = toy.uniform(1.5);
    let angles = [0.05, 0.1].map(|alpha| {
        let read = toy.reads(10.0, alpha, &corrections);
        angle(alpha, [read[0] - 1.0, read[1] + 2.0, read[2] - 3.0, read[3] - 4.0])
    });
    for (with_tip, tip) in [(true, [4.0, 4.0]), (false, angles.clone().map(|angle| -angle.tip_z_m))] {
        let found = predicted(&toy, with_tip, flow, &angles, &corrections).expect("it is linear");
        for (row, tip) in found.iter().zip(tip) {
            [1.0, -2.0, 3.0, tip].iter().zip(row).for_each(|(a, b)| assert!((a - b).abs() < 1e-9, "{row:?}"));
        }
    }
}

/// Lift at a factor is missed by the factor less one times theory's lift at the angles that were left out.
#[test]
fn what_theory_misses_at_angles_left_out_is_its_lift_there() {
    let toy = Toy::new(3, 2);
    let alphas = [-0.1, -0.04, 0.0, 0.06, 0.1];
    let mut campaign = toy.measured(&[10.0], &alphas, &toy.uniform(1.1));
    campaign.channels = [true, false, false];
    campaign.noise = Some(noise([1e-3; 4]));
    let calibration = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    let left_out = calibration.airspeeds[0].left_out.as_ref().expect("five angles");
    assert_eq!(left_out.alphas_rad, [-0.04, 0.06]);
    let slope_n = 0.5 * RHO * 100.0 * AREA_M2 * SLOPE;
    let mean_square: f64 = 0.5 * (0.0016 + 0.0036);
    near(left_out.objective_before, 0.1 * slope_n * mean_square.sqrt(), 1e-9);
    assert!(left_out.objective_after < 0.05 * left_out.objective_before, "{left_out:?}");
    // exact lines miss nothing
    assert!(left_out.line_error < 1e-9 * slope_n, "{left_out:?}");
    campaign.points.pop();
    let four = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    assert!(four.airspeeds[0].left_out.is_none());
}

/// Angles left out that lie off the line through the others are as far off it as they were put; a scatter of the
/// whole that is larger
/// counts in its place.
#[test]
fn lines_miss_angles_left_out_by_what_they_are_off() {
    let toy = Toy::new(3, 2);
    let alphas = [-0.1, -0.05, 0.0, 0.05, 0.1];
    let mut campaign = toy.measured(&[10.0], &alphas, &toy.uniform(1.0));
    campaign.channels = [true, false, false];
    campaign.noise = Some(noise([1.0; 4]));
    for (point, off) in campaign.points.iter_mut().zip([0.0, 0.3, 0.0, 0.3, 0.0]) {
        point.loads[0] = point.loads[0].map(|load| load + off);
    }
    let calibration = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    near(calibration.airspeeds[0].left_out.as_ref().expect("five angles").line_error, 0.3, 1e-9);
    // off it at the outer angles alike: a line of its own through them, the whole's residuals at the inner are 0.12
    for (point, off) in campaign.points.iter_mut().zip([0.3, -0.3, 0.0, -0.3, 0.3]) {
        point.loads[0] = point.loads[0].map(|load| load + off);
    }
    let calibration = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    // now 0.3 at both ends: the line through -0.1, 0, 0.1 is 0.2 above, and so are the angles between off it
    near(calibration.airspeeds[0].left_out.as_ref().expect("five angles").line_error, 0.2, 1e-9);
}

#[test]
fn an_airspeed_left_out_has_what_the_schedule_of_the_others_gives_there() {
    let toy = Toy::new(3, 2);
    let speeds = [10.0, 14.0, 20.0];
    let mut campaign = toy.measured(&speeds, &[-0.1, 0.0, 0.05, 0.1], &toy.uniform(1.0));
    campaign.channels = [true, true, false];
    campaign.noise = Some(noise([1e-3; 4]));
    // lift falls with the airspeed
    for point in &mut campaign.points {
        let factor = 1.2 - 0.01 * point.v_m_s;
        point.loads = point.loads.map(|load| load.map(|value| factor * value));
    }
    let calibration = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    for (index, at) in calibration.airspeeds.iter().enumerate() {
        let others = calibration.airspeeds.iter().enumerate().filter(|(other, _)| *other != index);
        let sets = others
            .map(|(_, at)| CorrectionSet { v_m_s: at.data.v_m_s, corrections: at.corrections.clone() })
            .collect();
        let schedule = Schedule {
            wing: String::new(),
            wing_hash: String::new(),
            sets,
            found: None,
            unconverged: vec![],
        };
        let left_out = at.left_out_airspeed.as_ref().expect("three airspeeds");
        let expected = schedule.at_or_nearest(speeds[index]).0;
        let apart = left_out.corrections.force.iter().zip(&expected.force).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-12, "{index}");
        let objective_of = |corrections: &Corrections| -> f64 {
            let rows: Vec<[f64; 4]> = at
                .data
                .angles
                .iter()
                .map(|angle| {
                    let read = toy.reads(at.data.v_m_s, angle.alpha_rad, corrections);
                    std::array::from_fn(|c| read[c] - angle.readings()[c])
                })
                .collect();
            (0..2).map(|c| (rows.iter().map(|row| row[c] * row[c]).sum::<f64>() / 4.0).sqrt()).sum()
        };
        near(left_out.objective_before, objective_of(&toy.uniform(1.0)), 1e-9);
        near(left_out.objective_after, objective_of(&expected), 1e-9);
    }
    campaign.points.truncate(4);
    let alone = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    assert!(alone.airspeeds[0].left_out_airspeed.is_none());
}

/// A zero of the tip that is free is that of the angles that were fitted, or of the airspeed's own: what is shifted
/// with it moves no
/// judgement.
#[test]
fn a_tip_with_a_free_zero_is_judged_about_it() {
    let toy = Toy::new(3, 2);
    let judged = |zero_m: f64, tip: TipReading| {
        let mut campaign = toy.measured(&[10.0, 14.0], &[-0.1, -0.05, 0.0, 0.05, 0.1], &toy.uniform(1.1));
        campaign.tip = tip;
        campaign.noise = Some(noise([1e-2, 1e-2, 1e-2, 1e-5]));
        for point in &mut campaign.points {
            point.tip_z_m = point.tip_z_m.map(|tip_m| tip_m + zero_m);
        }
        let found = calibrate(&toy, &campaign, &settings(2)).expect("it is sound").airspeeds.swap_remove(0);
        let angles = found.left_out.expect("five angles");
        let airspeed = found.left_out_airspeed.expect("two airspeeds");
        [angles.objective_before, airspeed.objective_before]
    };
    let [free, shifted] = [0.0, 0.01].map(|zero_m| judged(zero_m, TipReading::FreeZero));
    let known = judged(0.01, TipReading::Zeroed);
    for k in 0..2 {
        near(shifted[k], free[k], 1e-9);
        assert!(known[k] > 1.02 * free[k], "{known:?} {free:?}");
    }
}
