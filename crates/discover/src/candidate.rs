//! A candidate effect beside those found: screened by secants, fitted in the full simulation, with its log Bayes factor.

use crate::current_model::CurrentModel;
use crate::rules::{NamingRules, SharedRules};
use crate::setting::Setting;
use crate::shared::LinearStep;
use crate::trial::{Base, Point, Trial, difference};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use maneuver::effects::{Active, Effect, Parameter};
use std::sync::Arc;

/// A candidate and what screening says of it.
#[derive(Debug, Clone)]
pub struct Screened {
    /// The effect.
    pub effect: Arc<dyn Effect>,
    /// Secants by parameter, per plausible size.
    secants: Mat<f64>,
    /// What chi square would fall by.
    pub gain: f64,
    /// To where the secants lead.
    start: Vec<f64>,
    /// Where else a fit may begin.
    starts: Vec<Vec<f64>>,
    /// The best that was flown.
    flown: Option<Point>,
}

/// A candidate that was fitted, together with the effects found before it.
#[derive(Debug, Clone)]
pub struct Refit {
    /// The candidate.
    pub active: Active,
    /// Standard deviations of its parameters.
    pub sigma: Vec<f64>,
    /// Residual with it.
    pub residual: Vec<f64>,
    /// Chi square with it, without the prior.
    pub chi2: f64,
    /// `sum (theta/plausible)²`.
    pub prior: f64,
    /// Eigenvalues of `J'J`, J the secants at the solution per plausible size.
    pub eigenvalues: Vec<f64>,
}

impl Screened {
    /// Flies the candidate at its plausible size, parameter by parameter.
    pub fn new(setting: &Setting<'_>, current: &CurrentModel<'_>, effect: &Arc<dyn Effect>) -> Self {
        let parameters = effect.parameters();
        let trial = Trial { setting, current, effect, memory: current.memory.as_deref() };
        let started: Option<Point> = effect
            .starts()
            .iter()
            .map(|values| {
                let sizes: Vec<f64> = values.iter().zip(&parameters).map(|(v, p)| v / p.plausible).collect();
                trial.point(&sizes)
            })
            .min_by(|a, b| a.score.total_cmp(&b.score));
        let base = started.unwrap_or_else(|| trial.point_at_rest());
        if parameters.len() == 1 && base.sizes == [0.0] {
            return Self::of_one_parameter(&trial, &parameters[0]);
        }
        let at_base =
            Base { sizes: base.sizes.clone(), change: difference(&current.extended, &base.residual) };
        let columns: Vec<Vec<f64>> =
            (0..parameters.len()).map(|k| trial.secant(&parameters, k, &at_base)).collect();
        let secants = Mat::from_fn(current.extended.len(), columns.len(), |i, j| columns[j][i]);
        let LinearStep { step, gain, .. } = current.shared.step(&secants, &base.residual, &base.sizes);
        let start: Vec<f64> = base.sizes.iter().zip(step).map(|(a, b)| a + b).collect();
        let mut starts = vec![start.clone()];
        let gain = gain + current.chi2 - base.score;
        let flown = if base.sizes.iter().any(|size| *size != 0.0) {
            Some(base)
        } else {
            starts.push(start.iter().map(|size| -size).collect());
            None
        };
        Self { effect: Arc::clone(effect), secants, gain, starts, start, flown }
    }

    /// A single parameter: as small, as large, on either side as may be.
    fn of_one_parameter(trial: &Trial<'_>, parameter: &Parameter) -> Self {
        let (current, rules) = (trial.current, &trial.setting.rules().fit);
        let within = |size: &f64| (parameter.lower..=parameter.upper).contains(&(size * parameter.plausible));
        let sizes = if within(&-1.0) { &rules.tried } else { &rules.tried_one_sided };
        let little = current.chi2 < rules.much_missing * current.residual.len() as f64;
        let largest = if little && !current.effects.is_empty() { 1.0 } else { f64::INFINITY };
        let tried: Vec<(f64, Point)> = sizes
            .iter()
            .filter(|size| within(size) && size.abs() <= largest)
            .map(|size| (*size, trial.point(&[*size])))
            .collect();
        let secant = |tried: &(f64, Point)| {
            let of = |i: usize, _: usize| (current.extended[i] - tried.1.residual[i]) / tried.0;
            Mat::from_fn(current.extended.len(), 1, of)
        };
        // a secant says nothing of the other side
        let led = |tried: &(f64, Point)| {
            let LinearStep { step, gain, .. } =
                current.shared.step(&secant(tried), &current.extended, &[0.0]);
            (step[0] * tried.0 > 0.0).then_some((step[0], gain))
        };
        let best = tried.iter().min_by(|a, b| a.1.score.total_cmp(&b.1.score));
        let by_secants: Vec<(f64, f64)> = tried.iter().filter_map(led).collect();
        let largest = by_secants.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        let gain = best.map_or(0.0, |best| current.chi2 - best.1.score).max(largest.map_or(0.0, |l| l.1));
        let around = best.map_or(0.0, |best| best.0);
        let mut starts: Vec<Vec<f64>> = rules.starts.iter().map(|share| vec![share * around]).collect();
        starts.extend(by_secants.iter().map(|(size, _)| vec![*size]));
        Self {
            effect: Arc::clone(trial.effect),
            secants: best.map_or_else(|| Mat::zeros(current.extended.len(), 1), secant),
            gain,
            start: vec![largest.map_or(around, |largest| largest.0)],
            starts,
            flown: best.map(|best| best.1.clone()),
        }
    }

    /// The same with a fit that also begins with values that were found before, and is not passed over.
    #[must_use]
    pub(crate) fn also_from(mut self, known: &Active) -> Self {
        let parameters = known.parameters();
        self.starts
            .push(known.values.iter().zip(&parameters).map(|(value, p)| value / p.plausible).collect());
        self.gain = f64::INFINITY;
        self
    }

    /// Sizes to which the secants lead, in units of the plausible.
    pub fn start(&self) -> &[f64] {
        &self.start
    }

    /// Fits the candidate in the full simulation: Levenberg and Marquardt with Broyden's updates of the secants, from what
    /// the secants say and from plausible sizes.
    pub fn refit(&self, setting: &Setting<'_>, current: &CurrentModel<'_>) -> Refit {
        let trial = Trial { setting, current, effect: &self.effect, memory: None };
        let rules = &setting.rules().fit;
        let mut best = self.flown.clone();
        for start in &self.starts {
            let point = trial.point(start);
            if best.as_ref().is_none_or(|b| point.score < b.score) {
                best = Some(point);
            }
        }
        let mut point = best.unwrap_or_else(|| trial.point(&self.start));
        let mut jacobian = self.secants.clone();
        let origin = trial.point_at_rest();
        let rest = origin.score;
        if point.score > origin.score {
            point = origin;
        }
        let mut damping = 0.0;
        for taken in 0..rules.most_steps {
            let step = current.shared.step(&jacobian, &point.residual, &point.sizes).step;
            let damped = step.iter().map(|s| s / (1.0 + damping));
            let sizes: Vec<f64> = point.sizes.iter().zip(damped).map(|(a, b)| a + b).collect();
            let next = trial.point(&sizes);
            broyden(&mut jacobian, &point, &next);
            let gained = point.score - next.score;
            if gained > 0.0 {
                point = next;
                damping *= 0.3;
            } else {
                damping = if damping == 0.0 { 1.0 } else { 10.0 * damping };
            }
            let worth = rules.worth * (rest - point.score);
            if gained.abs() < rules.least_gain || damping > 1e4 || taken + 1 >= rules.steps && gained < worth
            {
                break;
            }
        }
        trial.finish(point, &jacobian)
    }
}

impl Trial<'_> {
    fn finish(&self, point: Point, jacobian: &Mat<f64>) -> Refit {
        let parameters = self.effect.parameters();
        let gram = self.current.shared.gram_of_extended(jacobian.as_ref());
        let k = gram.nrows();
        let mut precision = gram.clone();
        for j in 0..k {
            precision[(j, j)] += 1.0;
        }
        let covariance = precision
            .llt(Side::Lower)
            .map_or_else(|_| Mat::identity(k, k), |factor| factor.solve(Mat::<f64>::identity(k, k)));
        let sigma = (0..k).map(|j| parameters[j].plausible * covariance[(j, j)].max(0.0).sqrt()).collect();
        let eigenvalues = gram
            .self_adjoint_eigen(Side::Lower)
            .map_or_else(|_| vec![0.0; k], |e| (0..k).map(|j| e.S()[j].max(0.0)).collect());
        let mut residual = point.residual;
        residual.truncate(self.current.residual.len());
        Refit {
            active: self.active(&point.sizes),
            sigma,
            prior: point.sizes.iter().map(|s| s * s).sum(),
            residual,
            chi2: point.chi2,
            eigenvalues,
        }
    }
}

impl Refit {
    /// Logarithm of the Bayes factor against the current model, chi square divided by `phi`, by Laplace's
    /// method with a normal prior of the plausible sizes: `(chi²_0 - chi²_e)/(2 phi) - prior/2 - ½ ln |I + J'J/phi|`.
    pub fn evidence(&self, current: &CurrentModel<'_>, phi: f64) -> f64 {
        let occam: f64 = self.eigenvalues.iter().map(|e| 0.5 * (1.0 + e / phi).ln()).sum();
        0.5 * (current.chi2 - self.chi2) / phi - 0.5 * self.prior - occam
    }

    /// Standard deviations that the data leave, and the form.
    pub(crate) fn sigma_with_form(&self, rules: &NamingRules) -> Vec<f64> {
        let values = self.sigma.iter().zip(&self.active.values);
        values.map(|(sigma, value)| sigma.hypot(rules.value_form * value)).collect()
    }

    /// Whether its values are what its name says (see [`Effect::is_itself`]).
    pub fn is_itself(&self) -> bool {
        self.active.effect.is_itself(&self.active.values)
    }

    /// Whether no value is larger than calibration could have left it.
    pub fn is_within_prior(&self, rules: &SharedRules) -> bool {
        let parameters = self.active.parameters();
        let is_within = |(value, p): (&f64, &Parameter)| {
            let known = p.calibrated.map(|known| rules.prior_widths * known.sigma);
            value.abs() <= known.unwrap_or(rules.negligible * p.plausible)
        };
        self.active.values.iter().zip(&parameters).all(is_within)
    }
}

/// Makes the secants agree with a step that was flown.
fn broyden(jacobian: &mut Mat<f64>, from: &Point, to: &Point) {
    let step: Vec<f64> = to.sizes.iter().zip(&from.sizes).map(|(a, b)| a - b).collect();
    let length: f64 = step.iter().map(|s| s * s).sum();
    if length < 1e-12 {
        return;
    }
    // the residual falls by what the simulation gains
    let mut missed = difference(&from.residual, &to.residual);
    for (j, s) in step.iter().enumerate() {
        missed.iter_mut().zip(jacobian.col_as_slice(j)).for_each(|(missed, column)| *missed -= column * s);
    }
    for (j, s) in step.iter().enumerate() {
        let column = jacobian.col_as_slice_mut(j).iter_mut();
        column.zip(&missed).for_each(|(column, missed)| *column += missed / length * s);
    }
}
