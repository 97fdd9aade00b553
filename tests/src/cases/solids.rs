//! Solid elements beside published and exact results (data/published/fem*.json): MacNeal and Harder's standard set
//! (*A proposed standard set of problems to test finite element accuracy*, FE Anal. Design 1 (1985) 3-20), Lame's
//! thick cylinder.
//!
//! Straight and curved beams and plates are cases of shells as well: `shells.rs` and `plates.rs` add the rows made here.

use crate::fem::solid_mesh::{HEXA, SolidMesh, node, nodes};
use crate::registry::Case;
use crate::row::{Row, worst};
use crate::{list, number, numbers};
use nalgebra::{Point3, Vector3};
use nastran::{Expansion, Mat1, Span};
use serde_json::Value;
use std::sync::Arc;
use structure::SolidMaterial;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "fem__patch_solid", run: patch },
    Case { file: "fem__thick_cylinder", run: thick_cylinder },
];

fn isotropic(e: f64, nu: f64) -> Arc<SolidMaterial> {
    let card = Mat1 {
        id: 1,
        e,
        g: 0.0,
        nu,
        rho: 0.0,
        expansion: Expansion::default(),
        span: Span::generated("published case"),
    };
    Arc::new(SolidMaterial::from_mat1(&card).expect("a sound material"))
}

fn material_of(case: &Value) -> Arc<SolidMaterial> {
    isotropic(number(&case["inputs"]["E"]), number(&case["inputs"]["nu"]))
}

/// Seven hexahedra: an irregular one in the middle of a cube, one between each of its faces and the cube's.
fn patch(case: &Value) -> Vec<Row> {
    let outer = HEXA.map(|corner| Point3::from(corner.map(|at| at as f64)));
    let inner = list(&case["inputs"]["inner"]).iter().map(|p| Point3::from_slice(&numbers(p)));
    let points: Vec<_> = outer.into_iter().chain(inner).collect();
    let material = material_of(case);
    let mut elements = vec![((8..16).collect(), Arc::clone(&material))];
    for face in [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]] {
        let both = face.iter().copied().chain(face.iter().map(|corner| corner + 8));
        elements.push((both.collect(), Arc::clone(&material)));
    }
    let mesh = SolidMesh::new(points, &elements);
    let field = |p: &Point3<f64>| (p.coords + Vector3::repeat(p.coords.sum())) * 0.5e-3;
    let held: Vec<_> = (0..24).map(|dof| (dof, field(&mesh.points[dof / 3])[dof % 3])).collect();
    let u = mesh.solve(&held, &[]);
    let rel = number(&case["tolerance"]["rel"]);
    let mut rows = Vec::new();
    for (dof, got) in u.iter().enumerate().skip(24) {
        let what = format!("displacement {} of inner node {}", dof % 3 + 1, dof / 3 - 7);
        rows.push(Row::relative(what, *got, field(&mesh.points[dof / 3])[dof % 3], rel));
    }
    let [normal, shear] = ["sigma_normal", "tau"].map(|name| number(&case["expected"][name]));
    for element in 0..7 {
        for at in [[0.0; 3], [-0.9, 0.5, 0.3], [1.0, 1.0, -1.0]] {
            let stress = mesh.stress(element, &u, at);
            for (got, want) in stress.iter().zip([normal, normal, normal, shear, shear, shear]) {
                rows.push(Row::relative("stress", *got, want, rel));
            }
        }
    }
    let stresses = rows.split_off(24);
    rows.push(worst("stresses of seven elements at three points, the one furthest off", stresses));
    rows
}

/// The radii of MacNeal and Harder's mesh, ten degrees an element around, a quarter of the ring in plane strain.
/// The case gives a tolerance for nu = 0.49 and asks for a record of the locking at 0.4999.
fn thick_cylinder(case: &Value) -> Vec<Row> {
    let mut rows = Vec::new();
    let radii = [3.0, 3.5, 4.2, 5.2, 6.75, 9.0];
    let cells = [5, 9, 1];
    for (name, want) in case["expected"]["u_r_at_a"].as_object().into_iter().flatten() {
        let material = isotropic(number(&case["inputs"]["E"]), name.parse().expect("Poisson's ratio"));
        let place = |[i, j, k]: [usize; 3]| {
            let (sin, cos) = (j as f64 * 10.0).to_radians().sin_cos();
            Point3::new(radii[i] * cos, radii[i] * sin, k as f64)
        };
        let mesh = SolidMesh::block(cells, place, |_| Arc::clone(&material));
        let mut held: Vec<_> = nodes(cells, |_| true).iter().map(|at| (3 * at + 2, 0.0)).collect();
        held.extend(nodes(cells, |[_, j, _]| j == 0).iter().map(|at| (3 * at + 1, 0.0)));
        held.extend(nodes(cells, |[_, j, _]| j == 9).iter().map(|at| (3 * at, 0.0)));
        let pressure = number(&case["inputs"]["p"]);
        let mut loads = Vec::new();
        for j in 0..9 {
            let face = [[0, j, 0], [0, j + 1, 0], [0, j + 1, 1], [0, j, 1]].map(|at| node(cells, at));
            // Its normal points outwards, as the pressure does.
            loads.extend(mesh.face_loads(face, |_, normal| normal * pressure));
        }
        let u = mesh.solve(&held, &loads);
        let got = u[3 * node(cells, [0, 0, 0])];
        rows.push(Row::relative(
            format!("radial displacement at a, nu = {name}, 5 x 9"),
            got,
            number(want),
            0.02,
        ));
    }
    rows
}

/// How far the line of a number leans.
type Leaning = fn(usize) -> f64;

/// The three meshes of the straight beam: how far the lines between elements lean, by their number.
const LEANING: [(&str, Leaning); 3] = [
    ("rectangular", |_| 0.0),
    ("trapezoidal", |line| if line % 2 == 1 { 1.0 } else { -1.0 }),
    ("parallelogram", |_| 1.0),
];

/// The straight beam along x, `depth` along y, `thickness` along z, clamped at x = 0.
fn straight_beam(case: &Value, cells: [usize; 3], leaning: Leaning) -> SolidMesh {
    let [length, depth, thickness] = ["L", "h", "t"].map(|name| number(&case["inputs"][name]));
    let material = material_of(case);
    let place = |[i, j, k]: [usize; 3]| {
        let [x, y, z] = [(i, 0), (j, 1), (k, 2)].map(|(at, axis)| at as f64 / cells[axis] as f64);
        let lean = if i == 0 || i == cells[0] { 0.0 } else { leaning(i) * 6.0 / cells[0] as f64 };
        let y = depth * (y - 0.5);
        Point3::new(length * x + lean * y, y, thickness * (z - 0.5))
    };
    SolidMesh::block(cells, place, |_| Arc::clone(&material))
}

/// All three displacements of nodes, held.
fn all_held(of: &[usize]) -> Vec<(usize, f64)> {
    of.iter().flat_map(|at| (0..3).map(move |axis| (3 * at + axis, 0.0))).collect()
}

/// The motion that belongs to a unit load given as tractions on the end face i = last: the load's work.
fn unit_load_motion(
    mesh: &SolidMesh,
    cells: [usize; 3],
    held: &[(usize, f64)],
    traction: impl Fn(&Point3<f64>) -> Vector3<f64>,
) -> f64 {
    let mut loads = Vec::new();
    for j in 0..cells[1] {
        for k in 0..cells[2] {
            let face = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| node(cells, [cells[0], j + a, k + b]));
            loads.extend(mesh.face_loads(face, |p, _| traction(p)));
        }
    }
    let u = mesh.solve(held, &loads);
    loads.iter().map(|(dof, force)| u[*dof] * force).sum()
}

/// Motions of the tip along unit loads: extension, in plane, out of plane, twist by a couple.
fn tip_motions(case: &Value, mesh: &SolidMesh, cells: [usize; 3]) -> [f64; 4] {
    let [depth, thickness] = ["h", "t"].map(|name| number(&case["inputs"][name]));
    let held = all_held(&nodes(cells, |[i, _, _]| i == 0));
    let of = |traction: &dyn Fn(&Point3<f64>) -> Vector3<f64>| unit_load_motion(mesh, cells, &held, traction);
    let area = depth * thickness;
    // A couple about x: tractions (0, -z, y) per polar moment of area.
    let polar = area * (depth * depth + thickness * thickness) / 12.0;
    [
        of(&|_| Vector3::x() / area),
        of(&|_| Vector3::y() / area),
        of(&|_| Vector3::z() / area),
        of(&|p| Vector3::new(0.0, -p.z, p.y) / polar),
    ]
}

const LOADS: [&str; 4] =
    ["extension", "in_plane_shear", "out_of_plane_shear", "twist_saint_venant_recomputed"];

/// At the case's 6 x 1 x 1 its 2 % are reached by the three loads that beams know; one element across the section gives
/// the warping of torsion a single bilinear term, so twist is compared on a finer section, at the 3 % of the case's
/// note. The case asks for a record of the distorted meshes; such elements lock in every formulation that passes
/// the patch test.
pub(super) fn straight_beam_rows(case: &Value) -> Vec<Row> {
    let mut rows = Vec::new();
    for (mesh, cells) in [(0, [6, 1, 1]), (0, [24, 8, 4]), (1, [6, 1, 1]), (2, [6, 1, 1])] {
        let (name, leaning) = LEANING[mesh];
        let got = tip_motions(case, &straight_beam(case, cells, leaning), cells);
        for (load, got) in LOADS.iter().zip(got) {
            let what = format!("{load}, {} x {} x {} {name} solids", cells[0], cells[1], cells[2]);
            let want = number(&case["expected"][*load]);
            let is_twist = load.starts_with("twist");
            rows.push(if (mesh > 0 && *load != "extension") || (is_twist && cells[1] == 1) {
                Row::record(what, got, want)
            } else {
                Row::relative(what, got, want, if is_twist { 0.03 } else { 0.02 })
            });
        }
    }
    rows
}

/// Tip deflections of the curved beam, in and out of its plane.
fn curved_beam(case: &Value, cells: [usize; 3]) -> [f64; 2] {
    let [inner, outer, thickness] = ["Ri", "Ro", "t"].map(|name| number(&case["inputs"][name]));
    let material = material_of(case);
    let arc = number(&case["inputs"]["arc_deg"]).to_radians();
    let place = |[i, j, k]: [usize; 3]| {
        let [along, across, up] = [(i, 0), (j, 1), (k, 2)].map(|(at, axis)| at as f64 / cells[axis] as f64);
        let (sin, cos) = (along * arc).sin_cos();
        let radius = outer - across * (outer - inner);
        Point3::new(radius * sin, radius * cos, up * thickness)
    };
    let mesh = SolidMesh::block(cells, place, |_| Arc::clone(&material));
    let held = all_held(&nodes(cells, |[i, _, _]| i == 0));
    // The tip's section is the plane y = 0, the load in plane is along x, the radius there.
    [0, 2].map(|axis| {
        let per_area = Vector3::ith(axis, 1.0 / ((outer - inner) * thickness));
        unit_load_motion(&mesh, cells, &held, |_| per_area)
    })
}

/// One element across the section is recorded: it bends without locking along the arc's six chords, but
/// twists too little, and out-of-plane bending is half torsion. The case's 2 % are met by a finer mesh.
pub(super) fn curved_beam_rows(case: &Value) -> Vec<Row> {
    let rel = number(&case["tolerance"]["rel"]);
    let (coarse, fine) = (curved_beam(case, [6, 1, 1]), curved_beam(case, [32, 8, 4]));
    let mut rows = Vec::new();
    for (at, name) in ["in_plane", "out_of_plane"].iter().enumerate() {
        let want = number(&case["expected"][*name]);
        rows.push(Row::record(format!("{name}, 6 x 1 x 1 solids"), coarse[at], want));
        rows.push(Row::relative(format!("{name}, 32 x 8 x 4 solids"), fine[at], want, rel));
    }
    rows
}

/// Thickness of the plate for solids, as the case's note says; deflections are then times 1e-6.
const PLATE_THICKNESS: f64 = 0.01;

/// Held motions of a quarter plate, (0, 0) its middle, the far sides its edges: simply supported, clamped.
fn plate_supports(cells: [usize; 3]) -> [Vec<(usize, f64)>; 2] {
    let n = cells[0];
    let held = |axis: usize, keep: &dyn Fn([usize; 3]) -> bool| -> Vec<(usize, f64)> {
        nodes(cells, keep).iter().map(|at| (3 * at + axis, 0.0)).collect()
    };
    let symmetry = [held(0, &|at| at[0] == 0), held(1, &|at| at[1] == 0)].concat();
    let is_edge = |at: [usize; 3]| at[0] == n || at[1] == n;
    let along_edges = [held(1, &|at| at[0] == n), held(0, &|at| at[1] == n)].concat();
    let supported = [symmetry.clone(), held(2, &is_edge), along_edges].concat();
    [supported, [symmetry, all_held(&nodes(cells, is_edge))].concat()]
}

/// One solid through the thickness.
pub(super) fn square_plate_rows(case: &Value) -> Vec<Row> {
    let mut rows = Vec::new();
    let [side, q, force] = ["a", "q", "P"].map(|name| number(&case["inputs"][name]));
    let material = material_of(case);
    for n in [8, 16] {
        let cells = [n, n, 1];
        let place = |[i, j, k]: [usize; 3]| {
            let [x, y] = [i, j].map(|at| 0.5 * side * at as f64 / n as f64);
            Point3::new(x, y, PLATE_THICKNESS * (k as f64 - 0.5))
        };
        let mesh = SolidMesh::block(cells, place, |_| Arc::clone(&material));
        let centre = [0, 1].map(|k| 3 * node(cells, [0, 0, k]) + 2);
        // A quarter of the force, half of it at the bottom, half at the top.
        let point = centre.map(|dof| (dof, force / 8.0)).to_vec();
        let mut uniform = Vec::new();
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let face = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| node(cells, [i + a, j + b, 1]));
            uniform.extend(mesh.face_loads(face, |_, normal| normal * q));
        }
        for (edge, held) in ["ss", "cl"].iter().zip(plate_supports(cells)) {
            for (kind, loads) in [("udl", &uniform), ("point", &point)] {
                let u = mesh.solve(&held, loads);
                let got = 0.5e6 * (u[centre[0]] + u[centre[1]]);
                let name = format!("{edge}_{kind}");
                let want = number(&case["expected"][&name]);
                let what = format!("{name}, {n} x {n} x 1 solids a quarter");
                rows.push(Row::relative(what, got, want, number(&case["tolerance"]["rel"])));
            }
        }
    }
    rows
}
