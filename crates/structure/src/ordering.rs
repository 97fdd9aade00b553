//! The order of elimination that fills in least, of three.
//!
//! A wing is long: from station to station it couples to its neighbours only, and a band as wide as one station fills in
//! less than what minimum degree (AMD) finds (5 million entries instead of 14 for 3000 grids). Large solid bodies fill in
//! least by nested dissection (METIS), plates by minimum degree. Which it is for a structure is counted.
//!
//! Motions with the same neighbours, as those of a grid, are eliminated one after the other in each of these orders; the graph has
//! one node for all of them.

pub(crate) mod levels;

use faer::Side;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SymbolicSparseColMat, SymbolicSparseColMatRef};
use feral_metis::CscPattern;
use std::ops::Range;

type PatternRef<'a> = SymbolicSparseColMatRef<'a, usize>;

/// The degree of freedom of a symmetric pattern with both triangles to be eliminated at each place.
pub(crate) fn of_least_fill(pattern: PatternRef<'_>) -> Vec<usize> {
    let groups = alike(pattern);
    let graph = graph(pattern, &groups);
    let graph = graph.as_ref();
    let with_fill = |name: &'static str, order: Vec<usize>| {
        let inverse = inverse(&order);
        let custom = SymmetricOrdering::Custom(PermRef::new_checked(&order, &inverse, order.len()));
        let fill = counted(graph, custom).len_val();
        (name, order, fill)
    };
    let ((by_degree, levels), dissected) = rayon::join(
        || {
            let levels = || with_fill("levels", levels::reverse_cuthill_mckee(graph));
            rayon::join(|| counted(graph, SymmetricOrdering::Amd), levels)
        },
        || with_fill("dissection", dissection(graph)),
    );
    let mut least = by_degree.len_val();
    let mut order =
        by_degree.perm().map_or_else(|| (0..groups.len()).collect(), |perm| perm.arrays().0.to_vec());
    for (name, other, fill) in [levels, dissected] {
        tracing::debug!(by_degree = by_degree.len_val(), fill, name, "entries of the factor, by grids");
        if fill < least {
            (least, order) = (fill, other);
        }
    }
    order.into_iter().flat_map(|group| groups[group].clone()).collect()
}

/// The place of each degree of freedom in an order.
pub(crate) fn inverse(order: &[usize]) -> Vec<usize> {
    let mut inverse = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, dof)| inverse[*dof] = place);
    inverse
}

/// Runs of columns with the same rows.
fn alike(pattern: PatternRef<'_>) -> Vec<Range<usize>> {
    let mut groups: Vec<Range<usize>> = Vec::new();
    for j in 0..pattern.ncols() {
        match groups.last_mut() {
            Some(group) if pattern.row_idx_of_col_raw(group.start) == pattern.row_idx_of_col_raw(j) => {
                group.end = j + 1;
            }
            _ => groups.push(j..j + 1),
        }
    }
    groups
}

/// The pattern with one row and column for each group.
fn graph(pattern: PatternRef<'_>, groups: &[Range<usize>]) -> SymbolicSparseColMat<usize> {
    let mut group_of = vec![0; pattern.ncols()];
    groups.iter().enumerate().for_each(|(at, group)| group_of[group.clone()].fill(at));
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for group in groups {
        let start = rows.len();
        // A group's rows are whole groups: its columns have the same rows, and the pattern is symmetric.
        for row in pattern.row_idx_of_col_raw(group.start) {
            if rows.len() == start || rows[rows.len() - 1] != group_of[*row] {
                rows.push(group_of[*row]);
            }
        }
        columns.push(rows.len());
    }
    SymbolicSparseColMat::new_checked(groups.len(), groups.len(), columns, None, rows)
}

/// The pattern of the factor of a graph, entry by entry.
fn counted(graph: PatternRef<'_>, order: SymmetricOrdering<'_, usize>) -> SymbolicCholesky<usize> {
    let params = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
        ..Default::default()
    };
    factorize_symbolic_cholesky(graph, Side::Lower, order, params)
        .expect("memory for the pattern of the factor")
}

/// Nested dissection by METIS' method.
///
/// # Panics
/// If the graph has more entries than 32 bits can count, 16 GB of them.
fn dissection(graph: PatternRef<'_>) -> Vec<usize> {
    let narrow =
        |at: usize| i32::try_from(at).expect("a graph of grids has fewer than two thousand million entries");
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for j in 0..graph.ncols() {
        rows.extend(graph.row_idx_of_col_raw(j).iter().filter(|row| **row != j).map(|row| narrow(*row)));
        columns.push(narrow(rows.len()));
    }
    let pattern = CscPattern::new(graph.ncols(), &columns, &rows).expect("rows and columns of a matrix");
    let order = feral_metis::metis_order(&pattern).expect("a symmetric pattern can be dissected");
    order.into_iter().map(|at| usize::try_from(at).expect("places are not negative")).collect()
}

#[cfg(test)]
mod tests;
