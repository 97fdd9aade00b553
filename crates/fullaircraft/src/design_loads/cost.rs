//! What a case of a plan costs beside a trim, from a table: the same on every machine, so that shares of a sweep are.

use crate::cases::file::Action as Own;
use crate::cases::list::motion_cost;
use crate::design_loads::in_time::AFTER_S;
use loads::matrix::{Action, Case};

/// A case in turbulence, whose response is found at all frequencies of its grid.
const TURBULENCE: u64 = 600;

/// Whether a case is flown in time or in turbulence, which needs unsteady air.
pub fn is_in_time(case: &Case, maneuvers: &[Own]) -> bool {
    match case.action {
        Action::Trim => false,
        Action::Condition(place) => matches!(maneuvers[place], Own::Motion(_)),
        Action::Discrete { .. } | Action::Turbulence { .. } => true,
    }
}

/// What a case costs beside a trim; `maneuvers` are the plan's own, in the order of the matrix' conditions. A gust whose gradient is
/// searched for counts twice.
pub fn cost(case: &Case, maneuvers: &[Own]) -> u64 {
    match case.action {
        Action::Trim => 1,
        Action::Condition(place) => match &maneuvers[place] {
            Own::Steady(_) => 1,
            Own::Motion(motion) => motion_cost(motion.record_s() + AFTER_S),
        },
        Action::Discrete { gradient_m, refine, .. } => {
            let once = motion_cost(2.0 * gradient_m / case.v_m_s + AFTER_S);
            if refine { 2 * once } else { once }
        }
        Action::Turbulence { .. } => TURBULENCE,
    }
}

#[cfg(test)]
mod tests;
