//! Discrete gusts of one minus a cosine (CS 25.341(a)): reference velocity, alleviation by the flight profile, design
//! velocity. Its shape is flown by `fullaircraft::Gust`.

use super::{Mark, Quantity, between, share_by_speed};
use crate::design::{Design, Gradients, Gust, Rules};
use nastran::InputError;
use std::f64::consts::PI;

/// Reference velocities up to VC: altitude, m, and m/s EAS.
const U_REF: [(f64, f64); 3] = [(0.0, 17.07), (4572.0, 13.41), (18_288.0, 6.36)];

/// Length of the longest gradient, m, which design velocities refer to.
pub const LONGEST_GRADIENT_M: f64 = 107.0;
/// The shortest gradient, m.
pub const SHORTEST_GRADIENT_M: f64 = 9.0;

/// The alleviation factor at an altitude, m, for masses at landing, without fuel and at take-off, kg.
///
/// (F_gz + F_gm)/2 on the ground, linear to one at the largest operating altitude; F_gz = 1 - Z_mo/76 200 m, F_gm = root of
/// (R2 tan(pi R1/4)), R1 = MLW/MTOW, R2 = MZFW/MTOW.
pub fn alleviation(h_m: f64, z_mo_m: f64, landing_kg: f64, no_fuel_kg: f64, take_off_kg: f64) -> f64 {
    let f_gz = 1.0 - z_mo_m / 76_200.0;
    let f_gm = (no_fuel_kg / take_off_kg * (PI / 4.0 * landing_kg / take_off_kg).tan()).sqrt();
    between(&[(0.0, f64::midpoint(f_gz, f_gm)), (z_mo_m, 1.0)], h_m)
}

/// U_ds = U_ref F_g (H/107 m)^(1/6).
pub fn design_gust(u_ref_m_s: f64, f_g: f64, gradient_m: f64) -> f64 {
    u_ref_m_s * f_g * (gradient_m / LONGEST_GRADIENT_M).powf(1.0 / 6.0)
}

/// The longest gradient of the plan's discrete gusts, m; without any of its own the longest that gusts have.
pub(crate) fn longest_gradient_m(design: &Design) -> f64 {
    let own = design.gusts.iter().filter_map(|gust| match gust {
        Gust::Discrete { gradients_m: Gradients::Of(own), .. } => {
            Some(own.iter().copied().fold(0.0, f64::max))
        }
        Gust::Discrete { gradients_m: Gradients::Default, .. } => Some(LONGEST_GRADIENT_M),
        _ => None,
    });
    own.reduce(f64::max).unwrap_or(LONGEST_GRADIENT_M)
}

/// The design velocity of another gradient, m/s, by that of one: both gradients in m.
pub fn rescaled(u_ds_m_s: f64, gradient_m: f64, other_m: f64) -> f64 {
    u_ds_m_s * (other_m / gradient_m).powf(1.0 / 6.0)
}

/// The ten gradients that are flown if none are given, m: geometric, and with Pratt's 12.5 chords in the range for small aircraft.
pub fn default_gradients(mean_chord_m: f64) -> Vec<f64> {
    let first = SHORTEST_GRADIENT_M.min(12.5 * mean_chord_m);
    let ratio = LONGEST_GRADIENT_M / first;
    (0..10).map(|step| first * ratio.powf(f64::from(step) / 9.0)).collect()
}

impl Design {
    /// The reference gust velocity at an altitude, m, and an equivalent airspeed, m/s: m/s EAS.
    ///
    /// # Errors
    /// If neither the plan nor its rules give it.
    pub fn reference_gust(&self, h_m: f64, v_eas_m_s: f64) -> Result<Quantity, InputError> {
        let share = share_by_speed(self, v_eas_m_s);
        match (self.gust_speeds.u_ref_m_s, self.rules) {
            (Some(own), _) => Ok(Quantity::own("U_ref", own * share, "m/s EAS")),
            (None, Rules::Cs25) => {
                let source = "CS 25.341(a)(5)";
                Ok(Quantity::new("U_ref", between(&U_REF, h_m) * share, "m/s EAS", source, Mark::Text))
            }
            (None, _) => Err(self.asked_for("gust_speeds", "the reference gust velocity (`U_ref_m_s`)")),
        }
    }

    /// The alleviation factor of the flight profile at an altitude, m.
    ///
    /// # Errors
    /// If the plan gives neither it nor the masses and the altitude that CS-25 makes it of.
    pub fn profile_alleviation(&self, h_m: f64) -> Result<Quantity, InputError> {
        let own = &self.gust_speeds;
        if let Some(factor) = own.f_g {
            return Ok(Quantity::own("F_g", factor, "-"));
        }
        let needed = |value: Option<f64>, name: &str| {
            value.ok_or_else(|| self.asked_for("gust_speeds", &format!("`F_g`, or `{name}` to compute it")))
        };
        let z_mo = needed(own.z_mo_m, "Z_mo_m")?;
        let (mlw, mzfw) = (needed(own.mlw_kg, "MLW_kg")?, needed(own.mzfw_kg, "MZFW_kg")?);
        let value = alleviation(h_m, z_mo, mlw, mzfw, self.mtow_kg());
        Ok(Quantity::new("F_g", value, "-", "CS 25.341(a)(6)", Mark::Code))
    }
}
