//! The search: the best candidate is added if it passes the threshold, then earlier picks are weighed again (a first pick can
//! be a compromise of two terms, which a swap repairs; one that later picks make needless is dropped).

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::evidence::{Beyond, Candidate};
use super::families::{Family, families};
use super::named::{Named, Parameter};
use super::noise::{Base, Noise};
use super::{Gap, Question, Split, Visible};
use crate::data::{Blocking, Data};
use crate::fault::Fault;
use crate::qr::dot;
use crate::regression::Regression;
use crate::term::Term;

/// Nats within which candidates are not told apart, and the least evidence for a name.
const NATS: f64 = 5.0;
/// Thresholds are so many standard deviations above the mean of pseudo-campaigns.
const DEVIATIONS: f64 = 4.0;
/// Names of one response.
const MOST_NAMES: usize = 4;
/// Pseudo-campaigns for the floor of the gap.
const FLOOR_DRAWS: u32 = 20;

/// A candidate weighed against the model.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Weighed {
    index: usize,
    pub(super) name: String,
    pub(super) evidence: f64,
    beyond: Beyond,
}

/// A model, and all candidates beside it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Level {
    pub(super) weighed: Vec<Weighed>,
    pub(super) untold: Vec<String>,
    pub(super) threshold: f64,
    pub(super) misfit: f64,
    pub(super) misfit_limit: f64,
    pub(super) noise: f64,
    pub(super) families: Vec<Family>,
    pub(super) visible: Vec<Visible>,
    explained: Vec<f64>,
}

impl Level {
    fn best(&self) -> Option<&Weighed> {
        self.weighed.iter().reduce(|a, b| if b.evidence > a.evidence { b } else { a })
    }
}

/// What the search came to.
pub(super) struct Found {
    /// The model as given, then with what was named.
    pub(super) levels: Vec<Level>,
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
    fn level(&self, picks: &[Candidate]) -> Result<Level, Fault> {
        let base = self.base(picks)?;
        let (rest, variance) = (&base.fitted.residuals, self.noise.variance);
        let (mut weighed, mut untold, mut explained) = (Vec::new(), Vec::new(), Vec::new());
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
            let evidence = beyond.evidence(rest, variance);
            weighed.push(Weighed { index, name: candidate.name(), evidence, beyond });
        }
        let (threshold, misfit_limit) = self.limits(&base, &weighed)?;
        Ok(Level {
            threshold,
            misfit: self.noise.misfit(rest, base.fitted.degrees_of_freedom),
            misfit_limit,
            noise: variance.sqrt(),
            families: families(&base, &self.training, &self.candidates)?,
            visible: self.visible(&weighed, threshold),
            weighed,
            untold,
            explained,
        })
    }

    /// Evidence and misfit above which pseudo-campaigns of this very model do not come.
    fn limits(&self, base: &Base, weighed: &[Weighed]) -> Result<(f64, f64), Fault> {
        let mut random = ChaCha8Rng::seed_from_u64(self.question.seed);
        random.set_stream(1);
        let best = |errors: &[f64]| -> Result<(f64, f64), Fault> {
            let data = self.training.answering(self.response, errors);
            let noise = Noise::of(&data, self.response, self.question.noise)?;
            let rest = base.fitted.remainder(errors);
            let evidence = weighed.iter().map(|one| one.beyond.evidence(&rest, noise.variance));
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
        Ok((above(&alike).max(above(&own)).max(NATS), above(&misfit)))
    }

    fn visible(&self, weighed: &[Weighed], threshold: f64) -> Vec<Visible> {
        let points = self.training.points() as f64;
        let needed = (self.noise.variance * 2.0 * (threshold + 0.5 * points.ln())).sqrt();
        let of = |one: &Weighed| match &self.candidates[one.index] {
            Candidate::Term(term) => {
                Some(Visible { term: term.clone(), coefficient: needed / one.beyond.length })
            }
            Candidate::Blocks(_) => None,
        };
        weighed.iter().filter_map(of).collect()
    }

    /// A pick that another candidate beats, or that is needless, given the other picks.
    fn settle(&self, picks: &mut Vec<Candidate>) -> Result<(), Fault> {
        for _ in 0..MOST_NAMES {
            let before = picks.clone();
            for index in (0..picks.len()).rev() {
                let mut others = picks.clone();
                let own = others.remove(index);
                let level = self.level(&others)?;
                let Some(best) = level.best() else { continue };
                if best.evidence <= level.threshold {
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
        let level = self.level(&others)?;
        let at = level.weighed.iter().position(|one| self.candidates[one.index] == own);
        let at = at.ok_or_else(|| Fault::Design { why: format!("`{}` is not to be told", own.name()) })?;
        let one = &level.weighed[at];
        let mut rivals: Vec<&Weighed> =
            level.weighed.iter().filter(|other| other.index != one.index).collect();
        rivals.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
        let weight: f64 = level.weighed.iter().map(|other| (other.evidence - one.evidence).exp()).sum();
        rivals.retain(|rival| rival.evidence >= one.evidence - NATS);
        Ok(Named {
            name: own.name(),
            is_block: matches!(own, Candidate::Blocks(_)),
            confused_with: rivals.iter().map(|rival| rival.name.clone()).collect(),
            correlation: rivals.iter().map(|rival| one.beyond.correlation(&rival.beyond)).collect(),
            evidence: one.evidence,
            threshold: level.threshold,
            confidence: 1.0 / weight,
            share: (level.explained[at] / misfit_sum).min(1.0),
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
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0);
    mean + DEVIATIONS * square.sqrt()
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
    let mut levels = vec![place.level(&picks)?];
    while picks.len() < MOST_NAMES {
        let level = &levels[levels.len() - 1];
        let Some(best) = level.best().filter(|best| best.evidence > level.threshold) else { break };
        picks.push(place.candidates[best.index].clone());
        if picks.len() > 1 {
            place.settle(&mut picks)?;
        }
        levels.push(place.level(&picks)?);
    }
    let base = place.base(&[])?;
    let beyond =
        (dot(&base.fitted.residuals, &base.fitted.residuals) - place.noise.pure_sum()).max(f64::MIN_POSITIVE);
    let named = (0..picks.len()).map(|index| place.name(&picks, index, beyond));
    let named = named.collect::<Result<_, _>>()?;
    Ok(Found { levels, named, picks })
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
