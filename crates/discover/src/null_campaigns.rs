//! Campaigns without effect: the model itself with model-form variants, parameters within their uncertainty and noise.

use crate::current_model::CurrentModel;
use crate::null_distribution::{NullDistribution, label};
use crate::null_key::NullKey;
use crate::problem::Problem;
use crate::rank::rank;
use crate::setting::Setting;
use maneuver::effects::{Active, Effect, Flown};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rayon::prelude::*;
use response::verdict::mean_and_deviation;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::Instant;

/// What the search finds in one campaign without effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NullCampaign {
    /// Log Bayes factor of every effect that screening let through, by label.
    evidence: Vec<(String, f64)>,
    /// Mean square of what is left over the noise.
    misfit: f64,
    /// Gaps of training and held-out runs.
    gap: [f64; 2],
    /// Sum of squares of how the training loads vary, over the noise.
    variation: f64,
}

/// Keeps campaigns when they are finished, and may have some from a run that was stopped.
pub trait NullStore: Sync {
    /// A campaign that was finished before.
    fn get(&self, k: u64) -> Option<NullCampaign>;
    /// Keeps a campaign that took so long, s.
    fn put(&self, k: u64, campaign: &NullCampaign, seconds: f64);
}

/// Keeps nothing.
impl NullStore for () {
    fn get(&self, _: u64) -> Option<NullCampaign> {
        None
    }

    fn put(&self, _: u64, _: &NullCampaign, _: f64) {}
}

/// Makes those campaigns without effect that are wanted and searches them; `judged` are training and held-out data, each run for itself.
/// A campaign is the same whichever others are wanted.
pub fn null_campaigns(
    setting: &Setting<'_>,
    train: Problem<'_>,
    judged: &[Problem<'_>; 2],
    seed: u64,
    wanted: &[u64],
    kept: &dyn NullStore,
) -> Vec<NullCampaign> {
    // the same model flies all of them: what it is uncertain of and what effects change in it is found once
    let current = CurrentModel::bare(setting, train).remembering();
    let one = |k: u64| {
        let start = Instant::now();
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(k + 1);
        let campaign = null(setting, &current, judged, &mut random, k);
        kept.put(k, &campaign, start.elapsed().as_secs_f64());
        campaign
    };
    let mut nulls: Vec<(u64, Option<NullCampaign>)> = wanted.iter().map(|k| (*k, kept.get(*k))).collect();
    // the first alone, so that the others need not fly side by side what it will remember
    if let Some((k, first)) = nulls.iter_mut().find(|(_, null)| null.is_none()) {
        *first = Some(one(*k));
    }
    nulls.into_par_iter().map(|(k, null)| null.unwrap_or_else(|| one(k))).collect()
}

/// All campaigns that the rules ask for, and what they say together.
pub fn from_null_campaigns(
    setting: &Setting<'_>,
    train: Problem<'_>,
    judged: &[Problem<'_>; 2],
    seed: u64,
    kept: &dyn NullStore,
) -> NullDistribution {
    let all: Vec<u64> = (0..setting.rules().nulls.campaigns).collect();
    distribution(setting, &null_campaigns(setting, train, judged, seed, &all, kept))
}

/// What these campaigns say together.
fn distribution(setting: &Setting<'_>, nulls: &[NullCampaign]) -> NullDistribution {
    let (rules, naming) = (&setting.rules().nulls, &setting.rules().naming);
    let variations: Vec<f64> = nulls.iter().map(|null| null.variation).collect();
    let model_form = 0.5 * naming.model_form.powi(2) * mean_and_deviation(&variations).0;
    let threshold = |effect: &Arc<dyn Effect>| {
        let label = label(effect);
        let found =
            |null: &NullCampaign| null.evidence.iter().find(|(of, _)| *of == label).map(|found| found.1);
        // an effect that screening passed over found nothing there
        let mut values: Vec<f64> = nulls.iter().filter_map(found).map(|value| value.max(0.0)).collect();
        values.resize(nulls.len(), 0.0);
        let (mean, sd) = mean_and_deviation(&values);
        (label, (mean + rules.sigmas * sd + model_form).max(naming.least))
    };
    let misfits: Vec<f64> = nulls.iter().map(|null| null.misfit).collect();
    let (misfit, sd) = mean_and_deviation(&misfits);
    let floor = |k: usize| mean_and_deviation(&nulls.iter().map(|null| null.gap[k]).collect::<Vec<f64>>()).0;
    NullDistribution {
        key: NullKey::default(),
        evidence: setting.library.iter().map(threshold).collect(),
        model_form,
        misfit,
        misfit_limit: misfit + rules.sigmas * sd + rules.misfit_margin,
        floor: [floor(0), floor(1)],
    }
}

fn null(
    setting: &Setting<'_>,
    current: &CurrentModel<'_>,
    judged: &[Problem<'_>; 2],
    random: &mut ChaCha8Rng,
    k: u64,
) -> NullCampaign {
    let variants = setting.variants.len() as u64;
    let truth = match (k % (variants + 1)).checked_sub(1) {
        None => setting.model,
        Some(variant) => setting.variants[usize::try_from(variant).unwrap_or(0)],
    };
    let effects: Vec<Active> = setting
        .uncertain
        .iter()
        .map(|one| {
            let size = normal(random);
            let values: Vec<f64> = one.values.iter().map(|value| size * value).collect();
            Active::new(Arc::clone(&one.effect), &values)
        })
        .collect();
    let models = truth.models(&effects, None);
    let train = pretend(&current.problem, &|places| truth.fly(&models, &effects, places), random);
    let judged = judged
        .each_ref()
        .map(|problem| pretend(problem, &|places| truth.fly(&models, &effects, places), random));
    let variation = train.variation();
    let current = current.measuring(train);
    let ranked = rank(setting, &current, &NullDistribution::default());
    let gap =
        |problem: &Problem<'_>| problem.gap(&setting.model.fly(&current.models, &[], &problem.places())).all;
    NullCampaign {
        evidence: ranked.iter().map(|w| (w.label(), w.evidence)).collect(),
        misfit: current.chi2 / current.problem.len() as f64,
        gap: judged.each_ref().map(gap),
        variation,
    }
}

/// The problem with loads of a simulation and noise.
fn pretend<'a>(
    problem: &Problem<'a>,
    fly: &dyn Fn(&[usize]) -> Vec<Flown>,
    random: &mut ChaCha8Rng,
) -> Problem<'a> {
    problem.pretending(&fly(&problem.places()), || normal(random))
}

fn normal(random: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(random)
}
