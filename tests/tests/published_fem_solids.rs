//! Solid elements beside published and exact results (data/published/fem*.json): MacNeal and Harder's standard set
//! (*A proposed standard set of problems to test finite element accuracy*, FE Anal. Design 1 (1985) 3-20), Lame's
//! thick cylinder.
//!
//! Each case at its own tolerance and mesh; where the case only asks for a record, the record is printed.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

mod solid_mesh;

use nalgebra::{Point3, Vector3};
use nastran::{Mat1, Span};
use serde_json::Value;
use solid_mesh::{HEXA, SolidMesh, node, nodes};
use std::sync::Arc;
use structure::SolidMaterial;
use validation::{assert_close, list, number, numbers, published};

fn isotropic(e: f64, nu: f64) -> Arc<SolidMaterial> {
    let card = Mat1 { id: 1, e, g: 0.0, nu, rho: 0.0, span: Span::generated("test") };
    Arc::new(SolidMaterial::from_mat1(&card).unwrap())
}

fn material_of(case: &Value) -> Arc<SolidMaterial> {
    isotropic(number(&case["inputs"]["E"]), number(&case["inputs"]["nu"]))
}

/// Seven hexahedra: an irregular one in the middle of a cube, one between each of its faces and the cube's.
#[test]
fn macneal_and_harder_solid_patch() {
    let case = published("fem__patch_solid");
    let outer = HEXA.map(|corner| Point3::from(corner.map(|at| at as f64)));
    let inner = list(&case["inputs"]["inner"]).iter().map(|p| Point3::from_slice(&numbers(p)));
    let points: Vec<_> = outer.into_iter().chain(inner).collect();
    let material = material_of(&case);
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
    for dof in 24..48 {
        assert_close("displacement", u[dof], field(&mesh.points[dof / 3])[dof % 3], rel, 0.0);
    }
    let [normal, shear] = ["sigma_normal", "tau"].map(|name| number(&case["expected"][name]));
    for element in 0..7 {
        for at in [[0.0; 3], [-0.9, 0.5, 0.3], [1.0, 1.0, -1.0]] {
            let stress = mesh.stress(element, &u, at);
            for (got, want) in stress.iter().zip([normal, normal, normal, shear, shear, shear]) {
                assert_close(&format!("stress of element {element}"), *got, want, rel, 0.0);
            }
        }
    }
}

/// The radii of MacNeal and Harder's mesh, ten degrees an element around, a quarter of the ring in plane strain.
/// The case gives a tolerance for nu = 0.49 and asks for a record of the locking at 0.4999.
#[test]
fn thick_cylinder_hardly_compressible() {
    let case = published("fem__thick_cylinder");
    let radii = [3.0, 3.5, 4.2, 5.2, 6.75, 9.0];
    let cells = [5, 9, 1];
    for (name, want) in case["expected"]["u_r_at_a"].as_object().unwrap() {
        let material = isotropic(number(&case["inputs"]["E"]), name.parse().unwrap());
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
        let want = number(want);
        println!("nu = {name}: {got:.6e}, exact {want:.6e}, ratio {:.4}", got / want);
        assert_close(&format!("radial displacement, nu = {name}"), got, want, 0.02, 0.0);
    }
}
