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
