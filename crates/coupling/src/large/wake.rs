//! Where vortices go that leave a trailing edge.

use nalgebra::{Rotation3, Vector3};

/// Direction of the wake of all boxes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wake {
    /// Along the stream.
    Stream,
    /// Along x of the structure's axes, whatever the angle of attack: as small deflections have it. A lattice has single vortices
    /// for a wake, which no surface behind may pass within a few of their distances from each other.
    Body,
}

impl Wake {
    /// From the structure's axes, pitched nose up to the stream by `alpha_rad`, to those whose x runs along the wake.
    pub(super) fn axes(self, alpha_rad: f64) -> Rotation3<f64> {
        match self {
            Self::Stream => Rotation3::from_axis_angle(&Vector3::y_axis(), alpha_rad),
            Self::Body => Rotation3::identity(),
        }
    }

    /// Direction of the stream in those.
    pub(super) fn stream(self, alpha_rad: f64) -> Vector3<f64> {
        match self {
            Self::Stream => Vector3::x(),
            Self::Body => Vector3::new(alpha_rad.cos(), 0.0, alpha_rad.sin()),
        }
    }
}
