//! What a gust does to boxes, and tables of answers over frequency.

use crate::flutter::{FlutterError, MatrixSpline};
use aero::Lattice;
use faer::{Mat, c64};

/// Incidence of a gust of amplitude one (w/V = 1 rad) whose phase is taken at `x_0_m`, at the boxes' three-quarter
/// points: boxes by 1, at omega/V in 1/m.
pub fn gust_incidence(lattice: &Lattice, x_0_m: f64, omega_over_v: f64) -> Mat<c64> {
    gust_incidence_along(lattice, [0.0, 0.0, 1.0], x_0_m, omega_over_v)
}

/// The same of a gust whose air moves along a direction.
pub fn gust_incidence_along(
    lattice: &Lattice,
    direction: [f64; 3],
    x_0_m: f64,
    omega_over_v: f64,
) -> Mat<c64> {
    Mat::from_fn(lattice.len(), 1, |j, _| {
        let panel = &lattice.boxes[j];
        let phase = omega_over_v * (panel.three_quarter_point().x - x_0_m);
        let normal = panel.normal();
        let across = (0..3).map(|axis| normal[axis] * direction[axis]).sum::<f64>();
        c64::new(phase.cos(), -phase.sin()) * across
    })
}

/// Answers to oscillation at a table of frequencies, with cubic splines between.
///
/// The phase is taken at a point near the middle of what answers, so that the entries turn slowly with frequency;
/// [`FrequencyTable::at`] gives it at any other point.
#[derive(Debug, Clone)]
pub struct FrequencyTable {
    spline: MatrixSpline,
    x_0_m: f64,
}

impl FrequencyTable {
    /// From rising frequencies omega/V (1/m) and columns of answers, the gust's phase taken at `x_0_m`.
    ///
    /// # Errors
    /// If there is none, frequencies do not rise, or sizes differ.
    pub fn new(omega_over_v: Vec<f64>, answers: Vec<Mat<c64>>, x_0_m: f64) -> Result<Self, FlutterError> {
        Ok(Self { spline: MatrixSpline::new(omega_over_v, answers)?, x_0_m })
    }

    /// Least and largest frequency, 1/m.
    pub fn range(&self) -> (f64, f64) {
        self.spline.range()
    }

    /// The answers to a gust of amplitude one whose phase is taken at `from_x_m`.
    ///
    /// # Errors
    /// If the frequency is outside of the table.
    pub fn at(&self, omega_over_v: f64, from_x_m: f64) -> Result<Mat<c64>, FlutterError> {
        let (low, high) = self.range();
        let outside = FlutterError::OutsideTable { asked: omega_over_v, low, high };
        let answers = self.spline.at(omega_over_v).ok_or(outside)?;
        let phase = omega_over_v * (self.x_0_m - from_x_m);
        Ok(answers * faer::Scale(c64::new(phase.cos(), -phase.sin())))
    }
}

#[cfg(test)]
mod tests;
