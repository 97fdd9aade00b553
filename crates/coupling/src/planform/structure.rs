//! The two ways a parametric wing may be built: a beam, or shells around a solid core.

use super::{BeamStructure, FIRST_SENSOR_GRID, Fault, Mount, Planform, PointMass, ShellSolid};
use nalgebra::Point3;
use nastran::{BulkData, InputError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What the wing is made of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub enum Structure {
    /// A beam along the elastic axis.
    Beam(BeamStructure),
    /// Laminates around a foam core.
    ShellSolid(Box<ShellSolid>),
}

impl Structure {
    /// Masses beside those of the structure itself.
    pub fn point_masses(&self) -> &[PointMass] {
        match self {
            Self::Beam(beam) => &beam.point_masses,
            Self::ShellSolid(shell) => &shell.point_masses,
        }
    }

    /// Masses beside those of the structure itself, to be changed.
    pub fn point_masses_mut(&mut self) -> &mut Vec<PointMass> {
        match self {
            Self::Beam(beam) => &mut beam.point_masses,
            Self::ShellSolid(shell) => &mut shell.point_masses,
        }
    }

    /// Accelerometers.
    pub fn sensors(&self) -> &[PointMass] {
        match self {
            Self::Beam(beam) => &beam.sensors,
            Self::ShellSolid(shell) => &shell.sensors,
        }
    }

    /// Names and grids of the sensors, in the file's order.
    pub(super) fn sensor_grids(&self) -> Vec<(String, u32)> {
        self.sensors().iter().map(|sensor| sensor.name.clone()).zip(FIRST_SENSOR_GRID..).collect()
    }

    /// The file of stiffness and mass over the span, if there is one.
    pub(crate) fn distribution(&self) -> Option<&String> {
        match self {
            Self::Beam(beam) => Some(&beam.distribution),
            Self::ShellSolid(_) => None,
        }
    }

    /// As [`Structure::distribution`], to rename it.
    pub(crate) fn distribution_mut(&mut self) -> Option<&mut String> {
        match self {
            Self::Beam(beam) => Some(&mut beam.distribution),
            Self::ShellSolid(_) => None,
        }
    }

    pub(super) fn check(&self, planform: &Planform) -> Result<(), Fault> {
        match self {
            Self::Beam(beam) => beam.check(planform.semispan_m),
            Self::ShellSolid(shell) => shell.check(planform),
        }
    }

    pub(super) fn add_to(
        &self,
        bulk: &mut BulkData,
        planform: &Planform,
        folder: &Path,
        mount: Mount,
        balance: &Point3<f64>,
    ) -> Result<(), InputError> {
        match self {
            Self::Beam(beam) => beam.add_to(bulk, planform, folder, mount),
            Self::ShellSolid(shell) => shell.add_to(bulk, planform, folder, mount, balance),
        }
    }
}
