//! A generated mesh measured by its cards alone: places, areas, volumes and masses.

#![allow(dead_code, reason = "each test binary uses its share")]

use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{BulkData, ShellElement, SolidElement};

pub(crate) fn point(bulk: &BulkData, id: u32) -> Point3<f64> {
    Point3::from(bulk.grids[&id].xyz)
}

/// Half the cross product of the diagonals: area times normal, warped or not.
pub(crate) fn area_vector(bulk: &BulkData, shell: &ShellElement) -> Vector3<f64> {
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| point(bulk, shell.grids[corner]));
    0.5 * (c - a).cross(&(d - b))
}

pub(crate) fn centre(bulk: &BulkData, grids: &[u32]) -> Point3<f64> {
    let sum: Vector3<f64> = grids.iter().map(|&id| point(bulk, id).coords).sum();
    Point3::from(sum / grids.len() as f64)
}

/// Corners of the reference cube in the order of a CHEXA's grids.
const CUBE: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Determinant of the trilinear map from the cube of side 2.
pub(crate) fn jacobian(bulk: &BulkData, solid: &SolidElement, at: [f64; 3]) -> f64 {
    let mut map = Matrix3::zeros();
    for (corner, &grid) in CUBE.iter().zip(&solid.grids) {
        let factor = [0, 1, 2].map(|axis| 1.0 + corner[axis] * at[axis]);
        let slope = Vector3::new(
            corner[0] * factor[1] * factor[2],
            corner[1] * factor[0] * factor[2],
            corner[2] * factor[0] * factor[1],
        );
        map += point(bulk, grid).coords * slope.transpose() / 8.0;
    }
    map.determinant()
}

pub(crate) fn corner_jacobians(bulk: &BulkData, solid: &SolidElement) -> [f64; 8] {
    CUBE.map(|corner| jacobian(bulk, solid, corner))
}

/// By two Gauss points in each direction, exact for the trilinear map's quadratic determinant.
pub(crate) fn volume(bulk: &BulkData, solid: &SolidElement) -> f64 {
    CUBE.iter().map(|corner| jacobian(bulk, solid, corner.map(|at| at / 3.0_f64.sqrt()))).sum()
}

/// Mass per area of a laminate, its plies' and the non-structural.
pub(crate) fn mass_kg_m2(bulk: &BulkData, property: u32) -> f64 {
    let laminate = &bulk.laminates[&property];
    let plies: f64 =
        laminate.plies.iter().map(|ply| ply.thickness * bulk.ply_materials[&ply.material].rho).sum();
    plies + laminate.nsm
}

/// Every piece of mass with its centre.
pub(crate) fn masses(bulk: &BulkData) -> Vec<(f64, Point3<f64>)> {
    let shells = bulk.shells.values().map(|shell| {
        (area_vector(bulk, shell).norm() * mass_kg_m2(bulk, shell.property), centre(bulk, &shell.grids))
    });
    let solids = bulk.solids.values().map(|solid| {
        let rho = bulk.materials[&bulk.solid_properties[&solid.property].material].rho;
        (volume(bulk, solid) * rho, centre(bulk, &solid.grids))
    });
    let points =
        bulk.masses.values().map(|mass| (mass.mass, point(bulk, mass.grid) + Vector3::from(mass.offset)));
    shells.chain(solids).chain(points).collect()
}
