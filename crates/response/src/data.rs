//! Measured points: factors, responses and blocks by name, from a CSV table or from numbers in memory.

use nastran::{InputError, Table};

use schemars::JsonSchema;
use serde::Deserialize;

use crate::fault::Fault;
use crate::term::{Term, is_name};

/// What is done with the blocks of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
pub enum Blocking {
    /// They are not looked at.
    Ignored,
    /// An offset for every block of every block column; the offsets of a column sum to zero.
    #[default]
    Fixed,
    /// Offsets drawn with a variance of their own, found by restricted maximum likelihood; one block column only.
    Random,
}

/// Points with their factors, responses and blocks. All columns are equally long and finite, names are unique.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Data {
    factors: Vec<(String, Vec<f64>)>,
    responses: Vec<(String, Vec<f64>)>,
    blocks: Vec<Blocks>,
    points: usize,
}

/// Which block every point belongs to: a run, a day, a mounting.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks {
    /// Name of the column.
    pub name: String,
    /// Labels in the order of their first points.
    pub labels: Vec<String>,
    /// Of each point, the index of its label.
    pub of_point: Vec<usize>,
}

impl Blocks {
    /// From the label of each point.
    pub fn from_labels<'a>(name: &str, of_points: impl IntoIterator<Item = &'a str>) -> Self {
        let mut labels: Vec<String> = Vec::new();
        let mut of_point = Vec::new();
        for label in of_points {
            let index = labels.iter().position(|known| known == label).unwrap_or_else(|| {
                labels.push(label.to_string());
                labels.len() - 1
            });
            of_point.push(index);
        }
        Self { name: name.to_string(), labels, of_point }
    }

    /// Points of each block.
    pub fn sizes(&self) -> Vec<usize> {
        let mut sizes = vec![0; self.labels.len()];
        self.of_point.iter().for_each(|block| sizes[*block] += 1);
        sizes
    }
}

impl Data {
    /// No points yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Columns of a table. A factor must vary.
    ///
    /// # Errors
    /// At the cell that is missing or no number; a fault of [`Data::factor`], [`Data::response`] or [`Data::block`].
    pub fn from_table(
        table: &Table,
        factors: &[&str],
        responses: &[&str],
        blocks: &[&str],
    ) -> Result<Self, InputError> {
        let mut data = Self::new();
        let here = |fault: Fault| fault.in_table(table);
        for name in factors {
            data = data.factor(name, table.numbers(name)?).map_err(here)?;
        }
        for name in responses {
            data = data.response(name, table.numbers(name)?).map_err(here)?;
        }
        for name in blocks {
            let labels = (0..table.len()).map(|row| table.text(row, name)).collect::<Result<Vec<_>, _>>()?;
            data = data.block(Blocks::from_labels(name, labels)).map_err(here)?;
        }
        Ok(data)
    }

    /// The same with a factor more.
    ///
    /// # Errors
    /// If the name is taken or cannot stand in a term, the length is another, a value is not finite, or all are equal.
    pub fn factor(mut self, name: &str, values: Vec<f64>) -> Result<Self, Fault> {
        self.check(name, &values)?;
        if let Some(&value) = values.first()
            && values.iter().all(|other| *other == value)
        {
            return Err(Fault::ConstantFactor { name: name.to_string(), value });
        }
        self.points = values.len();
        self.factors.push((name.to_string(), values));
        Ok(self)
    }

    /// The same with a response more.
    ///
    /// # Errors
    /// As [`Data::factor`], but a response may be constant.
    pub fn response(mut self, name: &str, values: Vec<f64>) -> Result<Self, Fault> {
        self.check(name, &values)?;
        self.points = values.len();
        self.responses.push((name.to_string(), values));
        Ok(self)
    }

    /// The same with blocks.
    ///
    /// # Errors
    /// If the name is taken, the number of points is another, or there is one block only.
    pub fn block(mut self, blocks: Blocks) -> Result<Self, Fault> {
        self.check_name_and_length(&blocks.name, blocks.of_point.len())?;
        if blocks.labels.len() < 2 {
            let why = "all points are in one".to_string();
            return Err(Fault::Block { name: blocks.name, why });
        }
        self.points = blocks.of_point.len();
        self.blocks.push(blocks);
        Ok(self)
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Names of the factors.
    pub fn factor_names(&self) -> Vec<&str> {
        self.factors.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// Names of the responses.
    pub fn response_names(&self) -> Vec<&str> {
        self.responses.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// All blocks.
    pub fn blocks(&self) -> &[Blocks] {
        &self.blocks
    }

    /// Values of a factor.
    ///
    /// # Errors
    /// If there is none of this name.
    pub fn factor_values(&self, name: &str) -> Result<&[f64], Fault> {
        find(&self.factors, "factor", name)
    }

    /// Values of a response.
    ///
    /// # Errors
    /// If there is none of this name.
    pub fn response_values(&self, name: &str) -> Result<&[f64], Fault> {
        find(&self.responses, "response", name)
    }

    /// Values of a term at all points.
    ///
    /// # Errors
    /// If a factor is missing, or a value is not finite (a factor of zero in a denominator).
    pub fn column(&self, term: &Term) -> Result<Vec<f64>, Fault> {
        let mut values = vec![1.0; self.points];
        for (factor, power) in term.powers() {
            let of_factor = self.factor_values(factor)?;
            values.iter_mut().zip(of_factor).for_each(|(value, factor)| *value *= factor.powi(power));
        }
        check_finite(&term.to_string(), &values)?;
        Ok(values)
    }

    /// The factors of one point, by name.
    pub fn point(&self, index: usize) -> Vec<(&str, f64)> {
        self.factors.iter().map(|(name, values)| (name.as_str(), values[index])).collect()
    }

    /// Some of the points, in the given order.
    pub(crate) fn rows(&self, rows: &[usize]) -> Self {
        let take = |(name, values): &(String, Vec<f64>)| {
            (name.clone(), rows.iter().map(|row| values[*row]).collect())
        };
        let of = |blocks: &Blocks| Blocks {
            name: blocks.name.clone(),
            labels: blocks.labels.clone(),
            of_point: rows.iter().map(|row| blocks.of_point[*row]).collect(),
        };
        Self {
            factors: self.factors.iter().map(take).collect(),
            responses: self.responses.iter().map(take).collect(),
            blocks: self.blocks.iter().map(of).collect(),
            points: rows.len(),
        }
    }

    /// The same with these block columns only.
    pub(crate) fn with_blocks_only(&self, names: &[String]) -> Self {
        let mut data = self.clone();
        data.blocks.retain(|blocks| names.contains(&blocks.name));
        data
    }

    /// The same with other values of a response.
    pub(crate) fn answering(&self, response: &str, values: &[f64]) -> Self {
        let mut data = self.clone();
        data.responses = vec![(response.to_string(), values.to_vec())];
        data
    }

    fn check(&self, name: &str, values: &[f64]) -> Result<(), Fault> {
        self.check_name_and_length(name, values.len())?;
        if !is_name(name) {
            let why = "letters, digits, `_` and `.` only, and a letter first";
            return Err(Fault::Name { name: name.to_string(), why });
        }
        check_finite(name, values)
    }

    fn check_name_and_length(&self, name: &str, found: usize) -> Result<(), Fault> {
        let columns = self.factors.iter().chain(&self.responses).map(|(name, _)| name);
        if columns.chain(self.blocks.iter().map(|blocks| &blocks.name)).any(|known| known == name) {
            return Err(Fault::Name { name: name.to_string(), why: "it is used twice" });
        }
        let first = self.factors.is_empty() && self.responses.is_empty() && self.blocks.is_empty();
        if !first && found != self.points {
            return Err(Fault::Length { name: name.to_string(), found, expected: self.points });
        }
        Ok(())
    }
}

fn check_finite(name: &str, values: &[f64]) -> Result<(), Fault> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(at) => Err(Fault::NotFinite { name: name.to_string(), point: at + 1, value: values[at] }),
        None => Ok(()),
    }
}

fn find<'a>(columns: &'a [(String, Vec<f64>)], what: &'static str, name: &str) -> Result<&'a [f64], Fault> {
    let found = columns.iter().find(|(known, _)| known == name);
    let known = columns.iter().map(|(name, _)| name.as_str());
    found.map(|(_, values)| values.as_slice()).ok_or_else(|| Fault::unknown(what, name, known))
}
