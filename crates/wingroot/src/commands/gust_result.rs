//! `result.json` of `gust`; velocities, pressures, forces and lengths in the deck's units.

use schemars::JsonSchema;
use serde::Serialize;

/// A deck in gusts.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct GustResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// The deck.
    pub(crate) deck: String,
    /// Subcases that a gust or loads excite, in the deck's order.
    pub(crate) subcases: Vec<SubcaseGust>,
    /// Quantities in random gusts, those that do not move left out.
    pub(crate) random: Vec<RandomQuantity>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// One subcase.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SubcaseGust {
    /// Its number; zero without SUBCASE.
    pub(crate) subcase: u32,
    /// Its label.
    pub(crate) label: String,
    /// Its GUST card; zero where loads alone excite.
    pub(crate) gust: u32,
    /// Airspeed.
    pub(crate) velocity: f64,
    /// Dynamic pressure.
    pub(crate) dynamic_pressure: f64,
    /// Mach number that the air forces are of.
    pub(crate) mach: f64,
    /// Number of aerodynamic boxes.
    pub(crate) boxes: usize,
    /// Natural frequencies of the modes that are kept.
    pub(crate) frequencies_hz: Vec<f64>,
    /// How many of them are rigid motions.
    pub(crate) rigid_modes: usize,
    /// Whether answers are in time (TLOAD and TSTEP); else over frequency.
    pub(crate) in_time: bool,
    /// Displacements and accelerations of grids, and total loads of stations.
    pub(crate) extremes: Vec<Extreme>,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

/// A quantity at its largest and smallest.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Extreme {
    /// `grid 101`, or the name of a station.
    pub(crate) of: String,
    /// `T1` to `R3`, accelerations `acceleration T1` to `acceleration R3`, loads `F1` to `M3`.
    pub(crate) component: String,
    /// Largest value in time; over frequency the largest amplitude.
    pub(crate) highest: f64,
    /// Time of it, s; over frequency the frequency, Hz.
    pub(crate) highest_at: f64,
    /// Smallest value in time; over frequency the smallest amplitude.
    pub(crate) lowest: f64,
    /// Time of it, s; over frequency the frequency, Hz.
    pub(crate) lowest_at: f64,
}

/// A quantity in a random gust.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RandomQuantity {
    /// The set of RANDPS.
    pub(crate) set: u32,
    /// `grid 101`, or the name of a station.
    pub(crate) of: String,
    /// As in the extremes.
    pub(crate) component: String,
    /// Root mean square.
    pub(crate) rms: f64,
    /// Crossings of zero upwards.
    pub(crate) n0_hz: f64,
}
