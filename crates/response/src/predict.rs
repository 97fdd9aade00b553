//! What a fitted surface says at a point: value, slope, and how sure it is there. The standard error grows with the
//! leverage x' (X'X)^-1 x, the point's distance from the middle of the data ("site selection"). All values are those of the
//! mean block.

use schemars::JsonSchema;
use serde::Serialize;

use crate::distributions::{t_interval, t_quantile};
use crate::fault::Fault;
use crate::regression::Regression;

/// A prediction at a point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Prediction {
    /// Value, unit of the response.
    pub value: f64,
    /// Standard error of the surface there, same unit.
    #[schemars(with = "Option<f64>")]
    pub standard_error: f64,
    /// x' (X'X)^-1 x; the mean over the points of the data is parameters over points.
    pub leverage: f64,
    /// True if the leverage is above that of every point of the data: the point is outside of them.
    #[serde(rename = "beyond_data")]
    pub extrapolated: bool,
    /// Variance of one reading in the mean block.
    #[serde(skip)]
    pub error_variance: f64,
    /// Of the variance.
    #[serde(skip)]
    pub degrees_of_freedom: f64,
}

impl Prediction {
    /// The interval that holds the true mean there with the given probability.
    ///
    /// # Errors
    /// If the level is not between 0 and 1.
    pub fn mean_interval(&self, level: f64) -> Result<(f64, f64), Fault> {
        t_interval(self.value, self.standard_error, level, self.degrees_of_freedom)
    }

    /// The interval that holds the next reading there with the given probability.
    ///
    /// # Errors
    /// If the level is not between 0 and 1.
    pub fn reading_interval(&self, level: f64) -> Result<(f64, f64), Fault> {
        let sigma = self.standard_error.hypot(self.error_variance.sqrt());
        t_interval(self.value, sigma, level, self.degrees_of_freedom)
    }
}

/// A slope of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slope {
    /// Unit of the response over that of the factor.
    pub value: f64,
    /// Same unit.
    pub standard_error: f64,
}

impl Regression {
    /// Value of the surface at a point, by the factors' names; factors that no term has may be left out.
    ///
    /// # Errors
    /// If a factor of a term is missing, or a term has no finite value there.
    pub fn value(&self, point: &[(&str, f64)]) -> Result<f64, Fault> {
        let terms = self.term_values(point)?;
        Ok(self.combine(&terms))
    }

    /// The prediction at a point.
    ///
    /// # Errors
    /// As [`Regression::value`].
    pub fn predict(&self, point: &[(&str, f64)]) -> Result<Prediction, Fault> {
        let terms = self.term_values(point)?;
        let leverage = self.leverage(&terms);
        let largest = self.leverages.iter().copied().fold(0.0, f64::max);
        Ok(Prediction {
            value: self.combine(&terms),
            standard_error: (self.error_variance * leverage).sqrt(),
            leverage,
            // a hair of room for a point of the data itself
            extrapolated: leverage > largest * (1.0 + 1e-9),
            error_variance: self.error_variance,
            degrees_of_freedom: self.degrees_of_freedom,
        })
    }

    /// The slope with respect to a factor at a point.
    ///
    /// # Errors
    /// As [`Regression::value`], and if the data have no such factor.
    pub fn slope(&self, factor: &str, point: &[(&str, f64)]) -> Result<Slope, Fault> {
        if !self.factors().iter().any(|known| known == factor) {
            return Err(self.unknown(factor));
        }
        self.term_values(point)?;
        let of = |name: &str| lookup(point, name).unwrap_or(f64::NAN);
        let slopes: Vec<f64> = self.coefficients.iter().map(|c| c.term.derivative(factor, of)).collect();
        let standard_error = (self.error_variance * self.leverage(&slopes)).sqrt();
        Ok(Slope { value: self.combine(&slopes), standard_error })
    }

    /// Slopes with respect to all factors, in the order of [`Regression::factors`].
    ///
    /// # Errors
    /// As [`Regression::value`].
    pub fn gradient(&self, point: &[(&str, f64)]) -> Result<Vec<Slope>, Fault> {
        self.factors().iter().map(|factor| self.slope(factor, point)).collect()
    }

    /// The least difference between the surface at two points that is significant at the level: the t quantile times
    /// the standard error of the difference, in which what both have in common cancels.
    ///
    /// # Errors
    /// As [`Regression::value`], and if the level is not between 0 and 1.
    pub fn least_significant_difference(
        &self,
        one: &[(&str, f64)],
        other: &[(&str, f64)],
        level: f64,
    ) -> Result<f64, Fault> {
        let (one, other) = (self.term_values(one)?, self.term_values(other)?);
        let difference: Vec<f64> = one.iter().zip(&other).map(|(one, other)| one - other).collect();
        let sigma = (self.error_variance * self.leverage(&difference)).sqrt();
        Ok(t_quantile(level, self.degrees_of_freedom)? * sigma)
    }

    /// The one number of the surface for that (LSD): t sqrt(2 v), with v the mean variance of the fitted values over the
    /// data, which is the error variance times parameters over points (Box and Draper). It takes the two predictions as
    /// independent.
    ///
    /// # Errors
    /// If the level is not between 0 and 1.
    pub fn mean_least_significant_difference(&self, level: f64) -> Result<f64, Fault> {
        let mean_variance = self.error_variance * self.parameters() as f64 / self.points() as f64;
        Ok(t_quantile(level, self.degrees_of_freedom)? * (2.0 * mean_variance).sqrt())
    }

    fn combine(&self, terms: &[f64]) -> f64 {
        self.coefficients.iter().zip(terms).map(|(coefficient, term)| coefficient.value * term).sum()
    }

    fn term_values(&self, point: &[(&str, f64)]) -> Result<Vec<f64>, Fault> {
        let mut values = Vec::with_capacity(self.coefficients.len());
        for coefficient in &self.coefficients {
            let term = &coefficient.term;
            if let Some((missing, _)) = term.powers().find(|(factor, _)| lookup(point, factor).is_none()) {
                return Err(self.unknown(missing));
            }
            let value = term.value(|name| lookup(point, name).unwrap_or(f64::NAN));
            if !value.is_finite() {
                return Err(Fault::NotFinite { name: term.to_string(), point: 1, value });
            }
            values.push(value);
        }
        Ok(values)
    }

    fn unknown(&self, factor: &str) -> Fault {
        Fault::unknown("value for the factor", factor, self.factors().iter().map(String::as_str))
    }
}

fn lookup(point: &[(&str, f64)], name: &str) -> Option<f64> {
    point.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
}
