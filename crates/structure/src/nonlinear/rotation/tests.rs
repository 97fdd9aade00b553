//! Rotation vectors, half turns among them.

use super::*;
use nalgebra::Rotation3;

#[test]
fn logarithm_and_exponential_are_inverse_up_to_half_a_turn() {
    for angle in [1e-12, 1e-7, 1e-3, 0.3, 1.5, 3.0, 3.13] {
        let theta = Vector3::new(0.36, -0.48, 0.8) * angle;
        let back = logarithm(Rotation3::from_scaled_axis(theta).matrix());
        assert!((back - theta).norm() < 1e-11 * angle.max(1e-3), "{angle}: {back} for {theta}");
    }
}

#[test]
fn spins_change_vector_and_moment_as_differences_do() {
    let step = 1e-6;
    for angle in [1e-4, 0.009, 0.011, 0.049, 0.051, 0.8, 2.0] {
        let (theta, m) = (Vector3::new(0.36, -0.48, 0.8) * angle, Vector3::new(2.0, 1.0, -3.0));
        let rotation = Rotation3::from_scaled_axis(theta);
        for axis in 0..3 {
            let spin = Vector3::ith(axis, step);
            let turned =
                |sign: f64| logarithm((Rotation3::from_scaled_axis(spin * sign) * rotation).matrix());
            let change = (turned(1.0) - turned(-1.0)) / (2.0 * step);
            let own = by_spin(&theta).column(axis).into_owned();
            assert!((change - own).norm() < 1e-8, "L at {angle}: {own} for {change}");
            let moment = |sign: f64| by_spin(&(theta + spin * sign)).transpose() * m;
            let change = (moment(1.0) - moment(-1.0)) / (2.0 * step);
            let own = moment_by_vector(&theta, &m).column(axis).into_owned();
            assert!((change - own).norm() < 1e-8, "moment at {angle}: {own} for {change}");
        }
    }
}

/// A half turn about n is 2 n n^T - 1, and its logarithm pi n, of either sign.
#[test]
fn half_turns_have_logarithms_of_the_length_pi_along_their_axis() {
    let axes = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.6, 0.0, -0.8],
        [-0.36, 0.48, 0.8],
        [0.48, 0.64, -0.6],
    ];
    for axis in axes {
        let n = Vector3::from(axis);
        let theta = logarithm(&(n * n.transpose() * 2.0 - Matrix3::identity()));
        assert!((theta.norm() - std::f64::consts::PI).abs() < 1e-12, "{axis:?}: {theta}");
        assert!(theta.cross(&n).norm() < 1e-12, "{axis:?}: {theta}");
    }
    assert_eq!(logarithm(&Matrix3::identity()), Vector3::zeros());
}

const NORMAL: [f64; 3] = [0.6, 0.0, -0.8];

/// A rotation that tilts the normal by so much about a line across it, after it was turned about itself.
fn tilted(tilt: f64, twist: f64) -> (Vector3<f64>, Rotation3<f64>) {
    let (n, across) = (Vector3::from(NORMAL), Vector3::new(0.48, 0.8, 0.36));
    assert!(n.dot(&across).abs() < 1e-15);
    let rotation = Rotation3::from_scaled_axis(across * tilt) * Rotation3::from_scaled_axis(n * twist);
    (across * tilt + n * twist, rotation)
}

#[test]
fn a_tilt_of_the_normal_is_the_same_however_far_it_twists() {
    for (tilt, twist) in [(0.0, 0.3), (1e-9, -1e-3), (1e-3, 2.5), (0.4, -3.0), (0.5, 0.1), (2.9, 1.0)] {
        let (theta, rotation) = tilted(tilt, twist);
        let own = Turn::of(*rotation.matrix(), Measure::Tilt(NORMAL.into())).theta;
        assert!((own - theta).norm() < 1e-13, "{tilt} {twist}: {own} for {theta}");
    }
}

#[test]
fn spins_change_tilt_and_twist_and_their_moments_as_differences_do() {
    let (step, m) = (1e-5, Vector3::new(2.0, 1.0, -3.0));
    for (tilt, twist) in [(0.0, 0.0), (1e-4, 0.2), (0.44, -1.0), (0.46, 2.0), (1.9, 0.7)] {
        let (_, rotation) = tilted(tilt, twist);
        let at = |spin: Vector3<f64>| {
            Turn::of(*(Rotation3::from_scaled_axis(spin) * rotation).matrix(), Measure::Tilt(NORMAL.into()))
        };
        let turn = at(Vector3::zeros());
        for axis in 0..3 {
            let spin = Vector3::ith(axis, step);
            let change = (at(spin).theta - at(-spin).theta) / (2.0 * step);
            let own = turn.by_spin.column(axis).into_owned();
            assert!((change - own).norm() < 1e-8, "L at {tilt}: {own} for {change}");
            let moment = |spin| at(spin).by_spin.transpose() * m;
            let change = (moment(spin) - moment(-spin)) / (2.0 * step);
            let own = turn.moment_by_spin(&m).column(axis).into_owned();
            assert!((change - own).norm() < 1e-8, "moment at {tilt}: {own} for {change}");
        }
    }
}

/// acos(c) / sin(acos(c)) at 0, 60 and 90 degrees, and 1, -1/3, 4/15 at the first.
#[test]
fn series_and_closed_form_of_the_angle_over_its_sine_agree() {
    let near = |own: [f64; 3], expected: [f64; 3], within: f64| {
        for (own, expected) in own.into_iter().zip(expected) {
            assert!((own - expected).abs() < within, "{own} for {expected}");
        }
    };
    near(angle_over_sine(1.0), [1.0, -1.0 / 3.0, 4.0 / 15.0], 1e-15);
    let half_pi = std::f64::consts::FRAC_PI_2;
    near(angle_over_sine(0.0), [half_pi, -1.0, half_pi], 1e-14);
    let below = 1.0 - SERIES_TILT + 1e-12;
    near(angle_over_sine(below), angle_over_sine(below - 2e-12), 1e-11);
}
