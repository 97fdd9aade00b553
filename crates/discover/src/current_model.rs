//! The model with the effects that were found so far, around which candidates are tried.

use crate::data::Dataset;
use crate::directions::{DIRECTIONS, Directions};
use crate::problem::{Problem, difference};
use crate::shared::Shared;
use crate::simulator::{Models, Simulator};
use crate::trial::Memory;
use faer::Mat;
use maneuver::effects::{Active, Effect, Flown};
use rayon::prelude::*;
use std::sync::Arc;

/// What is asked of a search.
#[derive(Debug)]
pub struct Setting<'a> {
    /// The data.
    pub data: &'a Dataset,
    /// The wing in them.
    pub simulator: &'a Simulator,
    /// Model-form variants of the same wing: how far apart they are is a measure of how right either can be.
    pub variants: &'a [Simulator],
    /// The library.
    pub library: &'a [Arc<dyn Effect>],
    /// What calibration knows only so well, each at one standard deviation.
    pub uncertain: &'a [Active],
    /// How uncertain the corrections' directions are, as a share of what they are before any data: one if the campaign's own
    /// static points determine them, less if they were found with others.
    pub open_corrections: f64,
}

/// See the module.
#[derive(Debug, Clone)]
pub struct CurrentModel {
    /// Effects found.
    pub effects: Vec<Active>,
    /// Linear parts with them.
    pub models: Models,
    /// All segments flown with them.
    pub flown: Vec<Flown>,
    /// What each of them changes.
    contributions: Vec<Vec<Flown>>,
    /// What each of their values changes, in units of how far it may be off beside what is missing still.
    adjustments: Vec<Vec<Vec<f64>>>,
    /// Residual.
    pub residual: Vec<f64>,
    /// What runs share.
    pub shared: Shared,
    /// Its columns, not freed from what a run may be off by.
    columns: Vec<Vec<f64>>,
    /// `r' (I + G G')⁻¹ r`.
    pub chi2: f64,
    /// What candidates change, if other measurements will be searched around the same model.
    pub(crate) memory: Option<Arc<Memory>>,
}

/// What the difference of a model-form variant is multiplied by.
const NUMERICS: f64 = 1.5;
/// How far values of effects that were found may be off while something else is missing, as a share of them.
const OFF: f64 = 0.2;
/// Step for what they change.
const STEP: f64 = 0.1;
/// Most values of an effect that are freed so.
const FEW: usize = 3;

impl CurrentModel {
    /// Sets tolerances of the problem and columns around the model with `effects`.
    pub fn new(
        setting: &Setting<'_>,
        problem: &mut Problem<'_>,
        effects: &[Active],
        before: Option<&Models>,
    ) -> Self {
        Self::with_columns(setting, problem, (effects, before), None)
    }

    /// The same around a neighbour of this model, whose columns serve: what is uncertain changes little with an effect.
    #[must_use]
    pub fn beside(&self, setting: &Setting<'_>, problem: &mut Problem<'_>, effects: &[Active]) -> Self {
        Self::with_columns(setting, problem, (effects, Some(&self.models)), Some(&self.columns))
    }

    /// The same effects, where one of them is what it is: nothing is allowed to its form and values (sets the problem's
    /// tolerances so).
    #[must_use]
    pub fn strict(&self, problem: &mut Problem<'_>, which: usize) -> Self {
        let mut contributions = self.contributions.clone();
        contributions.remove(which);
        problem.set_tolerances(&self.flown, &contributions);
        let residual = problem.residual(&self.flown);
        let others = self.adjustments.iter().enumerate().filter(|(effect, _)| *effect != which);
        let adjusted = others.flat_map(|(_, columns)| columns);
        let shared = shared_of(problem, self.columns.iter().chain(adjusted));
        let chi2 = norm(&shared, &residual);
        Self { residual, shared, chi2, ..self.clone() }
    }

    /// What one of the effects changes in the residual.
    pub fn contribution(&self, problem: &Problem<'_>, which: usize) -> Vec<f64> {
        let all: Vec<usize> = (0..self.flown.len()).collect();
        let own = self.contributions[which].iter();
        let without: Vec<Flown> = self.flown.iter().zip(own).map(|(all, own)| difference(all, own)).collect();
        problem.change(&all, &self.flown, &without.iter().collect::<Vec<_>>())
    }

    /// The same, keeping what candidates change.
    #[must_use]
    pub(crate) fn remembering(self) -> Self {
        Self { memory: Some(Arc::default()), ..self }
    }

    /// The same around other measurements; the problem's tolerances are those of this model.
    #[must_use]
    pub fn measuring(&self, problem: &Problem<'_>) -> Self {
        let residual = problem.residual(&self.flown);
        let chi2 = norm(&self.shared, &residual);
        Self { residual, chi2, ..self.clone() }
    }

    fn with_columns(
        setting: &Setting<'_>,
        problem: &mut Problem<'_>,
        (effects, before): (&[Active], Option<&Models>),
        columns: Option<&[Vec<f64>]>,
    ) -> Self {
        let places = problem.places();
        let simulator = setting.simulator;
        let models = simulator.models(effects, before);
        let flown = simulator.fly(&models, effects, &places);
        let without = |k: usize| {
            let rest: Vec<Active> =
                effects.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, e)| e.clone()).collect();
            let plain = simulator.fly(&simulator.models(&rest, Some(&models)), &rest, &places);
            flown.iter().zip(&plain).map(|(with, plain)| difference(with, plain)).collect::<Vec<Flown>>()
        };
        let contributions: Vec<Vec<Flown>> = (0..effects.len()).map(without).collect();
        problem.set_tolerances(&flown, &contributions);
        let residual = problem.residual(&flown);
        let columns = columns
            .map_or_else(|| shared_columns(setting, problem, effects, &models, &flown), <[Vec<f64>]>::to_vec);
        let adjustments = adjustments(setting, problem, effects, &models, &flown);
        let shared = shared_of(problem, columns.iter().chain(adjustments.iter().flatten()));
        let chi2 = norm(&shared, &residual);
        Self {
            effects: effects.to_vec(),
            models,
            flown,
            contributions,
            adjustments,
            residual,
            shared,
            columns,
            chi2,
            memory: None,
        }
    }
}

fn shared_of<'a>(problem: &Problem<'_>, columns: impl Iterator<Item = &'a Vec<f64>>) -> Shared {
    let columns: Vec<&Vec<f64>> = columns.collect();
    let freed: Vec<Vec<f64>> = columns.par_iter().map(|column| problem.freed((*column).clone())).collect();
    Shared::new(&freed, problem.len())
}

/// `x' (I + G G')⁻¹ x`.
pub fn norm(shared: &Shared, x: &[f64]) -> f64 {
    shared.gram(Mat::from_fn(x.len(), 1, |i, _| x[i]).as_ref())[(0, 0)]
}

/// What the values of effects change, in units of how far they may be off: those of an effect with more than
/// [`FEW`] values are its form.
fn adjustments(
    setting: &Setting<'_>,
    problem: &Problem<'_>,
    effects: &[Active],
    models: &Models,
    flown: &[Flown],
) -> Vec<Vec<Vec<f64>>> {
    let all: Vec<usize> = (0..problem.segments.len()).collect();
    let before: Vec<&Flown> = flown.iter().collect();
    let column = |which: usize, k: usize| {
        let own = &effects[which];
        let mut values = own.values.clone();
        // towards zero, where bounds are not
        values[k] =
            if values[k] == 0.0 { STEP * own.parameters()[k].plausible } else { (1.0 - STEP) * values[k] };
        let mut changed = effects.to_vec();
        changed[which] = Active::new(Arc::clone(&own.effect), &values);
        let models = setting.simulator.models(&changed, Some(models));
        let after = setting.simulator.fly(&models, &changed, &problem.places());
        let mut column = problem.raw_change(&all, &after, &before);
        for value in &mut column {
            *value *= OFF / STEP;
        }
        column
    };
    let of = |which: usize| {
        let count = effects[which].values.len();
        (0..count).filter(|_| count <= FEW).map(|k| column(which, k)).collect()
    };
    (0..effects.len()).map(of).collect()
}

fn shared_columns(
    setting: &Setting<'_>,
    problem: &Problem<'_>,
    effects: &[Active],
    models: &Models,
    flown: &[Flown],
) -> Vec<Vec<f64>> {
    let (simulator, data) = (setting.simulator, setting.data);
    let all: Vec<usize> = (0..problem.segments.len()).collect();
    let changed = |extra: Active, segments: &[usize]| {
        let mut more = effects.to_vec();
        more.push(extra);
        let places: Vec<usize> = segments.iter().map(|s| problem.segments[*s].place).collect();
        let after = simulator.fly(&simulator.models(&more, Some(models)), &more, &places);
        let before: Vec<&Flown> = segments.iter().map(|s| &flown[*s]).collect();
        problem.raw_change(segments, &after, &before)
    };
    let calibrated = setting.uncertain.par_iter().map(|active| changed(active.clone(), &all));
    let windy: Vec<(usize, usize)> = (0..data.airspeeds_m_s.len())
        .filter(|v| data.airspeeds_m_s[*v] > 0.0)
        .flat_map(|v| (0..DIRECTIONS).map(move |k| (v, k)))
        .collect();
    let directions = windy.par_iter().map(|&(v, k)| {
        let effect: Arc<dyn Effect> = Arc::new(Directions { v_m_s: simulator.rigs[v].flow.v_m_s });
        let mut values = vec![0.0; DIRECTIONS];
        values[k] = effect.parameters()[k].plausible * setting.open_corrections;
        changed(Active::new(effect, &values), &problem.at_airspeed(v))
    });
    let variants = setting.variants.par_iter().map(|other| {
        let places = problem.places();
        let after = other.fly(&other.models(effects, None), effects, &places);
        let before: Vec<&Flown> = flown.iter().collect();
        let mut column = problem.raw_change(&all, &after, &before);
        for value in &mut column {
            *value *= NUMERICS;
        }
        column
    });
    let mut columns: Vec<Vec<f64>> = calibrated.collect();
    columns.extend(directions.collect::<Vec<_>>());
    columns.extend(variants.collect::<Vec<_>>());
    columns.retain(|column| column.iter().any(|value| *value != 0.0));
    columns
}
