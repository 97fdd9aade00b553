//! The structure as the air sees it: its flexibility at the degrees of freedom the spline uses.
//!
//! A spline touches few degrees of freedom (the s-set: those of the axis grids). With `F = Nᵀ K⁻¹ N` on that
//! set the steady elastic problem is exact, whatever the number of modes somebody keeps for dynamics:
//! `u_s = F Gᵀ P + K⁻¹ f_g` restricted to s.

use crate::error::CouplingError;
use crate::spline::Spline;
use faer::{Mat, MatRef};
use nalgebra::Point3;
use structure::{Flexibility, System};

/// Unit loads whose displacements of the whole structure are in memory at a time.
const TOGETHER: usize = 64;
/// Columns of loads that meet each entry of the spline side by side.
const COLUMNS: usize = 8;

/// A clamped structure reduced to the degrees of freedom that carry boxes.
#[derive(Debug, Clone)]
pub struct SupportedStructure {
    /// The s-set: g degrees of freedom used by the spline (and the tip's), ascending.
    pub s_dofs: Vec<usize>,
    /// F, s by s: displacement of the s-set per unit load on it, m and rad per N and N m.
    pub flexibility: Mat<f64>,
    /// s by 3: displacement of the s-set in a unit gravity field along x, y, z (K⁻¹ M r), per m/s².
    pub sag: Mat<f64>,
    /// 3 by 3: root loads (rows Fz, Mx, My) of the weight in a unit field along x, y, z, per m/s².
    pub weight: Mat<f64>,
    /// The spline's rows with columns renumbered to the s-set, two a box.
    pub spline_rows: Vec<Vec<(usize, f64)>>,
    /// Where the tip's z displacement stands in the s-set.
    pub tip_z: usize,
}

/// What rigid accelerations do to a held structure: unit accelerations along x, y, z and about them, about the balance
/// point, in this order.
#[derive(Debug, Clone)]
pub struct RigidInertia {
    /// s by 6: the motions themselves on the s-set, m and rad.
    pub motions: Mat<f64>,
    /// s by 6: K⁻¹ M r on the s-set; accelerating by a moves it by minus this times a.
    pub sag: Mat<f64>,
    /// 6 by 6: rᵀ M r, forces and moments that accelerate the whole, kg, kg m and kg m².
    pub mass: Mat<f64>,
    /// 6 by 6: (M r)ᵀ K⁻¹ M r, for inertia relief in mean axes.
    pub work: Mat<f64>,
}

impl SupportedStructure {
    /// Reduces a clamped system. `tip` is the index of the node whose height is reported.
    ///
    /// # Errors
    /// If the structure is not held (the grids that are free to move are named).
    pub fn new(
        system: &System,
        spline: &Spline,
        tip: usize,
        balance: &Point3<f64>,
    ) -> Result<Self, CouplingError> {
        Self::with_inertia(system, spline, tip, balance).map(|(structure, _)| structure)
    }

    /// As [`SupportedStructure::new`], and what all six rigid accelerations do to it.
    ///
    /// # Errors
    /// If the structure is not held (the grids that are free to move are named).
    pub fn with_inertia(
        system: &System,
        spline: &Spline,
        tip: usize,
        balance: &Point3<f64>,
    ) -> Result<(Self, RigidInertia), CouplingError> {
        let flexibility = Flexibility::new(system)?;
        let s_dofs = s_set(spline, tip);
        let displaced = |f_g: MatRef<'_, f64>| {
            system.expand(flexibility.displacements(system.reduce(f_g).as_ref()).as_ref())
        };
        let mut f = Mat::zeros(s_dofs.len(), s_dofs.len());
        for (group, dofs) in s_dofs.chunks(TOGETHER).enumerate() {
            let units = system.reduce_units(dofs);
            let answer = system.expand_at(flexibility.displacements(units.as_ref()).as_ref(), &s_dofs);
            f.as_mut().subcols_mut(group * TOGETHER, dofs.len()).copy_from(&answer);
        }
        let rigid = system.rigid_body(balance);
        let field = system.inertia_loads(rigid.as_ref());
        let sag_g = displaced(field.as_ref());
        let sag = restrict(sag_g.as_ref(), &s_dofs);
        let inertia = RigidInertia {
            mass: rigid.transpose() * &field,
            work: field.transpose() * &sag_g,
            motions: restrict(rigid.as_ref(), &s_dofs),
            sag: sag.clone(),
        };
        let weight = Mat::from_fn(3, 3, |row, column| {
            (0..field.nrows()).map(|dof| rigid[(dof, row + 2)] * field[(dof, column)]).sum()
        });
        let sag = sag.as_ref().subcols(0, 3).to_owned();
        Ok((Self::from_parts(s_dofs, symmetric(&f), sag, weight, spline, tip)?, inertia))
    }

    /// What takes long of [`SupportedStructure::with_inertia`], as matrices that [`SupportedStructure::of_matrices`] takes.
    pub fn matrices(&self, inertia: &RigidInertia) -> [Mat<f64>; 7] {
        let RigidInertia { motions, sag, mass, work } = inertia;
        [&self.flexibility, &self.sag, &self.weight, motions, sag, mass, work].map(Clone::clone)
    }

    /// From the matrices that [`SupportedStructure::matrices`] gave; `None` if they are not of this spline's s-set.
    pub fn of_matrices(matrices: Vec<Mat<f64>>, spline: &Spline, tip: usize) -> Option<(Self, RigidInertia)> {
        let s_dofs = s_set(spline, tip);
        let s = s_dofs.len();
        let sizes = [(s, s), (s, 3), (3, 3), (s, 6), (s, 6), (6, 6), (6, 6)];
        let [flexibility, sag_of_weight, weight, motions, sag, mass, work]: [Mat<f64>; 7] =
            matrices.try_into().ok()?;
        let all = [&flexibility, &sag_of_weight, &weight, &motions, &sag, &mass, &work];
        if all.map(|matrix| (matrix.nrows(), matrix.ncols())) != sizes {
            return None;
        }
        let structure = Self::from_parts(s_dofs, flexibility, sag_of_weight, weight, spline, tip).ok()?;
        Some((structure, RigidInertia { motions, sag, mass, work }))
    }

    /// From given matrices, for structures that come as numbers (another code's, or truncated to some modes).
    ///
    /// # Errors
    /// If the spline uses a degree of freedom that `s_dofs` lacks, or the tip's is not among them.
    pub fn from_parts(
        s_dofs: Vec<usize>,
        flexibility: Mat<f64>,
        sag: Mat<f64>,
        weight: Mat<f64>,
        spline: &Spline,
        tip: usize,
    ) -> Result<Self, CouplingError> {
        let place = |dof: usize| {
            s_dofs.binary_search(&dof).map_err(|_| CouplingError::SplineOutsideStructure { dof })
        };
        let spline_rows = spline
            .rows()
            .iter()
            .map(|row| row.iter().map(|&(dof, value)| Ok((place(dof)?, value))).collect())
            .collect::<Result<Vec<Vec<(usize, f64)>>, CouplingError>>()?;
        let tip_z = place(6 * tip + 2)?;
        Ok(Self { s_dofs, flexibility, sag, weight, spline_rows, tip_z })
    }

    /// Size of the s-set.
    pub fn size(&self) -> usize {
        self.s_dofs.len()
    }

    /// `Gᵀ P`: loads on the s-set of box loads (two rows a box), column by column.
    pub fn gather(&self, p_k: MatRef<'_, f64>) -> Mat<f64> {
        let mut loads = Mat::zeros(self.size(), p_k.ncols());
        let mut block = vec![[0.0; COLUMNS]; self.size()];
        for first in (0..p_k.ncols()).step_by(COLUMNS) {
            let columns = first..p_k.ncols().min(first + COLUMNS);
            block.fill([0.0; COLUMNS]);
            for (row, entries) in self.spline_rows.iter().enumerate() {
                let mut p = [0.0; COLUMNS];
                p.iter_mut().zip(columns.clone()).for_each(|(p, column)| *p = p_k[(row, column)]);
                for &(dof, value) in entries {
                    block[dof].iter_mut().zip(p).for_each(|(sum, p)| *sum += value * p);
                }
            }
            for (at, column) in columns.enumerate() {
                let sums = block.iter().map(|sums| sums[at]);
                loads.col_as_slice_mut(column).iter_mut().zip(sums).for_each(|(load, sum)| *load = sum);
            }
        }
        loads
    }

    /// Dense s-columns of the k-set displacement: rows 2 a box.
    pub fn k_displacements(&self) -> Mat<f64> {
        let mut g = Mat::zeros(self.spline_rows.len(), self.size());
        for (row, entries) in self.spline_rows.iter().enumerate() {
            for &(dof, value) in entries {
                g[(row, dof)] += value;
            }
        }
        g
    }
}

/// The degrees of freedom that the spline uses and the tip's height, ascending.
fn s_set(spline: &Spline, tip: usize) -> Vec<usize> {
    let mut s_dofs = spline.used_dofs();
    if !s_dofs.contains(&(6 * tip + 2)) {
        s_dofs.push(6 * tip + 2);
        s_dofs.sort_unstable();
    }
    s_dofs
}

/// The rows `dofs` of a matrix.
pub fn restrict(matrix: MatRef<'_, f64>, dofs: &[usize]) -> Mat<f64> {
    Mat::from_fn(dofs.len(), matrix.ncols(), |row, column| matrix[(dofs[row], column)])
}

/// The symmetric part: a flexibility is symmetric, its solve only to round-off.
fn symmetric(f: &Mat<f64>) -> Mat<f64> {
    Mat::from_fn(f.nrows(), f.ncols(), |i, j| 0.5 * (f[(i, j)] + f[(j, i)]))
}
