//! The bent wing as a calibration sees it.

use super::wing::{LargeState, LargeWing};
use crate::case::{CorrectableBoxes, RootSensitivity, SteadyCase, SteadyModel};
use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use aero::Corrections;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

/// A bent wing in many cases with many corrections: each is continued from the same case with the corrections that were asked for before,
/// first from theory, whose equilibrium is found once. Equilibria that are found on another way differ by what Newton's steps leave.
#[derive(Debug)]
pub struct LargeModel<'a> {
    wing: &'a LargeWing,
    /// What is known of cases by their numbers.
    known: Mutex<BTreeMap<Vec<u64>, Known>>,
}

/// Equilibria of a case.
#[derive(Debug, Clone)]
struct Known {
    /// By theory; nothing where there is none.
    theory: Option<Arc<LargeState>>,
    /// The last that was found, with its corrections.
    last: Option<(Corrections, Arc<LargeState>)>,
}

impl LargeWing {
    /// The wing for a calibration.
    pub fn model(&self) -> LargeModel<'_> {
        LargeModel { wing: self, known: Mutex::new(BTreeMap::new()) }
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
    ) -> Result<Arc<LargeState>, CouplingError> {
        let numbers = [case.flow.v_m_s, case.flow.rho_kg_m3, case.alpha_rad];
        let key: Vec<u64> = numbers.iter().chain(&case.controls_rad).map(|v| v.to_bits()).collect();
        let theory = Corrections::neutral(self.wing.elastic.correctable.len());
        let Known { theory: by_theory, last } = self.known(&key, case, &theory);
        if let Some(start) = by_theory.as_ref().filter(|_| *corrections == theory) {
            return Ok(Arc::clone(start));
        }
        let starts = last.into_iter().chain(by_theory.map(|start| (theory, start)));
        for (of, start) in starts {
            if of == *corrections {
                return Ok(start);
            }
            let (from, to) = (self.wing.air(case, &of)?, self.wing.air(case, corrections)?);
            if let Ok(found) = self.wing.continued(&start.state, &from, &to, case) {
                return Ok(self.keep(&key, corrections, found));
            }
        }
        let found = self.wing.solve(std::slice::from_ref(case), corrections)?.remove(0);
        Ok(self.keep(&key, corrections, found))
    }

    fn known(&self, key: &[u64], case: &SteadyCase, theory: &Corrections) -> Known {
        let known = self.known.lock().ok().and_then(|all| all.get(key).cloned());
        known.unwrap_or_else(|| {
            let found = self.wing.solve(std::slice::from_ref(case), theory).ok();
            let theory = found.and_then(|mut found| found.pop()).map(Arc::new);
            let known = Known { theory, last: None };
            if let Ok(mut all) = self.known.lock() {
                all.insert(key.to_vec(), known.clone());
            }
            known
        })
    }

    fn keep(&self, key: &[u64], corrections: &Corrections, found: LargeState) -> Arc<LargeState> {
        let found = Arc::new(found);
        if let Ok(mut all) = self.known.lock()
            && let Some(known) = all.get_mut(key)
        {
            known.last = Some((corrections.clone(), Arc::clone(&found)));
        }
        found
    }

    fn each<T: Send>(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
        of: impl Fn(&SteadyCase, &LargeState) -> Result<T, CouplingError> + Sync,
    ) -> Result<Vec<T>, CouplingError> {
        cases.par_iter().map(|case| of(case, &*self.equilibrium(case, corrections)?)).collect()
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
        self.each(cases, corrections, |case, state| self.wing.sensitivity(case, corrections, state))
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        let theory = Corrections::neutral(self.wing.elastic.correctable.len());
        let state = self.equilibrium(case, &theory)?;
        Ok(self.wing.elastic.correctable.places.iter().map(|place| state.cp[*place]).collect())
    }
}
