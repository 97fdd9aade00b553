//! The elements as cells of a mesh, for pictures: which nodes, in which order, of what shape.

pub use crate::cell_shape::CellShape;
use crate::model::registry::{self, ElementCard, TieCard, Visitor};
use crate::system::System;
use nastran::{BulkData, InputError};
use std::collections::BTreeMap;

/// One element, or one arm of a rigid element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MeshCell {
    /// The element's number.
    pub id: u32,
    /// Its shape.
    pub shape: CellShape,
    /// Positions of its nodes in [`System::node_ids`].
    pub nodes: Vec<usize>,
    /// True for the arm of a rigid element (RBE2, RBE3, RBAR).
    pub is_rigid: bool,
}

/// The cells of elements with an extent while they are gathered.
struct Cells<'a> {
    system: &'a System,
    elements: Vec<MeshCell>,
    arms: Vec<MeshCell>,
}

impl Cells<'_> {
    /// A cell, unless the structure does not have one of its grids.
    fn cell(&self, id: u32, shape: CellShape, grids: &[u32], is_rigid: bool) -> Option<MeshCell> {
        let nodes = grids.iter().map(|grid| self.system.node_index(*grid)).collect::<Option<_>>()?;
        Some(MeshCell { id, shape, nodes, is_rigid })
    }
}

impl Visitor for Cells<'_> {
    fn elements<C: ElementCard>(&mut self, cards: &BTreeMap<u32, C>) -> Result<(), InputError> {
        for (id, card) in cards {
            let cell = card.cell().and_then(|(shape, grids)| self.cell(*id, shape, &grids, false));
            self.elements.extend(cell);
        }
        Ok(())
    }

    fn ties<'a, C: TieCard + 'a>(
        &mut self,
        cards: impl IntoIterator<Item = &'a C>,
    ) -> Result<(), InputError> {
        for (id, arms) in cards.into_iter().map(TieCard::arms) {
            for grids in arms {
                self.arms.extend(self.cell(id, CellShape::Line, &grids, true));
            }
        }
        Ok(())
    }
}

/// All elements with an extent: lines (beams, rods, bushes, springs), shells, solids, then the arms of rigid elements;
/// each kind in ascending number. Nodes that the structure does not have are skipped with their cell.
///
/// # Panics
/// Never: gathering cells does not fail.
pub fn cells(bulk: &BulkData, system: &System) -> Vec<MeshCell> {
    let mut cells = Cells { system, elements: Vec::new(), arms: Vec::new() };
    registry::visit(bulk, &mut cells).expect("gathering cells does not fail");
    cells.elements.sort_by_key(|cell| cell.shape.dimensions());
    cells.elements.append(&mut cells.arms);
    cells.elements
}
