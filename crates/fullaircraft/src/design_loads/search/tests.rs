//! The search for worst gradients, with loads made by hand that are largest between the gradients of a family.

use super::{Family, gust, searched};
use crate::design_loads::instants::{FlownCase, FlownInstant};
use crate::flight::gust::{Gust, GustAxis};
use loads::design::{Attitude, Direction, Rules, Spectrum};
use loads::matrix::{Action, Case, Status};

pub(crate) fn case(number: usize, action: Action) -> Case {
    Case {
        number,
        kind: String::new(),
        mass: 0,
        h_m: 0.0,
        v_m_s: 50.0,
        v_eas_m_s: 50.0,
        mach: 0.1,
        n_z: 1.0,
        condition: String::new(),
        rule: Rules::Own,
        status: Status::Planned,
        why: String::new(),
        action,
    }
}

pub(crate) fn discrete(number: usize, gradient_m: f64, direction: Direction) -> Case {
    case(number, Action::Discrete { gradient_m, direction, u_ds_m_s: 8.0, refine: true })
}

/// Turbulence up to 20 Hz.
pub(crate) fn turbulence(number: usize) -> Case {
    let turbulence = Action::Turbulence {
        direction: Direction::Up,
        u_sigma_m_s: 1.0,
        scale_m: 762.0,
        cut_off_hz: 20.0,
        spectrum: Spectrum::Karman,
        attitude: Attitude::Stable,
        longest_gradient_m: 107.0,
    };
    case(number, turbulence)
}

/// An instant with net loads of one station.
fn instant(net: [f64; 6]) -> FlownInstant {
    let mut loads = [[0.0; 6]; 5];
    loads[4] = net;
    FlownInstant { t_s: 0.1, gradient_m: None, limit: None, tips_m: [0.0; 2], loads: vec![loads] }
}

fn flown(number: usize, net: &[[f64; 6]]) -> FlownCase {
    FlownCase { number, instants: net.iter().map(|net| instant(*net)).collect(), ..FlownCase::default() }
}

/// Fz by the gradient: a parabola over its logarithm with its top at 30 m; Mx rises and My falls all the way.
fn net(gradient_m: f64) -> [f64; 6] {
    let away = (gradient_m / 30.0).ln();
    [9e9, 9e9, 100.0 - away * away, gradient_m, -gradient_m, 9e9]
}

#[test]
fn the_next_gradient_is_the_top_of_a_parabola_over_the_logarithm_and_its_instants_are_kept() {
    let cases = [(3, 80.0), (5, 10.0), (4, 20.0), (9, 50.0)].map(|(n, m)| discrete(n, m, Direction::Up));
    let all: Vec<&Case> = cases.iter().collect();
    let mut rounds: Vec<Vec<(usize, f64)>> = Vec::new();
    let fly = &mut |gusts: &[(usize, Gust)]| {
        rounds.push(gusts.iter().map(|(number, gust)| (*number, 0.5 * gust.length_m)).collect());
        let one = |(number, gust): &(usize, Gust)| {
            let gradient_m = 0.5 * gust.length_m;
            (flown(*number, &[net(gradient_m)]), gradient_m)
        };
        Ok::<_, ()>(gusts.iter().map(one).collect())
    };
    let found = searched(&all, GustAxis::Vertical, fly).expect("nothing fails");
    assert_eq!(rounds[0], vec![(3, 80.0), (5, 10.0), (4, 20.0), (9, 50.0)]);
    assert_eq!(rounds.len(), 2);
    // 30 m is nearer to 20 m than to 50 m in ratio: 1.5 and 1.67
    assert_eq!(rounds[1].len(), 1);
    assert!(rounds[1][0].0 == 4 && (rounds[1][0].1 - 30.0).abs() < 1e-9, "{rounds:?}");
    let more: Vec<usize> =
        found.iter().filter(|case| case.instants.len() == 2).map(|case| case.number).collect();
    assert_eq!((more, found.len()), (vec![4], 4));
    let case = found.iter().find(|case| case.number == 4).expect("it is there");
    assert!((case.instants[1].gradient_m.expect("a gradient") - 30.0).abs() < 1e-9);
    assert_eq!(case.instants[0].gradient_m, None);
}

#[test]
fn a_family_with_a_case_that_was_refused_is_not_searched() {
    let cases = [10.0, 20.0, 50.0].map(|m| discrete(1, m, Direction::Up));
    let all: Vec<&Case> = cases.iter().collect();
    let mut rounds = 0;
    let fly = &mut |gusts: &[(usize, Gust)]| {
        rounds += 1;
        let refused = Some("unstable".to_owned());
        let one = |(_, gust): &(usize, Gust)| {
            (FlownCase { refused: refused.clone(), ..flown(1, &[[0.0; 6]]) }, 0.5 * gust.length_m)
        };
        Ok::<_, ()>(gusts.iter().map(one).collect())
    };
    assert_eq!(searched(&all, GustAxis::Vertical, fly).expect("nothing fails").len(), 3);
    assert_eq!(rounds, 1);
}

fn family(gradients_m: &[f64], net: impl Fn(f64) -> [f64; 6], axis: GustAxis) -> Family {
    let cases = gradients_m.iter().enumerate().map(|(at, m)| flown(at, &[net(*m)])).collect();
    Family::new(gradients_m.to_vec(), cases, axis)
}

#[test]
fn tops_within_a_twentieth_are_flown_once_at_the_middle_one() {
    // tops of Fz, Mx, My at 30 m and at shares of it, the smallest of Fz too: -Fz has its worst at an end
    let tops = |shares: [f64; 3]| {
        let net = move |m: f64| {
            let of = |share: f64| -(m / (30.0 * share)).ln().powi(2);
            [0.0, 0.0, of(shares[0]), of(shares[1]), of(shares[2]), 0.0]
        };
        family(&[10.0, 25.0, 36.0, 90.0], net, GustAxis::Vertical).next_m()
    };
    let same = |found: Vec<f64>, law: &[f64]| {
        assert!(found.len() == law.len(), "{found:?}");
        found.iter().zip(law).for_each(|(m, law)| assert!((m - law).abs() < 1e-9, "{found:?}"));
    };
    same(tops([1.0, 1.02, 1.04]), &[30.6]);
    same(tops([1.0, 1.02, 1.06]), &[30.6, 31.8]);
    same(tops([1.06, 1.0, 1.12]), &[30.0, 31.8, 33.6]);
    same(tops([1.0, 1.0, 1.049]), &[30.0]);
}

#[test]
fn ends_are_those_of_the_loads_that_a_gust_along_the_axis_drives() {
    let vertical = family(&[20.0, 10.0], net, GustAxis::Vertical);
    let ends: Vec<(usize, f64)> = vertical.ends().into_iter().map(|(_, load, sign)| (load, sign)).collect();
    assert_eq!(ends, vec![(2, 1.0), (2, -1.0), (3, 1.0), (3, -1.0), (4, 1.0), (4, -1.0)]);
    assert_eq!(vertical.gradients_m, vec![10.0, 20.0], "rising");
    assert_eq!(vertical.cases.iter().map(|case| case.number).collect::<Vec<_>>(), vec![1, 0]);
    assert_eq!(family(&[10.0], net, GustAxis::Lateral).loads, vec![1, 3, 5]);
    // nearest in ratio: the middle of 10 and 20 is their geometric mean, 14.14
    assert_eq!([vertical.nearest(14.0), vertical.nearest(14.3)], [Some(1), Some(0)]);
    assert_eq!([vertical.nearest(1.0), vertical.nearest(99.0)], [Some(1), Some(0)]);
    assert_eq!(family(&[], net, GustAxis::Vertical).nearest(1.0), None);
}

#[test]
fn of_found_instants_those_are_kept_that_raise_an_end_and_of_an_end_the_furthest() {
    let start = || family(&[10.0, 20.0], |_| [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], GustAxis::Vertical);
    let fz = |up: f64| instant([0.0, 0.0, up, 0.0, 0.0, 0.0]);
    let count = |found: Vec<(usize, FlownInstant)>| -> Vec<usize> {
        start().with(found).iter().map(|case| case.instants.len()).collect()
    };
    assert_eq!(count(vec![(0, fz(1.0)), (1, fz(1.0))]), vec![1, 1], "the same raises nothing");
    assert_eq!(count(vec![(0, fz(1.5)), (1, fz(2.0))]), vec![1, 2], "the larger");
    assert_eq!(count(vec![(0, fz(0.5)), (1, fz(2.0))]), vec![2, 2], "both ends");
    assert_eq!(count(vec![(0, instant([5.0, 5.0, 1.0, 0.0, 0.0, 5.0]))]), vec![1, 1], "no load of the axis");
}

#[test]
fn a_gust_of_another_gradient_has_the_velocity_of_its_sixth_root() {
    // CS-25.341(a)(4): U_ds = U_ref F_g (H/107)^(1/6)
    let up = gust(&discrete(1, 10.0, Direction::Up), None).expect("a gust");
    assert_eq!(up, Gust { velocity_m_s: 8.0, length_m: 20.0, start_s: 0.0 });
    let longer = gust(&discrete(1, 10.0, Direction::Down), Some(640.0)).expect("a gust");
    assert!((longer.velocity_m_s + 16.0).abs() < 1e-12 && longer.length_m == 1280.0, "{longer:?}");
    let side = gust(&discrete(1, 10.0, Direction::Lateral), None).expect("a gust");
    assert_eq!(side.velocity_m_s, 8.0);
    assert_eq!(gust(&case(1, Action::Trim), None), None);
}
