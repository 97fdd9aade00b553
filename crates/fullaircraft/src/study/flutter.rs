//! What a study says of flutter.

use super::fault::{Fault, is_above_zero};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How densities, Mach numbers and airspeeds go together.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Method {
    /// Every density with every Mach number and every airspeed.
    #[default]
    Pk,
    /// One by one, as matched points: three lists of one length.
    Pknl,
}

/// Densities of flutter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Densities {
    /// Densities themselves.
    Given(Vec<f64>),
    /// Ratios to a reference density.
    Ratios {
        /// The reference density.
        to: f64,
        /// The ratios.
        ratios: Vec<f64>,
    },
}

impl Densities {
    /// The density that ratios are of, and the ratios.
    pub(super) fn ratios(&self) -> (f64, &[f64]) {
        match self {
            Self::Given(densities) => (1.0, densities),
            Self::Ratios { to, ratios } => (*to, ratios),
        }
    }
}

/// Flutter by the p-k method.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flutter {
    /// How the three lists go together.
    #[serde(default)]
    pub method: Method,
    /// Mach numbers of the air forces.
    pub machs: Vec<f64>,
    /// Densities.
    pub densities: Densities,
    /// Airspeeds.
    pub airspeeds: Vec<f64>,
}

impl Flutter {
    /// What is wrong with it, if anything is.
    pub(super) fn fault(&self) -> Option<Fault> {
        let (to, ratios) = self.densities.ratios();
        let lengths = [self.machs.len(), ratios.len(), self.airspeeds.len()];
        for (field, count) in ["machs", "densities", "airspeeds"].into_iter().zip(lengths) {
            if count == 0 {
                return Some(Fault::new(field, "flutter needs Mach numbers, densities and airspeeds"));
            }
        }
        if let Some(mach) = self.machs.iter().find(|mach| !(0.0..1.0).contains(*mach)) {
            let message = format!("a Mach number of {mach}: the doublet lattice is subsonic");
            return Some(Fault::new("machs", message));
        }
        for (field, values) in
            [("densities", ratios), ("densities", &[to][..]), ("airspeeds", &self.airspeeds[..])]
        {
            if let Some(value) = values.iter().find(|value| !is_above_zero(**value)) {
                return Some(Fault::new(field, format!("{value} where a number above zero is expected")));
            }
        }
        let [machs, densities, airspeeds] = lengths;
        (self.method == Method::Pknl && (machs != densities || densities != airspeeds)).then(|| {
            let message = format!(
                "matched points take {machs} Mach numbers, {densities} densities and {airspeeds} airspeeds one by one"
            );
            Fault::new("method", message).with_help("give three lists of one length, or the method Pk")
        })
    }
}
