//! Which effects are missing: fitted one by one and beside those found, compared by evidence with days as the unit.

use crate::effect::{Effect, Family};
use crate::fit::{Fitted, Problem};
use crate::points::Point;
use crate::rig::Rig;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rayon::prelude::*;

/// A name needs so much log evidence beyond the model without it, and beyond the next family; about one in 20000.
pub const NEEDED: f64 = 10.0;
/// And it must win in this share of campaigns whose days are drawn again from those measured.
pub const WINS: f64 = 0.95;
/// Campaigns drawn.
const DRAWN: usize = 500;
/// Names at most; more than the shipped campaign supports.
const MOST: usize = 3;
/// Up to this many times the amplitude that turbulence makes, a rig is taken for linear.
const SMALL: f64 = 8.0;

/// An effect beside those found before it.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The effect.
    pub effect: Effect,
    /// With it.
    pub fitted: Fitted,
    /// Log evidence beyond the model without it.
    pub gained: f64,
    /// Share of drawn campaigns in which it gains.
    pub wins: f64,
}

/// A search.
#[derive(Debug, Clone)]
pub struct Found {
    /// The linear rig, calibrated on small oscillations (on all if none are small).
    pub linear: Fitted,
    /// The model with what was found.
    pub fitted: Fitted,
    /// Levels: candidates by what they gain, the best first.
    pub levels: Vec<Vec<Candidate>>,
    /// What was found at each level.
    pub named: Vec<Effect>,
    /// Families that the data do not tell from the first one found.
    pub rivals: Vec<Family>,
    /// Residuals of the fit.
    pub residuals: usize,
}

/// Searches with the scale of the heave sensor that is the more probable one, and its place among the scales: the effects that the
/// first scale leads to are fitted with each other one, and where that is better the search is made with it.
pub fn search_scales(rig: &Rig, points: &[Point]) -> (Found, usize) {
    let scaled = rig.scaled();
    let mut best = (search(&scaled[0], points), 0);
    for (place, rig) in scaled.iter().enumerate().skip(1) {
        let calibrated = calibrated(rig, points);
        let fitted = Problem::new(rig, points).fit(&best.0.named, calibrated.as_ref());
        if fitted.log_evidence > best.0.fitted.log_evidence {
            best = (search(rig, points), place);
        }
    }
    best
}

/// The linear rig fitted to oscillations that are small, for which a rig is taken for linear; none if there are none.
fn calibrated(rig: &Rig, points: &[Point]) -> Option<Fitted> {
    let largest = SMALL * rig.scatter.turbulence_rad;
    let small = points.iter().filter(|point| point.measured.amplitude_rad < largest);
    let small: Vec<Point> = small.cloned().collect();
    (!small.is_empty()).then(|| Problem::new(rig, &small).fit(&[], None))
}

/// Searches.
pub fn search(rig: &Rig, points: &[Point]) -> Found {
    let problem = Problem::new(rig, points);
    let calibrated = calibrated(rig, points);
    let mut fitted = problem.fit(&[], calibrated.as_ref());
    let linear = calibrated.unwrap_or_else(|| fitted.clone());
    let (mut levels, mut named): (Vec<Vec<Candidate>>, Vec<Effect>) = (Vec::new(), Vec::new());
    let mut rivals = Vec::new();
    while named.len() < MOST {
        // beside nothing, fits start at small oscillations: a linear rig that is pressed onto large ones leads astray
        let from = if named.is_empty() { &linear } else { &fitted };
        let mut level = candidates(&problem, from, &fitted, &named);
        if named.is_empty() {
            second_chance(&problem, &fitted, &mut level);
        }
        let Some(best) = level.first().filter(|best| best.gained > NEEDED && best.wins >= WINS) else {
            levels.push(level);
            break;
        };
        let near = rivals_of(best, &level);
        if named.is_empty() {
            rivals = near;
        } else if !near.is_empty() {
            // more is there, and the data do not say what
            levels.push(level);
            break;
        }
        named.push(best.effect);
        fitted = best.fitted.clone();
        levels.push(level);
    }
    Found { linear, fitted, levels, named, rivals, residuals: problem.residuals() }
}

/// All effects of families not yet named, beside those named.
fn candidates(problem: &Problem<'_>, from: &Fitted, against: &Fitted, named: &[Effect]) -> Vec<Candidate> {
    let known = |effect: &&Effect| !named.iter().any(|other| other.family() == effect.family());
    let mut all: Vec<Candidate> = Effect::ALL
        .par_iter()
        .filter(known)
        .map(|effect| {
            let fitted = problem.fit(&[named, &[*effect]].concat(), Some(from));
            let gained = fitted.log_evidence - against.log_evidence;
            let wins = wins(&fitted, against);
            Candidate { effect: *effect, fitted, gained, wins }
        })
        .collect();
    all.sort_by(|a, b| b.gained.total_cmp(&a.gained));
    all
}

/// Fits those of other families than the winner's once more, with the linear rig that the winner came to.
fn second_chance(problem: &Problem<'_>, against: &Fitted, level: &mut [Candidate]) {
    let Some(best) = level.first().cloned() else { return };
    level.par_iter_mut().filter(|other| other.effect.family() != best.effect.family()).for_each(|other| {
        let again = problem.fit(&[other.effect], Some(&best.fitted));
        if again.log_evidence > other.fitted.log_evidence {
            other.gained = again.log_evidence - against.log_evidence;
            other.wins = wins(&again, against);
            other.fitted = again;
        }
    });
    level.sort_by(|a, b| b.gained.total_cmp(&a.gained));
}

/// Families whose best effect comes within what is needed of the winner, or beats it in too many drawn campaigns.
fn rivals_of(best: &Candidate, level: &[Candidate]) -> Vec<Family> {
    let mut rivals = Vec::new();
    for other in level {
        let family = other.effect.family();
        let near = best.gained - other.gained < NEEDED || wins(&best.fitted, &other.fitted) < WINS;
        if near && family != best.effect.family() && !rivals.contains(&family) && other.gained > NEEDED {
            rivals.push(family);
        }
    }
    rivals
}

/// Share of campaigns, days drawn again with replacement, in which the first model is the more probable one.
pub fn wins(first: &Fitted, second: &Fitted) -> f64 {
    let gains: Vec<f64> =
        first.log_likelihood.iter().map(|(day, value)| value - second.log_likelihood[day]).collect();
    // what is not of a day: priors and what the parameters cost
    let shared = first.log_evidence - second.log_evidence - gains.iter().sum::<f64>();
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let won = (0..DRAWN).filter(|_| {
        let drawn = gains.iter().map(|_| gains[random.next_u32() as usize % gains.len()]);
        drawn.sum::<f64>() + shared > 0.0
    });
    won.count() as f64 / DRAWN as f64
}
