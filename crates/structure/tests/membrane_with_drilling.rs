//! CTRIAR's membrane, whose corners' rotations about the normal bend its sides: patches, bent rectangles and Cook's membrane.

use crate::common::{at, close, displaced, system};
use crate::contract::{Specimen, contract};
use nalgebra::{DVector, Point3, Vector3};
use nastran::{Mat8, Span};
use std::fmt::Write;
use std::sync::Arc;
use structure::{Element, PlacedPly, PlaneMaterial, ShearModel, Shell, ShellSection, System};

/// Corners in order, then the patch's inner node.
const PATCH: [[f64; 2]; 7] =
    [[0.0, 0.0], [1.1, 0.0], [2.0, 0.0], [2.0, 1.0], [0.7, 1.0], [0.0, 1.0], [0.8, 0.35]];
const E: f64 = 70e9;
const NU: f64 = 0.3;
const THICKNESS_M: f64 = 0.002;

fn isotropic() -> Arc<ShellSection> {
    sheet(E, E, E / (2.0 * (1.0 + NU)), 0.0)
}

/// A sheet of one ply.
fn sheet(e1: f64, e2: f64, g12: f64, angle_rad: f64) -> Arc<ShellSection> {
    let span = Span::generated("test");
    let card = Mat8 {
        id: 1,
        e1,
        e2,
        nu12: NU,
        g12,
        g1z: g12,
        g2z: g12,
        rho: 2700.0,
        expansion: nastran::Expansion::default(),
        span,
    };
    let material = PlaneMaterial::ply(&card).expect("a sound material");
    let (z_low_m, z_high_m) = (-0.5 * THICKNESS_M, 0.5 * THICKNESS_M);
    let ply = PlacedPly { material, angle_rad, z_low_m, z_high_m };
    Arc::new(ShellSection::laminate(&[ply], 0.0, ShearModel::Equilibrium))
}

/// A triangle with drilling; the section's x axis is `along`, in the plane z = 0.
fn triangle(nodes: [usize; 3], section: &Arc<ShellSection>, along: Vector3<f64>) -> Shell {
    let points = nodes.map(|node| Point3::new(PATCH[node][0], PATCH[node][1], 0.0));
    let axes = Shell::axes_of(&points).expect("an area");
    let x = axes * along;
    let span = Span::generated("test");
    Shell::new(1, nodes.to_vec(), &points, 0.0, Arc::clone(section), x.y.atan2(x.x), &span)
        .expect("a possible shell")
        .with_drilling()
}

/// The patch's six triangles around its inner node.
fn patch() -> Vec<Shell> {
    (0..6).map(|side| triangle([side, (side + 1) % 6, 6], &isotropic(), Vector3::x())).collect()
}

/// Motions of a node at x, y where the displacement gradients are constant (u,x; u,y; v,x; v,y).
fn linear([ux, uy, vx, vy]: [f64; 4], [x, y]: [f64; 2]) -> [f64; 6] {
    [ux * x + uy * y, vx * x + vy * y, 0.0, 0.0, 0.0, 0.5 * (vx - uy)]
}

#[test]
fn a_patch_under_constant_stress_has_that_strain_everywhere_and_the_edges_forces() {
    let stretch = 1e-3;
    let uniaxial = [stretch, 0.4e-3, -0.2e-3, -NU * stretch];
    let shear = 0.2e-3;
    let modulus = E / (2.0 * (1.0 + NU));
    let mut forces = [[0.0; 6]; 7];
    for element in patch() {
        let moved: Vec<f64> =
            element.nodes().iter().flat_map(|node| linear(uniaxial, PATCH[*node])).collect();
        for place in [[0.0, 0.0], [1.0, 0.0], [0.3, 0.3]] {
            // In the element's axes: turned from the patch's.
            let turn = element.axes();
            let [x, y, xy] = element.strains(&moved, place).membrane;
            let (c, s) = (turn[(0, 0)], turn[(0, 1)]);
            let (ex, ey) = (stretch, -NU * stretch);
            close(x, c * c * ex + s * s * ey + c * s * shear, 1e-10, "strain along the element's x");
            close(y, s * s * ex + c * c * ey - c * s * shear, 1e-10, "strain along the element's y");
            close(xy, 2.0 * c * s * (ey - ex) + (c * c - s * s) * shear, 1e-10, "shear strain");
        }
        let stiffness = element.stiffness().expect("has stiffness");
        let force = &*stiffness * DVector::from_vec(moved);
        for (corner, node) in element.nodes().iter().enumerate() {
            for axis in 0..6 {
                forces[*node][axis] += force[6 * corner + axis];
            }
        }
    }
    let pull = E * stretch * THICKNESS_M;
    let slide = modulus * shear * THICKNESS_M;
    for (value, what) in forces[6].iter().zip(["x", "y", "z", "rx", "ry", "rz"]) {
        assert!(value.abs() < 1e-9 * pull, "the inner node needs no force along {what}: {value}");
    }
    // The right edge has nodes 2 and 3 (2 and 3 share the lower and upper edges' shear), the upper edge's middle is 4.
    let right = forces[2][0] + forces[3][0];
    close(right, pull + 0.5 * slide * (1.3 - 0.9), 1e-9, "force along x at the right edge's nodes");
    close(forces[4][0], slide * 0.5 * (1.3 + 0.7), 1e-9, "force along x at the upper edge's middle");
    assert!(forces[4][1].abs() < 1e-9 * pull, "no force across the upper edge");
}

#[test]
fn a_triangle_is_the_same_from_whichever_corner_it_is_listed() {
    let section = sheet(20e9, 9e9, 5e9, 0.3);
    let nodes = [0, 2, 4];
    let one = triangle(nodes, &section, Vector3::x());
    let one = one.stiffness().expect("has stiffness");
    for shift in 1..3 {
        let listed = [0, 1, 2].map(|at| nodes[(at + shift) % 3]);
        let other = triangle(listed, &section, Vector3::x());
        let other = other.stiffness().expect("has stiffness");
        for row in 0..18 {
            for column in 0..18 {
                let place = |index: usize| 6 * ((index / 6 + shift) % 3) + index % 6;
                let (here, there) = (other[(row, column)], one[(place(row), place(column))]);
                assert!((here - there).abs() < 1e-10 * one.amax(), "{row}, {column}: {here} and {there}");
            }
        }
    }
}

/// Grids `from` + (column + (columns + 1) row) of a four-sided sheet's mesh, two triangles a cell, all in the plane z = 0.
fn mesh(name: &str, cells: [usize; 2], place: impl Fn(f64, f64) -> [f64; 2]) -> String {
    let [columns, rows] = cells;
    let mut deck = String::new();
    for row in 0..=rows {
        for column in 0..=columns {
            let [x, y] = place(column as f64 / columns as f64, row as f64 / rows as f64);
            let grid = 1 + column + (columns + 1) * row;
            writeln!(deck, "GRID,{grid},,{x:.9},{y:.9},0.\nSPC1,1,345,{grid}").expect("a string");
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let low = 1 + column + (columns + 1) * row;
            let high = low + columns + 1;
            let cell = 2 * (column + columns * row) + 1;
            if name == "CQUADR" {
                writeln!(deck, "CQUADR,{cell},1,{low},{},{},{high}", low + 1, high + 1).expect("a string");
                continue;
            }
            writeln!(deck, "CTRIAR,{cell},1,{low},{},{}", low + 1, high + 1).expect("a string");
            writeln!(deck, "CTRIAR,{},1,{low},{},{high}", cell + 1, high + 1).expect("a string");
        }
    }
    deck
}

/// Two triangles that make a rectangle about the origin, bent in their plane by the curvature of one per metre: their energy over
/// the beam's, E I length / 2. Corners move as the beam's do: u = x y and a rotation of -x.
fn energy_of_a_bent_rectangle(length_m: f64, depth_m: f64) -> f64 {
    let [x, y] = [0.5 * length_m, 0.5 * depth_m];
    let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
    let triangle = |nodes: [usize; 3]| {
        let points = nodes.map(|node| Point3::new(corners[node][0], corners[node][1], 0.0));
        let axes = Shell::axes_of(&points).expect("an area");
        let along = axes * Vector3::x();
        let span = Span::generated("test");
        let shell = Shell::new(1, nodes.to_vec(), &points, 0.0, isotropic(), along.y.atan2(along.x), &span);
        let shell = shell.expect("a possible shell").with_drilling();
        let moved: Vec<f64> = nodes
            .iter()
            .flat_map(|node| [corners[*node][0] * corners[*node][1], 0.0, 0.0, 0.0, 0.0, -corners[*node][0]])
            .collect();
        let moved = DVector::from_vec(moved);
        0.5 * moved.dot(&(&*shell.stiffness().expect("has stiffness") * &moved))
    };
    let beam = 0.5 * E * THICKNESS_M * depth_m.powi(3) / 12.0 * length_m;
    (triangle([0, 1, 2]) + triangle([0, 2, 3])) / beam
}

/// The same of one quadrilateral.
fn energy_of_a_bent_quadrilateral(length_m: f64, depth_m: f64) -> f64 {
    let [x, y] = [0.5 * length_m, 0.5 * depth_m];
    let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
    let points = corners.map(|[x, y]| Point3::new(x, y, 0.0));
    let span = Span::generated("test");
    let shell = Shell::new(1, vec![0, 1, 2, 3], &points, 0.0, isotropic(), 0.0, &span);
    let shell = shell.expect("a possible shell").with_drilling();
    let moved = corners.iter().flat_map(|[x, y]| [x * y, 0.0, 0.0, 0.0, 0.0, -x]);
    let moved = DVector::from_iterator(24, moved);
    let energy = 0.5 * moved.dot(&(&*shell.stiffness().expect("has stiffness") * &moved));
    energy / (0.5 * E * THICKNESS_M * depth_m.powi(3) / 12.0 * length_m)
}

/// Felippa 2003: what makes the triangle optimal.
#[test]
fn two_triangles_bend_in_their_plane_as_a_beam_whatever_the_ratio_of_the_sides() {
    for ratio in [0.5, 1.0, 2.0, 5.0, 10.0, 20.0] {
        let energy = energy_of_a_bent_rectangle(ratio, 1.0);
        close(energy, 1.0, 1e-9, &format!("energy over the beam's, sides {ratio} to 1"));
        let quadrilateral = energy_of_a_bent_quadrilateral(ratio, 1.0);
        close(quadrilateral, 1.0, 1e-9, &format!("of a quadrilateral, sides {ratio} to 1"));
    }
}

/// The tip's deflection of Cook's membrane (E = 1, nu = 1/3, unit shear at the end), `cells` by `cells`.
fn cook(name: &str, cells: u32) -> f64 {
    let deck = mesh(name, [cells as usize; 2], |along, up| {
        let (low, high) = (44.0 * along, 44.0 + 16.0 * along);
        [48.0 * along, low + (high - low) * up]
    });
    let mut cards = String::from("MAT1,1,1.,,0.333333333\nPSHELL,1,1,1.\n");
    for row in 0..=cells {
        writeln!(cards, "SPC1,1,12,{}", 1 + (cells + 1) * row).expect("a string");
    }
    let system: System = system(&(deck + &cards));
    let tip = |row: u32| 1 + cells + (cells + 1) * row;
    let share = |row: u32| if row == 0 || row == cells { 0.5 } else { 1.0 } / f64::from(cells);
    let loads: Vec<_> = (0..=cells).map(|row| (tip(row), 2, share(row))).collect();
    at(&system, &displaced(&system, &loads), tip(cells / 2), 2)
}

#[test]
fn cooks_membrane_converges_to_its_reference_from_below() {
    const REFERENCE: f64 = 23.96;
    for (name, last) in [("CTRIAR", 0.005), ("CQUADR", 0.005)] {
        let errors = [2, 4, 8, 16, 32].map(|cells| 1.0 - cook(name, cells) / REFERENCE);
        for pair in errors.windows(2) {
            assert!(
                0.0 < pair[1] && pair[1] < 0.6 * pair[0],
                "{name}: errors fall with the mesh: {errors:?}"
            );
        }
        assert!(errors[4] < last, "{name}: half a per cent with 32 cells a side: {errors:?}");
    }
}

#[test]
fn a_quadrilateral_with_drilling_keeps_the_contract() {
    let flat = [[0.1, 0.2, 0.0], [1.3, 0.1, 0.0], [1.1, 0.9, 0.0], [0.0, 0.7, 0.0]];
    let area = 0.5 * ((1.1 - 0.1) * (0.7 - 0.1) - (0.0 - 1.3) * (0.9 - 0.2));
    for offset_m in [0.0, 0.05] {
        contract(|rotation| {
            let points = flat.map(Point3::from);
            let turned = points.map(|point| rotation * point);
            let span = Span::generated("test");
            let shell = Shell::new(1, vec![0, 1, 2, 3], &turned, offset_m, isotropic(), 0.3, &span);
            let element = shell.expect("a possible shell").with_drilling();
            let mass_kg = 2700.0 * THICKNESS_M * area;
            Specimen { element, points: points.to_vec(), mass_kg, inertia: None }
        });
    }
}
