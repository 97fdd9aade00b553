//! Choice of terms by the predicted squared error, PSE = MSE + 2 sigma0^2 m / N (Eq. 1 of paper 2): mean squared error of the fit, and
//! a penalty for every one of its m terms. Of each size the best set is looked for; the curve over the sizes is kept, and
//! its lowest point is chosen.
//!
//! What sigma0^2 is decides everything: a term that takes S off the residual sum stays if S > 2 sigma0^2. With the variance
//! of errors itself terms stay from |t| = sqrt(2) on, and one spurious candidate in six would; with Morelli's upper bound,
//! the variance of the response about its mean, only terms stay that one sees without statistics. The rule here sets
//! sigma0^2 = t0^2 s^2 / 2, so that a term stays if its |t| is above t0 = 3: of spurious candidates 1 in 370 passes, of
//! terms of five standard errors 98 in 100.

mod criteria;
mod reduced;
mod search;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::pure_error::pure_error;
use crate::regression::Regression;
use crate::reml::{decorrelated, transformed, variance_ratio};
use crate::term::Term;
use crate::total_sum::total_sum;

pub use criteria::Criteria;
use criteria::Shared;
use reduced::Reduced;
use search::{best_subsets, ranked, stepwise};

/// How sets are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
pub enum Search {
    /// Morelli's ranking: candidates orthogonalised one after the other, always the one that takes most off the residual.
    Ranked,
    /// The same with steps back.
    Stepwise,
    /// All subsets, by branch and bound: first for the lowest predicted squared error, then for every size; each ended early
    /// (and said so) if it takes too long.
    #[default]
    BestSubset,
}

/// The rule for sigma0^2.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
pub enum ErrorRule {
    /// t0^2 s^2 / 2: a term stays from |t| = t0 on. s^2 is the larger of the pure error of replicates (offsets of blocks
    /// taken out; if there are any) and the residual variance with all candidates, so that neither replicates that are
    /// too good nor candidates that do not suffice let terms in.
    LeastT(f64),
    /// Morelli's upper bound: the variance of the response about its mean, offsets of blocks taken out.
    AboutMean,
    /// A number, unit of the response squared.
    Given(f64),
}

impl Default for ErrorRule {
    fn default() -> Self {
        Self::LeastT(3.0)
    }
}

/// How terms are chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// How sets are looked for.
    pub search: Search,
    /// What sigma0^2 is.
    pub error: ErrorRule,
    /// What is done with blocks. Offsets are never a matter of choice.
    pub blocking: Blocking,
    /// A term brings with it the candidates that a shift of the factors' origins makes out of it ([`Term::is_above`]), so
    /// that the choice does not depend on where angles are counted from.
    pub hierarchical: bool,
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            search: Search::default(),
            error: ErrorRule::default(),
            blocking: Blocking::Fixed,
            hierarchical: true,
        }
    }
}

/// One size on the curve.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Step {
    /// The best terms of this size that were found, in the order of the candidates.
    #[serde(rename = "chosen_terms")]
    pub terms: Vec<Term>,
    /// Their criteria.
    #[serde(flatten)]
    pub criteria: Criteria,
}

/// The chosen terms and how it came to them.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// The chosen surface, fitted.
    pub fitted: Regression,
    /// The curve over the number of terms.
    pub curve: Vec<Step>,
    /// Index of the chosen size on the curve.
    pub chosen: usize,
    /// sigma0^2, unit of the response squared.
    pub sigma0_squared: f64,
    /// False if the search of all subsets was ended before it was certain that no other has a lower predicted squared error.
    pub complete: bool,
    /// False if that search was ended before the same was certain of the residual sum of every size.
    pub curve_complete: bool,
}

/// Candidates that a search can take.
const MOST_CANDIDATES: usize = 60;

/// Chooses among candidate terms. The constant always stays if it is among them.
///
/// # Errors
/// As [`Regression::fit`] for the model with all candidates; if there are more than 60.
pub fn choose(data: &Data, response: &str, candidates: &[Term], rules: Rules) -> Result<Choice, Fault> {
    // the model with everything first: its faults are those of the data
    let full = Regression::fit(data, response, candidates, rules.blocking)?;
    let (constant, free): (Vec<Term>, Vec<Term>) = candidates.iter().cloned().partition(Term::is_constant);
    let few = free.len() <= MOST_CANDIDATES;
    Fault::unless(few, "the number of candidate terms", free.len() as f64, "at most 60")?;
    let sigma0_squared = sigma0_squared(data, response, &full, rules)?;
    let mut y = data.response_values(response)?.to_vec();
    let mut always = Columns::of_model(data, &constant, rules.blocking)?;
    let mut columns = Columns::of_terms(data, &free)?;
    if rules.blocking == Blocking::Random {
        // the ratio of the variances is that with all candidates
        let blocks = &data.blocks()[0];
        let ratio = variance_ratio(&Columns::of_terms(data, candidates)?, &y, blocks)?;
        y = transformed(&y, blocks, ratio);
        always = decorrelated(&always, blocks, ratio);
        columns = decorrelated(&columns, blocks, ratio);
    }
    let problem = Reduced::new(&always, &columns, &free, &y, rules.hierarchical)?;
    let (found, complete, curve_complete) = match rules.search {
        Search::Ranked => (ranked(&problem), true, true),
        Search::Stepwise => (stepwise(&problem), true, true),
        Search::BestSubset => {
            let subsets = best_subsets(&problem, 2.0 * sigma0_squared);
            (subsets.found, subsets.lowest_is_certain, subsets.all_are_certain)
        }
    };
    let share = Shared { constant: constant.len(), total_sum: full.total_sum, sigma0_squared };
    let curve = found.into_iter().flatten().map(|found| {
        let members = reduced::members(found.set);
        let terms = constant.iter().cloned().chain(members.map(|k| free[k].clone())).collect();
        Step { terms, criteria: share.criteria(&problem, found, &y) }
    });
    let curve: Vec<Step> = curve.collect();
    let lower = |best: usize, next: usize| {
        if curve[next].criteria.pse < curve[best].criteria.pse { next } else { best }
    };
    let chosen = (0..curve.len()).reduce(lower).unwrap_or(0);
    let fitted = Regression::fit(data, response, &curve[chosen].terms, rules.blocking)?;
    Ok(Choice { fitted, curve, chosen, sigma0_squared, complete, curve_complete })
}

fn sigma0_squared(data: &Data, response: &str, full: &Regression, rules: Rules) -> Result<f64, Fault> {
    let positive = |what: &'static str, value: f64| {
        Fault::unless(value > 0.0 && value.is_finite(), what, value, "a number above 0")
    };
    match rules.error {
        ErrorRule::Given(value) => positive("sigma0^2", value).map(|()| value),
        ErrorRule::AboutMean => {
            let y = data.response_values(response)?;
            Ok(total_sum(data, y, &[Term::constant()], rules.blocking)? / y.len() as f64)
        }
        ErrorRule::LeastT(t) => {
            positive("the least |t| of a term", t)?;
            let pure = pure_error(data, response, rules.blocking).map_or(0.0, |pure| pure.variance());
            Ok(0.5 * t * t * pure.max(full.error_variance))
        }
    }
}
