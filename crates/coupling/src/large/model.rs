//! The bent wing as a calibration sees it.

use super::wing::{LargeState, LargeWing};
use crate::case::{CorrectableBoxes, RootSensitivity, SteadyCase, SteadyModel};
use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use aero::Corrections;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock};

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
    theory: Option<Arc<Found>>,
    /// The last that was found, with its corrections.
    last: Option<(Corrections, Arc<Found>)>,
}

/// An equilibrium, and its readings with their derivatives once they were asked for: several fits begin from theory.
#[derive(Debug)]
struct Found {
    state: LargeState,
    sensitivity: OnceLock<RootSensitivity>,
}

impl From<LargeState> for Found {
    fn from(state: LargeState) -> Self {
        Self { state, sensitivity: OnceLock::new() }
    }
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
    ) -> Result<LargeState, CouplingError> {
        Ok(self.found(case, corrections)?.state.clone())
    }

    fn found(&self, case: &SteadyCase, corrections: &Corrections) -> Result<Arc<Found>, CouplingError> {
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
            if let Ok(found) = self.wing.continued(&start.state.state, &from, &to, case) {
                return Ok(self.keep(&key, corrections, found));
            }
        }
        let found = self.wing.solve(std::slice::from_ref(case), corrections)?.remove(0);
        Ok(self.keep(&key, corrections, found))
    }

    fn known(&self, key: &[u64], case: &SteadyCase, theory: &Corrections) -> Known {
        let known = self.known.lock().ok().and_then(|all| all.get(key).cloned());
        known.unwrap_or_else(|| {
            let theory = self.by_theory(case, theory).ok().map(|state| Arc::new(Found::from(state)));
            let known = Known { theory, last: None };
            if let Ok(mut all) = self.known.lock() {
                all.insert(key.to_vec(), known.clone());
            }
            known
        })
    }

    /// The equilibrium by theory: from rest without angle of attack, with one from there.
    fn by_theory(&self, case: &SteadyCase, theory: &Corrections) -> Result<LargeState, CouplingError> {
        let level = SteadyCase { alpha_rad: 0.0, ..case.clone() };
        if level != *case
            && let Ok(start) = self.found(&level, theory)
            && let Ok(found) = self.wing.continued_from(&start.state, &level, case, theory)
        {
            return Ok(found);
        }
        Ok(self.wing.solve(std::slice::from_ref(case), theory)?.remove(0))
    }

    fn keep(&self, key: &[u64], corrections: &Corrections, found: LargeState) -> Arc<Found> {
        let found = Arc::new(Found::from(found));
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
        cases.par_iter().map(|case| of(case, &self.found(case, corrections)?.state)).collect()
    }
}

impl SteadyModel for LargeModel<'_> {
    fn correctable(&self) -> &CorrectableBoxes {
        &self.wing.elastic.correctable
    }

    fn bends_far(&self) -> bool {
        true
    }

    fn nearby(&self) -> Option<&dyn SteadyModel> {
        Some(&self.wing.elastic)
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
        let one = |case: &SteadyCase| {
            let found = self.found(case, corrections)?;
            if let Some(known) = found.sensitivity.get() {
                return Ok(known.clone());
            }
            let own = self.wing.sensitivity(case, corrections, &found.state)?;
            Ok(found.sensitivity.get_or_init(|| own).clone())
        };
        cases.par_iter().map(one).collect()
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        let theory = Corrections::neutral(self.wing.elastic.correctable.len());
        let found = self.found(case, &theory)?;
        Ok(self.wing.elastic.correctable.places.iter().map(|place| found.state.cp[*place]).collect())
    }
}
