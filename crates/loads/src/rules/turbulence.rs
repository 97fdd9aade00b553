//! Intensity of continuous turbulence (CS 25.341(b)(3)).

use super::{Mark, Quantity, between, share_by_speed};
use crate::design::{Design, Rules};
use nastran::InputError;

/// Reference intensities up to VC: altitude, m, and m/s TAS.
const U_SIGMA: [(f64, f64); 2] = [(0.0, 27.43), (7315.0, 24.08)];

impl Design {
    /// The limit turbulence intensity at an altitude, m, and an equivalent airspeed, m/s: U_sigma = F_g U_sigma_ref, m/s TAS, behind
    /// the reference intensity.
    ///
    /// # Errors
    /// If neither the plan nor its rules give what it is made of.
    pub fn turbulence_intensity(&self, h_m: f64, v_eas_m_s: f64) -> Result<[Quantity; 2], InputError> {
        let share = share_by_speed(self, v_eas_m_s);
        let reference = match (self.gust_speeds.u_sigma_ref_m_s, self.rules) {
            (Some(own), _) => Quantity::own("U_sigma_ref", own * share, "m/s TAS"),
            (None, Rules::Cs25) => {
                let value = between(&U_SIGMA, h_m) * share;
                Quantity::new("U_sigma_ref", value, "m/s TAS", "CS 25.341(b)(3)", Mark::Code)
            }
            (None, _) => {
                let what = "the reference intensity of turbulence (`U_sigma_ref_m_s`)";
                return Err(self.asked_for("gust_speeds", what));
            }
        };
        let factor = self.profile_alleviation(h_m)?;
        let mut limit =
            Quantity { name: "U_sigma".into(), value: reference.value * factor.value, ..reference.clone() };
        if factor.mark == Mark::Own {
            limit.mark = Mark::Own;
        }
        Ok([reference, limit])
    }
}
