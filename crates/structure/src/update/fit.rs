//! The fit: Gauss-Newton steps within the determined directions, halved until they help.

use super::determination::Determination;
use super::measurements::{Measurements, Parameter, Quantity, Settings, UpdateError};
use super::state::{State, evaluate};
use crate::model::Model;

/// No factor goes below.
const LEAST: f64 = 0.02;
/// A step shorter than this ends the fit.
const SHORT: f64 = 1e-9;

/// A fitted factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Factor {
    /// The region's name.
    pub region: String,
    /// What it multiplies.
    pub quantity: Quantity,
    /// Its value; what the data do not determine stays as in the model.
    pub value: f64,
    /// One standard deviation within the determined directions.
    pub sigma: f64,
    /// Whether the data determine it by itself.
    pub is_determined: bool,
}

/// The result of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The factors, in the order of the parameters.
    pub factors: Vec<Factor>,
    /// The model as it is.
    pub before: State,
    /// The model with the factors.
    pub after: State,
    /// What the data determine.
    pub determination: Determination,
    /// Steps taken.
    pub steps: usize,
    /// Whether the last step was as short as it should be, or no step helps any more.
    pub is_converged: bool,
}

impl Fit {
    /// Numbers compared less directions fitted.
    pub fn degrees_of_freedom(&self) -> usize {
        self.after.compared().saturating_sub(self.determination.determined)
    }
}

/// Fits the factors of regions to measurements.
///
/// # Errors
/// If the structure has no modes or no flexibility.
pub fn fit(
    model: &Model,
    parameters: &[Parameter],
    measurements: &Measurements,
    settings: &Settings,
) -> Result<Fit, UpdateError> {
    let at = |factors: &[f64]| evaluate(model, parameters, factors, measurements, settings);
    let before = at(&vec![1.0; parameters.len()])?;
    let mut state = before.clone();
    let (mut steps, mut is_converged) = (0, parameters.is_empty());
    while steps < settings.iterations && !is_converged {
        let (_, step) = linearised(&state, parameters.len(), settings);
        if step.iter().all(|part| part.abs() < SHORT) {
            is_converged = true;
            break;
        }
        steps += 1;
        match improved(&state, &step, &at)? {
            Some(next) => state = next,
            None => is_converged = true,
        }
    }
    let (determination, _) = linearised(&state, parameters.len(), settings);
    let covariance = determination.covariance();
    let factor = |(p, parameter): (usize, &Parameter)| Factor {
        region: parameter.region.clone(),
        quantity: parameter.quantity,
        value: state.factors[p],
        sigma: covariance[p][p].sqrt(),
        is_determined: determination.is_determined(p),
    };
    let factors = parameters.iter().enumerate().map(factor).collect();
    Ok(Fit { factors, before, after: state, determination, steps, is_converged })
}

fn linearised(state: &State, count: usize, settings: &Settings) -> (Determination, Vec<f64>) {
    let residuals: Vec<f64> = state.predictions.iter().map(|p| p.residual().unwrap_or(0.0)).collect();
    Determination::of(&state.sensitivities, &residuals, count, settings.undetermined)
}

/// The state after the longest of the step, its half, its quarter, ... that makes the residuals smaller and loses no
/// pair of modes; none if there is none.
fn improved(
    state: &State,
    step: &[f64],
    at: &impl Fn(&[f64]) -> Result<State, UpdateError>,
) -> Result<Option<State>, UpdateError> {
    let mut length = 1.0;
    for _ in 0..20 {
        let factors: Vec<f64> = state.factors.iter().zip(step).map(|(f, part)| f + length * part).collect();
        if factors.iter().all(|factor| *factor > LEAST) {
            let next = at(&factors)?;
            let more = next.compared() > state.compared();
            let better = next.compared() == state.compared() && next.chi_square() < state.chi_square();
            if more || better {
                return Ok(Some(next));
            }
        }
        length *= 0.5;
    }
    Ok(None)
}
