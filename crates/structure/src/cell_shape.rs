//! The shapes of cells that elements are drawn as.

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

impl CellShape {
    /// One for a line, two for a surface, three for a body.
    pub(crate) fn dimensions(self) -> u8 {
        match self {
            Self::Line => 1,
            Self::Triangle | Self::Quadrilateral => 2,
            Self::Tetrahedron | Self::Wedge | Self::Hexahedron => 3,
        }
    }
}
