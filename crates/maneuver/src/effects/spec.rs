//! What is known of an effect before any data: its parameters, where it sits, what it looks like.

use coupling::WingFile;
use coupling::wing_file::{KnownTo, Servos};
use std::ops::RangeInclusive;

/// A parameter of an effect.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Name with unit, as in results: `Iyy_kg_m2`.
    pub name: String,
    /// Bounds; zero is within.
    pub lower: f64,
    /// Upper bound.
    pub upper: f64,
    /// Plausible size: standard deviation of the prior.
    pub plausible: f64,
    /// What calibration leaves of it, if one determines it before any run is looked at.
    pub calibrated: Option<Calibrated>,
}

impl Parameter {
    /// From its parts; no calibration determines it.
    pub fn new(name: impl Into<String>, bounds: RangeInclusive<f64>, plausible: f64) -> Self {
        let (lower, upper) = bounds.into_inner();
        Self { name: name.into(), lower, upper, plausible, calibrated: None }
    }

    /// Determined by a test to a standard deviation in its own unit; zero: it is none of what stays uncertain.
    pub(super) fn know(&mut self, by: Calibration, sigma: f64) {
        self.calibrated = (sigma > 0.0).then_some(Calibrated { by, sigma });
    }
}

/// How well a wing is known, by its file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Known {
    /// Servos with their standard deviations.
    pub servos: Servos,
    /// The rest.
    pub to: KnownTo,
}

impl From<&WingFile> for Known {
    fn from(file: &WingFile) -> Self {
        Self { servos: file.servos, to: file.known_to }
    }
}

/// How well a calibrated model knows a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calibrated {
    /// By which test.
    pub by: Calibration,
    /// Standard deviation, in the parameter's unit.
    pub sigma: f64,
}

/// Tests that a wing goes through before it is flown, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Calibration {
    /// Static loads and natural modes.
    Stiffness,
    /// Weighing.
    Mass,
    /// Free decay.
    Damping,
    /// Unsteady air beside a second method.
    Air,
    /// Deflected control surfaces.
    Surfaces,
    /// The servos' frequency response.
    Servos,
    /// Zero of the angle of attack.
    Angle,
    /// A pulse common to all channels.
    Clock,
}

/// Where an effect sits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Between wing and balance, and the balance.
    Balance,
    /// The tunnel's stream.
    Flow,
    /// The air around the wing.
    Aerodynamics,
    /// Control surfaces and their servos.
    Control,
    /// The wing's structure and mass.
    Structure,
    /// Sensors and what hangs on them.
    Sensor,
}

impl Side {
    /// Whether the effect stays with the wing when it flies: what belongs to tunnel, balance and sensors does not.
    pub fn travels(self) -> bool {
        matches!(self, Self::Aerodynamics | Self::Control | Self::Structure)
    }
}

/// Where on the way from the wing to the record an effect changes loads: whatever the order in which effects are named, a
/// filter delays what the joiner adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// It is a load on the balance.
    Load,
    /// It is what the balance makes of loads.
    Reading,
    /// It is what amplifiers and clocks make of readings.
    Record,
}

impl Stage {
    /// All, from the wing on.
    pub const ALL: [Self; 3] = [Self::Load, Self::Reading, Self::Record];
}

/// See the module.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spec {
    /// Name.
    pub name: &'static str,
    /// What it is, in words.
    pub title: &'static str,
    /// Where it sits.
    pub side: Side,
    /// Effects that look alike.
    pub rivals: &'static [&'static str],
    /// Experiments that tell it from them.
    pub experiment: &'static str,
}

impl Spec {
    /// Of an effect that is not declared.
    pub(super) const NONE: Self =
        Self { name: "", title: "", side: Side::Aerodynamics, rivals: &[], experiment: "" };

    /// Whether either is known to be taken for the other.
    pub fn is_rival_of(&self, other: &Self) -> bool {
        self.rivals.contains(&other.name) || other.rivals.contains(&self.name)
    }
}

#[cfg(test)]
mod tests;
