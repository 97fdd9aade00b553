//! What to analyse, as a RON file or a command line says it: tables with their factors, responses and blocks, candidate
//! terms and the rules of the choice.

use std::path::Path;

use nastran::{InputError, Table, place_of, read_text, ron_file};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::analysis::{Analysis, analyse};
use crate::candidates::{Candidates, candidates};
use crate::choice::{ErrorRule, Rules, Search};
use crate::data::{Blocking, Data};
use crate::effects::{Effects, effects};
use crate::fault::Fault;
use crate::term::Term;

/// Order of the candidate terms if nothing is said.
const ORDER: u32 = 2;

/// Tables to analyse.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Response")]
pub struct Study {
    /// For headings.
    #[serde(default)]
    pub name: String,
    /// The tables.
    pub tables: Vec<TableStudy>,
    /// Folder with published models (`coefficients.csv`, `ranges.csv`) whose curves are drawn too.
    pub published: Option<String>,
}

/// One table and what to make of it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableStudy {
    /// The CSV file, beside the file that names it.
    pub data: String,
    /// Columns of factors.
    pub factors: Vec<String>,
    /// Columns of responses.
    pub responses: Vec<String>,
    /// Columns of blocks.
    #[serde(default)]
    pub blocks: Vec<String>,
    /// All products of powers of the factors up to this order are candidates; 2 if neither this nor terms are given.
    pub order: Option<u32>,
    /// Candidates by name, such as `n^2/q`, besides those of the order if one is given.
    #[serde(default)]
    pub terms: Vec<String>,
    /// What is done with blocks.
    #[serde(default)]
    pub blocking: Blocking,
    /// How sets of terms are looked for.
    #[serde(default)]
    pub search: Search,
    /// The rule for sigma0^2.
    #[serde(default)]
    pub sigma0_squared: ErrorRule,
    /// A term brings with it those that a shift of origins makes out of it.
    #[serde(default = "yes")]
    pub hierarchical: bool,
    /// Level of tests and intervals.
    #[serde(default = "level")]
    pub level: f64,
    /// Two-level effects; those of all factors if they are all at two levels and nothing is said.
    pub effects: Option<EffectsStudy>,
}

/// Highest order of all products; there are too many of the next.
const HIGHEST_ORDER: u32 = 9;

/// Two-level effects of a table.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffectsStudy {
    /// Columns at two levels.
    pub factors: Vec<String>,
    /// Columns that are blocks here (numbers or texts): what is taken out.
    #[serde(default)]
    pub blocks: Vec<String>,
    /// Interactions of up to so many factors; of all if nothing is said.
    pub order: Option<u32>,
}

/// A table analysed.
#[derive(Debug, Clone, PartialEq)]
pub struct TableAnalysis {
    /// Its columns.
    pub data: Data,
    /// Candidates.
    pub candidates: Vec<Term>,
    /// Terms up to the order that the points do not tell from others, and those others.
    pub left_out: Vec<(Term, String)>,
    /// In the order of the responses.
    pub responses: Vec<Analysis>,
    /// Effects of each response, if there are two-level factors.
    pub effects: Vec<Effects>,
}

fn yes() -> bool {
    true
}

fn level() -> f64 {
    0.95
}

impl Study {
    /// Reads a RON file.
    ///
    /// # Errors
    /// If it cannot be read, does not say what is expected, or has no table.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let study: Self = ron_file::read(path)?;
        if study.tables.is_empty() {
            return Err(InputError::in_field(path, "tables", "there is no table to analyse")
                .with_help("add one, `(data: \"runs.csv\", factors: [\"alpha\"], responses: [\"CL\"])`"));
        }
        for table in &study.tables {
            table.check(path)?;
        }
        Ok(study)
    }
}

impl TableStudy {
    /// A table with its columns, all else as by default.
    pub fn new(data: &str, factors: &[String], responses: &[String], blocks: &[String]) -> Self {
        Self {
            data: data.to_string(),
            factors: factors.to_vec(),
            responses: responses.to_vec(),
            blocks: blocks.to_vec(),
            order: None,
            terms: Vec::new(),
            blocking: Blocking::default(),
            search: Search::default(),
            sigma0_squared: ErrorRule::default(),
            hierarchical: yes(),
            level: level(),
            effects: None,
        }
    }

    /// Complains at the line of the file about what can be seen without the table.
    fn check(&self, path: &Path) -> Result<(), InputError> {
        let of_table = format!("\"{}\"", self.data);
        let place = |name: &str| -> Result<_, InputError> {
            Ok(place_of(&[of_table.as_str(), name], &read_text(path)?, path))
        };
        for (field, names) in [("factors:", &self.factors), ("responses:", &self.responses)] {
            if names.is_empty() {
                return Err(InputError::at(&place(field)?, "no column is named here"));
            }
        }
        if let Some(order) = self.order.filter(|order| *order > HIGHEST_ORDER) {
            let message = format!("order is {order}, expected 0 to {HIGHEST_ORDER}");
            return Err(InputError::at(&place("order:")?, message)
                .with_help("name single terms of higher order in `terms`"));
        }
        for text in &self.terms {
            let quoted = format!("\"{text}\"");
            let term: Term = text.parse().map_err(|fault: Fault| match place(&quoted) {
                Ok(span) => InputError::at(&span, fault.to_string()),
                Err(error) => error,
            })?;
            if let Some((factor, _)) = term.powers().find(|(f, _)| !self.factors.iter().any(|own| own == f)) {
                let message = format!("the term `{text}` has `{factor}`, which is no factor of this table");
                return Err(InputError::at(&place(&quoted)?, message)
                    .with_help(format!("the factors are {}", self.factors.join(", "))));
            }
        }
        Ok(())
    }

    /// The rules of the choice.
    pub fn rules(&self) -> Rules {
        let (search, error, hierarchical) = (self.search, self.sigma0_squared, self.hierarchical);
        Rules { search, error, blocking: self.blocking, hierarchical }
    }

    /// Analyses the table.
    ///
    /// # Errors
    /// At the cell or column that is wrong; a fault of the candidates, the choice or the effects, of the whole table.
    pub fn analyse(&self, table: &Table) -> Result<TableAnalysis, InputError> {
        let (factors, responses) = (names(&self.factors), names(&self.responses));
        if factors.is_empty() || responses.is_empty() {
            let what = if factors.is_empty() { "factor" } else { "response" };
            let error = InputError::general(format!("no {what} is named for {}", self.data));
            return Err(error.with_help(format!("name columns of the table as its {what}s")));
        }
        let data = self.data_of(table)?;
        let here = |fault: Fault| fault.in_table(table);
        let Candidates { terms: candidates, left_out } = self.candidates(&data).map_err(here)?;
        let one = |name: &&str| analyse(&data, name, &candidates, self.rules(), self.level);
        let analyses = responses.iter().map(one).collect::<Result<_, _>>().map_err(here)?;
        let effects = match self.effects_study(&data) {
            Some(study) => self.effects(&study, table)?,
            None => Vec::new(),
        };
        Ok(TableAnalysis { data, candidates, left_out, responses: analyses, effects })
    }

    /// The columns of the table.
    ///
    /// # Errors
    /// As [`Data::from_table`].
    pub fn data_of(&self, table: &Table) -> Result<Data, InputError> {
        Data::from_table(table, &names(&self.factors), &names(&self.responses), &names(&self.blocks))
    }

    /// All terms of the order and those named, whether these points tell them apart or not.
    ///
    /// # Errors
    /// If a term cannot be read.
    pub fn library(&self) -> Result<Vec<Term>, Fault> {
        let order = self.order.or_else(|| self.terms.is_empty().then_some(ORDER));
        let mut terms = order.map_or_else(Vec::new, |order| Term::up_to_order(&names(&self.factors), order));
        for text in &self.terms {
            let term: Term = text.parse()?;
            if !terms.contains(&term) {
                terms.push(term);
            }
        }
        Ok(terms)
    }

    fn candidates(&self, data: &Data) -> Result<Candidates, Fault> {
        let order = self.order.or_else(|| self.terms.is_empty().then_some(ORDER));
        let mut found = match order {
            Some(order) => candidates(data, &data.factor_names(), order, self.blocking)?,
            None => Candidates { terms: vec![Term::constant()], left_out: Vec::new() },
        };
        for text in &self.terms {
            let term: Term = text.parse()?;
            // what is asked for by name is not left out: a fit refuses it
            found.left_out.retain(|(other, _)| *other != term);
            if !found.terms.contains(&term) {
                found.terms.push(term);
            }
        }
        Ok(found)
    }

    fn effects_study(&self, data: &Data) -> Option<EffectsStudy> {
        let two = |name: &String| {
            let values = data.factor_values(name).unwrap_or_default();
            let other = values.iter().find(|value| **value != values[0]);
            values.iter().all(|value| *value == values[0] || Some(value) == other)
        };
        let (factors, blocks) = (self.factors.clone(), self.blocks.clone());
        let of_all = || EffectsStudy { factors, blocks, order: None };
        self.effects.clone().or_else(|| self.factors.iter().all(two).then(of_all))
    }

    fn effects(&self, study: &EffectsStudy, table: &Table) -> Result<Vec<Effects>, InputError> {
        let factors = names(&study.factors);
        let data = Data::from_table(table, &factors, &names(&self.responses), &names(&study.blocks))?;
        let order = study.order.unwrap_or(u32::try_from(factors.len()).unwrap_or(u32::MAX));
        let blocking = if self.blocking == Blocking::Ignored { Blocking::Ignored } else { Blocking::Fixed };
        let one = |name: &String| effects(&data, name, &factors, order, (blocking, self.level));
        self.responses.iter().map(one).collect::<Result<_, _>>().map_err(|fault| fault.in_table(table))
    }
}

fn names(names: &[String]) -> Vec<&str> {
    names.iter().map(String::as_str).collect()
}
