//! Masses at places of the wing: servos, accelerometers, the root section.

use super::Fault;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A mass without inertia of its own, in the plane of the wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointMass {
    /// Its name, unique in the wing.
    pub name: String,
    /// Span station.
    pub y_m: f64,
    /// Place on the chord, 0 at the leading edge.
    pub x_over_c: f64,
    /// Mass.
    pub mass_kg: f64,
}

/// Names must differ, places must be on or near the wing, masses not below zero.
pub(super) fn check_masses<'a>(
    items: impl Iterator<Item = &'a PointMass>,
    semispan_m: f64,
) -> Result<(), Fault> {
    let all: Vec<&PointMass> = items.collect();
    for (index, item) in all.iter().enumerate() {
        let name = &item.name;
        if name.is_empty() || all[..index].iter().any(|other| other.name == *name) {
            return Err(Fault::named(
                name,
                format!("two masses are called \"{name}\""),
                "give each its own name",
            ));
        }
        let inside = (0.0..=semispan_m).contains(&item.y_m) && (-1.0..=2.0).contains(&item.x_over_c);
        if !(inside && item.mass_kg.is_finite() && item.mass_kg >= 0.0) {
            let message = format!(
                "{name} has y_m {}, x_over_c {} and mass_kg {}, one of which cannot be",
                item.y_m, item.x_over_c, item.mass_kg
            );
            let help =
                "expected y_m from 0 to the half span, x_over_c from -1 to 2 and mass_kg not below zero";
            return Err(Fault::named(name, message, help));
        }
    }
    Ok(())
}
