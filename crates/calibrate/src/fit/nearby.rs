//! A model about one set of corrections by a cheaper one, which answers corrections nearly as it does.
//!
//! ```text
//! r(x) = r_near(x) + (r - r_near)(x0) + (dr/dx - dr_near/dx)(x0) (x - x0)
//! ```
//! Right to first order at x0, with the curvature of the cheaper model: a fit on it goes where the fit itself would go, and the
//! model is asked once where it would be asked at each cone program (manifold mapping: Echeverria and Hemker, Comput. Methods
//! Appl. Math. 5 (2), 2005, with all derivatives at hand).

use aero::Corrections;
use coupling::{CorrectableBoxes, CouplingError, RootLoads, RootSensitivity, SteadyCase, SteadyModel};
use faer::Mat;

/// The cheaper model, put right about corrections.
pub(super) struct Nearby<'a> {
    near: &'a dyn SteadyModel,
    about: Corrections,
    /// By what the cheaper model is off there, in each case.
    off: Vec<(SteadyCase, RootSensitivity)>,
}

impl<'a> Nearby<'a> {
    /// About corrections at which the model itself reads `own` in groups of cases that share a flow.
    ///
    /// # Errors
    /// Those of the cheaper model.
    pub(super) fn new(
        near: &'a dyn SteadyModel,
        about: Corrections,
        groups: &[Vec<SteadyCase>],
        own: &[RootSensitivity],
    ) -> Result<Self, CouplingError> {
        let mut off = Vec::with_capacity(own.len());
        for cases in groups {
            let off_by = near.sensitivities(cases, &about)?;
            let own = &own[off.len()..];
            let differ = off_by.iter().zip(own).map(|(near, own)| combined(own, near, -1.0));
            off.extend(cases.iter().cloned().zip(differ.collect::<Vec<_>>()));
        }
        Ok(Self { near, about, off })
    }

    /// A reading of the cheaper model put right at corrections.
    fn right(&self, case: &SteadyCase, near: RootSensitivity, at: &Corrections) -> RootSensitivity {
        let Some((_, off)) = self.off.iter().find(|(known, _)| known == case) else { return near };
        let away = |channel: usize| -> f64 {
            let part = |by: &Mat<f64>, to: &[f64], from: &[f64]| -> f64 {
                to.iter().zip(from).enumerate().map(|(b, (to, from))| by[(channel, b)] * (to - from)).sum()
            };
            part(&off.by_force, &at.force, &self.about.force)
                + part(&off.by_moment, &at.moment, &self.about.moment)
                + part(&off.by_offset, &at.pressure_offset, &self.about.pressure_offset)
        };
        let sum = combined(&near, off, 1.0);
        let [fz, mx, my, tip_z_m] = std::array::from_fn(|channel| sum.readings()[channel] + away(channel));
        RootSensitivity { loads: RootLoads { fz_n: fz, mx_nm: mx, my_nm: my }, tip_z_m, ..sum }
    }
}

/// `a + factor b`, readings and derivatives.
fn combined(a: &RootSensitivity, b: &RootSensitivity, factor: f64) -> RootSensitivity {
    let sum = |a: &Mat<f64>, b: &Mat<f64>| a + faer::Scale(factor) * b;
    let [fz, mx, my, tip_z_m] =
        std::array::from_fn(|channel| a.readings()[channel] + factor * b.readings()[channel]);
    RootSensitivity {
        loads: RootLoads { fz_n: fz, mx_nm: mx, my_nm: my },
        tip_z_m,
        by_force: sum(&a.by_force, &b.by_force),
        by_moment: sum(&a.by_moment, &b.by_moment),
        by_offset: sum(&a.by_offset, &b.by_offset),
    }
}

impl SteadyModel for Nearby<'_> {
    fn correctable(&self) -> &CorrectableBoxes {
        self.near.correctable()
    }

    fn bends_far(&self) -> bool {
        true
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        let near = self.near.sensitivities(cases, corrections)?;
        Ok(cases.iter().zip(near).map(|(case, near)| self.right(case, near, corrections)).collect())
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        self.near.pressure_coefficients(case)
    }
}

#[cfg(test)]
mod tests;
