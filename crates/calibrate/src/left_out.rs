//! Judged on what the fit has not seen: every other angle, and every airspeed in turn.
//!
//! What is left out is left out from the rows on: offsets of blocks, noise and the metric of change are found again from the
//! rest, so that no number that was read at it has a part in what predicts it.

use crate::calibration::{AirspeedCalibration, Context};
use crate::campaign::{Campaign, TIP, TipReading};
use crate::member::CorrectionSet;
use crate::objective::{LineFit, objective, rmse};
use crate::schedule::Schedule;
use crate::statics::Angle;
use aero::{Corrections, Flow};
use coupling::{CouplingError, SteadyCase, SteadyModel};
use rayon::prelude::*;

/// Angles predicted by a fit to the others.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// The angles left out, rad.
    pub alphas_rad: Vec<f64>,
    /// The corrections that the other angles give.
    pub corrections: Corrections,
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
    /// The corrections that the schedule of the other airspeeds gives here.
    pub corrections: Corrections,
    /// Paper 1, Eq. 8 of the uncorrected model.
    pub objective_before: f64,
    /// Eq. 8 of paper 1 with these corrections.
    pub objective_after: f64,
}

/// Fits every other angle (both ends included) and predicts the rest; none with fewer than five angles.
pub(crate) fn left_out_angles<M: SteadyModel>(
    context: &Context<'_, M>,
    campaign: &Campaign,
    index: usize,
    line: &LineFit,
) -> Result<Option<LeftOut>, CouplingError> {
    if context.data.airspeeds[index].angles.len() < 5 {
        return Ok(None);
    }
    let (data, unseen) =
        context.data.without(campaign, |airspeed, angle| airspeed == index && angle % 2 == 1);
    let seen = Context::new(context.model, context.rho_kg_m3, &data, context.settings);
    let (kept, unseen) = (&data.airspeeds[index], &unseen[0]);
    let channels = data.channels;
    let corrections = seen.corrections(kept)?;
    let flow = |v_m_s: f64| Flow { v_m_s, rho_kg_m3: context.rho_kg_m3 };
    let weights = context.weights(&[flow(unseen.v_m_s)])?;
    let error = |corrections: &Corrections| {
        let residuals =
            |v_m_s, angles| predicted(context.model, channels[TIP], flow(v_m_s), angles, corrections);
        let mut missed = residuals(unseen.v_m_s, &unseen.angles)?;
        if data.tip == TipReading::FreeZero {
            // the zero is that of the angles that were fitted
            take_out(&mut missed, mean_tip(&residuals(kept.v_m_s, &kept.angles)?));
        }
        Ok::<f64, CouplingError>(objective(rmse(&missed, channels), weights))
    };
    // Their own scatter about a line: about the line of all angles where that is larger, because a line
    // through few angles may hit the unseen ones by chance.
    let own: Vec<[f64; 4]> = line.residuals.iter().skip(1).step_by(2).copied().collect();
    let about = line_through(&kept.angles, &unseen.angles, channels);
    let line_error = objective(rmse(&about, channels), weights).max(objective(rmse(&own, channels), weights));
    Ok(Some(LeftOut {
        alphas_rad: unseen.angles.iter().map(|angle| angle.alpha_rad).collect(),
        objective_before: error(&Corrections::neutral(corrections.len()))?,
        objective_after: error(&corrections)?,
        line_error,
        corrections,
    }))
}

/// Each airspeed with the corrections interpolated from the others (the nearest at the ends).
pub(crate) fn left_out_airspeeds<M: SteadyModel>(
    context: &Context<'_, M>,
    campaign: &Campaign,
    airspeeds: &[AirspeedCalibration],
) -> Result<Vec<Option<LeftOutAirspeed>>, CouplingError> {
    if airspeeds.len() < 2 {
        return Ok(vec![None; airspeeds.len()]);
    }
    let one = |index: usize| {
        let (data, unseen) = context.data.without(campaign, |airspeed, _| airspeed == index);
        let seen = Context::new(context.model, context.rho_kg_m3, &data, context.settings);
        let unseen = &unseen[0];
        // only its neighbours have a part in it: with it, they have indices one higher
        let neighbours = [index.checked_sub(1), Some(index)].into_iter().flatten();
        let set = |neighbour: usize| {
            let kept = data.airspeeds.get(neighbour)?;
            let known = &airspeeds[neighbour + usize::from(neighbour >= index)];
            // what it gave to neither noise nor offsets was fitted without it already
            let unchanged = known.data == *kept && context.data.point_sigma == data.point_sigma;
            let corrections = if unchanged { Ok(known.corrections.clone()) } else { seen.corrections(kept) };
            Some(corrections.map(|corrections| CorrectionSet { v_m_s: kept.v_m_s, corrections }))
        };
        let sets = neighbours.filter_map(set).collect::<Result<Vec<_>, CouplingError>>()?;
        let schedule = Schedule {
            wing: String::new(),
            wing_hash: String::new(),
            sets,
            found: None,
            unconverged: Vec::new(),
        };
        // the slowest and the fastest airspeed lie outside of the others: the nearest set is what a user would take
        let (corrections, _) = schedule.at_or_nearest(unseen.v_m_s);
        let flow = Flow { v_m_s: unseen.v_m_s, rho_kg_m3: context.rho_kg_m3 };
        let error = |corrections: &Corrections| {
            let mut residuals =
                predicted(context.model, data.channels[TIP], flow, &unseen.angles, corrections)?;
            if data.tip == TipReading::FreeZero {
                let mean = mean_tip(&residuals);
                take_out(&mut residuals, mean);
            }
            Ok::<f64, CouplingError>(objective(rmse(&residuals, data.channels), airspeeds[index].weights))
        };
        Ok(Some(LeftOutAirspeed {
            objective_before: error(&Corrections::neutral(corrections.len()))?,
            objective_after: error(&corrections)?,
            corrections,
        }))
    };
    (0..airspeeds.len()).into_par_iter().map(one).collect()
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

#[cfg(test)]
mod tests;
