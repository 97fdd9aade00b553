//! Power of the residual over that of pure error by channel, kind of maneuver and band of frequencies, with F limits.

use super::residuals::Residuals;
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// A cell of the map.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// Channel.
    pub channel: &'static str,
    /// Kind of maneuver, in words.
    pub maneuver: String,
    /// Place in [`crate::rules::LocateRules`]; static points are in the first.
    pub band: usize,
    /// Mean square of the residual over that of pure error; means of runs are left out.
    pub power: f64,
    /// What it stays below 99 times in a hundred where there is nothing but pure error.
    pub limit: f64,
    /// Number of coefficients or points.
    pub rows: usize,
    /// Number of runs or static groups.
    pub units: usize,
}

/// The band of a frequency.
pub fn band(bands_hz: &[(f64, f64)], frequency_hz: f64) -> usize {
    bands_hz.iter().position(|(_, end)| frequency_hz < *end).unwrap_or(bands_hz.len() - 1)
}

/// The map, the largest power first.
pub fn map(residuals: &Residuals) -> Vec<Cell> {
    let rules = &residuals.rules.locate;
    let mut cells: Vec<Cell> = Vec::new();
    for unit in &residuals.units {
        let maneuver = unit.maneuver.label(&residuals.controls);
        for (c, channel) in crate::channels::LOADS.into_iter().enumerate() {
            let mut sums = vec![(0.0, 0_usize); rules.bands_hz.len()];
            for (k, row) in unit.rows[c].iter().enumerate() {
                if unit.weight[c][k] > 0.0 && (unit.stimulus.steady || k > 0) {
                    let sum = &mut sums[band(&rules.bands_hz, unit.frequency_hz[k])];
                    *sum = (sum.0 + row * row, sum.1 + 1);
                }
            }
            for (band, (sum, rows)) in sums.into_iter().enumerate().filter(|(_, sum)| sum.1 > 0) {
                let same = |cell: &&mut Cell| {
                    cell.channel == channel && cell.maneuver == maneuver && cell.band == band
                };
                if let Some(cell) = cells.iter_mut().find(same) {
                    // sums until all are in
                    (cell.power, cell.rows, cell.units) =
                        (cell.power + sum, cell.rows + rows, cell.units + 1);
                } else {
                    let maneuver = maneuver.clone();
                    cells.push(Cell { channel, maneuver, band, power: sum, limit: 0.0, rows, units: 1 });
                }
            }
        }
    }
    for cell in &mut cells {
        cell.power /= cell.rows as f64;
        cell.limit = limit(rules.level, cell.rows as f64, residuals.degrees_of_freedom);
    }
    cells.sort_by(|a, b| b.power.total_cmp(&a.power));
    cells
}

/// The quantile of a ratio of mean squares.
pub(super) fn limit(level: f64, above: f64, below: Option<f64>) -> f64 {
    let quantile = match below {
        Some(below) => FisherSnedecor::new(above, below).map(|f| f.inverse_cdf(level)),
        None => ChiSquared::new(above).map_or(Ok(f64::NAN), |chi2| Ok(chi2.inverse_cdf(level) / above)),
    };
    quantile.unwrap_or(f64::NAN)
}
