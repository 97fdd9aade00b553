//! Two-level factorials: all combinations in standard order (the first factor changes fastest), and fractions whose
//! further factors are products of the basic ones, with what cannot be told apart then (Box and Hunter, Technometrics 3
//! (1961)).

use super::Design;
use crate::fault::Fault;
use crate::term::Term;

/// Most factors of a full factorial.
const MOST_FACTORS: usize = 20;

/// All combinations of -1 and +1.
///
/// # Errors
/// If a name cannot be used, or there are no factors or more than 20.
pub fn full_factorial(factors: &[&str]) -> Result<Design, Fault> {
    if factors.is_empty() || factors.len() > MOST_FACTORS {
        return Err(Fault::Design { why: format!("{} factors; 1 to 20 are possible", factors.len()) });
    }
    let level = |run: usize, factor: usize| if run >> factor & 1 == 1 { 1.0 } else { -1.0 };
    let point = |run: usize| (0..factors.len()).map(|factor| level(run, factor)).collect();
    Design::new(factors, (0..1 << factors.len()).map(point).collect())
}

/// What a further factor is set to: a product of basic factors, or its opposite.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Generator {
    /// The further factor.
    pub factor: String,
    /// The product.
    pub product: Term,
    /// Set to the opposite of the product.
    pub opposite: bool,
}

impl Generator {
    /// Reads `d = a*b*c` or `d = -a*b*c`.
    ///
    /// # Errors
    /// If it is not of this form.
    pub fn parse(text: &str) -> Result<Self, Fault> {
        let form = || Fault::Design { why: format!("the generator `{text}` is not like `d = a*b*c`") };
        let (factor, product) = text.split_once('=').ok_or_else(form)?;
        let product = product.trim();
        let (opposite, product) = product.strip_prefix('-').map_or((false, product), |rest| (true, rest));
        let product: Term = product.trim().parse()?;
        if product.is_constant() || product.powers().any(|(_, power)| power != 1) {
            return Err(form());
        }
        Ok(Self { factor: factor.trim().to_string(), product, opposite })
    }
}

/// A fraction of a factorial.
#[derive(Debug, Clone, PartialEq)]
pub struct Fraction {
    /// The points.
    pub design: Design,
    /// Products that are 1 at all points (or -1 where the flag is set): the defining relation.
    pub words: Vec<(Term, bool)>,
}

/// The fraction that basic factors and generators make.
///
/// # Errors
/// If a name cannot be used, or a generator has a factor that is not a basic one.
pub fn fractional_factorial(basic: &[&str], generators: &[Generator]) -> Result<Fraction, Fault> {
    let base = full_factorial(basic)?;
    let mut points = base.points.clone();
    let mut names = basic.to_vec();
    for generator in generators {
        let sign = if generator.opposite { -1.0 } else { 1.0 };
        for (point, value) in points.iter_mut().zip(base.column(&generator.product)?) {
            point.push(sign * value);
        }
        names.push(&generator.factor);
    }
    let design = Design::new(&names, points)?;
    let mut words: Vec<(Term, bool)> = Vec::new();
    for generator in generators {
        let own =
            (times(&Term::new([(generator.factor.as_str(), 1)]), &generator.product), generator.opposite);
        let more: Vec<(Term, bool)> =
            words.iter().map(|(word, sign)| (times(word, &own.0), *sign != own.1)).collect();
        words.push(own);
        words.extend(more);
    }
    Ok(Fraction { design, words })
}

/// The product of two products of two-level factors: squares are 1.
fn times(one: &Term, other: &Term) -> Term {
    let powers: Vec<(&str, i32)> = one.powers().chain(other.powers()).collect();
    let once = |name: &str| powers.iter().filter(|(known, _)| *known == name).count() % 2 == 1;
    Term::new(powers.iter().filter(|(name, _)| once(name)).copied())
}

impl Fraction {
    /// Length of the shortest word: at III main effects are not confused with each other, at IV not with interactions of two
    /// factors, at V those not with each other. `None` for a full factorial.
    pub fn resolution(&self) -> Option<u32> {
        self.words.iter().map(|(word, _)| word.order()).min()
    }

    /// The products that cannot be told from a given one, with a flag if their effect enters with the other sign.
    pub fn aliases(&self, term: &Term) -> Vec<(Term, bool)> {
        self.words.iter().map(|(word, sign)| (times(term, word), *sign)).collect()
    }
}
