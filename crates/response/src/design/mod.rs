//! Planned experiments in coded units (-1 low, +1 high): factorials and their fractions, central composite and D-optimal
//! designs, and the smallest effect that one can see.

mod composite;
mod d_optimal;
mod factorial;
mod power;

use crate::columns::Columns;
use crate::data::Data;
use crate::fault::Fault;
use crate::term::{Term, is_name};

pub use composite::{Axial, central_composite};
pub use d_optimal::{DOptimal, d_optimal};
pub use factorial::{Fraction, Generator, fractional_factorial, full_factorial};
pub use power::{detectable_noncentrality, power, smallest_effects};

/// Points of an experiment in coded units.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    factors: Vec<String>,
    points: Vec<Vec<f64>>,
}

impl Design {
    /// From the names of the factors and the points, each with one value a factor.
    ///
    /// # Errors
    /// If a name is used twice or cannot stand in a term, a point has another number of values, or one is not finite.
    pub fn new(factors: &[&str], points: Vec<Vec<f64>>) -> Result<Self, Fault> {
        for (index, name) in factors.iter().enumerate() {
            let refused = |why| Fault::Name { name: (*name).to_string(), why };
            if !is_name(name) {
                return Err(refused("letters, digits, `_` and `.` only, and a letter first"));
            }
            if factors[..index].contains(name) {
                return Err(refused("it is used twice"));
            }
        }
        for (index, point) in points.iter().enumerate() {
            if point.len() != factors.len() || point.iter().any(|value| !value.is_finite()) {
                let why = format!("point {} has not {} finite values", index + 1, factors.len());
                return Err(Fault::Design { why });
            }
        }
        Ok(Self { factors: factors.iter().map(ToString::to_string).collect(), points })
    }

    /// Names of the factors.
    pub fn factors(&self) -> Vec<&str> {
        self.factors.iter().map(String::as_str).collect()
    }

    /// The points.
    pub fn points(&self) -> &[Vec<f64>] {
        &self.points
    }

    /// The same points, each as often as wanted: the whole design again and again, so that a repetition can be a block.
    #[must_use]
    pub fn replicated(&self, times: usize) -> Self {
        let points = self.points.iter().cycle().take(self.points.len() * times).cloned().collect();
        Self { factors: self.factors.clone(), points }
    }

    /// Values of a term at all points.
    ///
    /// # Errors
    /// If a factor is not in the design.
    pub fn column(&self, term: &Term) -> Result<Vec<f64>, Fault> {
        for (factor, _) in term.powers() {
            if !self.factors.iter().any(|known| known == factor) {
                return Err(Fault::unknown("factor", factor, self.factors()));
            }
        }
        let place = |name: &str| self.factors.iter().position(|known| known == name).unwrap_or(0);
        Ok(self.points.iter().map(|point| term.value(|name| point[place(name)])).collect())
    }

    /// The columns of terms.
    fn columns(&self, terms: &[Term]) -> Result<Columns, Fault> {
        let values = terms.iter().map(|term| self.column(term)).collect::<Result<_, _>>()?;
        Ok(Columns { names: terms.iter().map(ToString::to_string).collect(), values })
    }

    /// In the units of the factors, from the low and high value of each in their order.
    ///
    /// # Errors
    /// If there is not one pair for every factor, or low is not below high.
    pub fn decoded(&self, low_high: &[(f64, f64)]) -> Result<Vec<Vec<f64>>, Fault> {
        if low_high.len() != self.factors.len() {
            let why = format!("{} factors need as many pairs of low and high", self.factors.len());
            return Err(Fault::Design { why });
        }
        if let Some(place) =
            low_high.iter().position(|(low, high)| high.partial_cmp(low) != Some(std::cmp::Ordering::Greater))
        {
            let why = format!("low is not below high for `{}`", self.factors[place]);
            return Err(Fault::Design { why });
        }
        let one = |(coded, (low, high)): (&f64, &(f64, f64))| 0.5 * (low + high) + 0.5 * (high - low) * coded;
        Ok(self.points.iter().map(|point| point.iter().zip(low_high).map(one).collect()).collect())
    }

    /// As data, for responses to be added.
    ///
    /// # Errors
    /// If a factor does not vary.
    pub fn data(&self) -> Result<Data, Fault> {
        let mut data = Data::new();
        for (place, name) in self.factors.iter().enumerate() {
            data = data.factor(name, self.points.iter().map(|point| point[place]).collect())?;
        }
        Ok(data)
    }
}
