//! Shell elements beside patch tests, plates and a membrane of the literature (data/published, `fem__*`).

use super::solids::square_plate_rows;
use crate::fem::{Isotropic, Mesh, Solved, solve_enforced, span};
use crate::registry::Case;
use crate::row::Row;
use crate::{list, number, numbers};
use serde_json::Value;
use structure::{PlacedPly, PlaneMaterial, ShearModel, ShellSection};

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "fem__patch_membrane", run: patch_membrane },
    Case { file: "fem__patch_bending", run: patch_bending },
    Case { file: "fem__mh_rect_plate_1", run: rectangular_plate },
    Case { file: "fem__iso_plate_ss_udl", run: thin_plate },
    Case { file: "fem__razzaque_skew", run: razzaque },
    Case { file: "fem__nafems_le1", run: elliptic_membrane },
];

/// Material and thickness as a case gives them.
pub(super) fn plate(inputs: &Value) -> Isotropic {
    let rho = inputs.get("rho").map_or(0.0, number);
    Isotropic { e: number(&inputs["E"]), nu: number(&inputs["nu"]), rho, t: number(&inputs["t"]) }
}

pub(super) fn section(plate: Isotropic) -> ShellSection {
    let Isotropic { e, nu, rho, t } = plate;
    let card = nastran::Mat1 {
        id: 1,
        e,
        g: e / (2.0 * (1.0 + nu)),
        nu,
        rho,
        expansion: nastran::Expansion::default(),
        span: span(),
    };
    let material = PlaneMaterial::isotropic(&card).expect("a sound material");
    let ply = PlacedPly { material, angle_rad: 0.0, z_low_m: -0.5 * t, z_high_m: 0.5 * t };
    ShellSection::laminate(&[ply], 0.0, ShearModel::Equilibrium)
}

/// The five quadrilaterals of MacNeal and Harder.
fn patch(inputs: &Value, membrane: &Value) -> Mesh {
    let mut mesh = Mesh::mapped(0, 0, |_, _| [0.0; 3]).of(plate(inputs));
    mesh.bulk.grids.clear();
    let points = list(&membrane["outer"]).iter().chain(list(&membrane["inner"]));
    for (id, point) in (1..).zip(points) {
        let xy = numbers(point);
        mesh.add_grid(id, [xy[0], xy[1], 0.0]);
    }
    for (id, grids) in (1..).zip([[1, 2, 6, 5], [2, 3, 7, 6], [3, 4, 8, 7], [4, 1, 5, 8], [5, 6, 7, 8]]) {
        mesh.add_shell(id, grids.to_vec());
    }
    mesh
}

/// Largest and smallest of each stress resultant over the elements' Gauss points, in basic axes.
fn resultants(mesh: &Mesh, solved: &Solved, plate: Isotropic, of_bending: bool) -> Vec<[f64; 3]> {
    let section = section(plate);
    let g = 1.0 / 3.0_f64.sqrt();
    let mut all = Vec::new();
    for element in mesh.bulk.shells.keys() {
        for at in [[-g, -g], [g, -g], [g, g], [-g, g]] {
            let (strains, shell) = solved.strains(mesh, *element, &section, at);
            let (matrix, strain) = if of_bending {
                (section.bending, strains.curvature)
            } else {
                (section.membrane, strains.membrane)
            };
            let own = matrix * nalgebra::Vector3::from(strain);
            // From the element's axes to the basic ones.
            let axes = shell.axes().fixed_view::<2, 2>(0, 0).into_owned();
            let tensor = nalgebra::Matrix2::new(own[0], own[2], own[2], own[1]);
            let basic = axes.transpose() * tensor * axes;
            all.push([basic[(0, 0)], basic[(1, 1)], basic[(0, 1)]]);
        }
    }
    all
}

fn worst(values: &[[f64; 3]], at: usize, expected: f64) -> f64 {
    let far = |value: &f64| (value - expected).abs();
    values.iter().map(|v| v[at]).max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(f64::NAN)
}

fn patch_membrane(case: &Value) -> Vec<Row> {
    let (inputs, expected) = (&case["inputs"], &case["expected"]);
    let mut mesh = patch(inputs, inputs);
    mesh.nx = 0;
    mesh.ny = 7;
    let mesh = mesh.clamped(&[1, 2], |_, j| j < 4).clamped(&[3, 4, 5], |_, _| true);
    let motions: Vec<(u32, usize, f64)> = (1..=4)
        .flat_map(|grid| {
            let [x, y, _]: [f64; 3] = mesh.bulk.grids[&grid].xyz.into();
            [(grid, 1, 1e-3 * (x + 0.5 * y)), (grid, 2, 1e-3 * (y + 0.5 * x))]
        })
        .collect();
    let plate = plate(inputs);
    let solved = solve_enforced(mesh.system(), &motions);
    let forces = resultants(&mesh, &solved, plate, false);
    let rel = number(&case["tolerance"]["rel"]);
    [("sigma_x", 0), ("sigma_y", 1), ("tau_xy", 2)]
        .map(|(name, at)| {
            // Printed with ten digits.
            let wanted = number(&expected[name]);
            let got = worst(&forces, at, wanted * plate.t) / plate.t;
            Row::within(format!("{name}, the point furthest off"), got, wanted, rel, 5e-7)
        })
        .into()
}

fn patch_bending(case: &Value) -> Vec<Row> {
    let (inputs, expected) = (&case["inputs"], &case["expected"]);
    let mut mesh = patch(inputs, &crate::published("fem__patch_membrane")["inputs"]);
    mesh.nx = 0;
    mesh.ny = 7;
    let mesh = mesh.clamped(&[3, 4, 5], |_, j| j < 4).clamped(&[1, 2, 6], |_, _| true);
    let motions: Vec<(u32, usize, f64)> = (1..=4)
        .flat_map(|grid| {
            let [x, y, _]: [f64; 3] = mesh.bulk.grids[&grid].xyz.into();
            let w = 0.5e-3 * (x * x + x * y + y * y);
            [(grid, 3, w), (grid, 4, 1e-3 * (y + 0.5 * x)), (grid, 5, -1e-3 * (x + 0.5 * y))]
        })
        .collect();
    let solved = solve_enforced(mesh.system(), &motions);
    let moments = resultants(&mesh, &solved, plate(inputs), true);
    // Moments that lengthen the upper side are positive here; the case counts those of w,xx > 0 positive.
    [("Mx", 0), ("My", 1), ("Mxy", 2)]
        .map(|(name, at)| {
            let wanted = number(&expected[name]);
            let got = -worst(&moments, at, -wanted);
            // Printed with eight digits.
            Row::within(format!("{name}, the point furthest off"), got, wanted, 1e-8, 5e-15)
        })
        .into()
}

/// A quarter of a rectangular plate with its centre in the corner s = t = 1.
fn quarter_plate(plate: Isotropic, a: f64, b: f64, n: usize, clamped: bool) -> Mesh {
    let mesh = Mesh::mapped(n, n, |s, t| [0.5 * a * s, 0.5 * b * t, 0.0]).of(plate);
    let mesh = mesh.clamped(&[1, 2, 6], |_, _| true);
    let mesh = mesh.clamped(&[5], |i, _| i == n).clamped(&[4], |_, j| j == n);
    if clamped {
        mesh.clamped(&[3, 4, 5], |i, j| i == 0 || j == 0)
    } else {
        mesh.clamped(&[3, 4], |i, _| i == 0).clamped(&[3, 5], |_, j| j == 0)
    }
}

fn rectangular_plate(case: &Value) -> Vec<Row> {
    let (inputs, expected) = (&case["inputs"], &case["expected"]);
    let (a, b) = (number(&inputs["a"]), number(&inputs["b"]));
    let (q, p) = (number(&inputs["q"]), number(&inputs["P"]));
    let rel = number(&case["tolerance"]["rel"]);
    let mut rows = Vec::new();
    for (edges, clamped) in [("ss", false), ("cl", true)] {
        let mesh = quarter_plate(plate(inputs), a, b, 8, clamped);
        let centre = mesh.id(8, 8);
        for (load, forces) in [("udl", mesh.pressure(3, |_| q)), ("point", vec![(centre, 3, 0.25 * p)])] {
            let name = format!("{edges}_{load}");
            let got = mesh.solved(&forces).at(centre, 3);
            rows.push(Row::relative(format!("{name}, 8 x 8 a quarter"), got, number(&expected[&name]), rel));
        }
    }
    rows.extend(square_plate_rows(case));
    rows
}

fn thin_plate(case: &Value) -> Vec<Row> {
    let expected = &case["expected"];
    let plate = Isotropic { e: 70e9, nu: 0.3, rho: 2700.0, t: 1e-3 };
    let n = 32;
    let mesh = quarter_plate(plate, 1.0, 1.0, n, false);
    let w = mesh.solved(&mesh.pressure(3, |_| 1.0)).at(mesh.id(n, n), 3) * plate.rigidity();
    let rel = number(&case["tolerance"]["rel"]);
    let exact = number(&expected["ss_square_udl_center_w_over_qa4D"]);
    let mut rows = vec![Row::relative("deflection of the centre, 32 x 32 a quarter", w, exact, rel)];
    // Modes with m, n odd are those of the quarter.
    let unit = std::f64::consts::PI.powi(2) * (plate.rigidity() / (plate.rho * plate.t)).sqrt();
    let got = mesh.frequencies_hz(1)[0] * std::f64::consts::TAU;
    rows.push(Row::relative("first frequency (1, 1), 32 x 32 a quarter", got / unit, 2.0, rel));
    rows
}

fn razzaque(case: &Value) -> Vec<Row> {
    let inputs = &case["inputs"];
    let (plate, side) = (plate(inputs), number(&inputs["side"]));
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let n = 32;
    let mesh = Mesh::mapped(n, n, |s, t| [side * (s + sin * t), side * cos * t, 0.0]).of(plate);
    let mesh = mesh.clamped(&[1, 2, 3, 5, 6], |_, j| j == 0 || j == n);
    let q = number(&inputs["q"]);
    let got = mesh.solved(&mesh.pressure(3, |_| q)).at(mesh.id(n / 2, n / 2), 3);
    let unit = q * side.powi(4) / plate.rigidity();
    vec![Row::relative(
        "deflection of the centre, 32 x 32",
        got / unit,
        7.945e-3,
        number(&case["tolerance"]["rel"]),
    )]
}

fn elliptic_membrane(case: &Value) -> Vec<Row> {
    let (inputs, expected) = (&case["inputs"], &case["expected"]);
    let (inner, outer) = (numbers(&inputs["inner"]), numbers(&inputs["outer"]));
    let pressure = number(&inputs["outward_pressure"]);
    let (nx, ny) = (24, 16);
    // s from the x axis to the y axis along the ellipses, t from the inner to the outer one.
    let at = |s: f64, t: f64| {
        let (sin, cos) = (0.5 * std::f64::consts::PI * s).sin_cos();
        let between = |axis: usize| inner[axis] + (outer[axis] - inner[axis]) * t;
        [between(0) * cos, between(1) * sin, 0.0]
    };
    let plate = plate(inputs);
    let mesh = Mesh::mapped(nx, ny, at).of(plate);
    let mesh = mesh.clamped(&[3, 4, 5], |_, _| true);
    let mesh = mesh.clamped(&[2], |i, _| i == 0).clamped(&[1], |i, _| i == nx);
    let mut loads = Vec::new();
    for i in 0..nx {
        let ends = [mesh.id(i, ny), mesh.id(i + 1, ny)];
        let [a, b] = ends.map(|id| mesh.bulk.grids[&id].xyz);
        let force = [(b[1] - a[1]) * pressure * plate.t, -(b[0] - a[0]) * pressure * plate.t];
        loads.extend(ends.iter().flat_map(|id| [(*id, 1, 0.5 * force[0]), (*id, 2, 0.5 * force[1])]));
    }
    let solved = mesh.solved(&loads);
    // The element at D: corner (s, t) = (0, 0); its x axis runs along the ellipse, here close to y.
    let (strains, shell) = solved.strains(&mesh, mesh.id(0, 0), &section(plate), [-1.0, -1.0]);
    let own = section(plate).membrane * nalgebra::Vector3::from(strains.membrane) / plate.t;
    let axes = shell.axes().fixed_view::<2, 2>(0, 0).into_owned();
    let basic = axes.transpose() * nalgebra::Matrix2::new(own[0], own[2], own[2], own[1]) * axes;
    vec![Row::relative("sigma_yy at D, 24 x 16", basic[(1, 1)], number(&expected["sigma_yy_D"]), 0.02)]
}
