//! One published equation: its terms with their coefficients, where it was fitted, and its value at a state. Outside its
//! range, or with a coefficient that the paper does not give, there is no value unless that is asked for.

use thiserror::Error;

use super::factor::{Condition, Factor};
use crate::term::Term;

/// How sure it is that a number belongs to its term.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Confidence {
    /// One of several possible places.
    Low,
    /// The likely place.
    Medium,
    /// In its place.
    High,
}

/// What was done to a coefficient of the tables. The words of the file are in backticks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// `printed`: in its place.
    Printed,
    /// `order_resolved`: its row is out of order.
    OrderResolved,
    /// `term_resolved`: it multiplies another term than the printed one.
    TermResolved,
    /// `exponent_assumed`: the printed exponent cannot be right.
    ExponentAssumed,
    /// `suspected_copy`: the number of another wing.
    SuspectedCopy,
    /// `missing`: the paper has no value.
    Missing,
}

/// A term of an equation.
#[derive(Debug, Clone, PartialEq)]
pub struct Coefficient {
    /// Its name in the tables: `a0`, `a1`, ...
    pub name: String,
    /// What it multiplies, in the paper's letters.
    pub term: Term,
    /// Its value, in the unit of the response over that of the term; `None` if the paper has none.
    pub value: Option<f64>,
    /// How sure the value is.
    pub confidence: Confidence,
    /// What was done to it.
    pub status: Status,
    /// Why, if there is a doubt; else empty.
    pub note: String,
}

/// Where an equation was fitted, by one factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The factor.
    pub factor: Factor,
    /// Least value, in the factor's unit.
    pub low: f64,
    /// Largest value.
    pub high: f64,
}

/// A published equation.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Its number in the paper, 4 to 16.
    pub equation: u8,
    /// `R`, `PR` or `BR`; empty if the paper does not say which wing.
    pub wing: String,
    /// `n_krpm`, `CL`, `CD` or `Cm`.
    pub response: String,
    /// Its terms in the paper's order.
    pub coefficients: Vec<Coefficient>,
    /// Its range, by factor.
    pub ranges: Vec<Range>,
}

/// What is done where a published equation has no answer of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rules {
    /// Evaluate outside the range too.
    pub extrapolate: bool,
    /// Leave out terms whose coefficient the paper does not give.
    pub leave_out_missing: bool,
}

impl Rules {
    /// Only what the paper supports.
    pub const STRICT: Self = Self { extrapolate: false, leave_out_missing: false };

    /// The same, outside the range too.
    #[must_use]
    pub fn extrapolating(self) -> Self {
        Self { extrapolate: true, ..self }
    }

    /// The same, without the terms that have no coefficient.
    #[must_use]
    pub fn leaving_out_missing(self) -> Self {
        Self { leave_out_missing: true, ..self }
    }
}

/// Why an equation has no value.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NoValue {
    /// Outside the range.
    #[error("Eq. {equation} was fitted for {symbol} from {low} to {high} {unit}; {value} {unit} is outside (ask for extrapolation if that is meant)", symbol = factor.symbol(), unit = factor.unit())]
    Outside {
        /// The equation.
        equation: u8,
        /// The factor.
        factor: Factor,
        /// Its value.
        value: f64,
        /// Least value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// The state lacks a factor.
    #[error("Eq. {equation} needs {symbol} ({unit}), which the state does not have", symbol = factor.symbol(), unit = factor.unit())]
    Lacking {
        /// The equation.
        equation: u8,
        /// The factor.
        factor: Factor,
    },
    /// The paper does not give all coefficients.
    #[error("Eq. {equation} has no published value of {} (ask to leave these terms out if that is meant)", names.join(", "))]
    Missing {
        /// The equation.
        equation: u8,
        /// Coefficients and their terms, such as `a10 (delta^3)`.
        names: Vec<String>,
    },
}

impl Model {
    /// Its value in the response's unit.
    ///
    /// # Errors
    /// If the state is outside the range or a coefficient is not published, unless the rules allow it; if the state
    /// lacks a factor. Which one, in words.
    pub fn value(&self, condition: &Condition, rules: Rules) -> Result<f64, NoValue> {
        let equation = self.equation;
        if !rules.leave_out_missing {
            let names: Vec<String> =
                self.missing().map(|missing| format!("{} ({})", missing.name, missing.term)).collect();
            if !names.is_empty() {
                return Err(NoValue::Missing { equation, names });
            }
        }
        if !rules.extrapolate {
            self.within_range(condition)?;
        }
        self.coefficients.iter().try_fold(0.0, |sum, coefficient| {
            let term = condition.value(&coefficient.term);
            let term = term.map_err(|factor| NoValue::Lacking { equation, factor })?;
            Ok(sum + coefficient.value.unwrap_or(0.0) * term)
        })
    }

    /// Demands a state within the range.
    ///
    /// # Errors
    /// The first factor that is lacking or outside.
    pub fn within_range(&self, condition: &Condition) -> Result<(), NoValue> {
        let equation = self.equation;
        for &Range { factor, low, high } in &self.ranges {
            let value = condition.get(factor).ok_or(NoValue::Lacking { equation, factor })?;
            // a hair of room for q = rho V^2 / 2 computed elsewhere; NaN is outside
            let room = 1e-9 * high.abs();
            if !(low - room..=high + room).contains(&value) {
                return Err(NoValue::Outside { equation, factor, value, low, high });
            }
        }
        Ok(())
    }

    /// The coefficients that the paper does not give.
    pub fn missing(&self) -> impl Iterator<Item = &Coefficient> {
        self.coefficients.iter().filter(|coefficient| coefficient.value.is_none())
    }

    /// True if a term has the propeller speed in it.
    pub fn needs_propeller_speed(&self) -> bool {
        let mut factors = self.coefficients.iter().flat_map(|coefficient| Factor::of_term(&coefficient.term));
        factors.any(|factor| factor == Factor::PropellerSpeed)
    }

    /// The range of a factor, if the equation has one.
    pub fn range(&self, factor: Factor) -> Option<Range> {
        self.ranges.iter().copied().find(|range| range.factor == factor)
    }

    /// The coefficient of a term, such as `q*delta`.
    pub fn coefficient(&self, term: &str) -> Option<&Coefficient> {
        self.coefficients.iter().find(|coefficient| coefficient.term.to_string() == term)
    }
}

impl From<NoValue> for nastran::InputError {
    fn from(error: NoValue) -> Self {
        Self::general(error.to_string())
    }
}
