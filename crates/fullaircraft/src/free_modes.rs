//! The free aircraft in its natural modes: six rigid motions and the elastic ones up to a frequency, with the pressures
//! each of them causes by its shape and by its velocity.

use crate::aircraft::Aircraft;
use crate::error::AircraftError;
use faer::Mat;
use std::f64::consts::TAU;
use structure::{count_below, normal_modes};

/// Modes of the free aircraft; columns are modes.
#[derive(Debug, Clone)]
pub struct FreeModes {
    /// Natural frequencies, rad/s: the first six are zero.
    pub omega_rad_s: Vec<f64>,
    /// Shapes in the g-set, normalised to a modal mass of one.
    pub shapes: Mat<f64>,
    /// Displacements of the boxes (h and theta, two rows a box).
    pub boxes: Mat<f64>,
    /// Pressure coefficients per unit of the mode: of the boxes' incidence theta.
    pub cp_shape: Mat<f64>,
    /// Pressure coefficients per unit of the mode's velocity, times V: of the incidence `chord/4 theta' - h'`.
    pub cp_rate: Mat<f64>,
}

impl FreeModes {
    /// Computes the modes and their pressures.
    ///
    /// # Errors
    /// If the modes do not converge.
    pub fn new(aircraft: &Aircraft) -> Result<Self, AircraftError> {
        let system = &aircraft.free;
        let count = count_below(system, TAU * aircraft.file.modes_up_to_hz)?.max(RIGID);
        let modes = normal_modes(system, count)?;
        let shapes = system.expand(modes.shapes.as_ref());
        let boxes = aircraft.spline.displace(shapes.as_ref());
        let lattice = &aircraft.flow.lattice;
        let theta = Mat::from_fn(lattice.len(), count, |j, mode| boxes[(2 * j + 1, mode)]);
        // The incidence is taken at the three-quarter point, a quarter of the chord behind the midpoint.
        let rate = Mat::from_fn(lattice.len(), count, |j, mode| {
            lattice.boxes[j].chord_m() / 4.0 * boxes[(2 * j + 1, mode)] - boxes[(2 * j, mode)]
        });
        Ok(Self {
            omega_rad_s: modes.omega_rad_s,
            cp_shape: aircraft.flow.pressures(theta.as_ref()),
            cp_rate: aircraft.flow.pressures(rate.as_ref()),
            shapes,
            boxes,
        })
    }

    /// Natural frequencies, Hz.
    pub fn frequencies_hz(&self) -> Vec<f64> {
        self.omega_rad_s.iter().map(|omega| omega / TAU).collect()
    }

    /// Number of modes.
    pub fn len(&self) -> usize {
        self.omega_rad_s.len()
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.omega_rad_s.is_empty()
    }
}

/// A free structure has six rigid motions.
const RIGID: usize = 6;
