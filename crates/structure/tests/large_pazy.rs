//! The Pazy wing without its skin under a weight behind the trailing edge of its tip: the equivalent beam of Riso and Cesnik beside
//! their program (UM/NAST, a geometrically exact beam) and beside SOL 400 with shells.

mod large;

use large::{numbers, published};
use nalgebra::{DMatrix, Matrix3, Matrix4, Matrix6, Point3, SMatrix, Vector3};
use nastran::Span;
use std::sync::Arc;
use structure::nonlinear::{LargeDeflection, Loads, NodeLoad, State};
use structure::{Clamp, Element, MassForm, MatrixElement, Model, Node, PointMass};

const SEMISPAN_M: f64 = 0.55;
const CHORD_M: f64 = 0.1;
/// Of the reference axis behind the leading edge.
const AXIS_M: f64 = 0.0441;
const G_M_S2: f64 = 9.81;

fn table() -> Vec<Vec<f64>> {
    let path = format!("{}/../../data/pazy/beam_without_skin.csv", env!("CARGO_MANIFEST_DIR"));
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

/// The beam; its last node is on a rigid arm at the weight's place behind the trailing edge.
fn wing(arm_aft_of_edge_m: f64) -> LargeDeflection {
    let rows = table();
    // Rows of the local axes: along the span, to the leading edge, up.
    let axes = Matrix3::new(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let turn = DMatrix::from_fn(12, 12, |i, j| if i / 3 == j / 3 { axes[(i % 3, j % 3)] } else { 0.0 });
    let mut points: Vec<Point3<f64>> = rows.iter().map(|row| Point3::new(AXIS_M, row[0], 0.0)).collect();
    points.push(Point3::new(CHORD_M + arm_aft_of_edge_m, points[15].y, 0.0));
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
        let arm = Vector3::new(row[12], row[13], row[14]);
        elements.push(Arc::new(PointMass::new(id, at, row[11], &arm, &Matrix3::zeros())));
    }
    // The rod of the weight, stiff beyond all else.
    let rod = Matrix4::from_diagonal(&nalgebra::Vector4::new(1e8, 1e4, 1e4, 1e4));
    let along = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    let turn = DMatrix::from_fn(12, 12, |i, j| if i / 3 == j / 3 { along[(i % 3, j % 3)] } else { 0.0 });
    let local = stiffness(&rod, points[16].x - points[15].x);
    let dofs: Vec<usize> = (90..102).collect();
    elements.push(Arc::new(MatrixElement::spring(id + 1, &dofs, &(turn.transpose() * local * &turn))));
    let node = |(at, point): (usize, &Point3<f64>)| Node {
        id: u32::try_from(at + 1).expect("a small number"),
        point: *point,
        axes: Matrix3::identity(),
        is_scalar: false,
    };
    let span = Span::new(&Arc::new("beam".into()), 1, 1, 1);
    let model = Model {
        nodes: points.iter().enumerate().map(node).collect(),
        elements,
        dependents: Vec::new(),
        ties: Vec::new(),
        clamps: vec![Clamp { node: 0, components: vec![1, 2, 3, 4, 5, 6], span }],
        mass_factor: 1.0,
        mass_form: MassForm::Consistent,
        holds_loose: false,
    };
    LargeDeflection::new(&model).expect("a beam")
}

/// Place of a point of the tip's chord, from the leading edge, m.
fn tip(state: &State, chord: f64) -> Vector3<f64> {
    state.places[15] + state.rotations[15] * Vector3::new(chord - AXIS_M, 0.0, 0.0)
}

#[test]
fn the_wing_without_skin_bends_and_twists_under_a_weight_behind_its_tip() {
    let case = published("nl_pazy__static_torsion_skin0");
    let wing = wing(0.04);
    let weight = Loads { gravity_m_s2: Vector3::new(0.0, 0.0, -G_M_S2), ..Loads::default() };
    let sag = wing.under(&weight).expect("its own weight").end().state.clone();
    let rows = |name: &str| -> Vec<Vec<f64>> {
        case["expected"][name].as_array().expect("rows").iter().map(numbers).collect()
    };
    let twist = |state: &State| {
        let chord = tip(state, 0.0) - tip(state, CHORD_M);
        (chord.z / chord.norm()).asin().to_degrees()
    };
    let (mut worst_z, mut worst_twist): (f64, f64) = (0.0, 0.0);
    for (place, turned) in
        rows("UMNAST_z_y_x").iter().zip(rows("UMNAST_twist_deg")).filter(|(p, _)| p[0] > 0.0)
    {
        let force = Vector3::new(0.0, 0.0, -place[0] * G_M_S2);
        let load = NodeLoad { node: 16, force, moment: Vector3::zeros() };
        let loads = Loads { dead: vec![load], ..weight.clone() };
        let end = wing.under(&loads).expect("the weight is carried").end().state.clone();
        let moved = (tip(&end, 0.5 * CHORD_M) - tip(&sag, 0.5 * CHORD_M)) * (100.0 / SEMISPAN_M);
        let axis = (end.places[15] - sag.places[15]) * (100.0 / SEMISPAN_M);
        let angle = twist(&end) - twist(&sag);
        println!(
            "{:.2} kg: z {:.3} (axis {:.3}) for {:.3}, y {:.3} ({:.3}) for {:.3}, x {:.3} ({:.3}) for {:.3}; twist {angle:.3} for {:.3}",
            place[0],
            moved.z,
            axis.z,
            place[1],
            moved.y,
            axis.y,
            place[2],
            moved.x,
            axis.x,
            place[3],
            turned[1]
        );
        worst_z = worst_z.max((moved.z / place[1] - 1.0).abs());
        worst_twist = worst_twist.max((angle / turned[1] - 1.0).abs());
    }
    println!("largest differences from UM/NAST: z {worst_z:.4}, twist {worst_twist:.4}");
    assert!(worst_z < 0.005 && worst_twist < 0.02, "z {worst_z}, twist {worst_twist}");
}
