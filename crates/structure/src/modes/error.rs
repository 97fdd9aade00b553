//! Why modes could not be computed.

use crate::flexibility::SingularStructure;

/// Why modes could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModesError {
    /// More modes were asked for than there are motions with mass.
    #[error(
        "{asked} modes were asked for, but the masses allow only {available} (hint: ask for fewer, or give the material a density)"
    )]
    TooMany {
        /// Number asked for.
        asked: usize,
        /// Number of motions with mass.
        available: usize,
    },
    /// A motion has neither stiffness nor mass.
    #[error("a motion has neither stiffness nor mass: {0}")]
    Massless(SingularStructure),
    /// The pivots near this frequency have no certain sign.
    #[error(
        "the modes below {omega_rad_s} rad/s cannot be counted, pivots stay too small (hint: look for motions without stiffness and mass)"
    )]
    Uncountable {
        /// The frequency.
        omega_rad_s: f64,
    },
    /// The iteration did not converge.
    #[error(
        "{asked} modes did not converge, the largest residual is {residual:.1e} (hint: look for stiffnesses or masses many orders of magnitude off)"
    )]
    NotConverged {
        /// Number asked for.
        asked: usize,
        /// Largest residual of the modes asked for.
        residual: f64,
    },
    /// The count of eigenvalues contradicts the modes found, whatever the size of the block.
    #[error(
        "{found} modes were found, but {counted} lie below {omega_rad_s} rad/s (hint: look for stiffnesses or masses many orders of magnitude off)"
    )]
    Incomplete {
        /// Modes found below the frequency.
        found: usize,
        /// Modes counted below it.
        counted: usize,
        /// The frequency.
        omega_rad_s: f64,
    },
}
