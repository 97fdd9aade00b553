//! The unsteady air of the free aircraft: pressures of its rigid motions, elastic modes, control surfaces and gusts by the
//! doublet lattice on the whole explicit aircraft, and a rational function of p = s/V through them.
//!
//! ```text
//! cp(p) = c_0 + c_1 p + c_2 p² + sum_j d_j p/(p + g_j)       (modes and controls: incidence (w_0 + p w_1) x)
//! cp(p) = c_0 + c_1 p +          sum_j d_j p/(p + g_j)       (alpha, beta, rates, gust: x is an incidence already)
//! ```
//! A rigid motion enters by its incidence (angle of attack, sideslip, rates over V), which is finite at p = 0; its apparent
//! mass is `c_1`, and a term with p² would be the derivative of an acceleration. `c_0` is the vortex lattice's, so steady
//! flight in this air is that of the trim. Poles are common to all, in a geometric row that needs no search.
//!
//! What limits the fit is the way from the wing to the tail: the wake of the wing arrives 1.3 m later, and real poles
//! imitate a delay only so far. The frequencies of the table and the fit's weights favour k < 0.4 (14 Hz at 25.7 m/s), where
//! maneuvers are; there errors are below 3 % of an entry's largest modulus for modes and controls and 6 % for rigid motions
//! (the pitching moment of the tail), below k = 0.15 within 1 and 2 %. Beyond k = 0.8 the wings' wake on the tail is rough.
//!
//! A gust, vertical or from the side, is known at stations along x, `gust_x_m`, and linear between them: constant gusts are exact, a wave of length L is
//! met with an error of 1/8 (2 pi d/L)², d = 0.1 m the distance of stations.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::flight::gust::GustAxis;
use crate::flight::modes::FreeModes;
use crate::flight::rows::momentum;
use crate::flight::solved_air::SolvedAir;
use aero::{DlmSettings, DoubletLattice, incidence};
use coupling::Keep;
use faer::{Mat, MatRef};
use maneuver::air::{AirTable, MotionColumns, RationalAir, Weighting, accuracy};
use nalgebra::{Point3, Vector3};
use std::sync::{Arc, OnceLock};
use structure::MassProperties;

/// Reduced frequencies k = omega c/(2 V), c the wing's mean chord, at which the doublet lattice is solved.
pub const REDUCED_FREQUENCIES: [f64; 8] = [0.02, 0.05, 0.1, 0.17, 0.26, 0.4, 0.8, 2.0];
/// Number of lags and the reduced frequencies of their first and last pole, in geometric steps between.
const LAGS: usize = 10;
const POLES: [f64; 2] = [0.05, 1.0];
/// Name of modes and pressures where they are kept.
const KEPT: &str = "air";
/// Distance of the stations at which a gust is known, m.
const GUST_STEP_M: f64 = 0.1;
/// Rigid motions: angle of attack, sideslip, and rotation rates over V (1/m) about x, y and z through the centre of
/// gravity (right-hand rule in x aft, y right, z up).
pub(crate) const RIGID: usize = 5;

/// Where the motions stand among the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AirColumns {
    /// Elastic modes.
    pub modes: usize,
    /// Control surfaces.
    pub controls: usize,
    /// Stations of the gust; each has a column a vertical gust and one a lateral one.
    pub gusts: usize,
}

impl AirColumns {
    /// Column of an elastic mode.
    pub fn mode(self, mode: usize) -> usize {
        RIGID + mode
    }

    /// Column of a control surface.
    pub fn control(self, control: usize) -> usize {
        RIGID + self.modes + control
    }

    /// Column of a station of a vertical gust, upwards.
    pub fn gust(self, station: usize) -> usize {
        self.gust_along(GustAxis::Vertical, station)
    }

    /// Column of a station of a gust.
    pub fn gust_along(self, axis: GustAxis, station: usize) -> usize {
        let before = match axis {
            GustAxis::Vertical => 0,
            GustAxis::Lateral => self.gusts,
        };
        self.control(self.controls) + before + station
    }

    /// All columns.
    pub fn count(self) -> usize {
        self.gust_along(GustAxis::Lateral, self.gusts)
    }

    /// True if a column is an incidence, without a p² of its own.
    pub(crate) fn is_incidence(self, column: usize) -> bool {
        column < RIGID || column >= self.gust(0)
    }
}

/// See the module.
#[derive(Debug, Clone)]
pub struct FlightAir {
    /// Modes of the free aircraft.
    pub modes: FreeModes,
    /// Where the motions stand.
    pub columns: AirColumns,
    /// Stations of the gust, ascending, m.
    pub gust_x_m: Vec<f64>,
    /// Mean chord that reduced frequencies refer to, m.
    pub chord_m: f64,
    /// Pressures at the table's frequencies, boxes by columns.
    pub table: AirTable,
    /// The rational function, boxes by columns.
    pub rational: RationalAir,
    /// Incidences, boxes by columns.
    pub incidence: MotionColumns,
    /// What accelerates the masses of an aircraft of these totals, once it is asked for.
    momentum: OnceLock<(MassProperties, Arc<Mat<f64>>)>,
}

impl FlightAir {
    /// Solves the doublet lattice of an aircraft and lays the rational function through it.
    ///
    /// # Errors
    /// If the modes do not converge or the lattice cannot be solved.
    pub fn new(aircraft: &Aircraft) -> Result<Self, AircraftError> {
        Self::kept(aircraft, &())
    }

    /// The same; modes and pressures are taken from where they are kept, or found and kept there.
    ///
    /// # Errors
    /// If the modes do not converge or the lattice cannot be solved.
    pub fn kept(aircraft: &Aircraft, keep: &dyn Keep) -> Result<Self, AircraftError> {
        let wing = &aircraft.flow;
        let inputs = aircraft.inputs();
        let kept = keep.get(KEPT, &inputs).and_then(SolvedAir::of_matrices);
        let modes = kept.as_ref().map_or_else(|| FreeModes::new(aircraft), |kept| Ok(kept.modes.clone()))?;
        let chord_m = mean_chord_m(aircraft);
        let gust_x_m = gust_stations(aircraft);
        let columns =
            AirColumns { modes: modes.elastic(), controls: wing.controls.len(), gusts: gust_x_m.len() };
        let incidence = motions(aircraft, &modes, columns, &gust_x_m);
        let kappa = REDUCED_FREQUENCIES.map(|k| 2.0 * k / chord_m);
        let solved = if let Some(kept) = kept {
            kept
        } else {
            let table = AirTable::new(&lattice(aircraft)?, &incidence, &kappa)?;
            let steady = wing.pressures(incidence.still.as_ref());
            let solved = SolvedAir { modes: modes.clone(), steady, cp: table.cp };
            keep.put(KEPT, &inputs, &solved.matrices());
            solved
        };
        let table = AirTable { omega_over_v_per_m: kappa.to_vec(), cp: solved.cp };
        let poles = poles_per_m(chord_m);
        let is_incidence = |column| columns.is_incidence(column);
        let rational = RationalAir::fit(&table, solved.steady, &poles, Weighting::FLIGHT, is_incidence);
        Ok(Self { modes, columns, gust_x_m, chord_m, table, rational, incidence, momentum: OnceLock::new() })
    }

    /// The [`momentum`] of the aircraft of this air, found once: airspeed, altitude and corrections do not change it.
    pub(crate) fn momentum(&self, aircraft: &Aircraft) -> Arc<Mat<f64>> {
        let of = || Arc::new(momentum(aircraft, &self.modes));
        let (mass, known) = self.momentum.get_or_init(|| (aircraft.mass.clone(), of()));
        if *mass == aircraft.mass { known.clone() } else { of() }
    }

    /// Highest frequency of the table at an airspeed, Hz.
    pub fn highest_hz(&self, v_m_s: f64) -> f64 {
        let k = REDUCED_FREQUENCIES[REDUCED_FREQUENCIES.len() - 1];
        k * v_m_s / (std::f64::consts::PI * self.chord_m)
    }

    /// A sentence if modes are faster than the table at this airspeed.
    pub fn warning(&self, v_m_s: f64) -> Option<String> {
        let fastest = self.modes.frequencies_hz().last().copied().unwrap_or(0.0);
        let highest = self.highest_hz(v_m_s);
        (fastest > highest).then(|| {
            format!(
                "at {v_m_s} m/s the doublet lattice's table ends at {highest:.0} Hz, below the fastest mode ({fastest:.0} Hz)"
            )
        })
    }

    /// Errors of the rational function against the doublet lattice at k (not only the table's), over each entry's
    /// largest modulus: generalised forces (six rigid ones, then the modes) by the columns. Entries that are nothing beside
    /// the others of their row and column count as zero.
    ///
    /// # Errors
    /// If the lattice cannot be solved.
    pub fn error_at(&self, aircraft: &Aircraft, k: f64) -> Result<Mat<f64>, AircraftError> {
        let kappa = 2.0 * k / self.chord_m;
        let exact = lattice(aircraft)?.at(kappa)?.pressures(self.incidence.incidence(kappa).as_ref());
        let rows = self.modes.generalised_rows(aircraft);
        let rows = aircraft.flow.integration.rows_by_pressure(rows.as_ref());
        let largest = significant(&accuracy::largest(rows.as_ref(), self.table.cp.iter()));
        let sample = [(kappa, exact)];
        Ok(accuracy::Accuracy::at(&self.rational, &sample, rows.as_ref(), largest.as_ref()).error)
    }

    /// The same air for an aircraft that does not bend.
    #[must_use]
    pub fn rigid(&self) -> Self {
        let (from, first) = (self.columns, FreeModes::FIRST_ELASTIC);
        let columns = AirColumns { modes: 0, ..from };
        let kept: Vec<usize> = (0..RIGID).chain(from.control(0)..from.count()).collect();
        let pick = |of: MatRef<'_, f64>| Mat::from_fn(of.nrows(), kept.len(), |j, i| of[(j, kept[i])]);
        let incidence = MotionColumns {
            still: pick(self.incidence.still.as_ref()),
            moving: pick(self.incidence.moving.as_ref()),
        };
        let rational = RationalAir {
            poles_per_m: self.rational.poles_per_m.clone(),
            steady: pick(self.steady()),
            rate: pick(self.rational.rate.as_ref()),
            second: pick(self.rational.second.as_ref()),
            lags: self.rational.lags.iter().map(|lag| pick(lag.as_ref())).collect(),
        };
        let modes = FreeModes {
            omega_rad_s: self.modes.omega_rad_s[..first].to_vec(),
            shapes: self.modes.shapes.as_ref().subcols(0, first).to_owned(),
            boxes: self.modes.boxes.as_ref().subcols(0, first).to_owned(),
        };
        Self { modes, columns, rational, incidence, momentum: OnceLock::new(), ..self.clone() }
    }

    /// The same air for an aircraft that does not bend, answering at once as in steady flow: what textbooks' closed
    /// forms of the short period and the phugoid assume.
    #[must_use]
    pub fn rigid_and_quasi_steady(&self, aircraft: &Aircraft) -> Self {
        let rigid = self.rigid();
        let rate = aircraft.flow.pressures(rigid.incidence.moving.as_ref());
        let rational = RationalAir::quasi_steady(rigid.steady().to_owned(), rate);
        Self { rational, ..rigid }
    }

    /// Steady pressures per unit of each column, boxes by columns.
    pub fn steady(&self) -> MatRef<'_, f64> {
        self.rational.steady.as_ref()
    }
}

/// The doublets of all boxes.
fn lattice(aircraft: &Aircraft) -> Result<DoubletLattice, AircraftError> {
    let (wing, settings) = (&aircraft.flow, DlmSettings::default());
    match aircraft.shared.as_ref().and_then(|shared| shared.doublets_of(wing, settings)) {
        Some(doublets) => Ok(doublets.clone()),
        None => Ok(DoubletLattice::new(&wing.lattice, wing.plane, wing.mach, &settings)?),
    }
}

/// An entry less than this beside the largest of its row and column (both scaled to one) is left out of account: zero by
/// symmetry, or of no consequence.
const INSIGNIFICANT: f64 = 0.01;

/// The entries that count, the others zero.
fn significant(largest: &Mat<f64>) -> Mat<f64> {
    let (rows, columns) = (largest.nrows(), largest.ncols());
    let mut scaled = largest.clone();
    for _ in 0..SCALINGS {
        for i in 0..rows {
            let most = (0..columns).map(|j| scaled[(i, j)]).fold(f64::MIN_POSITIVE, f64::max);
            (0..columns).for_each(|j| scaled[(i, j)] /= most);
        }
        for j in 0..columns {
            let most = (0..rows).map(|i| scaled[(i, j)]).fold(f64::MIN_POSITIVE, f64::max);
            (0..rows).for_each(|i| scaled[(i, j)] /= most);
        }
    }
    Mat::from_fn(rows, columns, |i, j| if scaled[(i, j)] > INSIGNIFICANT { largest[(i, j)] } else { 0.0 })
}

/// Rounds of scaling rows and columns to one.
const SCALINGS: usize = 4;

/// The poles, 1/m.
fn poles_per_m(chord_m: f64) -> Vec<f64> {
    let [first, last] = POLES;
    let step = |i: usize| i as f64 / (LAGS - 1) as f64;
    (0..LAGS).map(|i| 2.0 / chord_m * first * (last / first).powf(step(i))).collect()
}

/// Area over span of a wing, m.
fn mean_chord_m(aircraft: &Aircraft) -> f64 {
    let lattice = &aircraft.flow.lattice;
    let own = &aircraft.right.boxes;
    let area: f64 = own.iter().map(|&j| lattice.boxes[j].area_m2()).sum();
    let firsts =
        lattice.surfaces.iter().filter(|surface| own.contains(&surface.first_box)).flat_map(|surface| {
            (0..surface.spanwise).map(|strip| surface.first_box + strip * surface.chordwise)
        });
    area / firsts.map(|first| lattice.boxes[first].width_m()).sum::<f64>()
}

/// From the foremost to the rearmost three-quarter point.
fn gust_stations(aircraft: &Aircraft) -> Vec<f64> {
    let points = || aircraft.flow.lattice.boxes.iter().map(|panel| panel.three_quarter_point().x);
    let (first, last) = (points().fold(f64::INFINITY, f64::min), points().fold(f64::NEG_INFINITY, f64::max));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a length over a length")]
    let steps = ((last - first) / GUST_STEP_M).ceil().max(1.0) as usize;
    (0..=steps).map(|i| first + (last - first) * i as f64 / steps as f64).collect()
}

/// Incidences of all columns.
fn motions(aircraft: &Aircraft, modes: &FreeModes, columns: AirColumns, gust_x_m: &[f64]) -> MotionColumns {
    let lattice = &aircraft.flow.lattice;
    let boxes = lattice.len();
    let mut still = Mat::zeros(boxes, columns.count());
    let mut moving = Mat::zeros(boxes, columns.count());
    let about = Point3::from(aircraft.mass.centre.coords);
    let mut rigid = vec![incidence::angle_of_attack(lattice), incidence::sideslip(lattice)];
    rigid.extend(
        [Vector3::x(), Vector3::y(), Vector3::z()]
            .map(|axis| incidence::rotation_rate(lattice, &axis, &about, 1.0)),
    );
    for (column, w) in rigid.iter().enumerate() {
        for j in 0..boxes {
            still[(j, column)] = w[j];
        }
    }
    for mode in 0..columns.modes {
        let (from, column) = (FreeModes::FIRST_ELASTIC + mode, columns.mode(mode));
        for (j, panel) in lattice.boxes.iter().enumerate() {
            // theta + (theta' (x_34 - x_mid) - h')/V
            still[(j, column)] = modes.boxes[(2 * j + 1, from)];
            moving[(j, column)] =
                0.25 * panel.chord_m() * modes.boxes[(2 * j + 1, from)] - modes.boxes[(2 * j, from)];
        }
    }
    for (c, control) in aircraft.flow.controls.iter().enumerate() {
        let (slope, lever) = (control.column(boxes), control.rate_column_m(boxes));
        for j in 0..boxes {
            still[(j, columns.control(c))] = slope[j];
            moving[(j, columns.control(c))] = lever[j];
        }
    }
    let from_right = incidence::sideslip(lattice);
    for (j, panel) in lattice.boxes.iter().enumerate() {
        let (before, share) = between(gust_x_m, panel.three_quarter_point().x);
        // upwards, and from the right
        for (axis, incidence) in [(GustAxis::Vertical, panel.normal().z), (GustAxis::Lateral, from_right[j])]
        {
            still[(j, columns.gust_along(axis, before))] = (1.0 - share) * incidence;
            still[(j, columns.gust_along(axis, before + 1))] = share * incidence;
        }
    }
    MotionColumns { still, moving }
}

/// The station before x and the share of the one after it.
fn between(stations: &[f64], x_m: f64) -> (usize, f64) {
    let before = stations.partition_point(|station| *station <= x_m).clamp(1, stations.len() - 1) - 1;
    (before, (x_m - stations[before]) / (stations[before + 1] - stations[before]))
}

#[cfg(test)]
mod tests;
