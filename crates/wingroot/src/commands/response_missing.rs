//! `response --missing`: where what a model leaves of measured coefficients sits, which term it lacks, and the gap before
//! and after.

use std::time::Instant;

use nastran::InputError;
use rayon::prelude::*;
use response::missing::{Family, Missing, Named, find_missing};
use response::verdict::{Gap, VerdictKind};
use serde_json::{Map, Value, json};

use super::response_missing_text as text;
use super::response_models::{Asked, asked};
use super::response_source::Source;
use crate::args::{Common, ResponseArgs};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Seed if none is given.
const SEED: u64 = 1;

/// Runs the command.
pub(super) fn run(args: &ResponseArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let source = Source::read(args)?;
    let seed = common.seed.unwrap_or(SEED);
    let all = asked(args, &source, seed)?;
    let answer = |one: &Asked| {
        let found = find_missing(&one.data, &one.response, &one.question);
        found.map_err(|fault| {
            let at = format!("{}, {}: {fault}", one.file, one.response);
            let error = InputError::general(at);
            Failure::from(match fault {
                response::Fault::NoReplicates { .. } => {
                    error.with_help("say the standard deviation of one reading with --noise")
                }
                _ => error,
            })
        })
    };
    let found: Vec<Missing> = all.par_iter().map(answer).collect::<Result<_, _>>()?;
    let pairs: Vec<(&Asked, &Missing)> = all.iter().zip(&found).collect();
    let folder = ResultFolder::begin(&common.out("response"))?;
    folder.write_text("candidates.csv", &text::candidates_csv(&pairs))?;
    folder.write_text("families.csv", &text::families_csv(&pairs))?;
    let seconds = start.elapsed().as_secs_f64();
    let result = json(&source.name, &pairs, seed, seconds);
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let head = format!("{}: what the models lack\n", source.name);
    let body: String = pairs.iter().map(|(asked, found)| text::response(asked, found)).collect();
    let end = format!("\nwritten to {} in {seconds:.1} s", out.display());
    show::summary(common, &format!("{head}{body}{end}"));
    show::json(common, &result)
}

/// `result.json`, with the keys of discover's.
fn json(name: &str, pairs: &[(&Asked, &Missing)], seed: u64, seconds: f64) -> Value {
    let merged = |of: &dyn Fn(&Asked, &Missing) -> Vec<Value>| -> Vec<Value> {
        pairs.iter().flat_map(|(asked, found)| of(asked, found)).collect()
    };
    let gap = |of: &dyn Fn(&Missing) -> Gap| {
        let rms = |part: &dyn Fn(Gap) -> f64| {
            let squares: f64 = pairs.iter().map(|(_, found)| part(of(found)).powi(2)).sum();
            (squares / pairs.len().max(1) as f64).sqrt()
        };
        Gap { before: rms(&|g| g.before), after: rms(&|g| g.after), floor: rms(&|g| g.floor) }
    };
    json!({
        "command": "response", "name": name, "looked_for": "missing terms",
        "verdict": overall(pairs),
        "located": merged(&located),
        "effects": merged(&|asked, found| named_and_closest(asked, found).0),
        "gap": { "training": gap(&|found| found.training), "holdout": gap(&|found| found.held_out) },
        "responses": pairs.iter().map(|(asked, found)| response(asked, found)).collect::<Vec<_>>(),
        "seed": seed, "seconds": seconds,
    })
}

/// The answer for all responses together: what is least settled.
fn overall(pairs: &[(&Asked, &Missing)]) -> VerdictKind {
    let order = [VerdictKind::Unknown, VerdictKind::Ambiguous, VerdictKind::Effects];
    let any = |verdict: &VerdictKind| pairs.iter().any(|(_, found)| found.verdict == *verdict);
    order.into_iter().find(any).unwrap_or(VerdictKind::None)
}

fn located(asked: &Asked, found: &Missing) -> Vec<Value> {
    let families = found.families.iter().filter(|family| found.is_located(family));
    let one = |family: &Family| {
        json!({
            "channel": asked.response, "data": asked.file, "regressor": family.name, "terms": family.members,
            "share_of_residual": family.share, "f": family.alone.f, "p_value": family.alone.p_value,
            "beside_others": family.beside_others.map(|test| json!({ "f": test.f, "p_value": test.p_value })),
        })
    };
    families.map(one).collect()
}

fn effect(asked: &Asked, named: &Named) -> Value {
    let parameters = named.parameters.iter().map(|parameter| {
        (parameter.name.clone(), json!({ "value": parameter.value, "sigma": parameter.sigma }))
    });
    json!({
        "name": named.name, "channel": asked.response, "data": asked.file,
        "kind": if named.is_block { "block" } else { "term" },
        "confidence": named.confidence, "confused_with": named.confused_with,
        "correlation": named.correlation, "log_bayes_factor": named.log_bayes_factor, "threshold": named.threshold,
        "share_of_misfit": named.share, "parameters": parameters.collect::<Map<_, _>>(),
    })
}

/// What was named, and of an unknown what only comes closest.
fn named_and_closest(asked: &Asked, found: &Missing) -> (Vec<Value>, Vec<Value>) {
    let all = found.named.iter().map(|named| effect(asked, named)).collect();
    if found.verdict == VerdictKind::Unknown { (Vec::new(), all) } else { (all, Vec::new()) }
}

fn response(asked: &Asked, found: &Missing) -> Value {
    let (effects, closest) = named_and_closest(asked, found);
    let candidate = |(name, factor): &(String, f64)| json!({ "name": name, "log_bayes_factor": factor, "threshold": found.threshold });
    let limits = found.detection_limits.iter().map(|one| (one.term.to_string(), json!(one.coefficient)));
    json!({
        "name": found.response, "data": asked.file, "verdict": found.verdict,
        "model": asked.question.model,
        "model_blocks": asked.question.blocks, "model_from": asked.origin, "hidden": asked.hidden,
        "published_coefficient": asked.published, "model_terms_not_told_apart": asked.left_out,
        "located": located(asked, found), "effects": effects, "closest": closest,
        "gap": { "training": found.training, "holdout": found.held_out },
        "success": found.closed(),
        "misfit": { "before": found.misfit[0], "after": found.misfit[1], "limit": found.misfit_limit },
        "candidates": found.candidates.iter().map(candidate).collect::<Vec<_>>(),
        "not_told_from_the_model": found.untold,
        "detection_limits": limits.collect::<Map<_, _>>(),
        "pure_error_standard_deviation": found.noise,
        "split": { "training_points": found.split.training.len(), "held_out_points": found.split.held_out.len(),
            "held_out_rows": found.split.held_out.iter().map(|row| row + 1).collect::<Vec<_>>(),
            "how": "distinct points drawn at random, each with all its replicates" },
    })
}
