//! VTK unstructured grids (`.vtu`, XML, ASCII) for ParaView, from plain numbers.

use std::fmt::Write as _;

use crate::escape::for_xml;

/// The shape of a cell, with VTK's number for it; nodes in VTK's order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellType {
    /// Two points.
    Line = 3,
    /// Three points.
    Triangle = 5,
    /// Four points around.
    Quadrilateral = 9,
    /// Four points.
    Tetrahedron = 10,
    /// Eight points.
    Hexahedron = 12,
    /// Six points.
    Wedge = 13,
}

/// A named field, as many components a point or cell as its values divide into.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Name with unit.
    pub name: String,
    /// Components of one point or cell.
    pub components: usize,
    /// Values, components of the first point or cell first.
    pub values: Vec<f64>,
}

/// A mesh with fields.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Points, m.
    pub points: Vec<[f64; 3]>,
    /// Cells: shape and positions of its points.
    pub cells: Vec<(CellType, Vec<usize>)>,
    /// Fields on the points.
    pub point_fields: Vec<Field>,
    /// Fields on the cells.
    pub cell_fields: Vec<Field>,
}

/// The file of a mesh without its fields on the points: what several states of one structure share.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Frame {
    before: String,
    after: String,
}

impl Frame {
    /// The file's text with these fields on the points.
    pub fn with(&self, point_fields: &[Field]) -> String {
        let fields: String = point_fields.iter().map(on_points).collect();
        [self.before.as_str(), &fields, &self.after].concat()
    }
}

impl Mesh {
    /// The mesh as a file's text.
    pub fn vtu(&self) -> String {
        self.frame().with(&self.point_fields)
    }

    /// The mesh and its fields on the cells, for files that differ in those on the points.
    pub fn frame(&self) -> Frame {
        let mut points = String::new();
        for [x, y, z] in &self.points {
            let _ = writeln!(points, "{x:.9e} {y:.9e} {z:.9e}");
        }
        let (mut nodes, mut ends, mut types) = (String::new(), String::new(), String::new());
        let mut end = 0;
        for (kind, cell) in &self.cells {
            line(&mut nodes, cell.iter(), |text, node| {
                let _ = write!(text, "{node}");
            });
            end += cell.len();
            let _ = writeln!(ends, "{end}");
            let _ = writeln!(types, "{}", *kind as u8);
        }
        let before = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
            self.points.len(),
            self.cells.len(),
        );
        let after = format!(
            "</PointData>\n<CellData>\n{}</CellData>\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n</Piece>\n\
             </UnstructuredGrid>\n</VTKFile>\n",
            self.cell_fields.iter().map(on_cells).collect::<String>(),
            array("Float64", "points", 3, &points),
            array("Int32", "connectivity", 1, &nodes),
            array("Int32", "offsets", 1, &ends),
            array("UInt8", "types", 1, &types),
        );
        Frame { before, after }
    }
}

/// A field on the points, in single precision as pictures need it.
fn on_points(field: &Field) -> String {
    #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
    data("Float32", field, |digits, value, text| text.push_str(digits.format(value as f32)))
}

/// A field on the cells, exactly: it may hold numbers of elements.
fn on_cells(field: &Field) -> String {
    data("Float64", field, |digits, value, text| text.push_str(digits.format(value)))
}

/// A field with the fewest digits that tell each value from its neighbours.
fn data(kind: &str, field: &Field, write: impl Fn(&mut zmij::Buffer, f64, &mut String)) -> String {
    let mut text = String::with_capacity(12 * field.values.len());
    let mut digits = zmij::Buffer::new();
    for item in field.values.chunks(field.components.max(1)) {
        line(&mut text, item.iter(), |text, value| write(&mut digits, *value, text));
    }
    array(kind, &for_xml(&field.name), field.components, &text)
}

/// Puts a line of items behind a text, with blanks between them.
fn line<T>(text: &mut String, items: impl Iterator<Item = T>, mut write: impl FnMut(&mut String, T)) {
    for (at, item) in items.enumerate() {
        if at > 0 {
            text.push(' ');
        }
        write(text, item);
    }
    text.push('\n');
}

fn array(kind: &str, name: &str, components: usize, text: &str) -> String {
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">\n\
         {text}</DataArray>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_of_all_shapes_are_numbered_as_vtk_does() {
        let field = Field { name: "a < b".into(), components: 3, values: vec![0.0; 24] };
        let cells = vec![
            (CellType::Line, vec![0, 1]),
            (CellType::Quadrilateral, vec![0, 1, 2, 3]),
            (CellType::Hexahedron, (0..8).collect()),
        ];
        let mesh = Mesh { points: vec![[0.0; 3]; 8], cells, point_fields: vec![field], cell_fields: vec![] };
        let text = mesh.vtu();
        assert!(text.contains("NumberOfPoints=\"8\" NumberOfCells=\"3\""));
        assert!(text.contains("\n2\n6\n14\n</DataArray>"), "offsets are ends");
        assert!(text.contains("\n3\n9\n12\n</DataArray>"), "types");
        assert!(text.contains("Name=\"a &lt; b\" NumberOfComponents=\"3\""));
    }

    #[test]
    fn points_have_single_precision_and_cells_their_own_numbers() {
        let field = |name: &str, value: f64| Field { name: name.into(), components: 1, values: vec![value] };
        // the largest number of an element: single precision has 16777216 for both it and its neighbour
        let cell_fields = vec![field("element", 99_999_999.0)];
        let point_fields = vec![field("moved", -1.234_567_890_123e-5)];
        let mesh = Mesh { points: vec![[0.1, 2.0, -3.0]], cells: vec![], point_fields, cell_fields };
        let text = mesh.vtu();
        let document = roxmltree::Document::parse(&text).expect("well-formed XML");
        let value = |name: &str| {
            let array =
                document.descendants().find(|node| node.attribute("Name") == Some(name)).expect("there");
            array.text().expect("numbers").trim().parse::<f64>().expect("a number")
        };
        assert!((value("element") - 99_999_999.0).abs() < 0.5);
        assert!((value("moved") / -1.234_567_890_123e-5 - 1.0).abs() < 1e-7);
        // files of several states differ in their fields on the points alone
        let other = mesh.frame().with(&[field("moved", 2.0)]);
        let after = |text: &str| text.split_once("</PointData>").expect("fields on the points").1.to_owned();
        assert!(after(&other) == after(&text) && other != text);
    }

    #[test]
    fn names_of_fields_survive_an_xml_parser() {
        let name = "lift & moment of \"a\" < b > 'c'";
        let field = |components| Field { name: name.into(), components, values: vec![0.0; components] };
        let mesh = Mesh {
            points: vec![[0.0; 3]],
            cells: vec![(CellType::Line, vec![0, 0])],
            point_fields: vec![field(1)],
            cell_fields: vec![field(3)],
        };
        let text = mesh.vtu();
        let document = roxmltree::Document::parse(&text).expect("well-formed XML");
        let named = document.descendants().filter(|node| node.attribute("Name") == Some(name)).count();
        assert_eq!(named, 2, "{text}");
    }
}
