//! The search: the best candidate is added if it passes the threshold, then earlier picks are judged again (a first pick can
//! be a compromise of two terms, which a swap repairs; one that later picks make needless is dropped).

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::evidence::{Beyond, Candidate};
use super::families::{Family, families};
use super::named::{Named, Parameter};
use super::noise::{Base, Noise};
use super::{DetectionLimit, Question, Split};
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::qr::dot;
use crate::regression::Regression;
use crate::term::Term;
use crate::verdict::{Gap, mean_and_deviation};

/// Log Bayes factor within which candidates are not told apart, and the least that a name needs.
const CLOSE: f64 = 5.0;
/// Thresholds are so many standard deviations above the mean of pseudo-campaigns.
const DEVIATIONS: f64 = 4.0;
/// Names of one response.
const MOST_NAMES: usize = 4;
/// Pseudo-campaigns for the floor of the gap.
const FLOOR_DRAWS: u32 = 20;

/// A candidate ranked against the model.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ranked {
    index: usize,
    pub(super) name: String,
    pub(super) log_bayes_factor: f64,
    beyond: Beyond,
}

/// A model, and all candidates beside it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CurrentModel {
    pub(super) ranked: Vec<Ranked>,
    pub(super) untold: Vec<String>,
    pub(super) threshold: f64,
    pub(super) misfit: f64,
    pub(super) misfit_limit: f64,
    pub(super) noise: f64,
    pub(super) families: Vec<Family>,
    pub(super) detection_limits: Vec<DetectionLimit>,
    explained: Vec<f64>,
}

impl CurrentModel {
    fn best(&self) -> Option<&Ranked> {
        self.ranked.iter().reduce(|a, b| if b.log_bayes_factor > a.log_bayes_factor { b } else { a })
    }
}

/// What the search came to.
pub(super) struct Found {
    /// The model as given, then with what was named.
    pub(super) models: Vec<CurrentModel>,
    pub(super) named: Vec<Named>,
    picks: Vec<Candidate>,
}

/// The pieces that every step needs.
struct Place<'a> {
    question: &'a Question,
    training: Data,
    response: &'a str,
    candidates: Vec<Candidate>,
    noise: Noise,
}

/// A model with what was picked: its data (with the blocks that it has) and terms.
fn with(data: &Data, question: &Question, picks: &[Candidate]) -> (Data, Vec<Term>, Blocking) {
    let (mut terms, mut blocks) = (question.model.clone(), question.blocks.clone());
    for pick in picks {
        match pick {
            Candidate::Term(term) => terms.push(term.clone()),
            Candidate::Blocks(name) => blocks.push(name.clone()),
        }
    }
    let blocking = if blocks.is_empty() { Blocking::Ignored } else { Blocking::Fixed };
    (data.with_blocks_only(&blocks), terms, blocking)
}

impl Place<'_> {
    fn base(&self, picks: &[Candidate]) -> Result<Base, Fault> {
        let (data, terms, blocking) = with(&self.training, self.question, picks);
        let fitted = Regression::fit(&data, self.response, &terms, blocking)?;
        Ok(Base { fitted, noise: self.noise.clone() })
    }

    /// All candidates against the model with the picks; their threshold if `full`.
    fn current_model(&self, picks: &[Candidate]) -> Result<CurrentModel, Fault> {
        let base = self.base(picks)?;
        let (rest, variance) = (&base.fitted.residuals, self.noise.variance);
        let (mut ranked, mut untold, mut explained) = (Vec::new(), Vec::new(), Vec::new());
        for (index, candidate) in self.candidates.iter().enumerate() {
            if picks.contains(candidate) {
                continue;
            }
            let beyond = Beyond::of(&base.fitted, &candidate.columns(&self.training)?)?;
            if beyond.basis.is_empty() {
                untold.push(candidate.name());
                continue;
            }
            explained.push(beyond.explained(rest));
            let log_bayes_factor = beyond.log_bayes_factor(rest, variance);
            ranked.push(Ranked { index, name: candidate.name(), log_bayes_factor, beyond });
        }
        let (threshold, misfit_limit) = self.limits(&base, &ranked)?;
        Ok(CurrentModel {
            threshold,
            misfit: self.noise.misfit(rest, base.fitted.degrees_of_freedom),
            misfit_limit,
            noise: variance.sqrt(),
            families: families(&base, &self.training, &self.candidates)?,
            detection_limits: self.detection_limits(&ranked, threshold),
            ranked,
            untold,
            explained,
        })
    }

    /// Evidence and misfit above which pseudo-campaigns of this very model do not come.
    fn limits(&self, base: &Base, ranked: &[Ranked]) -> Result<(f64, f64), Fault> {
        let mut random = ChaCha8Rng::seed_from_u64(self.question.seed);
        random.set_stream(1);
        let best = |errors: &[f64]| -> Result<(f64, f64), Fault> {
            let data = self.training.answering(self.response, errors);
            let noise = Noise::of(&data, self.response, self.question.noise)?;
            let rest = base.fitted.remainder(errors);
            let evidence = ranked.iter().map(|one| one.beyond.log_bayes_factor(&rest, noise.variance));
            let misfit = noise.misfit(&rest, base.fitted.degrees_of_freedom);
            Ok((evidence.fold(0.0, f64::max), misfit))
        };
        let (mut alike, mut own, mut misfit) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..self.question.draws {
            let (evidence, left) = best(&self.noise.draw(&mut random))?;
            alike.push(evidence);
            misfit.push(left);
            own.push(best(&self.noise.draw_own(&mut random))?.0);
        }
        Ok((above(&alike).max(above(&own)).max(CLOSE), above(&misfit)))
    }

    fn detection_limits(&self, ranked: &[Ranked], threshold: f64) -> Vec<DetectionLimit> {
        let points = self.training.points() as f64;
        let needed = (self.noise.variance * 2.0 * (threshold + 0.5 * points.ln())).sqrt();
        let of = |one: &Ranked| match &self.candidates[one.index] {
            Candidate::Term(term) => {
                Some(DetectionLimit { term: term.clone(), coefficient: needed / one.beyond.length })
            }
            Candidate::Blocks(_) => None,
        };
        ranked.iter().filter_map(of).collect()
    }

    /// A pick that another candidate beats, or that is needless, given the other picks.
    fn backward_step(&self, picks: &mut Vec<Candidate>) -> Result<(), Fault> {
        for _ in 0..MOST_NAMES {
            let before = picks.clone();
            for index in (0..picks.len()).rev() {
                let mut others = picks.clone();
                let own = others.remove(index);
                let current = self.current_model(&others)?;
                let Some(best) = current.best() else { continue };
                if best.log_bayes_factor <= current.threshold {
                    *picks = others;
                } else if self.candidates[best.index] != own {
                    picks[index] = self.candidates[best.index].clone();
                }
            }
            if *picks == before {
                break;
            }
        }
        Ok(())
    }

    /// What is to be said of a pick, given the others.
    fn name(&self, picks: &[Candidate], index: usize, misfit_sum: f64) -> Result<Named, Fault> {
        let mut others = picks.to_vec();
        let own = others.remove(index);
        let current = self.current_model(&others)?;
        let at = current.ranked.iter().position(|one| self.candidates[one.index] == own);
        let at = at.ok_or_else(|| Fault::Design { why: format!("`{}` is not to be told", own.name()) })?;
        let one = &current.ranked[at];
        let mut rivals: Vec<&Ranked> =
            current.ranked.iter().filter(|other| other.index != one.index).collect();
        rivals.sort_by(|a, b| b.log_bayes_factor.total_cmp(&a.log_bayes_factor));
        let weight: f64 =
            current.ranked.iter().map(|other| (other.log_bayes_factor - one.log_bayes_factor).exp()).sum();
        rivals.retain(|rival| rival.log_bayes_factor >= one.log_bayes_factor - CLOSE);
        Ok(Named {
            name: own.name(),
            is_block: matches!(own, Candidate::Blocks(_)),
            confused_with: rivals.iter().map(|rival| rival.name.clone()).collect(),
            correlation: rivals.iter().map(|rival| one.beyond.correlation(&rival.beyond)).collect(),
            log_bayes_factor: one.log_bayes_factor,
            threshold: current.threshold,
            confidence: 1.0 / weight,
            share: (current.explained[at] / misfit_sum).min(1.0),
            parameters: parameters(&self.base(picks)?.fitted, &own),
        })
    }
}

/// Coefficients of a pick.
fn parameters(fitted: &Regression, own: &Candidate) -> Vec<Parameter> {
    match own {
        Candidate::Term(term) => fitted.coefficient(term).map_or_else(Vec::new, |c| {
            vec![Parameter { name: term.to_string(), value: c.value, sigma: Some(c.standard_error) }]
        }),
        Candidate::Blocks(name) => fitted
            .offsets
            .iter()
            .filter(|offset| offset.blocks == *name)
            .map(|o| Parameter { name: o.label.clone(), value: o.value, sigma: None })
            .collect(),
    }
}

/// Mean and so many standard deviations of draws.
fn above(values: &[f64]) -> f64 {
    let (mean, deviation) = mean_and_deviation(values);
    mean + DEVIATIONS * deviation
}

/// Adds what passes, best first.
pub(super) fn search(
    data: &Data,
    response: &str,
    question: &Question,
    split: &Split,
) -> Result<Found, Fault> {
    let training = data.rows(&split.training);
    let open = data.blocks().iter().filter(|blocks| !question.blocks.contains(&blocks.name));
    let mut candidates: Vec<Candidate> = open.map(|blocks| Candidate::Blocks(blocks.name.clone())).collect();
    for term in question.candidates.iter().filter(|term| !question.model.contains(term)) {
        let candidate = Candidate::Term(term.clone());
        if !candidates.contains(&candidate) {
            candidates.push(candidate);
        }
    }
    if let Some(name) = question.blocks.iter().find(|name| data.blocks().iter().all(|b| b.name != **name)) {
        let known = crate::fault::list(data.blocks().iter().map(|b| b.name.as_str()));
        return Err(Fault::Unknown { what: "block", name: name.clone(), known });
    }
    let noise = Noise::of(&training, response, question.noise)?;
    let place = Place { question, training, response, candidates, noise };
    let mut picks: Vec<Candidate> = Vec::new();
    let mut models = vec![place.current_model(&picks)?];
    while picks.len() < MOST_NAMES {
        let current = &models[models.len() - 1];
        let Some(best) = current.best().filter(|best| best.log_bayes_factor > current.threshold) else {
            break;
        };
        picks.push(place.candidates[best.index].clone());
        if picks.len() > 1 {
            place.backward_step(&mut picks)?;
        }
        models.push(place.current_model(&picks)?);
    }
    let base = place.base(&[])?;
    let beyond =
        (dot(&base.fitted.residuals, &base.fitted.residuals) - place.noise.pure_sum()).max(f64::MIN_POSITIVE);
    let named = (0..picks.len()).map(|index| place.name(&picks, index, beyond));
    let named = named.collect::<Result<_, _>>()?;
    Ok(Found { models, named, picks })
}

impl Found {
    /// Training and held-out gap, without and with what was named, and of pseudo-campaigns.
    pub(super) fn gaps(
        &self,
        data: &Data,
        response: &str,
        question: &Question,
        split: &Split,
    ) -> Result<[Gap; 2], Fault> {
        let noise = Noise::of(data, response, question.noise)?;
        let before = gap(data, response, question, &[], split, noise.variance)?;
        let after = gap(data, response, question, &self.picks, split, noise.variance)?;
        let mut random = ChaCha8Rng::seed_from_u64(question.seed);
        random.set_stream(2);
        let mut floor = [0.0; 2];
        for _ in 0..FLOOR_DRAWS {
            let drawn = data.answering(response, &noise.draw(&mut random));
            let own = Noise::of(&drawn, response, question.noise)?;
            let gaps = gap(&drawn, response, question, &self.picks, split, own.variance)?;
            floor.iter_mut().zip(gaps).for_each(|(sum, gap)| *sum += gap / f64::from(FLOOR_DRAWS));
        }
        let of = |k: usize| Gap { before: before[k], after: after[k], floor: floor[k] };
        Ok([of(0), of(1)])
    }
}

/// Root mean square of what a model fitted to the training points leaves there and at those held out.
fn gap(
    data: &Data,
    response: &str,
    question: &Question,
    picks: &[Candidate],
    split: &Split,
    variance: f64,
) -> Result<[f64; 2], Fault> {
    let (data, terms, blocking) = with(data, question, picks);
    let fitted = Regression::fit(&data.rows(&split.training), response, &terms, blocking)?;
    let y = data.response_values(response)?;
    let mut left = Vec::with_capacity(split.held_out.len());
    for &row in &split.held_out {
        let offset = data.blocks().iter().map(|blocks| {
            let label = &blocks.labels[blocks.of_point[row]];
            let own = fitted.offsets.iter().find(|o| o.blocks == blocks.name && o.label == *label);
            own.map_or(0.0, |offset| offset.value)
        });
        left.push(y[row] - fitted.value(&data.point(row))? - offset.sum::<f64>());
    }
    let rms = |rest: &[f64]| (dot(rest, rest) / rest.len() as f64 / variance).sqrt();
    Ok([rms(&fitted.residuals), rms(&left)])
}
