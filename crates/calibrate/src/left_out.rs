//! Judged on what the fit has not seen: every other angle, and every airspeed in turn.

use crate::calibration::AirspeedCalibration;
use crate::fit::Problem;
use crate::objective::{LineFit, objective, rmse};
use crate::schedule::{CorrectionSet, Outside, Schedule};
use crate::statics::Angle;
use aero::{Corrections, Flow};
use coupling::{CouplingError, SteadyCase, SteadyModel};

/// Angles predicted by a fit to the others.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// The angles left out, rad.
    pub alphas_rad: Vec<f64>,
    /// Eq. 8 of the uncorrected model at these angles.
    pub objective_before: f64,
    /// Eq. 8 of the model corrected by the other angles.
    pub objective_after: f64,
    /// Eq. 8 of these angles about the straight lines through the angles that were fitted.
    pub line_error: f64,
}

/// An airspeed predicted from its neighbours' corrections.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOutAirspeed {
    /// Eq. 8 of the uncorrected model.
    pub objective_before: f64,
    /// Eq. 8 with the corrections that the schedule of the other airspeeds gives here.
    pub objective_after: f64,
}

/// Fits every other angle (both ends included) and predicts the rest; none with fewer than five angles.
pub(crate) fn left_out_angles<M: SteadyModel>(
    problem: &Problem<'_, M>,
    line: &LineFit,
) -> Result<Option<LeftOut>, CouplingError> {
    if problem.angles.len() < 5 {
        return Ok(None);
    }
    let kept: Vec<Angle> = problem.angles.iter().step_by(2).cloned().collect();
    let unseen: Vec<Angle> = problem.angles.iter().skip(1).step_by(2).cloned().collect();
    let weights = problem.settings.weights;
    let about = |angles: &[Angle]| line_through(&kept, angles, problem.channels);
    let fit = Problem {
        angles: &kept,
        line_floor: objective(rmse(&about(&kept), problem.channels), weights),
        ..*problem
    }
    .fit()?;
    let error = |corrections: &Corrections| {
        predicted(problem.model, problem.flow, &unseen, corrections)
            .map(|residuals| objective(rmse(&residuals, problem.channels), weights))
    };
    // Their own scatter about a line: about the line of all angles where that is larger, because a line
    // through few angles may hit the unseen ones by chance.
    let own: Vec<[f64; 3]> = line.residuals.iter().skip(1).step_by(2).copied().collect();
    let line_error = objective(rmse(&about(&unseen), problem.channels), weights)
        .max(objective(rmse(&own, problem.channels), weights));
    Ok(Some(LeftOut {
        alphas_rad: unseen.iter().map(|angle| angle.alpha_rad).collect(),
        objective_before: error(&Corrections::neutral(problem.model.correctable().len()))?,
        objective_after: error(&problem.basis.corrections(&fit.x))?,
        line_error,
    }))
}

/// Each airspeed with the corrections interpolated from the others (the nearest at the ends).
pub(crate) fn left_out_airspeed<M: SteadyModel>(
    model: &M,
    rho_kg_m3: f64,
    airspeeds: &[AirspeedCalibration],
    channels: [bool; 3],
    weights: [f64; 3],
) -> Result<Vec<Option<LeftOutAirspeed>>, CouplingError> {
    let mut results = Vec::with_capacity(airspeeds.len());
    for (index, airspeed) in airspeeds.iter().enumerate() {
        let others: Vec<CorrectionSet> = airspeeds
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index)
            .map(|(_, other)| CorrectionSet::new(other.data.v_m_s, other.corrections.clone()))
            .collect();
        if others.is_empty() {
            results.push(None);
            continue;
        }
        let schedule = Schedule { wing: String::new(), wing_hash: String::new(), sets: others };
        let v_m_s = airspeed.data.v_m_s;
        let corrections =
            schedule.at(v_m_s, Outside::Refuse).or_else(|_| schedule.at(v_m_s, Outside::Nearest))?;
        let residuals = predicted(model, Flow { v_m_s, rho_kg_m3 }, &airspeed.data.angles, &corrections)?;
        results.push(Some(LeftOutAirspeed {
            objective_before: airspeed.fit.objective[0],
            objective_after: objective(rmse(&residuals, channels), weights),
        }));
    }
    Ok(results)
}

/// Simulated minus measured.
fn predicted<M: SteadyModel>(
    model: &M,
    flow: Flow,
    angles: &[Angle],
    corrections: &Corrections,
) -> Result<Vec<[f64; 3]>, CouplingError> {
    let cases: Vec<SteadyCase> = angles.iter().map(|angle| SteadyCase::new(flow, angle.alpha_rad)).collect();
    let loads = model.root_loads(&cases, corrections)?;
    let residual = |(load, angle): (&coupling::RootLoads, &Angle)| {
        let simulated = load.to_array();
        std::array::from_fn(|c| simulated[c] - angle.loads[c])
    };
    Ok(loads.iter().zip(angles).map(residual).collect())
}

/// Residuals of `angles` about the least-squares straight lines through `kept`.
fn line_through(kept: &[Angle], angles: &[Angle], channels: [bool; 3]) -> Vec<[f64; 3]> {
    let count = kept.len() as f64;
    let mean = kept.iter().map(|angle| angle.alpha_rad).sum::<f64>() / count;
    let spread: f64 = kept.iter().map(|angle| (angle.alpha_rad - mean).powi(2)).sum();
    let line = |c: usize| {
        let level = kept.iter().map(|angle| angle.loads[c]).sum::<f64>() / count;
        let slope = kept.iter().map(|angle| (angle.alpha_rad - mean) * angle.loads[c]).sum::<f64>() / spread;
        (level, slope)
    };
    let lines: [(f64, f64); 3] = std::array::from_fn(line);
    let about = |angle: &Angle| {
        std::array::from_fn(|c| {
            let (level, slope) = lines[c];
            if channels[c] { angle.loads[c] - level - slope * (angle.alpha_rad - mean) } else { 0.0 }
        })
    };
    angles.iter().map(about).collect()
}
