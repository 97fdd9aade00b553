//! Viscous polars of the section over Reynolds number, and straight lines laid through them.

use nastran::{InputError, Table};
use std::path::Path;

/// Lift and moment coefficients of one Reynolds number.
#[derive(Debug, Clone)]
struct Polar {
    re: f64,
    alpha_rad: Vec<f64>,
    cl: Vec<f64>,
    cm: Vec<f64>,
}

/// A straight line through a polar: `cl = slope (alpha + lead)`, and the mean moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PolarLine {
    /// Lift slope, 1/rad.
    pub(crate) slope: f64,
    /// Minus the angle of zero lift, rad.
    pub(crate) lead_rad: f64,
    /// Mean moment coefficient about the quarter chord, nose up positive.
    pub(crate) cm: f64,
}

/// Polars of one section, ascending Reynolds numbers, one grid of angles.
#[derive(Debug, Clone)]
pub(crate) struct Polars {
    polars: Vec<Polar>,
    /// Re per (V c) of the table, s/m²: one over the kinematic viscosity.
    re_per_v_c: f64,
}

impl Polars {
    /// Reads `V_mps,Re,alpha_deg,cl,cd,cm_c4`; Re is for `mean_chord_m`.
    pub(crate) fn read(path: &Path, mean_chord_m: f64) -> Result<Self, InputError> {
        let table = Table::read(path)?;
        table.require(&["V_mps", "Re", "alpha_deg", "cl", "cm_c4"])?;
        let mut polars: Vec<Polar> = Vec::new();
        for row in 0..table.len() {
            let re = table.number(row, "Re")?;
            if polars.last().is_none_or(|polar| polar.re != re) {
                polars.push(Polar { re, alpha_rad: Vec::new(), cl: Vec::new(), cm: Vec::new() });
            }
            let Some(polar) = polars.last_mut() else { continue };
            polar.alpha_rad.push(table.number(row, "alpha_deg")?.to_radians());
            polar.cl.push(table.number(row, "cl")?);
            polar.cm.push(table.number(row, "cm_c4")?);
        }
        let rises = |values: &[f64]| values.len() > 1 && values.windows(2).all(|pair| pair[0] < pair[1]);
        let ascending = polars.windows(2).all(|pair| pair[0].re < pair[1].re);
        if polars.is_empty() || !ascending || polars.iter().any(|polar| !rises(&polar.alpha_rad)) {
            return Err(InputError::in_file(path, "Reynolds numbers and, within each, angles must ascend")
                .with_help("sort the rows by Re, then by alpha_deg"));
        }
        let re_per_v_c = table.number(0, "Re")? / (table.number(0, "V_mps")? * mean_chord_m);
        Ok(Self { polars, re_per_v_c })
    }

    /// Reynolds number of a chord at an airspeed.
    pub(crate) fn reynolds(&self, v_m_s: f64, chord_m: f64) -> f64 {
        self.re_per_v_c * v_m_s * chord_m
    }

    /// Lift coefficient at an angle, linear in Reynolds number and angle, constant outside the table.
    pub(crate) fn cl(&self, re: f64, alpha_rad: f64) -> f64 {
        self.between(re, |polar| interpolate(&polar.alpha_rad, &polar.cl, alpha_rad))
    }

    /// Least-squares line over a range of angles.
    pub(crate) fn line(&self, re: f64, range_rad: (f64, f64)) -> PolarLine {
        // A fine grid, so that the range need not end at a row of the table.
        const STEPS: usize = 64;
        let at = |i: usize| range_rad.0 + (range_rad.1 - range_rad.0) * i as f64 / STEPS as f64;
        let count = (STEPS + 1) as f64;
        let mean_alpha = (0..=STEPS).map(at).sum::<f64>() / count;
        let mean_cl = (0..=STEPS).map(|i| self.cl(re, at(i))).sum::<f64>() / count;
        let product: f64 = (0..=STEPS).map(|i| (at(i) - mean_alpha) * self.cl(re, at(i))).sum();
        let square: f64 = (0..=STEPS).map(|i| (at(i) - mean_alpha).powi(2)).sum();
        let slope = product / square;
        let cm = |i: usize| self.between(re, |polar| interpolate(&polar.alpha_rad, &polar.cm, at(i)));
        PolarLine {
            slope,
            lead_rad: mean_cl / slope - mean_alpha,
            cm: (0..=STEPS).map(cm).sum::<f64>() / count,
        }
    }

    fn between(&self, re: f64, value: impl Fn(&Polar) -> f64) -> f64 {
        let res: Vec<f64> = self.polars.iter().map(|polar| polar.re).collect();
        let values: Vec<f64> = self.polars.iter().map(value).collect();
        interpolate(&res, &values, re)
    }
}

/// Linear interpolation, constant outside.
pub(crate) fn interpolate(x: &[f64], y: &[f64], at: f64) -> f64 {
    if x.len() < 2 {
        return y.first().copied().unwrap_or(0.0);
    }
    let upper = x.partition_point(|&x| x < at).clamp(1, x.len() - 1);
    let share = ((at - x[upper - 1]) / (x[upper] - x[upper - 1])).clamp(0.0, 1.0);
    y[upper - 1] + share * (y[upper] - y[upper - 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polars(cl: impl Fn(f64) -> f64) -> Polars {
        let alpha_rad: Vec<f64> = (-8..=8).map(|deg| f64::from(deg).to_radians()).collect();
        let cl: Vec<f64> = alpha_rad.iter().map(|&alpha| cl(alpha)).collect();
        let cm = vec![-0.1; cl.len()];
        Polars { polars: vec![Polar { re: 1e5, alpha_rad, cl, cm }], re_per_v_c: 1.0 }
    }

    #[test]
    fn a_straight_polar_is_its_own_line() {
        let line = polars(|alpha| 6.0 * (alpha + 0.1)).line(2e5, (-0.08, 0.05));
        assert!((line.slope - 6.0).abs() < 1e-12);
        assert!((line.lead_rad - 0.1).abs() < 1e-13);
        assert!((line.cm + 0.1).abs() < 1e-14);
    }

    #[test]
    fn interpolation_is_constant_outside_the_table() {
        let (x, y) = ([1.0, 2.0, 4.0], [10.0, 20.0, 0.0]);
        assert_eq!([0.0, 1.5, 3.0, 9.0].map(|at| interpolate(&x, &y, at)), [10.0, 15.0, 10.0, 0.0]);
    }
}
