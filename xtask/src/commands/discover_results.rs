//! What `discover` found as JSON, as entries of a wing's file and as a table for people.

use std::fmt::Write as _;
use std::path::Path;

use coupling::wing_file::{EffectValidity, WingEffect};
use discover::consistency::Share;
use discover::data_checks::Defect;
use discover::found::Found;
use discover::gap::Gap;
use discover::next::Advice;
use discover::spectral_lines::{SpectralLine, sentence};
use serde_json::{Map, Value, json};

use crate::commands::discover::Discovered;
use crate::commands::discover_sentence;

/// An experiment that separates rivals by less is no advice.
const SEPARATED_LOG_BAYES_FACTOR: f64 = 5.0;
/// Held out, the gap may be so many times its floor.
pub(crate) const CLOSED: f64 = 2.0;

/// effects, ambiguous, unknown or none: a gap well above what is left where nothing is missing is not none, even if no
/// effect has the evidence that it needs.
pub(crate) fn verdict(found: &Discovered<'_>) -> &'static str {
    let outcome = &found.report.outcome;
    let ambiguous = |effect: &Found| !effect.confused_with.is_empty();
    if outcome.found.is_empty() {
        if outcome.unexplained || is_far_above_floor(found) { "unknown" } else { "none" }
    } else if outcome.found.iter().any(ambiguous) {
        "ambiguous"
    } else {
        "effects"
    }
}

/// `result.json`.
pub(crate) fn json(found: &Discovered<'_>, located: &[Value], seconds: f64) -> Value {
    let outcome = &found.report.outcome;
    let parameters = |effect: &Found| {
        let each = effect.active.parameters().into_iter().zip(effect.active.values.iter().zip(&effect.sigma));
        each.map(|(p, (value, sigma))| (p.name, json!({ "value": value, "sigma": sigma })))
            .collect::<Map<_, _>>()
    };
    let effect = |effect: &Found| {
        let spec = effect.active.effect.spec();
        json!({ "name": spec.name, "form": effect.active.effect.form(), "title": spec.title,
            "confidence": effect.confidence, "confused_with": effect.confused_with,
            "log_bayes_factor": effect.evidence, "stays_with_the_wing": spec.side.travels(),
            "parameters": parameters(effect), "parts": effect.shares.iter().map(part).collect::<Vec<_>>() })
    };
    let line = |line: &SpectralLine| {
        json!({ "channel": line.channel, "v_m_s": line.v_m_s, "frequency_hz": line.frequency_hz,
            "times_its_neighbourhood": line.times })
    };
    let [train, holdout] = found.report.gaps;
    json!({
        "command": "discover",
        "verdict": verdict(found),
        "sentence": discover_sentence::sentence(found),
        "located": located,
        "effects": outcome.found.iter().map(effect).collect::<Vec<_>>(),
        "next_experiment": next_experiment(found),
        "experiments": experiments(found),
        "gap": { "training": gap(found, 0, train), "holdout": gap(found, 1, holdout) },
        "success": success(found),
        "supported": is_supported(found),
        "not_used": found.prepared.data.not_used,
        "misfit": { "before": outcome.misfit[0], "after": outcome.misfit[1],
            "nothing_missing": found.limits.misfit, "limit": found.limits.misfit_limit },
        "not_named": outcome.next_best.as_ref().map(|next| {
            json!({ "name": next.name(), "log_bayes_factor": next.evidence, "threshold": next.threshold })
        }),
        "candidates": outcome.first_ranking.iter().map(|one| {
            json!({ "name": one.label().trim(), "log_bayes_factor": one.evidence, "threshold": one.threshold })
        }).collect::<Vec<_>>(),
        "detection_limits": found.detection_limits.iter().map(|limit| {
            json!({ "name": limit.name, "form": limit.form, "parameter": limit.parameter, "value": limit.value })
        }).collect::<Vec<_>>(),
        "search": outcome.trace,
        "spectral_lines": found.prepared.spectral_lines.iter().map(line).collect::<Vec<_>>(),
        "corrections": found.corrected.origin,
        "null_distribution": found.nulls_from,
        "data_hash": found.data_hash,
        "split": found.prepared.data.split,
        "repeated_pairs": found.prepared.noise.pairs,
        "model_runs": found.report.model_runs,
        "seconds": seconds,
    })
}

/// The size that one part of the data would give an effect, over the one that was found.
fn part(share: &Share) -> Value {
    json!({ "v_m_s": share.v_m_s, "moved": share.moved.word(), "share": share.share, "sigma": share.sigma })
}

/// `result.json` where the data are at fault.
pub(crate) fn defects(found: &[Defect], seconds: f64) -> Value {
    let defect = |d: &Defect| json!({ "kind": format!("{:?}", d.kind), "run": d.run, "channel": d.channel, "sentence": d.sentence });
    json!({ "command": "discover", "verdict": "data_defect", "effects": [],
        "defects": found.iter().map(defect).collect::<Vec<_>>(), "seconds": seconds })
}

/// The gap of training (0) or held-out data (1); without numbers where there are no such data, or not this load.
fn gap(found: &Discovered<'_>, which: usize, [before, after]: [Gap; 2]) -> Value {
    let data = &found.prepared.data;
    if which == 1 && !data.has_held_out() {
        return json!({ "before": null, "after": null, "floor": null });
    }
    let floor = found.limits.floor[which];
    let (runs, points) = (data.run_loads, data.static_loads());
    let of = |v: [f64; 3], c: usize| (runs[c] || points[c]).then_some(v[c]);
    let channels = |v: [f64; 3]| json!({ "Fz_N": of(v, 0), "Mx_Nm": of(v, 1), "My_Nm": of(v, 2) });
    json!({ "before": before.all, "after": after.all, "floor": floor,
        "by_channel": { "before": channels(before.by_channel), "after": channels(after.by_channel) },
        "raw_percent": { "before": channels(before.raw_percent), "after": channels(after.raw_percent) } })
}

/// The gap of the training data is more than twice what is left where nothing is missing.
pub(crate) fn is_far_above_floor(found: &Discovered<'_>) -> bool {
    found.report.gaps[0][1].all > CLOSED * found.limits.floor[0]
}

/// Whether the training data come nearer with the effects in the model; true without any.
pub(crate) fn is_supported(found: &Discovered<'_>) -> bool {
    let [before, after] = found.report.gaps[0];
    found.report.outcome.found.is_empty() || after.all < before.all
}

/// The held-out gap shrank, and to at most twice what is left where nothing is missing.
pub(crate) fn success(found: &Discovered<'_>) -> bool {
    let [before, after] = found.report.gaps[1];
    !found.report.outcome.found.is_empty()
        && is_supported(found)
        && found.prepared.data.has_held_out()
        && after.all < before.all
        && after.all <= CLOSED * found.limits.floor[1]
}

/// What separates rivals most for its cost, if anything of the menu does; else what the library says.
fn next_experiment(found: &Discovered<'_>) -> Option<String> {
    let open = |effect: &&Found| !effect.confused_with.is_empty();
    let effect = found.report.outcome.found.iter().find(open)?;
    let best =
        found.advice.first().filter(|advice| advice.least_log_bayes_factor() >= SEPARATED_LOG_BAYES_FACTOR);
    Some(best.map_or_else(
        || effect.active.effect.spec().experiment.to_owned(),
        |advice| {
            format!(
                "{} (expected log Bayes factor {:.0})",
                advice.experiment,
                advice.least_log_bayes_factor()
            )
        },
    ))
}

/// Experiments as JSON.
fn experiments(found: &Discovered<'_>) -> Value {
    let each = |advice: &Advice| {
        let factors: Map<_, _> = advice
            .log_bayes_factors
            .iter()
            .map(|(name, factor)| ((*name).to_owned(), json!(factor)))
            .collect();
        json!({ "experiment": advice.experiment, "cost": advice.cost, "expected_log_bayes_factor": factors })
    };
    found.advice.iter().map(each).collect()
}

/// Entries of the wing's file.
pub(crate) fn effects(found: &Discovered<'_>) -> Vec<WingEffect> {
    let data = &found.prepared.data;
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        (low <= high).then_some((low, high))
    };
    let train = || data.runs.iter().filter(|run| !crate::commands::discover::is_held_out(run.usage));
    let validity = EffectValidity {
        alpha_deg: range(
            &mut train().flat_map(|run| &run.stimulus.inputs.alpha.value).map(|a| a.to_degrees()),
        ),
        v_m_s: range(&mut train().map(|run| data.airspeeds_m_s[run.airspeed])),
        frequency_hz: Some((0.0, data.rules.data.highest_hz)),
        delta_deg: range(
            &mut train()
                .flat_map(|run| run.stimulus.inputs.controls_rad.iter().flatten())
                .map(|d| d.to_degrees()),
        ),
    };
    let entry = |effect: &Found| {
        let names: Vec<String> = effect.active.parameters().into_iter().map(|p| p.name).collect();
        WingEffect {
            name: effect.active.effect.spec().name.to_owned(),
            form: effect.active.effect.form().to_owned(),
            parameters: names.iter().cloned().zip(effect.active.values.iter().copied()).collect(),
            sigma: names.into_iter().zip(effect.sigma.iter().copied()).collect(),
            covariance: Vec::new(),
            validity: Some(validity),
            evidence: Some(effect.evidence),
            rivals: effect.confused_with.iter().map(|name| (*name).to_owned()).collect(),
            data_hash: found.data_hash.clone(),
        }
    };
    found.report.outcome.found.iter().map(entry).collect()
}

/// The table for people.
pub(crate) fn summary(found: &Discovered<'_>, out: &Path, seconds: f64) -> String {
    let mut text = String::new();
    let outcome = &found.report.outcome;
    for effect in &outcome.found {
        let spec = effect.active.effect.spec();
        let _ = writeln!(
            text,
            "{}: {} (log Bayes factor {:.0}, confidence {:.2})",
            spec.name, spec.title, effect.evidence, effect.confidence
        );
        for (p, (value, sigma)) in
            effect.active.parameters().iter().zip(effect.active.values.iter().zip(&effect.sigma))
        {
            let _ = writeln!(text, "    {:<24} {value:>10.4} +- {sigma:.4}", p.name);
        }
        if !effect.confused_with.is_empty() {
            let _ = writeln!(text, "    not told from: {}", effect.confused_with.join(", "));
        }
    }
    if let Some(next) = next_experiment(found) {
        let _ = writeln!(text, "next: {next}");
    }
    let data = &found.prepared.data;
    let shown = if data.has_held_out() { 2 } else { 1 };
    for (which, name) in ["training", "held out"].into_iter().enumerate().take(shown) {
        let ([before, after], floor) = (found.report.gaps[which], found.limits.floor[which]);
        let _ = writeln!(
            text,
            "gap, {name:<9} {:>6.1} -> {:>5.1} standard deviations of the noise (nothing missing: {floor:.1})",
            before.all, after.all
        );
    }
    if !data.not_used.is_empty() {
        let _ = writeln!(text, "not used: {} (residuals are root loads)", data.not_used.join(", "));
    }
    if let Some(line) = sentence(&found.prepared.data.rules.spectral_lines, &found.prepared.spectral_lines) {
        let _ = writeln!(text, "{line}");
    }
    let _ = writeln!(text, "{}", discover_sentence::sentence(found));
    let _ = writeln!(
        text,
        "{seconds:.1} s, {} model runs; results in {}",
        found.report.model_runs,
        out.display()
    );
    text
}
