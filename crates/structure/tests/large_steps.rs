//! Load steps: how they grow, halve and end, where a path is judged, and what it says of its points.

use crate::large::{beam_along_x, force, large, moment};
use structure::nonlinear::{
    Acting, Controls, Following, LargeDeflection, Loads, NonlinearError, Path, differenced, moments_across,
};

/// A cantilever of four bars, 10 m long, E I = 100 N m^2 about y and 10 000 about z.
fn cantilever(cards: &str) -> LargeDeflection {
    large(&(beam_along_x(4, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n" + cards))
}

fn dead(load: structure::nonlinear::NodeLoad) -> Loads {
    Loads { dead: vec![load], ..Loads::default() }
}

fn walked(wing: &LargeDeflection, loads: &Loads, controls: &Controls) -> Result<Path, NonlinearError> {
    wing.path(&wing.undeformed(), &Loads::default(), loads, controls)
}

fn factors(path: &Path) -> Vec<f64> {
    path.points.iter().map(|point| point.load_factor).collect()
}

#[track_caller]
fn near(own: &[f64], expected: &[f64]) {
    assert_eq!(own.len(), expected.len(), "{own:?} for {expected:?}");
    assert!(own.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{own:?} for {expected:?}");
}

/// Half as much again after every step that took few iterations; what is left over is never a sliver.
#[test]
fn steps_grow_by_a_half_where_they_are_easy() {
    let (wing, loads) = (cantilever(""), dead(force(4, [0.0, 0.0, 0.001])));
    let of = |stops: &[f64], first_step: f64| {
        let path =
            walked(&wing, &loads, &Controls { stops: stops.to_vec(), first_step, ..Controls::default() });
        path.expect("an easy load")
    };
    near(&factors(&of(&[], 0.2)), &[0.2, 0.5, 0.95, 1.0]);
    near(&factors(&of(&[1.0], 1.0)), &[1.0]);
    near(&factors(&of(&[1.0], 0.9995)), &[1.0]);
    near(&factors(&of(&[1.0], 0.998)), &[0.998, 1.0]);
    // A stop cuts a step, which is none the shorter for it.
    let path = of(&[0.1, 1.0], 0.4);
    near(&factors(&path), &[0.1, 0.7, 1.0]);
    assert_eq!(path.at(0.1).map(|point| point.load_factor), Some(0.1));
    assert!(path.at(0.5).is_none() && path.end().load_factor == 1.0);
    let grown = [
        0.01,
        0.025,
        0.0475,
        0.08125,
        0.131_875,
        0.207_812_5,
        0.25,
        0.3,
        0.556_289_062_5,
        0.940_722_656_25,
        1.0,
    ];
    near(&factors(&of(&[0.25, 0.3, 1.0], 0.01)), &grown);
    // Nothing to do.
    assert!(of(&[0.0], 1.0).points.is_empty());
}

#[test]
fn steps_that_take_many_iterations_do_not_grow() {
    let (wing, loads) = (cantilever(""), dead(force(4, [0.0, 0.0, 60.0])));
    let path = walked(&wing, &loads, &Controls { first_step: 0.02, ..Controls::default() }).expect("carried");
    let all: Vec<f64> = [0.0].into_iter().chain(factors(&path)).collect();
    for (pair, point) in all.windows(3).zip(&path.points).take(path.points.len() - 2) {
        let growth = (pair[2] - pair[1]) / (pair[1] - pair[0]);
        let expected = if point.iterations < 7 { 1.5 } else { 1.0 };
        assert!((growth - expected).abs() < 1e-9, "{growth} after {} iterations", point.iterations);
    }
}

/// A linear answer turns the end by P L^2 / 2 E I = P / 2; beyond 1.5 rad the first iteration ends the step.
#[test]
fn steps_that_fail_are_halved_and_their_iterations_counted() {
    let (wing, loads) = (cantilever(""), dead(force(4, [0.0, 0.0, 20.0])));
    let of = |first_step: f64| {
        walked(&wing, &loads, &Controls { first_step, ..Controls::default() }).expect("carried in steps")
    };
    let (whole, eighth) = (of(1.0), of(0.125));
    near(&factors(&whole), &factors(&eighth));
    assert_eq!(whole.points[0].load_factor, 0.125);
    assert_eq!(whole.points[0].iterations, 3 + eighth.points[0].iterations);
    assert_eq!(whole.points[1].iterations, eighth.points[1].iterations, "counted once");
    assert_eq!(whole.end().state, eighth.end().state);
}

#[test]
fn a_load_beyond_all_measure_is_given_up_at_the_shortest_step() {
    let (wing, loads) = (cantilever(""), dead(force(4, [0.0, 0.0, 1e7])));
    let error = walked(&wing, &loads, &Controls::default()).expect_err("too much");
    let shortest = 0.5_f64.powi(13);
    assert_eq!(error, NonlinearError::Stalled { load_factor: 0.0, tried: shortest, negative: 0 });
    let stops = vec![1e-9, 1.0];
    let error = walked(&wing, &loads, &Controls { stops, ..Controls::default() }).expect_err("too much");
    let NonlinearError::Stalled { load_factor, tried, .. } = error else { panic!("{error}") };
    assert_eq!((load_factor, error.reached()), (1e-9, 1e-9));
    assert!((tried - 1e-9 - shortest).abs() < 1e-9, "{tried}");
}

/// Euler's load is 1 / 1.7 of what is applied. Steps do not grow again after the first unstable equilibrium.
#[test]
fn the_loss_of_stability_is_found_by_halving_to_a_thousandth() {
    let euler = std::f64::consts::PI.powi(2) / 4.0;
    let column = large(&(beam_along_x(8, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n"));
    let error = column.under(&dead(force(8, [-1.7 * euler, 0.0, 0.0]))).expect_err("it buckles");
    let NonlinearError::Unstable { load_factor, unstable, grid, component, .. } = error else {
        panic!("{error}")
    };
    assert_eq!(unstable - load_factor, 0.5_f64.powi(10));
    assert!(
        (1.7 * load_factor - 1.0).abs() < 4e-3 && (grid, component) == (9, 3),
        "{load_factor} {grid} {component}"
    );
}

/// One negative pivot for every load of buckling below: Euler's times 1, 9 and 25 about the weak axis.
#[test]
fn unstable_equilibria_are_counted_where_they_are_accepted() {
    let column = large(&(beam_along_x(8, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\n"));
    let euler = std::f64::consts::PI.powi(2) / 4.0;
    for (times, negative) in [(0.9, 0), (2.0, 1), (10.5, 2)] {
        let controls = Controls { accepts_unstable: true, ..Controls::default() };
        let path = walked(&column, &dead(force(8, [-times * euler, 0.0, 0.0])), &controls).expect("straight");
        assert_eq!(path.end().negative_pivots, Some(negative), "{times} times Euler's load");
    }
    let following = vec![Following::Node(force(8, [0.0, 0.0, 0.1]))];
    let path = column.under(&Loads { following, ..Loads::default() }).expect("carried");
    assert_eq!(path.end().negative_pivots, None, "not judged under loads that follow");
}

/// An end moment bends every bar by M L / E I: one of a third of the stiffness turns three times as far against its
/// ends.
#[test]
fn the_element_that_turns_most_is_named_with_half_of_its_bend() {
    let deck = beam_along_x(4, 10.0, 1.2e6, [0.1, 1.0]).replace("CBAR,3,1,", "CBAR,3,2,");
    let soft = deck.lines().nth(1).expect("PBAR").replace("PBAR,1,1", "PBAR,2,2");
    let wing = large(&format!("{deck}{soft}\nMAT1,2,4.+5,2.+5\nSPC1,1,123456,1\n"));
    let path = wing.under(&dead(moment(4, [0.0, -3.0, 0.0]))).expect("carried");
    let (angle, element) = path.end().largest_local_rotation;
    assert_eq!(element, 3);
    assert!((angle / (0.5 * 3.0 * 2.5 / (100.0 / 3.0)) - 1.0).abs() < 1e-7, "{angle}");
}

/// An end moment of 2 N m turns grids 2 to 5 by 0.05 to 0.2 rad, 2.9 to 11.5 degrees.
#[test]
fn linear_ties_are_refused_where_their_own_grids_have_turned_too_far() {
    let bent = dead(moment(4, [0.0, -2.0, 0.0]));
    let tied = |cards: &str| cantilever(&format!("GRID,9,,10.,0.,0.\n{cards}")).under(&bent);
    assert!(tied("MPC,1,9,5,1.,2,5,-1.\n").is_ok(), "grid 2 turns by less than five degrees");
    assert!(tied("CELAS2,77,1.-9,2,5\n").is_ok());
    for (cards, owner, degrees) in [
        ("MPC,1,9,5,1.,5,5,-1.\n", "MPC of set 1", 0.2_f64.to_degrees()),
        ("MPC,1,9,5,1.,2,5,-.5,,\n,,3,5,-.5\n", "MPC of set 1", 0.1_f64.to_degrees()),
        ("CELAS2,77,1.-9,4,5\n", "element 77", 0.15_f64.to_degrees()),
    ] {
        let error = tied(cards).expect_err("turned too far");
        let NonlinearError::Turned { owner: own, turned_deg, limit_deg, load_factor } = &error else {
            panic!("{error}")
        };
        assert_eq!((own.as_str(), *load_factor, error.reached()), (owner, 1.0, 1.0));
        assert!(
            (turned_deg - degrees).abs() < 1e-4 && (limit_deg - 5.0).abs() < 1e-9,
            "{turned_deg} {limit_deg}"
        );
    }
}

/// From one set of loads to another: halfway both act by half.
#[test]
fn a_path_goes_in_proportion_from_one_load_to_another() {
    let wing = cantilever("");
    let (from, to) = (dead(force(4, [0.0, 0.0, 3.0])), dead(moment(4, [0.0, 2.0, 0.0])));
    let start = wing.under(&from).expect("carried").end().state.clone();
    let controls = Controls { stops: vec![0.25, 1.0], ..Controls::default() };
    let path = wing.path(&start, &from, &to, &controls).expect("carried");
    for (factor, loads) in [(0.25, from.times(0.75).and(&to.times(0.25))), (1.0, to.clone())] {
        let direct = wing.under(&loads).expect("carried");
        let (own, expected) = (path.at(factor).expect("a stop"), direct.end());
        assert!((own.state.places[4] - expected.state.places[4]).norm() < 1e-8, "at {factor}");
    }
}

#[test]
fn moments_across_a_motion_and_differences_are_those_by_hand() {
    let forces = [9.0, 9.0, 9.0, 1.0, 2.0, 3.0, 9.0, 9.0, 9.0, 0.0, 0.0, 2.0];
    let motion = [8.0, 8.0, 8.0, 4.0, 5.0, 7.0, 8.0, 8.0, 8.0, 1.0, 0.0, 0.0];
    let expected = [0.0, 0.0, 0.0, -1.0, 5.0, -3.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    assert_eq!(moments_across(&forces, &motion), expected);
    let cubic = |x: &[f64]| vec![3.0 * x[0] - 2.0 * x[1] + x[0] * x[0], x[1].powi(3)];
    let own = differenced(&[40.0, -100.0], cubic);
    assert!((own[0] - 320.0).abs() < 1e-6 && own[1].abs() < 1e-4, "{own:?}");
    assert_eq!(differenced(&[0.0, 0.0], cubic), [0.0, 0.0]);
}

/// A pendulum on a torsion spring k, pushed along the line from a point h beyond its end: K = k - F a, and the
/// force's own turn
/// gives back F a^2 / h.
#[test]
fn what_loads_give_back_of_a_motion_is_their_moment_over_the_stiffness() {
    let pendulum = |first: u32, k: f64, a: f64, h: f64| {
        let y = f64::from(first);
        format!(
            "GRID,{first},,0.,{y:?},0.\nGRID,{},,{a:?},{y:?},0.\nGRID,{},,{:?},{y:?},0.\n\
            RBE2,{first},{first},123456,{}\n\
             CELAS2,{first},{k:?},{first},6\nSPC1,1,12345,{first}\nSPC1,1,123456,{}\n",
            first + 1,
            first + 2,
            a + h,
            first + 1,
            first + 2
        )
    };
    let pushed = |first: usize, size: f64| Following::Along {
        node: first + 1,
        line: [first + 2, first + 1],
        size,
        is_moment: false,
    };
    let gain = |deck: &str, following: Vec<Following>| {
        let wing = large(deck);
        let (state, loads) = (wing.undeformed(), Loads { following, ..Loads::default() });
        wing.following_gain(&state, loads.at(&wing, &state)?.as_ref())
    };
    let [one, other, third] = [(1, 50.0, 2.0, 0.5), (11, 80.0, 1.5, 0.25), (21, 60.0, 1.0, 0.5)]
        .map(|(first, k, a, h)| pendulum(first, k, a, h));
    let near = |own: Option<f64>, expected: f64| {
        let own = own.expect("a stable equilibrium");
        assert!((own - expected).abs() < 1e-6 * (1.0 + expected), "{own} for {expected}");
    };
    near(gain(&one, vec![pushed(0, 3.0)]), 3.0 * 8.0 / (50.0 - 6.0));
    let all = format!("{one}{other}{third}");
    // 4 / 0.5 over 50 - 2 F, 2.25 / 0.25 over 80 - 1.5 F, and one that is pulled back.
    near(gain(&all, vec![pushed(0, 3.0), pushed(3, 2.0), pushed(6, -4.0)]), 24.0 / 44.0);
    near(gain(&all, vec![pushed(0, 1.0), pushed(3, 9.0), pushed(6, -4.0)]), 81.0 / (80.0 - 13.5));
    near(gain(&third, vec![pushed(0, -4.0)]), 0.0);
    near(gain(&one, Vec::new()), 0.0);
    assert_eq!(gain(&one, vec![pushed(0, 26.0)]), None, "the arm itself falls over");
}
