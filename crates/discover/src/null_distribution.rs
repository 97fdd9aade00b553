//! What the search would find where nothing is missing: campaigns of the model itself with model-form variants, parameters
//! within their uncertainty and noise. Thresholds and floors come from them.

use crate::current_model::CurrentModel;
use crate::data::Dataset;
use crate::problem::Problem;
use crate::rank::rank;
use crate::setting::Setting;
use maneuver::effects::{Active, Flown};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rayon::prelude::*;
use response::verdict::mean_and_deviation;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Log Bayes factor on top: the null campaigns are made with the model's own form, or close to it, and real wings are not. On 539
/// campaigns of another program without any effect, of development seeds of the blind benchmark, nothing but [`CONFOUNDERS`] was
/// found with more than 18.
const MARGIN: f64 = 25.0;
/// What differences in model form look like, and the log Bayes factor that it needs on top. Most of all a small mass on the outer wing, another stream
/// between walls, another lag of the air; and a wing stiffer in torsion, where corrections come from the campaign's own
/// points. Less so what is a little of everything: losses at the tip, crosstalk, a shifted center of lift.
const CONFOUNDERS: [(&str, f64); 12] = [
    ("tip_mass", 75.0),
    ("wall_correction", 65.0),
    ("aero_lag", 65.0),
    ("tors_stiff", 85.0),
    ("tip_loss", 50.0),
    ("crosstalk", 40.0),
    ("ac_shift", 40.0),
    ("ctl_scale", 40.0),
    ("alpha_encoder", 40.0),
    ("wing_mass_error", 40.0),
    ("added_mass", 40.0),
    ("ctl_alpha_interaction", 40.0),
];
/// Thresholds of evidence by effect and form, and what the misfit is without effects.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NullDistribution {
    /// What it belongs to: see [`key`].
    pub key: String,
    /// By `name form`.
    pub evidence: BTreeMap<String, f64>,
    /// Chi square a row where nothing is missing, mean.
    pub misfit: f64,
    /// Above this something is missing.
    pub misfit_limit: f64,
    /// Gap where nothing is missing: training, held out.
    pub floor: [f64; 2],
}

impl Default for NullDistribution {
    fn default() -> Self {
        Self {
            key: String::new(),
            evidence: BTreeMap::new(),
            misfit: 1.0,
            misfit_limit: 1.5,
            floor: [1.0; 2],
        }
    }
}

impl NullDistribution {
    /// Threshold of an effect in a form.
    pub fn threshold(&self, name: &str, form: &str) -> f64 {
        self.evidence.get(&format!("{name} {form}")).copied().unwrap_or(margin(name))
    }

    /// Makes campaigns without effect and searches them; `judged` are training and held-out data, each run for itself.
    pub fn from_null_campaigns(
        setting: &Setting<'_>,
        train: Problem<'_>,
        judged: &[Problem<'_>; 2],
        seed: u64,
    ) -> Self {
        let rules = &setting.rules().nulls;
        // the same model flies all of them: what it is uncertain of and what effects change in it is found once
        let current = CurrentModel::bare(setting, train).remembering();
        let one = |k: u64| {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            random.set_stream(k + 1);
            null(setting, &current, judged, &mut random, k)
        };
        // the first alone, so that the others need not fly side by side what it will remember
        let mut nulls = vec![one(0)];
        nulls.par_extend((1..rules.campaigns).into_par_iter().map(one));
        let mut evidence: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for null in &nulls {
            for (name, value) in &null.evidence {
                evidence.entry(name.clone()).or_default().push(value.max(0.0));
            }
        }
        // an effect that screening passed over found nothing there
        let of = |name: &str, values: Vec<f64>| {
            let mut all = values;
            all.resize(nulls.len(), 0.0);
            let (mean, sd) = mean_and_deviation(&all);
            mean + rules.sigmas * sd + margin(name)
        };
        let misfits: Vec<f64> = nulls.iter().map(|null| null.misfit).collect();
        let (misfit, sd) = mean_and_deviation(&misfits);
        let floor =
            |k: usize| mean_and_deviation(&nulls.iter().map(|null| null.gap[k]).collect::<Vec<f64>>()).0;
        Self {
            key: String::new(),
            evidence: evidence
                .into_iter()
                .map(|(name, values)| {
                    let threshold = of(name.split(' ').next().unwrap_or(&name), values);
                    (name, threshold)
                })
                .collect(),
            misfit,
            misfit_limit: misfit + rules.sigmas * sd + rules.misfit_margin,
            floor: [floor(0), floor(1)],
        }
    }
}

/// Log Bayes factor on top of what the null campaigns show.
fn margin(name: &str) -> f64 {
    CONFOUNDERS.iter().find(|(confounder, _)| *confounder == name).map_or(MARGIN, |(_, margin)| *margin)
}

struct Null {
    evidence: Vec<(String, f64)>,
    misfit: f64,
    gap: [f64; 2],
}

fn null(
    setting: &Setting<'_>,
    current: &CurrentModel<'_>,
    judged: &[Problem<'_>; 2],
    random: &mut ChaCha8Rng,
    k: u64,
) -> Null {
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
    let current = current.measuring(train);
    let ranked = rank(setting, &current, &NullDistribution::default());
    let gap =
        |problem: &Problem<'_>| problem.gap(&setting.model.fly(&current.models, &[], &problem.places())).all;
    Null {
        evidence: ranked.iter().map(|w| (w.label(), w.evidence)).collect(),
        misfit: current.chi2 / current.problem.len() as f64,
        gap: judged.each_ref().map(gap),
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

/// What a null distribution was made by: another word where library, tolerances or margins change.
const RULES: &str = "replicates together, other lattice, held angles, margin 25, twelve mimics, small tip mass, calibrated to 2 %, either side";

/// A fingerprint of what a null distribution depends on, as FNV-1a of words.
pub fn key(wing_hash: &str, data: &Dataset) -> String {
    let mut words = vec![RULES.to_owned(), wing_hash.to_owned(), format!("{:?}", data.airspeeds_m_s)];
    for run in &data.runs {
        let commands: f64 = run.stimulus.inputs.controls_rad.iter().flatten().map(|d| d.abs()).sum();
        words.push(format!("{} {:?} {} {commands:.3}", run.airspeed, run.usage, run.measured[0].len()));
    }
    let (runs, points) = (data.run_loads, data.static_loads());
    if runs != [true; 3] || points != [true; 3] {
        words.push(format!("{runs:?} {points:?}"));
    }
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for byte in words.join("|").bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    format!("{hash:016x}")
}
