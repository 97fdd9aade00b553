//! Flutter of the wing that really bends: p-k about the equilibrium of every airspeed.
//!
//! Stiffness, places and directions are those of the bent wing at that airspeed (matched), so a mode may become unstable
//! and, where the wing bends further, stable again: a hump.

use super::{Aeroelastic, FlutterError, GafTable};
use aero::{Corrections, DlmSettings, DoubletLattice};
use coupling::{BentMotion, BentMotionError, CouplingError, LargeState, LargeWing, SteadyCase};
use faer::{Mat, c64};
use std::f64::consts::TAU;

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

/// The wing at an airspeed.
#[derive(Debug, Clone)]
pub struct BentPoint {
    /// The case.
    pub case: SteadyCase,
    /// Its equilibrium.
    pub state: LargeState,
    /// Natural frequencies without the air's answer, rad/s, ascending.
    pub omega_rad_s: Vec<f64>,
    /// Roots (1/s) that the modes become in the air; those that could not be followed are not there.
    pub roots: Vec<c64>,
}

/// A change of stability over airspeed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentCrossing {
    /// Airspeed, m/s, linear between those looked at.
    pub v_m_s: f64,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Rise of the tip, m.
    pub tip_z_m: f64,
    /// Whether the wing becomes unstable there (and not stable again).
    pub unstable: bool,
}

impl BentPoint {
    /// The oscillation that grows fastest, 1/s.
    pub fn least_stable(&self) -> Option<c64> {
        let oscillating = self.roots.iter().filter(|root| root.im > 0.0);
        oscillating.copied().max_by(|a, b| (a.re / a.im).total_cmp(&(b.re / b.im)))
    }
}

/// Equilibria and roots of cases at one angle of attack and ascending airspeed, in so many tangent modes of one damping ratio.
///
/// # Errors
/// If there is no equilibrium, or modes, the lattice or the roots cannot be found.
pub fn flutter_of_bent_wing(
    wing: &LargeWing,
    cases: &[SteadyCase],
    corrections: &[Corrections],
    count: usize,
    damping_ratio: f64,
) -> Result<Vec<BentPoint>, BentFlutterError> {
    let states = wing.solve_with(cases, corrections)?;
    let mut points = Vec::with_capacity(cases.len());
    for ((case, corrections), state) in cases.iter().zip(corrections).zip(states) {
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
        let roots = curves.branches.iter().filter_map(|branch| Some(branch.first()?.p)).collect();
        points.push(BentPoint { case: case.clone(), state, omega_rad_s: motion.omega_rad_s, roots });
    }
    Ok(points)
}

/// Where the least stable oscillation changes its stability.
pub fn crossings(points: &[BentPoint]) -> Vec<BentCrossing> {
    let mut found = Vec::new();
    for pair in points.windows(2) {
        let (Some(a), Some(b)) = (pair[0].least_stable(), pair[1].least_stable()) else { continue };
        let (g_a, g_b) = (a.re / a.im, b.re / b.im);
        if (g_a > 0.0) == (g_b > 0.0) {
            continue;
        }
        let share = g_a / (g_a - g_b);
        let mix = |a: f64, b: f64| a + share * (b - a);
        found.push(BentCrossing {
            v_m_s: mix(pair[0].case.flow.v_m_s, pair[1].case.flow.v_m_s),
            // That of the unstable side: the other may be another mode.
            frequency_hz: if g_b > 0.0 { b.im } else { a.im } / TAU,
            tip_z_m: mix(pair[0].state.tip_m.z, pair[1].state.tip_m.z),
            unstable: g_b > 0.0,
        });
    }
    found
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
