//! Which candidates the data do not tell apart: a bootstrap over segments.

use crate::current_model::CurrentModel;
use crate::rank::Ranked;
use crate::rules::RivalRules;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// What the draws say of a candidate.
#[derive(Debug)]
pub(crate) struct Draws {
    /// Share that it wins.
    pub(crate) own: f64,
    /// Share that it wins or one of the close ones that the library calls its rivals, of the draws that it wins or anything
    /// that has nearly as much evidence.
    pub(crate) with_rivals: f64,
    /// Other effects that the data do not tell from it.
    pub(crate) confused_with: Vec<&'static str>,
}

/// Bootstrap over segments: how often a candidate would have won, and which others would have.
pub(crate) fn distinguish(
    rules: &RivalRules,
    current: &CurrentModel<'_>,
    ranked: &[Ranked],
    best: &Ranked,
    seed: u64,
) -> Draws {
    let problem = &current.problem;
    let rows = problem.len() as f64;
    let phi = (best.refit.chi2 / rows).max(1.0);
    let by_segment = |w: &Ranked| -> Vec<f64> {
        let weighted = current.shared.weighted(&w.refit.residual);
        let of = |segment: &crate::problem::Segment| {
            segment.rows.clone().map(|i| w.refit.residual[i] * weighted[i]).sum::<f64>()
        };
        problem.segments.iter().map(of).collect()
    };
    let shares: Vec<Vec<f64>> = ranked.iter().map(by_segment).collect();
    let fixed: Vec<f64> = ranked.iter().map(|w| w.evidence + 0.5 * w.refit.chi2 / phi).collect();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let count = problem.segments.len();
    let mut wins = vec![0_usize; ranked.len()];
    for _ in 0..rules.draws {
        let mut weights = vec![0.0; count];
        for _ in 0..count {
            weights[random.next_u32() as usize % count] += 1.0;
        }
        let score = |c: usize| {
            let chi2: f64 = shares[c].iter().zip(&weights).map(|(s, w)| s * w).sum();
            fixed[c] - 0.5 * chi2 / phi
        };
        if let Some(winner) = (0..ranked.len()).max_by(|a, b| score(*a).total_cmp(&score(*b))) {
            wins[winner] += 1;
        }
    }
    let share = |name: &str| {
        let of_name = ranked.iter().zip(&wins).filter(|(w, _)| w.name() == name);
        of_name.map(|(_, wins)| *wins).sum::<usize>() as f64 / rules.draws as f64
    };
    let close = rules.close.max(rules.close_share * best.evidence.abs());
    let mut set: Vec<&'static str> = Vec::new();
    for rival in ranked.iter().filter(|w| w.name() != best.name()) {
        let wins = share(rival.name()) >= rules.in_set && rival.evidence > rules.rival_share * best.evidence;
        let close = wins || rival.evidence > best.evidence - close;
        // forms of one effect have one name
        if close && !set.contains(&rival.name()) {
            set.push(rival.name());
        }
    }
    let own = share(best.name());
    let spec = best.refit.active.effect.spec();
    let rival = |name: &&'static str| {
        let of = ranked.iter().find(|w| w.name() == *name);
        of.is_some_and(|w| w.refit.active.effect.spec().is_rival_of(spec))
    };
    let rivals: f64 = set.iter().filter(|name| rival(name)).map(|name| share(name)).sum();
    let plausible = |w: &Ranked| w.name() == best.name() || w.evidence > rules.rival_share * best.evidence;
    let plausible =
        ranked.iter().zip(&wins).filter(|(w, _)| plausible(w)).map(|(_, wins)| *wins).sum::<usize>();
    let plausible = plausible as f64 / rules.draws as f64;
    let with_rivals = if plausible > 0.0 { (own + rivals) / plausible } else { 0.0 };
    Draws { own, with_rivals, confused_with: set }
}

#[cfg(test)]
mod tests;
