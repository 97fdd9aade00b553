//! What is said of a response surface that may lack a term.

use super::families::Family;
use super::named::Named;
use super::split::Split;
use crate::term::Term;

/// The answer in one word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Something is missing and has a name.
    Effects,
    /// Something is missing, and these points do not tell two or more candidates apart.
    Ambiguous,
    /// The model explains the data to the pure error.
    None,
    /// Something is missing that no candidate explains.
    Unknown,
}

impl Verdict {
    /// As in result.json: `effects`, `ambiguous`, `none`, `unknown`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Effects => "effects",
            Self::Ambiguous => "ambiguous",
            Self::None => "none",
            Self::Unknown => "unknown",
        }
    }
}

/// Root mean square of what the surface leaves, over the standard deviation of pure error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// With the model as given.
    pub before: f64,
    /// With what was named.
    pub after: f64,
    /// Where nothing is missing: the mean of pseudo-campaigns.
    pub floor: f64,
}

/// What the smallest missing term is that would have been named.
#[derive(Debug, Clone, PartialEq)]
pub struct Visible {
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
    pub verdict: Verdict,
    /// Families of regressors, the one with most of the residual first.
    pub families: Vec<Family>,
    /// What is missing; of an unknown, what comes closest.
    pub named: Vec<Named>,
    /// Candidates with their evidence in nats before anything was added, best first.
    pub candidates: Vec<(String, f64)>,
    /// Evidence that a candidate needed at first, nats.
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
    pub visible: Vec<Visible>,
    /// Candidates that these points do not tell from the model's own terms: nothing can be said of them.
    pub untold: Vec<String>,
}

/// A family is located if its p value is below this over the number of families.
const LOCATED: f64 = 0.001;

impl Missing {
    /// Whether a family is beyond chance in what the model leaves.
    pub fn is_located(&self, family: &Family) -> bool {
        family.alone.p_value < LOCATED / self.families.len() as f64
    }

    /// The held-out gap shrank, and to at most twice what is left where nothing is missing.
    pub fn closed(&self) -> bool {
        matches!(self.verdict, Verdict::Effects | Verdict::Ambiguous)
            && self.held_out.after < self.held_out.before
            && self.held_out.after <= 2.0 * self.held_out.floor
    }
}
