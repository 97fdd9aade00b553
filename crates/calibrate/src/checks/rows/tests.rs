//! Rows that others do not bear out, by the textbook's numbers and by data whose fault is put in by hand.

use super::*;
use crate::checks::finding::Weight;
use crate::tests::{Toy, campaign, near, noise, point};

/// Rows of one airspeed with one channel, or the same in all.
fn group(alphas_rad: &[f64], loads: &[f64], angles: usize) -> Group {
    Group {
        v_m_s: 20.0,
        rows: (0..loads.len()).collect(),
        alphas_rad: alphas_rad.to_vec(),
        loads: std::array::from_fn(|_| loads.to_vec()),
        angles,
    }
}

const ALPHAS: [f64; 7] = [-0.06, -0.04, -0.02, 0.0, 0.02, 0.04, 0.06];
/// Scatter without a pattern.
const ERRORS: [f64; 7] = [0.01, -0.02, 0.015, -0.01, 0.0, 0.02, -0.015];

fn on_a_line(jumps: [f64; 7], times: f64) -> Vec<f64> {
    (0..7).map(|i| 2.0 + 30.0 * ALPHAS[i] + times * ERRORS[i] + jumps[i]).collect()
}

/// The hat values of a line, `1/n + (x - mean)²/Sxx`; those of any fit add up to its unknowns.
#[test]
fn leverages_are_those_of_the_textbook_in_any_unit() {
    let x = [1.0, 2.0, 4.0, 9.0];
    let found = leverages(&x, 1);
    for (x, h) in x.iter().zip(&found) {
        near(*h, 0.25 + (x - 4.0).powi(2) / 38.0, 1e-12);
    }
    let degrees = leverages(&x.map(f64::to_degrees), 1);
    found.iter().zip(&degrees).for_each(|(a, b)| near(*a, *b, 1e-12));
    near(leverages(&x, 2).iter().sum(), 3.0, 1e-12);
    assert!(leverages(&x[..3], 2).iter().all(|h| (h - 1.0).abs() < 1e-12));
}

/// A row's distance from the line through the others, over its own standard deviation `s (1 + 1/n + (x -
/// mean)²/Sxx)^(1/2)`, is t.
#[test]
fn a_row_left_out_is_told_by_its_distance_from_the_line_through_the_others() {
    let loads = on_a_line([0.0, 0.0, 0.0, 0.0, 0.0, -0.4, 0.0], 1.0);
    let others: Vec<usize> = (0..7).filter(|&i| i != 5).collect();
    let mean = |of: &dyn Fn(usize) -> f64| others.iter().map(|&i| of(i)).sum::<f64>() / 6.0;
    let (x, y) = (mean(&|i| ALPHAS[i]), mean(&|i| loads[i]));
    let spread = 6.0 * mean(&|i| (ALPHAS[i] - x).powi(2));
    let slope = 6.0 * mean(&|i| (ALPHAS[i] - x) * (loads[i] - y)) / spread;
    let line = |i: usize| y + slope * (ALPHAS[i] - x);
    let jump = loads[5] - line(5);
    let variance = 6.0 * mean(&|i| (loads[i] - line(i)).powi(2)) / 4.0;
    let t2 = jump * jump / (1.0 + 1.0 / 6.0 + (ALPHAS[5] - x).powi(2) / spread);
    let check = |declared: Option<f64>, scatter: f64, p_value: f64| {
        let found = deleted(&group(&ALPHAS, &loads, 4), 1, declared).expect("four angles");
        assert_eq!(found.row, 5);
        near(found.jump, jump, 1e-9);
        near(found.scatter, scatter, 1e-9);
        near(found.p_value, p_value, 1e-6);
    };
    let of_f = FisherSnedecor::new(1.0, 4.0).expect("a law").sf(t2 / variance);
    let of_chi = |variance: f64| ChiSquared::new(1.0).expect("a law").sf(t2 / variance);
    let shown = variance.sqrt();
    check(None, shown, of_f);
    // declared less than half of what is seen: what is seen decides
    check(Some(0.49 * shown), shown, of_f);
    check(Some(0.51 * shown), shown, of_chi(variance));
    check(Some(3.0 * shown), 3.0 * shown, of_chi(9.0 * variance));
}

#[test]
fn lines_need_four_angles_and_parabolas_five() {
    let with = |curve: f64| -> Vec<f64> {
        let bent = |i: usize| curve * 1000.0 * ALPHAS[i] * ALPHAS[i];
        (0..7).map(|i| 2.0 + 30.0 * ALPHAS[i] + bent(i) + if i == 2 { 0.7 } else { 0.0 }).collect()
    };
    let jump = |angles: usize, curve: f64| {
        deleted(&group(&ALPHAS, &with(curve), angles), 0, None)
            .map(|found| (found.row, found.jump, found.scatter))
    };
    assert!(jump(3, 0.0).is_none());
    // exact rows scatter by rounding: a millionth of the largest
    let (row, off, scatter) = jump(4, 0.0).expect("a line");
    assert_eq!(row, 2);
    near(off, 0.7, 1e-9);
    near(scatter, 3.8e-6, 1e-6);
    assert!(jump(4, 1.0).is_none_or(|(_, off, _)| (off - 0.7).abs() > 0.1), "a line has no curvature");
    let (row, off, scatter) = jump(5, 1.0).expect("a parabola");
    assert_eq!(row, 2);
    near(off, 0.7, 1e-9);
    near(scatter, 7.4e-6, 1e-6);
}

#[test]
fn two_rows_that_are_off_alike_are_told_from_none() {
    let found = |second: f64| {
        let loads = on_a_line([0.0, 0.9, 0.0, 0.0, 0.0, second, 0.0], 0.0);
        deleted(&group(&ALPHAS, &loads, 4), 0, None)
    };
    assert!(found(0.9).is_none());
    assert_eq!(found(0.3).expect("one is more").row, 1);
}

#[test]
fn rows_at_one_angle_are_a_cell_with_its_mean_and_ends_are_alone() {
    let angles = [0.1, 0.0, 0.1 + 4e-4, -0.1, 0.0];
    let of = group(&angles, &[4.0, 1.0, 6.0, 7.0, 5.0], 3);
    let cells = of.cells();
    assert_eq!(cells, [vec![3], vec![1, 4], vec![0, 2]]);
    assert_eq!(of.means(&cells, 2), [5.0, 3.0, 5.0, 7.0, 3.0]);
    assert_eq!([0, 1, 2, 3, 4].map(|row| of.is_end(row)), [false, false, false, true, false]);
    assert_eq!(of_replicates(&of, 0), (2.0 + 8.0, 2));
    let single = group(&[0.2, 0.0, 0.1], &[0.0; 3], 3);
    assert_eq!([0, 1, 2].map(|row| single.is_end(row)), [true, true, false]);
}

/// Orthogonal polynomials of equal steps: (1, -4, 6, -4, 1) lies at right angles to all cubics, (1, -3, 3, -1) to
/// parabolas, (1, -2, 1)
/// to lines.
#[test]
fn scatter_about_a_curve_is_what_one_degree_of_freedom_leaves() {
    let of = |pattern: &[f64], angles: usize| {
        let alphas: Vec<f64> = (0..pattern.len()).map(|i| 0.1 * i as f64).collect();
        let curve = |(i, p): (usize, &f64)| p + 1.0 - 2.0 * i as f64;
        about_a_curve(&group(&alphas, &pattern.iter().enumerate().map(curve).collect::<Vec<_>>(), angles), 0)
    };
    for (pattern, squares) in
        [(&[1.0, -4.0, 6.0, -4.0, 1.0][..], 70.0), (&[1.0, -3.0, 3.0, -1.0], 20.0), (&[1.0, -2.0, 1.0], 6.0)]
    {
        let (found, dof) = of(pattern, pattern.len());
        near(found, squares, 1e-9);
        assert_eq!(dof, 1);
    }
    assert_eq!(of(&[1.0, -2.0], 2), (0.0, 0));
    // six angles leave two about a cubic
    let (found, dof) = of(&[1.0, -3.0, 2.0, 2.0, -3.0, 1.0], 6);
    near(found, 28.0, 1e-9);
    assert_eq!(dof, 2);
    // angles that are few, rows that are many
    assert_eq!(of(&[1.0, -3.0, 3.0, -1.0], 3).1, 2);
}

/// What is known of two loads, or with other channels.
fn data(channels: [bool; 3], sigma: Option<f64>) -> StaticData {
    let toy = Toy::new(2, 2);
    let mut campaign = toy.measured(&[20.0], &ALPHAS, &toy.uniform(1.0));
    (campaign.channels, campaign.noise) = (channels, sigma.map(|sigma| noise([sigma; 4])));
    StaticData::from_campaign(&campaign).expect("it is sound")
}

#[test]
fn scatter_of_repeated_rows_is_said_from_twice_what_is_declared_on() {
    let pairs = |d: f64| {
        let alphas: Vec<f64> = (0..40).map(|i| 0.01 * f64::from(i / 2)).collect();
        let loads: Vec<f64> = (0..40).map(|i| f64::from(i / 2) + if i % 2 == 0 { d } else { -d }).collect();
        vec![group(&alphas, &loads, 20)]
    };
    // squares 2 d² a pair: the standard deviation is root 2 d
    let found = |d: f64, sigma| more_scatter(&pairs(d), &data([true, false, false], sigma));
    let loud = found(1.5, Some(1.0));
    assert_eq!(loud.len(), 1);
    assert_eq!(loud[0].0, 0);
    near(loud[0].1, 1.5 * 2.0_f64.sqrt(), 1e-12);
    assert!(
        loud[0].2.sentence.contains("Fz_N: repeated rows scatter by 2.12, 2.1 times the 1 "),
        "{:?}",
        loud[0].2
    );
    assert!(found(1.4, Some(1.0)).is_empty() && found(9.0, None).is_empty());
    assert!(found(3.0, Some(2.2)).is_empty() && found(3.0, Some(2.1)).len() == 1);
    // three pairs that differ by chance, once in a thousand campaigns
    let few = group(&[0.0, 0.0, 0.1, 0.1, 0.2, 0.2], &[1.7, -1.7, 1.7, -1.7, 1.7, -1.7], 3);
    assert!(more_scatter(&[few], &data([true, true, true], Some(1.0))).is_empty());
}

#[test]
fn without_repeated_rows_scatter_is_about_smooth_curves() {
    let alphas = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5];
    let one = || group(&alphas, &[1.0, -3.0, 2.0, 2.0, -3.0, 1.0].map(|p| 2.0 * p), 6);
    // 28 × 4 twice, of four degrees of freedom
    let found = more_scatter(&[one(), one()], &data([false, true, false], Some(1.0)));
    assert_eq!((found.len(), found[0].0), (1, 1));
    near(found[0].1, 56.0_f64.sqrt(), 1e-9);
    assert!(
        found[0].2.sentence.contains("Mx_Nm: rows about smooth curves scatter by 7.48, 7.5 times"),
        "{:?}",
        found[0].2
    );
    assert!(
        more_scatter(&[one()], &data([false, true, false], Some(1.0))).is_empty(),
        "two degrees are too few"
    );
}

/// Rows whose loads are `1 + k` times those of their angle, the third load by a share of `k`.
fn labelled(factors: &[(f64, f64)], third: f64) -> Group {
    let alphas: Vec<f64> = factors.iter().map(|(alpha, _)| *alpha).collect();
    let base = [1.0, 30.0, -0.2, 0.0];
    let mut made = group(&alphas, &alphas, 3);
    made.loads = std::array::from_fn(|c| {
        let share = if c == 2 { third } else { 1.0 };
        factors.iter().map(|(alpha, k)| base[c] * (1.0 + 10.0 * alpha) * (1.0 + share * k)).collect()
    });
    made
}

#[test]
fn rows_of_other_airspeeds_are_too_large_or_too_small_in_all_loads() {
    let four = |by: f64| -> Vec<(f64, f64)> {
        [0.0, 0.1, 0.2].iter().flat_map(|&a| [0.2, -0.2, 0.1, -0.1].map(|k| (a, by * k))).collect()
    };
    let all = data([true, true, true], None);
    let found = |factors: &[(f64, f64)], third: f64| other_airspeeds(&[labelled(factors, third)], &all);
    let said = found(&four(1.0), 1.0).expect("all loads go together");
    assert_eq!(said.weight, Weight::Defect);
    // 20 m/s times the roots of 0.8 and 1.2
    for words in ["V_m_s = 20:", "by -20 to +20 %", "between about 18 and 22 m/s"] {
        assert!(said.sentence.contains(words), "{said:?}");
    }
    assert!(found(&four(0.1), 1.0).is_none() && found(&four(0.25), 1.0).is_some(), "3 % root mean square");
    // of k in two loads and a share of it in the third, the common factor explains (2 + share)² / (6 + 3 share²)
    assert!(found(&four(1.0), 0.2).is_none() && found(&four(1.0), 0.3).is_some());
    let one = data([true, false, false], None);
    assert!(other_airspeeds(&[labelled(&four(1.0), 1.0)], &one).is_none(), "one load tells nothing");
    // three rows beyond the first at their angle; more than a third of the rows
    let repeated = [(0.0, 0.2), (0.0, -0.2), (0.0, 0.2), (0.0, -0.2), (0.1, 0.0), (0.2, 0.0)];
    assert!(found(&repeated, 1.0).is_some());
    assert!(found(&repeated[1..], 1.0).is_none());
    let mut few = vec![(0.0, 0.2), (0.0, -0.2), (0.0, 0.2), (0.0, -0.2)];
    few.extend([0.1, 0.2].iter().flat_map(|&a| [(a, 0.0); 4]));
    assert!(found(&few, 1.0).is_none());
    few.pop();
    assert!(found(&few, 1.0).is_some());
}

/// Two rows an angle with these offsets of the lift at each, noise declared.
fn at_angles(offsets: [f64; 7]) -> StaticData {
    let toy = Toy::new(2, 2);
    let row = |i: usize| {
        let [fz, mx, my, tip] = toy.reads(20.0, ALPHAS[i / 2], &toy.uniform(1.0));
        point(i + 2, 20.0, ALPHAS[i / 2], [fz - offsets[i / 2], mx, my, tip])
    };
    StaticData::from_campaign(&campaign((0..14).map(row).collect(), Some([0.1; 4]))).expect("it is sound")
}

#[test]
fn an_angle_contradicts_the_others_beyond_eight_standard_deviations_of_its_mean() {
    let found = |offsets: [f64; 7]| {
        let data = at_angles(offsets);
        lone_angle(&data.airspeeds[0], &data)
    };
    let one = |place: usize, off: f64| std::array::from_fn(|i| if i == place { off } else { 0.0 });
    let said = found(one(4, 5.0)).expect("one is off").sentence;
    // the mean of two rows: 0.1 N over root 2
    for words in ["V_m_s = 20 and alpha_deg = 1.15: Fz_N is 5.000 below", "71 times"] {
        assert!(said.contains(words), "{said}");
    }
    assert!(found(one(4, -5.0)).expect("one is off").sentence.contains("above"));
    assert!(found(one(4, 0.55)).is_none() && found(one(4, 0.6)).is_some());
    assert!(found(one(0, 5.0)).is_none() && found(one(6, 5.0)).is_none(), "a wing may stall at the ends");
    // what all scatter by is no angle's own
    let scattered = std::array::from_fn(|i| 30.0 * ERRORS[i] + if i == 4 { 3.0 } else { 0.0 });
    assert!(found(scattered).is_none());
}

/// Two rows an angle, some of them off in the lift.
fn with_wrong_rows(wrong: &[(usize, f64)]) -> Campaign {
    let toy = Toy::new(2, 2);
    let row = |i: usize| {
        let [fz, mx, my, tip] = toy.reads(20.0, ALPHAS[i / 2], &toy.uniform(1.0));
        let off = wrong.iter().find(|(row, _)| *row == i).map_or(0.0, |(_, off)| *off);
        point(i + 2, 20.0, ALPHAS[i / 2], [fz + off + 1e-2 * ERRORS[i % 7], mx, my, tip])
    };
    campaign((0..14).map(row).collect(), None)
}

fn checked(campaign: &Campaign) -> Checked {
    check(campaign, StaticData::from_campaign(campaign).expect("it is sound"))
}

#[test]
fn one_row_in_ten_is_set_aside_and_beyond_that_the_data_are_wrong() {
    let none = checked(&with_wrong_rows(&[]));
    assert!(none.findings.is_empty() && none.set_aside.is_empty(), "{:?}", none.findings);
    let one = checked(&with_wrong_rows(&[(5, -10.55)]));
    assert_eq!((one.set_aside.as_slice(), one.campaign.points.len()), (&[7][..], 13));
    let said = &one.findings[0].sentence;
    for words in ["line 7 of the static cases: Fz_N is 10.5", " N below", "at 20 m/s", "it is set aside"] {
        assert!(said.contains(words), "{said}");
    }
    // of 14 rows two may go
    let three = checked(&with_wrong_rows(&[(5, -10.0), (8, 100.0), (2, 1.0)]));
    assert_eq!(three.set_aside, [10, 7]);
    let defects: Vec<_> = three.findings.iter().filter(|one| one.weight == Weight::Defect).collect();
    assert!(defects.len() == 1 && defects[0].sentence.contains("line 4"), "{:?}", three.findings);
    let mut common = with_wrong_rows(&[(5, -10.0)]);
    common.sets = Sets::Common;
    assert!(checked(&common).findings.is_empty());
}

#[test]
fn a_single_row_at_the_end_stays_and_is_said() {
    let mut campaign = with_wrong_rows(&[(12, -10.0)]);
    campaign.points.pop();
    let found = checked(&campaign);
    assert!(found.set_aside.is_empty() && found.findings.len() == 1, "{:?}", found.findings);
    assert!(
        found.findings[0].sentence.contains("line 14") && found.findings[0].sentence.contains("it stays")
    );
}

#[test]
fn scatter_that_is_seen_takes_the_place_of_what_is_declared() {
    let toy = Toy::new(2, 2);
    let row = |i: usize| {
        let [fz, mx, my, tip] = toy.reads(20.0, ALPHAS[i / 4], &toy.uniform(1.0));
        let off = [1.0, -1.0][i % 2];
        point(i + 2, 20.0, ALPHAS[i / 4], [fz + off, mx, my, tip])
    };
    let found = checked(&campaign((0..28).map(row).collect(), Some([0.2, 0.3, 0.4, 0.0])));
    // 28 squares of one, 21 degrees of freedom
    let seen = (28.0 / 21.0_f64).sqrt();
    let sigma = found.data.point_sigma.expect("it is known");
    near(sigma[0], seen, 1e-9);
    assert_eq!(sigma[1..], [0.3, 0.4, 0.0]);
    assert_eq!(found.campaign.noise.expect("it is declared").static_point.to_array(), sigma);
}

/// Of a row in the middle of 14 on a line, 13/14 of the square of what it is off by is its own. All rows and loads of
/// a campaign share the
/// level: 42 tests ask for a chance of 2.4e-6, 4.72 standard deviations; 14 of one load for 7.1e-6, 4.49.
#[test]
fn the_level_is_shared_by_all_rows_and_loads() {
    let found = |standard_deviations: f64, channels: [bool; 3]| {
        let toy = Toy::new(2, 2);
        let off = 0.1 * standard_deviations / (13.0 / 14.0_f64).sqrt();
        let row = |i: usize| {
            let [fz, mx, my, tip] = toy.reads(20.0, ALPHAS[i / 2], &toy.uniform(1.0));
            point(i + 2, 20.0, ALPHAS[i / 2], [if i == 6 { fz + off } else { fz }, mx, my, tip])
        };
        let mut campaign = campaign((0..14).map(row).collect(), Some([0.1; 4]));
        campaign.channels = channels;
        let data = StaticData::from_campaign(&campaign).expect("it is sound");
        worst_row(&groups(&campaign, &data), &campaign, &data).map(|worst| (worst.place, worst.is_end))
    };
    for (sigmas, one, all) in [(4.4, false, false), (4.6, true, false), (4.8, true, true)] {
        assert_eq!(found(sigmas, [true, false, false]), one.then_some((6, false)), "{sigmas}");
        assert_eq!(found(sigmas, [true; 3]), all.then_some((6, false)), "{sigmas}");
    }
}
