//! The measured deflection correction of a control surface (paper 1, Eq. 10): how much of a commanded deflection
//! acts, `delta = K(delta_inp, V) delta_inp`, as a table in the wing's file. `maneuver::deflection` interpolates it.

use nastran::suggest::nearest;
use nastran::{BulkData, InputError, place_of};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Largest commanded or equivalent deflection that a table may name, degrees.
const LARGEST_DEG: f64 = 90.0;
/// Largest factor: the linear model is not off by more.
const LARGEST_FACTOR: f64 = 5.0;
/// Airspeeds of a table, m/s.
const AIRSPEEDS_M_S: std::ops::RangeInclusive<f64> = 0.1..=340.0;

/// What one control surface does with a commanded deflection.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeflectionTable {
    /// Name of the control surface.
    pub control: String,
    /// Whether K is the same for both signs (the default: only positive deflections are listed). If not, deflections
    /// of both signs are listed.
    #[serde(default = "yes")]
    pub odd: bool,
    /// What to do at an airspeed beyond the listed ones.
    #[serde(default)]
    pub outside: OutsideAirspeeds,
    /// Airspeeds, ascending.
    pub rows: Vec<DeflectionRow>,
}

/// What to do at an airspeed beyond those of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum OutsideAirspeeds {
    /// Refuse (an airspeed within 2 % of the first or last one takes that one's).
    #[default]
    Refuse,
    /// Take the first or last airspeed's.
    Nearest,
}

/// One airspeed of a [`DeflectionTable`]; either `equivalent_deg` or `factor` is given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeflectionRow {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Commanded deflections, ascending, none of them zero; trailing edge down positive.
    pub commanded_deg: Vec<f64>,
    /// The deflections that give the measured loads in the linear model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub equivalent_deg: Option<Vec<f64>>,
    /// Equivalent over commanded deflection.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor: Option<Vec<f64>>,
}

impl DeflectionRow {
    /// K at each commanded deflection, whichever way it is given.
    pub fn factors(&self) -> Vec<f64> {
        match (&self.factor, &self.equivalent_deg) {
            (Some(factors), _) => factors.clone(),
            (None, Some(equivalents)) => {
                equivalents.iter().zip(&self.commanded_deg).map(|(e, c)| e / c).collect()
            }
            (None, None) => vec![1.0; self.commanded_deg.len()],
        }
    }
}

fn yes() -> bool {
    true
}

/// What is wrong with a table: names that lead to its place, what, and what to do.
type Fault = (Vec<String>, String, String);

/// Checks the tables of a wing's file against each other and the wing's control surfaces.
pub(super) fn check(
    tables: &[DeflectionTable],
    bulk: &BulkData,
    text: &str,
    path: &Path,
) -> Result<(), InputError> {
    let controls: Vec<&str> = bulk.surfaces.values().map(|surface| surface.label.as_str()).collect();
    for (index, table) in tables.iter().enumerate() {
        let fault = known(table, &tables[..index], &controls).or_else(|| table.fault());
        if let Some((anchors, message, help)) = fault {
            let name = format!("\"{}\"", table.control);
            let all: Vec<&str> =
                ["deflection:", &name].into_iter().chain(anchors.iter().map(String::as_str)).collect();
            return Err(InputError::at(&place_of(&all, text, path), message).with_help(help));
        }
    }
    Ok(())
}

/// The control is one of the wing's, and has one table.
fn known(table: &DeflectionTable, earlier: &[DeflectionTable], controls: &[&str]) -> Option<Fault> {
    let name = &table.control;
    if !controls.contains(&name.as_str()) {
        let help = match nearest(name, controls.iter().copied()) {
            Some(meant) => format!("did you mean \"{meant}\"?"),
            None if controls.is_empty() => "the wing has no control surface".to_owned(),
            None => format!("the wing has {}", controls.join(", ")),
        };
        let message = format!("deflection: there is no control surface \"{name}\"");
        return Some((Vec::new(), message, help));
    }
    earlier.iter().any(|other| other.control == *name).then(|| {
        let help = "give each control surface one table with all airspeeds as rows";
        (Vec::new(), format!("{name} has two deflection tables"), help.to_owned())
    })
}

impl DeflectionTable {
    /// What is wrong with the numbers, if anything; whether the wing has the control is asked when its file is read.
    pub fn complaint(&self) -> Option<String> {
        self.fault().map(|(_, message, _)| message)
    }

    fn fault(&self) -> Option<Fault> {
        let name = &self.control;
        if self.rows.is_empty() {
            let help = "list at least one airspeed: (V_m_s: 30.0, commanded_deg: [5.0], factor: [1.0])";
            return Some((
                vec!["rows:".into()],
                format!("the deflection table of {name} has no rows"),
                help.into(),
            ));
        }
        for (index, row) in self.rows.iter().enumerate() {
            // The row's place is behind as many `V_m_s:` as there are rows before it.
            let mut anchors = vec!["V_m_s:".to_owned(); index + 1];
            if !AIRSPEEDS_M_S.contains(&row.v_m_s) {
                let message = format!("V_m_s is {:?}, expected an airspeed from 0.1 to 340 m/s", row.v_m_s);
                return Some((anchors, message, "the unit is in the field's name".into()));
            }
            if index > 0 && row.v_m_s <= self.rows[index - 1].v_m_s {
                let message = format!(
                    "the airspeeds of {name} do not ascend: {} is followed by {}",
                    self.rows[index - 1].v_m_s,
                    row.v_m_s
                );
                return Some((anchors, message, "sort the rows by airspeed, each once".into()));
            }
            if let Some((field, message, help)) = row.fault(self.odd) {
                anchors.push(format!("{field}:"));
                let message = format!("{name} at {} m/s: {message}", row.v_m_s);
                return Some((anchors, message, help.into()));
            }
        }
        None
    }
}

impl DeflectionRow {
    /// The field that is wrong, what is wrong with it and what to do.
    fn fault(&self, odd: bool) -> Option<(&'static str, String, &'static str)> {
        let commanded = &self.commanded_deg;
        let (field, given) = match (&self.equivalent_deg, &self.factor) {
            (Some(values), None) => ("equivalent_deg", values),
            (None, Some(values)) => ("factor", values),
            _ => {
                let help = "factor is equivalent_deg over commanded_deg";
                return Some(("commanded_deg", "give either equivalent_deg or factor".into(), help));
            }
        };
        if commanded.is_empty() {
            return Some(("commanded_deg", "no deflection is listed".into(), "one is enough"));
        }
        if commanded.iter().any(|d| !(d.abs() > 0.0 && d.abs() <= LARGEST_DEG)) {
            let message = "commanded_deg has a number that is zero, no number or beyond 90 degrees".into();
            return Some(("commanded_deg", message, "at zero K is that of the smallest deflection"));
        }
        if commanded.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Some(("commanded_deg", "commanded_deg must ascend".into(), "list each deflection once"));
        }
        if odd && commanded[0] < 0.0 {
            let message = "a negative deflection in an odd table".into();
            return Some(("commanded_deg", message, "write `odd: false` and list both signs"));
        }
        if !odd && (commanded[0] > 0.0 || commanded[commanded.len() - 1] < 0.0) {
            let message = "a table with `odd: false` needs deflections of both signs".into();
            return Some(("commanded_deg", message, "leave `odd` out for the same K both ways"));
        }
        if given.len() != commanded.len() {
            let message = format!("{} numbers for {} deflections", given.len(), commanded.len());
            return Some((field, message, "one for each number of commanded_deg"));
        }
        let wrong = self.factors().into_iter().find(|k| !(0.0..=LARGEST_FACTOR).contains(k));
        wrong.map(|k| {
            let message = format!("a factor of {k:.4}, expected one from 0 to {LARGEST_FACTOR}");
            (field, message, "an equivalent deflection has the sign of the commanded one")
        })
    }
}
