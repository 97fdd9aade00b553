//! Natural modes as shapes in space: the structure's surface and beams, undeformed and bent by each of the first modes.

use std::collections::BTreeMap;

use report::coarse::coarse;
use report::deformed::{Quad, View};
use structure::{CellShape, MeshCell, Modes, System};

use super::modes_pictures::{hertz, scaled};
use crate::failure::Failure;
use crate::output::ResultFolder;

/// Modes shown.
const SHAPES: usize = 5;
/// The largest displacement, in parts of the structure's longest extent.
const REACH: f64 = 0.1;

/// Faces of the solids, positions in their nodes; a triangle repeats its last.
const TETRAHEDRON: [[usize; 4]; 4] = [[0, 1, 2, 2], [0, 1, 3, 3], [1, 2, 3, 3], [0, 2, 3, 3]];
const WEDGE: [[usize; 4]; 5] = [[0, 1, 2, 2], [3, 4, 5, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
const HEXAHEDRON: [[usize; 4]; 6] =
    [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// What is said below them.
const CAPTION: &str = "The largest displacement is drawn as a tenth of the structure. Drag to turn, scroll to come nearer; a click \
                       on a name shows or hides a mode.";

/// Writes the shapes; nothing for a structure without an extent.
pub(super) fn write(
    folder: &ResultFolder,
    name: &str,
    system: &System,
    cells: &[MeshCell],
    modes: &Modes,
    files: &[String],
) -> Result<(), Failure> {
    let (views, drawn) = views(system, cells, modes);
    if views.is_empty() {
        return Ok(());
    }
    let files = &files[..files.len().min(views.len() - 1)];
    folder.write_shapes(
        "shapes_in_space",
        &format!("Shapes of {name}"),
        &format!("{CAPTION}{drawn}"),
        views,
        files,
    )
}

/// The structure undeformed and in its first modes, these to be asked for one by one but the first; none for a structure
/// without an extent. With them what the caption says of the faces drawn.
fn views(system: &System, cells: &[MeshCell], modes: &Modes) -> (Vec<View>, String) {
    let points = system.points();
    let extent = |axis: usize| {
        let values = || points.iter().map(|point| point[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let reach = REACH * (0..3).map(extent).fold(0.0, f64::max);
    let mut states = vec![(String::from("undeformed"), vec![0.0; 6 * points.len()])];
    for (mode, hertz) in hertz(modes).iter().enumerate().take(SHAPES) {
        let moved = scaled(system, modes, mode).iter().flatten().map(|value| reach * value).collect();
        states.push((format!("mode {}: {hertz:.2} Hz", mode + 1), moved));
    }
    if reach > 0.0 { in_space(system, cells, &states, 1) } else { Default::default() }
}

/// Views of states of a structure (name, displacements six a node), those after the first but number `shown` to be asked
/// for; none for a structure without an extent. With them what the caption says of the faces drawn.
fn in_space(
    system: &System,
    cells: &[MeshCell],
    states: &[(String, Vec<f64>)],
    shown: usize,
) -> (Vec<View>, String) {
    let (all, lines) = (surface(cells), lines(cells));
    let count = all.len();
    let faces = coarse(system.points(), all);
    if faces.is_empty() && lines.is_empty() {
        return Default::default();
    }
    let drawn = if faces.len() < count {
        format!(" Of the mesh's {count} faces neighbours are drawn together, to {}.", faces.len())
    } else {
        String::new()
    };
    let view = |(number, (title, displacements)): (usize, &(String, Vec<f64>))| {
        let mut at = system.points().to_vec();
        for (point, six) in at.iter_mut().zip(displacements.chunks_exact(6)) {
            (0..3).for_each(|axis| point[axis] += six[axis]);
        }
        View {
            title: title.clone(),
            groups: vec!["structure".into()],
            quads: faces.iter().map(|face| Quad { corners: face.map(|node| at[node]), group: 0 }).collect(),
            lines: lines.iter().map(|ends| ends.map(|node| at[node])).collect(),
            waits: number != 0 && number != shown,
        }
    };
    (states.iter().enumerate().map(view).collect(), drawn)
}

/// Writes states of a structure to scale, the last one shown; nothing for a structure without an extent.
pub(super) fn write_states(
    folder: &ResultFolder,
    name: &str,
    caption: &str,
    system: &System,
    cells: &[MeshCell],
    states: &[(String, Vec<f64>)],
    files: &[String],
) -> Result<(), Failure> {
    let (views, drawn) = in_space(system, cells, states, states.len() - 1);
    if views.is_empty() {
        return Ok(());
    }
    folder.write_shapes(
        "shapes_in_space",
        &format!("Shapes of {name}"),
        &format!("{caption}{drawn}"),
        views,
        files,
    )
}

/// Beams, rods, bushes and springs; arms of rigid elements are no structure to look at.
fn lines(cells: &[MeshCell]) -> Vec<[usize; 2]> {
    let of = |cell: &MeshCell| match cell.nodes[..] {
        [from, to] if !cell.is_rigid => Some([from, to]),
        _ => None,
    };
    cells.iter().filter_map(of).collect()
}

/// Shells, and the faces of solids that no second solid or shell shares.
fn surface(cells: &[MeshCell]) -> Vec<[usize; 4]> {
    let mut faces: BTreeMap<Vec<usize>, ([usize; 4], usize)> = BTreeMap::new();
    let mut shells = Vec::new();
    for cell in cells {
        let picks: &[[usize; 4]] = match cell.shape {
            CellShape::Line => continue,
            CellShape::Triangle => &[[0, 1, 2, 2]],
            CellShape::Quadrilateral => &[[0, 1, 2, 3]],
            CellShape::Tetrahedron => &TETRAHEDRON,
            CellShape::Wedge => &WEDGE,
            CellShape::Hexahedron => &HEXAHEDRON,
        };
        for face in picks.iter().map(|pick| pick.map(|at| cell.nodes[at])) {
            let mut key = face.to_vec();
            key.sort_unstable();
            if picks.len() == 1 {
                shells.push((key, face));
            } else {
                faces.entry(key).or_insert((face, 0)).1 += 1;
            }
        }
    }
    for (key, _) in &shells {
        faces.remove(key);
    }
    let skin = faces.into_values().filter(|(_, count)| *count == 1).map(|(face, _)| face);
    shells.into_iter().map(|(_, face)| face).chain(skin).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_outside_of_a_stack_of_solids_is_drawn_and_shells_on_it_once() {
        let solid = |from: usize| MeshCell {
            id: 1,
            shape: CellShape::Hexahedron,
            nodes: (from..from + 8).collect(),
            is_rigid: false,
        };
        // nodes 4 to 7 are the face between
        let stack = [solid(0), solid(4)];
        assert_eq!(surface(&stack).len(), 10);
        let shell =
            MeshCell { id: 9, shape: CellShape::Quadrilateral, nodes: vec![0, 1, 2, 3], is_rigid: false };
        let [first, second] = stack;
        assert_eq!(surface(&[first, second, shell]).len(), 10);
        let arm = MeshCell { id: 3, shape: CellShape::Line, nodes: vec![0, 1], is_rigid: true };
        let beam = MeshCell { is_rigid: false, ..arm.clone() };
        assert_eq!(lines(&[arm, beam]), [[0, 1]]);
    }
}
