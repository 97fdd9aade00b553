//! Generalised air forces over frequency: `f = q Q(omega/V) x`, per unit dynamic pressure q and coordinate x.
//!
//! Frequencies are omega/V in 1/m; the reduced frequency of a reference chord is k = (omega/V) c/2.

use super::FlutterError;
use super::spline::MatrixSpline;
use faer::{Mat, c64};

/// Im Q/kappa at rest is taken at this share of the range's largest frequency.
const NEARLY_AT_REST: f64 = 1e-6;

/// Forces at a frequency kappa = omega/V, split as the p-k equation needs them.
#[derive(Debug, Clone)]
pub struct SplitForces {
    /// Re Q.
    pub real: Mat<f64>,
    /// Im Q/kappa, m.
    pub damping: Mat<f64>,
    /// Whether kappa is beyond the range, so that both are those of its end.
    pub beyond: bool,
}

/// Forces on n generalised coordinates when they oscillate.
pub trait GeneralisedForces {
    /// Number of coordinates, n.
    fn size(&self) -> usize;

    /// Least and largest omega/V that [`GeneralisedForces::at`] takes at every airspeed, 1/m.
    fn range(&self) -> (f64, f64);

    /// Q, n by n: force on coordinate i per unit dynamic pressure and amplitude of coordinate j, time as
    /// exp(+i omega t). The airspeed matters where the corrections depend on it.
    ///
    /// # Errors
    /// If the frequency is outside of the range.
    fn at(&self, omega_over_v: f64, v_m_s: f64) -> Result<Mat<c64>, FlutterError>;

    /// Forces at any frequency, split for p-k; beyond the range Re Q and Im Q/kappa of its end are held.
    ///
    /// So does Nastran where a deck has one frequency. With several its spline goes on along a straight line, on which air soon
    /// drives what it damps at the table's end: where the table ends at k = 10, MSC's print of mAEWing2 has g of a mode at 128 Hz from
    /// -2.7e-4 at k = 12 to 2.3e-4 at 47, and NASTRAN-95 has .12 for the Goland wing at 10 m/s with k up to .3, but -.008 with k up to 80.
    /// What is held leaves out that apparent mass grows with the square of the frequency (5 % of the Goland wing's frequencies), and what
    /// is beyond the range may flutter late or not at all: a light section that does at 21 m/s does at 31 with k up to half of flutter's.
    ///
    /// # Errors
    /// As [`GeneralisedForces::at`] within the range.
    fn split(&self, omega_over_v: f64, v_m_s: f64) -> Result<SplitForces, FlutterError> {
        let (_, high) = self.range();
        let place = omega_over_v.min(high);
        let real_at = if place < NEARLY_AT_REST * high { 0.0 } else { place };
        let damping_at = place.max(NEARLY_AT_REST * high);
        let q = self.at(real_at, v_m_s)?;
        let slow = if damping_at == real_at { q.clone() } else { self.at(damping_at, v_m_s)? };
        let n = self.size();
        Ok(SplitForces {
            real: Mat::from_fn(n, n, |i, j| q[(i, j)].re),
            damping: Mat::from_fn(n, n, |i, j| slow[(i, j)].im / damping_at),
            beyond: omega_over_v > high,
        })
    }
}

/// A table of generalised forces, with a cubic spline in omega/V between its rows.
#[derive(Debug, Clone)]
pub struct GafTable {
    spline: MatrixSpline,
}

impl GafTable {
    /// From rising frequencies omega/V (1/m) and one matrix Q each. With zero as first frequency the table serves
    /// divergence too.
    ///
    /// # Errors
    /// If the table is empty, its frequencies do not rise or are negative, or a matrix is not square or of another size.
    pub fn new(omega_over_v: Vec<f64>, q: Vec<Mat<c64>>) -> Result<Self, FlutterError> {
        if let Some(matrix) = q.iter().find(|matrix| matrix.nrows() != matrix.ncols()) {
            let (rows, columns) = (matrix.nrows(), matrix.ncols());
            return Err(FlutterError::Size { what: "a matrix of the table", rows, columns, expected: rows });
        }
        if let Some(value) = omega_over_v.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
            let expected = "a frequency of zero or more, in 1/m";
            return Err(FlutterError::Number { what: "omega/V", value: *value, expected });
        }
        Ok(Self { spline: MatrixSpline::new(omega_over_v, q)? })
    }
}

impl GeneralisedForces for GafTable {
    fn size(&self) -> usize {
        self.spline.first().nrows()
    }

    fn range(&self) -> (f64, f64) {
        self.spline.range()
    }

    fn at(&self, omega_over_v: f64, _v_m_s: f64) -> Result<Mat<c64>, FlutterError> {
        let (low, high) = self.range();
        self.spline.at(omega_over_v).ok_or(FlutterError::OutsideTable { asked: omega_over_v, low, high })
    }
}

/// Forces given by a formula.
pub struct FormulaForces<F> {
    /// Number of coordinates.
    pub size: usize,
    /// Least and largest omega/V of the formula, 1/m.
    pub range: (f64, f64),
    /// Q at omega/V.
    pub formula: F,
}

impl<F: Fn(f64) -> Mat<c64>> GeneralisedForces for FormulaForces<F> {
    fn size(&self) -> usize {
        self.size
    }

    fn range(&self) -> (f64, f64) {
        self.range
    }

    fn at(&self, omega_over_v: f64, _v_m_s: f64) -> Result<Mat<c64>, FlutterError> {
        let (low, high) = self.range;
        if (low..=high).contains(&omega_over_v) {
            Ok((self.formula)(omega_over_v))
        } else {
            Err(FlutterError::OutsideTable { asked: omega_over_v, low, high })
        }
    }
}
