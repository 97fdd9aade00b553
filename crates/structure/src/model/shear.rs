//! Shear panels: CSHEAR with PSHEAR.

use super::build::{Builder, found, loss_of};
use super::registry::ElementCard;
use crate::cell_shape::CellShape;
use crate::element::Element;
use crate::shear_panel;
use nastran::{BulkData, Cshear, InputError};
use std::sync::Arc;

impl ElementCard for Cshear {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let user = format!("CSHEAR {}", self.id);
        let property = found(&builder.bulk.panel_sections, self.property, &user, "PSHEAR", &self.span)?;
        let owner = format!("PSHEAR {}", property.id);
        let material = found(&builder.bulk.materials, property.material, &owner, "MAT1", &property.span)?;
        let mut nodes = [0; 4];
        for (node, grid) in nodes.iter_mut().zip(self.grids) {
            *node = builder.node(grid, &user, &self.span)?;
        }
        let points = nodes.map(|node| builder.nodes[node].point);
        Ok(Arc::new(shear_panel::panel(self.id, nodes, &points, property, material, &self.span)?))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        Some((CellShape::Quadrilateral, self.grids.to_vec()))
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        loss_of(bulk, bulk.panel_sections.get(&self.property).map(|property| property.material))
    }
}
