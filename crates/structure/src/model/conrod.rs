//! Rods with their section on the card (CONROD).

use super::build::{Builder, found, loss_of};
use super::registry::ElementCard;
use crate::cell_shape::CellShape;
use crate::element::Element;
use crate::springs;
use nastran::{BulkData, Conrod, Crod, InputError, Prod};
use std::sync::Arc;

impl ElementCard for Conrod {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let user = format!("CONROD {}", self.id);
        let end = |grid: u32| builder.node(grid, &user, &self.span);
        let ends = [end(self.grids[0])?, end(self.grids[1])?];
        let material = found(&builder.bulk.materials, self.material, &user, "MAT1", &self.span)?;
        let Self { id, grids, material: number, area, j, nsm, span } = self.clone();
        let section = Prod { id, material: number, area, j, nsm, span: span.clone() };
        let rod = Crod { id, property: id, grids, span };
        Ok(Arc::new(springs::rod(&rod, &builder.nodes, ends, &section, material)?))
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        Some((CellShape::Line, self.grids.to_vec()))
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        loss_of(bulk, Some(self.material))
    }
}
