//! Effects of two-level factors and their interactions: how much the response changes from low to high, averaged over the
//! other factors. In coded units (-1, +1) that is twice the coefficient. Replicates give t tests; blocks are taken out.

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::design::detectable_noncentrality;
use crate::distributions::{probability, two_sided_t};
use crate::f_test::FTest;
use crate::fault::Fault;
use crate::lenth::Lenth;
use crate::qr::{dot, residuals};
use crate::term::Term;

/// The t test of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EffectTest {
    /// Standard error of the effect, unit of the response.
    pub standard_error: f64,
    /// Effect over standard error.
    pub t: f64,
    /// Probability of a |t| as large by chance.
    pub p_value: f64,
    /// True if that is below one minus the level: the null hypothesis is rejected.
    pub significant: bool,
}

/// An effect.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    /// The factor or interaction.
    pub term: Term,
    /// What these points do not tell from it; the flag is set if it enters with the other sign.
    pub aliases: Vec<(Term, bool)>,
    /// Mean at high minus mean at low, unit of the response.
    pub value: f64,
    /// What the residual sum would grow by without it.
    pub sum_of_squares: f64,
    /// `None` if no degree of freedom is left for the error.
    pub test: Option<EffectTest>,
}

/// The effects of an experiment.
#[derive(Debug, Clone, PartialEq)]
pub struct Effects {
    /// Name of the response.
    pub response: String,
    /// Mean of the response (of the two-level points with equal weight).
    pub mean: f64,
    /// The effects: main effects first, then interactions by order.
    pub effects: Vec<Effect>,
    /// Degrees of freedom of the error; 0 if there is none.
    pub degrees_of_freedom: f64,
    /// Sum of squares of the error.
    pub residual_sum: f64,
    /// Degrees of freedom of the offsets of blocks; 0 if they are not taken out.
    pub block_degrees_of_freedom: f64,
    /// What the offsets of blocks take off the sum of squares.
    pub block_sum: f64,
    /// Lenth's margins; `None` for fewer than 3 effects.
    pub lenth: Option<Lenth>,
}

impl Effects {
    /// F test of the offsets of blocks against the error; none without them or without an error.
    pub fn block_test(&self) -> Option<FTest> {
        let (above, below) = (self.block_degrees_of_freedom, self.degrees_of_freedom);
        (above > 0.0 && below > 0.0).then(|| FTest::new(self.block_sum, above, self.residual_sum, below))
    }

    /// The effect (same unit) that a test like this one finds with the given probability.
    ///
    /// # Errors
    /// As [`detectable_noncentrality`].
    pub fn detectable(&self, test: &EffectTest, level: f64, wanted: f64) -> Result<f64, Fault> {
        Ok(test.standard_error * detectable_noncentrality(self.degrees_of_freedom, level, wanted)?)
    }
}

/// Effects of the given two-level factors up to interactions of `order` factors. What a fraction cannot tell apart is
/// listed with the first of it. With [`Blocking::Fixed`] offsets of blocks are taken out, and what they are confounded with is
/// refused.
///
/// # Errors
/// If a factor is not in the data or has not two values, effects are partly aliased or with blocks, there are more effects
/// than points, or the level is not between 0 and 1. For random blocks: in a blocked factorial they do not change effects.
pub fn effects(
    data: &Data,
    response: &str,
    factors: &[&str],
    order: u32,
    (blocking, level): (Blocking, f64),
) -> Result<Effects, Fault> {
    probability("the level", level)?;
    if blocking == Blocking::Random {
        let name = data.blocks().first().map_or(String::new(), |blocks| blocks.name.clone());
        return Err(Fault::Block { name, why: "effects are computed with fixed blocks".into() });
    }
    let y = data.response_values(response)?;
    let (plain, terms) = coded(data, factors, order)?;
    let blocks = if blocking == Blocking::Fixed { data.blocks() } else { &[] };
    let columns = plain.clone().with_blocks(blocks);
    let block_degrees_of_freedom = (columns.len() - plain.len()) as f64;
    let qr = columns.orthogonalised()?;
    let solution = qr.solve(&columns.values, y);
    let rest = residuals(&columns.values, &solution, y);
    let degrees_of_freedom = (y.len() - columns.len()) as f64;
    let residual_sum = dot(&rest, &rest);
    let without = plain.orthogonalised()?.remainder(y).0;
    let block_sum = if block_degrees_of_freedom > 0.0 { dot(&without, &without) - residual_sum } else { 0.0 };
    let effect = |(k, (term, aliases)): (usize, (Term, Vec<(Term, bool)>))| {
        let (coefficient, share) = (solution[k + 1], qr.leverage_of(k + 1));
        let standard_error = 2.0 * (residual_sum / degrees_of_freedom * share).sqrt();
        let t = 2.0 * coefficient / standard_error;
        let p_value = two_sided_t(t, degrees_of_freedom);
        let test = EffectTest { standard_error, t, p_value, significant: p_value < 1.0 - level };
        Effect {
            term,
            aliases,
            value: 2.0 * coefficient,
            sum_of_squares: coefficient * coefficient / share,
            test: (degrees_of_freedom > 0.0).then_some(test),
        }
    };
    let effects: Vec<Effect> = terms.into_iter().enumerate().map(effect).collect();
    let values: Vec<f64> = effects.iter().map(|effect| effect.value).collect();
    Ok(Effects {
        response: response.to_string(),
        mean: solution[0],
        effects,
        degrees_of_freedom,
        residual_sum,
        block_degrees_of_freedom,
        block_sum,
        lenth: Lenth::of(&values, level).ok(),
    })
}

type Aliased = (Term, Vec<(Term, bool)>);

/// The constant's column and one for each effect that the points tell from those before it.
fn coded(data: &Data, factors: &[&str], order: u32) -> Result<(Columns, Vec<Aliased>), Fault> {
    let mut levels = Data::new();
    for name in factors {
        levels = levels.factor(name, coded_factor(name, data.factor_values(name)?)?)?;
    }
    let mut columns = Columns::of_terms(&levels, &[Term::constant()])?;
    let mut terms: Vec<Aliased> = Vec::new();
    let once = |term: &Term| term.powers().all(|(_, power)| power == 1) && !term.is_constant();
    for term in Term::up_to_order(factors, order).into_iter().filter(once) {
        let column = levels.column(&term)?;
        let same = |sign: f64| {
            columns.values.iter().position(|known| known.iter().zip(&column).all(|(a, b)| *a == sign * b))
        };
        match same(1.0).map(|at| (at, false)).or_else(|| same(-1.0).map(|at| (at, true))) {
            // a word of the defining relation: no effect of its own
            Some((0, _)) => {}
            Some((at, opposite)) => terms[at - 1].1.push((term, opposite)),
            None => {
                columns.names.push(term.to_string());
                columns.values.push(column);
                terms.push((term, Vec::new()));
            }
        }
    }
    Ok((columns, terms))
}

fn coded_factor(name: &str, values: &[f64]) -> Result<Vec<f64>, Fault> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if let Some(other) = values.iter().find(|value| **value != low && **value != high) {
        let why = format!("the factor `{name}` is not at two levels: {low}, {other} and {high} at least");
        return Err(Fault::Design { why });
    }
    Ok(values.iter().map(|value| if *value == low { -1.0 } else { 1.0 }).collect())
}
