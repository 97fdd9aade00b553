//! What a lattice can refuse to be computed for.

/// Why no pressures can be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AeroError {
    /// A box has corners on both sides of the plane of symmetry.
    #[error(
        "box {id} crosses the plane of symmetry y = {y_m} m; move the plane to the inner edge of the panels"
    )]
    CrossesPlane {
        /// The box.
        id: u32,
        /// The plane.
        y_m: f64,
    },
    /// A box lies in the plane of symmetry, where it meets its own image.
    #[error("box {id} lies in the plane of symmetry y = {y_m} m, on top of its own image")]
    InPlane {
        /// The box.
        id: u32,
        /// The plane.
        y_m: f64,
    },
    /// Boxes on both sides of the plane: the image would be there twice.
    #[error(
        "box {id} lies on the other side of the plane of symmetry y = {y_m} m than box {other}; give one half only"
    )]
    BothSides {
        /// The box.
        id: u32,
        /// A box of the other half.
        other: u32,
        /// The plane.
        y_m: f64,
    },
    /// The Mach number is not one of a subsonic stream.
    #[error("Mach number {mach} is out of range: the vortex lattice needs 0 <= Mach < 1")]
    Mach {
        /// What was asked for.
        mach: f64,
    },
    /// A frequency that is none.
    #[error("omega/V of {omega_over_v} 1/m is out of range: expected a number that is not negative")]
    Frequency {
        /// What was asked for, 1/m.
        omega_over_v: f64,
    },
    /// A box that the stream sees as a line along itself.
    #[error("box {id} has no width across the stream (y, z), which doublets need")]
    NoWidth {
        /// The box.
        id: u32,
    },
    /// No boxes.
    #[error("the lattice has no boxes")]
    Empty,
    /// The influence matrix has no inverse.
    #[error("the influence matrix is singular at box {id}; look for boxes that lie on top of each other")]
    Singular {
        /// A box whose pressure is not determined.
        id: u32,
    },
}
