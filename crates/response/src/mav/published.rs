//! The published equations from their files, and the propeller speed put into those that need it (Eq. 4 of paper 2 into Eqs. 12 to
//! 16). The files are described in data/mav/published/README.md.

use std::path::Path;

use nastran::{InputError, Table};

use super::factor::{Condition, Factor};
use super::model::{Coefficient, Confidence, Model, NoValue, Range, Rules, Status};
use crate::fault::Fault;
use crate::term::Term;

/// Columns of `coefficients.csv`.
const COLUMNS: &str =
    "equation wing response coefficient term value confidence status unit printed_term note";

/// The words of the column `status`.
const STATUSES: [(&str, Status); 6] = [
    ("printed", Status::Printed),
    ("order_resolved", Status::OrderResolved),
    ("term_resolved", Status::TermResolved),
    ("exponent_assumed", Status::ExponentAssumed),
    ("suspected_copy", Status::SuspectedCopy),
    ("missing", Status::Missing),
];

/// All published equations.
#[derive(Debug, Clone, PartialEq)]
pub struct Published {
    models: Vec<Model>,
}

impl Published {
    /// Reads `coefficients.csv` and `ranges.csv` of a folder.
    ///
    /// # Errors
    /// If a file cannot be read, a cell is wrong, or an equation has no range.
    pub fn read(folder: &Path) -> Result<Self, InputError> {
        let coefficients = Table::read(&folder.join("coefficients.csv"))?;
        let ranges = Table::read(&folder.join("ranges.csv"))?;
        Self::from_tables(&coefficients, &ranges)
    }

    /// The same from tables in memory.
    ///
    /// # Errors
    /// As [`Published::read`].
    pub fn from_tables(coefficients: &Table, ranges: &Table) -> Result<Self, InputError> {
        coefficients.require(&COLUMNS.split(' ').collect::<Vec<_>>())?;
        let ranges = read_ranges(ranges)?;
        let mut models: Vec<Model> = Vec::new();
        for row in 0..coefficients.len() {
            let equation = equation_number(coefficients, row)?;
            let text = |column| coefficients.text(row, column).map(str::to_string);
            let (wing, response) = (text("wing")?, text("response")?);
            let coefficient = read_coefficient(coefficients, row)?;
            let known = models.iter_mut().find(|model| model.equation == equation && model.wing == wing);
            if let Some(model) = known {
                if model.response != response {
                    let message =
                        format!("Eq. {equation} is of {} above and of {response} here", model.response);
                    return Err(InputError::at(&coefficients.span(row, "response"), message));
                }
                model.coefficients.push(coefficient);
                continue;
            }
            let of_equation: Vec<Range> =
                ranges.iter().filter(|(number, _)| *number == equation).map(|(_, range)| *range).collect();
            if of_equation.is_empty() {
                let message = format!("ranges.csv has no range of Eq. {equation}");
                return Err(InputError::at(&coefficients.span(row, "equation"), message)
                    .with_help("add a row with equation, factor, low and high"));
            }
            let coefficients = vec![coefficient];
            models.push(Model { equation, wing, response, coefficients, ranges: of_equation });
        }
        Ok(Self { models })
    }

    /// All equations, wing by wing, in the file's order.
    pub fn models(&self) -> &[Model] {
        &self.models
    }

    /// An equation; `wing` is `PR` or `BR` where the paper has both (Eqs. 8 to 10), else anything.
    ///
    /// # Errors
    /// If there is none.
    pub fn equation(&self, equation: u8, wing: &str) -> Result<&Model, InputError> {
        let of_number = || self.models.iter().filter(|model| model.equation == equation);
        if of_number().count() == 1
            && let Some(only) = of_number().next()
        {
            return Ok(only);
        }
        of_number().find(|model| model.wing == wing).ok_or_else(|| {
            let wings: Vec<String> = of_number().map(|model| format!("`{}`", model.wing)).collect();
            let error = InputError::general(format!("there is no Eq. {equation} of the wing `{wing}`"));
            if wings.is_empty() {
                error.with_help("the paper's models are Eqs. 4 to 16")
            } else {
                error.with_help(format!("it is given for {}", wings.join(" and ")))
            }
        })
    }

    /// An equation of which all coefficients are lacking if there is none.
    pub(super) fn given(&self, equation: u8, wing: &str) -> Result<&Model, NoValue> {
        let names = || vec!["all its coefficients".to_string()];
        self.equation(equation, wing).map_err(|_| NoValue::Missing { equation, names: names() })
    }

    /// Propeller speed in krpm by Eq. 4 of paper 2.
    ///
    /// # Errors
    /// As [`Model::value`].
    pub fn propeller_speed_krpm(&self, condition: &Condition, rules: Rules) -> Result<f64, NoValue> {
        self.given(4, "")?.value(condition, rules)
    }

    /// The value of `model`, with the propeller speed of Eq. 4 of paper 2 where it needs one and the state has only a voltage.
    ///
    /// # Errors
    /// As [`Model::value`]; the ranges of both equations count.
    pub fn value(&self, model: &Model, condition: &Condition, rules: Rules) -> Result<f64, NoValue> {
        if !model.needs_propeller_speed() || condition.n_krpm.is_some() || condition.voltage_v.is_none() {
            return model.value(condition, rules);
        }
        let n_krpm = self.propeller_speed_krpm(condition, rules)?;
        model.value(&Condition { n_krpm: Some(n_krpm), ..*condition }, rules)
    }
}

fn equation_number(table: &Table, row: usize) -> Result<u8, InputError> {
    let text = table.text(row, "equation")?;
    text.parse::<u8>().ok().filter(|number| (4..=16).contains(number)).ok_or_else(|| {
        let message = format!("`{text}` is not an equation of the paper; expected 4 to 16");
        InputError::at(&table.span(row, "equation"), message)
    })
}

fn read_ranges(table: &Table) -> Result<Vec<(u8, Range)>, InputError> {
    table.require(&["equation", "factor", "low", "high"])?;
    (0..table.len())
        .map(|row| {
            let factor = one_of(table, row, "factor", &Factor::ALL.map(|factor| (factor.symbol(), factor)))?;
            let (low, high) = (table.number(row, "low")?, table.number(row, "high")?);
            if low >= high {
                let message = format!("the range of {} goes from {low} to {high}", factor.symbol());
                return Err(InputError::at(&table.span(row, "low"), message)
                    .with_help("write the smaller end into `low`"));
            }
            Ok((equation_number(table, row)?, Range { factor, low, high }))
        })
        .collect()
}

fn read_coefficient(table: &Table, row: usize) -> Result<Coefficient, InputError> {
    let complain = |column: &str, message: String| InputError::at(&table.span(row, column), message);
    let term = read_term(table.text(row, "term")?).map_err(|message| complain("term", message))?;
    let confidence = [("high", Confidence::High), ("medium", Confidence::Medium), ("low", Confidence::Low)];
    let confidence = one_of(table, row, "confidence", &confidence)?;
    let status = one_of(table, row, "status", &STATUSES)?;
    let value = match (table.text(row, "value")?.is_empty(), status) {
        (true, Status::Missing) => None,
        (false, Status::Missing) => {
            return Err(complain("value", "the coefficient has a value and the status `missing`".into()));
        }
        _ => Some(table.number(row, "value")?),
    };
    let (name, note) = (table.text(row, "coefficient")?.into(), table.text(row, "note")?.into());
    Ok(Coefficient { name, term, value, confidence, status, note })
}

/// What a word of a column means.
fn one_of<T: Copy>(table: &Table, row: usize, column: &str, known: &[(&str, T)]) -> Result<T, InputError> {
    let text = table.text(row, column)?;
    known.iter().find(|(word, _)| *word == text).map(|(_, meaning)| *meaning).ok_or_else(|| {
        let words: Vec<&str> = known.iter().map(|(word, _)| *word).collect();
        let (last, others) = words.split_last().unwrap_or((&"nothing", &[]));
        let message = format!("`{text}` is no {column}; expected {} or {last}", others.join(", "));
        InputError::at(&table.span(row, column), message)
    })
}

/// A term of which every factor is one of the paper's.
fn read_term(text: &str) -> Result<Term, String> {
    let term: Term = text.parse().map_err(|fault: Fault| fault.to_string())?;
    if let Some((symbol, _)) = term.powers().find(|(symbol, _)| Factor::from_symbol(symbol).is_none()) {
        return Err(format!("`{symbol}` in the term `{text}` is none of q, alpha, delta, E, n"));
    }
    Ok(term)
}
