//! The wing as a shell around a solid core: laminates of any plies on the section's contour, foam inside.
//!
//! The mesh follows the boxes: span stations at the strips' edges and chord lines at the boxes' edges (hinge lines
//! included), each subdivided as the file says. The boxes are flat; the structure has the real section, placed by
//! the same sweep and dihedral, and turned by the twist about the quarter chord.
//!
//! Grids from 1000001 (layer fastest, then chord line, then station), solids from 1000001, shells from 2100001
//! (upper), 2200001 (lower), 2300001 (leading edge), 2400001 (trailing edge), 2500001 (webs), 2600001 (root rib),
//! 2700001 (tip rib). The elastic axis, sensors and point masses have the numbers of the beam's, so that whatever
//! follows the structure (splines, accelerations) need not know which of the two it is.

mod check;
mod contour;
mod counts;
mod integrals;
mod laminates;
mod layup;
mod mesh;
#[cfg(test)]
mod samples;
mod settings;
mod skin;
mod ties;

pub use counts::MeshCounts;
pub use integrals::SectionIntegrals;
pub use settings::{
    Band, Foam, LineMass, MeshSettings, PlyMaterial, PlySettings, Profile, ShellSolid, Surface,
};

use super::{Mount, Planform};
use contour::Contour;
use laminates::Laminates;
use layup::Layup;
use mesh::Mesh;
use nalgebra::Point3;
use nastran::{BulkData, InputError, Span};
use std::path::Path;

/// First grid of the core and the skin on it.
pub const FIRST_MESH_GRID: u32 = 1_000_001;
/// The grid that moves with the root rib, at the balance point.
pub const ROOT_GRID: u32 = 902;
/// The clamped grid on the other side of the balance.
pub const BALANCE_GRID: u32 = 901;
/// The bush between both, and its property.
pub const BALANCE_BUSH: u32 = 901;

impl ShellSolid {
    /// Adds the cards. `balance` is where the tunnel holds the root.
    pub(super) fn add_to(
        &self,
        bulk: &mut BulkData,
        planform: &Planform,
        folder: &Path,
        mount: Mount,
        balance: &Point3<f64>,
    ) -> Result<(), InputError> {
        let contour = Contour::read(planform, folder)?;
        let span = Span::generated("shell-and-solid wing");
        let mesh = Mesh::new(self, planform, &contour)?;
        let mut laminates = Laminates::new(Layup { settings: self, planform }, &contour, &mesh);
        mesh.add_grids(bulk, &span);
        mesh.add_core(bulk, &span);
        mesh.add_shells(bulk, &mut laminates, &span);
        laminates.add_materials(bulk, &span);
        mesh.add_ties(bulk, mount, balance, &span);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
