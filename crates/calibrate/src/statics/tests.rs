//! Means of rows, offsets of blocks and noise, worked out by hand.

use super::*;
use crate::tests::{campaign, near, point};

/// Rows of two days at three angles and an airspeed: the second day reads more by an offset, and a reading scatters
/// by an even amount
/// about its mean.
fn days(offset: f64, scatter: f64) -> Vec<StaticPoint> {
    let mut points = Vec::new();
    for (i, alpha_rad) in [0.0, 0.1, 0.2].into_iter().enumerate() {
        for (day, by) in [("A", 0.0), ("B", offset)] {
            for sign in [1.0, -1.0] {
                let value = 10.0 * i as f64 + by + sign * scatter;
                let mut row =
                    point(points.len() + 2, 10.0, alpha_rad, [value, 2.0 * value, -value, 0.01 * value]);
                row.block = Some(day.into());
                points.push(row);
            }
        }
    }
    points
}

fn data(points: Vec<StaticPoint>, sigma: Option<[f64; 4]>) -> (Campaign, StaticData) {
    let campaign = campaign(points, sigma);
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    (campaign, data)
}

/// Twelve rows of three angles and two days: 12 - 3 - 1 degrees of freedom, and squares of the scatter alone.
#[test]
fn noise_is_pooled_over_angles_and_days() {
    let (_, found) = data(days(4.0, 0.5), None);
    assert_eq!(found.noise_dof, Some(8));
    let sigma = found.point_sigma.expect("it is repeated");
    near(sigma[0], (12.0 * 0.25 / 8.0_f64).sqrt(), 1e-9);
    near(sigma[1], 2.0 * (12.0 * 0.25 / 8.0_f64).sqrt(), 1e-9);
    assert_eq!((sigma[3], &found.block_names), (0.0, &vec!["A".to_owned(), "B".to_owned()]));
    let mean = found.mean_sigma(&found.airspeeds[0].angles[0]).expect("it is known");
    near(mean[0], sigma[0] / 2.0, 1e-12);
    // paper 1, Eq. 8 of the noise of a mean: four rows an angle
    let floor = found.noise_floor(&found.airspeeds[0], [1.0, 0.5, 2.0, 7.0]).expect("it is known");
    near(floor, 0.5 * (sigma[0] + 0.5 * sigma[1] + 2.0 * sigma[2]), 1e-12);
    let (_, declared) = data(days(4.0, 0.5), Some([0.1, 0.2, 0.3, 0.0]));
    assert_eq!((declared.noise_dof, declared.point_sigma), (None, Some([0.1, 0.2, 0.3, 0.0])));
    let mut once = days(0.0, 0.5);
    once.retain(|row| row.span.line % 4 == 2);
    assert_eq!(data(once, None).1.point_sigma, None);
}

/// The estimate of each offset is half of the difference of days, `d/2`; noise of either is `sigma² / 12` (six rows a
/// day about the mean
/// of both). The spread of days is `d²/2 - sigma²/6`, half of which stands beside that noise.
#[test]
fn offsets_are_taken_out_and_their_mean_is_uncertain_by_their_spread() {
    let (_, found) = data(days(4.0, 0.5), Some([1.2, 2.4, 1.2, 0.0]));
    let (half, variance) = (2.0, 1.44 / 12.0);
    let spread = 2.0 * half * half - 2.0 * variance;
    let offset = half * 0.5 * spread / (0.5 * spread + variance);
    for (block, sign) in found.blocks.iter().zip([-1.0, 1.0]) {
        near(block.offset[0], sign * offset, 1e-9);
        near(block.offset[1], sign * 2.0 * offset, 1e-9);
        assert_eq!(block.offset[3], 0.0);
    }
    near(found.block_sigma[0], spread.sqrt(), 1e-9);
    near(found.common_sigma()[1], 2.0 * (spread / 2.0).sqrt(), 1e-9);
    for (i, angle) in found.airspeeds[0].angles.iter().enumerate() {
        near(angle.loads.fz, 10.0 * i as f64 + 2.0, 1e-9);
        assert_eq!((angle.replicates, angle.block, angle.line), (4, 0, 4 * i + 2));
    }
    let mut row = point(99, 10.0, 0.0, [0.0; 4]);
    assert_eq!(found.offset_of(&row, 0), 0.0);
    row.block = Some("B".into());
    near(found.offset_of(&row, 2), -offset, 1e-9);
    // one day alone has no offset
    let mut one = days(4.0, 0.5);
    one.retain(|row| row.block.as_deref() == Some("A"));
    let (_, one) = data(one, None);
    assert!(one.blocks.is_empty() && one.block_sigma == [0.0; 4] && one.common_sigma() == [0.0; 4]);
}

#[test]
fn a_common_set_keeps_days_apart_and_leaves_the_zero_of_the_tip_to_the_fit() {
    let mut all = campaign(days(4.0, 0.5), None);
    (all.sets, all.tip) = (Sets::Common, TipReading::FreeZero);
    let found = StaticData::from_campaign(&all).expect("it is sound");
    let of: Vec<_> =
        found.airspeeds[0].angles.iter().map(|angle| (angle.block, angle.line, angle.replicates)).collect();
    assert_eq!(of, [(0, 2, 2), (1, 4, 2), (0, 6, 2), (1, 8, 2), (0, 10, 2), (1, 12, 2)]);
    assert_eq!([found.blocks[1].offset[3], found.block_sigma[3]], [0.0; 2]);
    near(found.airspeeds[0].angles[1].tip_z_m, 0.04, 1e-12);
    near(found.airspeeds[0].angles[0].loads.fz, found.airspeeds[0].angles[1].loads.fz, 0.03);
}

#[test]
fn airspeeds_are_means_over_all_of_their_rows() {
    let rows = [
        (10.0, 0.0),
        (10.01, 0.1),
        (10.01, 0.1),
        (10.01, 0.1),
        (10.0, 0.2),
        (20.0, 0.0),
        (20.0, 0.1),
        (20.0, 0.2),
    ];
    let points =
        rows.iter().enumerate().map(|(i, &(v_m_s, alpha))| point(i + 2, v_m_s, alpha, [i as f64; 4]));
    let (_, found) = data(points.collect(), None);
    let speeds: Vec<f64> = found.airspeeds.iter().map(|airspeed| airspeed.v_m_s).collect();
    near(speeds[0], 50.03 / 5.0, 1e-12);
    assert_eq!((speeds.len(), speeds[1], found.airspeeds[1].span.line), (2, 20.0, 7));
    near(found.airspeeds[0].angles[1].loads.fz, 2.0, 1e-12);
}

/// What is not seen has neither part in means, offsets and noise of the rest nor a word in what it is told by.
#[test]
fn what_is_left_out_loses_the_offsets_that_the_others_give() {
    let mut points = days(4.0, 0.5);
    for row in points.iter_mut().filter(|row| row.alpha_rad == 0.1) {
        row.loads[0] = row.loads[0].map(|load| load + 100.0);
    }
    let (all, found) = data(points, None);
    let (seen, unseen) = found.without(&all, |airspeed, angle| airspeed == 0 && angle == 1);
    assert_eq!(seen.airspeeds[0].angles.iter().map(|angle| angle.alpha_rad).collect::<Vec<_>>(), [0.0, 0.2]);
    assert_eq!((seen.noise_dof, unseen.len(), unseen[0].angles.len()), (Some(5), 1, 1));
    near(seen.point_sigma.expect("it is repeated")[0], (8.0 * 0.25 / 5.0_f64).sqrt(), 1e-9);
    // two rows of each day: the offsets cancel
    near(unseen[0].angles[0].loads.fz, 112.0, 1e-9);
    let (all, found) = data(all.points, Some([0.3; 4]));
    let (seen, _) = found.without(&all, |_, angle| angle == 0);
    assert_eq!((seen.point_sigma, seen.noise_dof), (Some([0.3, 0.3, 0.3, 0.3]), None));
}

#[test]
fn rows_with_wind_off_or_controls_are_kept_beside() {
    let mut points = days(0.0, 0.5);
    points.push(point(90, 0.0, 0.3, [1.0; 4]));
    let mut deflected = point(91, 10.0, 0.3, [1.0; 4]);
    deflected.controls_rad = vec![("flap".into(), 0.1)];
    points.push(deflected);
    let (mut all, found) = data(points, None);
    assert_eq!(found.airspeeds[0].angles.len(), 3);
    let lines = |rows: &[StaticPoint]| rows.iter().map(|row| row.span.line).collect::<Vec<_>>();
    assert_eq!((lines(&found.weight_tares), lines(&found.further)), (vec![90], vec![91]));
    assert!(found.is_more_than_root_loads());
    all.points.pop();
    let mut found = StaticData::from_campaign(&all).expect("it is sound");
    assert!(!found.is_more_than_root_loads());
    found.channels[TIP] = true;
    assert!(found.is_more_than_root_loads());
}
