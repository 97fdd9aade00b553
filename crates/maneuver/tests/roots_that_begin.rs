//! Complete lists of p-k roots: which crossings they name, where branches are, and roots that begin in the air.

use aero::Flow;
use faer::{Mat, c64};
use maneuver::flutter::{Aeroelastic, Branch, CompleteCurves, Crossing, FormulaForces, Root};

fn flow(v_m_s: f64) -> Flow {
    Flow { v_m_s, rho_kg_m3: 1.2 }
}

#[test]
fn flutter_oscillates_and_divergence_does_not_and_both_become_unstable() {
    let crossing = |v_m_s: f64, omega_rad_s: f64, unstable: bool| Crossing {
        branch: 0,
        flow: flow(v_m_s),
        omega_rad_s,
        unstable,
        beyond_table: false,
    };
    let of = |crossings: Vec<Crossing>| CompleteCurves {
        flows: Vec::new(),
        branches: Vec::new(),
        crossings,
        begun_unstable: Vec::new(),
    };
    let (ends, converges) = (crossing(10.0, 5.0, false), crossing(11.0, 0.0, false));
    let (flutter, divergence) = (crossing(12.0, 6.0, true), crossing(13.0, 0.0, true));
    let all = of(vec![ends, converges, flutter, divergence]);
    assert_eq!((all.flutter(), all.divergence()), (Some(&flutter), Some(&divergence)));
    let other = of(vec![ends, converges, divergence, flutter]);
    assert_eq!((other.flutter(), other.divergence()), (Some(&flutter), Some(&divergence)));
    let none = of(vec![ends, converges]);
    assert!(none.flutter().is_none() && none.divergence().is_none());
    let root = |re: f64| Root { p: c64::from(re), beyond_table: false };
    let branch = Branch { first: 2, roots: vec![root(1.0), root(3.0)] };
    let found: Vec<Option<f64>> = (0..5).map(|place| branch.at(place).map(|root| root.p.re)).collect();
    assert_eq!(found, [None, None, Some(1.0), Some(3.0), None]);
}

/// A coordinate without stiffness that the air pushes away, p² = q a, beside one of 10 rad/s: below .01 1/s it is at
/// rest.
#[test]
fn a_root_that_begins_unstable_behind_the_first_flow_is_named() {
    let formula =
        |_: f64| Mat::from_fn(2, 2, |i, j| if (i, j) == (0, 0) { c64::from(1e-6) } else { c64::default() });
    let air = FormulaForces { size: 2, range: (0.0, 1e3), formula };
    let system = Aeroelastic::of_modes(&[0.0, 10.0], 0.02, &air).expect("two coordinates");
    let speed = |v: f64| (0.6 * v * v * 1e-6).sqrt();
    assert!(speed(5.0) < 0.01 && speed(30.0) > 0.01);
    let curves = system.pk_complete(&[flow(5.0), flow(30.0), flow(40.0)]).expect("roots");
    let firsts: Vec<usize> = curves.branches.iter().map(|branch| branch.first).collect();
    assert_eq!((firsts, curves.begun_unstable), (vec![0, 1, 1], vec![2]));
    for (branch, sign) in curves.branches[1..].iter().zip([-1.0, 1.0]) {
        for (place, v) in [(1, 30.0), (2, 40.0)] {
            let p = branch.at(place).expect("a root").p;
            assert!((p.re - sign * speed(v)).abs() < 1e-9 && p.im == 0.0, "{v} m/s: {p}");
        }
    }
    assert!(curves.crossings.is_empty() && curves.branches[0].roots.len() == 3);
    let later = system.pk_complete(&[flow(30.0), flow(40.0)]).expect("roots");
    assert!(later.begun_unstable.is_empty() && later.branches.iter().all(|branch| branch.first == 0));
    assert_eq!(later.branches.len(), 3);
}
