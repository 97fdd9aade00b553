//! Effects one after the other, each ranked against all others, until none is left that the data ask for.

use crate::backward_step::backward_step;
use crate::candidate::Refit;
use crate::consistency::{Share, scatter, shares};
use crate::current_model::{CurrentModel, Setting};
use crate::distinguish::{CLOSE, CLOSE_SHARE, Draws, distinguish};
use crate::null_distribution::NullDistribution;
use crate::problem::Problem;
use crate::rank::{Ranked, rank};
use maneuver::effects::Active;

/// Most effects that one campaign may lack.
const MOST: usize = 4;
/// An effect that adds less than this of the first one's evidence only repairs the first one's form.
const REPAIR_SHARE: f64 = 0.008;
/// A larger log Bayes factor than this repairs no form...
const NO_REPAIR: f64 = 100.0;
/// ... but that of a rival, which needs this share of the evidence of the one that it is a rival of.
const REPAIR_SHARE_OF_RIVAL: f64 = 0.2;
/// Log Bayes factor that the form of another program's model may add to an effect or take from it (see `null_distribution`).
const NUMERICS: f64 = 45.0;
/// Confidence in what goes first by its odds, not by the data: of two lags that are late, one of a kind that is early as often.
const ODDS: f64 = 2.0 / 3.0;
/// What had less than this of its evidence is not ranked in its place again when more was found.
const CONSIDERED: f64 = 0.2;
/// Where no candidate wins this share of draws together with what the library calls its rivals, the data do not say which
/// it is, and none is named.
const WINS: f64 = 0.35;
/// Share of draws that an effect wins, and how often it was the hidden one then, on development cases of the blind
/// benchmark: straight between. First where nothing is close to it, then where rivals are.
const RIGHT: [[(f64, f64); 5]; 2] = [
    [(0.0, 0.4), (0.45, 0.85), (0.7, 0.95), (0.9, 0.97), (1.0, 0.985)],
    [(0.0, 0.3), (0.5, 0.58), (0.7, 0.6), (0.85, 0.85), (1.0, 0.97)],
];
/// Below this share of the misfit explained, the best effect of the library is not the one that is missing.
const EXPLAINED: f64 = 0.1;
/// Below this share of it explained by all that was found, what was found is not what is missing.
const EXPLAINED_BY_ALL: f64 = 0.5;
/// Above this scatter of its size from one part of the data to the other an effect is not what it is called.
const SCATTER: f64 = 3.0;
/// The same where something is left that nothing explains.
const SCATTER_UNEXPLAINED: f64 = 1.4;
/// How far values are off because no form is exact, as shares of them, on development cases of the blind benchmark.
const FORM: f64 = 0.1;

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
    /// The size that each airspeed and kind of maneuver alone would give it, over the one found.
    pub shares: Vec<Share>,
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
    pub first_ranking: Vec<(String, f64, f64)>,
    /// What the search did, step by step.
    pub trace: Vec<String>,
}

/// Searches a training problem.
pub fn search(
    setting: &Setting<'_>,
    problem: &mut Problem<'_>,
    limits: &NullDistribution,
    seed: u64,
) -> (Outcome, CurrentModel) {
    let rows = problem.len() as f64;
    let current = CurrentModel::new(setting, problem, &[], None);
    let start = current.chi2;
    let bare = (problem.clone(), current.clone());
    let mut so_far = SoFar { current, outcome: Outcome::default(), first_evidence: None, undecided: false };
    // what a step takes back a later one may find again: steps end, whatever they do
    for _ in 0..2 * MOST {
        if so_far.outcome.found.len() == MOST || !so_far.step(setting, (&mut *problem, &bare), limits, seed) {
            break;
        }
    }
    let SoFar { mut current, mut outcome, undecided, .. } = so_far;
    // what was found beside an effect is no rival of it
    let names: Vec<&str> = outcome.found.iter().map(name).collect();
    for effect in &mut outcome.found {
        effect.confused_with.retain(|rival| !names.contains(rival));
        effect.rivals.retain(|rival| !names.contains(&rival.active.effect.spec().name));
    }
    let explained = (start - current.chi2) / (start - rows * limits.misfit).max(f64::MIN_POSITIVE);
    if current.chi2 > rows * limits.misfit_limit && explained < EXPLAINED_BY_ALL && !outcome.found.is_empty()
    {
        outcome.trace.push(format!("all of it explains {explained:.2} of the misfit: none is named"));
        outcome.found.clear();
        current = CurrentModel::new(setting, problem, &[], Some(&current.models));
    }
    let limit = if current.chi2 > rows * limits.misfit_limit { SCATTER_UNEXPLAINED } else { SCATTER };
    let undecided = judge_parts(setting, (problem, &current), limit, &mut outcome) || undecided;
    if outcome.found.len() != current.effects.len() {
        current = CurrentModel::new(setting, problem, &others(&outcome.found, &[]), Some(&current.models));
    }
    outcome.misfit = [start / rows, current.chi2 / rows];
    outcome.unexplained = outcome.misfit[1] > limits.misfit_limit || undecided && outcome.found.is_empty();
    (outcome, current)
}

/// Judges every effect from parts of the data, and drops those whose parts disagree (all, if the first is one: what was
/// found beside a wrong effect is not to be believed). Whether any was dropped.
fn judge_parts(
    setting: &Setting<'_>,
    (problem, current): (&Problem<'_>, &CurrentModel),
    limit: f64,
    outcome: &mut Outcome,
) -> bool {
    for (which, found) in outcome.found.iter_mut().enumerate() {
        let mut strict = problem.clone();
        let around = current.strict(&mut strict, which);
        found.shares = shares(setting, (&strict, &around), which);
    }
    let disagree =
        |found: &Found| scatter(&found.active, &found.shares).is_some_and(|scatter| scatter > limit);
    for found in outcome.found.iter().filter(|found| disagree(found)) {
        let each: Vec<String> = found.shares.iter().map(ToString::to_string).collect();
        let name = name(found);
        outcome.trace.push(format!("{name} has no size of its own ({}): it only resembles", each.join(", ")));
    }
    let before = outcome.found.len();
    if outcome.found.first().is_some_and(disagree) {
        outcome.found.clear();
    }
    outcome.found.retain(|found| !disagree(found));
    outcome.found.len() < before
}

/// A search on its way.
struct SoFar {
    current: CurrentModel,
    outcome: Outcome,
    first_evidence: Option<f64>,
    undecided: bool,
}

impl SoFar {
    /// Names one more effect, if there is one to name; whether there may be more.
    fn step(
        &mut self,
        setting: &Setting<'_>,
        (problem, bare): (&mut Problem<'_>, &(Problem<'_>, CurrentModel)),
        limits: &NullDistribution,
        seed: u64,
    ) -> bool {
        let ranked = rank(setting, problem, &self.current, limits);
        if self.first_evidence.is_none() {
            self.outcome.first_ranking = ranked
                .iter()
                .map(|w| (format!("{} {}", w.name(), w.refit.active.effect.form()), w.evidence, w.threshold))
                .collect();
        }
        let Some(Best { candidate: best, instead, needed }) = self.best(&ranked) else {
            self.outcome.next_best = ranked.into_iter().next();
            return false;
        };
        let (rows, chi2) = (problem.len() as f64, self.current.chi2);
        let explained = (chi2 - best.refit.chi2) / (chi2 - rows * limits.misfit).max(f64::MIN_POSITIVE);
        let Draws { own: share, with_rivals, confused_with } =
            distinguish(problem, &self.current, &ranked, (best, instead), seed);
        let explains = chi2 <= rows * limits.misfit_limit || explained >= EXPLAINED;
        if with_rivals < WINS || !explains {
            self.undecided = with_rivals < WINS;
            self.outcome.trace.push(format!(
                "{} at a log Bayes factor of {:.0} wins {with_rivals:.2} of the draws and explains {explained:.2} of the misfit: not named",
                best.name(),
                best.evidence
            ));
            self.outcome.next_best = Some(best.clone());
            return false;
        }
        self.first_evidence.get_or_insert(best.evidence);
        self.outcome.trace.push(format!(
            "{} named at a log Bayes factor of {:.0}, {needed:.0} needed",
            best.name(),
            best.evidence
        ));
        self.outcome.found.push(Found {
            active: best.refit.active.clone(),
            sigma: with_form(&best.refit),
            evidence: best.evidence,
            named_at: best.evidence,
            confidence: if instead.is_some() { ODDS } else { right(share, !confused_with.is_empty()) },
            rivals: confused_with.iter().filter_map(|name| fitted(&ranked, name)).collect(),
            confused_with,
            considered: ranked
                .iter()
                .filter(|w| w.evidence > CONSIDERED * best.evidence)
                .map(Ranked::name)
                .collect(),
            shares: Vec::new(),
        });
        let effects = others(&self.outcome.found, &[]);
        if effects.len() == 1 {
            self.current = CurrentModel::new(setting, problem, &effects, Some(&self.current.models));
            return true;
        }
        self.current = self.current.beside(setting, problem, &effects);
        let more =
            backward_step(setting, (problem, bare), limits, &mut self.outcome.found, &mut self.current);
        let names: Vec<&str> = self.outcome.found.iter().map(name).collect();
        self.outcome.trace.push(format!("all fitted again: {}", names.join(", ")));
        more
    }

    /// The best candidate that has the evidence it needs, and how much that is; and the one with more evidence that it goes
    /// before by its odds.
    fn best<'a>(&self, ranked: &'a [Ranked]) -> Option<Best<'a>> {
        let least = no_repair(self.first_evidence.unwrap_or(0.0));
        let rivals = |w: &Ranked| {
            let found = self.outcome.found.iter();
            let rivals = found.filter(|f| f.active.effect.spec().is_rival_of(w.refit.active.effect.spec()));
            rivals.map(|rival| REPAIR_SHARE_OF_RIVAL * rival.named_at).fold(0.0, f64::max)
        };
        let needed = |w: &Ranked| w.threshold.max(least).max(rivals(w));
        let counts =
            |w: &&Ranked| w.evidence > needed(w) && w.refit.is_itself() && !w.refit.is_within_prior();
        let first = ranked.iter().find(counts)?;
        let close = NUMERICS.min(CLOSE_SHARE * first.evidence);
        let odd = |w: &&Ranked| counts(w) && w.has_one_side() && first.evidence - w.evidence < close;
        let simpler = |w: &&Ranked| {
            counts(w) && w.parameters() < first.parameters() && first.evidence - w.evidence < CLOSE
        };
        let preferred = ranked.iter().find(odd).filter(|_| first.has_two_sides());
        let preferred = preferred.or_else(|| ranked.iter().find(simpler));
        let best = preferred.unwrap_or(first);
        Some(Best { candidate: best, instead: preferred.map(|_| first), needed: needed(best) })
    }
}

/// A candidate that is to be named.
struct Best<'a> {
    candidate: &'a Ranked,
    /// What has more evidence, though less than the model's form may make of it, and lesser odds.
    instead: Option<&'a Ranked>,
    /// Nats that it needed.
    needed: f64,
}

/// Evidence from which on a further effect is no repair of the first one's form.
pub(crate) fn no_repair(first: f64) -> f64 {
    (REPAIR_SHARE * first).min(NO_REPAIR)
}

/// Standard deviations that the data leave, and the form.
pub(crate) fn with_form(refit: &Refit) -> Vec<f64> {
    refit.sigma.iter().zip(&refit.active.values).map(|(sigma, value)| sigma.hypot(FORM * value)).collect()
}

/// The best fit of a name.
fn fitted(ranked: &[Ranked], name: &str) -> Option<Refit> {
    ranked.iter().find(|w| w.name() == name).map(|w| w.refit.clone())
}

/// How often a name with this share of draws was right.
fn right(share: f64, has_rivals: bool) -> f64 {
    let table = &RIGHT[usize::from(has_rivals)];
    let above = table.partition_point(|(x, _)| *x < share).clamp(1, table.len() - 1);
    let ((x0, y0), (x1, y1)) = (table[above - 1], table[above]);
    y0 + (y1 - y0) * (share - x0) / (x1 - x0)
}

/// The effects found but for some.
pub(crate) fn others(found: &[Found], without: &[usize]) -> Vec<Active> {
    found.iter().enumerate().filter(|(i, _)| !without.contains(i)).map(|(_, f)| f.active.clone()).collect()
}

/// Name of what was found.
pub(crate) fn name(found: &Found) -> &'static str {
    found.active.effect.spec().name
}
