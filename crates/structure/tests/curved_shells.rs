//! Shells with grids on their sides: patches, the contract, NAFEMS' elliptic membrane, plates, Scordelis and Lo's roof.

use crate::common::{at, close, displaced, system};
use crate::contract::{Specimen, contract};
use crate::meshed::{Mesh, QUAD, TRIANGLE, side_forces};
use nalgebra::{DMatrix, DVector, Point3, Rotation3, Vector3};
use nastran::{Mat8, Span, parse_deck};
use std::sync::Arc;
use structure::{
    CurvedPlace, CurvedShell, Element, Flexibility, Model, PlacedPly, PlaneMaterial, SectionAxis, ShearModel,
    ShellSection, System, loads_of,
};

/// MacNeal and Harder's patch: E = 1e6, nu = .25, t = .001.
const E: f64 = 1e6;
const NU: f64 = 0.25;

fn ply(e: f64, nu: f64, thickness_m: f64, low_m: f64) -> Arc<ShellSection> {
    let g = e / (2.0 * (1.0 + nu));
    let span = Span::generated("test");
    let card = Mat8 {
        id: 1,
        e1: e,
        e2: e,
        nu12: nu,
        g12: g,
        g1z: g,
        g2z: g,
        rho: 100.0,
        expansion: nastran::Expansion::default(),
        span,
    };
    let material = PlaneMaterial::ply(&card).expect("a sound material");
    let ply = PlacedPly { material, angle_rad: 0.0, z_low_m: low_m, z_high_m: low_m + thickness_m };
    Arc::new(ShellSection::laminate(&[ply], 0.7, ShearModel::Equilibrium))
}

fn shell(
    nodes: Vec<usize>,
    points: Vec<Point3<f64>>,
    offset_m: f64,
    section: Arc<ShellSection>,
) -> CurvedShell {
    let sides: Vec<usize> = (0..nodes.len() / 2).collect();
    let place = CurvedPlace { nodes, points, sides, offset_m };
    let axis = SectionAxis::Along(Vector3::new(1.0, 0.0, 0.0));
    CurvedShell::new(1, place, section, axis, &Span::generated("test")).expect("a possible shell")
}

/// Corners, and the middles of the sides behind them.
fn with_middles(corners: &[Vector3<f64>]) -> Vec<Point3<f64>> {
    let sides = if corners.len() == 4 { QUAD } else { TRIANGLE };
    let middles = sides.iter().map(|[a, b]| (corners[*a] + corners[*b]) * 0.5);
    corners.iter().copied().chain(middles).map(Point3::from).collect()
}

#[test]
fn flat_ones_keep_the_contract_and_have_the_inertia_of_a_plate() {
    let quad = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.3], [1.1, 0.9, 0.3], [0.0, 0.7, 0.3]].map(Vector3::from);
    let area_of_quad = 0.5 * (quad[2] - quad[0]).cross(&(quad[3] - quad[1])).norm();
    let triangle = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.1], [0.4, 0.9, 0.5]].map(Vector3::from);
    let area_of_triangle = 0.5 * (triangle[1] - triangle[0]).cross(&(triangle[2] - triangle[0])).norm();
    for (corners, area) in [(&quad[..], area_of_quad), (&triangle, area_of_triangle)] {
        for offset_m in [0.0, 0.05] {
            let points = with_middles(corners);
            contract(|rotation: &Rotation3<f64>| {
                let turned: Vec<Point3<f64>> = points.iter().map(|point| rotation * point).collect();
                let place = CurvedPlace {
                    nodes: (0..points.len()).collect(),
                    points: turned,
                    sides: (0..points.len() / 2).collect(),
                    offset_m,
                };
                let axis = SectionAxis::Along(rotation * Vector3::new(0.8, 0.6, 0.0));
                let section = ply(70e9, 0.3, 0.02, -0.005);
                let element = CurvedShell::new(1, place, section, axis, &Span::generated("test"));
                let element = element.expect("a possible shell");
                close(element.area_m2(), area, 1e-12, "area");
                Specimen {
                    element,
                    points: points.clone(),
                    mass_kg: (100.0 * 0.02 + 0.7) * area,
                    inertia: None,
                }
            });
        }
    }
    // A rectangle's mass about its middle, the plies from -.005 to .015 above the grids.
    let corners =
        [[-0.6, -0.25, 0.0], [0.6, -0.25, 0.0], [0.6, 0.25, 0.0], [-0.6, 0.25, 0.0]].map(Vector3::from);
    let points = with_middles(&corners);
    contract(|rotation| {
        let turned: Vec<Point3<f64>> = points.iter().map(|point| rotation * point).collect();
        let element = shell((0..8).collect(), turned, 0.0, ply(70e9, 0.3, 0.02, -0.005));
        let (m, second) = (2.7 * 0.6, 100.0 * 0.6 * (0.015_f64.powi(3) + 0.005_f64.powi(3)) / 3.0);
        let inertia = Vector3::new(m * 0.25 / 12.0 + second, m * 1.44 / 12.0 + second, m * 1.69 / 12.0);
        let first = Vector3::new(0.0, 0.0, 100.0 * 0.6 * (0.015_f64.powi(2) - 0.005_f64.powi(2)) / 2.0);
        let inertia = Some((nalgebra::Matrix3::from_diagonal(&inertia), first));
        Specimen { element, points: points.clone(), mass_kg: m, inertia }
    });
}

/// A piece of a saddle: rigid motions meet no force, and no other motion is free.
#[test]
fn a_doubly_curved_one_has_exactly_six_motions_without_energy() {
    for corners in
        [&[[0.0, 0.0], [1.0, 0.1], [1.1, 0.9], [0.1, 1.0]][..], &[[0.0, 0.0], [1.0, 0.1], [0.2, 0.9]]]
    {
        let flat: Vec<_> = corners.iter().map(|[x, y]| Vector3::new(*x, *y, 0.0)).collect();
        let up = |p: Point3<f64>| Point3::new(p.x, p.y, 0.3 * p.x * p.x - 0.2 * p.y * p.y + 0.1 * p.x * p.y);
        let points: Vec<_> = with_middles(&flat).into_iter().map(up).collect();
        let element = shell((0..points.len()).collect(), points.clone(), 0.1, ply(70e9, 0.3, 0.02, -0.005));
        let k = element.stiffness().expect("has stiffness").into_owned();
        let forces = &k * crate::contract::rigid(&points);
        assert!(forces.amax() < 1e-12 * k.amax(), "rigid motions: {:e}", forces.amax() / k.amax());
        let scale = DVector::from_fn(k.nrows(), |i, _| 1.0 / k[(i, i)].sqrt());
        let scaled = DMatrix::from_fn(k.nrows(), k.ncols(), |i, j| scale[i] * k[(i, j)] * scale[j]);
        let energies = scaled.symmetric_eigenvalues();
        assert_eq!(energies.iter().filter(|energy| energy.abs() < 1e-11).count(), 6, "{energies}");
    }
}

/// Corners of the elements of MacNeal and Harder's patch of five quadrilaterals (Finite Elem. Anal. Des. 1, 1985), or of each cut into two
/// triangles.
fn distorted(is_triangles: bool) -> Vec<Vec<Vector3<f64>>> {
    let corners = [
        [0.0, 0.0],
        [0.24, 0.0],
        [0.24, 0.12],
        [0.0, 0.12],
        [0.04, 0.02],
        [0.18, 0.03],
        [0.16, 0.08],
        [0.08, 0.08],
    ];
    let corner = |at: usize| Vector3::new(corners[at][0], corners[at][1], 0.0);
    let quads = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    if is_triangles {
        let cut = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]);
        return cut.map(|triangle| triangle.map(corner).into()).collect();
    }
    quads.map(|quad| quad.map(corner).into()).into()
}

/// Nine rectangles of the same outline.
fn rectangles() -> Vec<Vec<Vector3<f64>>> {
    let (x, y) = ([0.0, 0.04, 0.18, 0.24], [0.0, 0.03, 0.08, 0.12]);
    let at = |i: usize, j: usize| Vector3::new(x[i], y[j], 0.0);
    (0..9)
        .map(|cell| (cell % 3, cell / 3))
        .map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        .collect()
}

fn patch(cells: &[Vec<Vector3<f64>>]) -> (Vec<CurvedShell>, Vec<Vector3<f64>>) {
    let mut mesh = Mesh::new(|p| p);
    let mut shells = Vec::new();
    for corners in cells {
        let sides = if corners.len() == 4 { QUAD } else { TRIANGLE };
        let nodes: Vec<usize> = mesh.grids_of(corners, sides).iter().map(|grid| *grid as usize - 1).collect();
        shells.push(shell(nodes, with_middles(corners), 0.0, ply(E, NU, 0.001, -0.0005)));
    }
    (shells, mesh.grids.iter().map(|grid| grid[1]).collect())
}

/// Motions of all grids when those on the border move as the field says.
fn solved(
    shells: &[CurvedShell],
    grids: &[Vector3<f64>],
    field: impl Fn(&Vector3<f64>) -> [f64; 6],
) -> DVector<f64> {
    let n = 6 * grids.len();
    let (mut k, mut u) = (DMatrix::zeros(n, n), DVector::zeros(n));
    for shell in shells {
        let own = shell.stiffness().expect("has stiffness");
        for (j, column) in shell.dofs().iter().enumerate() {
            for (i, row) in shell.dofs().iter().enumerate() {
                k[(*row, *column)] += own[(i, j)];
            }
        }
    }
    let is_outer = |p: &Vector3<f64>| p.x < 1e-9 || p.y < 1e-9 || p.x > 0.24 - 1e-9 || p.y > 0.12 - 1e-9;
    for (node, point) in grids.iter().enumerate().filter(|(_, point)| is_outer(point)) {
        u.rows_mut(6 * node, 6).copy_from_slice(&field(point));
    }
    let free: Vec<usize> = (0..n).filter(|dof| !is_outer(&grids[dof / 6])).collect();
    let load = -(&k * &u).select_rows(&free);
    let inner = k.select_rows(&free).select_columns(&free).cholesky().expect("stiff").solve(&load);
    free.iter().zip(inner.iter()).for_each(|(dof, value)| u[*dof] = *value);
    u
}

/// MacNeal and Harder's membrane field: strains of 1e-3, stresses 1333, 1333, 400.
#[test]
fn a_distorted_patch_holds_a_constant_membrane_strain() {
    for is_triangles in [false, true] {
        let (shells, grids) = patch(&distorted(is_triangles));
        let field =
            |p: &Vector3<f64>| [1e-3 * (p.x + 0.5 * p.y), 1e-3 * (p.y + 0.5 * p.x), 0.0, 0.0, 0.0, 0.0];
        let u = solved(&shells, &grids, field);
        for shell in &shells {
            let own: Vec<f64> = shell.dofs().iter().map(|dof| u[*dof]).collect();
            for place in [[0.2, 0.3], [0.6, 0.1]] {
                let strains = shell.strains(&own, place).expect("a normal there");
                for value in strains.membrane {
                    close(value, 1e-3, 1e-9, "membrane strain");
                }
                assert!(
                    strains.curvature.iter().chain(&strains.shear).all(|other| other.abs() < 1e-9),
                    "{strains:?}"
                );
            }
        }
    }
}

/// MacNeal and Harder's bending field, w = (x^2 + x y + y^2) / 2 times 1e-3: exact in triangles of any form, whose functions are complete to
/// second degree, and in parallelograms.
#[test]
fn a_patch_holds_a_constant_curvature() {
    for is_triangles in [false, true] {
        let (shells, grids) = patch(&if is_triangles { distorted(true) } else { rectangles() });
        let field = |p: &Vector3<f64>| {
            let (x, y) = (p.x, p.y);
            [0.0, 0.0, 5e-4 * (x * x + x * y + y * y), 1e-3 * (0.5 * x + y), -1e-3 * (x + 0.5 * y), 0.0]
        };
        let u = solved(&shells, &grids, field);
        for shell in &shells {
            let own: Vec<f64> = shell.dofs().iter().map(|dof| u[*dof]).collect();
            let at = if is_triangles { [1.0 / 6.0, 2.0 / 3.0] } else { [0.0; 2] };
            let strains = shell.strains(&own, at).expect("a normal there");
            for value in strains.curvature {
                close(value, -1e-3, 1e-8, "curvature");
            }
        }
    }
}

/// NAFEMS LE1: a quarter of an elliptic membrane, 10 MPa outward on its outer edge; the stress along y at D (2, 0) is 92.7 MPa
/// (NAFEMS, *The Standard NAFEMS Benchmarks*, 1990).
#[test]
fn an_elliptic_membrane_has_the_stress_of_nafems_le1() {
    for (name, cells, relative) in [("CQUAD8", [8, 16], 0.01), ("CTRIA6", [16, 24], 0.02)] {
        let mut mesh = Mesh::new(|p| {
            let (sin, cos) = (p.y * std::f64::consts::FRAC_PI_2).sin_cos();
            // Finer towards the inner edge.
            let x = 0.5 * p.x * (1.0 + p.x);
            Vector3::new((2.0 + 1.25 * x) * cos, (1.0 + 1.75 * x) * sin, 0.0)
        });
        mesh.sheet(name, cells);
        mesh.hold("3456", |_, _| true);
        mesh.hold("2", |p, _| p.y == 0.0);
        mesh.hold("1", |p, _| p.y == 1.0);
        let mut loads = Vec::new();
        for side in 0..cells[1] {
            let step = 0.5 / cells[1] as f64;
            let grids =
                [0.0, 1.0, 2.0].map(|at| mesh.grid(Vector3::new(1.0, (2.0 * side as f64 + at) * step, 0.0)));
            let places = grids.map(|grid| mesh.grids[grid as usize - 1][1]);
            // The tangent runs counterclockwise: turned by a right angle it points inwards, minus that outwards.
            let forces =
                side_forces(places, |_, tangent| Vector3::new(tangent.y, -tangent.x, 0.0) * (10e6 * 0.1));
            for (grid, force) in grids.iter().zip(forces) {
                loads.extend([(*grid, 1, force.x), (*grid, 2, force.y)]);
            }
        }
        let d = mesh.grid(Vector3::zeros());
        let deck = mesh.deck("PSHELL,1,1,.1,1,,1\nMAT1,1,2.1+11,,.3\n");
        let system = system(&deck);
        let u = displaced(&system, &loads);
        let bulk = parse_deck("le1.bdf", &deck).expect("a deck");
        let card = bulk.shells.values().find(|shell| shell.grids[0] == d).expect("an element begins at D");
        let grids: Vec<u32> =
            card.grids.iter().copied().chain(card.midsides.iter().flatten().copied()).collect();
        let points: Vec<_> = grids.iter().map(|grid| mesh.grids[*grid as usize - 1][1].into()).collect();
        let own: Vec<f64> =
            grids.iter().flat_map(|grid| (1..=6).map(|c| at(&system, &u, *grid, c))).collect();
        let element = shell((0..grids.len()).collect(), points, 0.0, ply(2.1e11, 0.3, 0.1, -0.05));
        let corner = if name == "CQUAD8" { [-1.0, -1.0] } else { [0.0, 0.0] };
        let [x, y, _] = element.strains(&own, corner).expect("a normal there").membrane;
        let stress = 2.1e11 / (1.0 - 0.09) * (y + 0.3 * x);
        close(stress, 92.7e6, relative, &format!("stress along y at D, {name}"));
    }
}

/// A simply supported square plate under pressure: 0.00406 q a^4 / D in the middle (Timoshenko and Woinowsky-Krieger, *Theory of
/// Plates and Shells*, table 8), thin and very thin.
#[test]
fn thin_plates_under_pressure_do_not_lock() {
    for (name, cells) in [("CQUAD8", 6), ("CTRIA6", 8)] {
        for thickness in [0.02_f64, 0.002] {
            let mut mesh = Mesh::new(|p| p * 2.0);
            mesh.sheet(name, [cells; 2]);
            mesh.hold("3", |p, _| p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0);
            mesh.hold("126", |_, _| true);
            let middle = mesh.grid(Vector3::new(0.5, 0.5, 0.0));
            let elements = if name == "CQUAD8" { cells * cells } else { 2 * cells * cells };
            let deck = mesh.deck(&format!(
                "PSHELL,1,1,{thickness},1,,1\nMAT1,1,7.+10,,.3\nPLOAD2,2,-100.,1,THRU,{elements}\n"
            ));
            let bulk = parse_deck("plate.bdf", &deck).expect("a deck");
            let system = System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a system");
            let forces = system.forces_of(&loads_of(&bulk, 2).expect("loads"));
            let flexibility = Flexibility::new(&system).expect("stiff");
            let u =
                system.expand(flexibility.displacements(system.reduce(forces.as_ref()).as_ref()).as_ref());
            let bending = 7e10 * thickness.powi(3) / (12.0 * (1.0 - 0.09));
            let expected = -0.00406 * 100.0 * 16.0 / bending;
            close(at(&system, &u, middle, 3), expected, 0.02, &format!("{name}, {thickness} m thick"));
        }
    }
}

/// Scordelis and Lo's roof: 0.3024 downwards at the middle of the free edge (MacNeal and Harder 1985).
#[test]
fn scordelis_and_los_roof_sinks_by_the_published_amount() {
    for (name, cells) in [("CQUAD8", 4), ("CTRIA6", 8)] {
        let (radius, length, angle) = (25.0, 25.0, 40.0_f64.to_radians());
        // A quarter: x from the middle to the end, the arc from the crown to the free edge.
        let mut mesh = Mesh::new(|p| {
            let (sin, cos) = (p.y * angle).sin_cos();
            Vector3::new(length * p.x, radius * sin, radius * cos)
        });
        mesh.sheet(name, [cells; 2]);
        mesh.hold("23", |p, _| p.x == 1.0);
        mesh.hold("156", |p, _| p.x == 0.0);
        mesh.hold("246", |p, _| p.y == 0.0);
        let edge = mesh.grid(Vector3::new(0.0, 1.0, 0.0));
        // 90 per area downwards: a density of 360 under a unit acceleration, .25 thick.
        let deck = mesh.deck("PSHELL,1,1,.25,1,,1\nMAT1,1,4.32+8,,0.,360.\nGRAV,2,,1.,0.,0.,-1.\n");
        let bulk = parse_deck("roof.bdf", &deck).expect("a deck");
        let system = System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a system");
        let forces = system.forces_of(&loads_of(&bulk, 2).expect("loads"));
        let flexibility = Flexibility::new(&system).expect("stiff");
        let u = system.expand(flexibility.displacements(system.reduce(forces.as_ref()).as_ref()).as_ref());
        close(at(&system, &u, edge, 3), -0.3024, 0.02, name);
    }
}

/// A side without a grid is straight and as linear as that of the CQUAD4 beside it: a strip of both under tension.
#[test]
fn one_side_without_a_grid_fits_a_flat_shell_beside_it() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.2,0.,0.\nGRID,4,,2.2,1.,0.\nGRID,5,,1.1,1.,0.\n\
                GRID,6,,0.,1.,0.\nGRID,7,,.5,0.,0.\nGRID,8,,.55,1.,0.\nGRID,9,,0.,.5,0.\n\
                CQUAD8,1,1,1,2,5,6,7,\n,8,9\nCQUAD4,2,1,2,3,4,5\n\
                PSHELL,1,1,.1,1,,1\nMAT1,1,7.+10,,.3\nSPC1,1,3456,1,THRU,9\nSPC1,1,1,1,6,9\nSPC1,1,2,1\n";
    let system = system(deck);
    // 1000 N per m on the end of the flat shell.
    let u = displaced(&system, &[(3, 1, 500.0), (4, 1, 500.0)]);
    let stress = 1000.0 / 0.1;
    for (grid, x, y) in [(3, 2.2, 0.0), (4, 2.2, 1.0), (8, 0.55, 1.0), (7, 0.5, 0.0), (5, 1.1, 1.0)] {
        close(at(&system, &u, grid, 1), stress / 7e10 * x, 1e-9, "along the strip");
        assert!((at(&system, &u, grid, 2) + 0.3 * stress / 7e10 * y).abs() < 1e-9 * stress / 7e10, "across");
    }
}

/// Decks of plane problems hold all rotations. Those about the normal are no part of the membrane, and it must not be held with them.
#[test]
fn a_membrane_bends_in_its_plane_where_all_rotations_are_held() {
    for (name, cells, relative) in [
        ("CQUAD4", [20, 2], 0.01),
        ("CQUAD8", [10, 1], 0.01),
        ("CTRIA6", [10, 2], 0.01),
        ("CTRIA3", [80, 16], 0.03),
    ] {
        let mut mesh = Mesh::new(|p| Vector3::new(2.0 * p.x, 0.2 * p.y, 0.0));
        mesh.sheet(name, cells);
        mesh.hold("123456", |p, _| p.x == 0.0);
        mesh.hold("3456", |_, _| true);
        let tip = [mesh.grid(Vector3::new(1.0, 0.0, 0.0)), mesh.grid(Vector3::new(1.0, 1.0, 0.0))];
        let system = system(&mesh.deck("PSHELL,1,1,.01,1,,1\nMAT1,1,7.+10,,.3\n"));
        let u = displaced(&system, &[(tip[0], 2, 500.0), (tip[1], 2, 500.0)]);
        let (bending, shear) = (7e10 * 0.01 * 0.008 / 12.0, 7e10 / 2.6 * 0.01 * 0.2 / 1.2);
        let expected = 1000.0 * (8.0 / (3.0 * bending) + 2.0 / shear);
        close(at(&system, &u, tip[0], 2), expected, relative, name);
    }
}
