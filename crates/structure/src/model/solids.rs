//! Solids: CHEXA, CPENTA and CTETRA with PSOLID and MAT1 or MAT9.

use super::build::{Builder, found, loss_of, present, undefined};
use super::registry::ElementCard;
use crate::cell_shape::CellShape;
use crate::element::Element;
use crate::solid::{QuadraticSolid, Solid};
use crate::solid_material::SolidMaterial;
use nalgebra::{Matrix3, Point3, Vector3, Vector6};
use nastran::{BulkData, InputError, Psolid, SolidElement, SolidPoints, SolidShear};
use std::sync::Arc;

/// A solid of either kind.
enum AnySolid {
    Plain(Solid),
    WithEdges(QuadraticSolid),
}

impl ElementCard for SolidElement {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        Ok(match builder.solid(self)? {
            AnySolid::Plain(solid) => Arc::new(solid),
            AnySolid::WithEdges(solid) => Arc::new(solid),
        })
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        let shape = match self.grids.len() {
            4 => CellShape::Tetrahedron,
            6 => CellShape::Wedge,
            _ => CellShape::Hexahedron,
        };
        Some((shape, self.grids.clone()))
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        loss_of(bulk, bulk.solid_properties.get(&self.property).map(|property| property.material))
    }
}

impl Builder<'_> {
    fn solid(&mut self, card: &SolidElement) -> Result<AnySolid, InputError> {
        let builder = self;
        let kind = match card.grids.len() {
            8 => "CHEXA",
            6 => "CPENTA",
            _ => "CTETRA",
        };
        let user = format!("{kind} {}", card.id);
        let property = found(&builder.bulk.solid_properties, card.property, &user, "PSOLID", &card.span)?;
        let (edges, midsides) = present(&card.midsides);
        let grids: Vec<u32> = card.grids.iter().copied().chain(midsides).collect();
        let nodes = builder.nodes_of(&grids, &user, &card.span)?;
        let points: Vec<Point3<f64>> = nodes.iter().map(|node| builder.nodes[*node].point).collect();
        let known = builder.solid_materials.get(&property.id).filter(|_| property.cordm == 0);
        let material = if let Some(known) = known {
            Arc::clone(known)
        } else {
            let middle =
                points.iter().map(|point| point.coords).sum::<Vector3<f64>>() / (points.len() as f64);
            let made = Arc::new(builder.solid_material(property, &Point3::from(middle))?);
            builder.solid_materials.insert(property.id, Arc::clone(&made));
            made
        };
        if !edges.is_empty() {
            let solid = QuadraticSolid::new(card.id, nodes, &points, &edges, &material, &card.span)?;
            return Ok(AnySolid::WithEdges(solid));
        }
        let solid = Solid::new(card.id, nodes, &points, &material, &card.span)?;
        let solid = if builder.nastran.is_some() { solid.as_nastran() } else { solid };
        let has_bubbles = matches!(property.points, SolidPoints::Usual);
        let is_standard = property.shear == SolidShear::Full && !has_bubbles;
        Ok(AnySolid::Plain(if is_standard { solid.standard() } else { solid }))
    }

    /// Forces (N) by degree of freedom of the g-set that hold a solid whose grids are warmer by `rises`; `strain` is its free strain a degree.
    pub(super) fn solid_expansion(
        &mut self,
        card: &SolidElement,
        strain: &Vector6<f64>,
        rises: &[f64],
    ) -> Result<Vec<(usize, f64)>, InputError> {
        let (dofs, forces) = match self.solid(card)? {
            AnySolid::Plain(solid) => (solid.dofs(), solid.thermal_forces(strain, rises)),
            AnySolid::WithEdges(solid) => (solid.dofs(), solid.thermal_forces(strain, rises)),
        };
        Ok(dofs.into_iter().zip(forces.iter().copied()).collect())
    }

    fn solid_material(&self, card: &Psolid, place: &Point3<f64>) -> Result<SolidMaterial, InputError> {
        let bulk = self.bulk;
        if let Some(material) = bulk.materials.get(&card.material) {
            return SolidMaterial::from_mat1(material);
        }
        let user = format!("PSOLID {}", card.id);
        let Some(material) = bulk.solid_materials.get(&card.material) else {
            let known: Vec<&u32> = bulk.materials.keys().chain(bulk.solid_materials.keys()).collect();
            return Err(undefined(&user, "MAT1 or MAT9", card.material, known.into_iter(), &card.span));
        };
        let axes = match u32::try_from(card.cordm) {
            Ok(0) => Matrix3::identity(),
            Ok(system) => self.frames.axes_at_point(system, place, &card.span)?,
            Err(_) => {
                let message = format!(
                    "{user}: element axes (CORDM {}) for an anisotropic material are not read",
                    card.cordm
                );
                let help = "name a coordinate system in CORDM, 0 for the basic one";
                return Err(InputError::at(&card.span, message).with_help(help));
            }
        };
        SolidMaterial::from_mat9(material, &axes)
    }
}
