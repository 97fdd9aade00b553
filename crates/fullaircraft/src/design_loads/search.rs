//! The search for worst gradients between those of a family of gusts: where parabolas through three gradients say that a load is
//! largest, one more is flown, and its instants are kept that raise an end.

use crate::design_loads::instants::{FlownCase, FlownInstant};
use crate::flight::gust::{Gust, GustAxis};
use crate::stations::nodal::Component;
use loads::design::Direction;
use loads::matrix::{Action, Case};
use loads::rules::discrete::rescaled;
use loads::tuning::worst;

/// Gradients this close are flown once: the top of a load over the gradient is flat.
const ALIKE: f64 = 1.05;

/// What flies gusts, each with the number of its case: what came of them, with their gradients, m.
pub(super) type Fly<'f, E> = dyn FnMut(&[(usize, Gust)]) -> Result<Vec<(FlownCase, f64)>, E> + 'f;

/// Flies the gradients of a family and those where a load between them is largest: these become instants of the nearest case.
///
/// # Errors
/// Those of what flies.
pub(super) fn searched<E>(
    cases: &[&Case],
    axis: GustAxis,
    fly: &mut Fly<'_, E>,
) -> Result<Vec<FlownCase>, E> {
    let of = |number: usize, gradient_m: Option<f64>| {
        let case = cases.iter().find(|case| case.number == number)?;
        Some((number, gust(case, gradient_m)?))
    };
    let given: Vec<(usize, Gust)> = cases.iter().filter_map(|case| of(case.number, None)).collect();
    let mut given = fly(&given)?;
    given.sort_by_key(|(flown, _)| flown.number);
    let (given, gradients_m): (Vec<FlownCase>, Vec<f64>) = given.into_iter().unzip();
    if given.iter().any(|flown| flown.refused.is_some()) {
        return Ok(given);
    }
    let family = Family::new(gradients_m, given, axis);
    let next = family.next_m();
    let between: Vec<(usize, Gust)> =
        next.into_iter().filter_map(|next_m| of(family.nearest(next_m)?, Some(next_m))).collect();
    let found = fly(&between)?.into_iter().flat_map(|(flown, gradient_m)| {
        let number = flown.number;
        let one = move |instant| (number, FlownInstant { gradient_m: Some(gradient_m), ..instant });
        flown.instants.into_iter().map(one)
    });
    Ok(family.with(found.collect()))
}

/// Gradients of a family, m, in rising order, and their cases.
struct Family {
    gradients_m: Vec<f64>,
    cases: Vec<FlownCase>,
    /// Loads whose worst gradients are searched for.
    loads: Vec<usize>,
}

/// An end of a load: station, load, sign.
type End = (usize, usize, f64);

impl Family {
    /// Of cases with their gradients.
    fn new(gradients_m: Vec<f64>, cases: Vec<FlownCase>, axis: GustAxis) -> Self {
        let mut both: Vec<(f64, FlownCase)> = gradients_m.into_iter().zip(cases).collect();
        both.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (gradients_m, cases) = both.into_iter().unzip();
        let alone = axis.along().into_iter().filter_map(|along| {
            let mut shares = (0..6).filter(|load| along.shares[*load] != 0.0);
            shares.next().filter(|_| shares.next().is_none())
        });
        Self { gradients_m, cases, loads: alone.collect() }
    }

    fn ends(&self) -> Vec<End> {
        let stations =
            self.cases.first().and_then(|case| case.instants.first()).map_or(0, |one| one.loads.len());
        let of =
            |station| self.loads.iter().flat_map(move |load| [(station, *load, 1.0), (station, *load, -1.0)]);
        (0..stations).flat_map(of).collect()
    }

    /// Gradients to fly next, m.
    fn next_m(&self) -> Vec<f64> {
        let next = |end: End| {
            let sizes: Vec<f64> = self.cases.iter().map(|case| largest(&case.instants, end)).collect();
            worst(&self.gradients_m, &sizes)?.next_m
        };
        let mut all: Vec<f64> = self.ends().into_iter().filter_map(next).collect();
        all.sort_by(f64::total_cmp);
        let mut groups: Vec<Vec<f64>> = Vec::new();
        for next_m in all {
            match groups.last_mut().filter(|group| next_m <= group[0] * ALIKE) {
                Some(group) => group.push(next_m),
                None => groups.push(vec![next_m]),
            }
        }
        groups.into_iter().map(|group| group[group.len() / 2]).collect()
    }

    /// Number of the case with the gradient nearest to one, m.
    fn nearest(&self, gradient_m: f64) -> Option<usize> {
        let away = |known: f64| (known / gradient_m).ln().abs();
        let places = 0..self.cases.len();
        let place =
            places.min_by(|a, b| away(self.gradients_m[*a]).total_cmp(&away(self.gradients_m[*b])))?;
        Some(self.cases[place].number)
    }

    /// The cases with those of the found instants that raise an end; each comes with its case's number.
    fn with(mut self, found: Vec<(usize, FlownInstant)>) -> Vec<FlownCase> {
        let mut kept = vec![false; found.len()];
        for end in self.ends() {
            let known =
                self.cases.iter().map(|case| largest(&case.instants, end)).fold(f64::NEG_INFINITY, f64::max);
            let best =
                (0..found.len()).max_by(|a, b| value(&found[*a].1, end).total_cmp(&value(&found[*b].1, end)));
            if let Some(best) = best.filter(|best| value(&found[*best].1, end) > known) {
                kept[best] = true;
            }
        }
        for ((number, instant), _) in found.into_iter().zip(kept).filter(|(_, kept)| *kept) {
            if let Some(case) = self.cases.iter_mut().find(|case| case.number == number) {
                case.instants.push(instant);
            }
        }
        self.cases
    }
}

/// The gust of a case, or of another gradient, m, in its place.
pub(super) fn gust(case: &Case, other_m: Option<f64>) -> Option<Gust> {
    let Action::Discrete { gradient_m, direction, u_ds_m_s, .. } = case.action else { return None };
    let sign = if direction == Direction::Down { -1.0 } else { 1.0 };
    let flown_m = other_m.unwrap_or(gradient_m);
    let velocity_m_s = sign * rescaled(u_ds_m_s, gradient_m, flown_m);
    Some(Gust { velocity_m_s, length_m: 2.0 * flown_m, start_s: 0.0 })
}

/// A net load towards an end.
fn value(instant: &FlownInstant, (station, load, sign): End) -> f64 {
    sign * instant.loads[station][Component::ALL.len() - 1][load]
}

fn largest(instants: &[FlownInstant], end: End) -> f64 {
    instants.iter().map(|instant| value(instant, end)).fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
pub(crate) mod tests;
