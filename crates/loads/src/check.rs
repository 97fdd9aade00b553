//! What the numbers of a plan must satisfy, before anything is made of them.

use crate::atmosphere::ALTITUDES_M;
use crate::design::{Design, Gradients, Gust};
use nastran::InputError;
use std::collections::BTreeSet;

impl Design {
    /// Numbers that cannot be.
    ///
    /// # Errors
    /// At the field of the plan's file.
    pub fn check(&self) -> Result<(), InputError> {
        self.check_masses()?;
        self.check_speeds()?;
        self.check_factors()?;
        if self.altitudes_m.is_empty() {
            return Err(self.wrong("altitudes_m", "there is no altitude", "give at least one, such as 0.0"));
        }
        if let Some(h) = self.altitudes_m.iter().find(|h| !ALTITUDES_M.contains(h)) {
            let message = format!("{h} m is outside the standard atmosphere of the program");
            return Err(self.wrong("altitudes_m", message, "expected -2000 to 20000 m"));
        }
        for gust in &self.gusts {
            self.check_gust(gust)?;
        }
        self.check_gust_speeds()
    }

    fn check_masses(&self) -> Result<(), InputError> {
        if self.masses.is_empty() {
            return Err(self.wrong(
                "masses",
                "there is no mass",
                "give at least one: (name: .., mass_kg: ..)",
            ));
        }
        let mut names = BTreeSet::new();
        for mass in &self.masses {
            let inertia = [mass.ixx_kg_m2, mass.iyy_kg_m2, mass.izz_kg_m2];
            if !positive(mass.mass_kg) || inertia.into_iter().flatten().any(|i| !positive(i)) {
                let message = format!("the mass or a moment of inertia of `{}` is not above zero", mass.name);
                return Err(self.wrong("masses", message, "expected kg and kg m^2 above zero"));
            }
            if !names.insert(&mass.name) {
                let message = format!("two masses are called `{}`", mass.name);
                return Err(self.wrong("masses", message, "give every mass its own name"));
            }
        }
        Ok(())
    }

    fn check_speeds(&self) -> Result<(), InputError> {
        let field = "design_speeds_EAS_m_s";
        let speeds = &self.speeds;
        let all = [speeds.va, speeds.vb, Some(speeds.vc), Some(speeds.vd), speeds.vf];
        if all.into_iter().flatten().any(|v| !positive(v)) {
            return Err(self.wrong(field, "a design speed is not above zero", "expected m/s EAS above zero"));
        }
        if speeds.vd <= speeds.vc {
            let message = format!("VD {} m/s is not above VC {} m/s", speeds.vd, speeds.vc);
            return Err(self.wrong(field, message, "a dive is faster than cruise"));
        }
        for (name, v) in [("VA", speeds.va), ("VB", speeds.vb)] {
            if let Some(v) = v.filter(|v| *v > speeds.vd) {
                let message = format!("{name} {v} m/s is above VD {} m/s", speeds.vd);
                return Err(self.wrong(field, message, "design speeds are at most VD"));
            }
        }
        Ok(())
    }

    fn check_factors(&self) -> Result<(), InputError> {
        if let Some(own) = self.factors
            && !(own.n1 > 1.0 && own.n2 < 0.0 && own.n2_at_vd >= own.n2 && own.n2_at_vd < own.n1)
        {
            let help = "expected n1 above one, n2 below zero, and n2_at_VD not below n2";
            return Err(self.wrong("limit_load_factors", "these limit load factors make no envelope", help));
        }
        match self.lift {
            Some(lift) if !(lift.cl_max > 0.0 && lift.cl_min < 0.0) => {
                let help = "expected cl_max above zero and cl_min below zero";
                Err(self.wrong("lift", "these lift coefficients make no stall line", help))
            }
            _ => Ok(()),
        }
    }

    fn check_gust(&self, gust: &Gust) -> Result<(), InputError> {
        let (at, directions) = match gust {
            Gust::Pratt { at } => (at, None),
            Gust::Discrete { at, gradients_m, directions, .. } => {
                if let Gradients::Of(own) = gradients_m
                    && (own.is_empty() || own.iter().any(|h| !positive(*h)))
                {
                    let message = "a gradient is not above zero, or there is none";
                    return Err(self.wrong(
                        "gradients_m",
                        message,
                        "expected `Default` or `Of([9.0, 30.0])`, in m",
                    ));
                }
                (at, Some(directions))
            }
            Gust::Turbulence { at, scale_m, cut_off_hz, directions, .. } => {
                if !(positive(*scale_m) && positive(*cut_off_hz)) {
                    let message = "the scale or the cut-off of turbulence is not above zero";
                    return Err(self.wrong("gusts", message, "expected scale_m in m and cut_off_hz in Hz"));
                }
                (at, Some(directions))
            }
        };
        if at.is_empty() || directions.is_some_and(Vec::is_empty) {
            return Err(self.wrong("gusts", "a gust has no speed or no direction", "such as `at: [VC, VD]`"));
        }
        Ok(())
    }

    fn check_gust_speeds(&self) -> Result<(), InputError> {
        let own = &self.gust_speeds;
        let all = [
            own.u_de_vb_m_s,
            own.u_de_vc_m_s,
            own.u_de_vd_m_s,
            own.u_ref_m_s,
            own.u_sigma_ref_m_s,
            own.f_g,
            own.z_mo_m,
            own.mlw_kg,
            own.mzfw_kg,
            own.mtow_kg,
        ];
        if all.into_iter().flatten().any(|value| !positive(value)) {
            let help = "expected m/s, m and kg above zero";
            return Err(self.wrong("gust_speeds", "a number of `gust_speeds` is not above zero", help));
        }
        let mtow = self.mtow_kg();
        for (name, mass) in [("MLW", own.mlw_kg), ("MZFW", own.mzfw_kg)] {
            if let Some(mass) = mass.filter(|mass| *mass > mtow) {
                let message = format!("{name} {mass} kg is above the largest take-off mass {mtow} kg");
                return Err(self.wrong("gust_speeds", message, "give MTOW_kg, if no mass case is so heavy"));
            }
        }
        Ok(())
    }
}

fn positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}
