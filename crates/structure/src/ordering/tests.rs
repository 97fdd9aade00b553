//! Orders of elimination beside each other.

use super::*;

/// Grids in a block with some motions each, joined to their neighbours along edges and diagonals.
fn block([long, wide, high]: [usize; 3], motions: usize) -> SymbolicSparseColMat<usize> {
    let near = |a: usize, end: usize| (a.saturating_sub(1)..=a + 1).filter(move |a| *a < end);
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for grid in 0..long * wide * high {
        let (i, j, k) = (grid / (wide * high), grid / high % wide, grid % high);
        let around: Vec<usize> = near(i, long)
            .flat_map(|i| {
                near(j, wide).flat_map(move |j| near(k, high).map(move |k| (i * wide + j) * high + k))
            })
            .flat_map(|grid| motions * grid..motions * (grid + 1))
            .collect();
        for _ in 0..motions {
            rows.extend(&around);
            columns.push(rows.len());
        }
    }
    let n = long * wide * high * motions;
    SymbolicSparseColMat::new_checked(n, n, columns, None, rows)
}

fn fill(pattern: PatternRef<'_>, order: &[usize]) -> usize {
    let place = inverse(order);
    counted(pattern, SymmetricOrdering::Custom(PermRef::new_checked(order, &place, order.len()))).len_val()
}

#[test]
fn motions_of_a_grid_are_one_node_and_stay_together() {
    let pattern = block([5, 4, 1], 3);
    let groups = alike(pattern.as_ref());
    assert_eq!(groups, (0..20).map(|grid| 3 * grid..3 * grid + 3).collect::<Vec<_>>());
    let of_grids = graph(pattern.as_ref(), &groups);
    let expected = block([5, 4, 1], 1);
    assert_eq!(
        (of_grids.col_ptr(), of_grids.row_idx()),
        (expected.col_ptr(), expected.row_idx()),
        "as with one motion a grid"
    );
    let order = of_least_fill(pattern.as_ref());
    for grid in order.chunks(3) {
        assert_eq!(*grid, [grid[0], grid[0] + 1, grid[0] + 2]);
    }
    let mut all = order;
    all.sort_unstable();
    assert_eq!(all, (0..60).collect::<Vec<_>>());
}

#[test]
fn the_order_that_fills_in_least_is_taken() {
    for (shape, best) in [([100, 5, 1], "levels"), ([70, 70, 1], "degree"), ([20, 16, 12], "dissection")] {
        let pattern = block(shape, 1);
        let pattern = pattern.as_ref();
        let fills = [
            ("degree", counted(pattern, SymmetricOrdering::Amd).len_val()),
            ("levels", fill(pattern, &levels::reverse_cuthill_mckee(pattern))),
            ("dissection", fill(pattern, &dissection(pattern))),
        ];
        let least = fills.iter().min_by_key(|(_, fill)| *fill).expect("three");
        assert_eq!(least.0, best, "{shape:?}: {fills:?}");
        assert_eq!(fill(pattern, &of_least_fill(pattern)), least.1, "{shape:?}: {fills:?}");
    }
}

#[test]
fn levels_of_a_chain_fill_nothing() {
    let pattern = block([50, 1, 1], 1);
    assert_eq!(fill(pattern.as_ref(), &of_least_fill(pattern.as_ref())), 50 + 49);
}
