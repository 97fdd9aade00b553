//! Effective modal masses: how much of the mass each mode moves along and about each axis.
//!
//! Of a mode x with x^T M x = 1 and a rigid motion r of the base it is (x^T M r)^2. Summed over all modes the
//! translational ones give the mass that is not on clamped motions; the sums tell whether enough modes are taken for a
//! given excitation of the base.

use crate::modes::Modes;
use crate::system::System;
use nalgebra::Point3;

/// One row a mode: mass along x, y, z (kg) and inertia about x, y, z through `about` (kg m^2).
pub fn effective_masses(system: &System, modes: &Modes, about: &Point3<f64>) -> Vec<[f64; 6]> {
    let momentum = system.inertia_loads(system.rigid_body(about).as_ref());
    let factors = system.expand(modes.shapes.as_ref()).transpose() * momentum;
    let row = |mode: usize| std::array::from_fn(|axis| factors[(mode, axis)].powi(2));
    (0..modes.omega_rad_s.len()).map(row).collect()
}
