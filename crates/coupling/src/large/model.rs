//! The bent wing as a calibration sees it.

use super::wing::{LargeState, LargeWing};
use crate::case::{CorrectableBoxes, RootSensitivity, SteadyCase, SteadyModel};
use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use aero::Corrections;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// A bent wing in many cases with many corrections: each is continued from the case without corrections, whose equilibrium is
/// found once. So a result does not depend on what was asked before it.
#[derive(Debug)]
pub struct LargeModel<'a> {
    wing: &'a LargeWing,
    /// Equilibria of theory by the numbers of the case; nothing where there is none.
    theory: Mutex<BTreeMap<Vec<u64>, Option<LargeState>>>,
}

impl LargeWing {
    /// The wing for a calibration.
    pub fn model(&self) -> LargeModel<'_> {
        LargeModel { wing: self, theory: Mutex::new(BTreeMap::new()) }
    }
}

impl LargeModel<'_> {
    /// The equilibrium of a case with corrections (one entry for each correctable box).
    ///
    /// # Errors
    /// As [`LargeWing::solve`].
    pub fn equilibrium(
        &self,
        case: &SteadyCase,
        corrections: &Corrections,
    ) -> Result<LargeState, CouplingError> {
        if let Some(start) = self.theory_of(case) {
            let theory = Corrections::neutral(self.wing.elastic.correctable.len());
            if *corrections == theory {
                return Ok(start);
            }
            let (from, to) = (self.wing.air(case, &theory)?, self.wing.air(case, corrections)?);
            if let Ok(found) = self.wing.continued(&start.state, &from, &to, case) {
                return Ok(found);
            }
        }
        Ok(self.wing.solve(std::slice::from_ref(case), corrections)?.remove(0))
    }

    fn theory_of(&self, case: &SteadyCase) -> Option<LargeState> {
        let numbers = [case.flow.v_m_s, case.flow.rho_kg_m3, case.alpha_rad];
        let key: Vec<u64> = numbers.iter().chain(&case.controls_rad).map(|v| v.to_bits()).collect();
        let known = self.theory.lock().ok()?.get(&key).cloned();
        if let Some(known) = known {
            return known;
        }
        let theory = Corrections::neutral(self.wing.elastic.correctable.len());
        let found =
            self.wing.solve(std::slice::from_ref(case), &theory).ok().and_then(|mut found| found.pop());
        self.theory.lock().ok()?.insert(key, found.clone());
        found
    }

    fn each<T>(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
        of: impl Fn(&SteadyCase, LargeState) -> Result<T, CouplingError>,
    ) -> Result<Vec<T>, CouplingError> {
        cases.iter().map(|case| of(case, self.equilibrium(case, corrections)?)).collect()
    }
}

impl SteadyModel for LargeModel<'_> {
    fn correctable(&self) -> &CorrectableBoxes {
        &self.wing.elastic.correctable
    }

    fn bends_far(&self) -> bool {
        true
    }

    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError> {
        self.each(cases, corrections, |_, state| Ok(state.root))
    }

    fn tip_deflections(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<f64>, CouplingError> {
        self.each(cases, corrections, |_, state| Ok(state.tip_m.z))
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        self.each(cases, corrections, |case, state| self.wing.sensitivity(case, corrections, &state))
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        let theory = Corrections::neutral(self.wing.elastic.correctable.len());
        let state = self.equilibrium(case, &theory)?;
        Ok(self.wing.elastic.correctable.places.iter().map(|place| state.cp[*place]).collect())
    }
}
