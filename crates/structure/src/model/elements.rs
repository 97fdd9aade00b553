//! Beams, rods, general elements and masses: cards to elements.

use super::build::{Builder, found, loss_of};
use super::registry::ElementCard;
use crate::beam::{Beam, BeamPlacement};
use crate::beam_load::BeamParts;
use crate::cell_shape::CellShape;
use crate::element::Element;
use crate::masses::PointMass;
use crate::section::Section;
use crate::springs;
use nalgebra::Vector3;
use nastran::{BeamElement, BulkData, Conm1, Conm2, Crod, Genel, InputError, Motion, Orientation, Span};
use std::sync::Arc;

/// What a bar or beam is made of.
///
/// # Errors
/// If something that it names is not there, or its axes are not determined.
pub(super) fn beam_parts<'a>(card: &BeamElement, builder: &Builder<'a>) -> Result<BeamParts<'a>, InputError> {
    let bulk = builder.bulk;
    let user = format!("{} {}", if card.is_beam { "CBEAM" } else { "CBAR" }, card.id);
    let nodes = builder.ends(card.grids, &user, &card.span)?;
    let kind = if card.is_beam { "PBEAM" } else { "PBAR" };
    let property = found(&bulk.beam_properties, card.property, &user, kind, &card.span)?;
    let owner = format!("{} {}", if property.is_beam { "PBEAM" } else { "PBAR" }, property.id);
    let material = found(&bulk.materials, property.material, &owner, "MAT1", &property.span)?;
    let grids = nodes.map(|node| builder.nodes[node].point);
    let orientation = match &card.orientation {
        Orientation::Vector(vector) if card.offt.is_basic => *vector,
        other => builder.orientation(other, nodes[0], &user, &card.span)?,
    };
    // Element axes of offset vectors go from grid to grid.
    let local = springs::line_axes(&(grids[1] - grids[0]), Some(&orientation));
    let mut offsets = [Vector3::zeros(); 2];
    for (end, offset) in offsets.iter_mut().enumerate() {
        let axes = if card.offt.is_element[end] {
            local.ok_or_else(|| no_axes(&user, &card.span))?
        } else {
            builder.nodes[nodes[end]].axes
        };
        *offset = axes * card.offsets[end];
    }
    let placement = BeamPlacement { grids, offsets, orientation, pins: card.pins.clone() };
    Ok(BeamParts { nodes, placement, property, material })
}

impl ElementCard for BeamElement {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let BeamParts { nodes, placement, property, material } = beam_parts(self, builder)?;
        let beam = Beam::new(self.id, nodes, &placement, property, material, &self.span)?;
        if builder.nastran.is_none() {
            Section { property, material }.check_shear()?;
            return Ok(Arc::new(beam));
        }
        Ok(Arc::new(beam.with_nastran_masses(&placement, property, material, builder.bulk.bars_twist)))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        Some((CellShape::Line, self.grids.to_vec()))
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        loss_of(bulk, bulk.beam_properties.get(&self.property).map(|property| property.material))
    }
}

/// The error for offset vectors in element axes that are not there.
fn no_axes(user: &str, span: &Span) -> InputError {
    let message = format!(
        "{user} has offset vectors in element axes, but both grids are at one place or its orientation vector lies along it"
    );
    InputError::at(span, message).with_help("write OFFT as GGG with offset vectors in the grids' axes")
}

impl ElementCard for Crod {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let bulk = builder.bulk;
        let user = format!("CROD {}", self.id);
        let ends = builder.ends(self.grids, &user, &self.span)?;
        let property = found(&bulk.rod_properties, self.property, &user, "PROD", &self.span)?;
        let owner = format!("PROD {}", property.id);
        let material = found(&bulk.materials, property.material, &owner, "MAT1", &property.span)?;
        Ok(Arc::new(springs::rod(self, &builder.nodes, ends, property, material)?))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        Some((CellShape::Line, self.grids.to_vec()))
    }

    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        loss_of(bulk, bulk.rod_properties.get(&self.property).map(|property| property.material))
    }
}

impl ElementCard for Genel {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let user = format!("GENEL {}", self.id);
        let ui = builder.motions(&self.ui, &user, &self.span)?;
        let ud = builder.motions(&self.ud, &user, &self.span)?;
        Ok(Arc::new(springs::general(self, &builder.nodes, &ui, &ud)?))
    }
}

impl ElementCard for Conm2 {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let node = builder.node(self.grid, &format!("CONM2 {}", self.id), &self.span)?;
        Ok(Arc::new(PointMass::from_card(self, node, &builder.nodes[node].point, &builder.frames)?))
    }
}

impl ElementCard for Conm1 {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let node = builder.node(self.grid, &format!("CONM1 {}", self.id), &self.span)?;
        let axes = builder.frames.axes_at_point(self.cid, &builder.nodes[node].point, &self.span)?;
        Ok(Arc::new(springs::mass_matrix(self, node, &axes)))
    }
}

impl Builder<'_> {
    /// Positions of the two grids of a line.
    pub(super) fn ends(&self, [a, b]: [u32; 2], user: &str, span: &Span) -> Result<[usize; 2], InputError> {
        Ok([self.node(a, user, span)?, self.node(b, user, span)?])
    }

    pub(super) fn orientation(
        &self,
        orientation: &Orientation,
        end_a: usize,
        user: &str,
        span: &Span,
    ) -> Result<Vector3<f64>, InputError> {
        match orientation {
            Orientation::Vector(v) => Ok(self.nodes[end_a].axes * v),
            Orientation::Grid(id) => {
                let node = self.node(*id, &format!("{user} (orientation)"), span)?;
                Ok(self.nodes[node].point - self.nodes[end_a].point)
            }
        }
    }

    pub(super) fn motions(
        &self,
        motions: &[Motion],
        user: &str,
        span: &Span,
    ) -> Result<Vec<(usize, usize)>, InputError> {
        motions.iter().map(|motion| self.motion(*motion, user, span)).collect()
    }
}
