//! Steady maneuvers as trims: what is given, free and asked for in each.
//!
//! ```text
//! pull-up, push-down  q = (n - 1) g/V
//! steady roll         p given, no angular acceleration; thrust and side force as they come
//! level turn, bank φ  cos φ = 1/n,  q = (n - 1/n) g/V,  r = sin φ g/V,  coordinated: n_y = 0
//! steady sideslip     beta given, no rates; n_y = tan(bank) n_z comes out
//! ```
//! Turn rates: the turn's rate g tan φ/V is about the vertical; sin φ of it is pitch, cos φ of it yaw (small climb and pitch
//! angles). Positive slips are to the right; a turn's direction is a flag.

use crate::aircraft::file::{AircraftFile, Surfaces};
use crate::trim::case::TrimCase;
use crate::trim::variables::MOTIONS;
use coupling::GRAVITY_M_S2;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A steady maneuver at an airspeed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Steady {
    /// Straight and level.
    Level,
    /// Pull-up or push-down: wings level at a load factor, with the pitch rate (n - 1) g/V.
    Pull {
        /// Load factor.
        load_factor: f64,
    },
    /// Steady roll.
    Roll {
        /// Load factor.
        load_factor: f64,
        /// Right wing down, deg/s.
        rate_deg_s: f64,
        /// The pair of ailerons that rolls.
        control: String,
    },
    /// Level, coordinated turn.
    Turn {
        /// Load factor, above 1.
        load_factor: f64,
        /// To the left instead of the right.
        left: bool,
        /// The pair of ailerons that holds the bank.
        control: String,
    },
    /// Steady sideslip.
    Sideslip {
        /// Load factor.
        load_factor: f64,
        /// Wind from the right, deg.
        beta_deg: f64,
        /// The pair of ailerons that holds the bank.
        control: String,
    },
    /// Any trim: names and units as `wingroot fullaircraft` lists them.
    Trim {
        /// What it is called.
        name: String,
        /// Variables with values.
        given: BTreeMap<String, f64>,
        /// Variables to be found, as many as there are targets.
        free: Vec<String>,
        /// Motions asked for.
        targets: BTreeMap<String, f64>,
    },
}

impl Steady {
    /// A word for it.
    pub fn kind(&self) -> &str {
        match self {
            Self::Level => "level",
            Self::Pull { load_factor } if *load_factor < 1.0 => "push_down",
            Self::Pull { .. } => "pull_up",
            Self::Roll { .. } => "roll",
            Self::Turn { left: false, .. } => "turn_right",
            Self::Turn { left: true, .. } => "turn_left",
            Self::Sideslip { .. } => "sideslip",
            Self::Trim { name, .. } => name,
        }
    }

    /// Load factor asked for; one where it is not.
    pub fn load_factor(&self) -> f64 {
        match self {
            Self::Level => 1.0,
            Self::Pull { load_factor }
            | Self::Roll { load_factor, .. }
            | Self::Turn { load_factor, .. }
            | Self::Sideslip { load_factor, .. } => *load_factor,
            Self::Trim { targets, .. } => targets.get(MOTIONS[2]).copied().unwrap_or(1.0),
        }
    }

    /// The maneuver as a trim of an aircraft. With wings only in the flow nothing balances pitching and yawing moments or side force:
    /// the aircraft is held there.
    pub fn case(&self, file: &AircraftFile, v_m_s: f64) -> TrimCase {
        let n = self.load_factor();
        let (elevator, rudder) =
            (format!("{}_deg", file.htp.control.name), format!("{}_deg", file.vtp.control.name));
        let lateral = |control: &str| vec![format!("{control}_deg"), rudder.clone()];
        let g_over_v_deg_s = (GRAVITY_M_S2 / v_m_s).to_degrees();
        let (given, free, targets): (Vec<(&str, f64)>, Vec<String>, Vec<usize>) = match self {
            Self::Level => (vec![], vec![], vec![]),
            Self::Pull { .. } => (vec![("pitch_rate_deg_s", (n - 1.0) * g_over_v_deg_s)], vec![], vec![]),
            Self::Roll { rate_deg_s, control, .. } => {
                let mut free = lateral(control);
                free.push("beta_deg".to_owned());
                (vec![("roll_rate_deg_s", *rate_deg_s)], free, vec![1, 3, 5])
            }
            Self::Turn { left, control, .. } => {
                let side = if *left { -1.0 } else { 1.0 };
                let rates = vec![
                    ("pitch_rate_deg_s", (n - 1.0 / n) * g_over_v_deg_s),
                    ("yaw_rate_deg_s", side * (1.0 - 1.0 / (n * n)).max(0.0).sqrt() * g_over_v_deg_s),
                ];
                let mut free = lateral(control);
                free.push("beta_deg".to_owned());
                (rates, free, vec![1, 3, 5])
            }
            Self::Sideslip { beta_deg, control, .. } => {
                (vec![("beta_deg", *beta_deg)], lateral(control), vec![3, 5])
            }
            Self::Trim { name, given, free, targets } => {
                let pairs = |map: &BTreeMap<String, f64>| map.iter().map(|(k, v)| (k.clone(), *v)).collect();
                let held = Vec::new();
                let (given, targets) = (pairs(given), pairs(targets));
                return TrimCase { name: name.clone(), v_m_s, given, free: free.clone(), targets, held };
            }
        };
        let wings_only = file.surfaces == Surfaces::WingsOnly;
        let mut case = TrimCase {
            name: self.kind().to_owned(),
            v_m_s,
            given: given.into_iter().map(|(name, value)| (name.to_owned(), value)).collect(),
            free: std::iter::once("alpha_deg".to_owned()).collect(),
            targets: vec![(MOTIONS[2].to_owned(), n)],
            held: Vec::new(),
        };
        if !wings_only {
            case.free.push(elevator);
            case.targets.push((MOTIONS[4].to_owned(), 0.0));
        }
        let kept = |name: &String| !wings_only || (*name != rudder && *name != "beta_deg");
        case.free.extend(free.into_iter().filter(kept));
        let rows = targets.into_iter().filter(|row| !wings_only || *row == 3);
        case.targets.extend(rows.map(|row| (MOTIONS[row].to_owned(), 0.0)));
        if wings_only {
            let asked: Vec<String> = case.targets.iter().map(|(name, _)| name.clone()).collect();
            case.held = MOTIONS.iter().map(|m| (*m).to_owned()).filter(|m| !asked.contains(m)).collect();
        }
        case
    }
}

#[cfg(test)]
mod tests;
