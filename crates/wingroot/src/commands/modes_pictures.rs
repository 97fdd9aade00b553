//! Pictures of natural modes: `.vtu` files for ParaView and one figure of the first shapes.

use report::vtu::{CellType, Field, Frame, Mesh};
use report::{Figure, Panel, Series, Style};
use structure::{CellShape, MeshCell, Modes, System};

use crate::structures::Structure;

/// Shapes in the figure.
const SHAPES: usize = 6;

/// Frequencies in Hz.
pub(crate) fn hertz(modes: &Modes) -> Vec<f64> {
    modes.omega_rad_s.iter().map(|omega| omega / std::f64::consts::TAU).collect()
}

/// Displacements and rotations of a mode, six a node, scaled to a largest displacement of one (or rotation, for a
/// mode that displaces nothing).
pub(super) fn scaled(system: &System, modes: &Modes, mode: usize) -> Vec<[f64; 6]> {
    let motion = system.expand(modes.shapes.subcols(mode, 1));
    let node = |node: usize| std::array::from_fn(|component| motion[(6 * node + component, 0)]);
    let mut nodes: Vec<[f64; 6]> = (0..system.node_count()).map(node).collect();
    let length = |six: &[f64; 6], from: usize| six[from..from + 3].iter().map(|v| v * v).sum::<f64>().sqrt();
    let largest = |from: usize| nodes.iter().map(|six| length(six, from)).fold(0.0, f64::max);
    let size = if largest(0) > 0.0 { largest(0) } else { largest(3) };
    if size > 0.0 {
        nodes.iter_mut().flatten().for_each(|value| *value /= size);
    }
    nodes
}

/// The undeformed mesh with displacement and rotation of the nodes, six a node, as point fields.
pub(super) fn vtu(system: &System, cells: &[MeshCell], nodes: &[[f64; 6]]) -> String {
    frame(system, cells).with(&moved(nodes))
}

/// Displacement and rotation of the nodes as point fields ("Warp By Vector" in ParaView).
pub(super) fn moved(nodes: &[[f64; 6]]) -> [Field; 2] {
    [("displacement", 0), ("rotation", 3)].map(|(name, from)| Field {
        name: name.into(),
        components: 3,
        values: nodes.iter().flat_map(|six| &six[from..from + 3]).copied().collect(),
    })
}

/// The undeformed mesh.
pub(super) fn frame(system: &System, cells: &[MeshCell]) -> Frame {
    let kind = |shape: CellShape| match shape {
        CellShape::Line => CellType::Line,
        CellShape::Triangle => CellType::Triangle,
        CellShape::Quadrilateral => CellType::Quadrilateral,
        CellShape::Tetrahedron => CellType::Tetrahedron,
        CellShape::Wedge => CellType::Wedge,
        CellShape::Hexahedron => CellType::Hexahedron,
    };
    let of_cells = |name: &str, value: &dyn Fn(&MeshCell) -> f64| Field {
        name: name.into(),
        components: 1,
        values: cells.iter().map(value).collect(),
    };
    let mesh = Mesh {
        points: system.points().iter().map(|point| [point.x, point.y, point.z]).collect(),
        cells: cells.iter().map(|cell| (kind(cell.shape), cell.nodes.clone())).collect(),
        point_fields: Vec::new(),
        cell_fields: vec![
            of_cells("element", &|cell| f64::from(cell.id)),
            of_cells("rigid_element", &|cell| f64::from(u8::from(cell.is_rigid))),
        ],
    };
    mesh.frame()
}

/// Displacements of all nodes along the longest extent of the structure, a panel a mode; none for a structure that is
/// a point.
pub(super) fn figure(structure: &Structure, modes: &Modes) -> Option<Figure> {
    let points = structure.system.points();
    let extent = |axis: usize| {
        let values = || points.iter().map(|point| point[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let axis = (0..3).max_by(|a, b| extent(*a).total_cmp(&extent(*b)))?;
    if extent(axis) <= 0.0 {
        return None;
    }
    let names = ["x", "y", "z"];
    let along: Vec<f64> = points.iter().map(|point| point[axis]).collect();
    let hertz = hertz(modes);
    let panel = |mode: usize| {
        let nodes = scaled(&structure.system, modes, mode);
        let series = |component: usize| {
            let values = nodes.iter().map(|six| six[component]).collect();
            Series::new(format!("along {}", names[component]), along.clone(), values, Style::Points)
        };
        Panel::new(
            format!("{}: {:.2} Hz", mode + 1, hertz[mode]),
            format!("{} (m)", names[axis]),
            "displacement (of the largest)",
            [2, 0, 1].map(series).into(),
        )
    };
    let panels: Vec<Panel> = (0..modes.omega_rad_s.len().min(SHAPES)).map(panel).collect();
    (!panels.is_empty()).then(|| Figure::new(format!("Natural modes of {}", structure.name), panels, 3))
}
