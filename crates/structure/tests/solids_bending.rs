//! Bending by single slender elements, beside the exact field of elasticity.
//!
//! A bar under sigma_xx = E z only has u = x z, v = -nu y z, w = -x^2/2 + nu (y^2 - z^2)/2 (Timoshenko and Goodier,
//! *Theory of Elasticity*, section 102). An element displaced so at its corners must need the tractions' consistent
//! corner forces, whatever its slenderness, and report that stress.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use nalgebra::{DVector, Point3, Rotation3, Vector3};
use nastran::{Mat1, Span};
use std::sync::Arc;
use structure::{Element, Solid, SolidMaterial};

const E: f64 = 70e9;
const NU: f64 = 0.3;

fn material() -> Arc<SolidMaterial> {
    let card = Mat1 {
        id: 1,
        e: E,
        g: 0.0,
        nu: NU,
        rho: 0.0,
        expansion: nastran::Expansion::default(),
        span: Span::generated("test"),
    };
    Arc::new(SolidMaterial::from_mat1(&card).unwrap())
}

fn bent(p: &Vector3<f64>) -> Vector3<f64> {
    bent_axis(p) + Vector3::new(0.0, -NU * p.y * p.z, 0.5 * NU * (p.y * p.y - p.z * p.z))
}

/// Without the part within the section, whose mean strain is zero for an origin in the centroid.
fn bent_axis(p: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(p.x * p.z, 0.0, -0.5 * p.x * p.x)
}

/// Displaces the corners by the exact field, turned into an attitude, and compares forces and stresses.
fn bends_exactly(
    bent: impl Fn(&Vector3<f64>) -> Vector3<f64>,
    corners: &[Vector3<f64>],
    force_x: &[f64],
    stations: &[([f64; 3], f64)],
) {
    for rotation in [Rotation3::identity(), Rotation3::from_euler_angles(0.7, -0.4, 2.0)] {
        let points: Vec<_> = corners.iter().map(|corner| Point3::from(rotation * corner)).collect();
        let nodes = (0..points.len()).collect();
        let solid = Solid::new(1, nodes, &points, &material(), &Span::generated("test")).unwrap();
        let mut u = DVector::zeros(3 * corners.len());
        let mut expected = u.clone();
        for (i, corner) in corners.iter().enumerate() {
            u.fixed_rows_mut::<3>(3 * i).copy_from(&(rotation * bent(corner)));
            expected.fixed_rows_mut::<3>(3 * i).copy_from(&(rotation * Vector3::x() * force_x[i]));
        }
        let k = solid.stiffness().unwrap();
        let error = (k.as_ref() * &u - &expected).amax() / expected.amax();
        assert!(error < 1e-8, "corner forces off by {error:e}");
        for (at, z) in stations {
            let s = solid.stress(&u, *at);
            let tensor = nalgebra::Matrix3::new(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]);
            let own = rotation.matrix().transpose() * tensor * rotation.matrix();
            let exact = nalgebra::Matrix3::from_diagonal(&Vector3::new(E * z, 0.0, 0.0));
            let largest = E * corners.iter().map(|corner| corner.z.abs()).fold(0.0, f64::max);
            assert!((own - exact).amax() < 1e-8 * largest, "{own} {exact}");
        }
    }
}

/// PSOLID with IN = THREE and ISOP = FULL is the standard trilinear element. Displaced as in bending its corners give shear x beside
/// E z, so without Poisson's ratio it is 1 + (L/h)^2 / 2 times too stiff (G = E/2: the energies are E h^2 and G L^2, over twelve).
#[test]
fn the_standard_element_of_psolid_is_too_stiff_in_bending_by_its_slenderness() {
    let stiffness = |psolid: &str, length: f64| {
        let deck = format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,{length:?},0.,0.\nGRID,3,,{length:?},1.,0.\nGRID,4,,0.,1.,0.\n\
             GRID,5,,0.,0.,1.\nGRID,6,,{length:?},0.,1.\nGRID,7,,{length:?},1.,1.\nGRID,8,,0.,1.,1.\n\
             CHEXA,1,1,1,2,3,4,5,6\n,7,8\n{psolid}\nMAT1,1,1.,,0.\n"
        );
        let bulk = nastran::parse_deck("box.bdf", &deck).unwrap();
        let model = structure::Model::from_deck(&bulk, None).unwrap();
        let element = model.elements().next().unwrap();
        // opposite rotations of the ends about y
        let turned = |i: usize| {
            let (x, z) = ([-1.0, 1.0, 1.0, -1.0][i % 4], if i < 4 { -0.5 } else { 0.5 });
            [x * z, 0.0, 0.0]
        };
        let u = DVector::from_iterator(24, (0..8).flat_map(turned));
        (u.transpose() * element.stiffness().unwrap().as_ref() * &u)[(0, 0)]
    };
    for length in [0.5, 1.0, 4.0] {
        let exact = stiffness("PSOLID,1,1", length);
        let expected = 1.0 + 0.5 * length * length;
        for standard in ["PSOLID,1,1,,3,,1", "PSOLID,1,1,,TWO,,FULL"] {
            let ratio = stiffness(standard, length) / exact;
            assert!(
                (ratio - expected).abs() < 1e-9 * expected,
                "{standard}, {length}: {ratio} for {expected}"
            );
        }
        assert!((stiffness("PSOLID,1,1,,3", length) - exact).abs() < 1e-12 * exact, "reduced shear");
    }
}

#[test]
fn a_box_bends_exactly_at_any_slenderness() {
    for length in [0.5, 20.0, 50.0, 200.0] {
        let (half_x, half_y, half_z) = (0.5 * length, 0.4, 0.5);
        let sign = [
            [-1, -1, -1],
            [1, -1, -1],
            [1, 1, -1],
            [-1, 1, -1],
            [-1, -1, 1],
            [1, -1, 1],
            [1, 1, 1],
            [-1, 1, 1],
        ];
        let corners: Vec<_> = sign
            .iter()
            .map(|s| {
                Vector3::new(f64::from(s[0]) * half_x, f64::from(s[1]) * half_y, f64::from(s[2]) * half_z)
            })
            .collect();
        // int N E z over the end face
        let force: Vec<_> =
            sign.iter().map(|s| E * f64::from(s[0] * s[2]) * half_y * half_z * half_z / 3.0).collect();
        bends_exactly(bent, &corners, &force, &[([0.0; 3], 0.0), ([0.3, -0.6, 0.8], 0.8 * half_z)]);
    }
}

/// The corners of a triangle cannot follow the section's quadratic displacements, the modes supply their strains: the
/// element is exact with the section's corners left in place.
#[test]
fn a_long_prism_bends_along_its_axis_exactly() {
    for length in [1.0, 50.0] {
        let section = [[-0.4, -0.3], [0.5, -0.1], [-0.1, 0.4]]; // y, z; the centroid is the origin
        let mut corners = Vec::new();
        let mut force = Vec::new();
        let area = 0.5 * ((0.9 * 0.7) - (0.2 * 0.3_f64));
        for x in [-0.5_f64 * length, 0.5 * length] {
            for [y, z] in section {
                corners.push(Vector3::new(x, y, z));
                // int N_i z over a triangle = A/12 (sum of z + z_i), and the sum is zero
                force.push(x.signum() * E * area / 12.0 * z);
            }
        }
        let middle = [1.0 / 3.0, 1.0 / 3.0, 0.0];
        bends_exactly(bent_axis, &corners, &force, &[(middle, 0.0), ([0.0, 1.0, 0.7], 0.4)]);
    }
}
