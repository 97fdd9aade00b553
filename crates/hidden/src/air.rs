//! The true air: loads of the strips by every motion, from the doublet lattice, as a rational function of its own.
//!
//! Other than the model's: the doublets are integrated with another fit and another kernel, the poles are a fixed row of
//! another number, and the function is laid through the strips' loads.

use crate::strips::{Strips, ZONES};
use aero::{AeroError, DlmSettings, DoubletLattice, KernelIntegral, SpanFit};
use coupling::ElasticWing;
use faer::{Mat, c64};
use maneuver::air::{AirTable, MotionColumns, RationalAir, Weighting};
use rayon::prelude::*;

/// Frequencies of the table, omega c/(2 V) with the mean chord.
const REDUCED_FREQUENCIES: [f64; 11] = [0.015, 0.04, 0.08, 0.13, 0.2, 0.3, 0.45, 0.65, 0.95, 1.35, 1.8];
/// Poles in the same measure: five, in a geometric row.
const POLES: [f64; 5] = [0.035, 0.1, 0.25, 0.6, 1.4];
/// Poles of a fit whose damping and apparent mass fast modes have without lags.
const SLOW_POLES: [f64; 2] = [0.06, 0.35];

/// Number of lags.
pub(crate) const LAGS: usize = POLES.len();

/// See the module. Rows: lifts of the strips, then moments. Columns: modes, pitch, controls, zones (incidence alone).
#[derive(Debug, Clone)]
pub struct StripAir {
    /// With lags.
    pub(crate) rational: RationalAir,
    /// What of its lags is memory of incidences by rates, which counts times p: `D_j w_1`, m.
    pub(crate) moving_lags: Vec<Mat<f64>>,
    /// Without lags, for fast modes.
    pub(crate) instant: RationalAir,
    /// Strip loads by rates, without memory.
    pub(crate) quasi_steady_rate: Mat<f64>,
    /// Steady strip loads by the incidence of each strip.
    pub(crate) by_strip: Mat<f64>,
    /// Steady strip loads of camber and twist.
    pub(crate) camber: Vec<f64>,
    /// Controls.
    pub(crate) controls: usize,
    /// The highest frequency of the table, omega/V.
    pub(crate) highest_per_m: f64,
}

impl StripAir {
    /// Lag of a pole whose rate has a factor. The wake remembers incidences, `D_j (w_0 + p w_1)`, and `p p/(p + g) = p - g p/(p + g)`: of the
    /// second part the lag is smaller where the wake remembers longer, and damping stays.
    pub(crate) fn lag(&self, pole: usize, rate: f64, row: usize, motion: usize) -> f64 {
        let slower = self.rational.poles_per_m[pole] * (1.0 - rate);
        self.rational.lags[pole][(row, motion)] + slower * self.moving_lags[pole][(row, motion)]
    }

    /// Solves the doublet lattice for all motions.
    pub(crate) fn new(
        wing: &ElasticWing,
        strips: &Strips,
        pitch_axis_x_m: f64,
        mean_chord_m: f64,
    ) -> Result<Self, AeroError> {
        let rows = strips.rows(wing);
        let columns = columns(wing, strips, pitch_axis_x_m);
        let steady = &rows * &wing.pressures(columns.still.as_ref());
        let settings = DlmSettings { integral: KernelIntegral::Laschka, fit: SpanFit::Parabolic };
        let solver = DoubletLattice::new(&wing.lattice, wing.plane, wing.mach, &settings)?;
        let per_m = |k: &f64| 2.0 * k / mean_chord_m;
        let complex_rows = Mat::from_fn(rows.nrows(), rows.ncols(), |i, j| c64::from(rows[(i, j)]));
        let one = |k: &f64| -> Result<[Mat<c64>; 2], AeroError> {
            let solved = solver.at(per_m(k))?;
            Ok([&columns.still, &columns.moving].map(|part| {
                let part = Mat::from_fn(part.nrows(), part.ncols(), |i, j| c64::from(part[(i, j)]));
                &complex_rows * &solved.pressures(part.as_ref())
            }))
        };
        let loads: Result<Vec<[Mat<c64>; 2]>, AeroError> = REDUCED_FREQUENCIES.par_iter().map(one).collect();
        let (still, moving) = loads?.into_iter().map(|[still, moving]| (still, moving)).unzip();
        let omega_over_v_per_m: Vec<f64> = REDUCED_FREQUENCIES.iter().map(per_m).collect();
        let parts = [still, moving].map(|cp| AirTable { omega_over_v_per_m: omega_over_v_per_m.clone(), cp });
        let table = AirTable::of_motions(&parts);
        let poles = POLES.each_ref().map(per_m);
        let slow = SLOW_POLES.each_ref().map(per_m);
        let unit = Mat::from_fn(wing.lattice.len(), strips.len(), |j, strip| {
            f64::from(u8::from(strips.boxes[strip].contains(&j)))
        });
        let camber = Mat::from_fn(wing.lattice.len(), 1, |j, _| wing.pressures_of_camber()[j]);
        let rate = &rows * &wing.pressures(columns.moving.as_ref());
        Ok(Self {
            rational: RationalAir::fit(&table, steady.clone(), &poles, Weighting::RIG, |_| false),
            moving_lags: RationalAir::fit(&parts[1], rate.clone(), &poles, Weighting::RIG, |_| false).lags,
            instant: RationalAir::fit(&table, steady, &slow, Weighting::RIG, |_| false).without_lags(),
            quasi_steady_rate: rate,
            by_strip: &rows * &wing.pressures(unit.as_ref()),
            camber: (&rows * &camber).col_as_slice(0).to_vec(),
            controls: wing.controls.len(),
            highest_per_m: per_m(&REDUCED_FREQUENCIES[REDUCED_FREQUENCIES.len() - 1]),
        })
    }
}

/// Incidences of the modes, of root pitch, of the controls and of the zones.
fn columns(wing: &ElasticWing, strips: &Strips, pitch_axis_x_m: f64) -> MotionColumns {
    let (boxes, modes) = (wing.lattice.len(), strips.height.ncols());
    let controls = wing.controls.len();
    let mut still = Mat::zeros(boxes, modes + 1 + controls + ZONES);
    let mut moving = Mat::zeros(boxes, still.ncols());
    for (strip, members) in strips.boxes.iter().enumerate() {
        for &j in members {
            let aft_m = wing.lattice.boxes[j].three_quarter_point().x - strips.x_quarter_m[strip];
            for mode in 0..modes {
                let (height, twist) = (strips.height[(strip, mode)], strips.twist[(strip, mode)]);
                still[(j, mode)] = twist;
                moving[(j, mode)] = aft_m * twist - height;
            }
            still[(j, modes + 1 + controls + strips.zone[strip])] = 1.0;
        }
    }
    for (j, panel) in wing.lattice.boxes.iter().enumerate() {
        still[(j, modes)] = panel.normal().z;
        moving[(j, modes)] = (panel.three_quarter_point().x - pitch_axis_x_m) * panel.normal().z;
    }
    for (c, control) in wing.controls.iter().enumerate() {
        let (slope, lever) = (control.column(boxes), control.rate_column_m(boxes));
        for j in 0..boxes {
            still[(j, modes + 1 + c)] = slope[j];
            moving[(j, modes + 1 + c)] = lever[j];
        }
    }
    MotionColumns { still, moving }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Memory `p/(p + g) (w_0 D + p w_1 D)` whose rate g has a factor.
    #[test]
    fn a_longer_wake_remembers_incidences_and_takes_no_damping() {
        let one = |value: f64| Mat::from_fn(1, 1, |_, _| value);
        let (pole, still, moving) = (0.7, 1.3, -0.4);
        let lags = vec![one(still - pole * moving)];
        let (none, steady) = (Mat::zeros(1, 1), one(2.0));
        let rational =
            RationalAir { poles_per_m: vec![pole], steady, rate: none.clone(), second: none.clone(), lags };
        let air = StripAir {
            instant: rational.clone(),
            rational,
            moving_lags: vec![one(moving)],
            quasi_steady_rate: none.clone(),
            by_strip: none,
            camber: Vec::new(),
            controls: 0,
            highest_per_m: 1.0,
        };
        for (rate, kappa) in [(0.5, 0.2), (0.25, 1.0), (2.0, 0.6)] {
            let p = c64::new(0.0, kappa);
            let lag = |rate: f64| p / (p + rate * pole);
            let found = lag(rate) * air.lag(0, rate, 0, 0) - lag(1.0) * air.lag(0, 1.0, 0, 0);
            let law = (lag(rate) - lag(1.0)) * (p * moving + still);
            assert!((found - law).norm() < 1e-12, "{rate} {kappa}: {found} for {law}");
        }
    }
}
