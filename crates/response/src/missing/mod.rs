//! Which term a response surface lacks. The model's terms are fitted to the training points; what they leave is located
//! (F tests of families of regressors against pure error), each candidate is weighed against all others, and what is named
//! is added and judged on points that were held out. Nothing is named that pseudo-campaigns drawn from the model itself,
//! with the scatter of its replicates, would let one name as well.

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

pub use answer::{Gap, Missing, Verdict, Visible};
pub use families::Family;
pub use named::{Named, Parameter};
pub use question::Question;
pub use split::Split;

use search::{Level, search};

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
