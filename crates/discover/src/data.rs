//! Static points and runs of a campaign as the search wants them: grouped by airspeed, runs at one sample rate.

pub use crate::channels::StatedNoise;
use crate::channels::{not_used, run_loads, stated};
pub use crate::conditions::Condition;
use crate::conditions::conditions;
use crate::rules::{DataRules, Rules};
pub use crate::run_data::{RunData, StaticGroup};
use calibrate::{Campaign, RunEntry, Use};
use coupling::ElasticWing;
use maneuver::effects::{Inputs, Stimulus};
use maneuver::{Run, Smooth, smooth_from_rest, zero_phase};
use nastran::{InputError, named_file};
use rayon::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// See the module.
#[derive(Debug, Clone)]
pub struct Dataset {
    /// By what they were read, and are decided on.
    pub rules: Arc<Rules>,
    /// Airspeeds, m/s, ascending; zero is still air.
    pub airspeeds_m_s: Vec<f64>,
    /// Air density, kg/m³.
    pub rho_kg_m3: f64,
    /// Names of blocks.
    pub blocks: Vec<String>,
    /// Runs in the campaign's order.
    pub runs: Vec<RunData>,
    /// The runs with their repeats taken together.
    pub conditions: Vec<Condition>,
    /// Static points.
    pub statics: Vec<StaticGroup>,
    /// Which of Fz, Mx, My the runs have.
    pub run_loads: [bool; 3],
    /// Standard deviations as stated.
    pub stated: Option<StatedNoise>,
    /// How training and held-out runs were divided, if the campaign does not say it.
    pub split: Option<String>,
    /// What was measured and is not used, in words.
    pub not_used: Vec<String>,
}

impl Dataset {
    /// Reads the runs of a campaign for a wing.
    ///
    /// # Errors
    /// A run that cannot be read, moves a control the wing does not have or lacks a load that others have; no root load at
    /// all; noise that is stated of other loads than the runs have.
    pub fn read(campaign: &Campaign, wing: &ElasticWing, rules: &Arc<Rules>) -> Result<Self, InputError> {
        let how = &rules.data;
        let listed_in = &campaign.path;
        let read = read_runs(campaign, wing, listed_in)?;
        let (usage, split) = usage(how, &campaign.runs);
        let airspeeds_m_s = airspeeds(how, campaign, &read, &usage);
        let blocks = blocks(campaign);
        let run_loads = run_loads(campaign, &read, listed_in)?;
        let stated = stated(campaign, run_loads);
        let not_used = not_used(campaign, &read);
        // a run without loads has nothing to say; the others keep their order
        let measured: Vec<usize> =
            (0..read.len()).filter(|i| (0..3).any(|c| read[*i].load(c).is_some())).collect();
        let controls: Vec<&str> = wing.controls.iter().map(|control| control.name.as_str()).collect();
        let runs: Vec<RunData> = measured
            .par_iter()
            .map(|&i| {
                let (run, entry) = (&read[i], &campaign.runs[i]);
                let repeats = |file: &String| measured.iter().position(|j| &campaign.runs[*j].file == file);
                let decimation = decimation(how, run.time_step_s);
                let kept = |values: &[f64]| values.iter().step_by(decimation).copied().collect::<Vec<f64>>();
                let slow = |values: &[f64]| match decimation {
                    1 => values.to_vec(),
                    _ => kept(&zero_phase(values, run.time_step_s, how.anti_alias_hz)),
                };
                RunData {
                    name: run.name.clone(),
                    usage: usage[i],
                    airspeed: nearest(&airspeeds_m_s, run.v_m_s),
                    block: place(&blocks, entry.block.as_deref()),
                    repeat_of: entry.repeat_of.as_ref().and_then(repeats),
                    stimulus: stimulus(how, run, entry, &controls),
                    measured: std::array::from_fn(|c| {
                        run.load(c).map_or_else(|| vec![0.0; run.len().div_ceil(decimation)], slow)
                    }),
                    decimation,
                }
            })
            .collect();
        let statics = statics(how, campaign, &airspeeds_m_s, &blocks, &controls, &runs);
        let conditions = conditions(&runs);
        let rho_kg_m3 = campaign.rho_kg_m3;
        Ok(Self {
            rules: Arc::clone(rules),
            airspeeds_m_s,
            rho_kg_m3,
            blocks,
            runs,
            conditions,
            statics,
            run_loads,
            stated,
            split,
            not_used,
        })
    }

    /// Whether anything is held out: without that, nothing judges what is found.
    pub fn has_held_out(&self) -> bool {
        let runs = self.runs.iter().map(|run| run.usage);
        runs.chain(self.statics.iter().map(|group| group.usage)).any(|usage| usage == Use::Holdout)
    }

    /// Which of Fz, Mx, My some static point has.
    pub fn static_loads(&self) -> [bool; 3] {
        let has = |c: usize| self.statics.iter().flat_map(|group| &group.measured).any(|m| m[c].is_some());
        [has(0), has(1), has(2)]
    }

    /// From what there is, blocks and stated noise aside.
    pub(crate) fn of_parts(
        rules: &Arc<Rules>,
        rho_kg_m3: f64,
        airspeeds_m_s: Vec<f64>,
        runs: Vec<RunData>,
        statics: Vec<StaticGroup>,
    ) -> Self {
        let conditions = conditions(&runs);
        Self {
            rules: Arc::clone(rules),
            airspeeds_m_s,
            rho_kg_m3,
            blocks: Vec::new(),
            runs,
            conditions,
            statics,
            run_loads: [true; 3],
            stated: None,
            split: None,
            not_used: Vec::new(),
        }
    }

    /// Airspeed and stimulus of everything that can be flown: static groups, runs, conditions.
    pub fn stimuli(&self) -> impl Iterator<Item = (usize, &Stimulus)> {
        let statics = self.statics.iter().map(|group| (group.airspeed, &group.stimulus));
        let runs = self.runs.iter().map(|run| (run.airspeed, &run.stimulus));
        let conditions = self.conditions.iter().map(|one| (one.airspeed, &one.stimulus));
        statics.chain(runs).chain(conditions)
    }

    /// Place of a run among them.
    pub fn place_of_run(&self, run: usize) -> usize {
        self.statics.len() + run
    }

    /// Place of a condition among them.
    pub fn place_of_condition(&self, condition: usize) -> usize {
        self.statics.len() + self.runs.len() + condition
    }
}

/// All runs; a control that the wing does not have is an error.
fn read_runs(campaign: &Campaign, wing: &ElasticWing, listed_in: &Path) -> Result<Vec<Run>, InputError> {
    let one = |entry: &RunEntry| {
        let path = named_file(listed_in, &entry.file)?;
        let run = Run::read_named(&path, &campaign.columns)?;
        for (control, _) in &run.controls_rad {
            if !wing.controls.iter().any(|known| &known.name == control) {
                let known: Vec<&str> = wing.controls.iter().map(|control| control.name.as_str()).collect();
                let message = format!("the run moves a control {control}, which the wing does not have");
                return Err(InputError::in_file(&path, message)
                    .with_help(format!("the wing's controls: {}", known.join(", "))));
            }
        }
        Ok(run)
    };
    let read: Vec<Result<Run, InputError>> = campaign.runs.par_iter().map(one).collect();
    // the first that is wrong in the campaign's order is said
    read.into_iter().collect()
}

/// Airspeeds that are one are the slowest of them; what is held out moves none that training data are flown at.
fn airspeeds(how: &DataRules, campaign: &Campaign, runs: &[Run], usage: &[Use]) -> Vec<f64> {
    let of = |wanted: Use| runs.iter().zip(usage).filter(move |(_, usage)| **usage == wanted);
    let apart = |mut all: Vec<f64>| {
        all.sort_by(f64::total_cmp);
        all.dedup_by(|b, a| (*b - *a).abs() <= how.same_airspeed * *a);
        all
    };
    let points = campaign.points.iter().map(|point| point.v_m_s);
    let mut all = apart(of(Use::Train).map(|(run, _)| run.v_m_s).chain(points).collect());
    let new = |v: &f64| all.iter().all(|known| (v - known).abs() > how.same_airspeed * known.min(*v));
    let held_out = apart(of(Use::Holdout).map(|(run, _)| run.v_m_s).filter(new).collect());
    all.extend(held_out);
    all.sort_by(f64::total_cmp);
    all
}

fn nearest(airspeeds_m_s: &[f64], v_m_s: f64) -> usize {
    let far = |i: &usize| (airspeeds_m_s[*i] - v_m_s).abs();
    (0..airspeeds_m_s.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
}

fn blocks(campaign: &Campaign) -> Vec<String> {
    let of_runs = campaign.runs.iter().filter_map(|run| run.block.clone());
    let mut all: Vec<String> =
        campaign.points.iter().filter_map(|point| point.block.clone()).chain(of_runs).collect();
    all.sort();
    all.dedup();
    all
}

fn place(blocks: &[String], name: Option<&str>) -> Option<usize> {
    blocks.iter().position(|block| Some(block.as_str()) == name)
}

/// Every third run is held out where the campaign says nothing.
fn usage(how: &DataRules, runs: &[RunEntry]) -> (Vec<Use>, Option<String>) {
    let all: Vec<Use> = runs
        .iter()
        .enumerate()
        .map(|(i, run)| {
            run.usage.unwrap_or(if (i + 1).is_multiple_of(how.held_out_every) {
                Use::Holdout
            } else {
                Use::Train
            })
        })
        .collect();
    let open = runs.iter().filter(|run| run.usage.is_none()).count();
    let split =
        (open > 0).then(|| format!("{open} runs have no `use`: every third run of the list is held out"));
    (all, split)
}

fn decimation(how: &DataRules, time_step_s: f64) -> usize {
    let ratio = 1.0 / (time_step_s * how.rate_hz);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let whole = (ratio + 1e-6).floor().max(1.0) as usize;
    whole
}

/// An angle that does not move is held: what its encoder's noise says of rates would be flown as motion otherwise.
fn hold(how: &DataRules, alpha: &mut Smooth) {
    let n = alpha.value.len().max(1) as f64;
    let mean = alpha.value.iter().sum::<f64>() / n;
    let square = alpha.value.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / n;
    if square.sqrt() < how.held_angle_sd_rad {
        alpha.value.fill(mean);
        alpha.rate.fill(0.0);
        alpha.second.fill(0.0);
    }
}

fn stimulus(how: &DataRules, run: &Run, entry: &RunEntry, controls: &[&str]) -> Stimulus {
    let decimation = decimation(how, run.time_step_s);
    let kept = |values: &[f64]| values.iter().step_by(decimation).copied().collect::<Vec<f64>>();
    let smooth = smooth_from_rest(&run.alpha_rad, run.time_step_s, how.anti_alias_hz);
    let mut alpha =
        Smooth { value: kept(&smooth.value), rate: kept(&smooth.rate), second: kept(&smooth.second) };
    hold(how, &mut alpha);
    let samples = alpha.value.len();
    let commanded = |name: &&str| {
        let own = run.controls_rad.iter().find(|(control, _)| control == name);
        own.map_or_else(|| vec![0.0; samples], |(_, values)| kept(values))
    };
    Stimulus {
        inputs: Inputs {
            incidence_rad: vec![0.0; samples],
            controls_rad: controls.iter().map(commanded).collect(),
            alpha,
        },
        time_step_s: run.time_step_s * decimation as f64,
        steady: false,
        clock_h: entry.start_s.unwrap_or(0.0) / 3600.0,
    }
}

fn statics(
    how: &DataRules,
    campaign: &Campaign,
    airspeeds_m_s: &[f64],
    blocks: &[String],
    controls: &[&str],
    runs: &[RunData],
) -> Vec<StaticGroup> {
    let groups = airspeeds_m_s.iter().enumerate().filter_map(|(airspeed, _)| {
        let here = |i: &usize| nearest(airspeeds_m_s, campaign.points[*i].v_m_s) == airspeed;
        let indices: Vec<usize> = (0..campaign.points.len()).filter(here).collect();
        let points: Vec<_> = indices.iter().map(|i| &campaign.points[*i]).collect();
        if points.is_empty() {
            return None;
        }
        let still = vec![0.0; points.len()];
        let deflection = |name: &&str| {
            let of = |p: &&calibrate::StaticPoint| {
                p.controls_rad.iter().find(|(control, _)| control == name).map_or(0.0, |(_, delta)| *delta)
            };
            points.iter().map(of).collect::<Vec<f64>>()
        };
        let here: Vec<Use> =
            runs.iter().filter(|run| run.airspeed == airspeed).map(|run| run.usage).collect();
        let held_out = !here.is_empty() && here.iter().all(|usage| *usage == Use::Holdout);
        Some(StaticGroup {
            airspeed,
            stimulus: Stimulus {
                inputs: Inputs {
                    alpha: Smooth {
                        value: points.iter().map(|p| p.alpha_rad).collect(),
                        rate: still.clone(),
                        second: still.clone(),
                    },
                    incidence_rad: still,
                    controls_rad: controls.iter().map(deflection).collect(),
                },
                time_step_s: 1.0 / how.rate_hz,
                steady: true,
                clock_h: 0.0,
            },
            measured: points.iter().map(|p| p.loads).collect(),
            points: indices,
            blocks: points.iter().map(|p| place(blocks, p.block.as_deref())).collect(),
            usage: if held_out { Use::Holdout } else { Use::Train },
        })
    });
    groups.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_held_angle_has_no_rates_and_a_moving_one_keeps_them() {
        // the encoder's noise of five thousandths of a degree, and a degree of motion
        let noisy = |motion_rad: f64| Smooth {
            value: (0..200)
                .map(|i| 8.7e-5 * f64::from(i % 3 - 1) + motion_rad * (0.1 * f64::from(i)).sin())
                .collect(),
            rate: vec![0.01; 200],
            second: vec![1.0; 200],
        };
        let mut held = noisy(0.0);
        hold(&DataRules::default(), &mut held);
        assert!(held.rate.iter().chain(&held.second).all(|value| *value == 0.0));
        assert!(held.value.iter().all(|value| *value == held.value[0]));
        let mut moving = noisy(0.0175);
        hold(&DataRules::default(), &mut moving);
        assert_eq!(moving, noisy(0.0175));
    }
}
