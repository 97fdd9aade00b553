//! Effects that a search named, and what it ends with.

use crate::candidate::Refit;
use crate::consistency::Share;
use crate::rank::Ranked;
use crate::rules::NamingRules;
use maneuver::effects::Active;

/// An effect that was found.
#[derive(Debug, Clone)]
pub struct Found {
    /// The effect with its values.
    pub active: Active,
    /// Standard deviations.
    pub sigma: Vec<f64>,
    /// Logarithm of the Bayes factor.
    pub evidence: f64,
    /// The same when it was named first, beside fewer others.
    pub named_at: f64,
    /// How often effects with its share of bootstrap draws were the right ones.
    pub confidence: f64,
    /// Other effects that the data do not tell from it.
    pub confused_with: Vec<&'static str>,
    /// These as fitted in its place.
    pub rivals: Vec<Refit>,
    /// What was ranked and had some of its evidence when it was named: what may take its place.
    pub considered: Vec<&'static str>,
    /// The size that each airspeed and kind of maneuver alone would give it, over the one that the search found.
    pub shares: Vec<Share>,
}

impl Found {
    /// Name of the effect.
    pub fn name(&self) -> &'static str {
        self.active.effect.spec().name
    }

    /// Takes effect, values and evidence of another fit.
    pub(crate) fn take(&mut self, fit: &Ranked, naming: &NamingRules) {
        self.active = fit.refit.active.clone();
        self.sigma = fit.refit.sigma_with_form(naming);
        self.evidence = fit.evidence;
    }
}

/// What a search ends with.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// Effects, the first found first.
    pub found: Vec<Found>,
    /// Chi square a row before any effect, and with all found.
    pub misfit: [f64; 2],
    /// The best candidate that was not named.
    pub next_best: Option<Ranked>,
    /// Whether more is missing than the library explains, or something that it does not tell apart.
    pub unexplained: bool,
    /// Candidates beside the bare model by falling evidence.
    pub first_ranking: Vec<Ranked>,
    /// What the search did, step by step.
    pub trace: Vec<String>,
}

impl Outcome {
    /// Names of the effects, the first found first.
    pub fn names(&self) -> Vec<&'static str> {
        self.found.iter().map(Found::name).collect()
    }
}

/// The effects found but for some.
pub(crate) fn others(found: &[Found], without: &[usize]) -> Vec<Active> {
    found.iter().enumerate().filter(|(i, _)| !without.contains(i)).map(|(_, f)| f.active.clone()).collect()
}
