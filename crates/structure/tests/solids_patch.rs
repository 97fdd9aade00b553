//! Patch tests: meshes of irregular solids hold a constant strain exactly, alone and mixed.
//!
//! A cube of 3 x 3 x 3 cells, inner grids moved at random, the outer ones displaced by a linear field: the inner
//! ones must follow it and the stress must be that of the field everywhere.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use nalgebra::{DMatrix, DVector, Matrix3, Point3, Rotation3, Vector3};
use nastran::{Mat1, Mat9, Span};
use std::sync::Arc;
use structure::{Element, Solid, SolidMaterial};

#[derive(Debug, Clone, Copy)]
enum Cells {
    Hexahedra,
    Wedges,
    Tetrahedra,
    HexahedraAndWedges,
}

const SIDE: usize = 4;

fn node(i: usize, j: usize, k: usize) -> usize {
    (k * SIDE + j) * SIDE + i
}

/// A number between -1 and 1 that looks random and is the same on every run.
fn scatter(seed: usize) -> f64 {
    let x = (seed as f64 + 1.0) * 12.9898;
    2.0 * (x.sin() * 43758.5453).rem_euclid(1.0) - 1.0
}

fn is_inner(i: usize) -> bool {
    let inner = |at: usize| (1..SIDE - 1).contains(&at);
    inner(i % SIDE) && inner(i / SIDE % SIDE) && inner(i / SIDE / SIDE)
}

fn grids() -> Vec<Point3<f64>> {
    let place = |i: usize| {
        let regular = Vector3::new((i % SIDE) as f64, (i / SIDE % SIDE) as f64, (i / SIDE / SIDE) as f64);
        let moved = Vector3::from_fn(|axis, _| if is_inner(i) { 0.22 * scatter(3 * i + axis) } else { 0.0 });
        Point3::from((regular + moved).component_mul(&Vector3::new(1.0, 0.7, 1.3)))
    };
    (0..SIDE.pow(3)).map(place).collect()
}

fn elements(cells: Cells) -> Vec<Vec<usize>> {
    let mut list = Vec::new();
    for cell in 0..(SIDE - 1).pow(3) {
        let n = SIDE - 1;
        let (i, j, k) = (cell % n, cell / n % n, cell / n / n);
        let at = |corner: usize| node(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
        let pick = |corners: &[usize]| corners.iter().map(|corner| at(*corner)).collect::<Vec<_>>();
        let wedges = [pick(&[0, 1, 3, 4, 5, 7]), pick(&[0, 3, 2, 4, 7, 6])];
        match cells {
            Cells::HexahedraAndWedges if (i + j) % 2 == 1 => list.extend(wedges),
            Cells::Hexahedra | Cells::HexahedraAndWedges => list.push(pick(&[0, 1, 3, 2, 4, 5, 7, 6])),
            Cells::Wedges => list.extend(wedges),
            // Kuhn's six tetrahedra around the diagonal 0-7: neighbours match.
            Cells::Tetrahedra => list
                .extend([[1, 3], [3, 2], [2, 6], [6, 4], [4, 5], [5, 1]].map(|[a, b]| pick(&[0, a, b, 7]))),
        }
    }
    list
}

fn materials() -> [Arc<SolidMaterial>; 2] {
    let span = Span::generated("test");
    let steel = Mat1 {
        id: 1,
        e: 1e6,
        g: 0.0,
        nu: 0.25,
        rho: 1.0,
        expansion: nastran::Expansion::default(),
        span: span.clone(),
    };
    let mut g = [0.0; 21];
    for (at, value) in
        [(0, 25.2), (1, 0.34), (2, 0.34), (6, 1.07), (7, 0.27), (11, 1.07), (15, 0.5), (18, 0.2), (20, 0.5)]
    {
        g[at] = value;
    }
    let ply = Mat9 { id: 2, g, rho: 1.0, expansion: nastran::Expansion::default(), span };
    let axes = Rotation3::from_euler_angles(0.7, -0.2, 1.1);
    [SolidMaterial::from_mat1(&steel), SolidMaterial::from_mat9(&ply, axes.matrix())]
        .map(|material| Arc::new(material.unwrap()))
}

#[test]
fn a_constant_strain_is_held_exactly_by_distorted_meshes() {
    let gradient = Matrix3::new(1e-3, 4e-4, -2e-4, 3e-4, -7e-4, 5e-4, 6e-4, -1e-4, 2e-4);
    let g = gradient;
    let strain = nalgebra::Vector6::new(
        g[(0, 0)],
        g[(1, 1)],
        g[(2, 2)],
        g[(0, 1)] + g[(1, 0)],
        g[(1, 2)] + g[(2, 1)],
        g[(2, 0)] + g[(0, 2)],
    );
    let grids = grids();
    let linear = |i: usize| gradient * grids[i].coords;
    for cells in [Cells::Hexahedra, Cells::Wedges, Cells::Tetrahedra, Cells::HexahedraAndWedges] {
        for material in materials() {
            let solids = build(&elements(cells), &grids, &material);
            let displacements = solve(&solids, &grids, &linear);
            let stress = material.stiffness * strain;
            for i in 0..grids.len() {
                let error = (displacements.fixed_rows::<3>(3 * i) - linear(i)).amax();
                assert!(error < 1e-14, "{cells:?} grid {i}: {error:e}");
            }
            for solid in &solids {
                let place = |i: usize| 3 * solid.nodes()[i / 3] + i % 3;
                let own = DVector::from_fn(3 * solid.nodes().len(), |i, _| displacements[place(i)]);
                for at in [[0.25, 0.25, 0.0], [0.5, 0.1, -0.9], [0.1, 0.7, 0.8]] {
                    let error =
                        (nalgebra::Vector6::from(solid.stress(&own, at)) - stress).amax() / stress.amax();
                    assert!(error < 1e-11, "{cells:?} {}: {error:e}", solid.id());
                }
            }
        }
    }
}

fn build(elements: &[Vec<usize>], grids: &[Point3<f64>], material: &Arc<SolidMaterial>) -> Vec<Solid> {
    let solid = |(id, nodes): (u32, &Vec<usize>)| {
        let points: Vec<_> = nodes.iter().map(|at| grids[*at]).collect();
        Solid::new(id, nodes.clone(), &points, material, &Span::generated("test")).unwrap()
    };
    (1..).zip(elements).map(solid).collect()
}

/// Displacements of all grids when the outer ones are displaced as given.
fn solve(solids: &[Solid], grids: &[Point3<f64>], outer: &impl Fn(usize) -> Vector3<f64>) -> DVector<f64> {
    let n = 3 * grids.len();
    let mut k = DMatrix::zeros(n, n);
    for solid in solids {
        let dofs: Vec<_> = solid.dofs().iter().map(|dof| dof / 6 * 3 + dof % 6).collect();
        let own = solid.stiffness().unwrap();
        for (j, column) in dofs.iter().enumerate() {
            for (i, row) in dofs.iter().enumerate() {
                k[(*row, *column)] += own[(i, j)];
            }
        }
    }
    let mut u = DVector::zeros(n);
    for i in (0..grids.len()).filter(|i| !is_inner(*i)) {
        u.fixed_rows_mut::<3>(3 * i).copy_from(&outer(i));
    }
    let free: Vec<usize> = (0..n).filter(|dof| is_inner(dof / 3)).collect();
    let load = -(&k * &u).select_rows(&free);
    let solution = k.select_rows(&free).select_columns(&free).cholesky().unwrap().solve(&load);
    for (at, dof) in free.iter().enumerate() {
        u[*dof] = solution[at];
    }
    u
}
