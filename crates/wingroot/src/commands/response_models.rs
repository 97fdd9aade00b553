//! The models that `response --missing` looks at: terms named on the command line, or the published equations of the runs,
//! and what is hidden from them.

use std::path::Path;

use nastran::{InputError, Table};
use response::mav::{Factor, Published, Series};
use response::missing::Question;
use response::{Blocking, Data, TableStudy, Term, estimable};

use super::response_source::Source;
use crate::args::ResponseArgs;
use crate::failure::Failure;

/// A response with its model.
pub(super) struct Asked {
    /// The CSV file.
    pub(super) file: String,
    /// The points.
    pub(super) data: Data,
    /// The response.
    pub(super) response: String,
    /// Where the model is from.
    pub(super) origin: String,
    /// What was taken out.
    pub(super) hidden: Option<String>,
    /// The published coefficient of it.
    pub(super) published: Option<f64>,
    /// Terms of the model that these points do not tell from the others, left out.
    pub(super) left_out: Vec<String>,
    /// What is asked.
    pub(super) question: Question,
}

/// A model before anything is taken out: terms with their published values, and block columns.
struct Model {
    origin: String,
    terms: Vec<(Term, Option<f64>)>,
    blocks: Vec<String>,
}

/// Every response with its model; with `--hide` those whose model has it.
///
/// # Errors
/// If there is no model, a term cannot be read or has a factor that the table lacks, or nothing has what is to be hidden.
pub(super) fn asked(args: &ResponseArgs, source: &Source, seed: u64) -> Result<Vec<Asked>, Failure> {
    let published = source.published.as_deref().map(Published::read).transpose()?;
    let mut all = Vec::new();
    for (study, table) in &source.tables {
        let data = study.data_of(table)?;
        for response in &study.responses {
            let model = model(args, study, response, published.as_ref())?;
            if let Some(one) = one(args, study, table, &data, response, model, seed)? {
                all.push(one);
            }
        }
    }
    match &args.hide {
        Some(hidden) if all.is_empty() => {
            let message = format!("no model has `{hidden}`, so it cannot be hidden");
            Err(InputError::general(message)
                .with_help("name a term of the model, such as q*delta, or a column of blocks")
                .into())
        }
        _ => Ok(all),
    }
}

fn model(
    args: &ResponseArgs,
    study: &TableStudy,
    response: &str,
    published: Option<&Published>,
) -> Result<Model, Failure> {
    if !args.model.is_empty() {
        let (blocks, terms): (Vec<String>, Vec<String>) = args
            .model
            .iter()
            .map(|text| text.trim().to_string())
            .partition(|name| study.blocks.contains(name));
        let terms = terms.iter().map(|text| Ok((term(text, study)?, None)));
        return Ok(Model { origin: "--model".into(), terms: terms.collect::<Result<_, Failure>>()?, blocks });
    }
    let stem = Path::new(&study.data).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let series = Series::ALL.into_iter().find(|series| Some(series.name()) == stem.as_deref());
    let (Some(published), Some(series)) = (published, series) else {
        let message = format!("which terms the model of {response} has is not said");
        let help =
            "add --model, such as --model alpha,q,alpha*q and the block columns that it has offsets of";
        return Err(InputError::general(message).with_help(help).into());
    };
    let (equations, wing) = series.equations();
    for number in equations {
        let equation = published.equation(*number, wing)?;
        if equation.response == response {
            // terms whose coefficient the paper does not give are not in the runs
            let given = equation.coefficients.iter().filter(|coefficient| coefficient.value.is_some());
            let terms = given.map(|c| Ok((term(&c.term.to_string(), study)?, c.value)));
            return Ok(Model {
                origin: format!("Eq. {number}"),
                terms: terms.collect::<Result<_, Failure>>()?,
                blocks: study.blocks.clone(),
            });
        }
    }
    Err(InputError::general(format!("there is no published equation of {response}")).into())
}

/// A term by the names of the columns, or by the paper's letters where the table has their columns.
fn term(text: &str, study: &TableStudy) -> Result<Term, Failure> {
    let read: Term = text.parse().map_err(InputError::from)?;
    let mut powers = Vec::new();
    for (factor, power) in read.powers() {
        let column = match Factor::from_symbol(factor) {
            Some(known) => known.column(),
            None => factor,
        };
        let known = [factor, column].into_iter().find(|name| study.factors.iter().any(|own| own == name));
        let known = known.ok_or_else(|| {
            let message = format!("the term `{text}` has `{factor}`, which is no factor of {}", study.data);
            InputError::general(message).with_help(format!("the factors are {}", study.factors.join(", ")))
        })?;
        powers.push((known.to_string(), power));
    }
    Ok(Term::new(powers.iter().map(|(name, power)| (name.as_str(), *power))))
}

/// One response; none if its model does not have what is to be hidden.
fn one(
    args: &ResponseArgs,
    study: &TableStudy,
    table: &Table,
    data: &Data,
    response: &str,
    mut model: Model,
    seed: u64,
) -> Result<Option<Asked>, Failure> {
    let here = |fault: response::Fault| Failure::from(fault.in_table(table));
    let names: Vec<Term> = model.terms.iter().map(|(term, _)| term.clone()).collect();
    let blocking = if model.blocks.is_empty() { Blocking::Ignored } else { Blocking::Fixed };
    let told = estimable(data, &names, blocking).map_err(here)?;
    let (mut terms, mut hidden, mut published) = (told.terms, None, None);
    if let Some(text) = &args.hide {
        if model.blocks.contains(text) {
            model.blocks.retain(|name| name != text);
            hidden = Some(text.clone());
        } else {
            // a term of another table's factors is not in this model
            let Ok(wanted) = term(text, study) else { return Ok(None) };
            let Some(at) = terms.iter().position(|term| *term == wanted && !term.is_constant()) else {
                return Ok(None);
            };
            terms.remove(at);
            published = model.terms.iter().find(|(term, _)| *term == wanted).and_then(|(_, value)| *value);
            hidden = Some(wanted.to_string());
        }
    }
    let library = study.library().map_err(here)?;
    let question = Question { noise: args.noise, seed, ..Question::new(terms, model.blocks, library) };
    Ok(Some(Asked {
        file: study.data.clone(),
        data: data.clone(),
        response: response.to_string(),
        origin: model.origin,
        hidden,
        published,
        left_out: told.left_out.into_iter().map(|(term, _)| term.to_string()).collect(),
        question,
    }))
}
