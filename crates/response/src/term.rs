//! Terms of a response surface: products of powers of named factors, such as `alpha^2*q` or `n^2/q`, read and written
//! in that form. The constant is `1`.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};

use crate::fault::Fault;

/// A product of integer powers of factors, possibly negative; no factor twice, no power of zero. Two terms are equal if
/// they are the same product, in whatever order they were written.
#[derive(Debug, Clone, Default)]
pub struct Term {
    powers: Vec<(String, i32)>,
}

impl Term {
    /// The constant, `1`.
    pub fn constant() -> Self {
        Self::default()
    }

    /// The product of the given powers; a factor named twice has the sum of its powers.
    pub fn new<'a>(powers: impl IntoIterator<Item = (&'a str, i32)>) -> Self {
        let mut term = Self::constant();
        for (factor, power) in powers {
            match term.powers.iter_mut().find(|(known, _)| known == factor) {
                Some((_, sum)) => *sum += power,
                None => term.powers.push((factor.to_string(), power)),
            }
        }
        term.powers.retain(|(_, power)| *power != 0);
        term
    }

    /// All products of non-negative powers of the factors up to a total order, the constant included: low orders first,
    /// and within an order in the order of the factors.
    pub fn up_to_order(factors: &[&str], order: u32) -> Vec<Self> {
        let mut terms = vec![Self::constant()];
        for total in 1..=order {
            let mut exponents = Vec::new();
            exponents_of_order(factors.len(), total, &mut Vec::new(), &mut exponents);
            for of_term in exponents {
                let powers = factors.iter().zip(of_term);
                terms.push(Self::new(powers.map(|(factor, power)| (*factor, power))));
            }
        }
        terms
    }

    /// Factors and their powers, as written.
    pub fn powers(&self) -> impl Iterator<Item = (&str, i32)> {
        self.powers.iter().map(|(factor, power)| (factor.as_str(), *power))
    }

    /// The power of a factor; 0 if it is not in the term.
    pub fn power(&self, factor: &str) -> i32 {
        self.powers.iter().find(|(known, _)| known == factor).map_or(0, |(_, power)| *power)
    }

    /// True for `1`.
    pub fn is_constant(&self) -> bool {
        self.powers.is_empty()
    }

    /// Sum of the absolute powers.
    pub fn order(&self) -> u32 {
        self.powers.iter().map(|(_, power)| power.unsigned_abs()).sum()
    }

    /// True if the other term is this one with some powers nearer to zero: `q` and `alpha*q` of `alpha^2*q`, but not
    /// the term itself. These are the terms that a shift of the factors' origins makes out of it.
    pub fn is_above(&self, other: &Self) -> bool {
        let nearer = |(factor, power): (&str, i32)| {
            let own = self.power(factor);
            own.signum() == power.signum() && own.abs() >= power.abs()
        };
        self != other && other.powers().all(nearer)
    }

    /// Its value from values of the factors.
    pub fn value(&self, of: impl Fn(&str) -> f64) -> f64 {
        self.powers.iter().map(|(factor, power)| of(factor).powi(*power)).product()
    }

    /// Its derivative with respect to a factor at values of the factors.
    pub fn derivative(&self, factor: &str, of: impl Fn(&str) -> f64) -> f64 {
        let power = self.power(factor);
        if power == 0 {
            return 0.0;
        }
        let one_less = |(known, own): (&str, i32)| of(known).powi(own - i32::from(known == factor));
        f64::from(power) * self.powers().map(one_less).product::<f64>()
    }
}

fn exponents_of_order(factors: usize, total: u32, head: &mut Vec<i32>, found: &mut Vec<Vec<i32>>) {
    if factors == 0 {
        if total == 0 {
            found.push(head.clone());
        }
        return;
    }
    for power in (0..=total).rev() {
        head.push(i32::try_from(power).unwrap_or(i32::MAX));
        exponents_of_order(factors - 1, total - power, head, found);
        head.pop();
    }
}

impl PartialEq for Term {
    fn eq(&self, other: &Self) -> bool {
        self.powers.len() == other.powers.len()
            && self.powers.iter().all(|(factor, power)| other.power(factor) == *power)
    }
}

impl Eq for Term {}

impl JsonSchema for Term {
    fn schema_name() -> Cow<'static, str> {
        "Term".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "description": "A product of powers of factors, such as n^2/q; 1 is the constant." })
    }
}

impl Serialize for Term {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl FromStr for Term {
    type Err = Fault;

    /// Reads `1`, `alpha^2*q`, `n^2/q`, `1/q`, `q^-1`.
    fn from_str(text: &str) -> Result<Self, Fault> {
        let wrong = |why: String| Fault::WrongTerm { term: text.to_string(), why };
        let mut powers: Vec<(&str, i32)> = Vec::new();
        let (mut sign, mut rest) = (1, text);
        loop {
            let end = rest.find(['*', '/']).unwrap_or(rest.len());
            let piece = rest[..end].trim();
            let (name, exponent) = piece.split_once('^').unwrap_or((piece, "1"));
            let (name, exponent) = (name.trim(), exponent.trim());
            let power = exponent.parse::<i32>().ok().filter(|power| (1..=9).contains(&power.abs()));
            let power = power.ok_or_else(|| {
                wrong(format!("`{exponent}` is not a whole exponent from 1 to 9 or -1 to -9"))
            })?;
            if name != "1" {
                if !is_name(name) {
                    return Err(wrong(format!("`{piece}` is not the name of a factor")));
                }
                powers.push((name, sign * power));
            }
            let Some(operator) = rest[end..].chars().next() else { break };
            sign = if operator == '*' { 1 } else { -1 };
            rest = &rest[end + 1..];
        }
        Ok(Self::new(powers))
    }
}

/// A letter, then letters, digits, `_` and `.`: what a term can be read back from.
pub(crate) fn is_name(name: &str) -> bool {
    let mut characters = name.chars();
    characters.next().is_some_and(|first| first.is_alphabetic() || first == '_')
        && characters.all(|c| c.is_alphanumeric() || c == '_' || c == '.')
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.powers.is_empty() {
            return f.write_str("1");
        }
        // what is multiplied before what is divided by
        let above = self.powers.iter().filter(|(_, power)| *power > 0);
        let below = self.powers.iter().filter(|(_, power)| *power < 0);
        if self.powers.iter().all(|(_, power)| *power < 0) {
            f.write_str("1")?;
        }
        for (index, (factor, power)) in above.chain(below).enumerate() {
            f.write_str(if *power < 0 {
                "/"
            } else if index > 0 {
                "*"
            } else {
                ""
            })?;
            f.write_str(factor)?;
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

    fn term(text: &str) -> Term {
        text.parse().expect("a term")
    }

    #[test]
    fn terms_are_read_and_written_alike() {
        for text in ["1", "q", "alpha^2*q", "n^2/q", "1/q", "1/q^2/V_m_s"] {
            assert_eq!(term(text).to_string(), text);
        }
        assert_eq!(term("q ^ -2 * n").to_string(), "n/q^2");
        assert_eq!(term("q*q"), term("q^2"));
        assert_eq!(term("q/q"), Term::constant());
        for wrong in ["", "q^", "q^0", "q**a", "q*", "q^1.5", "2*q", "a b"] {
            assert!(wrong.parse::<Term>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_term_is_a_product_and_knows_its_slope() {
        let of = |name: &str| if name == "q" { 4.0 } else { 6.0 };
        assert_eq!(term("n^2/q").value(of), 9.0);
        assert_eq!(term("n^2/q").derivative("n", of), 3.0);
        assert_eq!(term("n^2/q").derivative("q", of), -2.25);
        assert_eq!(term("n").derivative("q", of), 0.0);
    }

    #[test]
    fn terms_up_to_an_order_are_as_many_as_combinations_with_repetition() {
        // n factors up to order k: (n + k)! / (n! k!)
        assert_eq!(Term::up_to_order(&["a", "b", "c"], 3).len(), 20);
        assert_eq!(Term::up_to_order(&["a", "b", "c", "d"], 2).len(), 15);
        let names: Vec<String> = Term::up_to_order(&["a", "b"], 2).iter().map(ToString::to_string).collect();
        assert_eq!(names, ["1", "a", "b", "a^2", "a*b", "b^2"]);
    }

    #[test]
    fn a_term_is_above_those_a_shift_of_origin_makes() {
        assert!(term("alpha^2*q").is_above(&term("alpha*q")));
        assert!(term("alpha^2*q").is_above(&Term::constant()));
        assert!(!term("alpha^2*q").is_above(&term("alpha^2*q")));
        assert!(!term("alpha^2*q").is_above(&term("q^2")));
        assert!(!term("n^2/q").is_above(&term("q")));
    }
}
