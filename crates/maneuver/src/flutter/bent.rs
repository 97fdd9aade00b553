//! The wing that really bends at one airspeed: its equilibrium, the tangent modes about it, and the p-k roots they become.
//!
//! Stiffness, places and directions are those of the bent wing at that airspeed (matched). Over airspeed:
//! [`super::bent_sweep`].

use super::{Aeroelastic, FlutterError, GafTable};
use aero::{Corrections, DlmSettings, DoubletLattice};
use coupling::{BentMotion, BentMotionError, CouplingError, LargeState, LargeWing, SteadyCase};
use faer::{Mat, c64};

/// Reduced frequencies omega c/(2V) of the doublet lattice, c the mean chord.
const REDUCED: [f64; 12] = [0.0, 0.02, 0.05, 0.1, 0.16, 0.24, 0.34, 0.46, 0.62, 0.85, 1.2, 1.8];

/// Why there is no flutter of the bent wing.
#[derive(Debug, thiserror::Error)]
pub enum BentFlutterError {
    /// The equilibrium.
    #[error(transparent)]
    Coupling(#[from] CouplingError),
    /// Motions about it.
    #[error(transparent)]
    Motion(#[from] BentMotionError),
    /// Their roots.
    #[error(transparent)]
    Flutter(#[from] FlutterError),
}

/// The wing at an airspeed. Lists have one entry a mode; over a sweep the same entry is the same mode.
#[derive(Debug, Clone)]
pub struct BentPoint {
    /// The case.
    pub case: SteadyCase,
    /// Its equilibrium.
    pub state: LargeState,
    /// Natural frequencies without the air's answer, rad/s, followed by shape.
    pub omega_rad_s: Vec<f64>,
    /// Roots (1/s) in the air, followed over airspeed from the modes that they are at the first; nothing where one could not be followed.
    pub roots: Vec<Option<c64>>,
    /// Displacements (m) and spins of all nodes by natural mode, unit generalised mass.
    pub(super) shapes: Mat<f64>,
}

impl BentPoint {
    /// Modes ascending in frequency, roots as p-k follows each of them from a vacuum.
    pub(super) fn new(
        wing: &LargeWing,
        case: &SteadyCase,
        corrections: &Corrections,
        state: LargeState,
        (count, damping_ratio): (usize, f64),
    ) -> Result<Self, BentFlutterError> {
        let motion = wing.small_motion(case, corrections, &state, count)?;
        let table = table(wing, &motion, case)?;
        let n = motion.omega_rad_s.len();
        let diagonal = |of: &dyn Fn(f64) -> f64| {
            Mat::from_fn(n, n, |i, j| if i == j { of(motion.omega_rad_s[i]) } else { 0.0 })
        };
        let system = Aeroelastic::new(
            diagonal(&|_| 1.0),
            diagonal(&|omega| 2.0 * damping_ratio * omega),
            diagonal(&|omega| omega * omega),
            &table,
        )?;
        let curves = system.pk(&[case.flow])?;
        let roots = curves.branches.iter().map(|branch| Some(branch.first()?.p)).collect();
        let BentMotion { omega_rad_s, shapes, .. } = motion;
        Ok(Self { case: case.clone(), state, omega_rad_s, roots, shapes })
    }

    /// The oscillation that grows fastest or dies most slowly, 1/s.
    pub fn least_stable(&self) -> Option<c64> {
        let oscillating = self.roots.iter().flatten().filter(|root| root.im > 0.0);
        oscillating.copied().max_by(|a, b| (a.re / a.im).total_cmp(&(b.re / b.im)))
    }
}

/// Generalised forces per unit dynamic pressure: doublets on the moved boxes, and the steady loads that turn with them.
fn table(wing: &LargeWing, motion: &BentMotion, case: &SteadyCase) -> Result<GafTable, BentFlutterError> {
    let elastic = &wing.elastic;
    let doublets = DoubletLattice::new(&motion.lattice, elastic.plane, elastic.mach, &DlmSettings::default());
    let doublets = doublets.map_err(FlutterError::from)?;
    let q_pa = case.flow.dynamic_pressure_pa();
    let mut matrices = Vec::with_capacity(REDUCED.len());
    let chord_m = elastic.correctable.mean_chord_m();
    let frequencies: Vec<f64> = REDUCED.iter().map(|k| 2.0 * k / chord_m).collect();
    for &kappa in &frequencies {
        let w = Mat::from_fn(motion.lattice.len(), motion.omega_rad_s.len(), |j, mode| {
            c64::new(motion.incidence[(j, mode)], -kappa * motion.heave[(j, mode)])
        });
        let cp = doublets.at(kappa).map_err(FlutterError::from)?.pressures(w.as_ref());
        matrices.push(Mat::from_fn(motion.work.nrows(), cp.ncols(), |i, mode| {
            let air: c64 = (0..cp.nrows()).map(|j| cp[(j, mode)] * motion.work[(i, j)]).sum();
            air + c64::from(motion.load_stiffness[(i, mode)] / q_pa)
        }));
    }
    Ok(GafTable::new(frequencies, matrices)?)
}

#[cfg(test)]
pub(super) mod laws;
