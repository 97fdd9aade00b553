//! What a grid of cases must satisfy: numbers that can be flown, no case twice, no more cases than can be kept, and names that
//! the aircraft knows, all before anything is flown.

use super::file::{CasesFile, Maneuver, Trims};
use crate::flight::small_motions::TIME_STEP_S;
use crate::trim::case::TrimTools;
use crate::trim::variables::motion;
use nastran::{InputError, memory, place_of, read_text};
use std::ops::RangeInclusive;

/// Airspeeds, m/s: the air is taken as incompressible.
const AIRSPEEDS_M_S: RangeInclusive<f64> = 0.1..=340.0;
/// Load factors beyond any aircraft's.
const LOAD_FACTORS: RangeInclusive<f64> = -100.0..=100.0;
/// Rates of roll, deg/s.
const RATES_DEG_S: RangeInclusive<f64> = -3600.0..=3600.0;
/// Angles of sideslip, deg.
const ANGLES_DEG: RangeInclusive<f64> = -90.0..=90.0;
/// Longest motion, s.
const LONGEST_S: f64 = 600.0;
/// Most cases of a file.
const MOST_CASES: usize = 5_000_000;
/// What to do where no airspeed is given.
const NO_AIRSPEED: &str = "give at least one; a plan of design loads has `rules` and takes its own";
/// What a case takes in memory, bytes: its hash and where its result stands; the result itself is in files.
const MEMORY_A_CASE: f64 = 300.0;

impl CasesFile {
    /// Numbers that cannot be, and too many of them.
    pub(super) fn check(&self) -> Result<(), InputError> {
        self.numbers("airspeeds_V_m_s", &self.airspeeds_v_m_s, &AIRSPEEDS_M_S)?;
        self.numbers("load_factors", &self.load_factors, &LOAD_FACTORS)?;
        if self.airspeeds_v_m_s.is_empty() && self.rules.is_none() {
            return Err(self.wrong("airspeeds_V_m_s", "there is no airspeed", NO_AIRSPEED));
        }
        if !self.maneuvers.iter().all(is_possible) {
            let message = "a number of `maneuvers` makes no sense here";
            let help = "expected angles up to 90 degrees, rates up to 3600 deg/s, frequencies and durations above zero, \
                        motions up to 600 s";
            return Err(self.wrong("maneuvers", message, help));
        }
        let actions = self.maneuvers.iter().map(|maneuver| self.count(maneuver));
        let actions = actions.fold(0, usize::saturating_add);
        if actions == 0 && self.rules.is_none() {
            let help = "give at least one (`Pull` needs load factors that are not one, `Turn` one above)";
            return Err(self.wrong("maneuvers", "there is no maneuver to fly", help));
        }
        let cases = actions.saturating_mul(2).saturating_mul(self.airspeeds_v_m_s.len());
        let help = "split the grid into several files, or make its lists shorter";
        if cases > MOST_CASES {
            let message = format!("these are {cases} cases, and {MOST_CASES} are the most of a file");
            return Err(self.wrong("maneuvers", &message, help));
        }
        memory::demand(&format!("{cases} cases"), MEMORY_A_CASE * cases as f64)
            .map_err(|error| self.wrong("maneuvers", &error.message, help))
    }

    /// Controls, variables and motions that the aircraft does not have.
    ///
    /// # Errors
    /// At the name's place in the file.
    pub fn check_names(&self, tools: &TrimTools<'_>) -> Result<(), InputError> {
        let text = read_text(&self.path).unwrap_or_default();
        let at = |name: &str, error: InputError| {
            let place = place_of(&["maneuvers:", &format!("\"{name}\"")], &text, &self.path);
            InputError { span: Some(place), ..error }
        };
        let control = |name: &str| {
            let known = tools.variables.place(&format!("{name}_deg")).map(|_| ());
            known.and_then(|()| tools.aircraft.drive(name).map(|_| ())).map_err(|error| {
                let message = format!("the aircraft has no control {name}");
                at(name, InputError { message, ..error })
            })
        };
        for maneuver in &self.maneuvers {
            match maneuver {
                Maneuver::Motion(moves) => control(moves.control().unwrap_or_default())?,
                Maneuver::Other(Trims::Level | Trims::Pull) => {}
                Maneuver::Other(
                    Trims::Roll { control: name, .. }
                    | Trims::Turn { control: name }
                    | Trims::Sideslip { control: name, .. },
                ) => control(name)?,
                Maneuver::Other(Trims::Trim { given, free, targets, .. }) => {
                    for name in given.keys().chain(free) {
                        tools.variables.place(name).map_err(|error| at(name, error))?;
                    }
                    for name in targets.keys() {
                        motion(name).map_err(|error| at(name, error))?;
                    }
                }
            }
        }
        Ok(())
    }

    /// How many actions a maneuver makes, without making them.
    fn count(&self, maneuver: &Maneuver) -> usize {
        let factors = |keep: fn(&f64) -> bool| self.load_factors.iter().filter(|n| keep(n)).count();
        match maneuver {
            Maneuver::Motion(_) | Maneuver::Other(Trims::Level | Trims::Trim { .. }) => 1,
            Maneuver::Other(Trims::Pull) => factors(|n| *n != 1.0),
            Maneuver::Other(Trims::Roll { rates_deg_s, .. }) => {
                self.load_factors.len().saturating_mul(rates_deg_s.len())
            }
            Maneuver::Other(Trims::Turn { .. }) => 2 * factors(|n| *n > 1.0),
            Maneuver::Other(Trims::Sideslip { angles_deg, .. }) => angles_deg.len(),
        }
    }

    /// Numbers of a list, each within a range and there once.
    fn numbers(&self, field: &str, list: &[f64], range: &RangeInclusive<f64>) -> Result<(), InputError> {
        if let Some(value) = list.iter().find(|value| !range.contains(value)) {
            let message = format!("{value:?} in `{field}` makes no sense here");
            let help = format!("expected numbers from {} to {}", range.start(), range.end());
            return Err(self.wrong(field, &message, &help));
        }
        let mut sorted = list.to_vec();
        sorted.sort_by(f64::total_cmp);
        match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => {
                let message = format!("{} stands twice in `{field}`", pair[0]);
                Err(self.wrong(field, &message, "each number once: its cases would be the same"))
            }
            None => Ok(()),
        }
    }

    fn wrong(&self, field: &str, message: &str, help: &str) -> InputError {
        InputError::in_field(&self.path, field, message).with_help(help)
    }
}

fn is_possible(maneuver: &Maneuver) -> bool {
    let within =
        |values: &[f64], range: &RangeInclusive<f64>| values.iter().all(|value| range.contains(value));
    match maneuver {
        Maneuver::Motion(motion) => {
            motion.control().is_some()
                && motion.fault(1.0 / TIME_STEP_S).is_none()
                && motion.record_s() > 0.0
                && motion.record_s() <= LONGEST_S
        }
        Maneuver::Other(Trims::Level | Trims::Pull | Trims::Turn { .. }) => true,
        Maneuver::Other(Trims::Roll { rates_deg_s, .. }) => within(rates_deg_s, &RATES_DEG_S),
        Maneuver::Other(Trims::Sideslip { angles_deg, .. }) => within(angles_deg, &ANGLES_DEG),
        Maneuver::Other(Trims::Trim { given, targets, .. }) => {
            given.values().chain(targets.values()).all(|x| x.is_finite())
        }
    }
}
