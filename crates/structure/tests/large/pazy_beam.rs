//! The Pazy wing with and without its skin as the equivalent beam of Riso and Cesnik (data/pazy/README.md), node 16 at the tip.

#![expect(clippy::expect_used, unreachable_pub, reason = "helpers of the tests in this folder")]
#![allow(dead_code, reason = "not every test file uses every helper")]

use nalgebra::{DMatrix, Matrix3, Matrix4, Matrix6, Point3, SMatrix, Vector3};
use nastran::Span;
use std::sync::Arc;
use structure::{Clamp, Element, MassForm, MatrixElement, Model, Node, PointMass};

/// Chord, m.
pub const CHORD_M: f64 = 0.1;
/// Of the reference axis behind the leading edge.
pub const AXIS_M: f64 = 0.0441;

/// A row a station as in the tables of data/pazy: place along the axis, stiffness to the next station, mass, centre, inertia.
pub type Station = Vec<f64>;

/// The wing's stations.
pub fn stations(with_skin: bool) -> Vec<Station> {
    let name = if with_skin { "beam_with_skin" } else { "beam_without_skin" };
    let path = format!("{}/../../data/pazy/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the table");
    let rows = text.lines().filter(|line| !line.starts_with(['#', 'y']));
    rows.map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect()
}

/// Stiffness of a beam of one section over both ends' motions in local axes, from the flexibility of end B with end A held (no shear
/// flexibility).
fn stiffness(section: &Matrix4<f64>, length: f64) -> DMatrix<f64> {
    let inverse = section.try_inverse().expect("a section's stiffness");
    let mut flexibility = Matrix6::zeros();
    // Gauss, two places: exact for moments linear in the place.
    for x in [0.5 - 0.5 / 3.0_f64.sqrt(), 0.5 + 0.5 / 3.0_f64.sqrt()] {
        let arm = (1.0 - x) * length;
        // Axial force and moments about 1, 2, 3 by the loads at end B.
        let mut forces = SMatrix::<f64, 4, 6>::zeros();
        (forces[(0, 0)], forces[(1, 3)], forces[(2, 4)], forces[(3, 5)]) = (1.0, 1.0, 1.0, 1.0);
        (forces[(2, 2)], forces[(3, 1)]) = (-arm, arm);
        flexibility += forces.transpose() * inverse * forces * (0.5 * length);
    }
    let end = flexibility.try_inverse().expect("a beam's flexibility");
    let mut relative = SMatrix::<f64, 6, 12>::zeros();
    for i in 0..6 {
        (relative[(i, i)], relative[(i, 6 + i)]) = (-1.0, 1.0);
    }
    (relative[(1, 5)], relative[(2, 4)]) = (-length, length);
    let k = relative.transpose() * end * relative;
    DMatrix::from_fn(12, 12, |i, j| 0.5 * (k[(i, j)] + k[(j, i)]))
}

/// The wing with or without skin, clamped at the wall; with a place for a weight behind the trailing edge of the tip, node 17 is there on a
/// stiff rod.
pub fn beam(with_skin: bool, weight_aft_of_edge_m: Option<f64>) -> Model {
    let rows = stations(with_skin);
    let mut model = swept(&rows, AXIS_M, 0.0);
    if let Some(arm) = weight_aft_of_edge_m {
        let point = Point3::new(CHORD_M + arm, rows[15][0], 0.0);
        model.nodes.push(node(16, &point));
        model.elements.push(rod(1000, point.x - AXIS_M));
    }
    model
}

/// A beam of stations, its axis from x = `root_x_m` at the wall, turned aft in its plane.
pub fn swept(rows: &[Station], root_x_m: f64, sweep_rad: f64) -> Model {
    let (sin, cos) = sweep_rad.sin_cos();
    // Rows of the local axes: along the axis, to the leading edge, up.
    let axes = Matrix3::new(sin, cos, 0.0, -cos, sin, 0.0, 0.0, 0.0, 1.0);
    let turn = DMatrix::from_fn(12, 12, |i, j| if i / 3 == j / 3 { axes[(i % 3, j % 3)] } else { 0.0 });
    // Masses have x aft, y along the axis, z up.
    let masses = Matrix3::new(cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0);
    let place = |row: &Station| Point3::new(root_x_m + sin * row[0], cos * row[0], 0.0);
    let mut elements: Vec<Arc<dyn Element>> = Vec::new();
    let mut id = 0;
    for (at, pair) in rows.windows(2).enumerate() {
        let k = &pair[0][1..11];
        let section = Matrix4::new(
            k[0], k[4], k[5], k[6], k[4], k[1], k[7], k[8], k[5], k[7], k[2], k[9], k[6], k[8], k[9], k[3],
        );
        let local = stiffness(&section, pair[1][0] - pair[0][0]);
        let dofs: Vec<usize> = (6 * at..6 * at + 12).collect();
        id += 1;
        elements.push(Arc::new(MatrixElement::spring(id, &dofs, &(turn.transpose() * local * &turn))));
    }
    for (at, row) in rows.iter().enumerate() {
        id += 1;
        let arm = masses * Vector3::new(row[12], row[13], row[14]);
        let inertia = Matrix3::from_diagonal(&Vector3::new(row[15], row[16], row[17]));
        elements.push(Arc::new(PointMass::new(
            id,
            at,
            row[11],
            &arm,
            &(masses * inertia * masses.transpose()),
        )));
    }
    let span = Span::new(&Arc::new("beam".into()), 1, 1, 1);
    Model {
        nodes: rows.iter().enumerate().map(|(at, row)| node(at, &place(row))).collect(),
        elements,
        dependents: Vec::new(),
        ties: Vec::new(),
        clamps: vec![Clamp { node: 0, components: vec![1, 2, 3, 4, 5, 6], span }],
        mass_factor: 1.0,
        mass_form: MassForm::Consistent,
        holds_loose: false,
    }
}

fn node(at: usize, point: &Point3<f64>) -> Node {
    let id = u32::try_from(at + 1).expect("a small number");
    Node { id, point: *point, axes: Matrix3::identity(), is_scalar: false }
}

/// Stiff beyond all else, along x from the tip.
fn rod(id: u32, length: f64) -> Arc<dyn Element> {
    let section = Matrix4::from_diagonal(&nalgebra::Vector4::new(1e8, 1e4, 1e4, 1e4));
    let dofs: Vec<usize> = (90..102).collect();
    Arc::new(MatrixElement::spring(id, &dofs, &stiffness(&section, length)))
}
