//! One set for all airspeeds, worked out by hand.

use super::*;
use crate::calibration::calibrate;
use crate::campaign::Sets;
use crate::tests::{Toy, near, noise, settings};

/// Readings at dynamic pressures 1 to 4 are a parabola and a pattern at right angles to all parabolas, (1, -3, 3, -1).
#[test]
fn rows_scatter_about_one_parabola_for_each_block_and_angle() {
    let toy = Toy::new(2, 2);
    // q = rho V²/2 of 1 to 4 Pa, two blocks, one of them at two angles
    let speeds = [1.0, 2.0, 3.0, 4.0].map(|q: f64| (2.0 * q / crate::tests::RHO).sqrt());
    let mut campaign = toy.measured(&speeds, &[0.05, 0.1], &toy.uniform(1.0));
    campaign.sets = Sets::Common;
    campaign.channels = [true, true, false];
    campaign.noise = Some(noise([1.0; 4]));
    let other = campaign.points.clone().into_iter().map(|mut point| {
        point.block = Some("B".into());
        point
    });
    let other: Vec<_> = other.step_by(2).collect();
    campaign.points.extend(other);
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    let mut angles: Vec<Angle> = data.airspeeds.iter().flat_map(|airspeed| airspeed.angles.clone()).collect();
    let q_pa: Vec<f64> =
        data.airspeeds.iter().enumerate().flat_map(|(i, a)| vec![(i + 1) as f64; a.angles.len()]).collect();
    for (angle, q) in angles.iter_mut().zip(&q_pa) {
        let size = if angle.block == 1 {
            0.2
        } else if angle.alpha_rad > 0.07 {
            0.3
        } else {
            0.1
        };
        let pattern = [1.0, -3.0, 3.0, -1.0][[1.0, 2.0, 3.0, 4.0].iter().position(|k| k == q).expect("one")];
        angle.loads.fz = 2.0 + 10.0 * size * q - 0.3 * q * q + size * pattern;
        angle.loads.mx = -angle.loads.fz;
        angle.loads.my = 100.0 * q * q * q;
    }
    let curves = Curves::new(&data, &angles.iter().collect::<Vec<_>>(), &q_pa);
    assert_eq!((curves.count, curves.residuals.len()), (3, 12));
    // squares of the pattern: 20; one degree of freedom a parabola
    let sigma = (20.0 * (0.01 + 0.04 + 0.09) / 3.0_f64).sqrt();
    near(curves.sigma[0], sigma, 1e-9);
    near(curves.sigma[1], sigma, 1e-9);
    assert_eq!(curves.sigma[2..], [0.0; 2]);
    for (angle, row) in angles.iter().zip(&curves.residuals) {
        assert!((row[0] + row[1]).abs() < 1e-9 && row[0].abs() > 0.09, "{angle:?} {row:?}");
    }
}

/// `(1 + 4k / (n / w² - 3k))^(1/2)`, the freedom not below one.
#[test]
fn parabolas_are_no_more_than_chance_by_their_degrees_of_freedom() {
    let curves = Curves { residuals: vec![[0.0; 4]; 8], sigma: [0.0; 4], count: 2 };
    near(curves.slack(1.0), 5.0_f64.sqrt(), 1e-15);
    near(curves.slack(0.5), (1.0 + 8.0 / 26.0_f64).sqrt(), 1e-15);
    near(curves.slack(2.0), 3.0, 1e-15);
    let one = Curves { residuals: vec![[0.0; 4]; 20], sigma: [0.0; 4], count: 1 };
    near(one.slack(2.0), 3.0_f64.sqrt(), 1e-15);
}

#[test]
fn one_factor_that_leaves_nothing_is_the_corrections_of_all_airspeeds() {
    let toy = Toy::new(3, 2);
    let mut campaign = toy.measured(&[8.0, 10.0, 12.0, 14.0], &[0.05, 0.1], &toy.uniform(1.25));
    campaign.sets = Sets::Common;
    campaign.noise = Some(noise([0.1; 4]));
    let found = calibrate(&toy, &campaign, &settings(2)).expect("it is sound");
    let set = found.common.expect("one set");
    assert_eq!((set.v_range_m_s, set.rows, set.fit.cone_programs), ([8.0, 14.0], 8, 0));
    near(set.mean_force_factor, 1.25, 1e-9);
    near(set.lift.expect("lift").factor, 1.25, 1e-9);
    assert_eq!(set.point_sigma[..3], [0.1; 3]);
    assert_eq!(rmse_of([1.0, 2.0, 3.0, 4.0], [true, false, true, false]), [1.0, 0.0, 3.0, 0.0]);
}
