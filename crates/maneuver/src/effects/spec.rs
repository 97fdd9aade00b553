//! What is known of an effect before any data: its parameters, where it sits, what it looks like.

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
}

impl Parameter {
    /// From its parts.
    pub fn new(name: impl Into<String>, (lower, upper): (f64, f64), plausible: f64) -> Self {
        Self { name: name.into(), lower, upper, plausible }
    }
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
    /// Whether either is known to be taken for the other.
    pub fn is_rival_of(&self, other: &Self) -> bool {
        self.rivals.contains(&other.name) || other.rivals.contains(&self.name)
    }
}
