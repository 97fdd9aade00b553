//! The states of an aircraft in flight and where they stand in one list of numbers.
//!
//! ```text
//! velocity of the centre of gravity (m/s) and rotation rates (rad/s), along x aft, y right, z up of the mean axes
//! attitude: quaternion (scalar first) that turns these axes into the earth's; place in the earth's axes (m)
//! modes and their rates, as departures from the trim; deflections (rad) and their rates; lags of the air
//! ```
//! Small motions have a rotation vector (rad, about the mean axes of the trim) in place of the quaternion.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

/// Numbers of states.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct StateLayout {
    pub(crate) modes: usize,
    pub(crate) drives: usize,
    /// Rigid incidences, modes, drives, gust stations.
    pub(crate) motions: usize,
    pub(crate) poles: usize,
}

/// Where the attitude begins, and the place.
pub(crate) const ATTITUDE: usize = 6;
pub(crate) const PLACE: usize = 10;
const ELASTIC: usize = 13;

impl StateLayout {
    pub(crate) fn mode_rate(self, mode: usize) -> usize {
        mode_state(self.modes) + mode
    }

    pub(crate) fn drive(self, drive: usize) -> usize {
        self.mode_rate(self.modes) + drive
    }

    pub(crate) fn drive_rate(self, drive: usize) -> usize {
        self.drive(self.drives) + drive
    }

    pub(crate) fn lag(self, pole: usize, motion: usize) -> usize {
        self.drive_rate(self.drives) + pole * self.motions + motion
    }

    pub(crate) fn len(self) -> usize {
        self.lag(self.poles, 0)
    }

    /// Number of states of small motions.
    pub(crate) fn small(self) -> usize {
        self.len() - 1
    }
}

/// Where a mode stands.
pub(crate) fn mode_state(mode: usize) -> usize {
    ELASTIC + mode
}

/// A state `h` away from `from` in the small state `at`.
pub(crate) fn moved(from: &[f64], at: usize, h: f64) -> Vec<f64> {
    let mut state = from.to_vec();
    match at {
        first if first < ATTITUDE => state[first] += h,
        turn if turn < ATTITUDE + 3 => {
            let vector = Vector3::from_fn(|axis, _| if axis + ATTITUDE == turn { h } else { 0.0 });
            let turned = attitude(from) * UnitQuaternion::from_scaled_axis(vector);
            put_attitude(&mut state, &turned);
        }
        rest => state[rest + 1] += h,
    }
    state
}

/// Rates of the small states from those of the full ones; `rates` are the rotation rates against the trim's.
pub(crate) fn small_rates(derivative: &[f64], rates: &Vector3<f64>) -> Vec<f64> {
    let mut small = derivative[..ATTITUDE].to_vec();
    small.extend(rates.iter());
    small.extend(&derivative[PLACE..]);
    small
}

pub(crate) fn vector(state: &[f64], from: usize) -> Vector3<f64> {
    Vector3::new(state[from], state[from + 1], state[from + 2])
}

/// Normalised, whatever the integrator left.
pub(crate) fn attitude(state: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(quaternion(state))
}

fn quaternion(state: &[f64]) -> Quaternion<f64> {
    Quaternion::new(state[ATTITUDE], state[ATTITUDE + 1], state[ATTITUDE + 2], state[ATTITUDE + 3])
}

pub(crate) fn put_attitude(state: &mut [f64], attitude: &UnitQuaternion<f64>) {
    let q = attitude.quaternion();
    state[ATTITUDE..PLACE].copy_from_slice(&[q.w, q.i, q.j, q.k]);
}

/// Rate of the quaternion: half of it times the rotation rates.
pub(crate) fn attitude_rate(state: &[f64], omega: &Vector3<f64>) -> [f64; 4] {
    let rate = quaternion(state) * Quaternion::from_parts(0.0, *omega) * 0.5;
    [rate.w, rate.i, rate.j, rate.k]
}

/// Roll (right wing down), pitch (nose up) and yaw (nose right), rad, as flight mechanics has them.
pub(crate) fn euler_angles(attitude: &UnitQuaternion<f64>) -> [f64; 3] {
    let r: Matrix3<f64> = attitude.to_rotation_matrix().into_inner();
    let roll = (-r[(2, 1)]).atan2(r[(2, 2)]);
    let pitch = (-r[(2, 0)]).clamp(-1.0, 1.0).asin();
    [roll, pitch, (-r[(1, 0)]).atan2(r[(0, 0)])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// Where the earth sees what points ahead, to the right and up on board.
    fn seen(attitude: &UnitQuaternion<f64>) -> [Vector3<f64>; 3] {
        [-Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| attitude * axis)
    }

    #[test]
    fn angles_say_where_nose_and_wing_point() {
        let turned = |axis: Vector3<f64>| UnitQuaternion::from_scaled_axis(axis);
        for (attitude, expected) in [
            (turned(Vector3::new(-0.3, 0.0, 0.0)), [0.3, 0.0, 0.0]),
            (turned(Vector3::new(0.0, 0.3, 0.0)), [0.0, 0.3, 0.0]),
            (turned(Vector3::new(0.0, 0.0, -0.3)), [0.0, 0.0, 0.3]),
        ] {
            let ([nose, right, _], angles) = (seen(&attitude), euler_angles(&attitude));
            // right wing down, nose up, nose right: sines of the angles as seen from the earth
            let shown = [-right.z, nose.z, nose.y].map(f64::asin);
            for ((angle, shown), expected) in angles.into_iter().zip(shown).zip(expected) {
                assert!((angle - expected).abs() < 1e-15 && (shown - expected).abs() < 1e-15, "{angles:?}");
            }
        }
    }

    #[test]
    fn angles_compose_as_yaw_then_pitch_then_roll() {
        // Etkin, Dynamics of Atmospheric Flight (1972), sec. 4.5: azimuth about the vertical, elevation of the nose, bank about the nose
        let (roll, pitch, yaw) = (0.4, -0.7, 2.1_f64);
        let about = |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
        let attitude = about(-Vector3::z(), yaw) * about(Vector3::y(), pitch) * about(-Vector3::x(), roll);
        for (found, given) in euler_angles(&attitude).into_iter().zip([roll, pitch, yaw]) {
            assert!((found - given).abs() < 1e-14, "{found} for {given}");
        }
        let [nose, right, up] = seen(&attitude);
        assert!((nose.z - pitch.sin()).abs() < 1e-14, "height of the nose over the horizon");
        assert!((nose.y.atan2(-nose.x) - yaw).abs() < 1e-14, "its azimuth, from ahead to the right");
        assert!((-right.z - roll.sin() * pitch.cos()).abs() < 1e-14 && up.z > 0.0, "the wing's");
        assert!(yaw > FRAC_PI_2, "beyond a quarter turn, where a sine alone would fail");
    }
}
