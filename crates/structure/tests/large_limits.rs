//! Loads that cannot be carried, parts that cannot turn, loads that follow.

use crate::large::{beam_along_x, force, large, model};
use nalgebra::Vector3;
use structure::nonlinear::{Following, LargeDeflection, Loads, NonlinearError};

#[test]
fn a_shallow_truss_carries_its_limit_load_and_no_more() {
    // Two rods over a span of two, rise 0.2: P = 2 E A (sin t - cos t0 tan t), greatest where cos^3 t = cos t0.
    let deck = "GRID,1,,-1.,0.,0.\nGRID,2,,0.,0.,.2\nGRID,3,,1.,0.,0.\nCROD,1,1,1,2\nCROD,2,1,2,3\n\
        PROD,1,1,1.\nMAT1,1,1000.,,.3\nSPC1,1,123,1,3\n";
    let truss = large(deck);
    let cos0 = 1.0 / 1.0_f64.hypot(0.2);
    let t = cos0.cbrt().acos();
    let limit = 2000.0 * (t.sin() - cos0 * t.tan());
    let under =
        |newton: f64| truss.under(&Loads { dead: vec![force(1, [0.0, 0.0, -newton])], ..Loads::default() });
    let carried = under(0.999 * limit).unwrap();
    assert_eq!(carried.end().negative_pivots, Some(0), "below the limit it is stable");
    // However far beyond, it must not arrive at the truss that has snapped through.
    for beyond in [1.02, 1.1, 1.25, 1.5, 2.0, 3.0] {
        let error = under(beyond * limit).expect_err("more than it carries");
        println!("{beyond} times the limit: {error}");
        let reached = match error {
            NonlinearError::Stalled { load_factor, .. } | NonlinearError::Unstable { load_factor, .. } => {
                load_factor
            }
            other => panic!("{other}"),
        };
        assert!((beyond * reached - 1.0).abs() < 4e-3, "{beyond}: {} of the limit", beyond * reached);
    }
}

#[test]
fn a_column_buckles_at_eulers_load_with_its_mode() {
    let column = large(&(beam_along_x(8, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n"));
    // pi^2 E I / 4 L^2 about the weak axis, E I = 100.
    let euler = std::f64::consts::PI.powi(2) / 4.0;
    let load = Loads { dead: vec![force(8, [-2.0 * euler, 0.0, 0.0])], ..Loads::default() };
    let error = column.under(&load).unwrap_err();
    println!("{error}");
    let NonlinearError::Unstable { load_factor, unstable, grid, component, mode } = error else {
        panic!("{error}")
    };
    let critical = load_factor + unstable;
    assert!((critical - 1.0).abs() < 3e-3, "twice Euler's load applied, {critical} carried");
    assert_eq!((grid, component), (9, 3), "the tip moves most, across the thin side");
    // 1 - cos(pi x / 2 L)
    let middle = 1.0 - std::f64::consts::FRAC_PI_4.cos();
    assert!((mode[6 * 4 + 2] / mode[6 * 8 + 2] - middle).abs() < 0.01, "the mode: {}", mode[6 * 4 + 2]);
}

/// Arm of the force over length at each place, from the end: EI phi' = P x, x' = cos phi, by Runge and Kutta's rule in the
/// frame of the end. Place of the end relative to the root, in the root's frame.
fn following_elastica(alpha: f64) -> [f64; 2] {
    let steps = 4000;
    let h = 1.0 / f64::from(steps);
    let rate = |[phi, x, _]: [f64; 3]| [alpha * x, phi.cos(), phi.sin()];
    let mut y = [0.0; 3];
    for _ in 0..steps {
        let ahead = |k: [f64; 3], by: f64| [0, 1, 2].map(|i| y[i] + by * k[i]);
        let k1 = rate(y);
        let k2 = rate(ahead(k1, 0.5 * h));
        let k3 = rate(ahead(k2, 0.5 * h));
        let k4 = rate(ahead(k3, h));
        y = [0, 1, 2].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    // In the frame of the end the root is at (-x, -z'), turned by -phi.
    let [phi, x, z] = y;
    [x * phi.cos() + z * phi.sin(), x * phi.sin() - z * phi.cos()]
}

#[test]
fn a_force_that_turns_with_the_end_bends_it_as_the_differential_equation_says() {
    let wing = large(&(beam_along_x(32, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n"));
    for alpha in [1.0, 4.0, 8.0] {
        let following = vec![Following::Node(force(32, [0.0, 0.0, alpha]))];
        let path = wing.under(&Loads { following, ..Loads::default() }).unwrap();
        let (end, [x, z]) = (path.end().state.places[32] / 10.0, following_elastica(alpha));
        let iterations: usize = path.points.iter().map(|p| p.iterations).sum();
        println!("alpha {alpha}: {:.5} {:.5} for {x:.5} {z:.5}, {iterations} iterations", end.x, end.z);
        assert!((end.x - x).hypot(end.z - z) < 1.5e-3, "alpha {alpha}: {end} for {x}, {z}");
    }
}

#[test]
fn what_cannot_turn_is_refused_by_name() {
    let beam = beam_along_x(4, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\nGRID,9,,10.,0.,0.\n";
    let bent = Loads { dead: vec![force(4, [0.0, 0.0, 2.0])], ..Loads::default() };
    let slightly = Loads { dead: vec![force(4, [0.0, 0.0, 0.1])], ..Loads::default() };
    for (cards, owner) in [
        ("MPC,1,9,5,1.,5,5,-1.\n", "MPC of set 1"),
        ("CELAS2,77,5.,5,5,4,5\n", "element 77"),
        ("RBE2,8,5,1235,9\n", "RBE2 8"),
    ] {
        let wing = large(&(beam.clone() + cards));
        assert!(wing.under(&slightly).is_ok(), "{owner} holds for small rotations");
        let error = wing.under(&bent).unwrap_err();
        println!("{error}");
        assert!(matches!(&error, NonlinearError::Turned { owner: own, .. } if own == owner), "{error}");
    }
    let general = "GENEL,5,,5,3,5,5\n,Z,.1,0.,.1\n";
    let error = LargeDeflection::new(&model(&(beam.clone() + general))).unwrap_err();
    println!("{error}");
    assert!(error.to_string().contains("GENEL 5"), "{error}");
    let loose = large(&beam.replace("SPC1,1,123456,1\n", "SPC1,1,123,1\n"));
    let error = loose.under(&slightly).unwrap_err();
    println!("{error}");
    assert!(matches!(error, NonlinearError::Singular(_)), "{error}");
}

#[test]
fn a_difference_of_displacements_is_exact_at_any_rotation() {
    // The bar hangs on three equations; the same bar held there by a shared grid.
    let beam = beam_along_x(4, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n";
    let tied = beam.clone()
        + "GRID,9,,10.,0.,0.\nGRID,10,,10.,5.,0.\nCROD,9,9,9,10\nPROD,9,1,.001\nSPC1,1,123,10\n\
           MPC,1,9,1,1.,5,1,-1.\nMPC,1,9,2,1.,5,2,-1.\nMPC,1,9,3,1.,5,3,-1.\n";
    let shared = beam + "GRID,10,,10.,5.,0.\nCROD,9,9,5,10\nPROD,9,1,.001\nSPC1,1,123,10\n";
    let load = Loads { dead: vec![force(4, [-1.0, 0.0, 4.0])], ..Loads::default() };
    let end = |deck: &str| -> Vector3<f64> { large(deck).under(&load).unwrap().end().state.places[4] };
    let (one, other) = (end(&tied), end(&shared));
    assert!((one - other).norm() < 1e-9, "{one} {other}");
    assert!((one - Vector3::new(10.0, 0.0, 0.0)).norm() > 1.0, "it turns far: {one}");
}
