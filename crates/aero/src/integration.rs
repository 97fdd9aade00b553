//! Pressures to loads: the matrix S (paper 1, Eq. 4), box by box.
//!
//! The pressure of a box acts at its quarter point along its normal. In the k-set that is a lift along the normal
//! at the midpoint and a nose-up moment about it of chord/4 times the lift.

use crate::lattice::Lattice;
use nalgebra::{Point3, Vector3};

/// Areas and arms of the boxes.
#[derive(Debug, Clone, PartialEq)]
pub struct Integration {
    area_m2: Vec<f64>,
    arm_m: Vec<f64>,
}

/// Loads of all boxes.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxLoads {
    /// `[lift_0, moment_0, lift_1, ...]`: lift along the normal in N, nose-up moment about the midpoint in N m.
    pub values: Vec<f64>,
}

impl Integration {
    /// Areas and arms of a lattice's boxes.
    pub fn new(lattice: &Lattice) -> Self {
        let area_m2 = lattice.boxes.iter().map(crate::AeroBox::area_m2).collect();
        Self { area_m2, arm_m: lattice.boxes.iter().map(|panel| panel.chord_m() / 4.0).collect() }
    }

    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.area_m2.len()
    }

    /// True if there are no boxes.
    pub fn is_empty(&self) -> bool {
        self.area_m2.is_empty()
    }

    /// Area of box `j`, m2.
    ///
    /// # Panics
    /// If there is no such box.
    pub fn area(&self, j: usize) -> f64 {
        self.area_m2[j]
    }

    /// Nose-up moment about the midpoint per unit lift of box `j`: chord/4, m.
    ///
    /// # Panics
    /// If there is no such box.
    pub fn moment_arm(&self, j: usize) -> f64 {
        self.arm_m[j]
    }
}

impl BoxLoads {
    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.values.len() / 2
    }

    /// True if there are no boxes.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Force (N) and moment (N m) of one box on the lattice's axes, the moment about the box midpoint.
    ///
    /// # Panics
    /// If there is no such box.
    pub fn vector(&self, lattice: &Lattice, j: usize) -> (Vector3<f64>, Vector3<f64>) {
        let panel = &lattice.boxes[j];
        (panel.normal() * self.values[2 * j], panel.pitch_axis() * self.values[2 * j + 1])
    }

    /// Sum of some boxes: force (N) and moment (N m) about a point, along x aft, y right, z up.
    ///
    /// # Panics
    /// If there is no such box.
    pub fn resultant(
        &self,
        lattice: &Lattice,
        boxes: impl Iterator<Item = usize>,
        about: &Point3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for j in boxes {
            let (f, m) = self.vector(lattice, j);
            force += f;
            moment += m + (lattice.boxes[j].mid_point() - about).cross(&f);
        }
        (force, moment)
    }
}
