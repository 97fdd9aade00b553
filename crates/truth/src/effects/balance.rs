//! What effects add to the loads that reach the balance.

use super::{Effect, Record};
use crate::random::{Purpose, Random};
use crate::rig::{Flight, GRAVITY_M_S2};
use std::f64::consts::TAU;

/// Mass of the joiner, kg; its moments follow from shares of its radius of inertia.
const JOINER_KG: f64 = 4.0;
/// Rate at which friction is .7 of its whole, rad/s.
const FRICTION_RAD_S: f64 = 0.015;
/// Dynamic pressure that a tone refers to, Pa.
const Q_REF_PA: f64 = 551.25;

impl Effect {
    pub(crate) fn on_balance(&self, record: &Record<'_>, flight: &mut Flight) {
        let p = self.value(0);
        let [alpha, rate, second] = record.alpha;
        let [fz, mx, my] = &mut flight.loads;
        match self.name.as_str() {
            "joiner_inertia" => {
                // a rigid body that turns about the axis of pitch: what accelerates it, tangentially and towards the axis,
                // and its weight in axes that turn with it
                let radius_m = (p / JOINER_KG).max(0.0).sqrt();
                let (aft, up) = (JOINER_KG * radius_m * self.value(1), JOINER_KG * radius_m * self.value(2));
                for i in 0..fz.len() {
                    let (sin, cos) = alpha[i].sin_cos();
                    fz[i] += aft * second[i] + up * rate[i] * rate[i];
                    my[i] += GRAVITY_M_S2 * (aft * (cos - 1.0) + up * sin) - p * second[i];
                }
            }
            "friction" => {
                for (my, rate) in my.iter_mut().zip(rate) {
                    *my += p * rate / rate.hypot(FRICTION_RAD_S);
                }
            }
            "cable_stiffness" => {
                for (my, alpha) in my.iter_mut().zip(alpha) {
                    *my -= p * alpha.tan();
                }
            }
            "mx_alpha_squared" => {
                for (mx, alpha) in mx.iter_mut().zip(alpha) {
                    *mx += p * record.q_pa * alpha.sin().powi(2);
                }
            }
            "shedding_tone" => {
                let Some(number) = record.number else { return };
                let phase = TAU * Random::new(number, Purpose::Tone).unit();
                let hz = self.value(1) * record.v_m_s;
                for i in 0..fz.len() {
                    let t_s = i as f64 * record.time_step_s;
                    let tone = p * record.q_pa / Q_REF_PA * (TAU * hz * t_s + phase).sin();
                    fz[i] += tone;
                    mx[i] += 0.8 * tone;
                    my[i] -= 0.25 * tone;
                }
            }
            _ => {}
        }
    }
}
