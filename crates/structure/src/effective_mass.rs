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

/// The mass (kg) that moves with the whole along x, y, z, of which the translational effective masses are parts; concentrated masses of single
/// components (CMASS2, CONM1) make it differ by axis.
pub fn masses_along(system: &System) -> [f64; 3] {
    let rigid = system.rigid_body(&Point3::origin());
    let momentum = system.inertia_loads(rigid.subcols(0, 3));
    std::array::from_fn(|axis| (0..rigid.nrows()).map(|dof| rigid[(dof, axis)] * momentum[(dof, axis)]).sum())
}
