//! The air in motion: pressures of oscillating boxes at a table of frequencies, and a rational function through them.
//!
//! A motion x(t) gives the boxes the incidence `w(p) = (w_0 + p w_1) x` with p = s/V in 1/m (s the Laplace variable), for
//! example `w_0` the angle of attack and `w_1` the distance of the three-quarter point aft of the axis of pitch. The
//! doublet lattice gives `cp(p) = Q(p) w(p)` on the imaginary axis; time needs it as a rational function of p.

pub mod accuracy;
mod basis;
mod poles;
pub mod rational;
mod shared;
pub mod table;

pub use accuracy::{Accuracy, worst_by_column, worst_by_row};
pub use rational::{RationalAir, Weighting};
pub use shared::SharedAir;
pub use table::{AirTable, MotionColumns};

use aero::{AeroError, DlmSettings, DoubletLattice, Lattice};
use coupling::ElasticWing;
use faer::{Mat, c64};

/// Reduced frequencies k = omega `c`/(2V), c the mean chord, at which the doublet lattice is solved. They reach 2, some 50
/// Hz of a .2 m chord at 18 m/s, and lie closer where the wake's answer bends.
pub const REDUCED_FREQUENCIES: [f64; 13] =
    [0.01, 0.03, 0.06, 0.1, 0.16, 0.25, 0.37, 0.53, 0.74, 1.0, 1.3, 1.65, 2.0];

/// Poles of [`UnsteadyAir::beyond`], as reduced frequencies: those of the wake in two dimensions lie at .05 and .3 (R. T.
/// Jones 1938). What they leave of the table is damping and apparent mass.
const SLOW_POLES: [f64; 3] = [0.05, 0.2, 0.6];

/// If the table's highest frequency is below this, Hz, no motion gets lags: balance and ailerons move that fast. Below 5 m/s
/// for a chord of .2 m, so that still air is the limit of slow air: apparent mass alone.
const FASTEST_MOTION_HZ: f64 = 15.0;

/// How the air answers motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AirModel {
    /// At once, as in steady flow at the momentary incidence: no wake, no apparent mass.
    QuasiSteady,
    /// With the wake's memory and apparent mass, by the doublet lattice.
    Unsteady {
        /// Number of lags of the rational approximation.
        lags: usize,
        /// How doublets are integrated.
        dlm: DlmSettings,
    },
}

impl AirModel {
    /// How doublets are integrated; none where air answers at once.
    pub fn doublets(self) -> Option<DlmSettings> {
        match self {
            Self::QuasiSteady => None,
            Self::Unsteady { dlm, .. } => Some(dlm),
        }
    }
}

impl Default for AirModel {
    fn default() -> Self {
        Self::Unsteady { lags: 7, dlm: DlmSettings::default() }
    }
}

/// The air's answer to a set of motions of one lattice.
#[derive(Debug, Clone)]
pub struct UnsteadyAir {
    /// The motions.
    pub columns: MotionColumns,
    /// Mean chord that reduced frequencies refer to, m.
    pub chord_m: f64,
    /// Pressures at the table's frequencies; none for quasi-steady air.
    pub table: Option<AirTable>,
    /// The rows the poles were chosen for: loads per unit pressure coefficient, rows by boxes.
    pub looked_at: Mat<f64>,
    /// The rational function.
    pub rational: RationalAir,
    /// The rational function for modes that are faster than the table: with the poles of the wake alone it is rougher at
    /// the table's frequencies and tends to apparent mass and damping beyond them, where poles that were chosen for the
    /// table may feed energy into a mode.
    pub beyond: RationalAir,
    /// What [`UnsteadyAir::beyond`] tends to: air without lags.
    pub instant: RationalAir,
    /// The wake's memory alone.
    pub wake: Wake,
    /// What air without memory would give: steady answers to momentary incidences.
    pub quasi_steady: RationalAir,
    lattice: Option<DoubletLattice>,
}

/// What the wake remembers of an incidence: pressures `M(p) w(p)` with `M(p) = sum_j D_j p/(p + g_j)`, the lags of rational functions
/// with the poles of [`UnsteadyAir::beyond`]. A motion has `D_j (w_0 + p w_1)`; in a function of the motion itself, where `p` times a lag
/// is again a lag and a rate, the two are not to be told apart any more.
#[derive(Debug, Clone, Default)]
pub struct Wake {
    /// g, 1/m.
    pub poles_per_m: Vec<f64>,
    /// `D_j w_0`, boxes by motions, one matrix a pole.
    pub still: Vec<Mat<f64>>,
    /// `D_j w_1`, m.
    pub moving: Vec<Mat<f64>>,
}

/// The air that the parts of a rig move through.
pub(crate) struct AirParts<'a> {
    /// Of root pitch, controls and the first modes; of the other modes.
    pub(crate) families: [&'a RationalAir; 2],
    /// How many modes, from the first, are slow.
    pub(crate) slow_modes: usize,
}

impl UnsteadyAir {
    /// Solves the doublet lattice at the table's frequencies and lays a rational function through the pressures.
    ///
    /// `steady` are the pressures of `columns.still` at rest, boxes by columns; `rate` those of `columns.moving`.
    /// `looked_at` are the rows by which the poles are chosen: rows by boxes, loads per unit pressure coefficient. A `shared` lattice
    /// is asked if it is the wing's own.
    ///
    /// # Errors
    /// As [`DoubletLattice::new`] and [`DoubletLattice::at`].
    pub fn new(
        model: AirModel,
        wing: &ElasticWing,
        columns: MotionColumns,
        steady: Mat<f64>,
        rate: Mat<f64>,
        looked_at: Mat<f64>,
        shared: Option<&SharedAir>,
    ) -> Result<Self, AeroError> {
        let chord_m = mean_chord_m(&wing.lattice);
        let quasi_steady = RationalAir::quasi_steady(steady.clone(), rate);
        let AirModel::Unsteady { lags, dlm } = model else {
            let [rational, beyond, instant] = std::array::from_fn(|_| quasi_steady.clone());
            return Ok(Self {
                columns,
                chord_m,
                table: None,
                looked_at,
                rational,
                beyond,
                instant,
                wake: Wake::default(),
                quasi_steady,
                lattice: None,
            });
        };
        let solver = match shared.and_then(|shared| shared.doublets_of(wing, dlm)) {
            Some(doublets) => doublets.clone(),
            None => DoubletLattice::new(&wing.lattice, wing.plane, wing.mach, &dlm)?,
        };
        let kappa: Vec<f64> = REDUCED_FREQUENCIES.iter().map(|k| 2.0 * k / chord_m).collect();
        let parts = AirTable::of_parts(&solver, &columns, &kappa)?;
        let table = AirTable::of_motions(&parts);
        let poles = poles::choose(&table, steady.as_ref(), looked_at.as_ref(), lags);
        let slow_poles: Vec<f64> = SLOW_POLES.iter().map(|k| 2.0 * k / chord_m).collect();
        let every_mode = |_| false;
        let beyond = RationalAir::fit(&table, steady.clone(), &slow_poles, Weighting::RIG, every_mode);
        let instant = beyond.clone().without_lags();
        let lags = |part: &AirTable, steady: &Mat<f64>| {
            RationalAir::fit(part, steady.clone(), &slow_poles, Weighting::RIG, every_mode).lags
        };
        let wake = Wake {
            still: lags(&parts[0], &steady),
            moving: lags(&parts[1], &quasi_steady.rate),
            poles_per_m: slow_poles.clone(),
        };
        let rational = RationalAir::fit(&table, steady, &poles, Weighting::RIG, every_mode);
        Ok(Self {
            columns,
            chord_m,
            table: Some(table),
            looked_at,
            rational,
            beyond,
            instant,
            wake,
            quasi_steady,
            lattice: Some(solver.without_kept_factors()),
        })
    }

    /// How far the rational function is from the doublet lattice at the table's own frequencies, in the rows it was chosen
    /// for; none for quasi-steady air.
    pub fn accuracy(&self) -> Option<Accuracy> {
        let table = self.table.as_ref()?;
        let samples: Vec<(f64, Mat<c64>)> =
            table.omega_over_v_per_m.iter().copied().zip(table.cp.iter().cloned()).collect();
        let rows = self.looked_at.as_ref();
        let largest = accuracy::largest(rows, table.cp.iter());
        Some(Accuracy::at(&self.rational, &samples, rows, largest.as_ref()))
    }

    /// The air at an airspeed, for modes with natural frequencies that ascend.
    pub(crate) fn at_airspeed(&self, omega_rad_s: &[f64], v_m_s: f64) -> AirParts<'_> {
        let highest = self.table.as_ref().and_then(|table| table.omega_over_v_per_m.last());
        let highest_rad_s = highest.map_or(f64::INFINITY, |highest| highest * v_m_s);
        let still = highest_rad_s < std::f64::consts::TAU * FASTEST_MOTION_HZ;
        AirParts {
            families: if still { [&self.instant; 2] } else { [&self.rational, &self.beyond] },
            slow_modes: omega_rad_s.iter().take_while(|omega| **omega <= highest_rad_s).count(),
        }
    }

    /// Pressures of the motions at omega/V (1/m) by the doublet lattice itself, boxes by columns; quasi-steady air gives
    /// its own.
    ///
    /// # Errors
    /// As [`DoubletLattice::at`].
    pub fn exact(&self, omega_over_v: f64) -> Result<Mat<c64>, AeroError> {
        match &self.lattice {
            Some(solver) => table::solve(solver, &self.columns, omega_over_v),
            None => Ok(self.rational.at(c64::new(0.0, omega_over_v))),
        }
    }
}

/// Area of all boxes over the width of all strips, m.
fn mean_chord_m(lattice: &Lattice) -> f64 {
    let area: f64 = lattice.boxes.iter().map(aero::AeroBox::area_m2).sum();
    let strips = |surface: &aero::Surface| {
        let firsts = (0..surface.spanwise).map(|strip| surface.first_box + strip * surface.chordwise);
        firsts.map(|first| lattice.boxes[first].width_m()).sum::<f64>()
    };
    area / lattice.surfaces.iter().map(strips).sum::<f64>()
}

#[cfg(test)]
mod tests;
