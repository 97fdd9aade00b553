//! Derived gust velocities and Pratt's formula (14 CFR 23.341, CS-VLA 341).

use super::{Mark, Quantity, between};
use crate::atmosphere::{Air, G_M_S2, RHO0_KG_M3};
use crate::design::{Design, Rules, Speed};
use nastran::InputError;

/// 20 000 and 50 000 ft, m.
const KNEES_M: [f64; 2] = [6096.0, 15_240.0];

/// What Pratt's formula knows of an aircraft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Airframe {
    /// Wing area, m^2.
    pub area_m2: f64,
    /// Mean geometric chord, m.
    pub mean_chord_m: f64,
    /// Slope of the aircraft's lift coefficient, 1/rad.
    pub lift_slope_per_rad: f64,
}

/// A gust by Pratt's formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pratt {
    /// Mass ratio.
    pub mu_g: f64,
    /// Alleviation factor.
    pub k_g: f64,
    /// Change of the load factor.
    pub delta_n: f64,
}

impl Pratt {
    /// Gust of `u_de`, m/s EAS, on an aircraft of a mass, kg, at an equivalent airspeed, m/s, in this air.
    ///
    /// 14 CFR 23.341(c): mu_g = 2 (m/S)/(rho c a), K_g = 0.88 mu_g/(5.3 + mu_g), Delta n = K_g rho0 U_de V a S/(2 m g).
    pub fn of(airframe: &Airframe, mass_kg: f64, air: &Air, v_eas_m_s: f64, u_de_m_s: f64) -> Self {
        let Airframe { area_m2, mean_chord_m, lift_slope_per_rad: slope } = *airframe;
        let mu_g = 2.0 * mass_kg / area_m2 / (air.rho_kg_m3 * mean_chord_m * slope);
        let k_g = 0.88 * mu_g / (5.3 + mu_g);
        let delta_n = k_g * RHO0_KG_M3 * u_de_m_s * v_eas_m_s * slope / (2.0 * mass_kg * G_M_S2 / area_m2);
        Self { mu_g, k_g, delta_n }
    }
}

impl Design {
    /// The derived gust velocity at a design speed and an altitude, m: m/s EAS.
    ///
    /// # Errors
    /// If neither the plan nor its rules give it.
    pub fn derived_gust(&self, speed: Speed, h_m: f64) -> Result<Quantity, InputError> {
        let name = format!("U_de at {}", speed.name());
        let (own, field) = match speed {
            Speed::VB => (self.gust_speeds.u_de_vb_m_s, "U_de_VB_m_s"),
            Speed::VC => (self.gust_speeds.u_de_vc_m_s, "U_de_VC_m_s"),
            Speed::VD => (self.gust_speeds.u_de_vd_m_s, "U_de_VD_m_s"),
            Speed::VA | Speed::VF => {
                let message = format!("there is no derived gust at {}", speed.name());
                return Err(self.wrong("gusts", message, "expected VB, VC or VD in `Pratt`"));
            }
        };
        if let Some(own) = own {
            return Ok(Quantity::own(name, own, "m/s EAS"));
        }
        let found = match (self.rules, speed) {
            (Rules::Vla, Speed::VC) => Some((15.24, "CS-VLA 333(c)(1)(i)", Mark::Code)),
            (Rules::Vla, Speed::VD) => Some((7.62, "CS-VLA 333(c)(1)(ii)", Mark::Code)),
            (Rules::Cs23Normal, Speed::VC) => Some((
                between(&[(KNEES_M[0], 15.24), (KNEES_M[1], 7.62)], h_m),
                "14 CFR 23.333(c)(1)(i) before amendment 64",
                Mark::Text,
            )),
            (Rules::Cs23Normal, Speed::VD) => Some((
                between(&[(KNEES_M[0], 7.62), (KNEES_M[1], 3.81)], h_m),
                "14 CFR 23.333(c)(1)(ii) before amendment 64",
                Mark::Text,
            )),
            // Rough air of the commuter category; its lessening above 20 000 ft was not read.
            (Rules::Cs23Normal, Speed::VB) if h_m <= KNEES_M[0] => Some((
                66.0 * 0.3048,
                "14 CFR 23.333(c)(1)(iii) before amendment 64 (commuter category)",
                Mark::Text,
            )),
            _ => None,
        };
        let what = format!("the derived gust velocity at {} and {h_m} m", speed.name());
        found
            .map(|(value, source, mark)| Quantity::new(name, value, "m/s EAS", source, mark))
            .ok_or_else(|| self.asked_for("gust_speeds", &format!("{what} (`{field}`)")))
    }
}
