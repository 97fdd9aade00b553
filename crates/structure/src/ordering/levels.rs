//! Order by the levels of a breadth-first search (reverse Cuthill-McKee). George and Liu, *Computer Solution of Large Sparse
//! Positive Definite Systems*, ch. 4.

use faer::sparse::SymbolicSparseColMatRef;

/// How often a start further away is looked for.
const SEARCHES: usize = 8;

/// Reverse Cuthill-McKee order of a symmetric pattern with both triangles: the degree of freedom to be eliminated at
/// each place.
pub(crate) fn reverse_cuthill_mckee(pattern: SymbolicSparseColMatRef<'_, usize>) -> Vec<usize> {
    let n = pattern.ncols();
    let degree: Vec<usize> = (0..n).map(|j| pattern.row_idx_of_col_raw(j).len()).collect();
    let mut order = Vec::with_capacity(n);
    let mut seen = vec![false; n];
    for first in 0..n {
        if seen[first] {
            continue;
        }
        let start = far_end(pattern, &degree, first);
        let component = levels(pattern, &degree, start).0;
        for at in &component {
            seen[*at] = true;
        }
        order.extend(component);
    }
    order.reverse();
    order
}

/// A node from which the component is long: the least connected one of the last level, as long as that makes it longer.
fn far_end(pattern: SymbolicSparseColMatRef<'_, usize>, degree: &[usize], first: usize) -> usize {
    let (mut start, mut depth) = (first, 0);
    for _ in 0..SEARCHES {
        let (order, last_level, reached) = levels(pattern, degree, start);
        if reached <= depth {
            break;
        }
        depth = reached;
        start = order[last_level..].iter().copied().min_by_key(|at| degree[*at]).unwrap_or(start);
    }
    start
}

/// Breadth-first order from a start, neighbours by ascending degree; where its last level begins, and the number of levels.
fn levels(
    pattern: SymbolicSparseColMatRef<'_, usize>,
    degree: &[usize],
    start: usize,
) -> (Vec<usize>, usize, usize) {
    let mut seen = vec![false; pattern.ncols()];
    let mut order = vec![start];
    seen[start] = true;
    let (mut level, mut depth) = (0, 0);
    loop {
        let end = order.len();
        for at in level..end {
            let from = order.len();
            let neighbours = pattern.row_idx_of_col_raw(order[at]).iter().copied();
            for neighbour in neighbours {
                if !seen[neighbour] {
                    seen[neighbour] = true;
                    order.push(neighbour);
                }
            }
            order[from..].sort_by_key(|at| degree[*at]);
        }
        if order.len() == end {
            return (order, level, depth);
        }
        level = end;
        depth += 1;
    }
}

#[cfg(test)]
mod tests;
