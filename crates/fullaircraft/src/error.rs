//! Why an aircraft cannot be built or flown.

use aero::AeroError;
use coupling::CouplingError;
use maneuver::flutter::FlutterError;
use nastran::InputError;
use structure::{ModesError, SingularStructure};

/// Why an aircraft cannot be built or flown.
#[derive(Debug, thiserror::Error)]
pub enum AircraftError {
    /// A file is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// Structure and air do not go together.
    #[error(transparent)]
    Coupling(#[from] CouplingError),
    /// The structure falls apart when held at the wing's root.
    #[error("{0}")]
    Singular(#[from] SingularStructure),
    /// The lattice cannot be solved.
    #[error("{0}")]
    Aero(#[from] AeroError),
    /// Flutter cannot be computed.
    #[error("{0}")]
    Flutter(#[from] FlutterError),
    /// The natural modes cannot be computed.
    #[error("{0}")]
    Modes(#[from] ModesError),
    /// The integrator of nonlinear flight gave up.
    #[error("the flight cannot be integrated beyond {t_s:.4} s: {why}")]
    Flight {
        /// How far it came, s.
        t_s: f64,
        /// What the integrator says.
        why: String,
    },
    /// No angle of attack and elevator give this flight.
    #[error("{point} at {v_m_s} m/s and load factor {load_factor} cannot be trimmed: {why}")]
    NotTrimmable {
        /// The flight point's name.
        point: String,
        /// Airspeed, m/s.
        v_m_s: f64,
        /// Load factor.
        load_factor: f64,
        /// What is wrong.
        why: String,
    },
}
