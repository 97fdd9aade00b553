//! The beam by influence coefficients: what every unit load bends, from the principle of virtual forces, and masses lumped in
//! slices that stand off the axis. No stiffness matrix is assembled.
//!
//! The axis is straight and swept; sections along x are rigid. A slice moves with the axis: up by `w`, by the slope `f` of
//! bending along the axis and by the twist `t` about it (nose up). A point `dx` aft of the axis and `dy` further out moves by
//! `w + (dx sin L + dy cos L) f - (dx cos L - dy sin L) t`.

mod axis;
mod flexibility;
mod modes;
mod slices;

pub use axis::{Axis, Stiffness};
pub use modes::{Modes, Shape};
pub use slices::{Beam, Extra, Slice};
