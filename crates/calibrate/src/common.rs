//! One set of corrections for all airspeeds of a campaign: for sweeps of the airspeed at one or a few angles.
//!
//! Corrections belong to coefficients, so one set can serve all airspeeds: loads and deflections then grow with dynamic
//! pressure as those of the elastic wing do. Where airspeeds are many and angles few, this is all that can be asked for.
//! The same cone programs run on the rows of all airspeeds; in place of straight lines in the angle of attack, the floor
//! is the error of parabolas in dynamic pressure, one for each block and angle (slope, wash-in or wash-out, zero).
//!
//! First comes the one number that such data do determine, the uniform factor on lift (`lift_factor`). A distribution is
//! looked for from there, and only if that number leaves more than the parabolas by more than chance gives: with
//! `n = rows (1 - rho) / (1 + rho)` independent rows and k parabolas, `(n - 3k) (F²/F_curve² - 1) > 4k`, two standard
//! deviations for one more number a parabola. What is below that is scatter, and theory's distribution stays.

use crate::calibration::Context;
use crate::campaign::TipReading;
use crate::fit::{Fit, Floor, FlowGroup, Problem};
use crate::identifiability::{Identifiability, Inputs, identifiability};
use crate::lift_factor::{LiftFactor, lift_factor};
use crate::objective::{objective, polynomial_residuals, rmse};
use crate::statics::{Angle, StaticData};
use crate::tip_zero::TipZero;
use aero::flow::same_angle;
use aero::{Corrections, Flow};
use coupling::{CouplingError, SteadyModel};
use faer::Mat;

/// Corrections that serve all airspeeds, and how good they are.
#[derive(Debug, Clone)]
pub struct CommonCalibration {
    /// Lowest and highest airspeed of the rows, m/s: corrections are known between them.
    pub v_range_m_s: [f64; 2],
    /// Means that were fitted.
    pub rows: usize,
    /// Corrections of the wing's boxes.
    pub corrections: Corrections,
    /// The sequence of cone programs.
    pub fit: Fit,
    /// Weights of paper 1, Eq. 8, the tip's in N m/m (zero if it is not fitted).
    pub weights: [f64; 4],
    /// RMSE of parabolas in dynamic pressure, one for each block and angle, by channel.
    pub curve_rmse: [f64; 4],
    /// Paper 1, Eq. 8 of these parabolas.
    pub curve_floor: f64,
    /// Standard deviation of a row: declared, from replicates, or of the rows about the parabolas.
    pub point_sigma: [f64; 4],
    /// Factor on all loads of the theory that fits best; none if nothing hangs on it.
    pub lift: Option<LiftFactor>,
    /// What the data can tell, their correlation considered.
    pub identifiability: Option<Identifiability>,
    /// Area-weighted mean of the force factors that were found.
    pub mean_force_factor: f64,
}

impl<M: SteadyModel> Context<'_, M> {
    /// Fits one set to all rows.
    pub(crate) fn common(&self) -> Result<CommonCalibration, CouplingError> {
        let metric = self.metric(&self.data.airspeeds)?;
        let (mut problem, curves, point_sigma) = self.common_problem(&metric)?;
        let lift = lift_factor(&problem, point_sigma)?;
        problem.slack = curves.slack(lift.as_ref().map_or(1.0, LiftFactor::widening));
        problem.start = lift.as_ref().map_or(1.0, |lift| lift.factor.max(self.settings.least_factor));
        self.fitted(&problem, rmse(&curves.residuals, self.data.channels), point_sigma, lift)
    }

    /// The one factor on the lift of all rows.
    pub(crate) fn common_lift(&self) -> Result<Option<LiftFactor>, CouplingError> {
        let metric = self.metric(&self.data.airspeeds)?;
        let (problem, _, point_sigma) = self.common_problem(&metric)?;
        lift_factor(&problem, point_sigma)
    }

    /// The problem of all rows from theory, parabolas through them, and the standard deviation of a row.
    fn common_problem<'b>(
        &'b self,
        metric: &'b Mat<f64>,
    ) -> Result<(Problem<'b, M>, Curves, [f64; 4]), CouplingError> {
        let data = self.data;
        let groups: Vec<FlowGroup<'_>> = data
            .airspeeds
            .iter()
            .map(|a| FlowGroup {
                flow: Flow { v_m_s: a.v_m_s, rho_kg_m3: self.rho_kg_m3 },
                angles: &a.angles,
            })
            .collect();
        let flows: Vec<Flow> = groups.iter().map(|group| group.flow).collect();
        let angles: Vec<&Angle> = groups.iter().flat_map(|group| group.angles).collect();
        let q_pa: Vec<f64> = groups
            .iter()
            .flat_map(|group| group.angles.iter().map(|_| group.flow.dynamic_pressure_pa()))
            .collect();
        let weights = self.weights(&flows)?;
        let curves = Curves::new(data, &angles, &q_pa);
        let curve_floor = objective(rmse(&curves.residuals, data.channels), weights);
        let point_sigma = std::array::from_fn(|c| {
            data.point_sigma.map(|sigma| sigma[c]).filter(|&sigma| sigma > 0.0).unwrap_or(curves.sigma[c])
        });
        let problem = Problem {
            model: self.model,
            channels: data.channels,
            weights,
            zero: TipZero::new(
                angles.iter().map(|angle| angle.block).collect(),
                data.tip == TipReading::FreeZero,
            ),
            basis: &self.basis,
            bounds: &self.bounds,
            metric,
            settings: self.settings,
            floor: Floor::Known(curve_floor),
            // what scatters about the parabolas is the noise, unless it is known
            noise_floor: objective(rmse_of(point_sigma, data.channels), weights),
            start: 1.0,
            slack: 1.0,
            groups,
        };
        Ok((problem, curves, point_sigma))
    }

    /// Runs the fit and says what came of it.
    fn fitted(
        &self,
        problem: &Problem<'_, M>,
        curve_rmse: [f64; 4],
        point_sigma: [f64; 4],
        lift: Option<LiftFactor>,
    ) -> Result<CommonCalibration, CouplingError> {
        let fit = problem.fit()?;
        let wide = lift.as_ref().map_or(1.0, LiftFactor::widening);
        let corrections = self.basis.corrections(&fit.x);
        let area_share = &self.model.correctable().area_share;
        let inputs = Inputs {
            basis: &self.basis,
            area_share,
            metric: problem.metric,
            prior_spread: self.settings.prior_spread,
            channels: problem.channels,
            angles: problem.angles().collect(),
            zero: &problem.zero,
            point_sigma: point_sigma.map(|sigma| wide * sigma),
            common_sigma: self.data.common_sigma(),
        };
        let v_m_s = problem.groups.iter().map(|group| group.flow.v_m_s);
        Ok(CommonCalibration {
            v_range_m_s: v_m_s.fold([f64::INFINITY, 0.0], |[low, high], v| [low.min(v), high.max(v)]),
            rows: problem.angles().count(),
            mean_force_factor: corrections.force.iter().zip(area_share).map(|(w, share)| w * share).sum(),
            identifiability: identifiability(&problem.linearise(&fit.x)?, &inputs),
            corrections,
            curve_floor: fit.floor,
            fit,
            weights: problem.weights,
            curve_rmse,
            point_sigma,
            lift,
        })
    }
}

fn rmse_of(sigma: [f64; 4], channels: [bool; 4]) -> [f64; 4] {
    std::array::from_fn(|c| if channels[c] { sigma[c] } else { 0.0 })
}

/// Parabolas in dynamic pressure, one for each block and angle.
struct Curves {
    residuals: Vec<[f64; 4]>,
    /// Standard deviation about them by channel, three degrees of freedom a parabola taken off.
    sigma: [f64; 4],
    /// Parabolas.
    count: usize,
}

impl Curves {
    fn new(data: &StaticData, angles: &[&Angle], q_pa: &[f64]) -> Self {
        let mut residuals = vec![[0.0; 4]; angles.len()];
        let (mut freedom, mut count) = (0, 0);
        let mut left: Vec<usize> = (0..angles.len()).collect();
        while let Some(&first) = left.first() {
            let belongs = |row: &usize| {
                angles[*row].block == angles[first].block
                    && same_angle(angles[*row].alpha_rad, angles[first].alpha_rad)
            };
            let (group, rest): (Vec<usize>, Vec<usize>) = left.iter().partition(|row| belongs(row));
            left = rest;
            let q: Vec<f64> = group.iter().map(|&row| q_pa[row]).collect();
            for channel in (0..4).filter(|&c| data.channels[c]) {
                let readings: Vec<f64> = group.iter().map(|&row| angles[row].readings()[channel]).collect();
                for (&row, residual) in group.iter().zip(polynomial_residuals(&q, &readings, 2).0) {
                    residuals[row][channel] = residual;
                }
            }
            freedom += group.len().saturating_sub(3);
            count += 1;
        }
        let sigma = std::array::from_fn(|c| {
            (residuals.iter().map(|row| row[c] * row[c]).sum::<f64>() / freedom.max(1) as f64).sqrt()
        });
        Self { residuals, sigma, count }
    }

    /// How many times the parabolas' error is no more than chance, with rows whose spreads are `wide` times those of
    /// independent ones.
    fn slack(&self, wide: f64) -> f64 {
        let (rows, count) = (self.residuals.len() as f64, self.count as f64);
        let freedom = (rows / (wide * wide) - 3.0 * count).max(1.0);
        (1.0 + 4.0 * count / freedom).sqrt()
    }
}

#[cfg(test)]
mod tests;
