//! The free aircraft in its natural modes: six rigid motions and the elastic ones up to a frequency.
//!
//! Elastic modes are made orthogonal to the rigid motions of the mass matrix to round-off, beyond what the eigensolver
//! leaves: the mean axes, in which rigid and elastic motion have no common momentum.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::f64::consts::TAU;
use structure::normal_modes_below;

/// Modes of the free aircraft; columns are modes.
#[derive(Debug, Clone)]
pub struct FreeModes {
    /// Natural frequencies, rad/s: the first six are zero.
    pub omega_rad_s: Vec<f64>,
    /// Shapes in the g-set, normalised to a modal mass of one.
    pub shapes: Mat<f64>,
    /// Displacements of the boxes (h and theta, two rows a box).
    pub boxes: Mat<f64>,
}

impl FreeModes {
    /// A free structure has six rigid motions: column of the first elastic mode.
    pub const FIRST_ELASTIC: usize = 6;

    /// Computes the modes.
    ///
    /// # Errors
    /// If the modes do not converge.
    pub fn new(aircraft: &Aircraft) -> Result<Self, AircraftError> {
        let system = &aircraft.free;
        let modes = normal_modes_below(system, TAU * aircraft.file.modes_up_to_hz, Self::FIRST_ELASTIC)?;
        let count = modes.omega_rad_s.len();
        let mut shapes = system.expand(modes.shapes.as_ref());
        let rigid = system.rigid_body(&aircraft.mass.centre);
        let momentum = system.inertia_loads(rigid.as_ref());
        let mass = rigid.transpose() * &momentum;
        let elastic = shapes.as_ref().subcols(Self::FIRST_ELASTIC, count - Self::FIRST_ELASTIC).to_owned();
        let share = mass.partial_piv_lu().solve(momentum.transpose() * &elastic);
        let free_of_momentum = elastic - &rigid * share;
        shapes
            .as_mut()
            .subcols_mut(Self::FIRST_ELASTIC, count - Self::FIRST_ELASTIC)
            .copy_from(&free_of_momentum);
        let boxes = aircraft.spline.displace(shapes.as_ref());
        Ok(Self { omega_rad_s: modes.omega_rad_s, shapes, boxes })
    }

    /// Natural frequencies, Hz.
    pub fn frequencies_hz(&self) -> Vec<f64> {
        self.omega_rad_s.iter().map(|omega| omega / TAU).collect()
    }

    /// Number of elastic modes.
    pub fn elastic(&self) -> usize {
        self.omega_rad_s.len() - Self::FIRST_ELASTIC
    }

    /// Natural frequencies of the elastic modes, rad/s.
    pub fn elastic_omega_rad_s(&self) -> &[f64] {
        &self.omega_rad_s[Self::FIRST_ELASTIC..]
    }

    /// Entry of an elastic mode in the g-set.
    pub fn elastic_shape(&self, dof: usize, mode: usize) -> f64 {
        self.shapes[(dof, Self::FIRST_ELASTIC + mode)]
    }

    /// What weighs box loads (rows by two columns a box): forces and moments about the centre of gravity along and about x,
    /// y, z, then the generalised forces of the elastic modes.
    pub fn generalised_rows(&self, aircraft: &Aircraft) -> Mat<f64> {
        let rigid = aircraft.spline.displace(aircraft.free.rigid_body(&aircraft.mass.centre).as_ref());
        Mat::from_fn(6 + self.elastic(), rigid.nrows(), |row, k| {
            if row < 6 { rigid[(k, row)] } else { self.boxes[(k, Self::FIRST_ELASTIC + row - 6)] }
        })
    }
}
