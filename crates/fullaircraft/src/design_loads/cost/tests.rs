//! Costs by the table: a trim is one, a second in motion a hundred, each motion twenty more, turbulence six hundred.

use super::{cost, is_in_time};
use crate::cases::file::Action as Own;
use crate::design_loads::search::tests::{case, discrete, turbulence};
use crate::trim::maneuvers::Steady;
use loads::design::Direction;
use loads::matrix::Action;
use maneuver::motion::{Doublet, MotionSpec};

fn motion(duration_s: f64) -> Own {
    let doublet = Doublet { height: 0.1, frequency_hz: 2.0, start_s: 0.1 };
    Own::Motion(MotionSpec { duration_s: Some(duration_s), ..MotionSpec::new("outer", doublet) })
}

#[test]
fn a_case_costs_its_time_and_a_search_twice_as_much() {
    let own = [Own::Steady(Steady::Level), motion(1.2)];
    // two gradients of 15 m at 50 m/s are 0.6 s, and 0.8 s follow
    let searched = discrete(1, 15.0, Direction::Up);
    let mut once = searched.clone();
    if let Action::Discrete { refine, .. } = &mut once.action {
        *refine = false;
    }
    let all = [
        (case(1, Action::Trim), 1, false),
        (case(1, Action::Condition(0)), 1, false),
        (case(1, Action::Condition(1)), 20 + 200, true),
        (once, 20 + 140, true),
        (searched, 2 * (20 + 140), true),
        (turbulence(1), 600, true),
    ];
    for (case, law, in_time) in all {
        assert_eq!((cost(&case, &own), is_in_time(&case, &own)), (law, in_time), "{:?}", case.action);
    }
}
