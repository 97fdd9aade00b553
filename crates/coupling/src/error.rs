//! What can go wrong between structure and air.

use aero::AeroError;
use nastran::InputError;
use structure::SingularStructure;
use structure::nonlinear::NonlinearError;

/// Why a coupled wing cannot be built or solved.
#[derive(Debug, thiserror::Error)]
pub enum CouplingError {
    /// A file is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The structure is not held.
    #[error("{0}")]
    Singular(#[from] SingularStructure),
    /// The lattice cannot be solved.
    #[error("{0}")]
    Aero(#[from] AeroError),
    /// A spline names a degree of freedom that the reduced structure lacks.
    #[error("the spline uses degree of freedom {dof} of the structure, which was not kept")]
    SplineOutsideStructure {
        /// Index in the g-set.
        dof: usize,
    },
    /// The wing diverges at this dynamic pressure.
    #[error("the wing diverges: dynamic pressure {q_pa:.1} Pa is at or beyond its divergence pressure{}",
        .divergence_pa.map_or(String::new(), |q| format!(" of {q:.1} Pa")))]
    Diverged {
        /// Dynamic pressure asked for, Pa.
        q_pa: f64,
        /// Lowest divergence pressure, Pa, if it was computed.
        divergence_pa: Option<f64>,
    },
    /// The bent wing does not carry itself.
    #[error("no equilibrium of the wing under its own weight was found: {0}")]
    OwnWeight(NonlinearError),
    /// No (stable) equilibrium of the bent wing in the air.
    #[error(
        "no stable equilibrium of the bent wing was found at {v_m_s:.2} m/s and {alpha_deg:.2} degrees; the last one was at \
        {reached_m_s:.2} m/s and {reached_deg:.2} degrees: {why}"
    )]
    NotInEquilibrium {
        /// Airspeed asked for, m/s.
        v_m_s: f64,
        /// Angle of attack asked for, degrees.
        alpha_deg: f64,
        /// Airspeed of the last equilibrium, m/s.
        reached_m_s: f64,
        /// Its angle of attack, degrees.
        reached_deg: f64,
        /// What went wrong beyond it.
        why: String,
    },
    /// No balanced equilibrium of the bent body in flight.
    #[error(
        "no balanced equilibrium of the bent aircraft was found at {v_m_s:.2} m/s and load factor {load_factor:.3}; the last one was \
        at load factor {reached:.3}: {why}"
    )]
    NotBalanced {
        /// Airspeed, m/s.
        v_m_s: f64,
        /// Load factor asked for.
        load_factor: f64,
        /// Of the last equilibrium.
        reached: f64,
        /// What went wrong beyond it.
        why: String,
    },
    /// Something has the wrong length.
    #[error("{what}: {got} values, expected {expected}")]
    Size {
        /// What was counted.
        what: &'static str,
        /// Its length.
        got: usize,
        /// The length needed.
        expected: usize,
    },
}

impl CouplingError {
    /// Whether the wing has no stable equilibrium at the loads that were asked for: beyond its divergence, or bent too far.
    pub fn is_without_equilibrium(&self) -> bool {
        matches!(self, Self::Diverged { .. } | Self::NotInEquilibrium { .. })
    }
}
