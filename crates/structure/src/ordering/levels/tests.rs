//! Orders of elimination.

use super::*;
use faer::sparse::SymbolicSparseColMat;

/// The pattern of a graph with both triangles.
fn pattern(n: usize, edges: &[[usize; 2]]) -> SymbolicSparseColMat<usize> {
    let mut columns = vec![Vec::new(); n];
    (0..n).for_each(|at| columns[at].push(at));
    for [a, b] in edges {
        columns[*a].push(*b);
        columns[*b].push(*a);
    }
    for rows in &mut columns {
        rows.sort_unstable();
    }
    let mut starts = vec![0];
    for rows in &columns {
        starts.push(starts[starts.len() - 1] + rows.len());
    }
    SymbolicSparseColMat::new_checked(n, n, starts, None, columns.concat())
}

/// How far apart in the order the ends of edges stand at most.
fn band(order: &[usize], edges: &[[usize; 2]]) -> usize {
    let place = |dof: usize| order.iter().position(|own| *own == dof).expect("every motion is in the order");
    edges.iter().map(|[a, b]| place(*a).abs_diff(place(*b))).max().unwrap_or(0)
}

#[test]
fn chains_are_ordered_from_end_to_end_whatever_their_numbers() {
    // Two chains and a loose one: 3-7-0-5-1 and 2-6-4; 8.
    let edges = [[3, 7], [7, 0], [0, 5], [5, 1], [2, 6], [6, 4]];
    let pattern = pattern(9, &edges);
    let order = reverse_cuthill_mckee(pattern.as_ref());
    let mut all = order.clone();
    all.sort_unstable();
    assert_eq!(all, (0..9).collect::<Vec<_>>());
    assert_eq!(band(&order, &edges), 1, "{order:?}");
    // Reversed: the part of the highest first number comes first.
    assert_eq!(order[0], 8);
}

/// A ladder of rungs of two in a row: a band of two, from one end to the other (Cuthill and McKee 1969).
#[test]
fn a_ladder_has_a_band_of_two_and_starts_at_an_end() {
    let number = |at: usize| (5 * at + 3) % 16;
    let rung = |at: usize| [number(2 * at), number(2 * at + 1)];
    let mut edges: Vec<[usize; 2]> = (0..8).map(rung).collect();
    for at in 0..7 {
        let ([a, b], [c, d]) = (rung(at), rung(at + 1));
        edges.extend([[a, c], [b, d]]);
    }
    let pattern = pattern(16, &edges);
    let order = reverse_cuthill_mckee(pattern.as_ref());
    assert_eq!(band(&order, &edges), 2, "{order:?}");
    let ends = [rung(0), rung(7)].concat();
    assert!(ends.contains(&order[0]) && ends.contains(&order[15]), "{order:?}");
}

#[test]
fn levels_are_those_of_a_walk_outwards() {
    // 0 in the middle of 1, 2 and 3; 4 and 5 beyond 3.
    let pattern = pattern(6, &[[0, 1], [0, 2], [0, 3], [3, 4], [3, 5]]);
    let degree = [4, 2, 2, 4, 2, 2];
    let (order, last, depth) = levels(pattern.as_ref(), &degree, 0);
    assert_eq!((order, last, depth), (vec![0, 1, 2, 3, 4, 5], 4, 2));
    let (order, last, depth) = levels(pattern.as_ref(), &degree, 1);
    assert_eq!((order, last, depth), (vec![1, 0, 2, 3, 4, 5], 4, 3));
    assert_eq!(
        far_end(pattern.as_ref(), &degree, 0),
        1,
        "three steps away from 4, and one of the least joined"
    );
}
