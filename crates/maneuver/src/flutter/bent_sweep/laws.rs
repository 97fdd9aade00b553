//! Pairs, changes of stability and likeness by hand; the sweep of a wing whose points are looked at one by one.

use super::super::bent::laws::point;
use super::*;
use crate::small::{CHORD_M, goland};
use std::cell::Cell;

#[expect(clippy::unnecessary_wraps, reason = "roots of a point may be missing")]
fn root(re: f64, im: f64) -> Option<c64> {
    Some(c64::new(re, im))
}

#[test]
fn the_nearest_pairs_are_taken_first_and_none_is_farther_than_the_limit() {
    let pairs = vec![(0.3, 0, 0), (0.1, 0, 1), (0.05, 1, 1), (0.2, 2, 2), (0.4, 0, 2)];
    assert_eq!(matched(3, pairs.clone(), 0.3), [Some(0), Some(1), Some(2)]);
    assert_eq!(matched(3, pairs.clone(), 0.29), [None, Some(1), Some(2)]);
    assert_eq!(matched(3, pairs, 0.01), [None; 3]);
}

#[test]
fn a_root_is_another_one_beyond_a_quarter_of_the_larger_modulus() {
    assert_eq!(nearest(&[root(0.0, 100.0)], &[root(0.0, 75.1)]), [root(0.0, 75.1)]);
    assert_eq!(nearest(&[root(0.0, 100.0)], &[root(0.0, 74.9)]), [None]);
    assert_eq!(nearest(&[root(0.0, 75.1)], &[root(0.0, 100.0)]), [root(0.0, 100.0)]);
    assert_eq!(nearest(&[root(0.0, 74.9), None], &[root(0.0, 100.0), None]), [None, None]);
}

#[test]
fn a_change_of_stability_lies_where_a_straight_line_has_no_growth() {
    let slow = point(20.0, 0.1, &[None, root(-0.3, 12.0)]);
    let fast = point(30.0, 0.3, &[root(1.0, 2.0), root(0.9, 16.0)]);
    // a quarter of the way
    let found = change(&slow, &fast, 1).expect("it begins to grow");
    assert_eq!((found.branch, found.unstable), (1, true));
    assert!((found.v_m_s - 22.5).abs() < 1e-12 && (found.tip_z_m - 0.15).abs() < 1e-12, "{found:?}");
    assert!((found.frequency_hz - 13.0 / TAU).abs() < 1e-12, "{found:?}");
    let back = change(&fast, &slow, 1).expect("it ends to grow");
    assert!(!back.unstable && (back.v_m_s - 22.5).abs() < 1e-12, "{back:?}");
    assert_eq!(change(&slow, &fast, 0), None, "a root that is not there");
    // one that neither grows nor dies is not unstable
    for (a, b, unstable) in [
        (-1.0, -0.1, None),
        (0.2, 3.0, None),
        (-1.0, 0.0, None),
        (0.0, -1.0, None),
        (0.0, 1.0, Some(true)),
        (1.0, 0.0, Some(false)),
    ] {
        let pair = [a, b].map(|re| point(20.0, 0.0, &[root(re, 9.0)]));
        let found = change(&pair[0], &pair[1], 0);
        assert_eq!(found.map(|change| change.unstable), unstable, "{a} to {b}");
    }
}

#[test]
fn a_sweep_that_begins_above_flutter_says_so() {
    let of = |points: Vec<BentPoint>| BentSweep { points, crossings: Vec::new(), ended: None };
    let (stable, neutral) = (point(9.0, 0.0, &[root(-1.0, 5.0), None]), point(9.0, 0.0, &[root(0.0, 5.0)]));
    let unstable = point(9.0, 0.0, &[None, root(-1.0, 5.0), root(0.1, 5.0)]);
    for (points, expected) in [
        (Vec::new(), false),
        (vec![stable.clone()], false),
        (vec![neutral], false),
        (vec![stable.clone(), unstable.clone()], false),
        (vec![unstable, stable], true),
    ] {
        assert_eq!(of(points).is_unstable_from_the_start(), expected);
    }
}

/// Points with shapes of two nodes, one column a mode: entries by place in the twelve.
fn shaped(columns: &[&[(usize, f64)]]) -> BentPoint {
    let mut shapes = Mat::zeros(12, columns.len());
    for (mode, column) in columns.iter().enumerate() {
        column.iter().for_each(|(row, value)| shapes[(*row, mode)] = *value);
    }
    BentPoint { shapes, ..point(20.0, 0.0, &[]) }
}

#[test]
fn modes_are_like_by_what_they_move_and_spins_count_over_a_chord() {
    let before = shaped(&[&[(2, 1.0)], &[(0, 1.0)], &[(1, 1.0)]]);
    // with a chord of .1 m four fifths of the motion are those of the other mode, the spin is the rest
    for size in [1.0, 0.1] {
        let turning = |row: usize, spin: usize| [(row, size), (spin, 5.0 * size)];
        let now = shaped(&[&turning(0, 3), &turning(2, 9), &[(1, size)]]);
        assert_eq!(like(&before, &now, 0.1), [1, 0, 2], "{size}");
        let now = shaped(&[&turning(0, 5), &turning(2, 10), &[(1, size)]]);
        assert_eq!(like(&before, &now, 0.1), [1, 0, 2], "{size}");
        // with a chord of 1 m they are spins, none of those before: what is left in order
        assert_eq!(like(&before, &now, 1.0), [0, 1, 2], "{size}");
    }
}

#[test]
fn modes_that_are_less_than_half_like_take_what_is_left_in_order() {
    let before = shaped(&[&[(2, 1.0)], &[(0, 1.0)], &[(1, 1.0)]]);
    let rest = |share: f64| (1.0 - share).sqrt();
    let mixed = |share: f64| {
        let (first, second) = ([(0, share.sqrt()), (7, rest(share))], [(2, share.sqrt()), (8, rest(share))]);
        like(&before, &shaped(&[&first, &second, &[(1, 1.0)]]), 0.1)
    };
    assert_eq!(mixed(0.45), [0, 1, 2]);
    assert_eq!(mixed(0.55), [1, 0, 2]);
}

fn neutral(wing: &LargeWing) -> Corrections {
    Corrections::neutral(wing.elastic.correctable.len())
}

fn task(wing: &LargeWing, alpha_rad: f64) -> BentFlutter<'_> {
    BentFlutter { wing, alpha_rad, rho_kg_m3: 1.225, modes: 2, damping_ratio: 0.0 }
}

/// The airspeed from which an oscillation grows, by points of their own (Illinois), with that point and the
/// oscillation's place.
fn onset(task: &BentFlutter<'_>) -> (f64, BentPoint, usize) {
    let neutral = neutral(task.wing);
    let most = |v: f64| {
        let point = task.point(v, &|_| neutral.clone(), None).expect("an equilibrium");
        let place = usize::from(point.roots[1].expect("a root").re > point.roots[0].expect("a root").re);
        let growth = point.roots[place].expect("a root").re;
        (growth, point, place)
    };
    let (mut slow, mut fast) = (60.0, 200.0);
    let (mut low, mut high) = (most(slow).0, most(fast).0);
    assert!(low < 0.0 && high > 0.0, "growth {low} at {slow} m/s, {high} at {fast} m/s");
    for _ in 0..20 {
        let v = slow + (fast - slow) * low / (low - high);
        let (growth, point, place) = most(v);
        if growth.abs() < 1e-3 {
            return (v, point, place);
        }
        if growth > 0.0 {
            (fast, high, low) = (v, growth, 0.5 * low);
        } else {
            (slow, low, high) = (v, growth, 0.5 * high);
        }
    }
    panic!("no onset between {slow} and {fast} m/s")
}

#[test]
fn a_sweep_finds_the_onset_of_growth_and_ends_where_the_wing_diverges() {
    let wing = goland();
    let task = task(&wing, 0.02);
    let (v_m_s, there, branch) = onset(&task);
    let oscillation = there.roots[branch].expect("a root");
    let neutral = neutral(&wing);
    let over = |airspeeds: &[f64]| task.over(airspeeds, &|_| neutral.clone()).expect("a sweep");
    // Goland's wing flutters from 137 m/s in strips (Goland and Luke, J. Appl. Mech., 1948)
    assert!((v_m_s / 137.0 - 1.0).abs() < 0.05, "{v_m_s} m/s");
    let sweep = over(&[0.5 * v_m_s, v_m_s - 9.0, v_m_s + 14.0, 500.0]);
    let [found] = sweep.crossings[..] else { panic!("{:?}", sweep.crossings) };
    assert!((found.v_m_s - v_m_s).abs() < ACCURACY_M_S && found.unstable, "{found:?} {v_m_s}");
    assert!((found.frequency_hz - oscillation.im / TAU).abs() < 0.01, "{found:?} {oscillation}");
    assert!(there.state.tip_m.z > 1e-3, "it bends");
    assert!((found.tip_z_m / there.state.tip_m.z - 1.0).abs() < 0.01, "{found:?} {}", there.state.tip_m.z);
    // a straight line between both ends misses by more
    let straight = change(&sweep.points[1], &sweep.points[2], found.branch).expect("a change");
    assert!((straight.v_m_s - v_m_s).abs() > 3.0 * ACCURACY_M_S, "{straight:?}");
    assert_eq!(sweep.points.len(), 3, "no equilibrium at the last airspeed");
    assert!(matches!(sweep.ended, Some(CouplingError::NotInEquilibrium { .. })));
    assert!(!sweep.is_unstable_from_the_start());
    for point in &sweep.points {
        assert!(point.omega_rad_s[0] < point.omega_rad_s[1] && point.omega_rad_s.len() == 2);
    }
    let above = over(&[v_m_s + 14.0, v_m_s + 20.0]);
    assert!(above.is_unstable_from_the_start() && above.crossings.is_empty() && above.ended.is_none());
    let down = over(&[v_m_s + 14.0, v_m_s - 9.0]);
    let [found] = down.crossings[..] else { panic!("{:?}", down.crossings) };
    assert!((found.v_m_s - v_m_s).abs() < ACCURACY_M_S && !found.unstable, "{found:?}");
}

/// Both ends made up so that a straight line between them leads to the root that is there, a tenth too fast: one
/// equilibrium of its own puts that right.
#[test]
fn a_crossing_is_mended_by_equilibria_of_its_own() {
    let wing = goland();
    let task = task(&wing, 0.0);
    let (v_m_s, there, branch) = onset(&task);
    let omega = there.roots[branch].expect("a root").im;
    let neutral = neutral(&wing);
    for (by, slow_root, fast_root) in [
        (-0.1, c64::new(-omega, 0.4 * omega), c64::new(3.0 * omega, 3.2 * omega)),
        (0.1, c64::new(-omega, 0.4 * omega), c64::new(3.0 * omega, 3.2 * omega)),
        // growth that ends
        (0.1, c64::new(omega, 0.4 * omega), c64::new(-3.0 * omega, 3.2 * omega)),
        (-0.1, c64::new(omega, 0.4 * omega), c64::new(-3.0 * omega, 3.2 * omega)),
    ] {
        let at = |v_m_s: f64, root: c64| {
            let mut point = there.clone();
            point.case.flow.v_m_s = v_m_s;
            point.roots = vec![None; 2];
            point.roots[branch] = Some(root);
            point
        };
        let (slow, fast) = (at(v_m_s + by - 10.0, slow_root), at(v_m_s + by + 30.0, fast_root));
        let calls = Cell::new(0);
        let corrections = |_: f64| {
            calls.set(calls.get() + 1);
            neutral.clone()
        };
        let first = change(&slow, &fast, branch).expect("a change");
        assert!((first.frequency_hz * TAU / omega - 1.1).abs() < 1e-9, "{first:?}");
        let found = task.crossing(&slow, &fast, branch, &corrections).expect("points").expect("a change");
        assert!((found.frequency_hz * TAU / omega - 1.0).abs() < 5e-3, "{by}: {found:?} {omega}");
        assert!((found.v_m_s - first.v_m_s).abs() < ACCURACY_M_S && found.unstable == (slow_root.re < 0.0));
        assert_eq!(calls.get(), 1, "it has not moved");
        let none = task.crossing(&slow, &slow, branch, &corrections).expect("nothing to find");
        assert!(none.is_none() && calls.get() == 1);
    }
}

#[test]
fn roots_are_taken_where_they_were_going_and_modes_by_their_shape() {
    let wing = goland();
    let task = task(&wing, 0.0);
    let neutral = neutral(&wing);
    let corrections = |_: f64| neutral.clone();
    let there = task.point(30.0, &corrections, None).expect("a point");
    let [first, second] = [0, 1].map(|i| there.roots[i].expect("a root"));
    let made_up = |v_m_s: f64, roots: [Option<c64>; 2]| {
        let mut point = there.clone();
        point.case.flow.v_m_s = v_m_s;
        point.roots = roots.to_vec();
        point.shapes = Mat::from_fn(there.shapes.nrows(), 2, |row, i| there.shapes[(row, 1 - i)]);
        point
    };
    let share = |root: c64, share: f64| Some(root * share);
    // three tenths in 5 m/s, six in the next 10
    let earlier = made_up(15.0, [share(second, 0.1), share(first, 0.1)]);
    let last = made_up(20.0, [share(second, 0.4), share(first, 0.4)]);
    let next = task.next(Some(&earlier), &last, 30.0, &corrections).expect("a point");
    assert_eq!(next.case.flow.v_m_s, 30.0);
    for (found, wanted) in next.roots.iter().zip([second, first]) {
        assert!((found.expect("followed") - wanted).norm() < 1e-6 * wanted.norm(), "{found:?} {wanted}");
    }
    for (i, other) in [(0, 1), (1, 0)] {
        assert!((next.omega_rad_s[i] / there.omega_rad_s[other] - 1.0).abs() < 1e-9);
        let apart = (0..there.shapes.nrows())
            .map(|row| next.shapes[(row, i)].abs() - there.shapes[(row, other)].abs())
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(apart < 1e-6 * there.shapes.norm_max(), "mode {i}: {apart:e}");
    }
    // without one before they stay, and what is lost stays lost
    let last = made_up(20.0, [share(second, 0.9), None]);
    let next = task.next(None, &last, 30.0, &corrections).expect("a point");
    assert!((next.roots[0].expect("followed") - second).norm() < 1e-6 * second.norm());
    assert_eq!(next.roots[1], None);
    assert!((wing.elastic.correctable.mean_chord_m() - CHORD_M).abs() < 1e-12);
}
