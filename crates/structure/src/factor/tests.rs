//! Factors and what a structure leaves loose.

use super::*;
use crate::sparse::{Pattern, Sparse};
use nalgebra::DMatrix;

/// A matrix with entries below the diagonal as given.
fn matrix(n: usize, entries: &[(usize, usize, f64)]) -> Sparse {
    let lists: Vec<Vec<usize>> = entries.iter().map(|(i, j, _)| vec![*i, *j]).collect();
    let mut values = Pattern::of(n, &lists).values();
    for (i, j, value) in entries {
        values.add_entry(*i, *j, [*value, 0.0]);
    }
    values.symmetric().0
}

fn dense(a: &Sparse) -> DMatrix<f64> {
    dense_of(a.as_ref())
}

fn dense_of(a: SparseColMatRef<'_, usize, f64>) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(a.nrows(), a.ncols());
    for j in 0..a.ncols() {
        a.row_idx_of_col(j).zip(a.val_of_col(j)).for_each(|(i, value)| all[(i, j)] = *value);
    }
    all
}

/// A chain of springs, free at both ends.
fn chain(springs: &[f64]) -> Sparse {
    let mut entries = Vec::new();
    for (at, k) in springs.iter().enumerate() {
        entries.extend([(at, at, *k), (at + 1, at + 1, *k), (at + 1, at, -k)]);
    }
    matrix(springs.len() + 1, &entries)
}

/// Coupled in a ring, with stiffnesses of unlike sizes; `sign` of one of its diagonal entries.
fn ring(sign: f64) -> Sparse {
    let mut entries = Vec::new();
    for at in 0..9_usize {
        entries.push((at, at, if at == 4 { sign * 300.0 } else { 5.0 + at as f64 }));
        if at > 0 {
            entries.push((at, at - 1, 1.0 - 0.3 * at as f64));
        }
    }
    entries.push((8, 0, 0.7));
    matrix(9, &entries)
}

fn scaled(a: &Sparse) -> Scaled<'_> {
    Scaled::of(a.symbolic(), a.val().to_vec(), &sizes(a))
}

fn indefinite(a: &Sparse) -> Option<Factor> {
    Factor::indefinite(&analysis(a), &scaled(a), Room::default())
}

fn analysis(a: &Sparse) -> Arc<Analysis> {
    Arc::new(analysed(a.symbolic()))
}

fn sizes(a: &Sparse) -> Vec<f64> {
    sparse::diagonal(a.as_ref()).iter().map(|d| d.abs()).collect()
}

/// A plate of grids with three motions each, stiffer from one end to the other: panels of many widths, with rows below.
fn plate(long: usize, wide: usize) -> Sparse {
    let mut entries = Vec::new();
    for grid in 0..long * wide {
        let neighbours = [(grid % wide + 1 < wide, grid + 1), (grid + wide < long * wide, grid + wide)];
        for at in 3 * grid..3 * grid + 3 {
            let size = (at % 200) as f64;
            entries.push((at, at, 9.0 + size * 0.1));
            entries.extend((3 * grid..at).map(|other| (at, other, 0.7)));
            for (_, other) in neighbours.iter().filter(|(is_there, _)| *is_there) {
                entries.extend((3 * other..3 * other + 3).map(|other| (other, at, 0.3 - 0.01 * size)));
            }
        }
    }
    matrix(3 * long * wide, &entries)
}

#[test]
fn solutions_are_those_of_the_whole_matrix_however_many_columns() {
    let diagonal = matrix(3, &[(0, 0, 2.0), (1, 1, -3.0), (2, 2, 0.5)]);
    for (a, columns) in [(ring(1.0), 11), (ring(-1.0), 11), (plate(9, 5), 1), (plate(9, 5), 8), (diagonal, 9)]
    {
        let n = a.ncols();
        let factor = indefinite(&a).expect("regular");
        let b = Mat::from_fn(n, columns, |i, j| (1.1 * i as f64 + 0.7 * j as f64).sin());
        let all = DMatrix::from_fn(n, columns, |i, j| b[(i, j)]);
        let expected = dense(&a).lu().solve(&all).expect("regular");
        let x = factor.solve(b.as_ref());
        let scale = |dof: usize| factor.scale[dof];
        let mut beside = Mat::zeros(n, columns);
        factor.solve_side_by_side(b.as_ref(), beside.as_mut(), scale);
        for (i, j) in (0..n).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            assert!((x[(i, j)] - expected[(i, j)]).abs() < 1e-13, "{i} {j} of {n}: {}", x[(i, j)]);
            let side = beside[(i, j)];
            assert!((side - expected[(i, j)]).abs() < 1e-13, "side by side, {i} {j} of {n}: {side}");
        }
    }
    let panels = |a: &Sparse| {
        let factor = indefinite(a).expect("regular");
        let panels = Panels::of(&factor.symbolic, &factor.values);
        (0..panels.count())
            .map(|at| (panels.panel(at).width, panels.panel(at).rows.len()))
            .collect::<Vec<_>>()
    };
    let widths = panels(&plate(9, 5));
    assert!(widths.iter().any(|(width, rows)| *width > 4 && width % 4 > 0 && *rows > 0), "{widths:?}");
    assert!(widths.len() > 4);
}

#[test]
fn a_factor_and_its_solutions_are_the_same_to_the_last_bit_on_any_number_of_threads() {
    let a = plate(70, 40);
    let b = Mat::from_fn(a.ncols(), 5, |i, j| (1.1 * i as f64 + 0.7 * j as f64).sin());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let factor = Factor::held(&analysis(&a), a.as_ref());
            let x = factor.solve(b.as_ref());
            (factor.values, factor.weak, x)
        })
    };
    let one = on(1);
    for threads in [2, 3, 4] {
        assert!(one == on(threads), "{threads} threads");
    }
}

#[test]
fn pivots_are_named_once_and_multiply_to_the_determinant_of_the_scaled_matrix() {
    for sign in [1.0, -1.0] {
        let a = ring(sign);
        let factor = indefinite(&a).expect("regular");
        let pivots = factor.pivots();
        let mut dofs: Vec<usize> = pivots.iter().map(|(dof, _)| *dof).collect();
        dofs.sort_unstable();
        assert_eq!(dofs, (0..9).collect::<Vec<_>>());
        let product: f64 = pivots.iter().map(|(_, pivot)| pivot).product();
        let expected = dense(&a).determinant() * factor.scale.iter().map(|s| s * s).product::<f64>();
        assert!((product / expected - 1.0).abs() < 1e-12, "{product} for {expected}");
        let negative = pivots.iter().filter(|(_, pivot)| *pivot < 0.0).count();
        let below = dense(&a).symmetric_eigenvalues().iter().filter(|value| **value < 0.0).count();
        assert_eq!(negative, below, "Sylvester's law of inertia");
    }
    // A diagonal matrix, each pivot its own sign.
    let a = matrix(4, &[(0, 0, 2.0), (1, 1, -3.0), (2, 2, 0.5), (3, 3, -1e6)]);
    let factor = indefinite(&a).expect("regular");
    let mut pivots = factor.pivots();
    pivots.sort_by_key(|(dof, _)| *dof);
    for ((dof, own), expected) in pivots.into_iter().zip([1.0, -1.0, 1.0, -1.0]) {
        assert!((own - expected).abs() < 1e-14, "{dof}: {own}");
    }
}

/// Whatever stands in the memory of another factor, longer or shorter.
#[test]
fn a_factor_in_the_room_of_another_is_the_same() {
    for a in [ring(1.0), ring(-1.0), chain(&[1.0; 40]), matrix(3, &[(0, 0, 2.0), (1, 1, -3.0), (2, 2, 0.5)])]
    {
        let own = indefinite(&a).expect("regular");
        for count in [1, own.values.len(), 3 * own.values.len()] {
            let room = Room(vec![f64::NAN; count]);
            let other = Factor::indefinite(&analysis(&a), &scaled(&a), room).expect("regular");
            assert_eq!((own.pivots(), own.is_certain), (other.pivots(), other.is_certain));
            let b = Mat::from_fn(a.ncols(), 3, |i, j| (1.1 * i as f64 + 0.7 * j as f64).sin());
            assert_eq!(own.solve(b.as_ref()), other.solve(b.as_ref()));
        }
    }
}

/// By L and D of the scaled matrix in the order of elimination, worked out by the schoolbook's rule.
#[test]
fn energies_of_rounding_are_those_of_absolute_values() {
    for a in [ring(1.0), ring(-1.0), matrix(3, &[(0, 0, 2.0), (1, 1, -3.0), (2, 2, 0.5)])] {
        let n = a.ncols();
        let factor = indefinite(&a).expect("regular");
        let order: Vec<usize> = factor.pivots().iter().map(|(dof, _)| *dof).collect();
        let scale = &factor.scale;
        let all = dense(&a);
        let scaled = DMatrix::from_fn(n, n, |i, j| scale[i] * all[(i, j)] * scale[j]);
        let mut rest = DMatrix::from_fn(n, n, |i, j| scaled[(order[i], order[j])]);
        let mut lower = DMatrix::<f64>::identity(n, n);
        for column in 0..n {
            for row in column + 1..n {
                lower[(row, column)] = rest[(row, column)] / rest[(column, column)];
                for other in column + 1..n {
                    let taken = lower[(row, column)] * rest[(column, other)];
                    rest[(row, other)] -= taken;
                }
            }
        }
        let x: Vec<f64> = (0..n).map(|i| (2.3 * i as f64 + 0.4).sin()).collect();
        let absolute: f64 =
            (0..n * n).map(|at| (x[at / n] * scaled[(at / n, at % n)] * x[at % n]).abs()).sum();
        let scaled = super::tests::scaled(&a);
        let column = Mat::from_fn(n, 1, |i, _| x[i]);
        assert!((absolute_energies(scaled.matrix(), column.as_ref())[0] / absolute - 1.0).abs() < 1e-13);
        let of_column = |column: usize| -> f64 {
            let sum: f64 = (column..n).map(|row| (lower[(row, column)] * x[order[row]]).abs()).sum();
            rest[(column, column)].abs() * sum * sum
        };
        let expected: f64 = (0..n).map(of_column).sum();
        let both = Mat::from_fn(n, 2, |i, j| if j == 0 { -3.0 * x[i] } else { x[i] });
        let [tripled, own, ..] = factor.factor_energies(both.as_ref());
        assert!((own / expected - 1.0).abs() < 1e-12, "{expected}");
        assert!((tripled / (9.0 * expected) - 1.0).abs() < 1e-12, "{expected}");
    }
}

/// Two motions on a common spring and one that is weaker by so much: its energy is half of that, what rounding does
/// is two.
#[test]
fn signs_are_certain_where_energies_exceed_rounding() {
    let of = |weak: f64| {
        let a = matrix(2, &[(0, 0, 1.0), (1, 1, 1.0 + weak), (1, 0, -1.0)]);
        indefinite(&a).is_some_and(|factor| factor.is_certain)
    };
    assert!(of(1e-12) && of(-1e-12) && of(0.5));
    assert!(!of(2.0 * f64::EPSILON) && !of(-2.0 * f64::EPSILON));
}

#[test]
fn a_free_chain_is_held_where_it_moves_most_and_answers_loads_without_a_resultant() {
    let a = chain(&[3.0, 1.0, 100.0, 2.0]);
    let all = analysis(&a);
    let ones = Mat::from_fn(5, 1, |_, _| 1.0);
    for factor in [Factor::held(&all, a.as_ref()), Factor::held_expecting(&all, a.as_ref(), &ones)] {
        assert_eq!(factor.loose.len(), 1);
        // A pull of 6 N from one end to the other stretches the springs one by one.
        let pull = [-6.0, 0.0, 0.0, 0.0, 6.0];
        let x = factor.solve(Mat::from_fn(5, 1, |i, _| pull[i]).as_ref());
        for (at, k) in [3.0, 1.0, 100.0, 2.0].iter().enumerate() {
            assert!((x[(at + 1, 0)] - x[(at, 0)] - 6.0 / k).abs() < 1e-12, "spring {at}");
        }
    }
    let held = matrix(2, &[(0, 0, 2.0), (1, 1, 1.0), (1, 0, -1.0)]);
    assert!(Factor::held(&analysis(&held), held.as_ref()).loose.is_empty());
    assert!(
        Factor::held_expecting(&analysis(&held), held.as_ref(), &Mat::from_fn(2, 1, |_, _| 1.0))
            .loose
            .is_empty()
    );
}

#[test]
fn motions_that_meet_no_stiffness_are_told_from_others() {
    let a = chain(&[1.0, 100.0, 2.0]);
    let among = |columns: &[[f64; 4]]| {
        let motions = Mat::from_fn(4, columns.len(), |i, j| columns[j][i]);
        loose_among(a.as_ref(), &motions)
    };
    // All move alike: the most energy would be at the motions of 101 and 102 N/m.
    assert_eq!(among(&[[1.0; 4]]), [2]);
    assert_eq!(among(&[[-7.0; 4], [1.0, 0.0, 0.0, 0.0]]), [2]);
    assert!(among(&[[1.0, 0.0, 0.0, 0.0], [1.0, -1.0, 1.0, -1.0], [0.0; 4]]).is_empty());
    // A millionth more stretches a spring by more than rounding does, a last digit does not.
    assert!(among(&[[1.0, 1.0, 1.0, 1.0 + 1e-6]]).is_empty());
    assert_eq!(among(&[[1.0, 1.0, 1.0, 1.0 + 1e-15]]), [2]);
    // Twice the same motion is one.
    assert_eq!(among(&[[1.0; 4], [2.0; 4]]), [2]);
    let two = matrix(4, &[(0, 0, 1.0), (1, 1, 1.0), (1, 0, -1.0), (2, 2, 5.0), (3, 3, 5.0), (3, 2, 5.0)]);
    let motions = Mat::from_fn(4, 2, |i, j| match (i, j) {
        (0 | 1, _) => 1.0,
        (2, 0) | (3, 1) => 2.0,
        _ => -2.0,
    });
    let mut places = loose_among(two.as_ref(), &motions);
    places.sort_unstable();
    assert!(places.len() == 2 && places[0] < 2 && places[1] >= 2, "one in each part: {places:?}");
}

#[test]
fn places_hold_as_many_motions_as_are_independent() {
    let motions = vec![vec![1.0, 2.0, 0.5], vec![-2.0, -4.0, -1.0], vec![1.0, 2.0, -3.0]];
    let places = pivots_of(motions);
    // The largest entry is -4; what is left of the third motion is at the last place.
    assert_eq!(places, [1, 2]);
    assert!(pivots_of(vec![vec![0.0; 3]]).is_empty() && pivots_of(Vec::new()).is_empty());
}

#[test]
fn columns_are_made_orthonormal_and_a_zero_stays() {
    let mut x =
        Mat::from_fn(4, 3, |i, j| if j == 1 { 0.0 } else { ((i + 1) as f64).powi(1 + i32::from(j > 0)) });
    let before = x.clone();
    orthonormalise(&mut x);
    let gram = inner(x.as_ref(), x.as_ref());
    for (i, j) in (0..9).map(|at| (at / 3, at % 3)) {
        let expected = f64::from(u8::from(i == j && i != 1));
        assert!((gram[(i, j)] - expected).abs() < 1e-14, "{i} {j}: {}", gram[(i, j)]);
    }
    // The first keeps its direction, the last lies in the plane of both.
    assert!((x[(1, 0)] / x[(0, 0)] - 2.0).abs() < 1e-14);
    let share = |k: usize| -> f64 { (0..4).map(|i| x[(i, k)] * before[(i, 2)]).sum() };
    for i in 0..4 {
        let back = share(0) * x[(i, 0)] + share(2) * x[(i, 2)];
        assert!((back - before[(i, 2)]).abs() < 1e-12, "{i}");
    }
    assert!(share(2) > 0.0);
}

#[test]
fn springs_stand_on_the_diagonal_of_the_scaled_matrix_alone() {
    let a = chain(&[1.0, 3.0]);
    let held = Scaled::of(a.symbolic(), a.val().to_vec(), &[1.0, 4.0, 0.25]).held(&[1]);
    let own = dense_of(held.matrix());
    let expected = DMatrix::from_row_slice(3, 3, &[1.0, -0.5, 0.0, -0.5, 1.0 + 1.0, -3.0, 0.0, -3.0, 12.0]);
    assert!((&own - &expected).amax() < 1e-14, "{own} {expected}");
}
