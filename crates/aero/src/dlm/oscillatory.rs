//! The oscillatory influence matrix and its factorisation.

use crate::dlm::exponentials::KernelIntegral;
use crate::dlm::increment::Increment;
use crate::dlm::numerators::Stream;
use crate::dlm::span_fit::SpanFit;
use crate::dlm::strips::Strip;
use crate::error::AeroError;
use crate::lattice::Lattice;
use crate::mirror::MirrorPlane;
use crate::vlm::influence;
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatRef, c64};
use serde::{Deserialize, Serialize};

/// How the doublets' incidence is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DlmSettings {
    /// Integrals of the kernel.
    pub integral: KernelIntegral,
    /// Integral along the doublet line.
    pub fit: SpanFit,
}

/// A lattice at one Mach number, ready for any frequency.
#[derive(Debug, Clone)]
pub struct DoubletLattice {
    steady: Mat<f64>,
    own: Increment,
    /// The image's strips as senders and the factor of their pressures.
    image: Option<(Increment, f64)>,
    mach: f64,
    integral: KernelIntegral,
    ids: Vec<u32>,
}

impl DoubletLattice {
    /// Computes what does not depend on the frequency.
    ///
    /// # Errors
    /// As [`influence`], and if a box has no width across the stream.
    pub fn new(
        lattice: &Lattice,
        plane: MirrorPlane,
        mach: f64,
        settings: &DlmSettings,
    ) -> Result<Self, AeroError> {
        let steady = influence(lattice, plane, mach)?;
        let strips = Strip::all(&lattice.boxes)?;
        let image = match plane.image() {
            None => None,
            Some((y_m, sign)) => {
                let senders = Strip::all(&lattice.mirrored(y_m).0.boxes)?;
                Some((Increment { receivers: strips.clone(), senders, fit: settings.fit }, sign))
            }
        };
        Ok(Self {
            steady,
            own: Increment { receivers: strips.clone(), senders: strips, fit: settings.fit },
            image,
            mach,
            integral: settings.integral,
            ids: lattice.boxes.iter().map(|panel| panel.id).collect(),
        })
    }

    /// The influence matrix A, n by n, at `omega_over_v` in 1/m: incidence `w_i` that box i needs for the pressure
    /// coefficients `cp_j`, w = A cp. At 0 it is the vortex lattice's.
    ///
    /// # Errors
    /// If the frequency is negative or not a number.
    pub fn influence(&self, omega_over_v: f64) -> Result<Mat<c64>, AeroError> {
        if !(omega_over_v >= 0.0 && omega_over_v.is_finite()) {
            return Err(AeroError::Frequency { omega_over_v });
        }
        let mut matrix =
            Mat::from_fn(self.steady.nrows(), self.steady.ncols(), |i, j| c64::from(self.steady[(i, j)]));
        if omega_over_v > 0.0 {
            let stream = Stream::new(self.mach, omega_over_v, self.integral);
            matrix += self.own.matrix(&stream);
            if let Some((image, sign)) = &self.image {
                matrix += image.matrix(&stream) * faer::Scale(c64::from(*sign));
            }
        }
        Ok(matrix)
    }

    /// Factorises the matrix at `omega_over_v` in 1/m.
    ///
    /// # Errors
    /// As [`DoubletLattice::influence`], and if the matrix is singular.
    pub fn at(&self, omega_over_v: f64) -> Result<OscillatoryAero, AeroError> {
        let factors = self.influence(omega_over_v)?.partial_piv_lu();
        Ok(OscillatoryAero { factors })
    }
}

/// The influence matrix at one frequency: [`DoubletLattice::influence`] for a single use.
///
/// # Errors
/// As [`DoubletLattice::new`] and [`DoubletLattice::influence`].
pub fn oscillatory(
    lattice: &Lattice,
    plane: MirrorPlane,
    mach: f64,
    omega_over_v: f64,
    settings: &DlmSettings,
) -> Result<Mat<c64>, AeroError> {
    DoubletLattice::new(lattice, plane, mach, settings)?.influence(omega_over_v)
}

/// The lattice solved at one frequency: pressures for any incidence.
#[derive(Debug, Clone)]
pub struct OscillatoryAero {
    factors: PartialPivLu<c64>,
}

impl OscillatoryAero {
    /// Amplitudes of the pressure coefficients, n by columns, for those of the incidences in rad, n by columns.
    ///
    /// # Panics
    /// If `w` has not one row per box.
    pub fn pressures(&self, w: MatRef<'_, c64>) -> Mat<c64> {
        self.factors.solve(w)
    }
}
