//! Oscillators whose growth, frequency and shape over airspeed are prescribed.

use super::*;
use std::cell::Cell;

fn spectrum(values: &[c64], columns: &[&[c64]]) -> Spectrum {
    let vectors = Mat::from_fn(columns.first().map_or(0, |c| c.len()), columns.len(), |i, j| columns[j][i]);
    Spectrum { values: values.to_vec(), vectors }
}

fn imaginary(values: &[f64]) -> Vec<c64> {
    values.iter().map(|im| c64::new(0.0, *im)).collect()
}

#[test]
fn what_grows_is_counted_beyond_round_off_and_pairs_once() {
    let count = unstable;
    // beside an eigenvalue of 100 what grows by 1e-10 is round-off
    let large = c64::new(-100.0, 0.0);
    assert_eq!(count(&[large, c64::new(5e-11, 3.0), c64::new(5e-11, -3.0)]), [0, 0]);
    assert_eq!(count(&[large, c64::new(2e-10, 3.0), c64::new(2e-10, -3.0)]), [1, 0]);
    let pair = [c64::new(1.0, 3.0), c64::new(1.0, -3.0)];
    assert_eq!(count(&[large, pair[0], pair[1], c64::from(2.0), c64::from(0.5), c64::from(-1.0)]), [1, 2]);
    assert_eq!(count(&[c64::default(); 2]), [0, 0]);
    // as good as real
    assert_eq!(count(&[c64::new(100.0, 5e-8), c64::new(100.0, -5e-8)]), [0, 2]);
    assert_eq!(count(&[c64::new(100.0, 2e-7), c64::new(100.0, -2e-7)]), [1, 0]);
    assert!(!oscillates(c64::default()) && oscillates(c64::new(0.0, 1.0)));
    assert!(!oscillates(c64::new(0.0, -1.0)));
}

#[test]
fn likeness_is_the_square_of_the_cosine_between_shapes() {
    let (one, i) = (c64::from(1.0), c64::new(0.0, 1.0));
    let from = spectrum(&imaginary(&[1.0, 2.0]), &[&[one, i], &[one * 2.0, c64::default()]]);
    let to = spectrum(&imaginary(&[1.0, 2.0]), &[&[one, one], &[i * 3.0, -one * 3.0]]);
    // conj(1) 1 + conj(i) 1 = 1 - i over 2 and 2; i (1, i) is (i, -1)
    for (a, b, wanted) in [(0, 0, 0.5), (0, 1, 1.0), (1, 0, 0.5), (1, 1, 0.5)] {
        assert!((from.likeness(a, &to, b) - wanted).abs() < 1e-12, "{a} {b}: {}", from.likeness(a, &to, b));
    }
    let none = spectrum(&imaginary(&[1.0, 2.0]), &[&[c64::default(); 2], &[c64::default(); 2]]);
    assert_eq!(from.likeness(0, &none, 0), 0.0);
}

/// A shape with this likeness to the first axis.
fn like(share: f64) -> [c64; 2] {
    [c64::from(share.sqrt()), c64::from((1.0 - share).sqrt())]
}

#[test]
fn a_branch_goes_where_likeness_less_the_relative_distance_is_largest() {
    let from = spectrum(&imaginary(&[100.0, 50.0]), &[&like(1.0), &like(0.0)]);
    let to = |values: &[f64], likes: [f64; 2]| {
        let columns = likes.map(like);
        spectrum(&imaginary(values), &[&columns[0], &columns[1]])
    };
    let first = [Some(0)];
    // .5 and .9 - .3
    assert_eq!(matched(&from, &to(&[100.0, 130.0], [0.5, 0.9]), &first), (vec![Some(1)], true));
    // .5 and .7 - .3
    assert_eq!(matched(&from, &to(&[100.0, 70.0], [0.5, 0.7]), &first), (vec![Some(0)], false));
    assert_eq!(matched(&from, &to(&[100.0, 70.0], [0.85, 0.1]), &first), (vec![Some(0)], true));
    // what swings backwards or not at all is none
    assert_eq!(matched(&from, &to(&[-100.0, 0.0], [1.0, 1.0]), &first), (vec![None], false));
    // two that would be nearer to each other's eigenvalue: by 2 x 50, by 2 x 0.06 and 2 x 0.04 for a limit of 0.1
    let both = [Some(0), Some(1)];
    assert_eq!(matched(&from, &to(&[50.0, 100.0], [0.9, 0.1]), &both), (vec![Some(0), Some(1)], false));
    let close = |apart: f64, plain: bool| {
        let from = spectrum(&imaginary(&[100.0, 100.0 - apart]), &[&like(1.0), &like(0.0)]);
        let exchanged = to(&[100.0 - apart, 100.0], [0.9, 0.1]);
        assert_eq!(matched(&from, &exchanged, &both), (vec![Some(0), Some(1)], plain));
    };
    close(0.06, false);
    close(0.04, true);
    // the best pair first; the other takes what is left, which is not plain
    assert_eq!(matched(&from, &to(&[100.0, 50.0], [0.9, 0.6]), &both), (vec![Some(0), Some(1)], false));
    assert_eq!(matched(&from, &to(&[50.0, 100.0], [0.05, 0.9]), &both), (vec![Some(1), Some(0)], true));
    // a branch that has ended stays ended
    assert_eq!(
        matched(&from, &to(&[100.0, 50.0], [0.9, 0.1]), &[None, Some(1)]),
        (vec![None, Some(1)], true)
    );
}

fn flow(v_m_s: f64) -> Flow {
    Flow { v_m_s, rho_kg_m3: 1.2 }
}

/// Growth and frequency of oscillations, each in coordinates of its own, then real eigenvalues.
fn blocks(oscillations: &[(f64, f64)], real: &[f64]) -> Mat<f64> {
    let pairs = 2 * oscillations.len();
    let mut a = Mat::zeros(pairs + real.len(), pairs + real.len());
    for (k, (growth, omega)) in oscillations.iter().enumerate() {
        (a[(2 * k, 2 * k)], a[(2 * k + 1, 2 * k + 1)]) = (*growth, *growth);
        (a[(2 * k, 2 * k + 1)], a[(2 * k + 1, 2 * k)]) = (*omega, -omega);
    }
    real.iter().enumerate().for_each(|(k, value)| a[(pairs + k, pairs + k)] = *value);
    a
}

type Curves = Result<FlutterCurves, FlutterError>;

#[test]
fn flutter_and_divergence_are_found_where_they_are_and_ascribed_to_the_branch_beside_them() {
    // the first rises from 5 to 20 rad/s and grows from 19 m/s on, the second falls from 22 to 7; divergence at 13 m/s
    let matrix = |flow: Flow| {
        let v = flow.v_m_s;
        let first = (0.1 * (v - 19.0), 5.0 + 1.5 * (v - 10.0));
        Ok(blocks(&[first, (-1.0, 22.0 - 1.5 * (v - 10.0))], &[v - 13.0, -40.0]))
    };
    let curves: Curves = flutter_of_state_space(&[flow(10.0), flow(20.0)], matrix);
    let curves = curves.expect("eigenvalues");
    let alone: Result<Vec<Crossing>, FlutterError> = changes_of_stability(&[flow(10.0), flow(20.0)], matrix);
    let beside = alone.expect("eigenvalues").into_iter().zip(&curves.crossings);
    let beside: Vec<Crossing> = beside.map(|(alone, of)| Crossing { branch: of.branch, ..alone }).collect();
    assert_eq!(beside, curves.crossings, "changes without curves");
    let [divergence, flutter] = curves.crossings[..] else { panic!("{:?}", curves.crossings) };
    assert!((divergence.flow.v_m_s - 13.0).abs() < 1e-8 && divergence.omega_rad_s == 0.0, "{divergence:?}");
    assert!((flutter.flow.v_m_s - 19.0).abs() < 1e-8 && (flutter.omega_rad_s - 18.5).abs() < 1e-7);
    assert!(divergence.unstable && flutter.unstable && !flutter.beyond_table);
    assert_eq!((flutter.branch, flutter.flow.rho_kg_m3), (0, 1.2));
    for (branch, ends) in curves.branches.iter().zip([[5.0, 20.0], [22.0, 7.0]]) {
        let found: Vec<f64> = branch.iter().map(|root| root.p.im).collect();
        assert!(found.iter().zip(ends).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
        assert!(branch.iter().all(|root| !root.beyond_table));
    }
    // the way back: both become stable again
    let back: Curves = flutter_of_state_space(&[flow(20.0), flow(10.0)], matrix);
    let back = back.expect("eigenvalues");
    assert_eq!(back.crossings.len(), 2);
    assert!(back.crossings.iter().all(|crossing| !crossing.unstable) && back.flutter().is_none());
}

#[test]
fn a_change_over_density_is_halved_in_on_as_one_over_airspeed_is_and_no_finer() {
    let along = |of: fn(f64) -> Flow, value: fn(Flow) -> f64| {
        let calls = Cell::new(0);
        let matrix = |flow: Flow| {
            calls.set(calls.get() + 1);
            Ok(blocks(&[(value(flow) - 12.0, 6.0)], &[]))
        };
        let curves: Curves = flutter_of_state_space(&[of(10.0), of(20.0)], matrix);
        let crossing = curves.expect("eigenvalues").crossings[0];
        assert!((value(crossing.flow) - 12.0).abs() < 2e-9, "{crossing:?}");
        // 10/2^n below 1e-10 of 12, and both ends
        assert_eq!(calls.get(), 2 + 33);
    };
    along(|v_m_s| Flow { v_m_s, rho_kg_m3: 1.2 }, |flow| flow.v_m_s);
    along(|rho_kg_m3| Flow { v_m_s: 30.0, rho_kg_m3 }, |flow| flow.rho_kg_m3);
}

#[test]
fn branches_are_oscillations_with_less_than_half_of_the_critical_damping() {
    let damped = |ratio: f64, omega: f64| (-ratio * omega, omega * f64::sqrt(1.0 - ratio * ratio));
    let matrix = |_: Flow| Ok(blocks(&[damped(0.6, 9.0), damped(0.4, 7.0), damped(0.1, 3.0)], &[-0.2, 0.1]));
    let calls = Cell::new(0);
    let counted = |flow: Flow| {
        calls.set(calls.get() + 1);
        matrix(flow)
    };
    let curves: Curves = flutter_of_state_space(&[flow(10.0), flow(11.0), flow(12.0)], counted);
    let curves = curves.expect("eigenvalues");
    let found: Vec<f64> = curves.branches.iter().map(|branch| branch[2].p.norm()).collect();
    assert!(found.len() == 2 && (found[0] - 3.0).abs() < 1e-9 && (found[1] - 7.0).abs() < 1e-9, "{found:?}");
    assert!(curves.crossings.is_empty(), "what grows throughout changes nowhere");
    assert_eq!(calls.get(), 3, "where it is plain which is which nothing is halved");
    let none: Curves = flutter_of_state_space(&[], matrix);
    assert!(matches!(none, Err(FlutterError::Empty(_))));
}

/// Two oscillators of 5 and 6 rad/s whose shapes are turned by an angle.
fn turned(angle: f64) -> Mat<f64> {
    let (sin, cos) = angle.sin_cos();
    let shape = [[cos, sin], [-sin, cos]];
    let stiffness = |i: usize, j: usize| 25.0 * shape[0][i] * shape[0][j] + 36.0 * shape[1][i] * shape[1][j];
    Mat::from_fn(4, 4, |i, j| match (i < 2, j < 2) {
        (true, _) => f64::from(u8::from(j == i + 2)),
        (false, true) => -stiffness(i - 2, j),
        (false, false) => -0.1 * f64::from(u8::from(i == j)),
    })
}

#[test]
fn shapes_that_turn_are_followed_in_steps_that_are_halved() {
    // sixty degrees on the way: seen from its ends each would have become the other
    let curves: Curves = flutter_of_state_space(&[flow(10.0), flow(20.0)], |flow: Flow| {
        Ok(turned(std::f64::consts::FRAC_PI_3 * 0.1 * (flow.v_m_s - 10.0)))
    });
    let curves = curves.expect("eigenvalues");
    for (branch, squared) in curves.branches.iter().zip([25.0, 36.0]) {
        assert!(branch.iter().all(|root| (root.p.norm_sqr() - squared).abs() < 1e-9), "{branch:?}");
    }
}

/// Oscillators that pass each other keep their shapes, those that only exchange them keep their eigenvalues; both look alike at the
/// ends of a step.
#[test]
fn branches_that_exchange_their_shapes_are_told_from_branches_that_cross() {
    // a quarter turn, then on by another and back by a whole half
    let flows = [10.0, 20.0, 30.0, 10.0].map(flow);
    let curves: Curves = flutter_of_state_space(&flows, |flow: Flow| {
        Ok(turned(std::f64::consts::FRAC_PI_2 * 0.1 * (flow.v_m_s - 10.0)))
    });
    for (branch, squared) in curves.expect("eigenvalues").branches.iter().zip([25.0, 36.0]) {
        assert!(branch.len() == 4 && branch.iter().all(|root| (root.p.norm_sqr() - squared).abs() < 1e-9));
    }
    let crossing = |flow: Flow| Ok(blocks(&[(-0.1, 0.5 * flow.v_m_s), (-0.2, 15.0 - 0.5 * flow.v_m_s)], &[]));
    let curves: Curves = flutter_of_state_space(&[flow(10.0), flow(20.0)], crossing);
    for (branch, ends) in curves.expect("eigenvalues").branches.iter().zip([[5.0, 10.0], [10.0, 5.0]]) {
        assert!(branch.iter().zip(ends).all(|(root, im)| (root.p.im - im).abs() < 1e-9), "{branch:?}");
    }
}

#[test]
fn changes_there_and_back_stand_in_the_order_of_the_way() {
    // 5 and 9 rad/s at 10 m/s, 9 and 5 at 20; the one that rises grows between 14 and 22 m/s
    let matrix = |flow: Flow| {
        let v = flow.v_m_s;
        Ok(blocks(
            &[(0.1 * (4.0 - (v - 18.0).abs()), 5.0 + 0.4 * (v - 10.0)), (-1.0, 9.0 - 0.4 * (v - 10.0))],
            &[],
        ))
    };
    let curves: Curves = flutter_of_state_space(&[10.0, 20.0, 10.0].map(flow), matrix);
    let curves = curves.expect("eigenvalues");
    let said: Vec<(usize, f64, bool)> =
        curves.crossings.iter().map(|c| (c.branch, c.flow.v_m_s.round(), c.unstable)).collect();
    // at 14 m/s it has 6.6 rad/s; at 20 the falling one (5) is nearer to that than itself (9), at 10 itself (5)
    assert_eq!(said, [(1, 14.0, true), (0, 14.0, false)]);
}

#[test]
fn halving_ends_where_shapes_jump() {
    for jump in [10.0 + 1e-6, 20.0 - 1e-6] {
        let calls = Cell::new(0);
        let matrix = |flow: Flow| {
            calls.set(calls.get() + 1);
            Ok(turned(if flow.v_m_s > jump { std::f64::consts::FRAC_PI_4 } else { 0.0 }))
        };
        let curves: Curves = flutter_of_state_space(&[flow(10.0), flow(20.0)], matrix);
        assert_eq!(curves.expect("eigenvalues").branches.len(), 2);
        assert_eq!(calls.get(), 2 + HALVINGS, "both ends and one halving in each interval with the jump");
    }
}
