//! One doublet lattice for wings that differ in anything but it: those of an ensemble, or one wing by several models.

use aero::{AeroError, DlmSettings, DoubletLattice, Lattice, MirrorPlane};
use coupling::ElasticWing;

/// A doublet lattice with what was factorised of it, and what it is of.
#[derive(Debug)]
pub struct SharedAir {
    lattice: Lattice,
    plane: MirrorPlane,
    mach: f64,
    settings: DlmSettings,
    doublets: DoubletLattice,
}

impl SharedAir {
    /// That of a wing, its doublets integrated as `settings` say.
    ///
    /// # Errors
    /// As [`DoubletLattice::new`].
    pub fn of(wing: &ElasticWing, settings: DlmSettings) -> Result<Self, AeroError> {
        let doublets =
            DoubletLattice::new(&wing.lattice, wing.plane, wing.mach, &settings)?.keeping_factors();
        Ok(Self { lattice: wing.lattice.clone(), plane: wing.plane, mach: wing.mach, settings, doublets })
    }

    /// The doublets, if they are a wing's own.
    pub fn doublets_of(&self, wing: &ElasticWing, settings: DlmSettings) -> Option<&DoubletLattice> {
        let own = self.settings == settings
            && self.plane == wing.plane
            && self.mach == wing.mach
            && self.lattice == wing.lattice;
        own.then_some(&self.doublets)
    }
}
