//! Sections from polars: straight lines through lift and moment by Reynolds number.

use super::table::{Table, between};
use crate::fault::Fault;
use std::path::Path;

/// Kinematic viscosity of the polars' air, m²/s: Re = V c / nu with the mean chord of the table's rows.
const NU_M2_S: f64 = 1.46e-5;
/// Angles of attack between which a section is straight, degrees: what strips of the campaign's wings meet.
const STRAIGHT_DEG: (f64, f64) = (-3.0, 6.0);

/// A section in small angles: `cl = slope (alpha - zero)`, `cm = cm_zero + cm_by_cl cl` about the quarter chord.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Lift slope, 1/rad.
    pub slope_per_rad: f64,
    /// Angle of zero lift, rad.
    pub zero_rad: f64,
    /// Moment coefficient without lift.
    pub cm_zero: f64,
    /// Moment coefficient by lift coefficient.
    pub cm_by_cl: f64,
}

impl Section {
    /// A thin flat plate in an ideal flow.
    pub const FLAT: Self =
        Self { slope_per_rad: std::f64::consts::TAU, zero_rad: 0.0, cm_zero: 0.0, cm_by_cl: 0.0 };
}

/// Sections by the logarithm of the Reynolds number.
#[derive(Debug, Clone, PartialEq)]
pub struct Polars {
    log_re: Vec<f64>,
    sections: Vec<Section>,
}

impl Polars {
    /// Reads a table with columns `Re`, `alpha_deg`, `cl`, `cm_c4`.
    ///
    /// # Errors
    /// A file that cannot be read, or that lacks a column.
    pub fn read(path: &Path) -> Result<Self, Fault> {
        let table = Table::read(path)?;
        let column = |name: &str| table.column(name, path);
        let (re, alpha, cl, cm) = (column("Re")?, column("alpha_deg")?, column("cl")?, column("cm_c4")?);
        let mut numbers = re.clone();
        numbers.sort_by(f64::total_cmp);
        numbers.dedup();
        let section = |number: &f64| {
            let rows = (0..re.len()).filter(|row| {
                re[*row] == *number && (STRAIGHT_DEG.0..=STRAIGHT_DEG.1).contains(&alpha[*row])
            });
            let points: Vec<[f64; 3]> = rows.map(|row| [alpha[row].to_radians(), cl[row], cm[row]]).collect();
            let columns = |x: usize, y: usize| points.iter().map(|p| (p[x], p[y])).collect::<Vec<_>>();
            let (slope_per_rad, at_zero) = line(&columns(0, 1));
            let (cm_by_cl, cm_zero) = line(&columns(1, 2));
            Section { slope_per_rad, zero_rad: -at_zero / slope_per_rad, cm_zero, cm_by_cl }
        };
        let sections = numbers.iter().map(section).collect();
        Ok(Self { log_re: numbers.iter().map(|re| re.ln()).collect(), sections })
    }

    /// The section of a chord at an airspeed.
    pub fn section(&self, v_m_s: f64, chord_m: f64) -> Section {
        let at = (v_m_s * chord_m / NU_M2_S).max(1.0).ln();
        let of = |value: fn(&Section) -> f64| {
            between(&self.log_re, &self.sections.iter().map(value).collect::<Vec<f64>>(), at)
        };
        Section {
            slope_per_rad: of(|s| s.slope_per_rad),
            zero_rad: of(|s| s.zero_rad),
            cm_zero: of(|s| s.cm_zero),
            cm_by_cl: of(|s| s.cm_by_cl),
        }
    }
}

/// Slope and value at zero of the straight line through points, by least squares.
fn line(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len().max(1) as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let across: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let along: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    let slope = across / along.max(f64::MIN_POSITIVE);
    (slope, y - slope * x)
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn a_line_goes_through_points_that_lie_on_one() {
        let points = [(0.0, 1.0), (2.0, 5.0), (3.0, 7.0)];
        let (slope, at_zero) = line(&points);
        assert!((slope - 2.0).abs() < 1e-12 && (at_zero - 1.0).abs() < 1e-12);
    }
}
