//! The programs that make the campaigns of `hidden`.

use clap::ValueEnum;

/// The programs that make campaigns.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Truth {
    /// The model's own library with another mesh: fast
    #[default]
    #[value(name = "doublet")]
    DoubletLattice,
    /// A vortex lattice and a beam of their own, which share nothing with the model
    Vortex,
}

impl Truth {
    /// Name in results.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::DoubletLattice => "doublet",
            Self::Vortex => "vortex",
        }
    }

    /// Folder of results if none is named.
    pub(crate) fn folder(self) -> &'static str {
        match self {
            Self::DoubletLattice => "hidden",
            Self::Vortex => "hidden_vortex",
        }
    }
}
