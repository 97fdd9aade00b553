//! One airspeed, or all with one set: a sequence of cone programs with steps halved on the true objective.

use crate::basis::Basis;
use crate::bounds::{BoundRow, Bounds, active_neighbours};
use crate::campaign::TIP;
use crate::cone_program::{ConeProgram, NoSolution};
use crate::objective::{objective, rmse};
use crate::settings::Settings;
use crate::statics::Angle;
use crate::tip_zero::TipZero;
use aero::{Corrections, Flow};
use coupling::{CouplingError, RootSensitivity, SteadyCase, SteadyModel};
use faer::Mat;
use rayon::prelude::*;

/// The weight of the change never falls below that of this share of the objective at the start.
const LEAST_SHARE: f64 = 0.01;
/// An objective below this many noise floors is what noise gives, within its own scatter.
const AT_NOISE: f64 = 1.5;

/// How a fit ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The objective reached the straight-line floor.
    Converged,
    /// The line was not reached, but what is left is no more than noise gives (1.5 noise floors at most).
    AtNoiseFloor,
    /// No step lowers the objective further, and it is above both floors (the bounds may hold it there).
    Stalled,
    /// The bounds contradict each other.
    InfeasibleBounds,
    /// Every step towards a better objective makes the wing diverge.
    Diverged,
    /// More than root loads was measured: the mean of the posterior stands in the place of the least change.
    PosteriorMean,
}

/// Rows that share a flow.
pub(crate) struct FlowGroup<'a> {
    pub(crate) flow: Flow,
    pub(crate) angles: &'a [Angle],
}

/// What a fit needs to know.
pub(crate) struct Problem<'a, M: SteadyModel> {
    pub(crate) model: &'a M,
    pub(crate) groups: Vec<FlowGroup<'a>>,
    pub(crate) channels: [bool; 4],
    /// Weights of paper 1, Eq. 8, the tip's in N m/m.
    pub(crate) weights: [f64; 4],
    /// The zero of the tip reading.
    pub(crate) zero: TipZero,
    pub(crate) basis: &'a Basis,
    pub(crate) bounds: &'a Bounds,
    pub(crate) metric: &'a Mat<f64>,
    pub(crate) settings: &'a Settings,
    /// The straight-line floor of paper 1, Eq. 8.
    pub(crate) line_floor: f64,
    /// The noise floor of paper 1, Eq. 8; zero if noise is unknown.
    pub(crate) noise_floor: f64,
    /// Force and moment factor of every box that the sequence starts from and change is measured from: one is theory.
    pub(crate) start: f64,
    /// How many times the floor counts as reaching it: above one where rows are correlated.
    pub(crate) slack: f64,
}

/// Where a fit came to.
#[derive(Debug, Clone)]
pub struct Fit {
    /// Unknowns.
    pub x: Vec<f64>,
    /// RMSE by channel before and after.
    pub rmse: [[f64; 4]; 2],
    /// Eq. 8 of paper 1 before and after.
    pub objective: [f64; 2],
    /// Eq. 8 of paper 1 after each accepted step.
    pub history: Vec<f64>,
    /// Cone programs solved.
    pub cone_programs: usize,
    /// How it ended.
    pub ending: Ending,
    /// Neighbour rows at their bound.
    pub neighbour_bound_active: usize,
}

impl FlowGroup<'_> {
    fn cases(&self) -> Vec<SteadyCase> {
        self.angles.iter().map(|angle| SteadyCase::new(self.flow, angle.alpha_rad)).collect()
    }
}

impl<M: SteadyModel> Problem<'_, M> {
    /// Runs the sequence from the start.
    pub(crate) fn fit(&self) -> Result<Fit, CouplingError> {
        let mut x = self.start();
        let mut at = self.linearise(&x)?;
        let before =
            if x == self.basis.neutral() { at.rmse } else { self.linearise(&self.basis.neutral())?.rmse };
        let target = self.slack * (1.02 * self.line_floor + 0.02 * self.noise_floor);
        let mut history = vec![self.objective(at.rmse)];
        let mut ending = Ending::Stalled;
        let mut cone_programs = 0;
        let mut working = self.bounds.first.clone();
        loop {
            if self.objective(at.rmse) <= target {
                ending = Ending::Converged;
                break;
            }
            if cone_programs == self.settings.most_cone_programs {
                break;
            }
            cone_programs += 1;
            let weight = self.change_weight(&at, before);
            match self.program(&at, &x, weight, &working) {
                Ok(goal) => {
                    let goal = self.within_bounds(&x, goal, &mut working);
                    match self.step(&x, &goal, weight, &at)? {
                        Step::Taken(next, linearised) => (x, at) = (next, linearised),
                        Step::Refused(why) => {
                            ending = why;
                            break;
                        }
                    }
                }
                Err(NoSolution::Infeasible) => {
                    ending = Ending::InfeasibleBounds;
                    break;
                }
                Err(NoSolution::Numerical) => break,
            }
            history.push(self.objective(at.rmse));
        }
        if ending == Ending::Stalled && self.objective(at.rmse) <= AT_NOISE * self.noise_floor {
            ending = Ending::AtNoiseFloor;
        }
        Ok(Fit {
            objective: [self.objective(before), self.objective(at.rmse)],
            rmse: [before, at.rmse],
            neighbour_bound_active: active_neighbours(&self.bounds.rows, &x),
            x,
            history,
            cone_programs,
            ending,
        })
    }

    /// Paper 1, Eq. 8 of channel errors.
    fn objective(&self, rmse: [f64; 4]) -> f64 {
        objective(rmse, self.weights)
    }

    /// Residuals and Jacobians at x.
    pub(crate) fn linearise(&self, x: &[f64]) -> Result<Linearised, CouplingError> {
        let sensitivities = self.sensitivities(&self.basis.corrections(x))?;
        let mut residuals = self.misses(&sensitivities);
        let mut tip: Vec<f64> = residuals.iter().map(|row| row[TIP]).collect();
        self.zero.centre(&mut tip);
        for (row, value) in residuals.iter_mut().zip(tip) {
            row[TIP] = value;
        }
        Ok(Linearised { rmse: rmse(&residuals, self.channels), residuals, sensitivities })
    }

    /// Readings and derivatives of all rows.
    pub(crate) fn sensitivities(
        &self,
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        let by_group = self
            .groups
            .par_iter()
            .map(|group| self.model.sensitivities(&group.cases(), corrections))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(by_group.into_iter().flatten().collect())
    }

    /// All rows in the order of the groups.
    pub(crate) fn angles(&self) -> impl Iterator<Item = &Angle> {
        self.groups.iter().flat_map(|group| group.angles)
    }

    /// Simulated minus measured, by row and channel, the zero of the tip not taken out.
    pub(crate) fn misses(&self, sensitivities: &[RootSensitivity]) -> Vec<[f64; 4]> {
        let miss = |(at, angle): (&RootSensitivity, &Angle)| {
            let (simulated, measured) = (at.readings(), angle.readings());
            std::array::from_fn(|c| simulated[c] - measured[c])
        };
        sensitivities.iter().zip(self.angles()).map(miss).collect()
    }

    /// Derivatives of one channel's residuals by the unknowns, rows by unknowns, a free zero eliminated.
    pub(crate) fn jacobian(&self, gradients: &[Mat<f64>], channel: usize) -> Mat<f64> {
        let mut jacobian =
            Mat::from_fn(gradients.len(), self.basis.size(), |i, k| gradients[i][(channel, k)]);
        if channel == TIP && self.zero.count() > 0 {
            for k in 0..jacobian.ncols() {
                self.zero.centre(jacobian.col_as_slice_mut(k));
            }
        }
        jacobian
    }

    /// Weight of the change: small against the objective. It falls with the objective, but not beyond a share of where
    /// the fit started or of the noise: a weight too small for the solver's arithmetic leaves the undetermined
    /// directions to chance, and the linearisation does not hold that far out.
    fn change_weight(&self, at: &Linearised, before: [f64; 4]) -> f64 {
        let least = (LEAST_SHARE * self.objective(before)).max(self.noise_floor);
        self.settings.change_weight * self.objective(at.rmse).max(least)
    }

    /// The goal, or the point on the way to it where the first bound outside the working set is met; bounds that the
    /// goal breaks join the working set.
    fn within_bounds(&self, x: &[f64], goal: Vec<f64>, working: &mut Vec<usize>) -> Vec<f64> {
        let (share, broken) = self.bounds.share_within(x, &goal);
        if broken.is_empty() {
            return goal;
        }
        working.extend(broken);
        working.sort_unstable();
        working.dedup();
        x.iter().zip(&goal).map(|(a, b)| a + share * (b - a)).collect()
    }

    fn program(
        &self,
        at: &Linearised,
        x: &[f64],
        weight: f64,
        working: &[usize],
    ) -> Result<Vec<f64>, NoSolution> {
        let measured: Vec<usize> = (0..4).filter(|&c| self.channels[c]).collect();
        let gradients: Vec<Mat<f64>> = at.sensitivities.iter().map(|s| self.basis.gradient(s)).collect();
        // The solver sees the tip in N m, as a number of the size of the loads.
        let unit = |c: usize| if c == TIP { self.weights[TIP] } else { 1.0 };
        let residuals: Vec<Vec<f64>> =
            measured.iter().map(|&c| at.residuals.iter().map(|r| unit(c) * r[c]).collect()).collect();
        let jacobians: Vec<Mat<f64>> =
            measured.iter().map(|&c| faer::Scale(unit(c)) * self.jacobian(&gradients, c)).collect();
        let bounds: Vec<&BoundRow> = working.iter().map(|&row| &self.bounds.rows[row]).collect();
        let weights: Vec<f64> = measured.iter().map(|&c| self.weights[c] / unit(c)).collect();
        ConeProgram {
            residuals: &residuals,
            jacobians: &jacobians,
            weights: &weights,
            from: x,
            neutral: &self.start(),
            metric: self.metric,
            change_weight: weight,
            bounds: &bounds,
        }
        .solve()
    }

    /// The longest of the steps 1, 1/2, 1/4 ... towards the goal that lowers the true objective.
    fn step(&self, x: &[f64], goal: &[f64], weight: f64, at: &Linearised) -> Result<Step, CouplingError> {
        let merit = |x: &[f64], rmse: [f64; 4]| self.objective(rmse) + weight * self.change(x);
        let now = merit(x, at.rmse);
        let mut share = 1.0;
        let mut why = Ending::Diverged;
        for _ in 0..self.settings.most_halvings {
            let next: Vec<f64> = x.iter().zip(goal).map(|(a, b)| a + share * (b - a)).collect();
            match self.linearise(&next) {
                Ok(linearised) if merit(&next, linearised.rmse) < now * (1.0 - 1e-6) => {
                    return Ok(Step::Taken(next, linearised));
                }
                Ok(_) => why = Ending::Stalled,
                Err(error) if error.is_without_equilibrium() => {}
                Err(error) => return Err(error),
            }
            share *= 0.5;
        }
        Ok(Step::Refused(why))
    }

    /// x0: theory's corrections, their factors times the one the fit starts from.
    fn start(&self) -> Vec<f64> {
        self.basis.neutral().iter().map(|one| self.start * one).collect()
    }

    /// (x - x0)' M (x - x0): mean square change of pressure.
    fn change(&self, x: &[f64]) -> f64 {
        let d: Vec<f64> = x.iter().zip(&self.start()).map(|(a, b)| a - b).collect();
        (0..d.len()).map(|j| (0..d.len()).map(|i| d[i] * self.metric[(i, j)]).sum::<f64>() * d[j]).sum()
    }
}

/// A step towards the solution of a cone program.
enum Step {
    /// It lowers the true objective: the new unknowns and the model around them.
    Taken(Vec<f64>, Linearised),
    /// No part of it does.
    Refused(Ending),
}

/// The model around one set of corrections.
pub(crate) struct Linearised {
    pub(crate) rmse: [f64; 4],
    /// By row and channel, the tip's about its zero.
    pub(crate) residuals: Vec<[f64; 4]>,
    pub(crate) sensitivities: Vec<RootSensitivity>,
}

#[cfg(test)]
mod tests;
