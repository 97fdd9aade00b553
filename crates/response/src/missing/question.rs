//! What is asked of a response surface that may lack a term.

use crate::term::Term;

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
