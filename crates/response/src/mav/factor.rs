//! The five independent variables of the micro air vehicle's models, the terms they form, and a state that gives each a
//! value: Eqs. 4 to 16 of "Wind-Tunnel Testing and Modeling of a Micro Air Vehicle with Flexible Wings". Everything
//! here is in the paper's units (Pa, degrees, volt, thousands of revolutions a minute), as its coefficients are.

use crate::term::Term;

/// An independent variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Factor {
    /// Dynamic pressure, Pa.
    DynamicPressure,
    /// Angle of attack, degrees.
    Alpha,
    /// Elevator, degrees, trailing edge down positive.
    Elevator,
    /// Motor voltage, V.
    Voltage,
    /// Propeller speed, thousands of revolutions a minute.
    PropellerSpeed,
}

impl Factor {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::DynamicPressure, Self::Alpha, Self::Elevator, Self::Voltage, Self::PropellerSpeed];

    /// Letter, column and unit.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::DynamicPressure => ("q", "q_Pa", "Pa"),
            Self::Alpha => ("alpha", "alpha_deg", "deg"),
            Self::Elevator => ("delta", "delta_deg", "deg"),
            Self::Voltage => ("E", "E_V", "V"),
            Self::PropellerSpeed => ("n", "n_krpm", "krpm"),
        }
    }

    /// The paper's letter: `q`, `alpha`, `delta`, `E`, `n`.
    pub fn symbol(self) -> &'static str {
        self.words().0
    }

    /// Its column in tables of runs: `q_Pa`, `alpha_deg`, `delta_deg`, `E_V`, `n_krpm`.
    pub fn column(self) -> &'static str {
        self.words().1
    }

    /// The unit of its numbers.
    pub fn unit(self) -> &'static str {
        self.words().2
    }

    /// The factor with this letter.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|factor| factor.symbol() == symbol)
    }

    /// The factors of a term in the paper's letters.
    pub fn of_term(term: &Term) -> impl Iterator<Item = Self> {
        term.powers().filter_map(|(symbol, _)| Self::from_symbol(symbol))
    }
}

/// A state of the vehicle in the tunnel. What no equation in hand needs may be `None`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Condition {
    /// Dynamic pressure, Pa.
    pub q_pa: f64,
    /// Angle of attack, degrees.
    pub alpha_deg: f64,
    /// Elevator, degrees, trailing edge down positive.
    pub delta_deg: f64,
    /// Motor voltage, V.
    pub voltage_v: Option<f64>,
    /// Propeller speed, thousands of revolutions a minute.
    pub n_krpm: Option<f64>,
}

impl Condition {
    /// Without a propeller.
    pub fn unpowered(q_pa: f64, alpha_deg: f64, delta_deg: f64) -> Self {
        Self { q_pa, alpha_deg, delta_deg, voltage_v: None, n_krpm: None }
    }

    /// The same state with the motor at this voltage.
    #[must_use]
    pub fn at_voltage(self, voltage_v: f64) -> Self {
        Self { voltage_v: Some(voltage_v), ..self }
    }

    /// The value of a factor, in its unit; `None` if the state does not have it.
    pub fn get(&self, factor: Factor) -> Option<f64> {
        match factor {
            Factor::DynamicPressure => Some(self.q_pa),
            Factor::Alpha => Some(self.alpha_deg),
            Factor::Elevator => Some(self.delta_deg),
            Factor::Voltage => self.voltage_v,
            Factor::PropellerSpeed => self.n_krpm,
        }
    }

    /// The value of a term in the paper's letters.
    ///
    /// # Errors
    /// The factor that the state does not have.
    pub fn value(&self, term: &Term) -> Result<f64, Factor> {
        term.powers().try_fold(1.0, |product, (symbol, power)| match Factor::from_symbol(symbol) {
            Some(factor) => Ok(product * self.get(factor).ok_or(factor)?.powi(power)),
            // no letter of the paper's
            None => Ok(f64::NAN),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_term_is_a_product_of_powers() {
        let condition = Condition { n_krpm: Some(18.0), ..Condition::unpowered(60.0, 10.0, -5.0) };
        let value = |text: &str| condition.value(&text.parse().expect("a term"));
        assert_eq!(value("1"), Ok(1.0));
        assert_eq!(value("delta^2*alpha"), Ok(250.0));
        assert_eq!(value("n^2/q"), Ok(324.0 / 60.0));
        assert_eq!(value("q*E"), Err(Factor::Voltage));
    }
}
