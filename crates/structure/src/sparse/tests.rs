//! Sparse sums and products beside dense ones.

use super::*;

const N: usize = 6;

/// Motions that elements join: 3 stands alone, 0 and 5 are apart.
fn lists() -> Vec<Vec<usize>> {
    vec![vec![2, 0], vec![4, 1, 2], vec![5, 4], vec![3]]
}

/// A symmetric matrix of an element.
fn own(n: usize, seed: usize) -> DMatrix<f64> {
    DMatrix::from_fn(n, n, |i, j| {
        ((i.min(j) + 3 * i.max(j) + seed) as f64 + 0.3).sin() + if i == j { 4.0 } else { 0.0 }
    })
}

fn dense(a: &Sparse) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(a.nrows(), a.ncols());
    for j in 0..a.ncols() {
        let rows: Vec<usize> = a.row_idx_of_col(j).collect();
        assert!(rows.windows(2).all(|pair| pair[0] < pair[1]), "rows ascend");
        rows.iter().zip(a.val_of_col(j)).for_each(|(i, value)| all[(*i, j)] = *value);
    }
    all
}

/// Stiffness and mass of all lists, and the same added up one by one.
fn summed() -> (Values, [DMatrix<f64>; 2]) {
    let mut values = Pattern::of(N, &lists()).values();
    let mut all = [DMatrix::zeros(N, N), DMatrix::zeros(N, N)];
    for (at, dofs) in lists().iter().enumerate() {
        let (k, m) = (own(dofs.len(), at), own(dofs.len(), at + 10));
        values.add(dofs, Some(&k), if at == 1 { None } else { Some(&m) });
        for (i, row) in dofs.iter().enumerate() {
            for (j, column) in dofs.iter().enumerate() {
                all[0][(*row, *column)] += k[(i, j)];
                all[1][(*row, *column)] += if at == 1 { 0.0 } else { m[(i, j)] };
            }
        }
    }
    // Of a list without a place for one motion.
    let k = own(3, 20);
    values.add_where(&[Some(4), None, Some(2)], Some(&k), None);
    for (i, row) in [(0, 4), (2, 2)] {
        for (j, column) in [(0, 4), (2, 2)] {
            all[0][(row, column)] += k[(i, j)];
        }
    }
    values.add_entry(4, 1, [0.5, 0.25]);
    values.add_entry(3, 3, [0.5, 0.25]);
    for (i, j) in [(4, 1), (1, 4), (3, 3)] {
        all[0][(i, j)] += 0.5;
        all[1][(i, j)] += 0.25;
    }
    (values, all)
}

fn symmetric() -> ([Sparse; 2], [DMatrix<f64>; 2]) {
    let (values, all) = summed();
    let (k, m) = values.symmetric();
    ([k, m], all)
}

#[test]
fn entries_are_summed_and_stand_in_both_triangles() {
    let (sparse, expected) = symmetric();
    for (own, expected) in sparse.iter().zip(&expected) {
        let own = dense(own);
        assert!((&own - expected).amax() < 1e-14, "{own} {expected}");
        assert_eq!(own, own.transpose());
    }
    // 6 on the diagonal, 1, 3 and 1 pairs.
    assert_eq!(sparse[0].val().len(), 6 + 2 * 5);
}

#[test]
fn a_change_of_mass_is_added_where_the_stiffness_has_entries() {
    let ([k, m], [_, expected]) = symmetric();
    let (dofs, change) = ([4, 2, 1], own(3, 40));
    let joined = |i: usize, j: usize| has(&k, i, j);
    let changed = dense(&with_sum(&m, &dofs, &change, joined).expect("one element joins them"));
    let mut expected = expected;
    for (i, j) in (0..9).map(|at| (at / 3, at % 3)) {
        expected[(dofs[i], dofs[j])] += change[(i, j)];
    }
    assert!((changed - &expected).amax() < 1e-14);
    assert!(with_sum(&m, &[0, 4], &own(2, 1), joined).is_none(), "no element joins them");
    // What a change takes away is no entry any more.
    let mass = dense(&m)[(3, 3)];
    let without = with_sum(&m, &[3], &DMatrix::from_element(1, 1, -mass), joined).expect("it is there");
    assert_eq!((without.val().len(), dense(&without)[(3, 3)]), (m.val().len() - 1, 0.0));
}

#[test]
fn sums_products_and_parts_are_those_of_the_whole_matrices() {
    let ([k, m], [k_all, m_all]) = symmetric();
    assert!(m.val().len() < k.val().len(), "the mass has fewer entries");
    let sum = combine(k.as_ref(), -2.5, m.as_ref());
    let sum = dense(&Sparse::new(k.symbolic().to_owned().expect("memory"), sum));
    assert!((sum - (&k_all - &m_all * 2.5)).amax() < 1e-14);
    let kept = [1, 2, 4];
    let part = k_all.select_rows(&kept).select_columns(&kept);
    assert!((dense(&block(k.as_ref(), &kept)) - part).amax() < 1e-14);
    assert!(diagonal(k.as_ref()).iter().enumerate().all(|(at, d)| (d - k_all[(at, at)]).abs() < 1e-14));
    for columns in [1, 4, 7] {
        let entry = |i: usize, j: usize| if i == 2 { 0.0 } else { (1.3 * i as f64 - 0.7 * j as f64).cos() };
        let x = Mat::from_fn(N, columns, |i, j| if j == 3 && i > 3 { 0.0 } else { entry(i, j) });
        let (own, all) = (multiply(k.as_ref(), x.as_ref()), DMatrix::from_fn(N, columns, |i, j| x[(i, j)]));
        let expected = &k_all * all;
        assert_eq!((own.nrows(), own.ncols()), (N, columns));
        for (i, j) in (0..N).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            assert!((own[(i, j)] - expected[(i, j)]).abs() < 1e-13, "{i} {j} of {columns}");
        }
    }
}

#[test]
fn a_lower_triangle_multiplies_and_gives_parts_as_the_whole_does() {
    let (whole, [k_all, m_all]) = symmetric();
    let (k, m) = summed().0.lower();
    let x = Mat::from_fn(N, 5, |i, j| (1.3 * i as f64 - 0.7 * j as f64).cos());
    for ((lower, whole), all) in [&k, &m].into_iter().zip(&whole).zip([k_all, m_all]) {
        // The sums have the same order: the same to the last bit.
        assert_eq!(lower.multiply(x.as_ref()), multiply(whole.as_ref(), x.as_ref()));
        for kept in [vec![1, 2, 4], vec![0, 5], vec![]] {
            let part = all.select_rows(&kept).select_columns(&kept);
            assert!((dense(&lower.block(&kept)) - part).iter().all(|miss| miss.abs() < 1e-14), "{kept:?}");
        }
        for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
            assert_eq!(
                (lower.has(i, j), has(whole, i, j)),
                (all[(i, j)] != 0.0, all[(i, j)] != 0.0),
                "{i} {j}"
            );
        }
    }
}

#[test]
fn what_hangs_together_is_listed_together() {
    let pattern = |lists: &[Vec<usize>]| Pattern::of(N, lists).values().symmetric().0;
    assert_eq!(components(pattern(&lists()).symbolic()), [vec![0, 1, 2, 4, 5], vec![3]]);
    let two = pattern(&[vec![5, 0], vec![1, 3], vec![3, 4]]);
    assert_eq!(components(two.symbolic()), [vec![0, 5], vec![1, 3, 4], vec![2]]);
}

#[test]
fn a_lumped_mass_has_no_entries_of_zero() {
    let mut values = Pattern::of(N, &lists()).values();
    values.add(&[4, 1, 2], Some(&own(3, 0)), Some(&DMatrix::from_diagonal_element(3, 3, 2.0)));
    let (k, m) = values.symmetric();
    assert_eq!((k.val().len(), m.val().len()), (6 + 2 * 5, 3));
    let lumped = DMatrix::from_fn(N, N, |i, j| if i == j && [1, 2, 4].contains(&i) { 2.0 } else { 0.0 });
    assert_eq!(dense(&m), lumped);
}
