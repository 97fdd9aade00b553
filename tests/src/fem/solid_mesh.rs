//! Blocks of hexahedra, assembled and solved for the tests of solids: three displacements a node, sparse Cholesky.

#![expect(
    clippy::missing_panics_doc,
    reason = "a case that cannot be solved is the case's own fault; the registry turns the panic into words"
)]

use faer::Mat;
use faer::prelude::Solve;
use faer::sparse::{SparseColMat, Triplet};
use nalgebra::{DVector, Point3, Vector3};
use nastran::Span;
use std::sync::Arc;
use structure::{Element, Solid, SolidMaterial};

/// A mesh of solids; degree of freedom 3 * node + axis.
pub struct SolidMesh {
    /// Places of the nodes.
    pub points: Vec<Point3<f64>>,
    /// The elements.
    pub solids: Vec<Solid>,
}

/// Nodes along the three directions of a block.
pub type Counts = [usize; 3];

/// Node of a block of `cells` cells.
pub fn node(cells: Counts, [i, j, k]: [usize; 3]) -> usize {
    (k * (cells[1] + 1) + j) * (cells[0] + 1) + i
}

/// All nodes of a block that `keep` wants, by their places in it.
pub fn nodes(cells: Counts, keep: impl Fn([usize; 3]) -> bool) -> Vec<usize> {
    let all =
        (0..=cells[2]).flat_map(|k| (0..=cells[1]).flat_map(move |j| (0..=cells[0]).map(move |i| [i, j, k])));
    all.filter(|at| keep(*at)).map(|at| node(cells, at)).collect()
}

impl SolidMesh {
    /// From the elements' nodes and materials.
    pub fn new(points: Vec<Point3<f64>>, elements: &[(Vec<usize>, Arc<SolidMaterial>)]) -> Self {
        let build = |(id, (nodes, material)): (u32, &(Vec<usize>, Arc<SolidMaterial>))| {
            let corners: Vec<_> = nodes.iter().map(|at| points[*at]).collect();
            Solid::new(id, nodes.clone(), &corners, material, &Span::generated("published case"))
                .expect("the case describes a possible element")
        };
        let solids = (1..).zip(elements).map(build).collect();
        Self { points, solids }
    }

    /// A block of hexahedra: `place` maps places in the block (0 to 1 along each direction) into space, `material`
    /// chooses by the layer (third direction).
    pub fn block(
        cells: Counts,
        place: impl Fn([usize; 3]) -> Point3<f64>,
        material: impl Fn(usize) -> Arc<SolidMaterial>,
    ) -> Self {
        let mut points = Vec::new();
        for k in 0..=cells[2] {
            for j in 0..=cells[1] {
                points.extend((0..=cells[0]).map(|i| place([i, j, k])));
            }
        }
        let mut elements = Vec::new();
        for k in 0..cells[2] {
            for j in 0..cells[1] {
                for i in 0..cells[0] {
                    let corner = |[a, b, c]: [usize; 3]| node(cells, [i + a, j + b, k + c]);
                    elements.push((HEXA.map(corner).to_vec(), material(k)));
                }
            }
        }
        Self::new(points, &elements)
    }

    /// Displacements under `loads` (degree of freedom, force) with `held` (degree of freedom, displacement).
    pub fn solve(&self, held: &[(usize, f64)], loads: &[(usize, f64)]) -> Vec<f64> {
        let n = 3 * self.points.len();
        let mut given = vec![None; n];
        for (dof, value) in held {
            given[*dof] = Some(*value);
        }
        let mut place = vec![usize::MAX; n];
        let free: Vec<usize> = (0..n).filter(|dof| given[*dof].is_none()).collect();
        for (at, dof) in free.iter().enumerate() {
            place[*dof] = at;
        }
        let mut load = vec![0.0; n];
        for (dof, value) in loads {
            load[*dof] += value;
        }
        let mut triplets = Vec::new();
        for solid in &self.solids {
            let k = solid.stiffness().expect("a solid has stiffness");
            let dofs: Vec<_> = solid.dofs().iter().map(|dof| dof / 6 * 3 + dof % 6).collect();
            for (j, column) in dofs.iter().enumerate() {
                for (i, row) in dofs.iter().enumerate().filter(|(_, row)| given[**row].is_none()) {
                    match given[*column] {
                        None => triplets.push(Triplet::new(place[*row], place[*column], k[(i, j)])),
                        Some(value) => load[*row] -= k[(i, j)] * value,
                    }
                }
            }
        }
        let k = SparseColMat::<usize, f64>::try_new_from_triplets(free.len(), free.len(), &triplets)
            .expect("rows and columns are below the number of motions");
        let rhs = Mat::from_fn(free.len(), 1, |i, _| load[free[i]]);
        let solution = k.sp_cholesky(faer::Side::Lower).expect("the block is held").solve(&rhs);
        (0..n).map(|dof| given[dof].unwrap_or_else(|| solution[(place[dof], 0)])).collect()
    }

    /// Stress of an element at local coordinates.
    pub fn stress(&self, element: usize, displacements: &[f64], at: [f64; 3]) -> [f64; 6] {
        let solid = &self.solids[element];
        let own = |i: usize, _| displacements[3 * solid.nodes()[i / 3] + i % 3];
        solid.stress(&DVector::from_fn(3 * solid.nodes().len(), own), at)
    }

    /// Forces at the four corners of a bilinear face under `traction` (a force per area by place).
    pub fn face_loads(
        &self,
        corners: [usize; 4],
        traction: impl Fn(&Point3<f64>, &Vector3<f64>) -> Vector3<f64>,
    ) -> Vec<(usize, f64)> {
        let mut loads = Vec::new();
        let line = [(-0.6_f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 9.0)];
        for (x, wx) in line {
            for (y, wy) in line {
                let signs = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let shape = signs.map(|(a, b)| 0.25 * (1.0 + a * x) * (1.0 + b * y));
                let sum = |weights: [f64; 4]| -> Vector3<f64> {
                    corners.iter().zip(weights).map(|(at, weight)| self.points[*at].coords * weight).sum()
                };
                let along_x = sum(signs.map(|(a, b)| 0.25 * a * (1.0 + b * y)));
                let along_y = sum(signs.map(|(a, b)| 0.25 * b * (1.0 + a * x)));
                let area = along_x.cross(&along_y);
                let force = traction(&Point3::from(sum(shape)), &area.normalize()) * area.norm() * wx * wy;
                for (at, n) in corners.iter().zip(shape) {
                    loads.extend((0..3).map(|axis| (3 * at + axis, n * force[axis])));
                }
            }
        }
        loads
    }
}

/// Places of a hexahedron's corners in a cell, in Nastran's order.
pub const HEXA: [[usize; 3]; 8] =
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
