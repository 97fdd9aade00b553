//! One factor by least squares, as its normal equations say.

use super::*;
use crate::calibration::Context;
use crate::campaign::{Campaign, Sets, TipReading};
use crate::statics::StaticData;
use crate::tests::{Toy, near, settings};

fn rows(channels: Vec<Channel>) -> At {
    At { channels, tip_means: (Vec::new(), Vec::new()) }
}

fn channel(residuals: [f64; 4], slopes: [f64; 4], growing: [f64; 4]) -> Channel {
    Channel { place: 0, residuals: residuals.to_vec(), slopes: slopes.to_vec(), growing: growing.to_vec() }
}

/// Residuals `a s - b g + e` with `e` at right angles to both: the growing part is `b`, what is left of the squares
/// is that of `e`.
#[test]
fn the_growing_part_is_that_of_two_unknowns_by_least_squares() {
    let (s, g, e) = ([2.0; 4], [0.0, 1.0, 2.0, 3.0], [1.0, -1.0, -1.0, 1.0]);
    // the part of g at right angles to s has the square 5
    for (size, freedom, widening) in [(0.0, 2.0, 1.0), (0.1, 1.0, 1.5), (6.0, 2.0, 1.0), (6.0, 1.0, 1.5)] {
        let r = std::array::from_fn(|i| 0.3 * s[i] - 1.7 * g[i] + size * e[i]);
        let (trend, sigma) = rows(vec![channel(r, s, g)]).trend(freedom, widening).expect("they are apart");
        near(trend, 1.7, 1e-12);
        let scatter = f64::max(1.0, 4.0 * size * size / freedom).sqrt();
        near(sigma, scatter * widening / 5.0_f64.sqrt(), 1e-12);
    }
    let r = std::array::from_fn(|i| 0.3 * s[i] - 1.7 * g[i]);
    let none =
        |freedom: f64, growing: [f64; 4]| rows(vec![channel(r, s, growing)]).trend(freedom, 1.0).is_none();
    assert!(none(0.9, g) && none(0.0, g), "no degree of freedom is left");
    assert!(none(2.0, s.map(|s| 0.4 * s)), "they are one");
    // a part of 2e-3 of the whole has a square of 4e-6 of it, one of 5e-4 less than a millionth
    let along = |share: f64| std::array::from_fn(|i| 1.0 + share * e[i]);
    assert!(!none(2.0, along(2e-3)) && none(2.0, along(5e-4)));
}

#[test]
fn gradient_and_curvature_add_up_over_channels() {
    let one = channel([1.0, 2.0, 3.0, 4.0], [1.0, 0.0, 2.0, -1.0], [0.0; 4]);
    let two = channel([2.0, 0.0, 0.0, 1.0], [3.0, 5.0, 0.0, 2.0], [0.0; 4]);
    assert_eq!(rows(vec![one, two]).normal(), (3.0 + 8.0, 6.0 + 38.0));
}

#[test]
fn correlation_widens_every_uncertainty() {
    let mut found = LiftFactor {
        factor: 1.0,
        sigma: 0.0,
        correlation: 0.0,
        rmse: [0.0; 4],
        tip_zeros: vec![],
        trend: None,
    };
    assert_eq!(found.widening(), 1.0);
    found.correlation = 0.6;
    near(found.widening(), 2.0, 1e-15);
}

/// Tip and lift of two blocks at several airspeeds, off the theory by hand.
fn sweep(toy: &Toy, errors: &[f64]) -> Campaign {
    let speeds = [8.0, 10.0, 12.0, 14.0];
    let mut campaign = toy.measured(&speeds, &[0.04, 0.08], &toy.uniform(1.0));
    campaign.channels = [true, false, false];
    (campaign.sets, campaign.tip) = (Sets::Common, TipReading::FreeZero);
    campaign.noise = Some(crate::tests::noise([0.5, 0.0, 0.0, 1e-3]));
    for (point, error) in campaign.points.iter_mut().zip(errors) {
        let second = point.alpha_rad > 0.05;
        point.block = Some(if second { "B" } else { "A" }.to_owned());
        let zero_m = if second { -0.02 } else { 0.01 };
        point.loads[0] = point.loads[0].map(|load| 1.1 * load + 0.5 * error);
        point.tip_z_m = point.tip_z_m.map(|tip_m| 1.1 * tip_m + zero_m - 1e-3 * error);
    }
    campaign
}

fn found(toy: &Toy, campaign: &Campaign) -> LiftFactor {
    let data = StaticData::from_campaign(campaign).expect("it is sound");
    let settings = settings(2);
    Context::new(toy, campaign.rho_kg_m3, &data, &settings)
        .common_lift()
        .expect("it is linear")
        .expect("lift hangs on it")
}

/// `s = 1 + sum(w a r) / sum(w a²)`, a the theory's readings about the zeros, r what is measured beyond them.
#[test]
fn the_factor_its_uncertainty_its_zeros_and_residuals_are_those_of_the_normal_equations() {
    let toy = Toy::new(3, 2);
    let errors = [1.0, -2.0, 3.0, 2.5, -1.5, 0.5, -2.0, 4.0];
    let campaign = sweep(&toy, &errors);
    let found = found(&toy, &campaign);
    let theory: Vec<[f64; 4]> =
        campaign.points.iter().map(|p| toy.reads(p.v_m_s, p.alpha_rad, &toy.uniform(1.0))).collect();
    let block = |b: usize| (b..8).step_by(2);
    let mean = |of: &dyn Fn(usize) -> f64, b: usize| block(b).map(of).sum::<f64>() / 4.0;
    // rows in standard deviations: four of the lift, then the tip about its zeros; alike in both blocks
    let lift = |i: usize| (theory[i][0] / 0.5, (campaign.points[i].reading(0) - theory[i][0]) / 0.5);
    let tip = |i: usize| {
        let (a, r) = (|i: usize| theory[i][3], |i: usize| campaign.points[i].reading(3) - theory[i][3]);
        ((a(i) - mean(&a, i % 2)) / 1e-3, (r(i) - mean(&r, i % 2)) / 1e-3)
    };
    let all: Vec<(f64, f64)> = (0..8).map(lift).chain((0..8).map(tip)).collect();
    let information: f64 = all.iter().map(|(a, _)| a * a).sum();
    let step = all.iter().map(|(a, r)| a * r).sum::<f64>() / information;
    near(found.factor, 1.0 + step, 1e-9);
    let left: Vec<f64> = all.iter().map(|(a, r)| r - step * a).collect();
    // 16 rows, a factor and two zeros
    let scatter = (left.iter().map(|r| r * r).sum::<f64>() / 13.0).max(1.0).sqrt();
    assert!(scatter > 1.1, "{scatter}");
    // neighbours in the file, each block for itself
    let (mut products, mut squares) = (0.0, 0.0);
    for first in [0, 8] {
        for i in 0..6 {
            products += left[first + i] * left[first + i + 2];
            squares += 0.5 * (left[first + i].powi(2) + left[first + i + 2].powi(2));
        }
    }
    near(found.correlation, (products / squares).max(0.0), 1e-6);
    let wide = scatter * found.widening();
    near(found.sigma, wide / information.sqrt(), 1e-9);
    let rms = |rows: &[f64]| (rows.iter().map(|r| r * r).sum::<f64>() / 8.0).sqrt();
    near(found.rmse[0], 0.5 * rms(&left[..8]), 1e-6);
    near(found.rmse[3], 1e-3 * rms(&left[8..]), 1e-6);
    assert_eq!(found.rmse[1..3], [0.0; 2]);
    for b in 0..2 {
        let zero_m = mean(&|i| campaign.points[i].reading(3) - found.factor * theory[i][3], b);
        near(found.tip_zeros[b].0, zero_m, 1e-9);
        let own_m = wide * 1e-3 / 2.0;
        near(found.tip_zeros[b].1, own_m.hypot(mean(&|i| theory[i][3], b) * found.sigma), 1e-9);
    }
    assert!(found.trend.is_some());
}

/// Errors that go on from row to row are correlated; errors that change their sign are not said to be.
#[test]
fn neighbouring_residuals_are_correlated_where_they_go_together() {
    let toy = Toy::new(3, 2);
    let slow = found(&toy, &sweep(&toy, &[-3.0, -3.0, 3.0, 3.0, 3.0, 3.0, -3.0, -3.0]));
    assert_eq!(slow.correlation.clamp(0.0, 0.99), slow.correlation);
    let quick = found(&toy, &sweep(&toy, &[3.0, 3.0, -3.0, -3.0, 3.0, 3.0, -3.0, -3.0]));
    assert_eq!(quick.correlation, 0.0);
    let one = found(&toy, &sweep(&toy, &[9.0; 8]));
    assert!(one.correlation > slow.correlation, "{one:?} {slow:?}");
}

#[test]
fn what_nothing_hangs_on_is_not_told_and_without_the_tip_no_trend_is() {
    let toy = Toy::new(3, 2);
    let mut campaign = sweep(&toy, &[0.0; 8]);
    campaign.tip = TipReading::Unused;
    let without = found(&toy, &campaign);
    assert!(without.trend.is_none() && without.tip_zeros.is_empty(), "{without:?}");
    near(without.factor, 1.1, 1e-9);
    for point in &mut campaign.points {
        point.alpha_rad = 0.0;
    }
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    let settings = settings(2);
    let none = Context::new(&toy, campaign.rho_kg_m3, &data, &settings).common_lift().expect("it is linear");
    assert_eq!(none, None);
}
