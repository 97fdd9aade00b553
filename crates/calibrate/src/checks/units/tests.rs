//! Factors that only a unit explains.

use super::*;
use crate::statics::Angle;
use crate::tests::{RHO, Toy};
use coupling::{ByLoad, RootLoads};

#[test]
fn a_factor_needs_a_word_outside_a_fifth_to_five() {
    let said = |ratio: f64| meaning(&LOADS, ratio);
    for ratio in [0.2, 1.0, 4.99] {
        assert_eq!(said(ratio), None, "{ratio}");
    }
    assert!(said(5.0).expect("five").contains("no unit explains"));
    assert!(said(0.0).expect("none").contains("no unit explains"));
    for ratio in [-0.3, -1.0, -4.9] {
        assert!(said(ratio).expect("a sign").contains("opposite sign"), "{ratio}");
    }
    for ratio in [-0.1, -60.0, -5.0] {
        assert_eq!(said(ratio), None, "{ratio}");
    }
    let words =
        [(57.3, "radians"), (1e-3, "kN"), (1000.0, "mN"), (1.0 / 12.96, "km/h"), (1.0 / 57.3, "twice")];
    for (ratio, word) in words {
        for near in [0.6, 1.0, 1.7] {
            assert!(said(near * ratio).expect(word).contains(word), "{near} × {ratio}");
        }
    }
    assert!(said(57.3 * 1.9).expect("far").contains("no unit explains"));
    assert!(meaning(&TIP_ALONE, 900.0).expect("mm").contains("millimetres"));
}

#[test]
fn factors_are_near_within_18_on_both_sides() {
    let found = [0.5, 0.56, 1.0, 1.79, 1.8].map(|a| near(3.0 * a, 3.0));
    assert_eq!(found, [false, true, true, true, false]);
    assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
    assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(3.0));
    assert_eq!(median(Vec::new()), None);
}

fn airspeed(readings: &[(f64, f64)]) -> AirspeedData {
    let angle = |&(alpha_rad, value): &(f64, f64)| Angle {
        alpha_rad,
        loads: ByLoad::from_array([value, 2.0 * value, -value]),
        tip_z_m: 0.1 * value,
        block: 0,
        line: 2,
        replicates: 1,
    };
    AirspeedData {
        v_m_s: 10.0,
        angles: readings.iter().map(angle).collect(),
        span: nastran::Span::generated("test"),
    }
}

/// `b = Sxy/Sxx`; it speaks where `b² Sxx` is more than 25 times the squares about the line.
#[test]
fn a_slope_speaks_where_it_stands_clear_of_the_scatter() {
    let exact = airspeed(&[(0.1, 5.0), (0.2, 7.0), (0.4, 11.0)]);
    let slopes = [0, 1, 2, 3].map(|c| clear_slope(&exact, c).expect("a line"));
    slopes.iter().zip([20.0, 40.0, -20.0, 2.0]).for_each(|(a, b)| close(*a, b));
    assert_eq!(clear_slope(&airspeed(&[(0.1, 5.0), (0.2, 7.0)]), 0), None);
    assert_eq!(clear_slope(&airspeed(&[(0.1, 5.0), (0.1, 7.0), (0.1, 6.0)]), 0), None);
    // slope 1 over 10, 11, 12 and 13: Sxx 5; the pattern (1, -1, -1, 1) lies at right angles to lines, its squares 4 e²
    let with = |e: f64| {
        let readings: Vec<(f64, f64)> = [1.0, -1.0, -1.0, 1.0]
            .iter()
            .enumerate()
            .map(|(i, p)| (10.0 + i as f64, 100.0 + i as f64 + e * p))
            .collect();
        clear_slope(&airspeed(&readings), 0)
    };
    // 5 > 25 × 4 e²: e below 0.2236
    close(with(0.22).expect("clear"), 1.0);
    assert_eq!(with(0.23), None);
}

#[track_caller]
fn close(a: f64, b: f64) {
    crate::tests::near(a, b, 1e-9);
}

#[test]
fn the_arm_is_that_of_the_change_of_the_moment_by_the_lift() {
    let loads = [[1.0, 5.0, 0.0], [3.0, 1.0, 0.0]].map(RootLoads::from_array);
    close(model_arm(&loads), 2.0);
}

#[test]
fn ratios_are_of_measured_by_modelled_slopes_and_a_small_moment_says_nothing() {
    let toy = Toy::new(2, 2);
    let alphas = [0.0, 0.05, 0.1];
    let mut campaign = toy.measured(&[10.0], &alphas, &toy.uniform(1.0));
    campaign.tip = crate::campaign::TipReading::Zeroed;
    for point in &mut campaign.points {
        let [fz, mx, my] = point.loads.map(|load| load.expect("it is measured"));
        point.loads = [2.0 * fz, 3.0 * mx, 4.0 * my].map(Some);
        point.tip_z_m = point.tip_z_m.map(|tip_m| 5.0 * tip_m);
    }
    let ratios = |toy: &Toy, data: &StaticData| {
        slope_ratios(toy, RHO, &data.airspeeds[0], data).expect("it is linear")
    };
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    // My of the whole is less than a tenth of Mx
    let [fz, mx, my, tip] = ratios(&toy, &data);
    [fz, mx, tip].into_iter().zip([2.0, 3.0, 5.0]).for_each(|(a, b)| close(a.expect("a slope"), b));
    assert_eq!(my, None);
    let mut without = data.clone();
    without.channels = [true, false, true, false];
    assert_eq!(ratios(&toy, &without).map(|ratio| ratio.is_some()), [true, false, false, false]);
    // a chord as long as the span
    let mut wide = Toy::new(2, 2);
    wide.boxes.area_m2 = 8.0;
    let mut campaign = wide.measured(&[10.0], &alphas, &wide.uniform(1.0));
    for point in &mut campaign.points {
        point.loads[2] = point.loads[2].map(|my| 4.0 * my);
    }
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    close(ratios(&wide, &data)[2].expect("a slope"), 4.0);
}

/// Sentences about a campaign whose readings are changed by hand.
fn said(rho: f64, change: impl Fn([f64; 4]) -> [f64; 4]) -> Vec<String> {
    let toy = Toy::new(2, 2);
    let mut campaign = toy.measured(&[10.0, 20.0], &[0.0, 0.05, 0.1], &toy.uniform(1.0));
    campaign.tip = crate::campaign::TipReading::Zeroed;
    for point in &mut campaign.points {
        let [fz, mx, my, tip] = change([0, 1, 2, 3].map(|channel| point.reading(channel)));
        (point.loads, point.tip_z_m) = ([fz, mx, my].map(Some), Some(tip));
    }
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    // the density of the file alone is looked at: loads are those of the air as it was
    campaign.rho_kg_m3 = rho;
    let found = of_campaign(&toy, &campaign, &data).expect("it is linear");
    found.into_iter().filter(|one| rho == RHO || one.contains("rho")).collect()
}

#[test]
fn units_of_a_campaign_are_told_by_what_changes_with_them() {
    assert!(said(RHO, |read| read).is_empty());
    for (rho, good) in [(0.02, true), (29.9, true), (0.0199, false), (30.0, false)] {
        assert_eq!(said(rho, |read| read).is_empty(), good, "{rho}");
    }
    let one = |change: fn([f64; 4]) -> [f64; 4], words: &[&str]| {
        let found = said(RHO, change);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(words.iter().all(|word| found[0].contains(word)), "{found:?} {words:?}");
    };
    one(|[fz, mx, my, tip]| [1e-3 * fz, 1e-3 * mx, 1e-3 * my, tip], &["loads change", "0.001 times", "kN"]);
    // within 1.8 of each other: the geometric mean
    one(
        |[fz, mx, my, tip]| [10.0 * fz, 14.4 * mx, my, tip],
        &["loads change", "12.000 times", "no unit explains"],
    );
    one(|[fz, mx, my, tip]| [-fz, -mx, -my, tip], &["loads change", "-1.000 times", "opposite sign"]);
    one(|[fz, mx, my, tip]| [fz, 1e3 * mx, my, tip], &["Mx_Nm changes", "1000.000 times", "N mm"]);
    one(|[fz, mx, my, tip]| [1e3 * fz, mx, my, tip], &["Fz_N changes", "mN"]);
    one(|[fz, mx, my, tip]| [fz, mx, my, 1e3 * tip], &["tip_z_m changes", "millimetres"]);
    // the sign of one load is judged with the others
    assert!(said(RHO, |[fz, mx, my, tip]| [fz, -mx, my, tip]).is_empty());
}
