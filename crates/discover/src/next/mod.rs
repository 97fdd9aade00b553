//! The next experiment: which of a menu would separate what the data leave open most, for its cost.
//!
//! The wing with the named effect and the wing with its rival, each as fitted to the data there are, are flown through
//! every experiment. What separates them is the squared distance of their loads beyond noise, run tolerance, what is
//! uncertain about the model, and what the rival could still give by its parameters' uncertainty: half of it is the
//! expected logarithm of the Bayes factor (T-optimal design, Atkinson and Fedorov 1975).

mod menu;

pub use menu::{Experiment, menu};

use crate::analysis::{DiscoverError, Prepared, Rigs};
use crate::candidate::Refit;
use crate::current_model::CurrentModel;
use crate::data::{Dataset, RunData, StaticGroup};
use crate::found::Found;
use crate::load_model::LoadModel;
use crate::noise::Noise;
use crate::problem::Problem;
use crate::setting::Setting;
use crate::shared::LinearStep;
use calibrate::{Schedule, Use};
use faer::Mat;
use maneuver::effects::{Active, Flown};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

/// An experiment and what is expected of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Advice {
    /// What to fly.
    pub experiment: Cow<'static, str>,
    /// Its cost; one is a run with wind.
    pub cost: f64,
    /// Expected logarithm of the Bayes factor between the named effect and each of its rivals.
    #[serde(rename = "expected_log_bayes_factor")]
    pub log_bayes_factors: BTreeMap<String, f64>,
}

impl Advice {
    /// What the nearest rival is separated by.
    pub fn least_log_bayes_factor(&self) -> f64 {
        self.log_bayes_factors.values().copied().fold(f64::INFINITY, f64::min)
    }
}

/// All experiments of the menu for one of the effects found, what separates its nearest rival most for its cost first.
///
/// # Errors
/// If the wing cannot be flown through an experiment.
pub fn advise(
    rigs: &Rigs<'_>,
    schedule: &Schedule,
    prepared: &Prepared,
    found: &[Found],
    open: usize,
) -> Result<Vec<Advice>, DiscoverError> {
    let most_m_s = prepared.data.airspeeds_m_s.last().copied().unwrap_or(0.0);
    let of = |experiment: &Experiment| -> Result<Advice, DiscoverError> {
        let planned = planned(prepared, experiment, most_m_s);
        let (simulator, variants) = rigs.simulators(schedule, &planned)?;
        let variants = variants.iter().map(|variant| variant as &dyn LoadModel).collect();
        let setting = Setting { data: &planned, model: &simulator, variants, ..prepared.setting() };
        let noise = noise_of(prepared, &planned);
        let problem = Problem::of_conditions(&planned, &noise, Use::Train);
        let log_bayes_factors = found[open]
            .rivals
            .iter()
            .map(|rival| {
                (
                    rival.active.effect.spec().name.to_owned(),
                    separation(&setting, problem.clone(), found, open, rival),
                )
            })
            .collect();
        Ok(Advice { experiment: experiment.name.into(), cost: experiment.cost, log_bayes_factors })
    };
    let mut all = menu(&prepared.data.rules.experiments)
        .par_iter()
        .map(of)
        .collect::<Result<Vec<_>, DiscoverError>>()?;
    let worth = |advice: &Advice| advice.least_log_bayes_factor() / advice.cost;
    all.sort_by(|a, b| worth(b).total_cmp(&worth(a)));
    Ok(all)
}

/// The experiment as a campaign without measurements.
fn planned(prepared: &Prepared, experiment: &Experiment, most_m_s: f64) -> Dataset {
    let controls = prepared.simulator.rigs.first().map_or(0, |rig| rig.controls.len());
    let mut airspeeds_m_s: Vec<f64> = experiment.runs.iter().map(|(share, _)| share * most_m_s).collect();
    airspeeds_m_s.sort_by(f64::total_cmp);
    airspeeds_m_s.dedup();
    let (mut runs, mut statics) = (Vec::new(), Vec::new());
    let loads = match prepared.data.static_loads() {
        [false, false, false] => prepared.data.run_loads,
        loads => loads,
    };
    for (k, (share, motion)) in experiment.runs.iter().enumerate() {
        let airspeed = airspeeds_m_s.iter().position(|v| *v == share * most_m_s).unwrap_or(0);
        let stimulus = motion.stimulus(controls, &prepared.data.rules);
        let samples = stimulus.inputs.alpha.value.len();
        if motion.is_static() {
            statics.push(StaticGroup {
                airspeed,
                stimulus,
                measured: vec![loads.map(|there| there.then_some(0.0)); samples],
                points: Vec::new(),
                blocks: vec![None; samples],
                usage: Use::Train,
            });
        } else {
            runs.push(RunData {
                name: format!("planned_{k}"),
                usage: Use::Train,
                airspeed,
                block: None,
                repeat_of: None,
                measured: std::array::from_fn(|_| vec![0.0; samples]),
                stimulus,
                decimation: 1,
            });
        }
    }
    Dataset::of_parts(&prepared.data.rules, prepared.data.rho_kg_m3, airspeeds_m_s, runs, statics)
}

/// The campaign's noise at the nearest airspeeds.
fn noise_of(prepared: &Prepared, planned: &Dataset) -> Noise {
    let known = &prepared.data.airspeeds_m_s;
    let nearest = |v: &f64| {
        let far = |i: &usize| (known[*i] - v).abs();
        (0..known.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    };
    Noise {
        run: planned.airspeeds_m_s.iter().map(|v| prepared.noise.run[nearest(v)]).collect(),
        ..prepared.noise.clone()
    }
}

fn separation(
    setting: &Setting<'_>,
    problem: Problem<'_>,
    found: &[Found],
    open: usize,
    rival: &Refit,
) -> f64 {
    let with = |active: &Active| -> Vec<Active> {
        found
            .iter()
            .enumerate()
            .map(|(i, f)| if i == open { active.clone() } else { f.active.clone() })
            .collect()
    };
    let current = CurrentModel::new(setting, problem, &with(&found[open].active));
    let problem = &current.problem;
    let fly = |active: &Active| setting.model.flown(&with(active), Some(&current.models), &problem.places());
    let all = problem.all();
    let change =
        |after: &[Flown], before: &[Flown]| problem.change(&all, after, &before.iter().collect::<Vec<_>>());
    let other = fly(&rival.active);
    let apart = current.shared.extended(change(&other, &current.flown));
    let moved = |k: usize| {
        let mut values = rival.active.values.clone();
        values[k] += rival.sigma[k];
        current.shared.extended(change(&fly(&Active::new(Arc::clone(&rival.active.effect), &values)), &other))
    };
    let columns: Vec<Vec<f64>> = (0..rival.sigma.len()).map(moved).collect();
    let jacobian = Mat::from_fn(apart.len(), columns.len(), |i, j| columns[j][i]);
    let LinearStep { gain, square, .. } = current.shared.step(&jacobian, &apart, &vec![0.0; columns.len()]);
    0.5 * (square - gain).max(0.0)
}
