//! What a flat shell is to the assembly.

use super::point::{lumped_mass, mass};
use super::{Shell, andes};
use crate::element::Element;
use nalgebra::{DMatrix, Vector3};
use std::borrow::Cow;

impl Element for Shell {
    fn id(&self) -> u32 {
        self.id
    }
    fn nodes(&self) -> &[usize] {
        &self.nodes
    }
    fn directors(&self) -> Vec<Vector3<f64>> {
        let normals = (0..self.nodes.len()).map(|at| self.normals.get(at).copied().flatten());
        normals.map(|own| self.axes.tr_mul(&own.unwrap_or_else(Vector3::z))).collect()
    }
    fn stiffness(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        Some(Cow::Owned(if !self.triangles.is_empty() {
            self.drilled_stiffness()
        } else if self.corners.len() == 4 && self.is_nastran {
            self.nastran_stiffness(&self.section())
        } else if self.corners.len() == 4 {
            self.bent(&self.quad_points(), self.quad_motions())
        } else if self.drills {
            let points = andes::points(&self.corners, &self.section().membrane);
            self.bent(&self.thickened(points), None)
        } else if self.is_nastran {
            self.nastran_triangle()
        } else {
            self.bent(&self.triangle_points(), self.triangle_motions())
        }))
    }
    fn mass(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        Some(Cow::Owned(if self.corners.len() == 4 {
            self.basic(&mass(&self.quad_points(), &self.section))
        } else {
            self.basic(&mass(&self.triangle_points(), &self.section))
        }))
    }
    fn lumped_mass(&self) -> Option<DMatrix<f64>> {
        Some(if self.corners.len() == 4 {
            lumped_mass(&self.quad_points(), &self.section)
        } else {
            lumped_mass(&self.triangle_points(), &self.section)
        })
    }
}
