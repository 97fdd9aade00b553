//! A response surface fitted to data: given terms by least squares, with fixed or random block offsets, and what the fit
//! says of itself. Coefficients are in the unit of the response over that of the term.

use schemars::JsonSchema;
use serde::Serialize;

use crate::columns::Columns;
use crate::data::{Blocking, Blocks, Data};
use crate::distributions::{t_interval, two_sided_t};
use crate::f_test::FTest;
use crate::fault::Fault;
use crate::qr::{Qr, dot, residuals, subtract};
use crate::reml::{decorrelated, transformed, variance_ratio};
use crate::term::Term;
use crate::total_sum::total_sum;

/// A coefficient with its t test against zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Coefficient {
    /// What it multiplies.
    pub term: Term,
    /// Its value, unit of the response over that of the term.
    pub value: f64,
    /// Its standard error, same unit.
    pub standard_error: f64,
    /// Value over standard error.
    pub t: f64,
    /// Probability of a |t| as large if the true coefficient is zero.
    pub p_value: f64,
}

impl Coefficient {
    /// The interval that holds the true coefficient with the given probability.
    ///
    /// # Errors
    /// If the level is not between 0 and 1.
    pub fn interval(&self, level: f64, degrees_of_freedom: f64) -> Result<(f64, f64), Fault> {
        t_interval(self.value, self.standard_error, level, degrees_of_freedom)
    }
}

/// The offset of a block from the mean block.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BlockOffset {
    /// The block column.
    pub blocks: String,
    /// The block.
    #[serde(rename = "block")]
    pub label: String,
    /// Its offset, unit of the response; of random blocks the best linear unbiased prediction.
    #[serde(rename = "offset")]
    pub value: f64,
}

/// A fitted response surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Regression {
    /// Name of the response.
    pub response: String,
    /// Coefficients in the order of the terms.
    pub coefficients: Vec<Coefficient>,
    /// Offsets of blocks; empty if blocks are ignored.
    pub offsets: Vec<BlockOffset>,
    /// Variance of errors within blocks: residual sum of squares over its degrees of freedom.
    pub error_variance: f64,
    /// Variance between random blocks; 0 for other blocks.
    pub block_variance: f64,
    /// Points minus parameters.
    pub degrees_of_freedom: f64,
    /// Residual sum of squares (of random blocks: in the transformed space in which errors are independent).
    pub residual_sum: f64,
    /// Sum of squares about the mean, once the offsets of fixed blocks are out; about zero if there is no constant.
    pub total_sum: f64,
    /// What is left at each point, offsets taken out.
    pub residuals: Vec<f64>,
    /// Leverage of each point: its own share in its fitted value.
    pub leverages: Vec<f64>,
    factors: Vec<String>,
    qr: Qr,
}

impl Regression {
    /// Fits terms to a response.
    ///
    /// # Errors
    /// If a name is not in the data, terms are aliased or have values that are not finite, the response is constant, or
    /// the points are not more than the parameters.
    pub fn fit(data: &Data, response: &str, terms: &[Term], blocking: Blocking) -> Result<Self, Fault> {
        let y = data.response_values(response)?;
        if let Some(&value) = y.first()
            && y.iter().all(|other| *other == value)
        {
            return Err(Fault::ConstantResponse { name: response.to_string(), value });
        }
        let columns = Columns::of_model(data, terms, blocking)?;
        if y.len() <= columns.len() {
            let needs = " and an estimate of the error";
            return Err(Fault::TooFewPoints { points: y.len(), terms: columns.len(), needs });
        }
        match blocking {
            Blocking::Random => Self::with_random_blocks(data, response, terms, &columns),
            Blocking::Ignored | Blocking::Fixed => {
                let mut fitted = Self::of_columns(terms, &columns, y)?;
                fitted.total_sum = total_sum(data, y, terms, blocking)?;
                fitted.name(data, response);
                let blocks = if blocking == Blocking::Fixed { data.blocks() } else { &[] };
                fitted.offsets = fixed_offsets(&fitted.qr.solve(&columns.values, y)[terms.len()..], blocks);
                Ok(fitted)
            }
        }
    }

    fn with_random_blocks(
        data: &Data,
        response: &str,
        terms: &[Term],
        columns: &Columns,
    ) -> Result<Self, Fault> {
        let [blocks] = data.blocks() else {
            let why = format!("random blocks need one column of blocks, there are {}", data.blocks().len());
            return Err(Fault::Design { why });
        };
        let y = data.response_values(response)?;
        let ratio = variance_ratio(columns, y, blocks)?;
        let changed = decorrelated(columns, blocks, ratio);
        let mut fitted = Self::of_columns(terms, &changed, &transformed(y, blocks, ratio))?;
        fitted.block_variance = ratio * fitted.error_variance;
        let values: Vec<f64> = fitted.coefficients.iter().map(|c| c.value).collect();
        fitted.residuals = residuals(&columns.values, &values, y);
        fitted.offsets = fitted.take_out_predictions(blocks, ratio);
        fitted.total_sum = total_sum(data, y, terms, Blocking::Ignored)?;
        fitted.name(data, response);
        Ok(fitted)
    }

    /// Best linear unbiased predictions of the offsets, which are taken out of the residuals.
    fn take_out_predictions(&mut self, blocks: &Blocks, ratio: f64) -> Vec<BlockOffset> {
        let mut values = vec![0.0; blocks.labels.len()];
        self.residuals.iter().zip(&blocks.of_point).for_each(|(rest, block)| values[*block] += rest);
        for (value, size) in values.iter_mut().zip(blocks.sizes()) {
            *value *= ratio / (1.0 + ratio * size as f64);
        }
        self.residuals.iter_mut().zip(&blocks.of_point).for_each(|(rest, block)| *rest -= values[*block]);
        let offset = |(label, value): (&String, f64)| BlockOffset {
            blocks: blocks.name.clone(),
            label: label.clone(),
            value,
        };
        blocks.labels.iter().zip(values).map(offset).collect()
    }

    fn of_columns(terms: &[Term], columns: &Columns, y: &[f64]) -> Result<Self, Fault> {
        let qr = columns.orthogonalised()?;
        let solution = qr.solve(&columns.values, y);
        let residuals = residuals(&columns.values, &solution, y);
        let residual_sum = dot(&residuals, &residuals);
        let degrees_of_freedom = (y.len() - columns.len()) as f64;
        let error_variance = residual_sum / degrees_of_freedom;
        let coefficient = |(j, term): (usize, &Term)| {
            let standard_error = (error_variance * qr.leverage_of(j)).sqrt();
            let t = solution[j] / standard_error;
            let p_value = two_sided_t(t, degrees_of_freedom);
            Coefficient { term: term.clone(), value: solution[j], standard_error, t, p_value }
        };
        Ok(Self {
            response: String::new(),
            coefficients: terms.iter().enumerate().map(coefficient).collect(),
            offsets: Vec::new(),
            error_variance,
            block_variance: 0.0,
            degrees_of_freedom,
            residual_sum,
            total_sum: 0.0,
            residuals,
            leverages: qr.leverages(),
            factors: Vec::new(),
            qr,
        })
    }

    fn name(&mut self, data: &Data, response: &str) {
        self.response = response.to_string();
        self.factors = data.factor_names().into_iter().map(String::from).collect();
    }

    /// Names of the factors of the data, in their order, used by a term or not.
    pub fn factors(&self) -> &[String] {
        &self.factors
    }

    /// The terms.
    pub fn terms(&self) -> Vec<Term> {
        self.coefficients.iter().map(|coefficient| coefficient.term.clone()).collect()
    }

    /// The coefficient of a term.
    pub fn coefficient(&self, term: &Term) -> Option<&Coefficient> {
        self.coefficients.iter().find(|coefficient| coefficient.term == *term)
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.residuals.len()
    }

    /// Number of parameters: terms, and one less than blocks for each column of fixed blocks.
    pub fn parameters(&self) -> usize {
        self.qr.q.len()
    }

    /// x' (X'X)^-1 x, for values of the terms at the mean block.
    pub(crate) fn leverage(&self, terms: &[f64]) -> f64 {
        self.qr.leverage(&self.padded(terms))
    }

    /// F test of a family of terms: what they explain together beyond the others, against the residual. One for a term
    /// alone is the square of its t.
    ///
    /// # Errors
    /// If a term of the family is not in the surface, or the family is empty.
    pub fn family_test(&self, family: &[Term]) -> Result<FTest, Fault> {
        let (mut values, mut white, mut names) = (Vec::new(), Vec::new(), Vec::new());
        for term in family {
            let found = self.coefficients.iter().position(|c| c.term == *term).ok_or_else(|| {
                let known: Vec<String> = self.terms().iter().map(ToString::to_string).collect();
                Fault::unknown("term in the surface", &term.to_string(), known.iter().map(String::as_str))
            })?;
            white.push(self.qr.whitened_unit(found));
            values.push(self.coefficients[found].value);
            names.push(term.to_string());
        }
        Fault::unless(!family.is_empty(), "the number of terms to test", 0.0, "at least 1")?;
        // b' C^-1 b with C = W' W, the family's part of (X'X)^-1
        let explained = Qr::new(&white, &names)?.leverage(&values);
        let (above, below) = (family.len() as f64, self.degrees_of_freedom);
        Ok(FTest::new(explained, above, self.error_variance * below, below))
    }

    /// What the columns of the model leave of another column.
    pub(crate) fn remainder(&self, column: &[f64]) -> Vec<f64> {
        self.qr.remainder(column).0
    }

    fn padded(&self, terms: &[f64]) -> Vec<f64> {
        let mut all = terms.to_vec();
        all.resize(self.parameters(), 0.0);
        all
    }
}

/// Offsets of all blocks from those of all but the last of each column.
fn fixed_offsets(mut solved: &[f64], of: &[Blocks]) -> Vec<BlockOffset> {
    let mut offsets = Vec::new();
    for blocks in of {
        let (own, others) = solved.split_at(blocks.labels.len() - 1);
        solved = others;
        let mut last = [0.0];
        for value in own {
            subtract(&mut last, *value, &[1.0]);
        }
        for (label, value) in blocks.labels.iter().zip(own.iter().chain(&last)) {
            let (blocks, label) = (blocks.name.clone(), label.clone());
            offsets.push(BlockOffset { blocks, label, value: *value });
        }
    }
    offsets
}
