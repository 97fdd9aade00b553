//! The five independent variables of the micro air vehicle's models, the terms they form, and a state that gives each a
//! value: Eqs. 4 to 16 of "Wind-Tunnel Testing and Modeling of a Micro Air Vehicle with Flexible Wings". Everything
//! here is in the paper's units (Pa, degrees, volt, thousands of revolutions a minute), as its coefficients are.

use std::fmt;

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

    /// The paper's letter: `q`, `alpha`, `delta`, `E`, `n`.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::DynamicPressure => "q",
            Self::Alpha => "alpha",
            Self::Elevator => "delta",
            Self::Voltage => "E",
            Self::PropellerSpeed => "n",
        }
    }

    /// Its column in tables of runs: `q_Pa`, `alpha_deg`, `delta_deg`, `E_V`, `n_krpm`.
    pub fn column(self) -> &'static str {
        match self {
            Self::DynamicPressure => "q_Pa",
            Self::Alpha => "alpha_deg",
            Self::Elevator => "delta_deg",
            Self::Voltage => "E_V",
            Self::PropellerSpeed => "n_krpm",
        }
    }

    /// The unit of its numbers.
    pub fn unit(self) -> &'static str {
        match self {
            Self::DynamicPressure => "Pa",
            Self::Alpha | Self::Elevator => "deg",
            Self::Voltage => "V",
            Self::PropellerSpeed => "krpm",
        }
    }

    /// The factor with this letter.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|factor| factor.symbol() == symbol)
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
}

/// A product of powers of factors, such as `q*delta^2` or `n^2/q`; `1` has none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Monomial {
    powers: Vec<(Factor, i32)>,
}

impl Monomial {
    /// Reads `1`, `q`, `delta^2*alpha`, `n^2/q`.
    ///
    /// # Errors
    /// If a letter is not a factor's or an exponent is not a whole number from 1 to 9: which one, in words.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut powers = Vec::new();
        let mut rest = text.trim();
        let mut sign = 1;
        while rest != "1" {
            let end = rest.find(['*', '/']).unwrap_or(rest.len());
            let (symbol, exponent) = rest[..end].trim().split_once('^').unwrap_or((rest[..end].trim(), "1"));
            let factor = Factor::from_symbol(symbol)
                .ok_or_else(|| format!("`{symbol}` in the term `{text}` is none of q, alpha, delta, E, n"))?;
            let exponent =
                exponent.parse::<i32>().ok().filter(|exponent| (1..=9).contains(exponent)).ok_or_else(
                    || format!("`{exponent}` in the term `{text}` is not an exponent from 1 to 9"),
                )?;
            powers.push((factor, sign * exponent));
            let Some(operator) = rest[end..].chars().next() else { break };
            sign = if operator == '*' { 1 } else { -1 };
            rest = &rest[end + 1..];
        }
        Ok(Self { powers })
    }

    /// The factors in it.
    pub fn factors(&self) -> impl Iterator<Item = Factor> {
        self.powers.iter().map(|(factor, _)| *factor)
    }

    /// Its value.
    ///
    /// # Errors
    /// The factor that the state does not have.
    pub fn value(&self, condition: &Condition) -> Result<f64, Factor> {
        self.powers.iter().try_fold(1.0, |product, &(factor, power)| {
            Ok(product * condition.get(factor).ok_or(factor)?.powi(power))
        })
    }
}

impl fmt::Display for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.powers.is_empty() {
            return f.write_str("1");
        }
        for (index, (factor, power)) in self.powers.iter().enumerate() {
            match (index, *power < 0) {
                (0, false) => {}
                (0, true) => f.write_str("1/")?,
                (_, negative) => f.write_str(if negative { "/" } else { "*" })?,
            }
            f.write_str(factor.symbol())?;
            if power.abs() > 1 {
                write!(f, "^{}", power.abs())?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_are_read_and_written_alike() {
        for text in ["1", "q", "delta^2*alpha", "n^2/q", "alpha^4"] {
            assert_eq!(Monomial::parse(text).expect("a term").to_string(), text);
        }
        for wrong in ["", "x", "q^", "q^0", "q**alpha", "q*", "q^1.5"] {
            assert!(Monomial::parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_term_is_a_product_of_powers() {
        let condition = Condition { n_krpm: Some(18.0), ..Condition::unpowered(60.0, 10.0, -5.0) };
        let value = |text: &str| Monomial::parse(text).expect("a term").value(&condition);
        assert_eq!(value("1"), Ok(1.0));
        assert_eq!(value("delta^2*alpha"), Ok(250.0));
        assert_eq!(value("n^2/q"), Ok(324.0 / 60.0));
        assert_eq!(value("q*E"), Err(Factor::Voltage));
    }
}
