//! The paper's way of calibrating, on our own model: a general optimiser with finite differences of the simulation
//! (Fig. 5, S19 and S28). Only `bench` runs it, to be set beside the cone programs.
//!
//! The bounds enter as a quadratic penalty, as the optimiser (L-BFGS) knows none.

use std::cell::Cell;
use std::time::{Duration, Instant};

use aero::Flow;
use argmin::core::{CostFunction, Error, Executor, Gradient};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;
use calibrate::basis::Basis;
use calibrate::bounds::{BoundRow, bounds};
use calibrate::objective::{objective, rmse};
use calibrate::{AirspeedData, Settings};
use coupling::{ElasticWing, SteadyCase, SteadyModel};

/// Where the general optimiser came to.
pub(crate) struct GeneralFit {
    pub(crate) seconds: f64,
    /// Steady solutions of all angles that it asked for.
    pub(crate) simulations: usize,
    pub(crate) objective: f64,
}

/// Forward difference step, as fmincon's default for values near one.
const STEP: f64 = 1.5e-8;
/// Length of the search's first step, in corrections.
const FIRST_STEP: f64 = 0.1;
/// Weight of a squared violation of a bound, N.
const PENALTY: f64 = 1e4;

struct PapersProblem<'a> {
    wing: &'a ElasticWing,
    data: &'a AirspeedData,
    basis: Basis,
    bounds: Vec<BoundRow>,
    cases: Vec<SteadyCase>,
    simulations: Cell<usize>,
    stop: Instant,
    /// Factor on the cost, so that the first step of the search has a sensible length.
    scale: f64,
}

impl PapersProblem<'_> {
    /// Eq. 8 of paper 1, alone.
    fn objective(&self, x: &[f64]) -> Result<f64, Error> {
        self.simulations.set(self.simulations.get() + 1);
        let loads = self.wing.root_loads(&self.cases, &self.basis.corrections(x))?;
        let residuals: Vec<[f64; 3]> = loads
            .iter()
            .zip(&self.data.angles)
            .map(|(load, angle)| std::array::from_fn(|c| load.to_array()[c] - angle.loads.to_array()[c]))
            .collect();
        Ok(objective(rmse(&residuals, [true; 3]), [1.0; 3]))
    }
}

impl CostFunction for PapersProblem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        if Instant::now() > self.stop {
            return Err(Error::msg("time is up"));
        }
        let broken: f64 = self.bounds.iter().map(|row| (row.value(x) - row.limit).max(0.0).powi(2)).sum();
        Ok(self.scale * (self.objective(x)? + PENALTY * broken))
    }
}

impl Gradient for PapersProblem<'_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, Error> {
        let here = self.cost(x)?;
        let mut moved = x.clone();
        (0..x.len())
            .map(|k| {
                let step = STEP * x[k].abs().max(1.0);
                moved[k] = x[k] + step;
                let slope = (self.cost(&moved)? - here) / step;
                moved[k] = x[k];
                Ok(slope)
            })
            .collect()
    }
}

/// Fits one airspeed until the optimiser stops or the time is up; what was best counts.
pub(crate) fn fit(
    wing: &ElasticWing,
    data: &AirspeedData,
    rho_kg_m3: f64,
    settings: &Settings,
    most: Duration,
) -> Result<GeneralFit, Error> {
    let start = Instant::now();
    let boxes = &wing.correctable;
    let basis = Basis::new(boxes, settings.chord_strips, settings.span_order);
    let flow = Flow { v_m_s: data.v_m_s, rho_kg_m3 };
    let mut x = basis.neutral();
    let mut simulations = 0;
    let mut reached = f64::INFINITY;
    // argmin returns nothing when a cost fails, so the search runs in short legs from the best point so far.
    while start.elapsed() < most {
        let mut problem = PapersProblem {
            wing,
            data,
            bounds: bounds(&basis, boxes, settings.neighbour_bound, settings.least_factor).rows,
            basis: basis.clone(),
            cases: data.angles.iter().map(|angle| SteadyCase::new(flow, angle.alpha_rad)).collect(),
            simulations: Cell::new(0),
            stop: start + 2 * most,
            scale: 1.0,
        };
        let slope = problem.gradient(&x)?.iter().map(|value| value * value).sum::<f64>().sqrt();
        problem.scale = FIRST_STEP / slope.max(f64::MIN_POSITIVE);
        let scale = problem.scale;
        let solver = LBFGS::new(MoreThuenteLineSearch::new(), 10);
        let run =
            Executor::new(problem, solver).configure(|state| state.param(x.clone()).max_iters(10)).run();
        let mut end = match run {
            Ok(end) => end,
            Err(e) => {
                wingroot::show::note(&format!("general optimiser: {e}"));
                break;
            }
        };
        simulations += end.problem.problem.as_ref().map_or(0, |problem| problem.simulations.get());
        let cost = end.state.get_best_cost() / scale;
        let Some(best) = end.state.take_best_param() else { break };
        let progress = cost < reached * (1.0 - 1e-4);
        (x, reached) = (best, cost.min(reached));
        if !progress {
            break;
        }
    }
    Ok(GeneralFit { seconds: start.elapsed().as_secs_f64(), simulations, objective: reached })
}
