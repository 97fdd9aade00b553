//! Three searches for the best set of each size: Morelli's ranking of orthogonalised candidates, stepwise with steps back,
//! and all subsets by branch and bound. Each gives one set for every size that is possible.

use super::reduced::{Reduced, Set, members};

/// The best set found of one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) set: Set,
    /// Its residual sum of squares.
    pub(crate) sum: f64,
}

/// Best sets by size; index 0 is the empty set.
pub(crate) type BySize = Vec<Option<Found>>;

fn largest(values: &[(usize, f64)]) -> Option<(usize, f64)> {
    values.iter().copied().reduce(|best, next| if next.1 > best.1 { next } else { best })
}

fn smallest(values: &[(usize, f64)]) -> Option<(usize, f64)> {
    values.iter().copied().reduce(|best, next| if next.1 < best.1 { next } else { best })
}

/// Morelli's ranking: each time the candidate whose part orthogonal to those already in takes most off the residual.
pub(crate) fn ranked(problem: &Reduced) -> BySize {
    let mut set = 0;
    let mut found = vec![Some(Found { set, sum: problem.drops(set).sum })];
    while let Some((best, _)) = largest(&problem.gains(set)) {
        set |= 1 << best;
        found.push(Some(Found { set, sum: problem.drops(set).sum }));
    }
    found.resize(problem.count() + 1, None);
    found
}

/// Stepwise: the best candidate joins, then members leave as long as what is left is better than the best set of its size
/// so far (floating search, Pudil, Novovicova and Kittler, Pattern Recognit. Lett. 15 (1994)).
pub(crate) fn stepwise(problem: &Reduced) -> BySize {
    let mut found: BySize = vec![None; problem.count() + 1];
    let mut set: Set = 0;
    found[0] = Some(Found { set, sum: problem.drops(set).sum });
    while let Some((best, _)) = largest(&problem.gains(set)) {
        set |= 1 << best;
        let mut drops = problem.drops(set);
        record(&mut found, Found { set, sum: drops.sum });
        while let Some((worst, growth)) = smallest(&drops.growth) {
            let without = Found { set: set & !(1 << worst), sum: drops.sum + growth };
            if !record(&mut found, without) {
                break;
            }
            set = without.set;
            drops = problem.drops(set);
        }
        // go on from the best of this size, which may have been found on another way
        if let Some(Some(best)) = found.get(set.count_ones() as usize) {
            set = best.set;
        }
    }
    found
}

/// Keeps what is better than the best of its size, by more than rounding.
fn record(found: &mut BySize, new: Found) -> bool {
    let best = &mut found[new.set.count_ones() as usize];
    let better = best.is_none_or(|best| new.sum < best.sum * (1.0 - 1e-12));
    if better {
        *best = Some(new);
    }
    better
}

/// Work of a search in sets times the cube of their candidates, at most; beyond it the search ends early. About ten seconds
/// for the lowest predicted squared error, one for the rest of the curve.
const MOST_WORK: [f64; 2] = [4e9, 4e8];

/// Best sets of all sizes, and how far that is certain.
pub(crate) struct Subsets {
    pub(crate) found: BySize,
    /// No other set has a lower predicted squared error.
    pub(crate) lowest_is_certain: bool,
    /// No other set of any size has a lower residual sum.
    pub(crate) all_are_certain: bool,
}

/// All subsets, by branch and bound (after Furnival and Wilson, Technometrics 16 (1974)): from all candidates downwards,
/// each set once. A set's subsets are not looked at if none can be better: the residual sum of a subset is not below its own,
/// and a subset has what must stay. First for the lowest residual sum plus `penalty` a term, then for the best set of
/// every size.
pub(crate) fn best_subsets(problem: &Reduced, penalty: f64) -> Subsets {
    let mut found = stepwise(problem);
    let all = problem.all();
    record(&mut found, Found { set: all, sum: problem.drops(all).sum });
    let order = order(problem);
    let cube = (problem.count().max(1) as f64).powi(3);
    let mut certain = [false; 2];
    for (k, penalty) in [Some(penalty), None].into_iter().enumerate() {
        let mut search = Search { problem, order: &order, found, penalty, left: MOST_WORK[k] / cube };
        search.below(all, 0);
        certain[k] = search.left >= 0.0;
        found = search.found;
    }
    Subsets { found, lowest_is_certain: certain[0] || certain[1], all_are_certain: certain[1] }
}

/// Candidates in the order of leaving: those that others need after these, and else strong ones first, as their many
/// followers are then cut off soonest.
fn order(problem: &Reduced) -> Vec<usize> {
    let (mut left, mut order) = (problem.all(), Vec::new());
    while left != 0 {
        let drops = problem.drops(left);
        // never empty: a term of the highest order left has none above it
        let mut growth = drops.growth;
        growth.sort_by(|a, b| b.1.total_cmp(&a.1));
        for (member, _) in growth {
            left &= !(1 << member);
            order.push(member);
        }
    }
    order
}

struct Search<'a> {
    problem: &'a Reduced,
    order: &'a [usize],
    found: BySize,
    /// What a term costs; none if the best set of every size is looked for.
    penalty: Option<f64>,
    /// Sets that may still be looked at.
    left: f64,
}

impl Search<'_> {
    /// Looks at the sets that leave out of `set` only candidates from `start` of the order on.
    fn below(&mut self, set: Set, start: usize) {
        self.left -= 1.0;
        if self.left < 0.0 {
            return;
        }
        let drops = self.problem.drops(set);
        for position in start..self.order.len() {
            // those before the position stay from here on
            if !self.is_worth_a_look(Found { set, sum: drops.sum }, position) {
                return;
            }
            let member = self.order[position];
            let Some((_, growth)) = drops.growth.iter().find(|(known, _)| *known == member) else { continue };
            let without = Found { set: set & !(1 << member), sum: drops.sum + growth };
            record(&mut self.found, without);
            if self.is_worth_a_look(without, position + 1) {
                self.below(without.set, position + 1);
            }
        }
    }

    /// False if no subset that leaves out candidates from `start` on can be better than what was found.
    fn is_worth_a_look(&self, from: Found, start: usize) -> bool {
        let later: Set = self.order[start..].iter().map(|k| 1 << k).sum();
        let stays =
            members(from.set & !later).fold(0, |stays: Set, k| stays | 1 << k | self.problem.needs(k));
        let (least, most) = (stays.count_ones() as usize, from.set.count_ones() as usize);
        match self.penalty {
            Some(penalty) => {
                let cost = |found: &Found| found.sum + penalty * f64::from(found.set.count_ones());
                let lowest = self.found.iter().flatten().map(cost).fold(f64::INFINITY, f64::min);
                from.sum + penalty * (least as f64) < lowest
            }
            None => self.found[least..most].iter().any(|best| best.is_none_or(|best| from.sum < best.sum)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::columns::Columns;
    use crate::data::Data;
    use crate::term::Term;

    /// A response of a few terms with a scatter that no polynomial follows.
    fn problem(shift: f64, hierarchical: bool) -> Reduced {
        let x: Vec<f64> = (0..30).map(|i| f64::from(i % 6)).collect();
        let z: Vec<f64> = (0..30).map(|i| f64::from(i / 6) - 1.0).collect();
        let scatter = |i: usize| (37.0 * i as f64 + shift).sin();
        let y: Vec<f64> =
            (0..30).map(|i| x[i] - 0.3 * x[i] * z[i] + 0.1 * z[i].powi(3) + scatter(i)).collect();
        let data = Data::new().factor("x", x).and_then(|data| data.factor("z", z)).expect("data");
        let terms = Term::up_to_order(&["x", "z"], 3);
        let columns = |terms: &[Term]| Columns::of_terms(&data, terms).expect("columns");
        Reduced::new(&columns(&terms[..1]), &columns(&terms[1..]), &terms[1..], &y, hierarchical)
            .expect("a problem")
    }

    #[test]
    fn the_lowest_penalised_sum_is_found_as_by_trying_all() {
        let (mut looked_at, mut tried) = (0.0, 0.0);
        for case in 0..40 {
            let (hierarchical, penalty) = (case % 2 == 0, 0.2 + 0.1 * f64::from(case % 9));
            let problem = problem(f64::from(case), hierarchical);
            let allowed = |set: &Set| members(*set).all(|k| problem.needs(k) & !set == 0);
            let cost = |set: Set, sum: f64| sum + penalty * f64::from(set.count_ones());
            let all = (0..=problem.all()).filter(allowed).map(|set| cost(set, problem.drops(set).sum));
            let want = all.fold(f64::INFINITY, f64::min);
            tried += (0..=problem.all()).filter(allowed).count() as f64;
            let order = order(&problem);
            // from nothing but the full set, so that the search itself has to find it
            let mut found: BySize = vec![None; problem.count() + 1];
            let full = problem.all();
            record(&mut found, Found { set: full, sum: problem.drops(full).sum });
            let mut search =
                Search { problem: &problem, order: &order, found, penalty: Some(penalty), left: 1e9 };
            search.below(full, 0);
            let got = search
                .found
                .iter()
                .flatten()
                .map(|found| cost(found.set, found.sum))
                .fold(f64::INFINITY, f64::min);
            assert!((got - want).abs() < 1e-9 * want, "{case}: {got} instead of {want}");
            looked_at += 1e9 - search.left;
        }
        println!("{looked_at} of {tried} sets were looked at");
        assert!(looked_at < 0.5 * tried, "the bound leaves {looked_at} of {tried} sets");
    }

    #[test]
    fn the_best_set_of_every_size_is_found_as_by_trying_all_and_most_are_never_looked_at() {
        let (mut looked_at, mut tried) = (0.0, 0.0);
        for case in 0..40 {
            let problem = problem(f64::from(case), case % 2 == 0);
            let allowed = |set: &Set| members(*set).all(|k| problem.needs(k) & !set == 0);
            let mut want = vec![f64::INFINITY; problem.count() + 1];
            for set in (0..=problem.all()).filter(allowed) {
                let best = &mut want[set.count_ones() as usize];
                *best = best.min(problem.drops(set).sum);
                tried += 1.0;
            }
            let full = problem.all();
            let mut found: BySize = vec![None; problem.count() + 1];
            record(&mut found, Found { set: full, sum: problem.drops(full).sum });
            let order = order(&problem);
            let mut search = Search { problem: &problem, order: &order, found, penalty: None, left: 1e9 };
            search.below(full, 0);
            for (size, (got, want)) in search.found.iter().zip(&want).enumerate() {
                let got = got.expect("every size is possible").sum;
                assert!((got - want).abs() < 1e-9 * want, "{case}, {size} terms: {got} instead of {want}");
            }
            looked_at += 1e9 - search.left;
            // and with what stepwise finds to begin with, which is what a choice does
            let all = best_subsets(&problem, 0.5);
            assert!(all.lowest_is_certain && all.all_are_certain);
            for (size, (got, want)) in all.found.iter().zip(&want).enumerate() {
                let got = got.expect("every size is possible").sum;
                assert!(
                    (got - want).abs() < 1e-9 * want,
                    "{case}, {size} terms of all: {got} instead of {want}"
                );
            }
        }
        println!("{looked_at} of {tried} sets were looked at");
        assert!(looked_at < 0.5 * tried, "the bound leaves {looked_at} of {tried} sets");
    }
}
