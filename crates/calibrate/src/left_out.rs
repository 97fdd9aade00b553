//! Judged on what the fit has not seen: every other angle, and every airspeed in turn.

use crate::calibration::AirspeedCalibration;
use crate::campaign::{TIP, TipReading};
use crate::fit::{FlowGroup, Problem};
use crate::objective::{LineFit, objective, rmse};
use crate::schedule::{CorrectionSet, Schedule};
use crate::statics::{Angle, StaticData};
use crate::tip_zero::TipZero;
use aero::{Corrections, Flow};
use coupling::{CouplingError, SteadyCase, SteadyModel};

/// Angles predicted by a fit to the others.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// The angles left out, rad.
    pub alphas_rad: Vec<f64>,
    /// Paper 1, Eq. 8 of the uncorrected model at these angles.
    pub objective_before: f64,
    /// Paper 1, Eq. 8 of the model corrected by the other angles.
    pub objective_after: f64,
    /// Paper 1, Eq. 8 of these angles about the straight lines through the angles that were fitted.
    pub line_error: f64,
}

/// An airspeed predicted from its neighbours' corrections.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOutAirspeed {
    /// Paper 1, Eq. 8 of the uncorrected model.
    pub objective_before: f64,
    /// Eq. 8 of paper 1 with the corrections that the schedule of the other airspeeds gives here.
    pub objective_after: f64,
}

/// Fits every other angle (both ends included) and predicts the rest; none with fewer than five angles.
pub(crate) fn left_out_angles<M: SteadyModel>(
    problem: &Problem<'_, M>,
    line: &LineFit,
) -> Result<Option<LeftOut>, CouplingError> {
    let [FlowGroup { flow, angles }] = problem.groups[..] else { return Ok(None) };
    if angles.len() < 5 {
        return Ok(None);
    }
    let kept: Vec<Angle> = angles.iter().step_by(2).cloned().collect();
    let unseen: Vec<Angle> = angles.iter().skip(1).step_by(2).cloned().collect();
    let weights = problem.weights;
    let free_zero = problem.zero.count() > 0;
    let about = |angles: &[Angle]| line_through(&kept, angles, problem.channels);
    let fit = Problem {
        groups: vec![FlowGroup { flow, angles: &kept }],
        zero: TipZero::new(vec![0; kept.len()], free_zero),
        line_floor: objective(rmse(&about(&kept), problem.channels), weights),
        ..*problem
    }
    .fit()?;
    let error = |corrections: &Corrections| {
        let residuals =
            |angles: &[Angle]| predicted(problem.model, problem.channels[TIP], flow, angles, corrections);
        let mut missed = residuals(&unseen)?;
        if free_zero {
            // the zero is that of the angles that were fitted
            take_out(&mut missed, mean_tip(&residuals(&kept)?));
        }
        Ok::<f64, CouplingError>(objective(rmse(&missed, problem.channels), weights))
    };
    // Their own scatter about a line: about the line of all angles where that is larger, because a line
    // through few angles may hit the unseen ones by chance.
    let own: Vec<[f64; 4]> = line.residuals.iter().skip(1).step_by(2).copied().collect();
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
    data: &StaticData,
) -> Result<Vec<Option<LeftOutAirspeed>>, CouplingError> {
    let mut results = Vec::with_capacity(airspeeds.len());
    for (index, airspeed) in airspeeds.iter().enumerate() {
        let others: Vec<CorrectionSet> = airspeeds
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index)
            .map(|(_, other)| CorrectionSet {
                v_m_s: other.data.v_m_s,
                corrections: other.corrections.clone(),
            })
            .collect();
        if others.is_empty() {
            results.push(None);
            continue;
        }
        let schedule =
            Schedule { wing: String::new(), wing_hash: String::new(), sets: others, unconverged: Vec::new() };
        let v_m_s = airspeed.data.v_m_s;
        // the slowest and the fastest airspeed lie outside of the others: the nearest set is what a user would take
        let (corrections, _) = schedule.at_or_nearest(v_m_s);
        let flow = Flow { v_m_s, rho_kg_m3 };
        let mut residuals = predicted(model, data.channels[TIP], flow, &airspeed.data.angles, &corrections)?;
        if data.tip == TipReading::FreeZero {
            let mean = mean_tip(&residuals);
            take_out(&mut residuals, mean);
        }
        results.push(Some(LeftOutAirspeed {
            objective_before: airspeed.fit.objective[0],
            objective_after: objective(rmse(&residuals, data.channels), airspeed.weights),
        }));
    }
    Ok(results)
}

/// Simulated minus measured, the tip's if asked for.
fn predicted<M: SteadyModel>(
    model: &M,
    with_tip: bool,
    flow: Flow,
    angles: &[Angle],
    corrections: &Corrections,
) -> Result<Vec<[f64; 4]>, CouplingError> {
    let cases: Vec<SteadyCase> = angles.iter().map(|angle| SteadyCase::new(flow, angle.alpha_rad)).collect();
    let loads = model.root_loads(&cases, corrections)?;
    let tips = if with_tip { model.tip_deflections(&cases, corrections)? } else { vec![0.0; cases.len()] };
    let residual = |((load, tip), angle): ((&coupling::RootLoads, &f64), &Angle)| {
        let ([fz, mx, my], measured) = (load.to_array(), angle.readings());
        let simulated = [fz, mx, my, *tip];
        std::array::from_fn(|c| simulated[c] - measured[c])
    };
    Ok(loads.iter().zip(&tips).zip(angles).map(residual).collect())
}

fn mean_tip(residuals: &[[f64; 4]]) -> f64 {
    residuals.iter().map(|row| row[TIP]).sum::<f64>() / residuals.len() as f64
}

fn take_out(residuals: &mut [[f64; 4]], mean: f64) {
    for row in residuals {
        row[TIP] -= mean;
    }
}

/// Residuals of `angles` about the least-squares straight lines through `kept`.
fn line_through(kept: &[Angle], angles: &[Angle], channels: [bool; 4]) -> Vec<[f64; 4]> {
    let count = kept.len() as f64;
    let mean = kept.iter().map(|angle| angle.alpha_rad).sum::<f64>() / count;
    let spread: f64 = kept.iter().map(|angle| (angle.alpha_rad - mean).powi(2)).sum();
    let line = |c: usize| {
        let level = kept.iter().map(|angle| angle.readings()[c]).sum::<f64>() / count;
        let slope =
            kept.iter().map(|angle| (angle.alpha_rad - mean) * angle.readings()[c]).sum::<f64>() / spread;
        (level, slope)
    };
    let lines: [(f64, f64); 4] = std::array::from_fn(line);
    let about = |angle: &Angle| {
        std::array::from_fn(|c| {
            let (level, slope) = lines[c];
            if channels[c] { angle.readings()[c] - level - slope * (angle.alpha_rad - mean) } else { 0.0 }
        })
    };
    angles.iter().map(about).collect()
}
