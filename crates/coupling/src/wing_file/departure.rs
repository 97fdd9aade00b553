//! A wing that departs from its drawing: softer or stiffer, with control surfaces that do more or less.

use nastran::BulkData;

/// What a wing departs from its drawing by; by nothing, if nothing is said.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Departure {
    /// Logarithms of the factors on the structure's flexibility in bending and in torsion.
    pub log_flexibility: [f64; 2],
    /// Factors on what control surfaces do, by name.
    pub controls: Vec<(String, f64)>,
}

impl Departure {
    /// Puts it into the cards of the wing as drawn.
    pub(super) fn put_into(&self, bulk: &mut BulkData) {
        if self.log_flexibility != [0.0; 2] {
            soften(bulk, self.log_flexibility);
        }
        for (name, factor) in &self.controls {
            for surface in bulk.surfaces.values_mut().filter(|surface| surface.label == *name) {
                surface.effectiveness *= factor;
            }
        }
    }
}

/// Divides what resists bending (direct moduli) by one factor and what resists torsion (shear moduli) by another, given as
/// logarithms. Springs and given matrices stay: no material says what they are made of.
fn soften(bulk: &mut BulkData, [bending, torsion]: [f64; 2]) {
    let [direct, shear] = [bending, torsion].map(|log| (-log).exp());
    for material in bulk.materials.values_mut() {
        material.e *= direct;
        material.g *= shear;
    }
    for plane in bulk.plane_materials.values_mut() {
        // G11 G12 G13 G22 G23 G33; coupling terms keep the matrix positive with the geometric mean
        let mean = (direct * shear).sqrt();
        for (value, factor) in plane.g.iter_mut().zip([direct, direct, mean, direct, mean, shear]) {
            *value *= factor;
        }
    }
    for ply in bulk.ply_materials.values_mut() {
        ply.e1 *= direct;
        ply.e2 *= direct;
        for value in [&mut ply.g12, &mut ply.g1z, &mut ply.g2z] {
            *value *= shear;
        }
    }
    for solid in bulk.solid_materials.values_mut() {
        solid.g.iter_mut().for_each(|value| *value *= direct);
    }
}
