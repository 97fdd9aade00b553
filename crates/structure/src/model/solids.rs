//! Solids: CHEXA, CPENTA and CTETRA with PSOLID and MAT1 or MAT9.

use super::build::{Builder, undefined};
use crate::element::Element;
use crate::solid::Solid;
use crate::solid_material::SolidMaterial;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{InputError, Psolid};
use std::collections::BTreeMap;
use std::sync::Arc;

impl Builder<'_> {
    pub(super) fn solids(&self) -> Result<Vec<Arc<dyn Element>>, InputError> {
        let properties = &self.bulk.solid_properties;
        // One material for all elements of a property, unless its axes turn with the place.
        let mut materials: BTreeMap<u32, Arc<SolidMaterial>> = BTreeMap::new();
        let mut elements: Vec<Arc<dyn Element>> = Vec::with_capacity(self.bulk.solids.len());
        for card in self.bulk.solids.values() {
            let kind = match card.grids.len() {
                8 => "CHEXA",
                6 => "CPENTA",
                _ => "CTETRA",
            };
            let user = format!("{kind} {}", card.id);
            let property = properties
                .get(&card.property)
                .ok_or_else(|| undefined(&user, "PSOLID", card.property, properties.keys(), &card.span))?;
            let nodes = self.nodes_of(&card.grids, &user, &card.span)?;
            let points: Vec<Point3<f64>> = nodes.iter().map(|node| self.nodes[*node].point).collect();
            let material = if let (0, Some(known)) = (property.cordm, materials.get(&property.id)) {
                Arc::clone(known)
            } else {
                let middle =
                    points.iter().map(|point| point.coords).sum::<Vector3<f64>>() / (points.len() as f64);
                let made = Arc::new(self.solid_material(property, &Point3::from(middle))?);
                materials.insert(property.id, Arc::clone(&made));
                made
            };
            elements.push(Arc::new(Solid::new(card.id, nodes, &points, &material, &card.span)?));
        }
        Ok(elements)
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
            Ok(system) => self.axes_at(system, place, &card.span)?,
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
