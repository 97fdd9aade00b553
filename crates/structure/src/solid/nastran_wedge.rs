//! The stiffness of Nastran's CPENTA with six corners, as Simcenter Nastran 8.5 and MSC Nastran 2005 print the forces of single ones (to six digits;
//! right prisms of an isotropic material, other shapes by the same formulas).
//!
//! Local axes: z along the normal of the triangle half-way between the two, x along its first side.
//!
//! - xx, yy, zz and xy: isoparametric at three by two points, with three incompatible modes: L1 L2 + L2 L3 + L3 L1 of the displacements along x and along y,
//!   1 - z^2 of that along z.
//! - zx and yz: constant along the prism. Along the sides of the middle triangle (unit tangents t) they are e = t . g + r, a constant shear and a
//!   part that goes round; the energy is the mean of that of g + r t over the sides.

use super::penta::{Penta, TRIANGLE_2, prism};
use super::shape::{Shape as _, gauss_2, strain_transformation};
use nalgebra::{DMatrix, Matrix2, Matrix3, Matrix4, Matrix6, RowVector3, SMatrix, Vector2, Vector3};

/// The three displacements of six corners and the three modes.
const ALL: usize = 21;

/// Of corners and a material in basic axes; nothing of a material that couples the shears across with other strains, and of a prism without room.
pub(super) fn stiffness(corners: &SMatrix<f64, 3, 8>, material: &Matrix6<f64>) -> Option<DMatrix<f64>> {
    let middle = [0, 1, 2].map(|i| 0.5 * (corners.column(i) + corners.column(i + 3)));
    let (x, other) = ((middle[1] - middle[0]).normalize(), middle[2] - middle[0]);
    let z = x.cross(&other).try_normalize(f64::EPSILON * other.norm())?;
    let axes = Matrix3::from_rows(&[x.transpose(), z.cross(&x).transpose(), z.transpose()]);
    let turn = strain_transformation(&axes.transpose());
    let elastic = turn.transpose() * material * turn;
    let coupled = elastic.fixed_view::<4, 2>(0, 4).amax();
    if coupled > 1e-9 * elastic.amax() {
        return None;
    }
    let wedge = Wedge { corners: axes * corners, elastic };
    let (in_plane, volume) = wedge.in_plane()?;
    let k = in_plane + wedge.across(&middle.map(|point| axes * point))? * volume;
    let mut turned = DMatrix::zeros(18, 18);
    for (i, j) in (0..36).map(|at| (3 * (at / 6), 3 * (at % 6))) {
        let block = axes.transpose() * k.fixed_view::<3, 3>(i, j) * axes;
        turned.view_mut((i, j), (3, 3)).copy_from(&block);
    }
    Some(turned)
}

/// In local axes.
struct Wedge {
    corners: SMatrix<f64, 3, 8>,
    elastic: Matrix6<f64>,
}

impl Wedge {
    /// Transposed inverse of the Jacobian, its determinant.
    fn inverse(&self, at: [f64; 3]) -> Option<(Matrix3<f64>, f64)> {
        let jacobian = self.corners * Penta.gradients(at).transpose();
        Some((jacobian.try_inverse()?.transpose(), jacobian.determinant()))
    }

    /// Of the strains xx, yy, zz, xy, the modes condensed; and the volume.
    fn in_plane(&self) -> Option<(SMatrix<f64, 18, 18>, f64)> {
        let mut k = SMatrix::<f64, ALL, ALL>::zeros();
        let mut volume = 0.0;
        let elastic: Matrix4<f64> = self.elastic.fixed_view::<4, 4>(0, 0).into();
        let (inverse_middle, middle) = self.inverse(Penta.middle())?;
        for point in prism(&TRIANGLE_2.map(|(r, s)| (r, s, 1.0 / 6.0)), &gauss_2()) {
            let (inverse, determinant) = self.inverse(point.at)?;
            let slopes = inverse * Penta.gradients(point.at);
            let [r, s, z] = point.at;
            let first = 1.0 - r - s;
            let of_mode = |local: Vector3<f64>| inverse_middle * local * (middle / determinant);
            let bubble = of_mode(Vector3::new(first - r, first - s, 0.0));
            let along = of_mode(Vector3::new(0.0, 0.0, -2.0 * z));
            let mut strains = SMatrix::<f64, 4, ALL>::zeros();
            let mut write = |column: usize, axis: usize, slope: &Vector3<f64>| {
                strains[(axis, column)] = slope[axis];
                if axis < 2 {
                    strains[(3, column)] = slope[1 - axis];
                }
            };
            for node in 0..6 {
                (0..3).for_each(|axis| write(3 * node + axis, axis, &slopes.column(node).into_owned()));
            }
            write(18, 0, &bubble);
            write(19, 1, &bubble);
            write(20, 2, &along);
            let weight = point.weight * determinant.abs();
            k += strains.transpose() * elastic * strains * weight;
            volume += weight;
        }
        let modes: Matrix3<f64> = k.fixed_view::<3, 3>(18, 18).into();
        let across: SMatrix<f64, 3, 18> = k.fixed_view::<3, 18>(18, 0).into();
        let own: SMatrix<f64, 18, 18> = k.fixed_view::<18, 18>(0, 0).into();
        Some((own - across.transpose() * modes.cholesky()?.solve(&across), volume))
    }

    /// Of the strains zx and yz, per volume.
    fn across(&self, middle: &[Vector3<f64>; 3]) -> Option<SMatrix<f64, 18, 18>> {
        let places = [[0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.5, 0.0]];
        let (mut shears, mut constants) = (SMatrix::<f64, 3, 18>::zeros(), Matrix3::zeros());
        let mut energy = Matrix3::zeros();
        let e = &self.elastic;
        let g = Matrix2::new(e[(5, 5)], e[(5, 4)], e[(4, 5)], e[(4, 4)]);
        for (side, at) in places.into_iter().enumerate() {
            let along: Vector2<f64> = (middle[(side + 1) % 3] - middle[side]).xy().normalize();
            let slopes = self.inverse(at)?.0 * Penta.gradients(at);
            for node in 0..6 {
                shears[(side, 3 * node)] = along.x * slopes[(2, node)];
                shears[(side, 3 * node + 1)] = along.y * slopes[(2, node)];
                shears[(side, 3 * node + 2)] = along.x * slopes[(0, node)] + along.y * slopes[(1, node)];
            }
            constants.set_row(side, &RowVector3::new(along.x, along.y, 1.0));
            let of_side = SMatrix::<f64, 2, 3>::new(1.0, 0.0, along.x, 0.0, 1.0, along.y);
            energy += of_side.transpose() * g * of_side / 3.0;
        }
        let parts = constants.try_inverse()? * shears;
        Some(parts.transpose() * energy * parts)
    }
}
