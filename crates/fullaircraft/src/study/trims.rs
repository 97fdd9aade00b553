//! What a study says of trims.

use super::fault::{Fault, is_above_zero};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A control of the pilot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// Its name.
    pub name: String,
    /// Control surfaces (AESURF) and how far each goes by a unit of the control; the value of the first is what trims give.
    pub moves: Vec<(String, f64)>,
}

/// What is balanced.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Balance {
    /// Heave and pitch, with the angle of attack and one control.
    #[default]
    Pitch,
    /// Heave, pitch, roll and yaw, with the angle of attack and three controls; to the side the aircraft may accelerate.
    /// Where a study has such a trim, its trims in pitch may accelerate to the side, in roll and in yaw.
    AllAxes,
}

/// One trim.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Point {
    /// Its name.
    pub name: String,
    /// Mach number of the air forces.
    pub mach: f64,
    /// Airspeed.
    pub v: f64,
    /// Density.
    pub rho: f64,
    /// Load factor.
    #[serde(default = "one")]
    pub load_factor: f64,
    /// Pitch rate, degrees per unit of time.
    #[serde(default)]
    pub pitch_rate_deg: f64,
    /// What is balanced.
    #[serde(default)]
    pub balance: Balance,
    /// Controls that balance it.
    pub free: Vec<String>,
    /// Controls with a deflection, degrees of their first surface; all others are at zero.
    #[serde(default)]
    pub held_deg: BTreeMap<String, f64>,
}

const fn one() -> f64 {
    1.0
}

/// What is wrong with the trims and the controls, if anything is.
pub(super) fn fault(trims: &[Point], controls: &[Control], is_half: bool) -> Option<Fault> {
    if let Some(value) = trims.iter().flat_map(|trim| [trim.v, trim.rho]).find(|value| !is_above_zero(*value))
    {
        let message = format!("{value} where an airspeed or density above zero is expected");
        return Some(Fault::new("trims", message));
    }
    if is_half && trims.iter().any(|trim| trim.balance == Balance::AllAxes) {
        return Some(Fault::new(
            "balance",
            "half an aircraft neither rolls nor yaws: AllAxes needs a whole one",
        ));
    }
    let still =
        controls.iter().find(|control| control.moves.first().is_none_or(|(_, factor)| *factor == 0.0));
    if let Some(control) = still {
        let message = format!("the control {} moves no surface at first", control.name);
        return Some(Fault::new("controls", message));
    }
    trims.iter().find_map(|trim| of_controls(trim, controls))
}

/// Whether a trim has as many free controls as it needs, each there and once.
fn of_controls(trim: &Point, controls: &[Control]) -> Option<Fault> {
    let wanted = match trim.balance {
        Balance::Pitch => 1,
        Balance::AllAxes => 3,
    };
    if trim.free.len() != wanted {
        let message = format!("{} has {} free controls, {wanted} balance it", trim.name, trim.free.len());
        return Some(Fault::new("free", message));
    }
    let twice =
        |(at, name): &(usize, &String)| trim.held_deg.contains_key(*name) || trim.free[..*at].contains(name);
    if let Some((_, name)) = trim.free.iter().enumerate().find(twice) {
        let message = format!("{}: {name} balances it twice, or is held as well", trim.name);
        return Some(Fault::new("free", message));
    }
    let is_missing = |name: &&String| controls.iter().all(|control| control.name != **name);
    trim.free.iter().chain(trim.held_deg.keys()).find(is_missing).map(|name| {
        let there: Vec<&str> = controls.iter().map(|control| control.name.as_str()).collect();
        Fault::new("free", format!("{}: there is no control {name}", trim.name))
            .with_help(format!("there are {}", there.join(", ")))
    })
}
