//! What quadrilateral and triangle have in common: sums over integration points, the condensed incompatible modes.

use super::residual::Residual;
use super::strains::ShellStrains;
use crate::laminate::ShellSection;
use nalgebra::{DMatrix, Matrix3, Matrix4, Matrix6, RowSVector, SMatrix, SVector};

/// Strain operators at one point, D = 6 motions a node.
pub(super) struct Point<const D: usize> {
    /// Area it stands for, m^2 (weight times Jacobian).
    pub(super) area_m2: f64,
    /// Thickness here, in units of the section's.
    pub(super) thickness: f64,
    /// Shape functions of the nodes.
    pub(super) shape: Vec<f64>,
    pub(super) membrane: SMatrix<f64, 3, D>,
    pub(super) bending: SMatrix<f64, 3, D>,
    pub(super) shear: SMatrix<f64, 2, D>,
    /// Rotation about the normal less the membrane's own, (v,x - u,y) / 2.
    pub(super) drilling: RowSVector<f64, D>,
    /// Membrane strains of the four incompatible modes; zero if there are none.
    pub(super) modes: SMatrix<f64, 3, 4>,
    /// Their part in `drilling`.
    pub(super) mode_drilling: RowSVector<f64, 4>,
}

/// Stiffness before condensation: motions, motions by modes, modes.
struct Parts<const D: usize> {
    uu: SMatrix<f64, D, D>,
    ua: SMatrix<f64, D, 4>,
    aa: Matrix4<f64>,
}

fn parts<const D: usize>(
    points: &[Point<D>],
    section: &ShellSection,
    residual: Option<Residual>,
    drilling: f64,
) -> Parts<D> {
    // Without residual flexibility the whole shear is one.
    let area: f64 = points.iter().map(|point| point.area_m2).sum();
    let mean_shear = match residual {
        Some(_) => points.iter().map(|point| point.shear * (point.area_m2 / area)).sum(),
        None => SMatrix::<f64, 2, D>::zeros(),
    };
    let mut sum = Parts { uu: SMatrix::zeros(), ua: SMatrix::zeros(), aa: Matrix4::zeros() };
    for point in points {
        let da = point.area_m2;
        let section = section.thickened(point.thickness);
        let (a, b, d) = (&section.membrane, &section.coupling, &section.bending);
        let turn = drilling * turned(&section);
        let (m, k) = (&point.membrane, &point.bending);
        let force = (a * m + b * k) * da;
        let moment = (b * m + d * k) * da;
        sum.uu += m.transpose() * force + k.transpose() * moment;
        let [uniform, varying] =
            residual.map_or([section.shear; 2], |residual| residual.stiffness(&section, point.thickness));
        let rest = point.shear - mean_shear;
        sum.uu += mean_shear.transpose() * (uniform * mean_shear) * da;
        sum.uu += rest.transpose() * (varying * rest) * da;
        sum.uu += point.drilling.transpose() * point.drilling * (turn * da);
        sum.ua += force.transpose() * point.modes;
        sum.ua += point.drilling.transpose() * point.mode_drilling * (turn * da);
        sum.aa += point.modes.transpose() * (a * point.modes) * da;
        sum.aa += point.mode_drilling.transpose() * point.mode_drilling * (turn * da);
    }
    sum
}

/// What stiffness of rotations about the normal is measured in: the membrane's shear stiffness, or a thousandth of that across a shell without
/// a membrane.
fn turned(section: &ShellSection) -> f64 {
    section.membrane[(2, 2)].max(section.shear[(0, 0)] * 1e-3)
}

/// The part of rotations about the normal that [`stiffness`] has, alone.
pub(super) fn tie_stiffness<const D: usize>(
    points: &[Point<D>],
    section: &ShellSection,
    drilling: f64,
) -> SMatrix<f64, D, D> {
    let of_point = |point: &Point<D>| {
        let turn = drilling * turned(&section.thickened(point.thickness));
        point.drilling.transpose() * point.drilling * (turn * point.area_m2)
    };
    points.iter().map(of_point).sum()
}

/// Stiffness, the modes condensed.
pub(super) fn stiffness<const D: usize>(
    points: &[Point<D>],
    section: &ShellSection,
    residual: Option<Residual>,
    drilling: f64,
) -> SMatrix<f64, D, D> {
    let Parts { uu, ua, aa } = parts(points, section, residual, drilling);
    aa.cholesky().map_or(uu, |factor| uu - ua * factor.solve(&ua.transpose()))
}

/// Amplitudes of the incompatible modes under local motions `u`.
pub(super) fn modes_of<const D: usize>(
    points: &[Point<D>],
    section: &ShellSection,
    drilling: f64,
    u: &SVector<f64, D>,
) -> SVector<f64, 4> {
    let Parts { ua, aa, .. } = parts(points, section, None, drilling);
    aa.cholesky().map_or_else(SVector::zeros, |factor| -factor.solve(&(ua.transpose() * u)))
}

pub(super) fn strains_at<const D: usize>(
    point: &Point<D>,
    u: &SVector<f64, D>,
    modes: &SVector<f64, 4>,
) -> ShellStrains {
    let membrane = point.membrane * u + point.modes * modes;
    let curvature = point.bending * u;
    let shear = point.shear * u;
    ShellStrains { membrane: membrane.into(), curvature: curvature.into(), shear: shear.into() }
}

/// Consistent mass: the kinetic energy of the velocities u + z ry, v - z rx, w.
pub(super) fn mass<const D: usize>(points: &[Point<D>], section: &ShellSection) -> SMatrix<f64, D, D> {
    let mut sum = SMatrix::<f64, D, D>::zeros();
    for point in points {
        let section = section.thickened(point.thickness);
        let (m, first, second) = (section.mass_kg_m2, section.mass_moment_kg_m, section.mass_inertia_kg);
        for (i, left) in point.shape.iter().enumerate() {
            for (j, right) in point.shape.iter().enumerate() {
                let share = left * right * point.area_m2;
                let (i, j) = (6 * i, 6 * j);
                for axis in 0..3 {
                    sum[(i + axis, j + axis)] += share * m;
                }
                for (row, column, value) in [
                    (0, 4, first),
                    (4, 0, first),
                    (1, 3, -first),
                    (3, 1, -first),
                    (3, 3, second),
                    (4, 4, second),
                ] {
                    sum[(i + row, j + column)] += share * value;
                }
            }
        }
    }
    sum
}

/// As [`mass`] with all of it at the grids: the shape functions add to one, so that the sum of a displacement's row is the integral of its own.
pub(super) fn lumped_mass<const D: usize>(points: &[Point<D>], section: &ShellSection) -> DMatrix<f64> {
    let mut sum = DMatrix::zeros(D, D);
    for point in points {
        let mass_kg = section.thickened(point.thickness).mass_kg_m2 * point.area_m2;
        for (i, share) in point.shape.iter().enumerate() {
            (6 * i..6 * i + 3).for_each(|at| sum[(at, at)] += share * mass_kg);
        }
    }
    sum
}

/// Mass of an area of one between two grids of a curved shell, over their six motions in basic axes: the kinetic energy of the velocities u + (offset
/// + z) (t x n), where `left` and `right` turn t into t x n.
pub(super) fn mass_of(
    section: &ShellSection,
    left: &Matrix3<f64>,
    right: &Matrix3<f64>,
    offset_m: f64,
) -> Matrix6<f64> {
    let m = section.mass_kg_m2;
    let first = section.mass_moment_kg_m + m * offset_m;
    let second = section.mass_inertia_kg + (first + section.mass_moment_kg_m) * offset_m;
    let mut block = Matrix6::zeros();
    block.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(m);
    block.fixed_view_mut::<3, 3>(0, 3).copy_from(&(right * first));
    block.fixed_view_mut::<3, 3>(3, 0).copy_from(&(left.transpose() * first));
    block.fixed_view_mut::<3, 3>(3, 3).copy_from(&(left.transpose() * right * second));
    block
}
