//! `result.json` of `response --missing`.

use std::collections::BTreeMap;

use discover::result::BeforeAfter;
use response::Term;
use response::verdict::{Gap, VerdictKind};
use schemars::JsonSchema;
use serde::Serialize;

/// Which terms models of measured coefficients lack; with the keys of `discover`'s result.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MissingResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the study.
    pub(crate) name: String,
    /// What was looked for.
    pub(crate) looked_for: &'static str,
    /// The answer for all responses together: what is least settled.
    pub(crate) verdict: VerdictKind,
    /// What the residuals go with.
    pub(crate) located: Vec<LocatedFamily>,
    /// What was named.
    pub(crate) effects: Vec<NamedTerm>,
    /// Gaps of all responses, root mean square.
    pub(crate) gap: Gaps,
    /// By response.
    pub(crate) responses: Vec<MissingOfResponse>,
    /// Seed of the split and of the campaigns drawn.
    pub(crate) seed: u64,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// Gaps of the points that were fitted and of the others.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Gaps {
    /// Points that were fitted.
    pub(crate) training: Gap,
    /// Points that only judge.
    pub(crate) holdout: Gap,
}

/// A family of regressors that the residual goes with.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct LocatedFamily {
    /// The response.
    pub(crate) channel: String,
    /// The table.
    pub(crate) data: String,
    /// The family.
    pub(crate) regressor: String,
    /// Its terms.
    pub(crate) terms: Vec<String>,
    /// Share of the residual that it takes.
    pub(crate) share_of_residual: f64,
    /// F statistic of the family alone; null if what it is set beside is zero.
    #[schemars(with = "Option<f64>")]
    pub(crate) f: f64,
    /// Probability of an F as large by chance; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) p_value: f64,
    /// The same beside all other families; null if it has no rival.
    pub(crate) beside_others: Option<BesideOthers>,
}

/// A test of a family beside the others.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct BesideOthers {
    /// F statistic; null if what it is set beside is zero.
    #[schemars(with = "Option<f64>")]
    pub(crate) f: f64,
    /// Probability of an F as large by chance; null if there is no test.
    #[schemars(with = "Option<f64>")]
    pub(crate) p_value: f64,
}

/// A term, or offsets of blocks, that was named.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct NamedTerm {
    /// Its name.
    pub(crate) name: String,
    /// The response.
    pub(crate) channel: String,
    /// The table.
    pub(crate) data: String,
    /// `term` or `block`.
    pub(crate) kind: &'static str,
    /// Probability that it is right.
    pub(crate) confidence: f64,
    /// What these points do not tell from it.
    pub(crate) confused_with: Vec<String>,
    /// Correlations with these.
    pub(crate) correlation: Vec<f64>,
    /// Logarithm of its Bayes factor.
    pub(crate) log_bayes_factor: f64,
    /// What it needed.
    pub(crate) threshold: f64,
    /// Share of the misfit that it takes.
    pub(crate) share_of_misfit: f64,
    /// Its coefficients, unit of the response over that of the term.
    pub(crate) parameters: BTreeMap<String, CoefficientEstimate>,
}

/// A coefficient.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub(crate) struct CoefficientEstimate {
    /// Its value.
    pub(crate) value: f64,
    /// One standard deviation; null if the data do not determine it.
    pub(crate) sigma: Option<f64>,
}

/// What the model of one response lacks.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MissingOfResponse {
    /// The response.
    pub(crate) name: String,
    /// The table.
    pub(crate) data: String,
    /// The answer.
    pub(crate) verdict: VerdictKind,
    /// Terms of the model.
    pub(crate) model: Vec<Term>,
    /// Block columns whose offsets it has.
    pub(crate) model_blocks: Vec<String>,
    /// Where the model is from.
    pub(crate) model_from: String,
    /// What was taken out of it first; null for nothing.
    pub(crate) hidden: Option<String>,
    /// The published coefficient of that; null if no published model says it.
    pub(crate) published_coefficient: Option<f64>,
    /// Terms of the model that these points do not tell from its others, left out.
    pub(crate) model_terms_not_told_apart: Vec<String>,
    /// What the residual goes with.
    pub(crate) located: Vec<LocatedFamily>,
    /// What was named.
    pub(crate) effects: Vec<NamedTerm>,
    /// What only comes closest, where nothing was named.
    pub(crate) closest: Vec<NamedTerm>,
    /// Gaps.
    pub(crate) gap: Gaps,
    /// Whether what was named closes the gap of the points that only judge.
    pub(crate) success: bool,
    /// Mean square of the residual over pure error.
    pub(crate) misfit: MisfitResult,
    /// Candidates by evidence.
    pub(crate) candidates: Vec<CandidateTerm>,
    /// Candidates that these points do not tell from the model.
    pub(crate) not_told_from_the_model: Vec<String>,
    /// The smallest coefficient that would have been found, by term; null if none would.
    #[schemars(with = "BTreeMap<String, Option<f64>>")]
    pub(crate) detection_limits: BTreeMap<String, f64>,
    /// Standard deviation of one reading; null if no point was repeated.
    #[schemars(with = "Option<f64>")]
    pub(crate) pure_error_standard_deviation: f64,
    /// Which points only judge.
    pub(crate) split: SplitResult,
}

/// Mean square of the residual over pure error, where one is expected.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MisfitResult {
    /// With the model, and with what was named.
    #[serde(flatten)]
    pub(crate) of: BeforeAfter<f64>,
    /// Above this something is missing.
    pub(crate) limit: f64,
}

/// A candidate.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CandidateTerm {
    /// Its name.
    pub(crate) name: String,
    /// Logarithm of its Bayes factor.
    pub(crate) log_bayes_factor: f64,
    /// What it needs.
    pub(crate) threshold: f64,
}

/// Which points only judge.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SplitResult {
    /// How many were fitted.
    pub(crate) training_points: usize,
    /// How many only judge.
    pub(crate) held_out_points: usize,
    /// The rows of these, from 1.
    pub(crate) held_out_rows: Vec<usize>,
    /// How they were chosen.
    pub(crate) how: &'static str,
}
