//! The cases of a grid, one by one: which there are, what each is called and what it costs. None needs the aircraft.

use crate::cases::file::{Action, CasesFile};
use crate::trim::maneuvers::Steady;
use maneuver::motion::tidy_degrees;
use std::collections::BTreeMap;

/// Models of a case, in the order of results.
pub const MODELS: [&str; 2] = ["initial", "updated"];

/// A motion's cost in trims, and that of each of its seconds.
const MOTION_COST: u64 = 20;
/// See above.
const MOTION_COST_A_SECOND: f64 = 100.0;

/// One case.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its place in the grid.
    pub number: usize,
    /// Which of [`MODELS`].
    pub model: usize,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// What is flown.
    pub action: Action,
}

/// All cases of a file, made one by one: model by model, airspeed by airspeed, in the file's order.
#[derive(Debug, Clone)]
pub struct Grid {
    airspeeds_v_m_s: Vec<f64>,
    actions: Vec<Action>,
}

impl Grid {
    /// How many cases there are.
    pub fn len(&self) -> usize {
        MODELS.len() * self.airspeeds_v_m_s.len() * self.actions.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The case of a number below [`len`](Self::len).
    pub fn case(&self, number: usize) -> Case {
        let (row, action) = (number / self.actions.len(), number % self.actions.len());
        let (model, airspeed) = (row / self.airspeeds_v_m_s.len(), row % self.airspeeds_v_m_s.len());
        Case { number, model, v_m_s: self.airspeeds_v_m_s[airspeed], action: self.actions[action].clone() }
    }

    /// All cases in the order of their numbers.
    pub fn cases(&self) -> impl Iterator<Item = Case> {
        (0..self.len()).map(|number| self.case(number))
    }
}

impl CasesFile {
    /// The grid of all cases, which takes no memory a case.
    pub fn grid(&self) -> Grid {
        Grid { airspeeds_v_m_s: self.airspeeds_v_m_s.clone(), actions: self.actions() }
    }

    /// All cases.
    pub fn cases(&self) -> Vec<Case> {
        self.grid().cases().collect()
    }
}

impl Case {
    /// The trim it is, or the level flight it starts from.
    pub(super) fn steady(&self) -> Steady {
        if let Action::Steady(steady) = &self.action { steady.clone() } else { Steady::Level }
    }

    /// What is flown, in a few words.
    pub fn maneuver(&self) -> String {
        match &self.action {
            Action::Steady(Steady::Roll { rate_deg_s, control, .. }) => {
                format!("roll {rate_deg_s} deg/s, {control}")
            }
            Action::Steady(Steady::Sideslip { beta_deg, .. }) => format!("sideslip {beta_deg} deg"),
            Action::Steady(steady) => steady.kind().to_owned(),
            Action::Motion(motion) => {
                let (kind, control) = (motion.kind(), motion.control().unwrap_or_default());
                format!("{} {} deg, {control}", kind.words(), tidy_degrees(kind.height()))
            }
        }
    }

    /// Its kind: that of the trim (`roll`), or of the motion (`doublet`).
    pub fn kind(&self) -> &str {
        match &self.action {
            Action::Steady(steady) => steady.kind(),
            Action::Motion(motion) => motion.kind().words(),
        }
    }

    /// Whether it is flown in time.
    pub fn is_dynamic(&self) -> bool {
        !matches!(self.action, Action::Steady(_))
    }

    /// What the case costs beside a trim, from a table: the same on every machine, so that shares of a sweep are.
    pub fn cost(&self) -> u64 {
        match &self.action {
            Action::Steady(_) => 1,
            Action::Motion(motion) => motion_cost(motion.record_s()),
        }
    }
}

/// What a motion of so many seconds costs beside a trim.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "files allow 0 to 600 s")]
pub(crate) fn motion_cost(seconds: f64) -> u64 {
    MOTION_COST + (MOTION_COST_A_SECOND * seconds) as u64
}

/// Cases sorted into groups that are flown together: one for each model and airspeed.
pub fn groups(cases: &[Case]) -> Vec<Vec<&Case>> {
    let mut groups: BTreeMap<(usize, u64), Vec<&Case>> = BTreeMap::new();
    for case in cases {
        groups.entry((case.model, case.v_m_s.to_bits())).or_default().push(case);
    }
    groups.into_values().collect()
}
