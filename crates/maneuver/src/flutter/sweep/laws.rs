//! Uncoupled coordinates whose air is apparent mass and damping: roots in closed form, and how often the air is asked.

use super::super::GeneralisedForces;
use super::*;
use aero::Flow;
use std::cell::RefCell;

const V: f64 = 10.0;
const PLACE: Place = Place { flow: Flow { v_m_s: V, rho_kg_m3: 1.2 }, share: 1.0 };

/// Q = r kappa² - i kappa d on each coordinate, and a stiffness that is taken away; every frequency that is asked for.
struct Air {
    by: Vec<[f64; 3]>,
    asked: RefCell<Vec<f64>>,
}

impl Air {
    fn new(by: &[[f64; 3]]) -> Self {
        Self { by: by.to_vec(), asked: RefCell::default() }
    }

    fn calls(&self, of: impl FnOnce()) -> usize {
        self.asked.borrow_mut().clear();
        of();
        self.asked.borrow().len()
    }
}

impl GeneralisedForces for Air {
    fn size(&self) -> usize {
        self.by.len()
    }

    fn range(&self) -> (f64, f64) {
        (0.0, 100.0)
    }

    fn at(&self, kappa: f64, _v_m_s: f64) -> Result<Mat<c64>, FlutterError> {
        self.asked.borrow_mut().push(kappa);
        Ok(Mat::from_fn(self.by.len(), self.by.len(), |i, j| {
            let [r, d, taken] = self.by[i];
            if i == j { c64::new(taken + r * kappa * kappa, -d * kappa) } else { c64::default() }
        }))
    }
}

/// Roots of p² + c p + w² - q taken, c = q d/V, with the mass 1 + r rho/2 where it oscillates.
fn closed_form(omega: f64, [r, d, taken]: [f64; 3]) -> Vec<c64> {
    let (c, stiffness) = (60.0 * d / V, omega * omega - 60.0 * taken);
    let square = stiffness - 0.25 * c * c;
    if square > 0.0 {
        vec![c64::new(-0.5 * c, (square / (1.0 + 0.6 * r)).sqrt())]
    } else {
        let rest = (-square).sqrt();
        vec![c64::from(-0.5 * c - rest), c64::from(-0.5 * c + rest)]
    }
}

fn assert_roots(found: &[State], wanted: &[c64]) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (state, wanted) in found.iter().zip(wanted) {
        assert!((state.p - wanted).norm() < 1e-8 * wanted.norm(), "{} {wanted}", state.p);
        assert_eq!(state.real, wanted.im == 0.0);
    }
}

#[test]
fn all_roots_are_found_without_a_start_and_known_ones_are_taken_as_they_are() {
    let omega = [5.0, 12.0, 30.0, 3.0, 33.0];
    let air =
        Air::new(&[[0.5, 0.2, 0.0], [1.0, 0.4, 0.3], [0.0, 0.1, 0.0], [0.2, 2.0, 0.0], [0.4, 0.3, 0.0]]);
    let system = Aeroelastic::of_modes(&omega, 0.0, &air).expect("five coordinates");
    let mut wanted: Vec<c64> = omega.iter().zip(&air.by).flat_map(|(w, by)| closed_form(*w, *by)).collect();
    wanted.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    let found = system.all_roots(PLACE, &[]).expect("all roots");
    assert_roots(&found, &wanted);
    // with all of them known the air is asked at rest (twice) and at each look alone
    let known: Vec<&State> = found.iter().collect();
    let calls = air.calls(|| assert_roots(&system.all_roots(PLACE, &known).expect("all roots"), &wanted));
    assert_eq!(calls, 2 + LOOKS as usize);
    // squares of equal steps, to half as much again as the fastest with the air at rest
    let fastest = system.held_at(0.0, PLACE).expect("eigenvalues")[0].p.im;
    for (look, kappa) in (1..=LOOKS).zip(&air.asked.borrow()[2..]) {
        let share = f64::from(look) / 32.0;
        assert!((kappa - 1.5 * fastest / V * share * share).abs() < 1e-12 * fastest, "{look}: {kappa}");
    }
    // one that is not among the known is found
    for left_out in 2..known.len() {
        let mut some = known.clone();
        some.remove(left_out);
        assert_roots(&system.all_roots(PLACE, &some).expect("all roots"), &wanted);
    }
}

#[test]
fn a_root_slower_than_a_thousandth_of_the_slowest_mode_is_at_rest() {
    // q is 60 Pa: what is left of a stiffness of 25
    for (left, count) in [(0.004_f64, 1), (0.006, 2)] {
        let air = Air::new(&[[0.0, 0.0, (25.0 - left * left) / 60.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.0]]);
        let system = Aeroelastic::of_modes(&[5.0, 9.0, 0.0], 0.0, &air).expect("three coordinates");
        let found = system.all_roots(PLACE, &[]).expect("all roots");
        assert_eq!(found.len(), count, "{left}: {found:?}");
        assert!((found[count - 1].p - closed_form(9.0, air.by[1])[0]).norm() < 1e-8);
        if count == 2 {
            assert!((found[0].p - c64::new(0.0, left)).norm() < 1e-6, "{}", found[0].p);
        }
        // one that has lost more than all diverges
        let gone = Air::new(&[[0.0, 0.0, (25.0 + left * left) / 60.0]]);
        let system = Aeroelastic::of_modes(&[5.0], 0.0, &gone).expect("one coordinate");
        let found: Vec<f64> = system.all_roots(PLACE, &[]).expect("roots").iter().map(|s| s.p.re).collect();
        assert_eq!(found.len(), 2 * (count - 1), "{found:?}");
        assert!(found.iter().zip([-left, left]).all(|(a, b)| (a - b).abs() < 1e-6), "{found:?}");
    }
}

#[test]
fn a_root_is_closed_in_on_between_two_frequencies_and_not_taken_from_elsewhere() {
    let air = Air::new(&[[1.0, 0.2, 0.0], [0.0, 0.1, 0.0]]);
    let system = Aeroelastic::of_modes(&[12.0, 3.0], 0.0, &air).expect("two coordinates");
    let root = closed_form(12.0, air.by[0])[0];
    let kappa = root.im / V;
    let bracket = |low: f64, high: f64| Bracket { kappas: [low, high], rank: 0, is_above: true };
    let other =
        State { p: closed_form(3.0, air.by[1])[0], u: vec![c64::default(); 2], real: false, beyond: false };
    let close = |kappas: [f64; 2], known: &[State]| {
        let mut found = None;
        let calls = air.calls(|| {
            found = Some(system.closed_in(bracket(kappas[0], kappas[1]), PLACE, known).expect("a state"));
        });
        (found.expect("a state"), calls)
    };
    // Newton's method is there from the first or second middle
    let (found, calls) = close([0.4 * kappa, 1.9 * kappa], std::slice::from_ref(&other));
    assert!((found.p - root).norm() < 1e-9 && calls < 40, "{} {root}, {calls}", found.p);
    // where that root is known already halving alone leads there
    let (again, calls) = close([0.4 * kappa, 1.9 * kappa], std::slice::from_ref(&found));
    assert!((again.p - root).norm() < 1e-9 && calls >= HALVINGS, "{} {root}, {calls}", again.p);
    // outside of the bracket it is not it
    for kappas in [[0.2 * kappa, 0.6 * kappa], [1.4 * kappa, 1.9 * kappa]] {
        let (found, _) = close(kappas, &[]);
        assert!((found.p - root).norm() > 0.1, "{kappas:?}: {}", found.p);
    }
    // the state of the largest frequency does not oscillate: below every kappa
    let stiff = Air::new(&[[0.0, 30.0, 0.0]]);
    let damped = Aeroelastic::of_modes(&[1.0], 0.0, &stiff).expect("one coordinate");
    assert!(damped.closed_in(bracket(0.1, 0.2), PLACE, &[]).is_err());
}
