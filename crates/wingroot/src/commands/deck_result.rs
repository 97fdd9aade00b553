//! `result.json` of `deck`.

use std::collections::BTreeMap;

use coupling::ByLoad;
use schemars::JsonSchema;
use serde::Serialize;

/// A wing written as a Nastran deck.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct DeckResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the wing.
    pub(crate) wing: String,
    /// Fingerprint of the wing's file.
    pub(crate) wing_hash: String,
    /// The deck.
    pub(crate) file: &'static str,
    /// Mass.
    pub(crate) mass_kg: f64,
    /// Number of grids.
    pub(crate) grids: usize,
    /// Number of elements by card.
    pub(crate) elements: BTreeMap<&'static str, usize>,
    /// Natural frequencies, ascending.
    pub(crate) frequencies_hz: Vec<f64>,
    /// Number of aerodynamic boxes.
    pub(crate) boxes: usize,
    /// Number of splines.
    pub(crate) splines: usize,
    /// Deflection under a load at the tip, to compare programs by; null if the structure is not held.
    pub(crate) tip_load: Option<TipLoad>,
    /// Airspeed of the corrections; null without corrections.
    pub(crate) corrections_at_m_s: Option<f64>,
    /// What w2gj.bdf and qjj.op4 do not carry; null where nothing is left out.
    pub(crate) left_out: Option<LeftOutOfDeck>,
    /// The HDF5 file; null if none was asked for.
    pub(crate) model: Option<&'static str>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// Deflections under a load at the outermost spline grid.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TipLoad {
    /// The grid.
    pub(crate) grid: u32,
    /// The load, up.
    #[serde(rename = "fz_N")]
    pub(crate) fz_n: f64,
    /// Its three displacements (m) and three rotations (rad).
    pub(crate) displacement_m_rad: Vec<f64>,
}

/// What w2gj.bdf and qjj.op4 do not carry.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct LeftOutOfDeck {
    /// In words.
    pub(crate) what: &'static str,
    /// Airspeed of the numbers.
    #[serde(rename = "V_m_s")]
    pub(crate) v_m_s: f64,
    /// Density of the air.
    pub(crate) rho_kg_m3: f64,
    /// Angle of attack.
    pub(crate) alpha_deg: f64,
    /// Root loads with all corrections.
    pub(crate) root_loads_complete: ByLoad<f64>,
    /// Root loads with those that are carried.
    pub(crate) root_loads_carried: ByLoad<f64>,
}
