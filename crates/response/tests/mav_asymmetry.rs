//! Eqs. 2 and 3 of "Wind-Tunnel Testing and Modeling of a Micro Air Vehicle with Flexible Wings": laws and closed forms
//! of the asymmetry ratio.

use nastran::Table;
use response::asymmetry::{
    Asymmetry, Displacement, RigidWing, Settings, asymmetry, displacements, read_displacements,
};

/// A field on the product of two sets of coordinates.
fn field(xs: &[f64], ys: &[f64], w: impl Fn(f64, f64) -> f64) -> Vec<Displacement> {
    let point = |x_mm: f64, y_mm: f64| Displacement { x_mm, y_mm, w_mm: w(x_mm, y_mm) };
    xs.iter().flat_map(|&x| ys.iter().map(move |&y| (x, y))).map(|(x, y)| point(x, y)).collect()
}

fn steps(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| from + (to - from) * k as f64 / (count - 1) as f64).collect()
}

fn ratio(points: &[Displacement]) -> Asymmetry {
    asymmetry(points, &Settings::default()).expect("a grid")
}

#[test]
fn a_field_that_is_the_same_on_both_sides_has_the_ratio_one() {
    let points = field(&steps(0.0, 130.0, 27), &steps(-75.0, 75.0, 31), |x, y| 1.0 + 0.01 * x + 2e-4 * y * y);
    let result = ratio(&points);
    assert!((result.ratio - 1.0).abs() < 1e-14, "{}", result.ratio);
    assert_eq!((result.pairs, result.unpaired, result.equally_spaced), (27 * 15, 0, true));
}

#[test]
fn on_an_equally_spaced_grid_the_ratio_is_that_of_the_sums() {
    // Eq. 3 of paper 2, no point on the plane of symmetry
    let points = field(&steps(0.0, 130.0, 14), &steps(-75.0, 75.0, 30), |x, y| {
        (1.0 + (0.1 * x).sin()) * if y < 0.0 { 0.6 } else { 1.0 }
    });
    let side = |left: bool| -> f64 { points.iter().filter(|p| (p.y_mm < 0.0) == left).map(|p| p.w_mm).sum() };
    let result = ratio(&points);
    assert!((result.ratio - side(true) / side(false)).abs() < 1e-14);
    assert!((result.ratio - 0.6).abs() < 1e-14);
}

#[test]
fn exchanging_left_and_right_inverts_the_ratio_and_scaling_leaves_it() {
    let points = field(&steps(0.0, 130.0, 14), &steps(-75.0, 75.0, 31), |x, y| 2.0 + 0.01 * y + 1e-3 * x);
    let changed = |sign: f64, factor: f64| -> Vec<Displacement> {
        points.iter().map(|p| Displacement { y_mm: sign * p.y_mm, w_mm: factor * p.w_mm, ..*p }).collect()
    };
    let original = ratio(&points).ratio;
    assert!((ratio(&changed(-1.0, 1.0)).ratio * original - 1.0).abs() < 1e-13);
    assert!((ratio(&changed(1.0, 25.4)).ratio - original).abs() < 1e-13);
}

#[test]
fn an_unequally_spaced_grid_gives_the_ratio_of_the_integrals() {
    // w = 1 + y/b is 1/2 and 3/2 on average over the halves; sums of points, which crowd at the tips, are not
    let half: Vec<f64> = (0..1000).map(|k| 75.0 * ((f64::from(k) + 0.5) / 1000.0).sqrt()).collect();
    let ys: Vec<f64> = half.iter().rev().map(|y| -y).chain(half.iter().copied()).collect();
    let points = field(&steps(0.0, 130.0, 5), &ys, |_, y| 1.0 + y / 75.0);
    let side = |left: bool| -> f64 { points.iter().filter(|p| (p.y_mm < 0.0) == left).map(|p| p.w_mm).sum() };
    let result = ratio(&points);
    assert!(!result.equally_spaced);
    assert!((result.ratio - 1.0 / 3.0).abs() < 0.005, "{}", result.ratio);
    assert!((side(true) / side(false) - 1.0 / 3.0).abs() > 0.1);
}

#[test]
fn a_hole_on_one_side_leaves_a_symmetric_field_symmetric() {
    let mut points = field(&steps(0.0, 130.0, 14), &steps(-75.0, 75.0, 31), |x, y| 1.0 + 0.1 * x + y * y);
    let before = points.len();
    points.retain(|p| !(p.y_mm > 40.0 && p.x_mm < 60.0));
    let result = ratio(&points);
    assert_eq!(result.unpaired, before - points.len());
    assert!((result.ratio - 1.0).abs() < 1e-13);
}

#[test]
fn a_rigid_motion_drives_the_ratio_towards_one() {
    // the paper: the balance's own deflection is in both integrals, so even a rigid wing has a ratio
    let of_motion = |motion_mm: f64| {
        let points = field(&steps(0.0, 130.0, 14), &steps(-75.0, 75.0, 30), |_, y| {
            motion_mm + if y < 0.0 { 0.6 } else { 1.0 }
        });
        ratio(&points).ratio
    };
    assert!(of_motion(0.0) < of_motion(1.0) && of_motion(1.0) < of_motion(10.0) && of_motion(10.0) < 1.0);
}

#[test]
fn the_standard_deviation_is_the_textbook_one_of_a_ratio() {
    // N equal points a side: sigma_R = sigma sqrt(1 + R^2) / (sqrt(N) mean of the right)
    let points =
        field(&steps(0.0, 130.0, 10), &steps(-75.0, 75.0, 20), |_, y| if y < 0.0 { 0.6 } else { 1.0 });
    let settings = Settings { sigma_w_mm: 0.05, ..Settings::default() };
    let result = asymmetry(&points, &settings).expect("a grid");
    let expected = 0.05 * (1.0f64 + 0.36).sqrt() / 100.0f64.sqrt();
    assert!((result.sigma / expected - 1.0).abs() < 1e-12, "{} {expected}", result.sigma);
    let (low, high) = result.interval.expect("the right half is far from zero");
    assert!(low < 0.6 && 0.6 < high);
    assert!(((high - low) / (2.0 * 1.959_964 * expected) - 1.0).abs() < 1e-3);
}

#[test]
fn a_wing_that_does_not_move_has_no_interval() {
    let points = field(&steps(0.0, 130.0, 10), &steps(-75.0, 75.0, 20), |x, y| 1e-3 * (x + y).sin());
    let result = ratio(&points);
    assert_eq!(result.interval, None);
}

#[test]
fn the_bias_of_the_rigid_wing_is_reported_and_must_be_exceeded() {
    assert!((RigidWing::PUBLISHED.bias() - 0.044).abs() < 1e-12);
    let rigid = RigidWing::from_ratios(&[0.93, 0.98, 0.958]).expect("three ratios");
    assert!((rigid.mean - 0.956).abs() < 1e-12);
    assert!((rigid.scatter.expect("three tests") - 0.025_06).abs() < 1e-5);
    let of = |left: f64| {
        ratio(&field(
            &steps(0.0, 130.0, 10),
            &steps(-75.0, 75.0, 20),
            |_, y| if y < 0.0 { left } else { 1.0 },
        ))
    };
    assert!(RigidWing::PUBLISHED.is_exceeded_by(&of(0.6)));
    assert!(!RigidWing::PUBLISHED.is_exceeded_by(&of(0.96)));
    assert!(!rigid.is_exceeded_by(&of(0.93)));
}

#[test]
fn wrong_fields_are_refused_with_the_reason() {
    let parse = |text: &str| displacements(&Table::parse("field.csv", text).expect("a table"));
    let missing = parse("x_mm,y_m,w_mm\n0,0,0\n").expect_err("a column is missing").to_string();
    assert!(missing.contains("`y_mm`"), "{missing}");
    let word = parse("x_mm,y_mm,w_mm\n0,1,none\n").expect_err("a word").to_string();
    assert!(word.contains("`none`"), "{word}");
    let of = |text: &str| {
        asymmetry(&parse(text).expect("numbers"), &Settings::default()).expect_err("no ratio").to_string()
    };
    assert!(of("x_mm,y_mm,w_mm\n0,1,1\n").contains("grid"));
    assert!(of("x_mm,y_mm,w_mm\n0,-1,1\n0,1,1\n1,1,1\n1,1,2\n").contains("twice"));
    assert!(of("x_mm,y_mm,w_mm\n0,1,1\n0,2,1\n1,1,1\n1,2,2\n").contains("mirror image"));
    assert!(of("x_mm,y_mm,w_mm\n0,-1,1\n0,1,1\n1,-1,1\n1,1,-1\n").contains("zero"));
    let settings = Settings { confidence: 1.0, ..Settings::default() };
    assert!(asymmetry(&[], &settings).is_err());
    assert!(read_displacements(std::path::Path::new("nowhere.csv")).is_err());
}
