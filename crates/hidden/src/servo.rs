//! The ailerons' servo: second order, stepped exactly between samples of the simulation.

use faer::Mat;
use maneuver::ExactStep;
use std::f64::consts::TAU;

/// `d'' = w² (command - d) - 2 zeta w d'`
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Servo {
    /// Natural frequency, Hz; infinite: it follows at once.
    pub(crate) frequency_hz: f64,
    /// Damping ratio.
    pub(crate) damping_ratio: f64,
}

impl Servo {
    /// Deflections of a command that is at rest before its first sample.
    pub(crate) fn follow(self, command: &[f64], time_step_s: f64) -> Vec<f64> {
        let Some(&first) = command.first() else { return Vec::new() };
        if self.frequency_hz.is_infinite() || command.iter().all(|value| *value == first) {
            return command.to_vec();
        }
        let omega = TAU * self.frequency_hz;
        let a = Mat::from_fn(2, 2, |i, j| match (i, j) {
            (0, 1) => 1.0,
            (1, 0) => -omega * omega,
            (1, 1) => -2.0 * self.damping_ratio * omega,
            _ => 0.0,
        });
        let b = Mat::from_fn(2, 1, |i, _| if i == 1 { omega * omega } else { 0.0 });
        let step = ExactStep::new(a.as_ref(), b.as_ref(), time_step_s);
        let (phi, g0, g1) = (&step.transition, &step.from_first, &step.from_last);
        let mut x = [first, 0.0];
        let mut all = vec![first];
        for pair in command.windows(2) {
            let next = |i: usize| {
                phi[(i, 0)] * x[0] + phi[(i, 1)] * x[1] + g0[(i, 0)] * pair[0] + g1[(i, 0)] * pair[1]
            };
            x = [next(0), next(1)];
            all.push(x[0]);
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_is_followed_with_the_lag_of_a_second_order_servo() {
        let servo = Servo { frequency_hz: 15.0, damping_ratio: 0.8 };
        let ramp: Vec<f64> = (0..800).map(|i| f64::from(i) * 0.0025).collect();
        let followed = servo.follow(&ramp, 0.0025);
        // 2 zeta / w behind
        let lag_s = 1.6 / (TAU * 15.0);
        assert!((followed[799] - (ramp[799] - lag_s)).abs() < 1e-9);
    }
}
