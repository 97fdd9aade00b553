//! Solids with grids on their edges: patches of constant strain and of bending, the contract, NAFEMS' thick plate.

use crate::common::{close, displaced, system};
use crate::contract::{Specimen, contract};
use crate::meshed::{HEXA, Mesh, TETRA, WEDGE};
use nalgebra::{DMatrix, DVector, Matrix3, Point3, Vector3};
use nastran::{Mat1, Span, parse_deck};
use std::fmt::Write;
use std::sync::Arc;
use structure::{Element, MassProperties, Model, QuadraticSolid, SolidMaterial, System, loads_of};

const NU: f64 = 0.25;

fn material() -> Arc<SolidMaterial> {
    let card = Mat1 {
        id: 1,
        e: 1e6,
        g: 0.0,
        nu: NU,
        rho: 3.0,
        expansion: nastran::Expansion::default(),
        span: Span::generated("test"),
    };
    Arc::new(SolidMaterial::from_mat1(&card).expect("a sound material"))
}

/// Corners of a cell of the box, 3 x 2 x 2 cells, as elements of a kind.
fn corners(kind: &str, cell: [usize; 3]) -> Vec<Vec<Vector3<f64>>> {
    let at = |corner: usize| {
        let step = [corner & 1, corner >> 1 & 1, corner >> 2];
        Vector3::from_fn(|axis, _| (cell[axis] + step[axis]) as f64)
    };
    let pick = |list: &[usize]| list.iter().map(|corner| at(*corner)).collect::<Vec<_>>();
    match kind {
        "CHEXA" => vec![pick(&[0, 1, 3, 2, 4, 5, 7, 6])],
        "CPENTA" => vec![pick(&[0, 1, 3, 4, 5, 7]), pick(&[0, 3, 2, 4, 7, 6])],
        // Kuhn's six tetrahedra around the diagonal 0-7: neighbours match.
        _ => [[1, 3], [3, 2], [2, 6], [6, 4], [4, 5], [5, 1]].map(|[a, b]| pick(&[0, a, b, 7])).into(),
    }
}

const CELLS: [usize; 3] = [3, 2, 2];

/// The elements of a box and the places of their grids; inner corners are moved by `scatter`, grids on edges whose middle `has_grid` refuses
/// are left out.
fn patch(
    kind: &str,
    scatter: f64,
    has_grid: impl Fn(&Vector3<f64>) -> bool,
) -> (Vec<QuadraticSolid>, Vec<Vector3<f64>>) {
    let place = move |corner: Vector3<f64>| {
        let is_inner = (0..3).all(|axis| corner[axis] > 0.1 && corner[axis] < CELLS[axis] as f64 - 0.1);
        let moved = Vector3::new(0.9, -0.6, 0.8) * if is_inner { scatter * (corner.x - 1.4) } else { 0.0 };
        (corner + moved).component_mul(&Vector3::new(1.0, 0.7, 0.4))
    };
    let edges = match kind {
        "CHEXA" => HEXA,
        "CPENTA" => WEDGE,
        _ => TETRA,
    };
    let mut mesh = Mesh::new(|parameters| parameters);
    let mut solids = Vec::new();
    for cell in 0..CELLS.iter().product() {
        let cell = [cell % CELLS[0], cell / CELLS[0] % CELLS[1], cell / CELLS[0] / CELLS[1]];
        for own in corners(kind, cell) {
            let middle = |edge: usize| (own[edges[edge][0]] + own[edges[edge][1]]) * 0.5;
            let sides: Vec<usize> = (0..edges.len()).filter(|edge| has_grid(&middle(*edge))).collect();
            let with: Vec<[usize; 2]> = sides.iter().map(|edge| edges[*edge]).collect();
            let nodes: Vec<usize> =
                mesh.grids_of(&own, &with).iter().map(|grid| *grid as usize - 1).collect();
            let moved: Vec<_> = own.iter().map(|corner| place(*corner)).collect();
            let points: Vec<Point3<f64>> = moved
                .iter()
                .copied()
                .chain(with.iter().map(|[a, b]| (moved[*a] + moved[*b]) * 0.5))
                .map(Point3::from)
                .collect();
            for (node, point) in nodes.iter().zip(&points) {
                mesh.grids[*node][1] = point.coords;
            }
            let span = Span::generated("test");
            solids.push(QuadraticSolid::new(1, nodes, &points, &sides, &material(), &span).expect("a solid"));
        }
    }
    (solids, mesh.grids.iter().map(|grid| grid[1]).collect())
}

/// Displacements when the grids of the box's faces move as `field` says; the others find their place.
fn solved(
    solids: &[QuadraticSolid],
    grids: &[Vector3<f64>],
    field: &impl Fn(&Vector3<f64>) -> Vector3<f64>,
) -> DVector<f64> {
    let n = 3 * grids.len();
    let (mut k, mut u) = (DMatrix::zeros(n, n), DVector::zeros(n));
    for solid in solids {
        let dofs: Vec<_> = solid.dofs().iter().map(|dof| dof / 6 * 3 + dof % 6).collect();
        let own = solid.stiffness().expect("has stiffness");
        for (j, column) in dofs.iter().enumerate() {
            for (i, row) in dofs.iter().enumerate() {
                k[(*row, *column)] += own[(i, j)];
            }
        }
    }
    let size = Vector3::new(3.0, 1.4, 0.8);
    let is_outer =
        |point: &Vector3<f64>| (0..3).any(|axis| point[axis] < 1e-9 || point[axis] > size[axis] - 1e-9);
    for (node, point) in grids.iter().enumerate().filter(|(_, point)| is_outer(point)) {
        u.fixed_rows_mut::<3>(3 * node).copy_from(&field(point));
    }
    let free: Vec<usize> = (0..n).filter(|dof| !is_outer(&grids[dof / 3])).collect();
    let load = -(&k * &u).select_rows(&free);
    let inner = k.select_rows(&free).select_columns(&free).cholesky().expect("stiff").solve(&load);
    free.iter().zip(inner.iter()).for_each(|(dof, value)| u[*dof] = *value);
    u
}

/// Largest difference of the solved displacements from the field, over the field's largest.
fn error(
    kind: &str,
    scatter: f64,
    has_grid: impl Fn(&Vector3<f64>) -> bool,
    field: impl Fn(&Vector3<f64>) -> Vector3<f64>,
) -> f64 {
    let (solids, grids) = patch(kind, scatter, has_grid);
    let u = solved(&solids, &grids, &field);
    let expected = DVector::from_iterator(u.len(), grids.iter().flat_map(|p| <[f64; 3]>::from(field(p))));
    (u - &expected).amax() / expected.amax()
}

#[test]
fn a_constant_strain_is_held_exactly_by_distorted_meshes_with_and_without_grids_on_edges() {
    let gradient = Matrix3::new(1e-3, 4e-4, -2e-4, 3e-4, -7e-4, 5e-4, 6e-4, -1e-4, 2e-4);
    for kind in ["CHEXA", "CPENTA", "CTETRA"] {
        let all = error(kind, 0.2, |_| true, |p| gradient * p);
        assert!(all < 1e-12, "{kind} with all grids: {all:e}");
        // Edges in a part of the box have none: the elements at its border have some.
        let some = error(kind, 0.2, |middle| middle.x > 1.2, |p| gradient * p);
        assert!(some < 1e-12, "{kind} with some grids: {some:e}");
    }
}

/// Bending about z: the strain grows with y, and Poisson's strains with it. A field of second degree.
fn bent(p: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(p.x * p.y, -0.5 * (p.x * p.x + NU * (p.y * p.y - p.z * p.z)), -NU * p.y * p.z) * 1e-3
}

#[test]
fn pure_bending_is_exact_in_boxes_and_prisms_and_in_any_tetrahedra_with_straight_edges() {
    for (kind, scatter) in [("CHEXA", 0.0), ("CPENTA", 0.0), ("CTETRA", 0.2)] {
        let error = error(kind, scatter, |_| true, bent);
        assert!(error < 1e-12, "{kind}: {error:e}");
        // In the middle of an element the stress is the curvature times E y.
        let (solids, grids) = patch(kind, scatter, |_| true);
        let u = DVector::from_iterator(3 * grids.len(), grids.iter().flat_map(|p| <[f64; 3]>::from(bent(p))));
        let own = DVector::from_iterator(
            3 * solids[0].nodes().len(),
            solids[0].nodes().iter().flat_map(|node| [0, 1, 2].map(|axis| u[3 * node + axis])),
        );
        let (corners, at) = match kind {
            "CHEXA" => (8, [0.0; 3]),
            "CPENTA" => (6, [1.0 / 3.0, 1.0 / 3.0, 0.0]),
            _ => (4, [0.25; 3]),
        };
        let y = solids[0].nodes()[..corners].iter().map(|node| grids[*node].y).sum::<f64>() / corners as f64;
        let stress = solids[0].stress(&own, at);
        close(stress[0], 1e6 * 1e-3 * y, 1e-10, "stress along the beam");
        assert!(stress[1..].iter().all(|other| other.abs() < 1e-7), "{kind}: no other stress: {stress:?}");
    }
}

#[test]
fn solids_with_grids_on_edges_keep_the_contract() {
    let lean = Matrix3::new(1.3, 0.2, 0.1, -0.1, 0.8, 0.3, 0.2, 0.0, 0.6);
    let unit = |kind: &str| corners(kind, [0, 0, 0]).swap_remove(0);
    for (kind, edges, share) in [("CHEXA", HEXA, 1.0), ("CPENTA", WEDGE, 0.5), ("CTETRA", TETRA, 1.0 / 6.0)] {
        let own: Vec<_> = unit(kind).iter().map(|corner| lean * corner).collect();
        let middles = edges.iter().map(|[a, b]| (own[*a] + own[*b]) * 0.5);
        let points: Vec<Point3<f64>> = own.iter().copied().chain(middles).map(Point3::from).collect();
        let sides: Vec<usize> = (0..edges.len()).collect();
        contract(|rotation| {
            let turned: Vec<_> = points.iter().map(|point| rotation * point).collect();
            let nodes = (0..points.len()).collect();
            let element =
                QuadraticSolid::new(1, nodes, &turned, &sides, &material(), &Span::generated("test"));
            let element = element.expect("a solid");
            close(element.volume_m3(), share * lean.determinant(), 1e-12, "volume");
            let mass_kg = 3.0 * share * lean.determinant();
            Specimen { element, points: points.clone(), mass_kg, inertia: None }
        });
    }
}

/// An edge that is bent: six motions without energy still, and no more.
#[test]
fn a_bent_hexahedron_has_six_motions_without_energy_and_positive_lumped_masses() {
    let mut mesh = Mesh::new(|p| Vector3::new((2.0 + p.x) * p.y.cos(), (2.0 + p.x) * p.y.sin(), p.z));
    mesh.element("CHEXA", &corners("CHEXA", [0, 0, 0])[0], HEXA);
    let cards = "PSOLID,1,1\nMAT1,1,1.+6,,.25,3.\nSPC1,1,456,1,THRU,20\n";
    for form in ["", "PARAM,COUPMASS,-1\n"] {
        let bulk = parse_deck("test.bdf", &(mesh.deck(cards) + form)).expect("a deck");
        let model = Model::from_bulk(&bulk).expect("a model");
        let mass = MassProperties::of_model(&model).mass_kg;
        // A sector of a ring: one radian, radii 2 and 3; parabolas in the place of arcs leave two thousandths.
        close(mass, 3.0 * 0.5 * (9.0 - 4.0), 3e-3, "mass of a sector of a ring");
        let lumped = model.elements().next().and_then(Element::lumped_mass).expect("has mass");
        assert!(
            lumped.diagonal().iter().all(|own| *own >= 0.0),
            "no grid has a negative mass: {}",
            lumped.diagonal()
        );
        assert!(
            lumped.diagonal().rows(0, 24).iter().all(|own| *own == 0.0),
            "as in Nastran, corners have none"
        );
        close(lumped.trace(), 3.0 * mass, 1e-12, "lumped mass along three axes");
        let system = System::assemble(&model).expect("a system");
        let loose = structure::normal_modes(&system, 7).expect("modes").omega_rad_s;
        assert!(loose[5] < 1e-3 * loose[6], "six rigid motions and no more: {loose:?}");
    }
}

/// NAFEMS LE10: a quarter of a thick elliptic plate under a pressure of 1 MPa on its top; the stress along y at D (2, 0, top) is -5.38 MPa
/// (NAFEMS, *The Standard NAFEMS Benchmarks*, 1990).
#[test]
fn a_thick_elliptic_plate_has_the_stress_of_nafems_le10() {
    const CELLS: [usize; 3] = [6, 8, 4];
    // Parameters: from the inner to the outer ellipse, from the x axis to the y axis, through the thickness.
    let mut mesh = Mesh::new(|p| {
        let (sin, cos) = (p.y * std::f64::consts::FRAC_PI_2).sin_cos();
        // Finer towards the inner edge.
        let x = 0.5 * p.x * (1.0 + p.x);
        Vector3::new((2.0 + 1.25 * x) * cos, (1.0 + 1.75 * x) * sin, 0.6 * p.z)
    });
    let mut loads = String::new();
    for k in 0..CELLS[2] {
        for j in 0..CELLS[1] {
            for i in 0..CELLS[0] {
                let at = |x: usize, y: usize, z: usize| {
                    let [nx, ny, nz] = CELLS.map(|count| count as f64);
                    Vector3::new((i + x) as f64 / nx, (j + y) as f64 / ny, (k + z) as f64 / nz)
                };
                let lower = [at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)];
                let own = [&lower[..], &[at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)]].concat();
                let id = mesh.element("CHEXA", &own, HEXA);
                if k + 1 == CELLS[2] {
                    let [one, other] = [mesh.grid(own[4]), mesh.grid(own[6])];
                    writeln!(loads, "PLOAD4,2,{id},1.+6,,,,{one},{other}").expect("a string");
                }
            }
        }
    }
    mesh.hold("2", |p, _| p.y == 0.0);
    mesh.hold("1", |p, _| p.y == 1.0);
    mesh.hold("12", |p, _| p.x == 1.0);
    mesh.hold("3", |p, _| p.x == 1.0 && p.z == 0.5);
    let d = mesh.grid(Vector3::new(0.0, 0.0, 1.0));
    let deck = mesh.deck(&format!("PSOLID,1,1\nMAT1,1,2.1+11,,.3\n{loads}"));
    let bulk = parse_deck("le10.bdf", &deck).expect("a deck");
    let system = System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a system");
    let forces = system.forces_of(&loads_of(&bulk, 2).expect("loads"));
    let total: f64 = (0..system.node_count()).map(|node| forces[(6 * node + 2, 0)]).sum();
    let area = std::f64::consts::PI / 4.0 * (3.25 * 2.75 - 2.0);
    close(total, -1e6 * area, 1e-4, "the pressure's force");
    let flexibility = structure::Flexibility::new(&system).expect("stiff");
    let u = system.expand(flexibility.displacements(system.reduce(forces.as_ref()).as_ref()).as_ref());
    let card = bulk
        .solids
        .values()
        .find(|solid| solid.grids[4] == d)
        .expect("the element at D begins its upper face there");
    let grids: Vec<u32> = card.grids.iter().copied().chain(card.midsides.iter().flatten().copied()).collect();
    let nodes: Vec<usize> = grids.iter().map(|grid| system.node_index(*grid).expect("is there")).collect();
    let points: Vec<Point3<f64>> = nodes.iter().map(|node| system.points()[*node]).collect();
    let steel = Arc::new(SolidMaterial::from_mat1(&bulk.materials[&1]).expect("sound"));
    let own = DVector::from_iterator(
        60,
        nodes.iter().flat_map(|node| [0, 1, 2].map(|axis| u[(6 * node + axis, 0)])),
    );
    let sides: Vec<usize> = (0..12).collect();
    let element = QuadraticSolid::new(1, nodes, &points, &sides, &steel, &Span::generated("test"));
    let element = element.expect("a solid");
    let stress = element.stress(&own, [-1.0, -1.0, 1.0])[1];
    close(stress, -5.38e6, 0.02, "stress along y at D");
}

#[test]
fn a_flat_or_turned_solid_with_grids_on_edges_is_refused_by_a_sentence() {
    let grids = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\nGRID,4,,0.,0.,1.\nGRID,5,,.5,0.,0.\n\
                 GRID,6,,1.4,.1,.1\nMAT1,1,1.,,.3\nPSOLID,1,1\n";
    let refused = |card: &str| {
        let bulk = parse_deck("test.bdf", &format!("{grids}{card}")).expect("a deck");
        Model::from_bulk(&bulk).expect_err("no solid").to_string()
    };
    let twice = refused("CTETRA,1,1,1,2,3,4,5\n,5\n");
    assert!(twice.contains("CTETRA 1: two of its grids are the same"), "{twice}");
    let far = refused("CTETRA,1,1,1,2,3,4,6\n");
    assert!(far.contains("CTETRA 1: it is turned inside out in a part of it"), "{far}");
    assert!(
        displaced(&system(&format!("{grids}CTETRA,1,1,1,2,3,4,5\nSPC1,1,123,1,2,3,5\n")), &[(4, 1, 1.0)])
            [(18, 0)]
            > 0.0
    );
}
