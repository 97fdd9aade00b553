//! The model with the effects that were found so far, around which candidates are tried.

use crate::directions::{DIRECTIONS, Directions};
use crate::load_model::Models;
use crate::memory::Memory;
use crate::problem::{Problem, difference};
use crate::setting::Setting;
use crate::shared::Shared;
use maneuver::effects::{Active, Effect, Flown};
use rayon::prelude::*;
use std::sync::Arc;

/// See the module.
#[derive(Debug, Clone)]
pub struct CurrentModel<'a> {
    /// The measurements, freed from what a run may be off by around this model.
    pub problem: Problem<'a>,
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
    /// The residual [`Shared::extended`].
    pub(crate) extended: Vec<f64>,
    /// What all runs share: uncertain parameters, corrections, model form.
    pub shared: Shared,
    /// Its columns, not freed from what a run may be off by.
    columns: Arc<Vec<Vec<f64>>>,
    /// `r' (I + G G')⁻¹ r`.
    pub chi2: f64,
    /// What candidates change, if other measurements will be searched around the same model.
    pub(crate) memory: Option<Arc<Memory>>,
}

impl<'a> CurrentModel<'a> {
    /// Sets tolerances of the problem and columns around the model without effects.
    pub fn bare(setting: &Setting<'_>, problem: Problem<'a>) -> Self {
        Self::around(setting, problem, &[], None, None)
    }

    /// The same around the model with `effects`.
    pub fn new(setting: &Setting<'_>, problem: Problem<'a>, effects: &[Active]) -> Self {
        Self::around(setting, problem, effects, None, None)
    }

    /// The same measurements around the model with other effects.
    #[must_use]
    pub fn with(&self, setting: &Setting<'_>, effects: &[Active]) -> Self {
        Self::around(setting, self.problem.clone(), effects, Some(&self.models), None)
    }

    /// The same around a neighbour of this model, whose columns serve: what is uncertain changes little with an effect.
    #[must_use]
    pub fn beside(&self, setting: &Setting<'_>, effects: &[Active]) -> Self {
        let columns = Some(Arc::clone(&self.columns));
        Self::around(setting, self.problem.clone(), effects, Some(&self.models), columns)
    }

    /// The same effects, where one of them is what it is: nothing is allowed to its form and values.
    #[must_use]
    pub fn strict(&self, which: usize) -> Self {
        let mut contributions = self.contributions.clone();
        contributions.remove(which);
        let mut problem = self.problem.clone();
        problem.set_tolerances(&self.flown, &contributions);
        let residual = problem.residual(&self.flown);
        let others = self.adjustments.iter().enumerate().filter(|(effect, _)| *effect != which);
        let adjusted = others.flat_map(|(_, columns)| columns);
        let shared = shared_of(&problem, self.columns.iter().chain(adjusted));
        let extended = shared.extended(residual.clone());
        let chi2 = shared.norm_of_extended(&extended);
        Self { problem, residual, extended, shared, chi2, ..self.clone() }
    }

    /// The model without one of the effects, where nothing is allowed to runs and nothing is uncertain.
    pub(crate) fn lacking(&self, setting: &Setting<'_>, which: usize) -> Self {
        let mut effects = self.effects.clone();
        effects.remove(which);
        let models = setting.model.models(&effects, Some(&self.models));
        let flown = setting.model.fly(&models, &effects, &self.problem.places());
        let problem = self.problem.without_tolerances();
        let residual = problem.residual(&flown);
        let shared = Shared::new(&[], problem.len());
        let extended = shared.extended(residual.clone());
        let chi2 = shared.norm_of_extended(&extended);
        Self { problem, effects, models, flown, residual, extended, shared, chi2, ..self.clone() }
    }

    /// What one of the effects changes in the residual.
    pub fn contribution(&self, which: usize) -> Vec<f64> {
        let own = self.contributions[which].iter();
        let without: Vec<Flown> = self.flown.iter().zip(own).map(|(all, own)| difference(all, own)).collect();
        let problem = &self.problem;
        problem.change(&problem.all(), &self.flown, &without.iter().collect::<Vec<_>>())
    }

    /// Chi square with other effects, by the tolerances of this model.
    pub fn misfit_of(&self, setting: &Setting<'_>, effects: &[Active]) -> f64 {
        let flown = setting.model.flown(effects, Some(&self.models), &self.problem.places());
        self.shared.norm(&self.problem.residual(&flown))
    }

    /// The same, keeping what candidates change.
    #[must_use]
    pub(crate) fn remembering(self) -> Self {
        Self { memory: Some(Arc::default()), ..self }
    }

    /// The same around other measurements, whose tolerances are those of this model.
    #[must_use]
    pub fn measuring(&self, problem: Problem<'a>) -> Self {
        let residual = problem.residual(&self.flown);
        let extended = self.shared.extended(residual.clone());
        let chi2 = self.shared.norm_of_extended(&extended);
        Self { problem, residual, extended, chi2, ..self.clone() }
    }

    fn around(
        setting: &Setting<'_>,
        mut problem: Problem<'a>,
        effects: &[Active],
        before: Option<&Models>,
        columns: Option<Arc<Vec<Vec<f64>>>>,
    ) -> Self {
        let places = problem.places();
        let model = setting.model;
        let models = model.models(effects, before);
        let flown = model.fly(&models, effects, &places);
        let without = |k: usize| {
            let rest: Vec<Active> =
                effects.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, e)| e.clone()).collect();
            let plain = model.flown(&rest, Some(&models), &places);
            flown.iter().zip(&plain).map(|(with, plain)| difference(with, plain)).collect::<Vec<Flown>>()
        };
        let contributions: Vec<Vec<Flown>> = (0..effects.len()).map(without).collect();
        problem.set_tolerances(&flown, &contributions);
        let residual = problem.residual(&flown);
        let columns_of = Columns { setting, problem: &problem, effects, models: &models, flown: &flown };
        let columns = columns.unwrap_or_else(|| Arc::new(columns_of.shared()));
        let adjustments = columns_of.adjustments();
        let shared = shared_of(&problem, columns.iter().chain(adjustments.iter().flatten()));
        let extended = shared.extended(residual.clone());
        let chi2 = shared.norm_of_extended(&extended);
        Self {
            problem,
            effects: effects.to_vec(),
            models,
            flown,
            contributions,
            adjustments,
            residual,
            extended,
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

/// Where columns are taken: the model as it is flown.
struct Columns<'a> {
    setting: &'a Setting<'a>,
    problem: &'a Problem<'a>,
    effects: &'a [Active],
    models: &'a Models,
    flown: &'a [Flown],
}

impl Columns<'_> {
    /// What other effects, or another model, change in some segments.
    fn change(&self, segments: &[usize], after: &[Flown]) -> Vec<f64> {
        let before: Vec<&Flown> = segments.iter().map(|s| &self.flown[*s]).collect();
        self.problem.raw_change(segments, after, &before)
    }

    /// What the values of effects change, in units of how far they may be off: those of an effect with more than a few
    /// values are its form.
    fn adjustments(&self) -> Vec<Vec<Vec<f64>>> {
        let rules = &self.setting.rules().shared;
        let step = rules.found_value_step;
        let column = |which: usize, k: usize| {
            let own = &self.effects[which];
            let mut values = own.values.clone();
            // towards zero, where bounds are not
            values[k] = if values[k] == 0.0 {
                step * own.parameters()[k].plausible
            } else {
                (1.0 - step) * values[k]
            };
            let mut changed = self.effects.to_vec();
            changed[which] = Active::new(Arc::clone(&own.effect), &values);
            let after = self.setting.model.flown(&changed, Some(self.models), &self.problem.places());
            scaled(self.change(&self.problem.all(), &after), rules.found_value_off / step)
        };
        let of = |which: usize| {
            let count = self.effects[which].values.len();
            (0..count).filter(|_| count <= rules.found_values_freed).map(|k| column(which, k)).collect()
        };
        (0..self.effects.len()).map(of).collect()
    }

    /// Calibrated parameters, corrections and model-form variants.
    fn shared(&self) -> Vec<Vec<f64>> {
        let (setting, problem, rules) = (self.setting, self.problem, &self.setting.rules().shared);
        let all = problem.all();
        let changed = |extra: Active, segments: &[usize]| {
            let mut more = self.effects.to_vec();
            more.push(extra);
            let places: Vec<usize> = segments.iter().map(|s| problem.segments[*s].place).collect();
            self.change(segments, &setting.model.flown(&more, Some(self.models), &places))
        };
        let calibrated = setting.uncertain.par_iter().map(|active| changed(active.clone(), &all));
        let airspeeds_m_s = &setting.data.airspeeds_m_s;
        let windy: Vec<(usize, usize)> = (0..airspeeds_m_s.len())
            .filter(|v| airspeeds_m_s[*v] > 0.0)
            .flat_map(|v| (0..DIRECTIONS).map(move |k| (v, k)))
            .collect();
        let directions = windy.par_iter().map(|&(v, k)| {
            let effect: Arc<dyn Effect> = Arc::new(Directions::new(airspeeds_m_s[v], rules));
            let mut values = vec![0.0; DIRECTIONS];
            values[k] = effect.parameters()[k].plausible * setting.open_corrections;
            changed(Active::new(effect, &values), &problem.at_airspeed(v))
        });
        let variants = setting.variants.par_iter().map(|variant| {
            let after = variant.flown(self.effects, None, &problem.places());
            scaled(self.change(&all, &after), rules.variant_factor)
        });
        let mut columns: Vec<Vec<f64>> = calibrated.collect();
        columns.extend(directions.collect::<Vec<_>>());
        columns.extend(variants.collect::<Vec<_>>());
        columns.retain(|column| column.iter().any(|value| *value != 0.0));
        columns
    }
}

fn scaled(mut column: Vec<f64>, factor: f64) -> Vec<f64> {
    for value in &mut column {
        *value *= factor;
    }
    column
}
