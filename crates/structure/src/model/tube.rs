//! Rods of a tube's section (CTUBE).

use super::build::{Builder, found, loss_of};
use super::registry::ElementCard;
use crate::cell_shape::CellShape;
use crate::element::Element;
use crate::springs;
use nastran::{BulkData, Crod, Ctube, InputError, Prod};
use std::sync::Arc;

impl ElementCard for Ctube {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let user = format!("CTUBE {}", self.id);
        let end = |grid: u32| builder.node(grid, &user, &self.span);
        let ends = [end(self.grids[0])?, end(self.grids[1])?];
        let tube = found(&builder.bulk.tube_properties, self.property, &user, "PTUBE", &self.span)?;
        let owner = format!("PTUBE {}", tube.id);
        let material = found(&builder.bulk.materials, tube.material, &owner, "MAT1", &tube.span)?;
        let Self { id, property, grids, span } = self.clone();
        let [area, j] = tube.section();
        let section =
            Prod { id: property, material: tube.material, area, j, nsm: tube.nsm, span: span.clone() };
        let rod = Crod { id, property, grids, span };
        Ok(Arc::new(springs::rod(&rod, &builder.nodes, ends, &section, material)?))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        Some((CellShape::Line, self.grids.to_vec()))
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        loss_of(bulk, bulk.tube_properties.get(&self.property).map(|property| property.material))
    }
}
