//! Three searches for the best set of each size: Morelli's ranking of orthogonalised candidates, stepwise with steps back,
//! and all subsets by branch and bound. Each gives one set for every size that is possible.

use super::reduced::{Reduced, Set};

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

/// Sets whose members were dropped one by one, at most; beyond it the search of all subsets ends early.
const MOST_SETS: usize = 1_000_000;

/// All subsets, by branch and bound (after Furnival and Wilson, Technometrics 16 (1974)): from all candidates downwards,
/// each set once. A set's subsets are not looked at if its own residual is above the best of every size they can have. The
/// flag says if the search was complete.
pub(crate) fn best_subsets(problem: &Reduced) -> (BySize, bool) {
    let mut search = Search { problem, order: order(problem), found: stepwise(problem), sets: 0 };
    let all = problem.all();
    record(&mut search.found, Found { set: all, sum: problem.drops(all).sum });
    search.below(all, 0);
    (search.found, search.sets <= MOST_SETS)
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
    order: Vec<usize>,
    found: BySize,
    sets: usize,
}

impl Search<'_> {
    /// Looks at the sets that leave out of `set` only candidates from `start` of the order on.
    fn below(&mut self, set: Set, start: usize) {
        self.sets += 1;
        if self.sets > MOST_SETS {
            return;
        }
        let drops = self.problem.drops(set);
        for position in start..self.order.len() {
            let member = self.order[position];
            let Some((_, growth)) = drops.growth.iter().find(|(known, _)| *known == member) else { continue };
            let without = Found { set: set & !(1 << member), sum: drops.sum + growth };
            record(&mut self.found, without);
            if self.is_worth_a_look(without, position + 1) {
                self.below(without.set, position + 1);
            }
        }
    }

    fn is_worth_a_look(&self, from: Found, start: usize) -> bool {
        let size = from.set.count_ones() as usize;
        let later = self.order[start..].iter().filter(|k| from.set >> **k & 1 == 1).count();
        self.found[size - later..size].iter().any(|best| best.is_none_or(|best| from.sum < best.sum))
    }
}
