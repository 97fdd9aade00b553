//! `result.json` of `statics`.

use schemars::JsonSchema;
use serde::Serialize;

/// A structure under a load set.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StaticsResult {
    /// Name of the command.
    pub(crate) command: &'static str,
    /// Name of the structure.
    pub(crate) structure: String,
    /// The subcase; absent where the deck has one boundary condition only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) subcase: Option<u32>,
    /// The load set; zero where only motions are enforced.
    pub(crate) load_set: u32,
    /// Whether deflections are large.
    pub(crate) large_deflections: bool,
    /// Number of grids.
    pub(crate) grids: usize,
    /// Number of motions that are not held.
    pub(crate) free_motions: usize,
    /// Sum of the loads: x, y, z; at the places of the end if deflections are large.
    pub(crate) applied_force_n: [f64; 3],
    /// Their moment about the origin of the basic system.
    pub(crate) applied_moment_nm: [f64; 3],
    /// The grid that moves most.
    pub(crate) grid: u32,
    /// Its displacement: x, y, z.
    pub(crate) displacement_m: [f64; 3],
    /// What linear theory says of it.
    pub(crate) linear_displacement_m: [f64; 3],
    /// Equilibria on the way of the load; none for small deflections.
    pub(crate) steps: Vec<StepResult>,
    /// The largest rotation of a grid against the frame of its element, where deflections are large: beyond some 30 the element is
    /// too long.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) largest_local_rotation_deg: Option<f64>,
    /// Wall clock.
    pub(crate) seconds: f64,
    /// The other subcases; absent if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) further: Vec<StaticsResult>,
}

/// An equilibrium on the way of the load.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct StepResult {
    /// Share of the load.
    pub(crate) load_factor: f64,
    /// Iterations since the one before.
    pub(crate) iterations: usize,
    /// Displacement of the grid that moves most at the end: x, y, z.
    pub(crate) displacement_m: [f64; 3],
    /// Negative pivots of the tangent, zero for a stable equilibrium; absent where loads follow the structure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) negative_pivots: Option<usize>,
}
