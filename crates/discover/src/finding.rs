//! A campaign that was searched to its end, and all that is told of it.

use crate::analysis::{DiscoverError, Prepared, Report, Rigs};
use crate::detection_limit::DetectionLimit;
use crate::found::Found;
use crate::held_out_runs::held_out_runs;
use crate::load_model::LoadModel;
use crate::locate::{Cell, Located, PureError, Residuals, map, regressors};
use crate::next::{Advice, advise};
use crate::null_distribution::NullDistribution;
use crate::recalibration::Recalibrated;
use crate::result::{
    Candidate, DiscoverResult, Estimate, HeldOutRun, MapCell, Misfit, NamedEffect, SearchResult, StatedGap,
    StatedGaps,
};
use crate::simulator::Simulator;
use crate::verdict::{Answer, Gap, Judgement};
use calibrate::{Schedule, Use};
use coupling::wing_file::{EffectValidity, WingEffect};
use maneuver::effects::Active;

/// See the module.
#[derive(Debug)]
pub struct Finding<'a> {
    /// Data and model.
    pub prepared: &'a Prepared,
    /// What is found where nothing is missing.
    pub nulls: &'a NullDistribution,
    /// What was found; its gaps after are with corrections calibrated again where the corrections are the campaign's own.
    pub report: Report<'a>,
    /// Corrections calibrated again beside the effects.
    pub recalibrated: Option<Recalibrated>,
    /// Whether the corrections are the campaign's own.
    own_corrections: bool,
    /// Experiments that would separate what is left open, the best first.
    pub advice: Vec<Advice>,
    /// The smallest sizes that would have been named, where nothing is.
    pub detection_limits: Vec<DetectionLimit>,
    /// Effects that the search ended with and that are not in the model, as the gap on training data does not shrink with them;
    /// and that gap.
    withdrawn: Option<(Vec<&'static str>, Gap)>,
}

/// Where what a finding rests on comes from.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    /// The corrections, in words.
    pub corrections: String,
    /// The null distribution, in words.
    pub null_distribution: String,
    /// Fingerprint of the data.
    pub data_hash: String,
}

impl<'a> Finding<'a> {
    /// Searches a campaign; nothing is calibrated again and no experiment is thought of.
    pub fn search(prepared: &'a Prepared, nulls: &'a NullDistribution, seed: u64) -> Self {
        let report = prepared.search(nulls, seed);
        let own_corrections = prepared.open_corrections == 1.0;
        let (advice, detection_limits) = (Vec::new(), Vec::new());
        let (recalibrated, withdrawn) = (None, None);
        let mut finding = Self {
            prepared,
            nulls,
            report,
            recalibrated,
            own_corrections,
            advice,
            detection_limits,
            withdrawn,
        };
        // corrections of the campaign's own have taken up what effects do at rest, until they are calibrated again
        if !own_corrections {
            finding.withdraw_unsupported();
        }
        finding
    }

    /// Takes effects with which the gap on training data does not shrink out of the model.
    fn withdraw_unsupported(&mut self) {
        let names = self.report.outcome.names();
        let tried = self.gap(0);
        if names.is_empty() || tried.after < tried.before {
            return;
        }
        self.report.outcome.found.clear();
        self.report.outcome.unexplained = true;
        self.report.current = self.report.current.with(&self.prepared.setting(), &[]);
        for gaps in &mut self.report.gaps {
            gaps[1] = gaps[0];
        }
        self.recalibrated = None;
        self.advice.clear();
        self.withdrawn = Some((names, tried));
    }

    /// Before and after, training or held-out runs (0, 1).
    fn gap(&self, which: usize) -> Gap {
        let [before, after] = self.report.gaps[which].map(|gap| gap.all);
        Gap { before, after, floor: self.nulls.floor[which] }
    }

    /// Thinks of the next experiment and of what would have been named.
    ///
    /// # Errors
    /// If the wing cannot be flown through an experiment.
    pub fn look_further(&mut self, rigs: &Rigs<'_>, schedule: &Schedule) -> Result<(), DiscoverError> {
        let found = &self.report.outcome.found;
        if let Some(open) = found.iter().position(|found| !found.rivals.is_empty()) {
            self.advice = advise(rigs, schedule, self.prepared, found, open)?;
        }
        self.detection_limits = self.prepared.detection_limits(&self.report, self.nulls);
        Ok(())
    }

    /// Takes corrections that were calibrated again: where the corrections are the campaign's own, the gap after is the one with
    /// these.
    pub fn recalibrate(&mut self, again: Recalibrated) {
        if self.own_corrections {
            let after = self.prepared.gaps_of(&again.simulator, &self.report.current.effects);
            for (gaps, after) in self.report.gaps.iter_mut().zip(after) {
                gaps[1] = after;
            }
        }
        self.recalibrated = Some(again);
        self.withdraw_unsupported();
    }

    /// The wing with the effects as it is flown after: with corrections calibrated again if they are the campaign's own.
    pub fn simulator_after(&self) -> &Simulator {
        let again = self.recalibrated.as_ref().filter(|_| self.own_corrections);
        again.map_or(&self.prepared.simulator, |again| &again.simulator)
    }

    fn held_out_runs(&self) -> Vec<HeldOutRun> {
        held_out_runs(self.prepared, &self.report.current, self.simulator_after())
    }

    /// What is said of it.
    pub fn judgement(&self) -> Judgement<'_> {
        let held_out = self.prepared.data.has_held_out().then(|| self.gap(1));
        let rules = &self.prepared.data.rules.verdict;
        let judgement = Judgement::new(rules, &self.report.outcome, self.gap(0), held_out);
        match &self.withdrawn {
            Some((names, training)) => Judgement { names: names.clone(), training: *training, ..judgement },
            None => judgement,
        }
    }

    /// The effects that are named.
    fn named(&self) -> &[Found] {
        match self.judgement().answer() {
            Answer::Named(..) => &self.report.outcome.found,
            Answer::Withdrawn(_) | Answer::Missing | Answer::Nothing => &[],
        }
    }

    /// What separates rivals most for its cost, if anything of the menu does; else what the library says.
    pub fn next_experiment(&self) -> Option<String> {
        let open = |effect: &&Found| !effect.confused_with.is_empty();
        let effect = self.report.outcome.found.iter().find(open)?;
        let separated = self.prepared.data.rules.verdict.separated;
        let best = self.advice.first().filter(|advice| advice.least_log_bayes_factor() >= separated);
        Some(best.map_or_else(
            || effect.active.effect.spec().experiment.to_owned(),
            |advice| {
                let least = advice.least_log_bayes_factor();
                format!("{} (expected log Bayes factor {least:.0})", advice.experiment)
            },
        ))
    }

    /// Residuals of the training data as a simulator flies them with effects.
    fn residuals(&self, simulator: &Simulator, effects: &[Active]) -> Residuals {
        let Prepared { data, noise, .. } = self.prepared;
        let flown = simulator.flown(effects, None, &self.prepared.records());
        let coefficient = |airspeed: usize, channel: usize, hz: f64| noise.sigma(airspeed, channel, hz);
        let error = PureError { coefficient: &coefficient, point: noise.point, degrees_of_freedom: None };
        Residuals::new(data, &flown, &error, &self.prepared.controls, Some(Use::Train))
    }

    /// What the residual goes with before any effect. Families of deflections are judged on all training data, the others
    /// where the controls rest, if there is such: a large residual of theirs would hide the rest.
    pub fn located(&self) -> Vec<Located> {
        let rules = &self.prepared.data.rules.locate;
        let all = self.residuals(&self.prepared.simulator, &[]);
        let mut resting = all.clone();
        let rests = |control: &Vec<f64>| control.iter().all(|delta| *delta == control[0]);
        resting.units.retain(|unit| unit.stimulus.inputs.controls_rad.iter().all(rests));
        let of_controls = |l: &Located| l.regressor.contains("delta");
        let mut listed = regressors(&all);
        if !resting.units.is_empty() {
            listed.retain(of_controls);
            listed.extend(regressors(&resting).into_iter().filter(|l| !of_controls(l)));
            listed.sort_by(|a, b| b.share_of_residual.total_cmp(&a.share_of_residual));
        }
        listed.retain(|l| l.share_of_residual >= rules.least_share && l.p_value <= rules.chance);
        listed.truncate(rules.listed);
        listed
    }

    /// The map of the residual before and after, the largest power before first.
    pub fn map(&self) -> Vec<MapCell> {
        let after = map(&self.residuals(self.simulator_after(), &self.report.current.effects));
        let cell = |before: Cell| {
            let same = |other: &&Cell| {
                (other.channel, &other.maneuver, other.band)
                    == (before.channel, &before.maneuver, before.band)
            };
            let after = after.iter().find(same).map_or(f64::NAN, |other| other.power);
            let (from_hz, to_hz) = self.prepared.data.rules.locate.bands_hz[before.band];
            let Cell { channel, maneuver, power, limit, rows, units, .. } = before;
            let channel = channel.to_owned();
            MapCell { channel, maneuver, from_hz, to_hz, before: power, after, limit, rows, units }
        };
        map(&self.residuals(&self.prepared.simulator, &[])).into_iter().map(cell).collect()
    }

    /// Entries of the wing's file.
    pub fn wing_effects(&self, data_hash: &str) -> Vec<WingEffect> {
        let data = &self.prepared.data;
        let range = |values: &mut dyn Iterator<Item = f64>| {
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
            (low <= high).then_some((low, high))
        };
        let train = || data.runs.iter().filter(|run| run.usage != Use::Holdout);
        let inputs = || train().map(|run| &run.stimulus.inputs);
        let degrees = |rad: &f64| rad.to_degrees();
        let validity = EffectValidity {
            alpha_deg: range(&mut inputs().flat_map(|inputs| &inputs.alpha.value).map(degrees)),
            v_m_s: range(&mut train().map(|run| data.airspeeds_m_s[run.airspeed])),
            frequency_hz: Some((0.0, data.rules.data.highest_hz)),
            delta_deg: range(
                &mut inputs().flat_map(|inputs| inputs.controls_rad.iter().flatten()).map(degrees),
            ),
        };
        let entry = |effect: &Found| {
            let names = || effect.active.parameters().into_iter().map(|p| p.name);
            WingEffect {
                name: effect.name().to_owned(),
                form: effect.active.effect.form().to_owned(),
                parameters: names().zip(effect.active.values.iter().copied()).collect(),
                sigma: names().zip(effect.sigma.iter().copied()).collect(),
                covariance: Vec::new(),
                validity: Some(validity),
                evidence: Some(effect.evidence),
                rivals: effect.confused_with.iter().map(|name| (*name).to_owned()).collect(),
                data_hash: data_hash.to_owned(),
            }
        };
        self.named().iter().map(entry).collect()
    }

    /// `result.json`; the residual is located in it if `with_located`, which takes some seconds.
    pub fn result(&self, sources: &Sources, with_located: bool, seconds: f64) -> DiscoverResult {
        let (Prepared { data, noise, spectral_lines, .. }, outcome) = (self.prepared, &self.report.outcome);
        let judgement = self.judgement();
        let (runs, points) = (data.run_loads, data.static_loads());
        let has = std::array::from_fn(|c| runs[c] || points[c]);
        let [training, holdout] = [0, 1].map(|which| match which {
            1 if !data.has_held_out() => StatedGap::default(),
            _ => StatedGap::new(self.report.gaps[which], self.nulls.floor[which], has),
        });
        let misfit = Misfit {
            before: outcome.misfit[0],
            after: outcome.misfit[1],
            nothing_missing: self.nulls.misfit,
            limit: self.nulls.misfit_limit,
        };
        let search = SearchResult {
            sentence: judgement.sentence(),
            located: if with_located { self.located() } else { Vec::new() },
            next_experiment: self.next_experiment(),
            experiments: self.advice.clone(),
            gap: Some(StatedGaps { training, holdout }),
            held_out_runs: if with_located { self.held_out_runs() } else { Vec::new() },
            success: judgement.is_success(),
            supported: judgement.is_supported(),
            not_used: data.not_used.clone(),
            misfit,
            not_named: outcome.next_best.as_ref().map(|next| Candidate {
                name: next.name().to_owned(),
                log_bayes_factor: next.evidence,
                threshold: next.threshold,
            }),
            candidates: outcome
                .first_ranking
                .iter()
                .map(|one| Candidate {
                    name: one.label().trim().to_owned(),
                    log_bayes_factor: one.evidence,
                    threshold: one.threshold,
                })
                .collect(),
            detection_limits: self.detection_limits.clone(),
            steps: outcome.trace.clone(),
            spectral_lines: spectral_lines.clone(),
            noise_beyond_stated: self.prepared.noise_beyond_stated.clone(),
            corrections: sources.corrections.clone(),
            null_distribution: sources.null_distribution.clone(),
            data_hash: sources.data_hash.clone(),
            split: data.split.clone(),
            repeated_pairs: noise.pairs,
            model_runs: Some(self.report.model_runs),
            map: with_located.then(|| self.map()),
        };
        DiscoverResult {
            command: "discover".to_owned(),
            verdict: judgement.kind(),
            effects: self.named().iter().map(named).collect(),
            defects: Vec::new(),
            refused: None,
            seconds: Some(seconds),
            search: Some(search),
        }
    }
}

fn named(effect: &Found) -> NamedEffect {
    let spec = effect.active.effect.spec();
    let values = effect.active.values.iter().zip(&effect.sigma);
    let parameters = effect.active.parameters().into_iter().zip(values);
    NamedEffect {
        name: spec.name.to_owned(),
        form: effect.active.effect.form().to_owned(),
        title: spec.title.to_owned(),
        confidence: Some(effect.confidence),
        confused_with: effect.confused_with.iter().map(|name| (*name).to_owned()).collect(),
        log_bayes_factor: Some(effect.evidence),
        stays_with_the_wing: spec.side.travels(),
        parameters: parameters
            .map(|(p, (value, sigma))| (p.name, Estimate { value: *value, sigma: Some(*sigma) }))
            .collect(),
        parts: effect.shares.clone(),
    }
}
