//! When a fit ends, what it weighs and how far it goes, on a wing that is linear in its corrections.

use super::*;
use crate::calibration::Context;
use crate::campaign::TipReading;
use crate::objective::line_fit;
use crate::statics::StaticData;
use crate::tests::{RHO, Toy, near, noise, settings};

/// Hands over the problem of a wing whose lift is a factor of theory's.
fn with_problem(factor: f64, settings: &Settings, judge: impl Fn(&mut Problem<'_, Toy>)) {
    let toy = Toy::new(3, 2);
    let mut campaign = toy.measured(&[10.0], &[-0.1, 0.0, 0.05, 0.1], &toy.uniform(factor));
    campaign.tip = TipReading::FreeZero;
    campaign.noise = Some(noise([0.1, 0.1, 0.1, 1e-3]));
    let data = StaticData::from_campaign(&campaign).expect("it is sound");
    let context = Context::new(&toy, RHO, &data, settings);
    let metric = context.metric(&data.airspeeds).expect("it is linear");
    let line = line_fit(&data, &data.airspeeds[0]);
    let mut problem = context.problem(&data.airspeeds[0], &line, &metric).expect("it is linear");
    judge(&mut problem);
}

/// The objective of theory itself.
fn of_theory(problem: &Problem<'_, Toy>) -> f64 {
    problem.objective(problem.linearise(&problem.basis.neutral()).expect("it is linear").rmse)
}

#[test]
fn a_fit_ends_at_its_floor_which_is_the_lines_and_a_share_of_the_noise() {
    with_problem(1.2, &settings(2), |problem| {
        let start = of_theory(problem);
        let mut programs = |line_floor: f64, noise_floor: f64, slack: f64| {
            (problem.floor, problem.noise_floor, problem.slack) =
                (Floor::Known(line_floor), noise_floor, slack);
            let fit = problem.fit().expect("it is linear");
            assert_eq!((fit.objective[0], fit.history[0], fit.ending), (start, start, Ending::Converged));
            assert_eq!(fit.history.len(), fit.cone_programs + 1);
            near(*fit.history.last().expect("some"), fit.objective[1], 1e-15);
            fit.cone_programs
        };
        assert_eq!(programs(1.0001 * start / 1.02, 0.0, 1.0), 0);
        assert!(programs(0.9999 * start / 1.02, 0.0, 1.0) > 0);
        assert_eq!(programs(0.0, 1.0001 * start / 0.02, 1.0), 0);
        assert!(programs(0.0, 0.9999 * start / 0.02, 1.0) > 0);
        assert_eq!(programs(0.5 * start / 1.02, 0.25 * start / 0.02, 1.3334), 0);
        assert!(programs(0.5 * start / 1.02, 0.25 * start / 0.02, 1.3332) > 0);
    });
}

#[test]
fn a_fit_that_may_not_go_on_is_at_the_noise_up_to_half_more_than_it() {
    let settings = Settings { most_cone_programs: 0, ..settings(2) };
    with_problem(1.2, &settings, |problem| {
        let start = of_theory(problem);
        for (noise_floor, ending) in
            [(1.001 * start / 1.5, Ending::AtNoiseFloor), (0.999 * start / 1.5, Ending::Stalled)]
        {
            problem.noise_floor = noise_floor;
            problem.floor = Floor::Known(0.0);
            let fit = problem.fit().expect("it is linear");
            assert_eq!((fit.ending, fit.cone_programs, &fit.x), (ending, 0, &problem.basis.neutral()));
        }
    });
}

#[test]
fn a_fit_starts_from_its_factor_and_counts_change_from_it() {
    with_problem(1.2, &settings(2), |problem| {
        let theory = of_theory(problem);
        problem.start = 1.2;
        let x = problem.start();
        problem.basis.neutral().iter().zip(&x).for_each(|(one, x)| assert_eq!(1.2 * one, *x));
        let fit = problem.fit().expect("it is linear");
        assert_eq!((fit.cone_programs, &fit.x), (0, &x));
        near(fit.objective[0], theory, 1e-12);
        assert!(fit.objective[1] < 1e-9 * theory);
        assert_eq!(problem.change(&x), 0.0);
        // the factor of every force off by 0.1: a hundredth of the area's mean square
        let mut moved = x.clone();
        for strip in 0..2 {
            moved[problem.basis.column(0, strip)] += 0.1;
        }
        near(problem.change(&moved), 0.01, 1e-12);
    });
}

#[test]
fn change_weighs_as_the_objective_but_not_less_than_noise_and_a_hundredth_of_the_start() {
    let settings = Settings { change_weight: 0.5, ..settings(2) };
    with_problem(1.2, &settings, |problem| {
        problem.weights = [1.0, 1.0, 1.0, 0.0];
        let of = |fz: f64| Linearised { rmse: [fz, 0.0, 0.0, 0.0], residuals: vec![], sensitivities: vec![] };
        for (now, before, noise_floor, expected) in
            [(8.0, 100.0, 2.0, 4.0), (0.5, 100.0, 0.2, 0.5), (0.5, 100.0, 3.0, 1.5), (0.5, 10.0, 0.2, 0.25)]
        {
            problem.noise_floor = noise_floor;
            near(problem.change_weight(&of(now), [before, 0.0, 0.0, 0.0]), expected, 1e-12);
        }
    });
}

#[test]
fn residuals_of_the_tip_and_their_derivatives_are_about_its_zero() {
    with_problem(1.2, &settings(2), |problem| {
        let x = problem.basis.neutral();
        let here = problem.linearise(&x).expect("it is linear");
        assert!(here.residuals.iter().map(|row| row[TIP]).sum::<f64>().abs() < 1e-12);
        let gradients: Vec<Mat<f64>> = here.sensitivities.iter().map(|s| problem.basis.gradient(s)).collect();
        for c in 0..4 {
            let jacobian = problem.jacobian(&gradients, c);
            for k in 0..x.len() {
                let mut moved = x.clone();
                moved[k] += 1.0;
                let there = problem.linearise(&moved).expect("it is linear");
                for i in 0..4 {
                    let difference = there.residuals[i][c] - here.residuals[i][c];
                    assert!((jacobian[(i, k)] - difference).abs() < 1e-9, "{c} {k} {i}");
                }
            }
        }
        assert!(here.residuals.iter().all(|row| row[0].abs() > 1.0 || row[0].abs() < 1e-9));
    });
}

#[test]
fn a_goal_beyond_bounds_is_met_half_way_and_they_join_the_others() {
    with_problem(1.0, &settings(2), |problem| {
        let x = problem.basis.neutral();
        let mut goal = x.clone();
        // all force factors fall to -0.9: half of the way they meet 0.05
        for strip in 0..2 {
            goal[problem.basis.column(0, strip)] = -0.9;
        }
        let mut working = vec![1, 0];
        let found = problem.within_bounds(&x, goal.clone(), &mut working);
        for strip in 0..2 {
            assert!((found[problem.basis.column(0, strip)] - 0.05).abs() < 1e-6);
        }
        assert_eq!(found[problem.basis.column(1, 0)], 1.0);
        let is_least = |row: usize| problem.bounds.rows[row].limit == -0.05;
        assert!(
            working.is_sorted()
                && working.len()
                    == 2 + (2..problem.bounds.rows.len())
                        .filter(|&row| is_least(row) && problem.bounds.rows[row].entries[0].0 < 4)
                        .count(),
            "{working:?}"
        );
        let inside: Vec<f64> = x.iter().map(|x| 0.99 * x).collect();
        let mut working = vec![];
        assert_eq!((problem.within_bounds(&x, inside.clone(), &mut working), working), (inside, vec![]));
    });
}

#[test]
fn steps_are_halved_until_the_objective_falls() {
    with_problem(1.2, &Settings { most_halvings: 3, ..settings(2) }, |problem| {
        let x = problem.start();
        let at = problem.linearise(&x).expect("it is linear");
        let goal = |share: f64| -> Vec<f64> { x.iter().map(|one| one * (1.0 + share)).collect() };
        let taken = |share: f64| match problem.step(&x, &goal(share), 0.0, &at).expect("it is linear") {
            Step::Taken(next, _) => Some(next[0] - 1.0),
            Step::Refused(why) => {
                assert_eq!(why, Ending::Stalled);
                None
            }
        };
        // right is 0.2: less than 0.4 away is better than nothing
        near(taken(0.3).expect("better"), 0.3, 1e-9);
        near(taken(0.6).expect("better"), 0.3, 1e-9);
        near(taken(1.5).expect("better"), 0.375, 1e-9);
        assert!(taken(1.7).is_none() && taken(-0.1).is_none());
        // change weighs as well: so much that nothing is won
        assert!(matches!(problem.step(&x, &goal(0.1), 1e9, &at), Ok(Step::Refused(Ending::Stalled))));
    });
}
