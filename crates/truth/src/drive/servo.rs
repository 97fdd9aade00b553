//! The ailerons' servo: second order.

use crate::signals::second_order;
use std::f64::consts::TAU;

/// A servo that follows its command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Servo {
    /// Natural frequency, Hz; infinite: it follows at once.
    pub frequency_hz: f64,
    /// Damping over critical.
    pub damping_ratio: f64,
}

impl Servo {
    /// Deflections of a command that rests before its first sample.
    pub fn follow(&self, command: &[f64], time_step_s: f64) -> Vec<f64> {
        if self.frequency_hz.is_infinite() {
            return command.to_vec();
        }
        second_order(command, TAU * self.frequency_hz, self.damping_ratio, time_step_s)
    }
}
