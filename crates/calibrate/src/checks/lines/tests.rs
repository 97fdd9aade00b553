//! Lines as textbooks fit them.

use super::*;
use crate::campaign::Campaign;
use crate::tests::{AREA_M2, RHO, SLOPE, SPAN_M, Toy, near, noise};

const ALPHAS: [f64; 4] = [0.0, 0.1, 0.2, 0.5];

fn measured(read: [f64; 4]) -> Campaign {
    let toy = Toy::new(2, 2);
    let mut campaign = toy.measured(&[10.0], &ALPHAS, &toy.uniform(1.0));
    for (point, value) in campaign.points.iter_mut().zip(read) {
        point.loads = [value, 2.0 * value, -value].map(Some);
    }
    campaign
}

/// `b = Sxy / Sxx`, `var b = s² / Sxx`, `var a = s² (1/n + mean² / Sxx)`, `cov(a, b) = -s² mean / Sxx`, `s² = SSE /
/// (n - 2)`.
#[test]
fn a_measured_line_and_its_covariance_are_those_of_least_squares() {
    let read = [1.0, 1.4, 1.5, 2.6];
    let campaign = measured(read);
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    let (line, found) = measured_line(&data, &data.airspeeds[0], Load::Fz);
    let (mean, level) = (0.2, 6.5 / 4.0);
    let spread: f64 = 0.04 + 0.01 + 0.09;
    let slope = (-0.2 * 1.0 - 0.1 * 1.4 + 0.3 * 2.6) / spread;
    near(line.slope, slope, 1e-12);
    near(line.at_zero, level - slope * mean, 1e-12);
    let squares: f64 = ALPHAS.iter().zip(read).map(|(x, y)| (y - level - slope * (x - mean)).powi(2)).sum();
    let check = |noise: LineNoise, variance: f64| {
        near(noise.slope, variance / spread, 1e-9);
        near(noise.at_zero, variance * (0.25 + mean * mean / spread), 1e-9);
        near(noise.both, -variance * mean / spread, 1e-9);
        assert_eq!(noise.matrix(), [[noise.slope, noise.both], [noise.both, noise.at_zero]]);
    };
    check(found, squares / 2.0);
    // twice the load: four times the variance
    check(measured_line(&data, &data.airspeeds[0], Load::Mx).1, 2.0 * squares);
    // declared: no less than that, over the rows an angle
    let mut declared = campaign.clone();
    declared.noise = Some(noise([3.0; 4]));
    let data = StaticData::from_campaign(&declared).expect("it is sound");
    check(measured_line(&data, &data.airspeeds[0], Load::Fz).1, 9.0);
    declared.points.extend(campaign.points.clone());
    declared.points.extend(campaign.points);
    let data = StaticData::from_campaign(&declared).expect("it is sound");
    check(measured_line(&data, &data.airspeeds[0], Load::Fz).1, 3.0);
    declared.noise = Some(noise([1e-6; 4]));
    let data = StaticData::from_campaign(&declared).expect("it is sound");
    check(measured_line(&data, &data.airspeeds[0], Load::Fz).1, squares / 2.0);
}

#[test]
fn theorys_line_has_its_slope_and_the_load_at_zero_angle() {
    let mut toy = Toy::new(2, 2);
    toy.camber_rad = 0.03;
    let mut campaign = toy.measured(&[10.0, 20.0], &ALPHAS[..3], &toy.uniform(1.0));
    campaign.channels = [true, false, true];
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    let mut with_two = data.clone();
    with_two.airspeeds[0].angles.pop();
    let found = lines(&toy, RHO, &with_two).expect("it is linear");
    assert_eq!(found.iter().map(|line| line.v_m_s).collect::<Vec<_>>(), [20.0]);
    let found = lines(&toy, RHO, &data).expect("it is linear");
    assert_eq!(found.iter().map(|line| line.v_m_s).collect::<Vec<_>>(), [10.0, 20.0]);
    for line in &found {
        let slope_n = 0.5 * RHO * line.v_m_s.powi(2) * AREA_M2 * SLOPE;
        near(line.theory.fz.slope, slope_n, 1e-9);
        near(line.theory.fz.at_zero, 0.03 * slope_n, 1e-9);
        // the lift of even strips acts at half of the span
        near(line.theory.mx.slope, 0.5 * SPAN_M * slope_n, 1e-9);
        near(line.theory.mx.at_zero, 0.015 * SPAN_M * slope_n, 1e-9);
        near(line.measured.fz.slope, slope_n, 1e-9);
        near(line.measured.my.at_zero, line.theory.my.at_zero, 1e-9);
        near(line.chord_m, AREA_M2 / SPAN_M, 1e-12);
        assert_eq!(line.channels, ByLoad { fz: true, mx: false, my: true });
    }
    assert_eq!(Line::level(2.0).parts(), [0.0, 2.0]);
    assert_eq!(Line { slope: 3.0, at_zero: 2.0 }.times(2.0, 5.0).parts(), [6.0, 10.0]);
}
