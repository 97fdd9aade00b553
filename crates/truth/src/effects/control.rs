//! What effects make of a control's command and of its servo's answer.

use super::{Effect, Record};
use crate::signals::second_order;

/// Dynamic pressure that softness refers to: 30 m/s at sea level, Pa.
const Q_REF_PA: f64 = 551.25;
/// Hinge moment of the angle of attack over that of the deflection.
const ALPHA_SHARE: f64 = 0.15;
/// Damping ratio of a servo that is late.
const LATE_DAMPING: f64 = 0.9;
/// Deflection over which up becomes down, rad.
const UP_DOWN_RAD: f64 = 0.02;

impl Effect {
    /// Between command and servo.
    pub(crate) fn on_command(&self, record: &Record<'_>, delta: &mut [f64]) {
        let p = self.value(0);
        if p <= 0.0 {
            return;
        }
        match self.name.as_str() {
            // second order with the delay of the stated time
            "act_lag" => {
                let omega = 2.0 * LATE_DAMPING / p;
                let late = second_order(delta, omega, LATE_DAMPING, record.time_step_s);
                delta.copy_from_slice(&late);
            }
            "act_rate" => {
                let most = record.time_step_s / p;
                let mut place = delta.first().copied().unwrap_or_default();
                for value in delta {
                    place += most * ((*value - place) / most).tanh();
                    *value = place;
                }
            }
            _ => {}
        }
    }

    /// Between servo and air.
    pub(crate) fn on_deflection(&self, record: &Record<'_>, control: usize, delta: &mut [f64]) {
        let p = self.value(0);
        let alpha = |i: usize| record.alpha[0][i];
        match self.name.as_str() {
            "ctl_saturation" => {
                // those further out lose more; 1/sqrt(1 + 2/3 x²) begins as tanh x / x does
                let inverse = p * (0.92 + 0.08 * control as f64);
                for d in delta {
                    *d /= (1.0 + (inverse * *d).powi(2) / 1.5).sqrt();
                }
            }
            "ctl_compliance" => {
                let soft = p * record.q_pa / Q_REF_PA;
                for (i, d) in delta.iter_mut().enumerate() {
                    *d = (*d - soft * ALPHA_SHARE * alpha(i).sin()) / (1.0 + soft);
                }
            }
            "backlash" if p > 0.0 => {
                let half = 0.5 * p.to_radians();
                let mut places = [delta.first().copied().unwrap_or_default(); 3];
                for value in delta {
                    for (place, width) in places.iter_mut().zip([0.5 * half, half, 1.5 * half]) {
                        *place = place.clamp(*value - width, *value + width);
                    }
                    *value = 0.25 * places[0] + 0.5 * places[1] + 0.25 * places[2];
                }
            }
            "ctl_asym" => {
                for d in delta {
                    *d *= 1.0 - p / (1.0 + (*d / UP_DOWN_RAD).exp());
                }
            }
            "ctl_alpha_interaction" => {
                for (i, d) in delta.iter_mut().enumerate() {
                    *d *= (-p * alpha(i)).exp();
                }
            }
            "delta_offset" if control == self.choice(1) => {
                for d in delta {
                    *d += p.to_radians();
                }
            }
            _ => {}
        }
    }
}
