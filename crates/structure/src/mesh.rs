//! The elements as cells of a mesh, for pictures: which nodes, in which order, of what shape.

use crate::system::System;
use nastran::BulkData;

/// The shape of a cell. The order of the nodes is that of the cards, which is VTK's as well.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellShape {
    /// Two nodes: bars, beams, rods, bushes, springs and the arms of rigid elements.
    Line,
    /// Three nodes.
    Triangle,
    /// Four nodes around.
    Quadrilateral,
    /// Four nodes.
    Tetrahedron,
    /// Six nodes, bottom then top.
    Wedge,
    /// Eight nodes, bottom then top.
    Hexahedron,
}

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

/// All elements with an extent, in the order beams, rods, bushes, springs, shells, solids, rigid elements; each kind in
/// ascending number. Nodes that the structure does not have are skipped with their cell.
pub fn cells(bulk: &BulkData, system: &System) -> Vec<MeshCell> {
    let mut cells = Vec::new();
    let mut add = |id: u32, shape: CellShape, grids: &[u32], is_rigid: bool| {
        if let Some(nodes) = grids.iter().map(|grid| system.node_index(*grid)).collect() {
            cells.push(MeshCell { id, shape, nodes, is_rigid });
        }
    };
    bulk.beams.values().for_each(|beam| add(beam.id, CellShape::Line, &beam.grids, false));
    bulk.rods.values().for_each(|rod| add(rod.id, CellShape::Line, &rod.grids, false));
    for bush in bulk.bushes.values() {
        if let Some(end) = bush.grids.1 {
            add(bush.id, CellShape::Line, &[bush.grids.0, end], false);
        }
    }
    for spring in bulk.springs.values() {
        if let [Some(a), Some(b)] = spring.ends {
            add(spring.id, CellShape::Line, &[a.0, b.0], false);
        }
    }
    for shell in bulk.shells.values() {
        let shape = if shell.grids.len() == 3 { CellShape::Triangle } else { CellShape::Quadrilateral };
        add(shell.id, shape, &shell.grids, false);
    }
    for solid in bulk.solids.values() {
        let shape = match solid.grids.len() {
            4 => CellShape::Tetrahedron,
            6 => CellShape::Wedge,
            _ => CellShape::Hexahedron,
        };
        add(solid.id, shape, &solid.grids, false);
    }
    for link in bulk.rigid.values() {
        link.dependent
            .iter()
            .for_each(|grid| add(link.id, CellShape::Line, &[link.independent, *grid], true));
    }
    for mean in bulk.averages.values() {
        let grids = mean.groups.iter().flat_map(|group| &group.grids);
        grids.for_each(|grid| add(mean.id, CellShape::Line, &[mean.reference, *grid], true));
    }
    bulk.rigid_bars.values().for_each(|bar| add(bar.id, CellShape::Line, &bar.grids, true));
    cells
}
