//! Columns counted by hand, and accelerations expressed by everything else.

use super::*;

const LAYOUT: Layout = Layout { modes: 3, slow_modes: 2, controls: 2, poles: [2, 3], fields: 3 };

#[test]
fn columns_stand_where_they_are_counted_to() {
    assert_eq!(
        (LAYOUT.motions(), LAYOUT.motion(0), LAYOUT.motion(1), LAYOUT.motion(2)),
        (6, 0..6, 6..12, 12..18)
    );
    assert_eq!(LAYOUT.modal_accelerations(), 12..15);
    assert_eq!((0..6).map(|m| LAYOUT.family_of(m)).collect::<Vec<_>>(), [0, 0, 1, 0, 0, 0]);
    assert_eq!(LAYOUT.family(0).collect::<Vec<_>>(), [0, 1, 3, 4, 5]);
    assert_eq!(LAYOUT.family(1).collect::<Vec<_>>(), [2]);
    // five slow motions with two poles, one fast with three
    assert_eq!([(0, 0), (0, 1), (1, 0), (1, 2)].map(|(f, p)| LAYOUT.lags_before(f, p)), [0, 5, 10, 12]);
    assert_eq!((LAYOUT.lags(), LAYOUT.first_lag(), LAYOUT.one()), (13, 18, 31));
    assert_eq!(([0, 1, 2].map(|f| LAYOUT.field(f)), LAYOUT.len()), ([32, 33, 34], 35));
    let lags: Vec<_> = LAYOUT.every_lag().collect();
    let slow = |pole: usize| [0, 1, 3, 4, 5].map(|motion| (0, pole, motion));
    assert_eq!(lags, [&slow(0)[..], &slow(1), &[(1, 0, 2), (1, 1, 2), (1, 2, 2)]].concat());
}

#[test]
fn modal_accelerations_are_replaced_by_what_they_are_of_the_rest() {
    let number = |i: usize, j: usize| ((3 * i + 7 * j) as f64).sin();
    let mut modal = Linear::zeros(3, LAYOUT);
    modal.by = Mat::from_fn(3, 35, |i, j| if (12..15).contains(&j) { 0.0 } else { number(i + 4, j) });
    let rows = Linear { layout: LAYOUT, by: Mat::from_fn(2, 35, number) };
    // any state: with the accelerations that it has, both give the same
    let mut x: Vec<f64> = (0..35).map(|k| (1.9 * f64::from(k)).cos()).collect();
    let times = |by: &Mat<f64>, x: &[f64], row: usize| (0..35).map(|k| by[(row, k)] * x[k]).sum::<f64>();
    for mode in 0..3 {
        x[12 + mode] = times(&modal.by, &x, mode);
    }
    let freed = rows.clone().with_modal(&modal);
    for row in 0..2 {
        assert!((times(&rows.by, &x, row) - times(&freed.by, &x, row)).abs() < 1e-12);
        assert!((12..15).all(|k| freed.by[(row, k)] == 0.0));
    }
    let left = Mat::from_fn(1, 2, |_, j| [2.0, -3.0][j]);
    let sum =
        rows.mapped(left.as_ref()).plus(&Linear { layout: LAYOUT, by: Mat::from_fn(1, 35, |_, _| 0.5) });
    assert!((sum.by[(0, 4)] - (2.0 * number(0, 4) - 3.0 * number(1, 4) + 0.5)).abs() < 1e-12);
}
