//! How many cards of each kind a mesh has.

use nastran::BulkData;

/// Numbers of grids and elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeshCounts {
    /// All grids.
    pub grids: usize,
    /// CHEXA.
    pub solids: usize,
    /// CQUAD4.
    pub shells: usize,
    /// RBE3.
    pub averages: usize,
    /// CONM2.
    pub masses: usize,
    /// PCOMP.
    pub laminates: usize,
}

impl MeshCounts {
    /// Counts a deck's cards.
    pub fn of(bulk: &BulkData) -> Self {
        Self {
            grids: bulk.grids.len(),
            solids: bulk.solids.len(),
            shells: bulk.shells.len(),
            averages: bulk.averages.len(),
            masses: bulk.masses.len(),
            laminates: bulk.laminates.len(),
        }
    }
}
