//! What is said of a response surface that may lack a term.

use super::families::Family;
use super::named::Named;
use super::split::Split;
use crate::term::Term;
use crate::verdict::{Gap, VerdictKind};

/// The smallest coefficient of a term that would have been named.
#[derive(Debug, Clone, PartialEq)]
pub struct DetectionLimit {
    /// The candidate.
    pub term: Term,
    /// Its coefficient, unit of the response over that of the term.
    pub coefficient: f64,
}

/// The answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Missing {
    /// Name of the response.
    pub response: String,
    /// In one word.
    pub verdict: VerdictKind,
    /// Families of regressors, the one with most of the residual first.
    pub families: Vec<Family>,
    /// What is missing; of an unknown, what comes closest.
    pub named: Vec<Named>,
    /// Candidates with their log Bayes factors before anything was added, best first.
    pub candidates: Vec<(String, f64)>,
    /// Log Bayes factor that a candidate needed at first.
    pub threshold: f64,
    /// Lack of fit over pure error, before and after.
    pub misfit: [f64; 2],
    /// The misfit above which something is missing, with what was named in the model.
    pub misfit_limit: f64,
    /// On the training points.
    pub training: Gap,
    /// On the points held out.
    pub held_out: Gap,
    /// Which points are which.
    pub split: Split,
    /// Standard deviation of pure error, unit of the response, offsets of all blocks taken out.
    pub noise: f64,
    /// The smallest coefficients that would have been named, if nothing was.
    pub detection_limits: Vec<DetectionLimit>,
    /// Candidates that these points do not tell from the model's own terms: nothing can be said of them.
    pub untold: Vec<String>,
}

/// So many times its floor a gap may be at most to count as closed.
const CLOSED: f64 = 2.0;
/// A family is located if its p value is below this over the number of families.
const LOCATED: f64 = 0.001;

impl Missing {
    /// Whether a family is beyond chance in what the model leaves.
    pub fn is_located(&self, family: &Family) -> bool {
        family.alone.p_value < LOCATED / self.families.len() as f64
    }

    /// The held-out gap shrank, and to at most twice what is left where nothing is missing.
    pub fn closed(&self) -> bool {
        matches!(self.verdict, VerdictKind::Effects | VerdictKind::Ambiguous)
            && self.held_out.is_closed(CLOSED)
    }
}
