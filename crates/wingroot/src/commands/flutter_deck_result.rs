//! `result.json` of `flutter --deck`; velocities, densities and lengths in the deck's units.

use schemars::JsonSchema;
use serde::Serialize;

/// Flutter of a deck.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct DeckFlutter {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// The deck.
    pub(crate) deck: String,
    /// Subcases that select a FLUTTER, in the deck's order.
    pub(crate) subcases: Vec<SubcaseFlutter>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// One subcase.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SubcaseFlutter {
    /// Its number; zero without a case control.
    pub(crate) subcase: u32,
    /// Its label.
    pub(crate) label: String,
    /// Its FLUTTER card.
    pub(crate) flutter: u32,
    /// Number of aerodynamic boxes.
    pub(crate) boxes: usize,
    /// Natural frequencies of the modes that are kept.
    pub(crate) frequencies_hz: Vec<f64>,
    /// How many of them are rigid motions.
    pub(crate) rigid_modes: usize,
    /// Densities and Mach numbers, or one list of matched points.
    pub(crate) conditions: Vec<Condition>,
}

/// One density and Mach number, or a list of matched points.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Condition {
    /// Mach number; the first of matched points.
    pub(crate) mach: f64,
    /// Lowest and highest Mach number.
    pub(crate) machs: [f64; 2],
    /// Density; the first of matched points.
    pub(crate) density: f64,
    /// Lowest and highest airspeed.
    pub(crate) speeds: [f64; 2],
    /// Every airspeed at which a root becomes stable or unstable.
    pub(crate) changes_of_stability: Vec<Change>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

/// A root becomes stable or unstable.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Change {
    /// Airspeed.
    pub(crate) velocity: f64,
    /// Mach number; between two matched points in proportion to the airspeed.
    pub(crate) mach: f64,
    /// Density.
    pub(crate) density: f64,
    /// Frequency; zero for divergence.
    pub(crate) frequency_hz: f64,
    /// The branch, counted from 1.
    pub(crate) branch: usize,
    /// `unstable` or `stable`.
    pub(crate) becomes: &'static str,
    /// Whether the reduced frequency is beyond those of MKAERO1 and MKAERO2, whose last Re Q and Im Q/k are held: a hint only.
    pub(crate) beyond_table: bool,
}
