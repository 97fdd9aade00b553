//! Filters that are known in time.

use super::*;

fn turned(angle: f64) -> c64 {
    c64::new(angle.cos(), -angle.sin())
}

#[test]
fn a_delay_of_a_whole_step_moves_every_sample_by_one() {
    let dt = 0.01;
    let values: Vec<f64> = (0..37).map(|k| if k == 0 { 0.3 } else { (2.3 * f64::from(k)).sin() }).collect();
    let later = filtered(&values, dt, |omega| turned(omega * dt));
    assert_eq!(later.len(), values.len());
    for k in 1..37 {
        assert!((later[k] - values[k - 1]).abs() < 1e-12, "{k}");
    }
    let doubled = filtered(&values, dt, |_| c64::from(2.0));
    for k in 0..37 {
        // at rest before the first sample: what differs from it is doubled
        assert!((doubled[k] - (2.0 * values[k] - values[0])).abs() < 1e-12, "{k}");
    }
    assert_eq!(filtered(&[0.7; 9], dt, |_| c64::from(2.0)), [0.7; 9]);
}

#[test]
fn a_filter_that_multiplies_by_i_omega_differentiates() {
    let dt = 0.01;
    let bell = |t: f64| (-((t - 1.0) / 0.1_f64).powi(2)).exp();
    let values: Vec<f64> = (0..200).map(|k| 1.0 + bell(f64::from(k) * dt)).collect();
    let rate = filtered(&values, dt, |omega| c64::new(0.0, omega));
    for (k, rate) in rate.iter().enumerate() {
        let t = k as f64 * dt;
        let exact = 1.0 - 2.0 * (t - 1.0) / 0.01 * bell(t);
        assert!((rate - exact).abs() < 1e-8, "{t}: {rate} {exact}");
    }
}

#[test]
fn a_record_goes_back_in_a_second_along_half_a_cosine_and_stays() {
    let record = continued(&[1.0, 2.0, 4.0], 10, 0.25);
    let back = [0.75_f64, 0.5, 0.25, 0.0].map(|x| 3.0 * 0.5 * (1.0 - (PI * x).cos()));
    let wanted = [0.0, 1.0, 3.0, back[0], back[1], back[2], back[3], 0.0, 0.0, 0.0];
    assert!(record.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{record:?}");
    // steps longer than a second go back in one
    assert_eq!(continued(&[0.0, 1.0], 4, 5.0), [0.0, 1.0, 0.0, 0.0]);
}

#[test]
fn steps_are_the_nearest_whole_number_of_them() {
    assert_eq!((steps(1.0, 0.3), steps(1.0, 0.4), steps(3.0, 1.5)), (3, 3, 2));
}
