//! A rig's modes in the air of the doublet lattice, for p-k.

use super::modal_air::incidence_of_motion;
use super::{FlutterError, GafTable};
use crate::rig::Rig;
use aero::{Corrections, DoubletLattice};
use faer::{Mat, Scale, c64};

/// Pressures of a rig's modes at a table of frequencies: solved once, integrated with any corrections.
#[derive(Debug, Clone)]
pub struct ModePressures {
    omega_over_v: Vec<f64>,
    motion: Mat<f64>,
    cp: Vec<Mat<c64>>,
    /// Those of air without memory or apparent mass: the steady answer to the momentary incidence.
    steady: Vec<Mat<c64>>,
}

impl ModePressures {
    /// The same with a factor on all that air does beyond the steady answer to the momentary incidence; the steady limit stays.
    #[must_use]
    pub fn with_unsteady(&self, factor: f64) -> Self {
        let one = |(cp, steady): (&Mat<c64>, &Mat<c64>)| steady + (cp - steady) * Scale(c64::from(factor));
        Self { cp: self.cp.iter().zip(&self.steady).map(one).collect(), ..self.clone() }
    }
}

impl Rig<'_> {
    /// How the boxes move with the kept modes: two rows a box (h along the normal at the midpoint, theta nose up).
    pub fn box_motion(&self) -> Mat<f64> {
        match &self.wing.supported {
            Some(supported) => &supported.k_displacements() * &self.operators.shapes,
            None => Mat::zeros(2 * self.wing.lattice.len(), 0),
        }
    }

    /// Pressures of the kept modes at rising frequencies omega/V, 1/m; one factorisation each.
    ///
    /// # Errors
    /// As [`DoubletLattice::at`].
    pub fn mode_pressures(
        &self,
        dlm: &DoubletLattice,
        omega_over_v: &[f64],
    ) -> Result<ModePressures, FlutterError> {
        let motion = self.box_motion();
        let at_rest = dlm.at(0.0)?;
        let (mut cp, mut steady) = (Vec::new(), Vec::new());
        for &kappa in omega_over_v {
            let w = incidence_of_motion(&self.wing.lattice, motion.as_ref(), kappa);
            cp.push(dlm.at(kappa)?.pressures(w.as_ref()));
            steady.push(at_rest.pressures(w.as_ref()));
        }
        Ok(ModePressures { omega_over_v: omega_over_v.to_vec(), motion, cp, steady })
    }

    /// The generalised forces of these pressures with corrections of every box of the lattice.
    ///
    /// # Errors
    /// If the frequencies do not rise.
    pub fn gaf_table(
        &self,
        pressures: &ModePressures,
        corrections: &Corrections,
    ) -> Result<GafTable, FlutterError> {
        let loads = self.wing.integration.corrected(corrections);
        let q = pressures.cp.iter().map(|cp| loads.weighed(pressures.motion.transpose(), cp.as_ref()));
        GafTable::new(pressures.omega_over_v.clone(), q.collect())
    }
}

#[cfg(test)]
mod tests;
