//! `response --missing`: where what a model leaves of measured coefficients sits, which term it lacks, and the gap before
//! and after.

use std::time::Instant;

use discover::result::BeforeAfter;
use nastran::InputError;
use rayon::prelude::*;
use response::missing::{Family, Missing, Named, find_missing};
use response::verdict::{Gap, VerdictKind};

use super::response_missing_result::{
    BesideOthers, CandidateTerm, CoefficientEstimate, Gaps, LocatedFamily, MisfitResult, MissingOfResponse,
    MissingResult, NamedTerm, SplitResult,
};
use super::response_missing_text as text;
use super::response_models::{Asked, asked};
use super::response_source::Source;
use crate::args::{Common, ResponseArgs};
use crate::commands::result_parts::as_json;
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
    let result = as_json(&result(&source.name, &pairs, seed, seconds))?;
    folder.write_json("result.json", &result)?;
    let out = folder.commit()?;
    let head = format!("{}: what the models lack\n", source.name);
    let body: String = pairs.iter().map(|(asked, found)| text::response(asked, found)).collect();
    let end = format!("\nwritten to {} in {seconds:.1} s", out.display());
    show::summary(common, &format!("{head}{body}{end}"));
    show::json(common, &result)
}

/// `result.json`, with the keys of discover's.
fn result(name: &str, pairs: &[(&Asked, &Missing)], seed: u64, seconds: f64) -> MissingResult {
    let gap = |of: &dyn Fn(&Missing) -> Gap| {
        let rms = |part: &dyn Fn(Gap) -> f64| {
            let squares: f64 = pairs.iter().map(|(_, found)| part(of(found)).powi(2)).sum();
            (squares / pairs.len().max(1) as f64).sqrt()
        };
        Gap { before: rms(&|g| g.before), after: rms(&|g| g.after), floor: rms(&|g| g.floor) }
    };
    MissingResult {
        command: "response",
        name: name.to_owned(),
        looked_for: "missing terms",
        verdict: overall(pairs),
        located: pairs.iter().flat_map(|(asked, found)| located(asked, found)).collect(),
        effects: pairs.iter().flat_map(|(asked, found)| named_and_closest(asked, found).0).collect(),
        gap: Gaps { training: gap(&|found| found.training), holdout: gap(&|found| found.held_out) },
        responses: pairs.iter().map(|(asked, found)| response(asked, found)).collect(),
        seed,
        seconds,
    }
}

/// The answer for all responses together: what is least settled.
fn overall(pairs: &[(&Asked, &Missing)]) -> VerdictKind {
    let order = [VerdictKind::Unknown, VerdictKind::Ambiguous, VerdictKind::Effects];
    let any = |verdict: &VerdictKind| pairs.iter().any(|(_, found)| found.verdict == *verdict);
    order.into_iter().find(any).unwrap_or(VerdictKind::None)
}

fn located(asked: &Asked, found: &Missing) -> Vec<LocatedFamily> {
    let families = found.families.iter().filter(|family| found.is_located(family));
    let one = |family: &Family| LocatedFamily {
        channel: asked.response.clone(),
        data: asked.file.clone(),
        regressor: family.name.clone(),
        terms: family.members.clone(),
        share_of_residual: family.share,
        f: family.alone.f,
        p_value: family.alone.p_value,
        beside_others: family.beside_others.map(|test| BesideOthers { f: test.f, p_value: test.p_value }),
    };
    families.map(one).collect()
}

fn effect(asked: &Asked, named: &Named) -> NamedTerm {
    let parameters = named.parameters.iter().map(|parameter| {
        let (value, sigma) = (parameter.value, parameter.sigma);
        (parameter.name.clone(), CoefficientEstimate { value, sigma })
    });
    NamedTerm {
        name: named.name.clone(),
        channel: asked.response.clone(),
        data: asked.file.clone(),
        kind: if named.is_block { "block" } else { "term" },
        confidence: named.confidence,
        confused_with: named.confused_with.clone(),
        correlation: named.correlation.clone(),
        log_bayes_factor: named.log_bayes_factor,
        threshold: named.threshold,
        share_of_misfit: named.share,
        parameters: parameters.collect(),
    }
}

/// What was named, and of an unknown what only comes closest.
fn named_and_closest(asked: &Asked, found: &Missing) -> (Vec<NamedTerm>, Vec<NamedTerm>) {
    let all = found.named.iter().map(|named| effect(asked, named)).collect();
    if found.verdict == VerdictKind::Unknown { (Vec::new(), all) } else { (all, Vec::new()) }
}

fn response(asked: &Asked, found: &Missing) -> MissingOfResponse {
    let (effects, closest) = named_and_closest(asked, found);
    let candidate = |(name, factor): &(String, f64)| CandidateTerm {
        name: name.clone(),
        log_bayes_factor: *factor,
        threshold: found.threshold,
    };
    let [before, after] = found.misfit;
    MissingOfResponse {
        name: found.response.clone(),
        data: asked.file.clone(),
        verdict: found.verdict,
        model: asked.question.model.clone(),
        model_blocks: asked.question.blocks.clone(),
        model_from: asked.origin.clone(),
        hidden: asked.hidden.clone(),
        published_coefficient: asked.published,
        model_terms_not_told_apart: asked.left_out.clone(),
        located: located(asked, found),
        effects,
        closest,
        gap: Gaps { training: found.training, holdout: found.held_out },
        success: found.closed(),
        misfit: MisfitResult { of: BeforeAfter { before, after }, limit: found.misfit_limit },
        candidates: found.candidates.iter().map(candidate).collect(),
        not_told_from_the_model: found.untold.clone(),
        detection_limits: found
            .detection_limits
            .iter()
            .map(|one| (one.term.to_string(), one.coefficient))
            .collect(),
        pure_error_standard_deviation: found.noise,
        split: SplitResult {
            training_points: found.split.training.len(),
            held_out_points: found.split.held_out.len(),
            held_out_rows: found.split.held_out.iter().map(|row| row + 1).collect(),
            how: "distinct points drawn at random, each with all its replicates",
        },
    }
}
