//! One load step, beside the truss of two rods whose way is known in closed form.

use super::*;
use crate::model::Model;
use crate::nonlinear::{Loads, NodeLoad};
use nalgebra::{Rotation3, Vector3};

/// Two rods over a span of two, rise 0.2, E A = 1000.
fn truss() -> LargeDeflection {
    let deck = "GRID,1,,-1.,0.,0.\nGRID,2,,0.,0.,.2\nGRID,3,,1.,0.,0.\nCROD,1,1,1,2\nCROD,2,1,2,3\n\
        PROD,1,1,1.\nMAT1,1,1000.,,.3\nSPC1,1,123,1,3\n";
    let bulk = nastran::parse_deck("test.bdf", deck).expect("a deck");
    LargeDeflection::new(&Model::from_bulk(&bulk).expect("a model")).expect("a structure")
}

fn down(newton: f64) -> Loads {
    let load = NodeLoad { node: 1, force: Vector3::new(0.0, 0.0, -newton), moment: Vector3::zeros() };
    Loads { dead: vec![load], ..Loads::default() }
}

/// Force downwards and its slope at a height z: rods of the length l from l0, each with E A (l - l0) / l0 along itself.
fn resistance(z: f64) -> (f64, f64) {
    let (l0, l) = (1.0_f64.hypot(0.2), 1.0_f64.hypot(z));
    (2000.0 * (1.0 / l - 1.0 / l0) * z, 2000.0 * (1.0 / l0 - 1.0 / l.powi(3)))
}

#[test]
fn a_truss_goes_where_its_closed_form_says() {
    let truss = truss();
    let (z, mut work) = (0.15, 0.0);
    let newton = resistance(z).0;
    let found = converge(&truss, &truss.undeformed(), &down(newton), &mut work);
    let Ok(found) = found else { panic!("an equilibrium") };
    assert!((found.state.places[1].z - z).abs() < 1e-9, "{}", found.state.places[1].z);
    assert_eq!((found.negative, found.overshoot), (0, 0.0));
    // The first step's work is P^2 / K of the undeformed truss.
    let expected = newton * newton / resistance(0.2).1;
    assert!((work / expected - 1.0).abs() < 1e-9, "{work} for {expected}");
    // A smaller step later does not make it less.
    let again = converge(&truss, &found.state, &down(newton + 1e-3), &mut work);
    assert!(again.is_ok() && (work / expected - 1.0).abs() < 1e-9);
}

/// From one side to the other: the work of the load on its way over the mean of what both ends' stiffnesses say.
#[test]
fn a_way_across_a_limit_is_longer_than_the_stiffnesses_at_its_ends_say() {
    let truss = truss();
    let (mut snapped, mut crossed) = (0, 0);
    for z in [-0.235, -0.24, -0.25, -0.27, -0.3, -0.33, -0.36, -0.4, -0.45, -0.5] {
        let newton = resistance(z).0;
        let Ok(found) = converge(&truss, &truss.undeformed(), &down(newton), &mut 0.0) else { continue };
        snapped += 1;
        assert!((found.state.places[1].z - z).abs() < 1e-9, "{}", found.state.places[1].z);
        let mean = 0.5 * newton * newton * (1.0 / resistance(0.2).1 + 1.0 / resistance(z).1);
        let expected = newton * (0.2 - z) / mean;
        let own = found.overshoot;
        assert!(own == 0.0 || (own / expected - 1.0).abs() < 1e-6, "{own} for {expected}");
        assert_eq!(found.negative, 0, "beyond the snap it is stable");
        crossed += usize::from(own > 0.0);
    }
    assert!(snapped > 1 && crossed > 0, "{snapped} snap through, {crossed} by way of unstable states");
}

#[test]
fn an_unstable_equilibrium_has_a_negative_pivot() {
    let truss = truss();
    // Between the limits the truss pushes back ever less.
    let (z, mut start) = (0.02, truss.undeformed());
    let (newton, slope) = resistance(z);
    assert!(slope < 0.0);
    start.places[1].z = z + 1e-3;
    let Ok(found) = converge(&truss, &start, &down(newton), &mut 0.0) else { panic!("an equilibrium") };
    assert!((found.state.places[1].z - z).abs() < 1e-9 && found.negative == 1);
}

#[test]
fn a_step_that_turns_by_more_than_a_linear_answer_can_ends_at_once() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCBAR,1,1,1,2,0.,0.,1.\nPBAR,1,1,1.,1.,1.,1.\nMAT1,1,1.,.5\n\
        SPC1,1,123456,1\n";
    let bulk = nastran::parse_deck("test.bdf", deck).expect("a deck");
    let beam = LargeDeflection::new(&Model::from_bulk(&bulk).expect("a model")).expect("a structure");
    // The end turns by M L / E I.
    let bent = |moment: f64| {
        let load = NodeLoad { node: 1, force: Vector3::zeros(), moment: Vector3::new(0.0, 0.0, moment) };
        converge(&beam, &beam.undeformed(), &Loads { dead: vec![load], ..Loads::default() }, &mut 0.0)
    };
    let Err(failed) = bent(1.51) else { panic!("too far") };
    assert_eq!((failed.iterations, failed.negative), (1, 0));
    let Ok(found) = bent(1.49) else { panic!("an equilibrium") };
    assert!((found.state.rotations[1].angle() - 1.49).abs() < 1e-9 && found.iterations > 1);
}

#[test]
fn sizes_of_motions_and_structures_are_lengths_of_vectors() {
    let motion = [3.0, 0.0, 4.0, 0.1, 0.0, 0.0, 0.0, -2.0, 0.0, 0.2, 0.2, -0.1];
    assert_eq!(largest(&motion), (5.0, 0.2_f64.hypot(0.2).hypot(0.1)));
    assert_eq!(largest(&[0.0; 6]), (0.0, 0.0));
    assert!(largest(&[f64::NAN; 6]).0.is_nan());
    let torn = [[f64::NAN; 6], [1.0; 6]];
    for motion in [torn.concat(), [torn[1], torn[0]].concat()] {
        let (shift, spin) = largest(&motion);
        assert!(shift.is_nan() && spin.is_nan(), "{motion:?}: {shift}, {spin}");
    }
    let places =
        vec![Vector3::new(1.0, 2.0, -1.0), Vector3::new(4.0, 2.0, 3.0), Vector3::new(2.0, 14.0, 0.0)];
    let state = State { rotations: vec![Rotation3::identity(); 3], places };
    assert!((extent(&state) - 13.0).abs() < 1e-12, "3, 12 and 4: {}", extent(&state));
}
