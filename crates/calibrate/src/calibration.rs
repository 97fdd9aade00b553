//! The whole calibration: every airspeed for itself and in parallel, then what they say together; or one set for all.

use crate::basis::Basis;
use crate::bounds::{Bounds, bounds};
use crate::campaign::{Campaign, Sets, TIP, TipReading};
use crate::checks::{self, Checked, Finding, Weight, trust};
use crate::common::CommonCalibration;
use crate::fit::{Ending, Fit, Floor, FlowGroup, Problem};
use crate::identifiability::{Identifiability, Inputs, identifiability};
use crate::left_out::{LeftOut, LeftOutAirspeed, left_out_airspeeds, left_out_angles};
use crate::lift_factor::{LiftFactor, lift_factor};
use crate::member::Member;
use crate::objective::{LineFit, line_fit, line_fit_of, objective};
use crate::settings::Settings;
use crate::statics::{AirspeedData, StaticData};
use crate::tip_zero::TipZero;
use aero::{Corrections, Flow};
use coupling::{ByLoad, CouplingError, SteadyCase, SteadyModel};
use faer::Mat;
use nastran::InputError;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Corrections of one airspeed and how good they are.
#[derive(Debug, Clone)]
pub struct AirspeedCalibration {
    /// The data that were fitted.
    pub data: AirspeedData,
    /// Corrections of the wing's boxes.
    pub corrections: Corrections,
    /// The sequence of cone programs.
    pub fit: Fit,
    /// Straight lines through the data (of a wing that bends far: through what it misses), their error, tests for nonlinearity.
    pub line: LineFit,
    /// Weights of paper 1, Eq. 8: the settings', and the tip's in N m/m (zero if it is not fitted).
    pub weights: [f64; 4],
    /// Paper 1, Eq. 8 of the straight lines; of a wing that bends far, those through what it misses: it has a curvature of its own.
    pub line_floor: f64,
    /// Eq. 8 of paper 1 that noise alone gives; none if noise is not known.
    pub noise_floor: Option<f64>,
    /// What the data can tell.
    pub identifiability: Option<Identifiability>,
    /// Factor on all loads of the theory that fits best; only where the tip is fitted.
    pub lift: Option<LiftFactor>,
    /// Every other angle left out of a fit and predicted.
    pub left_out: Option<LeftOut>,
    /// This airspeed left out and predicted from its neighbours' corrections.
    pub left_out_airspeed: Option<LeftOutAirspeed>,
}

/// What tilting the wing with wind off says about its weight and arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightTare {
    /// Rows.
    pub points: usize,
    /// Root mean square of measured minus modelled weight, by channel (N, N m, N m).
    pub rms: ByLoad<f64>,
    /// The same over the standard deviation of a row; none if noise is not known.
    pub rms_over_noise: Option<ByLoad<f64>>,
}

/// A finished calibration.
#[derive(Debug, Clone)]
pub struct Calibration {
    /// Airspeeds in ascending order; empty if one set serves all.
    pub airspeeds: Vec<AirspeedCalibration>,
    /// The set that serves all airspeeds, if the campaign asks for one.
    pub common: Option<CommonCalibration>,
    /// Air density of the campaign, kg/m³.
    pub rho_kg_m3: f64,
    /// The data behind them: blocks, noise, what was left aside.
    pub data: StaticData,
    /// Weight tares, if the campaign has any.
    pub weight_tare: Option<WeightTare>,
    /// Probability below which a single test for nonlinearity is significant (the setting shared by all tests).
    pub nonlinearity_level: f64,
    /// What the checks of the data found.
    pub findings: Vec<Finding>,
    /// Lines of rows that no others bear out, which were not fitted.
    pub set_aside: Vec<usize>,
    /// The wing with the structure and surfaces that were found, and its corrections; none before [`Calibration::with_means`], or from root loads alone.
    pub found: Option<Member>,
}

/// Finds corrections for every airspeed of a campaign.
///
/// # Errors
/// Bad data (an airspeed with fewer than three angles), or a wing that diverges at one of the airspeeds.
pub fn calibrate<M: SteadyModel>(
    model: &M,
    campaign: &Campaign,
    settings: &Settings,
) -> Result<Calibration, CouplingError> {
    let data = StaticData::from_campaign(campaign)?;
    check_settings(model, settings, &data)?;
    check_divergence(model, campaign.rho_kg_m3, &data)?;
    let Checked { campaign, data, mut findings, set_aside } = checks::check(model, campaign, data)?;
    let context = Context::new(model, campaign.rho_kg_m3, &data, settings);
    let (each, common) = match data.sets {
        Sets::EachAirspeed => (&data.airspeeds[..], None),
        Sets::Common => (&[][..], Some(context.common()?)),
    };
    let done = AtomicUsize::new(0);
    let fitted = |(index, airspeed): (usize, &AirspeedData)| {
        let fitted = context.airspeed(airspeed).and_then(|fitted| {
            let predicted = || left_out_angles(&context, &campaign, index, &fitted.line);
            let left_out = if settings.left_out { predicted()? } else { None };
            Ok(AirspeedCalibration { left_out, ..fitted })
        });
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        tracing::trace!(target: "progress", what = "airspeeds", done, total = each.len());
        fitted
    };
    let mut airspeeds = each.par_iter().enumerate().map(fitted).collect::<Result<Vec<_>, _>>()?;
    let across =
        if settings.left_out { left_out_airspeeds(&context, &campaign, &airspeeds)? } else { Vec::new() };
    for (airspeed, left_out) in airspeeds.iter_mut().zip(across) {
        airspeed.left_out_airspeed = left_out;
    }
    let least = settings.least_factor;
    findings.extend(
        airspeeds
            .iter()
            .filter_map(|at| trust::factors(&at.corrections, &format!("at {} m/s", at.data.v_m_s), least)),
    );
    if let Some(set) = &common {
        findings.extend(trust::factors(&set.corrections, "at all airspeeds", least));
        findings.extend(trust::deflections(&context, set)?);
    }
    for Finding { sentence, weight } in &findings {
        let from = campaign.folder.display();
        match weight {
            Weight::Open => tracing::info!("{from}: {sentence}"),
            Weight::Suspicion | Weight::Defect => tracing::warn!("{from}: {sentence}"),
        }
    }
    let tests = airspeeds.iter().flat_map(|a| a.line.nonlinearity).flatten().count().max(1);
    Ok(Calibration {
        weight_tare: weight_tare(model, campaign.rho_kg_m3, &data)?,
        findings,
        set_aside,
        found: None,
        nonlinearity_level: settings.significance / tests as f64,
        airspeeds,
        common,
        rho_kg_m3: campaign.rho_kg_m3,
        data,
    })
}

/// An airspeed at which the uncorrected wing diverges is a mistake in the data or in the wing.
fn check_divergence<M: SteadyModel>(
    model: &M,
    rho_kg_m3: f64,
    data: &StaticData,
) -> Result<(), CouplingError> {
    let neutral = Corrections::neutral(model.correctable().len());
    let loads = |airspeed: &AirspeedData| {
        let case = SteadyCase::new(Flow { v_m_s: airspeed.v_m_s, rho_kg_m3 }, 0.0);
        model.root_loads(&[case], &neutral)
    };
    let all: Vec<_> = data.airspeeds.par_iter().map(loads).collect();
    for (airspeed, loads) in data.airspeeds.iter().zip(all) {
        match loads {
            Err(CouplingError::Diverged { divergence_pa, .. }) => {
                let speed = divergence_pa.map_or_else(String::new, |q_pa| {
                    format!(", its divergence speed is {:.2} m/s", (2.0 * q_pa / rho_kg_m3).sqrt())
                });
                let message = format!("the wing diverges at {} m/s{speed}", airspeed.v_m_s);
                return Err(InputError::at(&airspeed.span, message)
                    .with_help("take the airspeed out of the static cases, or check the wing's stiffness and that airspeeds are in m/s")
                    .into());
            }
            Err(error) => return Err(error),
            Ok(_) => {}
        }
    }
    Ok(())
}

fn check_settings<M: SteadyModel>(
    model: &M,
    settings: &Settings,
    data: &StaticData,
) -> Result<(), InputError> {
    if data.channels[TIP] && !model.has_tip() {
        return Err(InputError::general("the campaign fits tip deflections, but the wing is rigid")
            .with_help("give the wing a structure, or write `tip: Unused` in campaign.ron"));
    }
    if let Some(sensor) = data.sensors.iter().find(|sensor| sensor.reads.is_shape() && !model.has_tip()) {
        let message = format!("sensor `{}` reads the wing's shape, but the wing is rigid", sensor.column);
        return Err(InputError::general(message)
            .with_help("give the wing a structure, or take the sensor out of campaign.ron"));
    }
    let boxes = model.correctable();
    let rows = boxes.chord_rows.iter().copied().min().unwrap_or(0);
    if settings.chord_strips == 0 || settings.chord_strips > rows {
        return Err(InputError::general(format!(
            "{} chordwise strips of corrections on a wing of {rows} chordwise boxes",
            settings.chord_strips
        ))
        .with_help("take a number from 1 to the number of chordwise boxes"));
    }
    Ok(())
}

/// What all airspeeds share.
pub(crate) struct Context<'a, M: SteadyModel> {
    pub(crate) model: &'a M,
    pub(crate) rho_kg_m3: f64,
    pub(crate) data: &'a StaticData,
    pub(crate) settings: &'a Settings,
    pub(crate) basis: Basis,
    pub(crate) bounds: Bounds,
}

impl<'a, M: SteadyModel> Context<'a, M> {
    pub(crate) fn new(model: &'a M, rho_kg_m3: f64, data: &'a StaticData, settings: &'a Settings) -> Self {
        let boxes = model.correctable();
        let basis = Basis::new(boxes, settings.chord_strips, settings.span_order);
        let bounds = bounds(&basis, boxes, settings.neighbour_bound, settings.least_factor);
        Self { model, rho_kg_m3, data, settings, basis, bounds }
    }

    /// The fit of one airspeed.
    pub(crate) fn problem<'b>(
        &'b self,
        airspeed: &'b AirspeedData,
        line: &LineFit,
        metric: &'b Mat<f64>,
    ) -> Result<Problem<'b, M>, CouplingError> {
        let flow = Flow { v_m_s: airspeed.v_m_s, rho_kg_m3: self.rho_kg_m3 };
        let weights = self.weights(&[flow])?;
        Ok(Problem {
            model: self.model,
            groups: vec![FlowGroup { flow, angles: &airspeed.angles }],
            channels: self.data.channels,
            weights,
            zero: TipZero::new(vec![0; airspeed.angles.len()], self.data.tip == TipReading::FreeZero),
            basis: &self.basis,
            bounds: &self.bounds,
            metric,
            settings: self.settings,
            floor: if self.model.bends_far() {
                Floor::OfMisses
            } else {
                Floor::Known(objective(line.rmse, weights))
            },
            noise_floor: self.data.noise_floor(airspeed, weights).unwrap_or(0.0),
            start: 1.0,
            slack: 1.0,
        })
    }

    /// Corrections of one airspeed.
    pub(crate) fn corrections(&self, airspeed: &AirspeedData) -> Result<Corrections, CouplingError> {
        let metric = self.metric(std::slice::from_ref(airspeed))?;
        let fit = self.problem(airspeed, &line_fit(self.data, airspeed), &metric)?.fit()?;
        Ok(self.basis.corrections(&fit.x))
    }

    fn airspeed(&self, airspeed: &AirspeedData) -> Result<AirspeedCalibration, CouplingError> {
        let line = line_fit(self.data, airspeed);
        let metric = self.metric(std::slice::from_ref(airspeed))?;
        let problem = self.problem(airspeed, &line, &metric)?;
        let fit = problem.fit()?;
        let solution = problem.linearise(&fit.x)?;
        let line = if self.model.bends_far() {
            line_fit_of(self.data, airspeed, &problem.misses(&solution.sensitivities))
        } else {
            line
        };
        let point_sigma = self.data.point_sigma.unwrap_or(line.rmse);
        Ok(AirspeedCalibration {
            corrections: self.basis.corrections(&fit.x),
            identifiability: identifiability(
                &solution,
                &Inputs {
                    basis: &self.basis,
                    area_share: &self.model.correctable().area_share,
                    metric: &metric,
                    prior_spread: self.settings.prior_spread,
                    channels: self.data.channels,
                    angles: airspeed.angles.iter().collect(),
                    zero: &problem.zero,
                    point_sigma,
                    common_sigma: self.data.common_sigma(),
                },
            ),
            lift: if self.data.channels[TIP] { lift_factor(&problem, point_sigma)? } else { None },
            left_out: None,
            left_out_airspeed: None,
            data: airspeed.clone(),
            line_floor: fit.floor,
            fit,
            weights: problem.weights,
            noise_floor: self.data.noise_floor(airspeed, problem.weights),
            line,
        })
    }

    /// Weights of paper 1, Eq. 8, the tip's in N m/m: see `Settings::tip_weight`.
    pub(crate) fn weights(&self, flows: &[Flow]) -> Result<[f64; 4], CouplingError> {
        let ByLoad { fz, mx, my } = self.settings.weights;
        if !self.data.channels[TIP] {
            return Ok([fz, mx, my, 0.0]);
        }
        let neutral = Corrections::neutral(self.model.correctable().len());
        let (mut moments_nm, mut heights_m) = (0.0, 0.0);
        for &flow in flows {
            let cases = [-0.01, 0.01].map(|alpha_rad| SteadyCase::new(flow, alpha_rad));
            let [down, up] = &self.model.root_loads(&cases, &neutral)?[..] else { continue };
            let tips = self.model.tip_deflections(&cases, &neutral)?;
            moments_nm += (up.mx_nm - down.mx_nm).abs();
            heights_m += (tips[1] - tips[0]).abs();
        }
        Ok([fz, mx, my, self.settings.tip_weight * moments_nm / heights_m.max(f64::MIN_POSITIVE)])
    }

    /// Metric of change in units of the theoretical pressures (rms over boxes and angles).
    pub(crate) fn metric(&self, airspeeds: &[AirspeedData]) -> Result<Mat<f64>, CouplingError> {
        let shares = &self.model.correctable().area_share;
        let (mut mean_square, mut count) = (0.0, 0.0);
        for airspeed in airspeeds {
            let flow = Flow { v_m_s: airspeed.v_m_s, rho_kg_m3: self.rho_kg_m3 };
            for angle in &airspeed.angles {
                let cp = self.model.pressure_coefficients(&SteadyCase::new(flow, angle.alpha_rad))?;
                mean_square += cp.iter().zip(shares).map(|(cp, share)| share * cp * cp).sum::<f64>();
                count += 1.0;
            }
        }
        mean_square /= count;
        Ok(self.basis.change_metric(shares, [1.0, 1.0, 1.0 / mean_square.max(f64::MIN_POSITIVE)]))
    }
}

/// Compares weight tares with the modelled weight.
fn weight_tare<M: SteadyModel>(
    model: &M,
    rho_kg_m3: f64,
    data: &StaticData,
) -> Result<Option<WeightTare>, CouplingError> {
    if data.weight_tares.is_empty() {
        return Ok(None);
    }
    let neutral = Corrections::neutral(model.correctable().len());
    let cases: Vec<SteadyCase> = data
        .weight_tares
        .iter()
        .map(|point| SteadyCase::new(Flow { v_m_s: 0.0, rho_kg_m3 }, point.alpha_rad))
        .collect();
    let loads = model.root_loads(&cases, &neutral)?;
    let rms = ByLoad::from_fn(|load| {
        let squares = data.weight_tares.iter().zip(&loads).filter_map(|(point, modelled)| {
            let modelled = ByLoad::from(*modelled)[load];
            point.loads[load as usize].map(|measured| (measured - modelled).powi(2))
        });
        (squares.sum::<f64>() / data.weight_tares.len() as f64).sqrt()
    });
    let over =
        |sigma: [f64; 4]| ByLoad::from_fn(|load| rms[load] / sigma[load as usize].max(f64::MIN_POSITIVE));
    Ok(Some(WeightTare { points: data.weight_tares.len(), rms, rms_over_noise: data.point_sigma.map(over) }))
}

impl Calibration {
    /// Endings that are not a success.
    pub fn failures(&self) -> Vec<(f64, Ending)> {
        let bad = |ending: &Ending| {
            !matches!(ending, Ending::Converged | Ending::AtNoiseFloor | Ending::PosteriorMean)
        };
        let common = self.common.iter().map(|common| (common.v_range_m_s[1], common.fit.ending));
        let each = self.airspeeds.iter().map(|a| (a.data.v_m_s, a.fit.ending));
        each.chain(common).filter(|(_, ending)| bad(ending)).collect()
    }

    /// Why the corrections are not to be trusted, a sentence each: fits that did not reach their floor, defects of the data.
    pub fn faults(&self) -> Vec<String> {
        let list: Vec<String> =
            self.failures().iter().map(|(v, ending)| format!("{v} m/s: {ending:?}")).collect();
        let fits =
            (!list.is_empty()).then(|| format!("the fit did not reach its floor at {}", list.join(", ")));
        self.said(&[Weight::Defect]).into_iter().chain(fits).collect()
    }

    /// What the checks of the data say with these weights.
    pub fn said(&self, weights: &[Weight]) -> Vec<String> {
        let of = self.findings.iter().filter(|finding| weights.contains(&finding.weight));
        of.map(|finding| finding.sentence.clone()).collect()
    }

    /// Cone programs of the main fits.
    pub fn cone_programs(&self) -> usize {
        let common = self.common.iter().map(|common| common.fit.cone_programs);
        self.airspeeds.iter().map(|airspeed| airspeed.fit.cone_programs).chain(common).sum()
    }
}

#[cfg(test)]
mod tests;
