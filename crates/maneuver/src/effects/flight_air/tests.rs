//! Corrections of a rigid wing's boxes by hand.

use super::*;
use crate::small::{CHORD_M, rigid};

/// Corrections that differ from box to box.
fn uneven(wing: &ElasticWing) -> Corrections {
    let boxes = 0..wing.correctable.len();
    Corrections {
        force: boxes.clone().map(|k| 1.0 + 0.1 * k as f64).collect(),
        moment: boxes.clone().map(|k| 0.9 - 0.05 * k as f64).collect(),
        pressure_offset: boxes.map(|k| 0.01 * k as f64 - 0.02).collect(),
    }
}

/// Force, moment and offset of a box before and after, and its place in the lattice.
fn assert_changes(
    wing: &ElasticWing,
    act: impl Fn(&mut FlightAir<'_>),
    wanted: impl Fn([f64; 3], usize, usize) -> [f64; 3],
) {
    let before = uneven(wing);
    let mut after = before.clone();
    act(&mut FlightAir { wing, v_m_s: 20.0, corrections: &mut after });
    for (k, &j) in wing.correctable.places.iter().enumerate() {
        let of = |c: &Corrections| [c.force[k], c.moment[k], c.pressure_offset[k]];
        for (found, wanted) in of(&after).into_iter().zip(wanted(of(&before), k, j)) {
            assert!((found - wanted).abs() < 1e-12, "box {k}: {found} {wanted}");
        }
    }
}

#[test]
fn corrections_take_the_lift_of_a_changed_slope_tip_or_angle() {
    let wing = rigid([2, 4], |j| 0.02 + 0.01 * j as f64);
    let (camber, alpha) = (wing.pressures_of_camber(), wing.pressures_by_alpha());
    assert!(camber[3].abs() > 1e-3 && alpha[3].abs() > 0.1);
    // of a force factor times (cp of camber + cp of alpha) plus an offset the first stays
    assert_changes(
        &wing,
        |air| air.scale_slope(0.3),
        |[f, m, o], _, j| [1.3 * f, 1.3 * m, o + f * camber[j] - 1.3 * f * camber[j]],
    );
    // middles of the strips at 1/8, 3/8, 5/8, 7/8 of the span
    assert_changes(
        &wing,
        |air| air.lose_to_tip(0.4),
        |[f, m, o], k, _| {
            let y = [1.0, 3.0, 5.0, 7.0][k / 2] / 8.0;
            [f, m, o].map(|value| value * (1.0 - 0.4 * y * y))
        },
    );
    assert_changes(&wing, |air| air.incline(0.02), |[f, m, o], _, j| [f, m, o + 0.02 * f * alpha[j]]);
}

#[test]
fn lift_that_acts_further_aft_is_a_moment_of_its_arm_on_every_box() {
    for rows in [1, 2, 3] {
        let wing = rigid([rows, 4], |_| 0.0);
        // moments of boxes are in quarters of their own chords
        let quarter = 0.25 * CHORD_M / f64::from(rows);
        assert_changes(
            &wing,
            |air| air.shift_aft(0.05),
            |[f, m, o], _, _| [f, m - 0.05 * CHORD_M * f / quarter, o],
        );
    }
}

#[test]
fn a_moment_coefficient_of_strips_carries_no_lift() {
    for rows in [1_u32, 2, 3] {
        let wing = rigid([rows, 4], |_| 0.0);
        let mut corrections = uneven(&wing);
        FlightAir { wing: &wing, v_m_s: 20.0, corrections: &mut corrections }.add_moment(0.08);
        let before = uneven(&wing);
        assert_eq!((&corrections.force, &corrections.moment), (&before.force, &before.moment));
        let share = 1.0 / f64::from(rows);
        let added: Vec<f64> =
            corrections.pressure_offset.iter().zip(&before.pressure_offset).map(|(a, b)| a - b).collect();
        for strip in added.chunks(rows as usize) {
            // pressures times area, and times the way forward from the middle of the chord
            let lift: f64 = strip.iter().map(|cp| cp * share).sum();
            let middles = (0..rows).map(|row| 0.5 - (f64::from(row) + 0.5) * share);
            let moment: f64 = strip.iter().zip(middles).map(|(cp, forward)| cp * share * forward).sum();
            let wanted = if rows > 1 { 0.08 } else { 0.0 };
            assert!(lift.abs() < 1e-12 && (moment - wanted).abs() < 1e-12, "{rows}: {lift} {moment}");
        }
    }
}

#[test]
fn effects_of_the_reynolds_number_grow_below_30_metres_a_second() {
    let wing = rigid([1, 2], |_| 0.0);
    let mut corrections = uneven(&wing);
    for (v_m_s, wanted) in [(15.0, 1.0), (60.0, -0.5), (30.0, 0.0), (0.0, 0.0)] {
        assert_eq!(FlightAir { wing: &wing, v_m_s, corrections: &mut corrections }.slower(), wanted);
    }
}
