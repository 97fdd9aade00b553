//! Stations along the span at which the loads of everything outboard are given beside the balance's.

use crate::planform::Fault;
use crate::planform::check::within;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A monitoring station as a wing's file describes it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StationAt {
    /// Name, part of the channels' names: `Fz_NAME_N`.
    pub name: String,
    /// Boxes and masses with a larger y count.
    pub y_m: f64,
    /// x of the point moments count about; left out: the balance's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_m: Option<f64>,
    /// z of that point; left out: the balance's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z_m: Option<f64>,
}

/// Names that make columns of a CSV file, each once, and places that are numbers.
pub(super) fn check(stations: &[StationAt]) -> Result<(), Fault> {
    for (index, station) in stations.iter().enumerate() {
        let name = &station.name;
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if name.is_empty() || !name.chars().all(plain) {
            let message = format!("the station's name {name:?} cannot be a column's");
            return Err(Fault::field("stations", message, "use letters, digits, - and _"));
        }
        if stations[..index].iter().any(|other| other.name == *name) {
            let message = format!("two stations are called {name}");
            return Err(Fault::field("stations", message, "give every station its own name"));
        }
        within("y_m", station.y_m, -1e4, 1e4)?;
        within("x_m", station.x_m.unwrap_or(0.0), -1e4, 1e4)?;
        within("z_m", station.z_m.unwrap_or(0.0), -1e4, 1e4)?;
    }
    Ok(())
}
