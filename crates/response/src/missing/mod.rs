//! Which term a response surface lacks. The model's terms are fitted to the training points; what they leave is located
//! (F tests of families of regressors against pure error), candidates are ranked by their log Bayes factors, and what is named
//! is added and judged on points that were held out. Nothing is named that pseudo-campaigns drawn from the model itself,
//! with the scatter of its replicates, would let one name as well.
//!
//! `discover` asks the same of a wing in time and answers in the same words ([`crate::verdict`]). The rest differs because the
//! model here is linear in its terms and readings err independently: a log Bayes factor is exact (Schwarz's form, with a known
//! error), rivals are told apart by their correlation, points are held out at random, and campaigns with nothing missing cost
//! a matrix product each. There, effects are nonlinear and fitted step by step, residuals are correlated in time and
//! marginalised over what calibration absorbed, runs are held out whole, rivals are told apart by a bootstrap over segments, and a
//! null campaign costs simulations.

mod answer;
mod evidence;
mod families;
mod named;
mod noise;
mod question;
mod search;
mod split;

use crate::data::Data;
use crate::fault::Fault;
use crate::verdict::{Gap, VerdictKind};

pub use answer::{DetectionLimit, Missing};
pub use families::Family;
pub use named::{Named, Parameter};
pub use question::Question;
pub use split::Split;

use search::{CurrentModel, search};

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
    let first = &found.models[0];
    let last: &CurrentModel = found.models.last().unwrap_or(first);
    let gaps = found.gaps(data, response, question, &split)?;
    let verdict = verdict(&found.named, last, gaps[1]);
    let mut ranked: Vec<(String, f64)> =
        first.ranked.iter().map(|one| (one.name.clone(), one.log_bayes_factor)).collect();
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
        detection_limits: if found.named.is_empty() { first.detection_limits.clone() } else { Vec::new() },
        untold: first.untold.clone(),
        named: found.named,
        split,
    })
}

fn verdict(named: &[Named], last: &CurrentModel, held_out: Gap) -> VerdictKind {
    let unexplained = last.misfit > last.misfit_limit;
    if unexplained || !named.is_empty() && held_out.after >= held_out.before {
        VerdictKind::Unknown
    } else if named.is_empty() {
        VerdictKind::None
    } else if named.iter().any(|one| !one.confused_with.is_empty()) {
        VerdictKind::Ambiguous
    } else {
        VerdictKind::Effects
    }
}
