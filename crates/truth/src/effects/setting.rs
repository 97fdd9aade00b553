//! What effects change about structure and air.

use super::Effect;
use crate::beam::Extra;
use crate::setting::{Setting, Stall};
use crate::wing::Wing;
use std::f64::consts::{PI, TAU};

/// Airspeed at which nothing depends on the Reynolds number, m/s.
pub const V_REF_M_S: f64 = 30.0;
/// Of separating flow: angle over which the loss begins, and chords that it takes.
const KNEE_DEG: f64 = 0.8;
const STALL_CHORDS: f64 = 4.0;

impl Effect {
    /// Changes a setting at an airspeed as the campaign says it.
    pub(crate) fn on_setting(&self, wing: &Wing, v_m_s: f64, setting: &mut Setting) {
        let p = self.value(0);
        match self.name.as_str() {
            // a stream that turns a little less outboard
            "alpha_offset" => {
                setting.incidence_rad.add(|eta| p.to_radians() * (1.0 + 0.08 * (PI * eta).cos()));
            }
            "flow_upwash_gradient" => {
                let semispan_m = wing.planform.semispan_m;
                setting.incidence_rad.add(|eta| (p * eta * semispan_m).to_radians() * (1.1 - 0.15 * eta));
            }
            // the pressure acts, and the wake drifts with its airspeed
            "q_error" => setting.airspeed *= (1.0 + p).max(0.01).sqrt(),
            "camber" => {
                let moment = self.value(1);
                setting.zero_rad.add(|eta| -p.to_radians() * (0.92 + 0.16 * eta));
                setting.moment.add(|eta| moment * (1.05 - 0.1 * eta));
            }
            "lift_slope" => {
                setting.lift.scale(|eta| 1.0 + p * (1.0 + 0.1 * (TAU * eta).sin()));
                setting.flap.iter_mut().for_each(|flap| *flap /= 1.0 + p);
            }
            "tip_loss" => setting.lift.scale(|eta| 1.0 - p * eta * eta * (0.8 + 0.25 * eta * eta)),
            "ac_shift" => setting.aft_over_c.add(|eta| p * (1.1 - 0.2 * eta)),
            // with the logarithm of the Reynolds number, as friction goes
            "re_dependence" => setting.lift.scale(|_| 1.0 + p * (V_REF_M_S / v_m_s.max(1.0)).ln()),
            "added_mass" => setting.apparent.scale(|eta| 1.0 + p * (1.0 + 0.06 * (PI * eta).cos())),
            // the wake stays near the wing for longer
            "aero_lag" => setting.wake_slower += p,
            "stall" if p != 0.0 => {
                setting.stall = Some(Stall {
                    angle_rad: self.value(1).to_radians(),
                    share: p,
                    knee_rad: KNEE_DEG.to_radians(),
                    chords: STALL_CHORDS,
                });
            }
            "ctl_scale" => {
                for (control, flap) in setting.flap.iter_mut().enumerate() {
                    *flap *= 1.0 + p * (0.96 + 0.04 * control as f64);
                }
            }
            "bend_stiff" => setting.bending.scale(|eta| 1.0 + p * (1.0 - 0.08 * (PI * eta).cos())),
            "tors_stiff" => setting.torsion.scale(|eta| 1.0 + p * (1.0 - 0.12 * (PI * eta).cos())),
            "wing_mass_error" => setting.mass.scale(|eta| 1.0 + p * (0.9 + 0.2 * eta)),
            // slow modes gain most
            "damping" => {
                let last = setting.damping.last().copied().unwrap_or_default();
                setting.damping.resize(setting.damping.len().max(12), last);
                for (mode, zeta) in setting.damping.iter_mut().enumerate() {
                    *zeta *= 1.0 + p * 0.93_f64.powf(mode as f64);
                }
            }
            "tip_mass" if p != 0.0 => {
                setting.extras.extend(tip_masses(wing, p, self.value(1), self.value(2)));
            }
            _ => {}
        }
    }
}

/// A body near the tip as three lumps: nose, middle, tail.
fn tip_masses(wing: &Wing, mass_kg: f64, eta: f64, x_over_c: f64) -> [Extra; 3] {
    [(0.25, -0.06), (0.5, 0.0), (0.25, 0.06)].map(|(share, aft)| {
        let y_m = eta * wing.planform.semispan_m;
        Extra { y_m, x_m: wing.planform.x_m(y_m, x_over_c + aft), mass_kg: share * mass_kg }
    })
}
