//! Large deflections against closed forms and published tables.

#![expect(clippy::format_push_string, reason = "decks written card by card")]

use crate::common::system;
use crate::large::{beam_along_x, elastica, force, large, moment, numbers, path, published, share_off};
use nalgebra::Vector3;
use structure::nonlinear::{Controls, Loads};

#[test]
fn sixteen_beams_bend_as_the_elastica_and_the_error_falls_with_the_square() {
    let error = |count: usize| {
        let deck = beam_along_x(count, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n";
        let wing = large(&deck);
        // E I = 100.
        let loads = Loads { dead: vec![force(count, [0.0, 0.0, 10.0])], ..Loads::default() };
        let (alphas, u, w) = elastica();
        let stops: Vec<f64> = alphas.iter().map(|alpha| alpha / 10.0).collect();
        let path = wing
            .path(&wing.undeformed(), &Loads::default(), &loads, &Controls { stops, ..Controls::default() })
            .unwrap();
        let mut largest: f64 = 0.0;
        for (at, alpha) in alphas.iter().enumerate() {
            let place = path.at(alpha / 10.0).unwrap().state.places[count];
            let (own_u, own_w) = (1.0 - place.x / 10.0, place.z / 10.0);
            println!("{count} beams, alpha {alpha}: {own_u:.6} {:.6}, {own_w:.6} {:.6}", u[at], w[at]);
            largest = largest.max(share_off(own_w, w[at])).max(share_off(own_u, u[at]));
        }
        println!("iterations {}", path.points.iter().map(|p| p.iterations).sum::<usize>());
        largest
    };
    let (coarse, fine) = (error(8), error(16));
    assert!(coarse < 5e-3 && fine < 1.5e-3, "8 beams {coarse:e}, 16 beams {fine:e}");
    assert!((coarse / fine - 4.0).abs() < 0.8, "the error falls with the square: {}", coarse / fine);
}

#[test]
fn an_end_moment_rolls_a_cantilever_up_to_a_circle() {
    let deck = beam_along_x(20, 12.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n";
    let wing = large(&deck);
    let full = 50.0 * std::f64::consts::PI / 3.0;
    let loads = Loads { dead: vec![moment(20, [0.0, -full, 0.0])], ..Loads::default() };
    let stops = vec![0.25, 0.5, 0.75, 1.0];
    let controls = Controls { stops, ..Controls::default() };
    let path = wing.path(&wing.undeformed(), &Loads::default(), &loads, &controls).unwrap();
    for share in [0.25, 0.5, 0.75, 1.0] {
        let angle = 2.0 * std::f64::consts::PI * share;
        let radius = 12.0 / angle;
        let circle = Vector3::new(radius * angle.sin(), 0.0, radius * (1.0 - angle.cos()));
        // Straight elements of unchanged length, each turned against the last by the same angle.
        let side = |k: usize| angle * (k as f64 + 0.5) / 20.0;
        let polygon: Vector3<f64> =
            (0..20).map(|k| Vector3::new(side(k).cos(), 0.0, side(k).sin()) * (12.0 / 20.0)).sum();
        let place = path.at(share).unwrap().state.places[20];
        assert!((place - circle).norm() < 0.01, "the circle at {share}: {place} for {circle}");
        assert!((place - polygon).norm() < 1e-7, "the polygon at {share}: {place} for {polygon}");
    }
}

#[test]
fn small_loads_give_the_linear_answer_and_the_difference_falls_in_proportion() {
    let deck = beam_along_x(6, 2.0, 7e10, [0.01, 0.02])
        + "GRID,20,,2.0,0.3,0.1\nRBE2,1,7,123456,20\nSPC1,1,123456,1\n";
    let wing = large(&deck);
    let linear = crate::common::displaced(&system(&deck), &[(20, 3, 1.0), (20, 1, 2.0)]);
    let difference = |factor: f64| {
        let loads = Loads { dead: vec![force(7, [2.0 * factor, 0.0, factor])], ..Loads::default() };
        let moved = path(&wing, &loads).end().state.displacements(wing.nodes());
        let square: f64 = moved.iter().enumerate().map(|(i, u)| (u / factor - linear[(i, 0)]).powi(2)).sum();
        square.sqrt() / linear.norm_l2()
    };
    let (large, small) = (difference(1e-3), difference(1e-4));
    println!("difference from the linear answer: {large:e} {small:e}");
    assert!(small < 1e-5, "{small:e}");
    assert!((large / small - 10.0).abs() < 0.5, "in proportion to the load: {large:e} {small:e}");
}

#[test]
fn a_bend_of_45_degrees_goes_out_of_its_plane_as_published() {
    let count = 16;
    let mut deck = String::from("MAT1,1,1.+7,5.+6,,1.0\nPBAR,1,1,1.,.0833333333,.0833333333,.1406\n");
    for node in 0..=count {
        let angle = std::f64::consts::FRAC_PI_4 * node as f64 / count as f64;
        let (x, z) = (100.0 * angle.sin(), 100.0 * (1.0 - angle.cos()));
        deck += &format!("GRID,{},,{x:.9},0.,{z:.9}\n", node + 1);
    }
    for grid in 1..=count {
        deck += &format!("CBAR,{grid},1,{grid},{},0.,1.,0.\n", grid + 1);
    }
    let wing = large(&(deck + "SPC1,1,123456,1\n"));
    let loads = Loads { dead: vec![force(count, [0.0, 600.0, 0.0])], ..Loads::default() };
    let controls = Controls { stops: vec![0.5, 0.75, 1.0], ..Controls::default() };
    let path = wing.path(&wing.undeformed(), &Loads::default(), &loads, &controls).unwrap();
    println!(
        "45 degrees: {:?}",
        path.points.iter().map(|p| (p.load_factor, p.iterations)).collect::<Vec<_>>()
    );
    // Bathe and Bolourchi (1979); the converged values of an independent program with the same torsion constant.
    let case = published("nl_beam__bathe_bolourchi_45");
    for load in [300.0, 450.0, 600.0] {
        let state = &path.at(load / 600.0).unwrap().state;
        let moved = state.places[count] - wing.nodes()[count].point.coords;
        let expected = numbers(&case["expected"]["own_J_0.1406_64_beams"][format!("{load}")]);
        let expected = Vector3::from_vec(expected);
        println!("{load}: {:.3} {:.3} {:.3} for {expected:?}", moved.x, moved.y, moved.z);
        assert!((moved - expected).norm() < 0.003 * expected.norm(), "{load}: {moved} for {expected}");
    }
}
