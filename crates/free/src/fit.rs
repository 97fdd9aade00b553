//! The rig with chosen effects fitted to oscillations: the most probable parameters, and the evidence (Laplace).

use crate::balance::{Model, RESIDUALS, Whitening};
use crate::effect::{Active, Effect};
use crate::least_squares::{minimise, normal};
use crate::points::Point;
use crate::rig::{LINEAR, Rig};
use nalgebra::{DMatrix, DVector};
use std::collections::{BTreeMap, BTreeSet};

/// Standard deviation of the angle from the mean of motion to where the pitch spring is at rest, rad: two degrees.
const CENTRE_SD_RAD: f64 = 0.035;
/// Rounds in which what residuals are divided by follows the model: by how much the scatter is wider in each. Narrow from the
/// start, a fit ends in the first hollow.
const ROUNDS: [f64; 3] = [2.0, 1.0, 1.0];
/// Rounds from each of several starts.
const TRIED: [f64; 2] = [5.0, 1.0];
/// Linear parameters stay within so many standard deviations.
const WITHIN_SD: f64 = 6.0;

/// What is fitted.
#[derive(Debug, Clone)]
pub struct Problem<'a> {
    rig: &'a Rig,
    points: &'a [Point],
    days: Vec<u32>,
}

/// A fitted rig.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// Its effects.
    pub effects: Vec<Effect>,
    /// Parameters in standard deviations: the linear rig's, the centre, stiffness and damping of each day, the effects'.
    pub x: Vec<f64>,
    /// Standard deviations of `x` after the fit.
    pub sd: Vec<f64>,
    /// Log evidence.
    pub log_evidence: f64,
    /// Sum of squared residuals, in standard deviations.
    pub chi2: f64,
    /// Log likelihood by day, without a constant that all models share.
    pub log_likelihood: BTreeMap<u32, f64>,
    days: Vec<u32>,
}

impl Fitted {
    /// The model of a day; of one without data, that of the nearest day.
    pub fn model(&self, rig: &Rig, day: u32) -> Model {
        model(rig, &self.days, &self.effects, &self.x, day)
    }

    /// Values of the effects' parameters with their standard deviations, on the day that is nearest.
    pub fn values(&self) -> Vec<(Effect, Vec<[f64; 2]>)> {
        let mut at = LINEAR + 1 + 2 * self.days.len();
        let of = |effect: &Effect| {
            let parameters = effect.parameters();
            let values = parameters
                .iter()
                .zip(at..)
                .map(|(p, k)| [p.centre + p.plausible * self.x[k], p.plausible * self.sd[k]]);
            let values = values.collect();
            at += parameters.len();
            (*effect, values)
        };
        self.effects.iter().map(of).collect()
    }

    /// With the evidence and the standard deviations that a curvature `J'J` gives.
    fn with_curvature(mut self, normal: DMatrix<f64>) -> Self {
        if let Some(factor) = normal.cholesky() {
            self.log_evidence = self.log_posterior() - factor.l().diagonal().map(f64::ln).sum();
            self.sd = factor.inverse().diagonal().iter().map(|v| v.sqrt()).collect();
        }
        self
    }

    /// Log of the posterior density, without a constant.
    fn log_posterior(&self) -> f64 {
        self.log_likelihood.values().sum::<f64>() - 0.5 * self.x.iter().map(|x| x * x).sum::<f64>()
    }
}

fn model(rig: &Rig, days: &[u32], effects: &[Effect], x: &[f64], day: u32) -> Model {
    let nearest = (0..days.len()).min_by_key(|k| days[*k].abs_diff(day));
    let factor = |first: usize, sd: f64| nearest.map_or(1.0, |k| (sd * x[first + k]).exp());
    let stiffness = factor(LINEAR + 1, rig.day_stiffness_sd);
    let damping = factor(LINEAR + 1 + days.len(), rig.day_damping_sd);
    let mut at = LINEAR + 1 + 2 * days.len();
    let active = effects.iter().map(|effect| {
        let parameters = effect.parameters();
        let mut values: Vec<f64> =
            parameters.iter().zip(&x[at..]).map(|(p, x)| p.centre + p.plausible * x).collect();
        at += parameters.len();
        if *effect == Effect::DryPitch {
            values[0] *= damping;
        }
        Active { effect: *effect, values }
    });
    let effects = active.collect();
    Model { rig: rig.at(&x[..LINEAR]), effects, centre_rad: CENTRE_SD_RAD * x[LINEAR], stiffness, damping }
}

impl<'a> Problem<'a> {
    /// Of a rig and its points.
    pub fn new(rig: &'a Rig, points: &'a [Point]) -> Self {
        let days: BTreeSet<u32> = points.iter().map(|point| point.day).collect();
        Self { rig, points, days: days.into_iter().collect() }
    }

    /// Number of residuals.
    pub fn residuals(&self) -> usize {
        self.points.len() * RESIDUALS
    }

    fn fixed(&self) -> usize {
        LINEAR + 1 + 2 * self.days.len()
    }

    /// Fits effects beside what was fitted before, perhaps to other points or with fewer effects. What was fitted before is
    /// among the starts, so that a model is never worse than a part of it.
    pub fn fit(&self, effects: &[Effect], before: Option<&Fitted>) -> Fitted {
        let parameters: Vec<_> = effects.iter().flat_map(|effect| effect.parameters()).collect();
        let mut bounds = vec![[-WITHIN_SD, WITHIN_SD]; self.fixed()];
        bounds.extend(parameters.iter().map(|p| p.bounds.map(|bound| (bound - p.centre) / p.plausible)));
        let starts = self.starts(effects, before);
        let tried = starts.iter().map(|start| self.rounds(effects, start.clone(), &bounds, &TRIED));
        let first = self.rounds(effects, starts[0].clone(), &bounds, &[]);
        let best = tried.fold(first, better);
        let best = better(self.rounds(effects, best.x.clone(), &bounds, &ROUNDS), best);
        let whitenings = self.whitenings(effects, &best.x, 1.0);
        let still = |x: &[f64]| self.stacked(effects, x, &whitenings);
        let curvature = normal(&still, &best.x, &bounds);
        best.with_curvature(curvature)
    }

    fn starts(&self, effects: &[Effect], before: Option<&Fitted>) -> Vec<Vec<f64>> {
        let mut linear = vec![0.0; self.fixed()];
        let mut known = BTreeMap::new();
        if let Some(before) = before {
            let same = if before.days == self.days { self.fixed() } else { LINEAR };
            linear[..same].copy_from_slice(&before.x[..same]);
            let mut at = LINEAR + 1 + 2 * before.days.len();
            for effect in &before.effects {
                let length = effect.parameters().len();
                known.insert(*effect, before.x[at..at + length].to_vec());
                at += length;
            }
        }
        let mut starts = vec![linear];
        for effect in effects {
            let here = known.get(effect).map_or_else(|| effect.starts(), |x| vec![x.clone()]);
            starts =
                here.iter().flat_map(|x| starts.iter().map(|s| [s.clone(), x.clone()].concat())).collect();
        }
        starts
    }

    fn rounds(&self, effects: &[Effect], start: Vec<f64>, bounds: &[[f64; 2]], widths: &[f64]) -> Fitted {
        let mut x = start;
        for width in widths {
            let whitenings = self.whitenings(effects, &x, *width);
            x = minimise(&|x: &[f64]| self.stacked(effects, x, &whitenings), &x, bounds);
        }
        self.described(effects, x)
    }

    fn models(&self, effects: &[Effect], x: &[f64]) -> BTreeMap<u32, Model> {
        self.days.iter().map(|day| (*day, model(self.rig, &self.days, effects, x, *day))).collect()
    }

    fn whitenings(&self, effects: &[Effect], x: &[f64], width: f64) -> Vec<Whitening> {
        let models = self.models(effects, x);
        self.points.iter().map(|p| models[&p.day].whitening(p, &self.rig.scatter, width)).collect()
    }

    fn stacked(&self, effects: &[Effect], x: &[f64], whitenings: &[Whitening]) -> DVector<f64> {
        let models = self.models(effects, x);
        let whitened =
            |(point, whitening): (&Point, &Whitening)| models[&point.day].whitened(point, whitening);
        let of_points = self.points.iter().zip(whitenings).flat_map(whitened);
        DVector::from_iterator(self.residuals() + x.len(), of_points.chain(x.iter().copied()))
    }

    fn described(&self, effects: &[Effect], x: Vec<f64>) -> Fitted {
        let whitenings = self.whitenings(effects, &x, 1.0);
        let left = self.stacked(effects, &x, &whitenings);
        let mut log_likelihood = BTreeMap::new();
        for (k, (point, whitening)) in self.points.iter().zip(&whitenings).enumerate() {
            let squares = left.rows(k * RESIDUALS, RESIDUALS).norm_squared();
            *log_likelihood.entry(point.day).or_default() -= 0.5 * squares + whitening.log_volume;
        }
        Fitted {
            effects: effects.to_vec(),
            sd: vec![f64::INFINITY; x.len()],
            x,
            log_evidence: f64::NEG_INFINITY,
            chi2: left.rows(0, self.residuals()).norm_squared(),
            log_likelihood,
            days: self.days.clone(),
        }
    }
}

/// The more probable one, of the same effects.
fn better(a: Fitted, b: Fitted) -> Fitted {
    if a.log_posterior() >= b.log_posterior() { a } else { b }
}
