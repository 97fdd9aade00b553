//! One airspeed, or all with one set: a sequence of cone programs with steps halved on the true objective.

mod nearby;

use crate::basis::Basis;
use crate::bounds::{BoundRow, Bounds, active_neighbours};
use crate::campaign::TIP;
use crate::cone_program::{ConeProgram, NoSolution};
use crate::objective::{objective, polynomial_residuals, rmse};
use crate::settings::Settings;
use crate::statics::Angle;
use crate::tip_zero::TipZero;
use aero::{Corrections, Flow};
use coupling::{CouplingError, RootSensitivity, SteadyCase, SteadyModel};
use faer::Mat;
use nearby::Nearby;
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

/// What an objective can come down to.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Floor {
    /// That of curves through the readings, of a form that every set of corrections gives (straight lines in the angle: paper 1, Eq. 8).
    Known(f64),
    /// That of straight lines in the angle through what the model misses: it has a curvature of its own, and corrections shift and
    /// tilt it.
    OfMisses,
}

/// Rows that share a flow.
#[derive(Clone)]
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
    pub(crate) floor: Floor,
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
    /// What the objective could come down to.
    pub floor: f64,
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
        let x = self.start();
        let at = self.linearise(&x)?;
        let before =
            if x == self.basis.neutral() { at.rmse } else { self.linearise(&self.basis.neutral())?.rmse };
        self.sequence(x, at, before)
    }

    /// Runs it from unknowns and the model around them; `before` are theory's errors.
    fn sequence(&self, mut x: Vec<f64>, mut at: Linearised, before: [f64; 4]) -> Result<Fit, CouplingError> {
        let mut history = vec![self.objective(at.rmse)];
        let mut ending = Ending::Stalled;
        let (mut rounds, mut cone_programs) = (0, 0);
        let mut working = self.bounds.first.clone();
        loop {
            if self.objective(at.rmse) <= self.target(&at) {
                ending = Ending::Converged;
                break;
            }
            if rounds == self.settings.most_cone_programs {
                break;
            }
            rounds += 1;
            let weight = self.change_weight(&at, before);
            let goal = match self.model.nearby() {
                Some(near) => self.goal_by(near, &x, &at, before)?,
                None => self.goal(&x, &at, weight, &mut working),
            };
            cone_programs += goal.cone_programs;
            match goal.found.map(|goal| self.step(&x, &goal, weight, &at)) {
                Ok(step) => match step? {
                    Step::Taken(next, linearised) => (x, at) = (next, linearised),
                    Step::Refused(why) => {
                        ending = why;
                        break;
                    }
                },
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
            floor: self.floor_at(&at),
            neighbour_bound_active: active_neighbours(&self.bounds.rows, &x),
            x,
            history,
            cone_programs,
            ending,
        })
    }

    /// Where the objective is as low as it can be: the floor and a share of the noise.
    fn target(&self, at: &Linearised) -> f64 {
        self.slack * (1.02 * self.floor_at(at) + 0.02 * self.noise_floor)
    }

    fn floor_at(&self, at: &Linearised) -> f64 {
        if let Floor::Known(floor) = self.floor {
            return floor;
        }
        let mut left = Vec::with_capacity(at.residuals.len());
        for group in &self.groups {
            let misses = &at.residuals[left.len()..][..group.angles.len()];
            let alphas: Vec<f64> = group.angles.iter().map(|angle| angle.alpha_rad).collect();
            let of_channel = |c: usize| {
                let values: Vec<f64> = misses.iter().map(|row| row[c]).collect();
                polynomial_residuals(&alphas, &values, 1).0
            };
            let channels: [Vec<f64>; 4] = std::array::from_fn(of_channel);
            left.extend((0..misses.len()).map(|row| std::array::from_fn(|c| channels[c][row])));
        }
        self.objective(rmse(&left, self.channels))
    }

    /// Where the next step goes by one cone program.
    fn goal(&self, x: &[f64], at: &Linearised, weight: f64, working: &mut Vec<usize>) -> Goal {
        let found = self.program(at, x, weight, working);
        Goal { cone_programs: 1, found: found.map(|goal| self.within_bounds(x, goal, working)) }
    }

    /// Where it goes by a whole sequence on a cheaper model that is put right about x.
    fn goal_by(
        &self,
        near: &dyn SteadyModel,
        x: &[f64],
        at: &Linearised,
        before: [f64; 4],
    ) -> Result<Goal, CouplingError> {
        let groups: Vec<_> = self.groups.iter().map(FlowGroup::cases).collect();
        let model = Nearby::new(near, self.basis.corrections(x), &groups, &at.sensitivities)?;
        let problem = Problem {
            model: &model,
            groups: self.groups.clone(),
            channels: self.channels,
            weights: self.weights,
            zero: self.zero.clone(),
            basis: self.basis,
            bounds: self.bounds,
            metric: self.metric,
            settings: self.settings,
            floor: self.floor,
            noise_floor: self.noise_floor,
            start: self.start,
            slack: self.slack,
        };
        let fit = problem.sequence(x.to_vec(), at.clone(), before)?;
        let found =
            if fit.ending == Ending::InfeasibleBounds { Err(NoSolution::Infeasible) } else { Ok(fit.x) };
        Ok(Goal { cone_programs: fit.cone_programs, found })
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
        // A search that did not move found nothing better: the model need not be asked.
        if x == goal {
            return Ok(Step::Refused(Ending::Stalled));
        }
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

/// Where a step goes.
struct Goal {
    /// Cone programs that it took.
    cone_programs: usize,
    found: Result<Vec<f64>, NoSolution>,
}

/// A step towards the solution of a cone program.
enum Step {
    /// It lowers the true objective: the new unknowns and the model around them.
    Taken(Vec<f64>, Linearised),
    /// No part of it does.
    Refused(Ending),
}

/// The model around one set of corrections.
#[derive(Clone)]
pub(crate) struct Linearised {
    pub(crate) rmse: [f64; 4],
    /// By row and channel, the tip's about its zero.
    pub(crate) residuals: Vec<[f64; 4]>,
    pub(crate) sensitivities: Vec<RootSensitivity>,
}

#[cfg(test)]
mod tests;
