//! Which term a response surface lacks. The model's terms are fitted to the training points; what they leave is located
//! (F tests of families of regressors against pure error), each candidate is weighed against all others, and what is named
//! is added and judged on points that were held out. Nothing is named that pseudo-campaigns drawn from the model itself,
//! with the scatter of its replicates, would let one name as well.

mod evidence;
mod families;
mod named;
mod noise;
mod search;
mod split;

use crate::data::Data;
use crate::fault::Fault;
use crate::term::Term;

pub use families::Family;
pub use named::{Named, Parameter};
pub use split::Split;

use search::{Level, search};

/// What is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// The model's terms, the constant too if it has one.
    pub model: Vec<Term>,
    /// Block columns of the data whose offsets are in the model; offsets of the others are candidates.
    pub blocks: Vec<String>,
    /// Terms that may be missing; those of the model are passed over.
    pub candidates: Vec<Term>,
    /// Standard deviation of one reading, unit of the response; from replicates if not given.
    pub noise: Option<f64>,
    /// Share of the distinct points that are held out, with all their replicates.
    pub held_out: f64,
    /// Pseudo-campaigns without a missing term that the threshold comes from.
    pub draws: u32,
    /// Of the split and the draws.
    pub seed: u64,
}

impl Question {
    /// With a quarter of the points held out, 200 pseudo-campaigns and pure error from replicates.
    pub fn new(model: Vec<Term>, blocks: Vec<String>, candidates: Vec<Term>) -> Self {
        Self { model, blocks, candidates, noise: None, held_out: 0.25, draws: 200, seed: 1 }
    }
}

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

impl Missing {
    /// The held-out gap shrank, and to at most twice what is left where nothing is missing.
    pub fn closed(&self) -> bool {
        matches!(self.verdict, Verdict::Effects | Verdict::Ambiguous)
            && self.held_out.after < self.held_out.before
            && self.held_out.after <= 2.0 * self.held_out.floor
    }
}

/// Looks for what the model of a response lacks.
///
/// # Errors
/// If a name is not in the data, the model's terms are aliased, there are neither replicates nor a stated noise, or the
/// points are too few to hold some out.
pub fn find_missing(data: &Data, response: &str, question: &Question) -> Result<Missing, Fault> {
    if let Some(value) = question.noise.filter(|noise| !(*noise > 0.0 && noise.is_finite())) {
        return Err(Fault::Number { what: "the noise", value, expected: "a number above 0" });
    }
    if question.draws < 20 {
        let value = f64::from(question.draws);
        return Err(Fault::Number { what: "the number of pseudo-campaigns", value, expected: "at least 20" });
    }
    let split = Split::draw(data, question.held_out, question.seed)?;
    let found = search(data, response, question, &split)?;
    let first = &found.levels[0];
    let last: &Level = found.levels.last().unwrap_or(first);
    let gaps = found.gaps(data, response, question, &split)?;
    let verdict = verdict(&found.named, last, gaps[1]);
    let mut ranked: Vec<(String, f64)> =
        first.weighed.iter().map(|one| (one.name.clone(), one.evidence)).collect();
    ranked.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(Missing {
        response: response.to_string(),
        verdict,
        families: first.families.clone(),
        candidates: ranked,
        threshold: first.threshold,
        misfit: [first.misfit, last.misfit],
        misfit_limit: last.misfit_limit,
        training: gaps[0],
        held_out: gaps[1],
        noise: first.noise,
        visible: if found.named.is_empty() { first.visible.clone() } else { Vec::new() },
        untold: first.untold.clone(),
        named: found.named,
        split,
    })
}

fn verdict(named: &[Named], last: &Level, held_out: Gap) -> Verdict {
    let unexplained = last.misfit > last.misfit_limit;
    if unexplained || !named.is_empty() && held_out.after >= held_out.before {
        Verdict::Unknown
    } else if named.is_empty() {
        Verdict::None
    } else if named.iter().any(|one| !one.confused_with.is_empty()) {
        Verdict::Ambiguous
    } else {
        Verdict::Effects
    }
}
