//! Asymmetry of a wing's displacement field: R = integral of w over the left half / integral over the right half, Eq. 2 of paper 2
//! of "Wind-Tunnel Testing and Modeling of a Micro Air Vehicle with Flexible Wings", which on an equally spaced grid is
//! the ratio of the two sums (Eq. 3 of paper 2). Left is y < 0. A rigid wing should give 1; by how much it does not is the bias of
//! the instrument, which no noise of single points explains, so it is reported beside the noise and not removed.

mod grid;

use std::path::Path;

use nastran::{InputError, Table};
use schemars::JsonSchema;
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal};

use grid::Grid;

pub use grid::Displacement;

/// The mean ratio of the paper's rigid wing.
pub const PUBLISHED_RIGID_RATIO: f64 = 0.956;

/// Resolution of the paper's image correlation, mm: its estimate of one point's error.
pub const PUBLISHED_RESOLUTION_MM: f64 = 0.05;

/// What the ratio is to be computed with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Where the plane of symmetry is, mm.
    pub centre_y_mm: f64,
    /// Standard deviation of the error of one point, mm; errors of different points are taken as independent.
    pub sigma_w_mm: f64,
    /// Of the interval, between 0 and 1.
    pub confidence: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { centre_y_mm: 0.0, sigma_w_mm: PUBLISHED_RESOLUTION_MM, confidence: 0.95 }
    }
}

/// The ratio of a displacement field.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Asymmetry {
    /// R, left over right.
    pub ratio: f64,
    /// Its standard deviation from the noise of the points, to first order.
    pub sigma: f64,
    /// Fieller's interval at the chosen confidence; `None` if the right half's integral is not told from zero, when
    /// the ratio may be anything.
    pub interval: Option<(f64, f64)>,
    /// Volume below the left half, mm^3.
    pub left_mm3: f64,
    /// Volume below the right half, mm^3.
    pub right_mm3: f64,
    /// Points of one half that have their mirror image in the other.
    pub pairs: usize,
    /// Points left out because their mirror image is not in the data.
    pub unpaired: usize,
    /// True if the grid is equally spaced, where Eq. 3 of paper 2 is Eq. 2.
    pub equally_spaced: bool,
}

/// Ratios of a rigid wing in the same set-up: what an asymmetry must exceed to be one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidWing {
    /// Mean ratio.
    pub mean: f64,
    /// Standard deviation of one test about the mean; `None` with fewer than two tests.
    pub scatter: Option<f64>,
}

impl RigidWing {
    /// The paper's, of which only the mean is printed.
    pub const PUBLISHED: Self = Self { mean: PUBLISHED_RIGID_RATIO, scatter: None };

    /// From the ratios of several tests.
    ///
    /// # Errors
    /// If there is none, or one is not finite.
    pub fn from_ratios(ratios: &[f64]) -> Result<Self, InputError> {
        if ratios.is_empty() {
            return Err(InputError::general("no ratio of a rigid wing is given; expected one at least"));
        }
        if let Some(index) = ratios.iter().position(|ratio| !ratio.is_finite()) {
            let message = format!("ratio {} of the rigid wing is not a finite number", index + 1);
            return Err(InputError::general(message));
        }
        let count = ratios.len() as f64;
        let mean = ratios.iter().sum::<f64>() / count;
        let squares: f64 = ratios.iter().map(|ratio| (ratio - mean).powi(2)).sum();
        let scatter = (ratios.len() > 1).then(|| (squares / (count - 1.0)).sqrt());
        Ok(Self { mean, scatter })
    }

    /// 1 - mean: by how much a wing without asymmetry is reported to have one.
    pub fn bias(&self) -> f64 {
        1.0 - self.mean
    }

    /// True if the field's distance from 1 is more than the bias, either way, plus twice the standard deviation of
    /// noise and scatter together.
    pub fn is_exceeded_by(&self, field: &Asymmetry) -> bool {
        let sigma = field.sigma.hypot(self.scatter.unwrap_or(0.0));
        (field.ratio - 1.0).abs() > self.bias().abs() + 2.0 * sigma
    }
}

/// Reads a field from a CSV file with the columns `x_mm`, `y_mm` (to the right) and `w_mm`; others are passed over.
///
/// # Errors
/// If the file cannot be read, or a cell is not a number.
pub fn read_displacements(path: &Path) -> Result<Vec<Displacement>, InputError> {
    displacements(&Table::read(path)?)
}

/// The same from a table in memory.
///
/// # Errors
/// If a column is missing, or a cell is not a number.
pub fn displacements(table: &Table) -> Result<Vec<Displacement>, InputError> {
    table.require(&["x_mm", "y_mm", "w_mm"])?;
    (0..table.len())
        .map(|row| {
            let number = |column| table.number(row, column);
            Ok(Displacement { x_mm: number("x_mm")?, y_mm: number("y_mm")?, w_mm: number("w_mm")? })
        })
        .collect()
}

/// The ratio R of a field on a rectangular grid, which may be unequally spaced and may have holes: where a point or its
/// mirror image is missing, both are left out. Points on the plane of symmetry count half to either side.
///
/// # Errors
/// If the settings are not finite or out of bounds, the points are no grid, one occurs twice, there is no pair, or
/// the right half's integral is exactly zero.
pub fn asymmetry(field: &[Displacement], settings: &Settings) -> Result<Asymmetry, InputError> {
    check(settings)?;
    let grid = Grid::new(field, settings.centre_y_mm)?;
    let mut sums = Sums::default();
    let (mut pairs, mut unpaired) = (0, 0);
    for (&(i, j), point) in &grid.points {
        let mirrored = grid.mirror[j];
        if mirrored == Some(j) {
            sums.add(0.5 * grid.area(i, j), 0.5 * grid.area(i, j), point.w_mm);
        } else if let Some(other) = mirrored.filter(|&other| grid.points.contains_key(&(i, other))) {
            let left = j < other;
            // one area for both, so that an image a hair off its place does not tilt the ratio
            let area = 0.5 * (grid.area(i, j) + grid.area(i, other));
            sums.add(if left { area } else { 0.0 }, if left { 0.0 } else { area }, point.w_mm);
            pairs += usize::from(left);
        } else {
            unpaired += 1;
        }
    }
    if pairs == 0 {
        return Err(InputError::general("no point of the left half has a mirror image in the right half")
            .with_help("left is y < 0; check where the plane of symmetry is"));
    }
    if sums.right == 0.0 {
        return Err(InputError::general(
            "the displacement of the right half adds up to zero, so there is no ratio",
        ));
    }
    let ratio = sums.left / sums.right;
    let sigma = settings.sigma_w_mm * sums.variance_of(ratio).sqrt() / sums.right.abs();
    let quantile = Normal::standard().inverse_cdf(0.5 + 0.5 * settings.confidence);
    Ok(Asymmetry {
        ratio,
        sigma,
        interval: sums.fieller(quantile * settings.sigma_w_mm),
        left_mm3: sums.left,
        right_mm3: sums.right,
        pairs,
        unpaired,
        equally_spaced: grid.equally_spaced(),
    })
}

fn check(settings: &Settings) -> Result<(), InputError> {
    let Settings { centre_y_mm, sigma_w_mm, confidence } = *settings;
    if !centre_y_mm.is_finite() || !sigma_w_mm.is_finite() || sigma_w_mm < 0.0 {
        let message = format!(
            "plane of symmetry {centre_y_mm} mm, error of a point {sigma_w_mm} mm; expected finite numbers, the error \
             not negative"
        );
        return Err(InputError::general(message));
    }
    if !(confidence > 0.0 && confidence < 1.0) {
        let message = format!("a confidence of {confidence}; expected one between 0 and 1, such as 0.95");
        return Err(InputError::general(message));
    }
    Ok(())
}

/// Sums of a w on both sides, and of a^2, from which the noise follows.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    left: f64,
    right: f64,
    left_squares: f64,
    right_squares: f64,
    products: f64,
}

impl Sums {
    fn add(&mut self, left: f64, right: f64, w_mm: f64) {
        self.left += left * w_mm;
        self.right += right * w_mm;
        self.left_squares += left * left;
        self.right_squares += right * right;
        self.products += left * right;
    }

    /// Variance of left - ratio right, for unit noise of a point.
    fn variance_of(&self, ratio: f64) -> f64 {
        self.left_squares - 2.0 * ratio * self.products + ratio * ratio * self.right_squares
    }

    /// The ratios r with (left - r right)^2 <= z^2 variance(r) (Fieller 1954), if they are an interval.
    fn fieller(&self, z: f64) -> Option<(f64, f64)> {
        let z2 = z * z;
        let a = self.right * self.right - z2 * self.right_squares;
        let b = self.left * self.right - z2 * self.products;
        let c = self.left * self.left - z2 * self.left_squares;
        let root = (b * b - a * c).max(0.0).sqrt();
        (a > 0.0).then(|| ((b - root) / a, (b + root) / a))
    }
}
