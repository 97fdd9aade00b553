//! Gaussians of a few unknowns, conditioned by hand.

use super::*;

/// Airspeed, rows, which of them were read under a weight.
type At = (f64, Vec<Vec<f64>>, Vec<bool>);

fn joint(at: &[At], counts: [usize; 2], alike: f64) -> Joint {
    let of: Vec<OfAirspeed<'_>> =
        at.iter().map(|(v_m_s, rows, hung)| OfAirspeed { v_m_s: *v_m_s, rows, hung: hung.clone() }).collect();
    Joint::new(&of, [counts[0], counts[1], counts[1]], alike)
}

#[track_caller]
fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-12, "{a} {b}");
}

/// A reading `a z + noise` of the sizes 3 and 1 leaves `1 / (1 + 9)` of the variance, and the mean `3 d / 10`.
#[test]
fn one_reading_of_one_unknown_is_conditioned_as_by_hand() {
    let one = joint(&[(10.0, vec![vec![3.0, 0.0, 0.0]], vec![false])], [1, 2], 0.0);
    close(one.sigma(0, &[1.0, 0.0]), 0.1_f64.sqrt());
    close(one.sigma(0, &[2.0, 1.0]), (0.4_f64 + 1.0).sqrt());
    let means = one.means(&|k, i| 5.0 + (k + i) as f64).expect("it is finite");
    assert_eq!(means.len(), 1);
    means[0].iter().zip([1.5, 0.0, 0.0]).for_each(|(a, b)| close(*a, b));
    // the same reading once more: 1 / (1 + 9 + 9); one of the other unknown: 1 / (1 + 4)
    close(one.sigma_with(0, &[vec![3.0, 0.0]], &[1.0, 0.0]), (1.0 / 19.0_f64).sqrt());
    close(one.sigma_with(0, &[vec![0.0, 2.0]], &[0.0, 1.0]), 0.2_f64.sqrt());
    close(one.sigma_with(0, &[], &[1.0, 0.0]), 0.1_f64.sqrt());
}

/// What the data leave of `z1` and `z2` after `z1 + z2 + noise` is `I - [1 1; 1 1] / 3`, whose eigenvalues are 1/3
/// and 1.
#[test]
fn the_root_of_what_is_left_is_symmetric_and_its_square_is_the_covariance() {
    let one = joint(&[(10.0, vec![vec![1.0, 1.0]], vec![false])], [1, 2], 0.0);
    let root = one.root(0);
    let third = (1.0 / 3.0_f64).sqrt();
    for (i, j, value) in [
        (0, 0, 0.5 * (third + 1.0)),
        (1, 1, 0.5 * (third + 1.0)),
        (0, 1, 0.5 * (third - 1.0)),
        (1, 0, 0.5 * (third - 1.0)),
    ] {
        close(root[(i, j)], value);
    }
    let none = joint(&[(10.0, vec![], vec![])], [1, 3], 0.0);
    assert_eq!((none.root(0).nrows(), none.sigma(0, &[3.0, 4.0])), (3, 5.0));
}

/// Unknowns of two airspeeds: a correction, one of the structure, one of a sensor. Only the first airspeed is read.
fn two(alike: f64) -> Joint {
    let rows = vec![vec![2.0, 0.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 1.0]];
    let none = vec![vec![0.0; 3]];
    joint(&[(20.0, rows, vec![false; 3]), (40.0, none, vec![false])], [1, 2], alike)
}

#[test]
fn what_is_read_at_one_airspeed_tells_of_another_by_their_correlation() {
    let alike = 0.8;
    let correlation = (-(2.0_f64).ln() / alike).exp();
    let joint = two(alike);
    for (k, l) in [(0, 1), (1, 0)] {
        close(joint.correlation(k, l, 0), correlation);
        assert_eq!([1, 2].map(|unknown| joint.correlation(k, l, unknown)), [1.0, 0.0]);
        assert_eq!([0, 1, 2].map(|unknown| joint.correlation(k, k, unknown)), [1.0; 3]);
    }
    // of the correction 1/5 of the variance is left where it was read, and elsewhere what they do not have in common
    close(joint.sigma(0, &[1.0, 0.0]), 0.2_f64.sqrt());
    close(joint.sigma(1, &[1.0, 0.0]), (1.0 - 0.8 * correlation * correlation).sqrt());
    // the structure is one
    close(joint.sigma(0, &[0.0, 1.0]), 0.5_f64.sqrt());
    close(joint.sigma(1, &[0.0, 1.0]), 0.5_f64.sqrt());
    close(joint.sigma(1, &[1.0, 1.0]), (1.5 - 0.8 * correlation * correlation).sqrt());
    let means = joint.means(&|k, i| if k == 0 { [5.0, 6.0, 8.0][i] } else { 0.0 }).expect("it is finite");
    means[0].iter().zip([2.0, 3.0, 4.0]).for_each(|(a, b)| close(*a, b));
    // a sensor's own unknown is of its airspeed alone
    means[1].iter().zip([2.0 * correlation, 3.0, 0.0]).for_each(|(a, b)| close(*a, b));
    let root = joint.root(1);
    close(root[(0, 0)].powi(2) + root[(0, 1)].powi(2), 1.0 - 0.8 * correlation * correlation);
    close(root[(1, 1)].powi(2) + root[(1, 0)].powi(2), 0.5);
}

#[test]
fn airspeeds_that_are_not_alike_know_nothing_of_each_other() {
    let joint = two(0.0);
    assert_eq!([0, 1, 2].map(|unknown| joint.correlation(0, 1, unknown)), [0.0; 3]);
    close(joint.sigma(0, &[1.0, 1.0]), 0.7_f64.sqrt());
    assert_eq!(joint.sigma(1, &[3.0, 4.0]), 5.0);
    let means = joint.means(&|_, _| 1.0).expect("it is finite");
    assert_eq!(means[1], [0.0; 3]);
}

/// What a reading is off by is the same at both airspeeds and no part of the wing: read as twice it at one, a fifth of its variance is left.
#[test]
fn what_a_reading_is_off_by_is_shared_and_no_part_of_the_wing() {
    let rows = [vec![vec![0.0, 0.0, 2.0]], vec![vec![0.0; 3]]];
    let at = |k: usize| OfAirspeed { v_m_s: 20.0 + 20.0 * k as f64, rows: &rows[k], hung: vec![false] };
    let joint = Joint::new(&[at(0), at(1)], [1, 2, 3], 0.8);
    for k in [0, 1] {
        close(joint.sigma(k, &[0.0, 0.0, 1.0]), 0.2_f64.sqrt());
        close(joint.sigma(k, &[3.0, 0.0, 1.0]), 9.2_f64.sqrt());
        assert_eq!((joint.root(k).nrows(), joint.root(k).ncols()), (2, 2));
    }
}

/// The same weight was read by both; it is one reading, unless no airspeed knows of another.
#[test]
fn a_dead_weight_counts_once() {
    let rows = || vec![vec![0.0, 1.0], vec![1.0, 0.0]];
    let of = |other_m_s: f64, alike: f64| {
        joint(&[(20.0, rows(), vec![true, false]), (other_m_s, rows(), vec![true, false])], [1, 2], alike)
    };
    let together = of(20.0, 2.0);
    assert_eq!(together.rows.iter().map(|(k, i, _)| (*k, *i)).collect::<Vec<_>>(), [(0, 0), (0, 1), (1, 1)]);
    close(together.sigma(1, &[0.0, 1.0]), 0.5_f64.sqrt());
    // corrections of one airspeed were read twice
    close(together.sigma(1, &[1.0, 0.0]), (1.0 / 3.0_f64).sqrt());
    let apart = of(40.0, 0.0);
    assert_eq!(apart.rows.len(), 4);
    close(apart.sigma(1, &[1.0, 1.0]), 1.0);
}
