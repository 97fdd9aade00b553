//! Why there is no equilibrium to report.

use crate::flexibility::SingularStructure;

/// The computation of an equilibrium that could not be completed, with the last load factor that was.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NonlinearError {
    /// The undeformed structure can move without force.
    #[error(transparent)]
    Singular(#[from] SingularStructure),
    /// Newton's method finds no equilibrium at a greater load, however small the step.
    #[error(
        "no equilibrium was found beyond {load_factor:.4} of the load (tried: {tried:.4}); {negative} \
         negative pivots there (hint: this load cannot be carried, or the structure snaps through)"
    )]
    Stalled {
        /// Last converged load factor.
        load_factor: f64,
        /// The smallest load factor that was tried in vain.
        tried: f64,
        /// Negative pivots of the last tangent that was tried.
        negative: usize,
    },
    /// The equilibrium becomes unstable: a limit of the load or a bifurcation.
    #[error(
        "the equilibrium becomes unstable between {load_factor:.4} and {unstable:.4} of the load: GRID {grid} \
         component {component} moves most (hint: buckling or a limit of the load; what follows is no statics)"
    )]
    Unstable {
        /// Last stable load factor.
        load_factor: f64,
        /// First load factor found unstable.
        unstable: f64,
        /// Grid that moves most in the mode that loses its stiffness.
        grid: u32,
        /// Its component, 1 to 6.
        component: u8,
        /// That mode, g-set, largest entry one.
        mode: Vec<f64>,
    },
    /// An element or tie that holds for small rotations only has turned too far.
    #[error(
        "{owner} holds for rotations up to {limit_deg:.0} degrees, and its grids turn by {turned_deg:.1} at {load_factor:.4} \
         of the load (hint: use a rigid element, a bush or a beam that turns with the structure)"
    )]
    Turned {
        /// The card.
        owner: String,
        /// Rotation, deg.
        turned_deg: f64,
        /// Greatest rotation for which it holds, deg.
        limit_deg: f64,
        /// Load factor at which this was found.
        load_factor: f64,
    },
}

impl NonlinearError {
    /// The last share of the load that was reached in equilibrium.
    pub fn reached(&self) -> f64 {
        match self {
            Self::Singular(_) => 0.0,
            Self::Stalled { load_factor, .. }
            | Self::Unstable { load_factor, .. }
            | Self::Turned { load_factor, .. } => *load_factor,
        }
    }
}
