//! Displacements under loads: the stiffness factorised once, and what is loose if it cannot be.
//!
//! The matrix is scaled to a unit diagonal and factorised as L D L^T with a fill-reducing order (faer, simplicial).
//! In the scaled matrix a pivot is the share of a degree of freedom's stiffness that is left when those eliminated
//! before it follow freely: a structure that is held has pivots down to about 1e-10 (a slender chain of a thousand
//! elements), a loose motion leaves round-off, below 1e-13. A pivot below [`LOOSE`] is therefore a loose motion; it
//! is held where it was found, so that the elimination goes on and names every further one.
//!
//! This file is the seam to faer's sparse factorisation; `sturm.rs` and `modes.rs` use [`Factor`].

use crate::sparse::{self, Sparse};
use crate::system::System;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::{Conj, Mat, MatRef, Par, Side};
use std::fmt;

/// Scaled pivots up to this one are loose motions.
pub(crate) const LOOSE: f64 = 1e-13;

/// What a loose pivot is replaced by: greater than any scaled pivot of a positive definite matrix, which is at most one.
const HELD: f64 = 2.0;

/// The structure can move without any force: which degrees of freedom are loose.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SingularStructure {
    /// Grid and component (1 to 6) at which each loose motion was found; holding all of them makes the structure
    /// stable. Any other grid that takes part in the same motion could be named as well.
    pub loose: Vec<(u32, u8)>,
}

impl fmt::Display for SingularStructure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 12;
        write!(f, "the structure is loose, {} motion(s) meet no stiffness: ", self.loose.len())?;
        for (at, (grid, component)) in self.loose.iter().take(SHOWN).enumerate() {
            let comma = if at == 0 { "" } else { ", " };
            write!(f, "{comma}GRID {grid} component {component}")?;
        }
        let more = self.loose.len().saturating_sub(SHOWN);
        if more > 0 {
            write!(f, " and {more} more")?;
        }
        write!(f, " (hint: clamp with SPC1, or look for a missing element or a pin flag too many)")
    }
}

impl std::error::Error for SingularStructure {}

/// The factorised stiffness of a structure.
#[derive(Debug)]
pub struct Flexibility {
    factor: Factor,
}

impl Flexibility {
    /// Factorises the stiffness of the free motions.
    ///
    /// # Errors
    /// If the structure can move without force.
    pub fn new(system: &System) -> Result<Self, SingularStructure> {
        let factor = Factor::held(system.stiffness());
        if factor.loose.is_empty() {
            return Ok(Self { factor });
        }
        Err(SingularStructure::at(system, &factor.loose))
    }

    /// Displacements (f-set; m, rad) under loads (f-set; N, Nm), one load case a column.
    ///
    /// # Panics
    /// If `loads_f` has not one row a free degree of freedom.
    pub fn displacements(&self, loads_f: MatRef<'_, f64>) -> Mat<f64> {
        self.factor.solve(loads_f)
    }
}

impl SingularStructure {
    /// With the names of free degrees of freedom.
    pub(crate) fn at(system: &System, free: &[usize]) -> Self {
        let mut loose: Vec<(u32, u8)> = free.iter().map(|dof| system.name(*dof)).collect();
        loose.sort_unstable();
        Self { loose }
    }
}

/// S A S = L D L^T with S the scaling to a unit diagonal.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    scale: Vec<f64>,
    /// Loose degrees of freedom, which were held ([`Factor::held`] only).
    pub(crate) loose: Vec<usize>,
}

impl Factor {
    /// Of a positive semidefinite matrix; what is loose is held and listed.
    pub(crate) fn held(a: SparseColMatRef<'_, usize, f64>) -> Self {
        let regularization = LdltRegularization {
            dynamic_regularization_signs: Some(&vec![1; a.ncols()]),
            dynamic_regularization_delta: HELD,
            dynamic_regularization_epsilon: LOOSE,
        };
        let mut factor = Self::new(a, &sparse::diagonal(a), regularization)
            .expect("a positive pivot is put in the place of every other, and entries are finite");
        let loose = factor.pivots().into_iter().filter(|(_, pivot)| *pivot == HELD).map(|(dof, _)| dof);
        factor.loose = loose.collect();
        factor
    }

    /// Of an indefinite matrix, without pivoting; `None` if a pivot is exactly zero. `size` gives the scale of
    /// each degree of freedom.
    pub(crate) fn indefinite(a: SparseColMatRef<'_, usize, f64>, size: &[f64]) -> Option<Self> {
        Self::new(a, size, LdltRegularization::default())
    }

    fn new(
        a: SparseColMatRef<'_, usize, f64>,
        size: &[f64],
        regularization: LdltRegularization<'_, f64>,
    ) -> Option<Self> {
        let scale: Vec<f64> = size.iter().map(|d| if *d > 0.0 { 1.0 / d.sqrt() } else { 1.0 }).collect();
        let scaled = scaled(a, &scale);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic =
            factorize_symbolic_cholesky(scaled.symbolic(), Side::Lower, SymmetricOrdering::Amd, params)
                .expect("memory for the pattern of the factor");
        let mut values = vec![0.0; symbolic.len_val()];
        let mut memory =
            MemBuffer::new(symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default()));
        symbolic
            .factorize_numeric_ldlt(
                &mut values,
                scaled.as_ref(),
                Side::Lower,
                regularization,
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .ok()?;
        Some(Self { symbolic, values, scale, loose: Vec::new() })
    }

    /// Degree of freedom and scaled pivot, in the order of elimination.
    pub(crate) fn pivots(&self) -> Vec<(usize, f64)> {
        let SymbolicCholeskyRaw::Simplicial(pattern) = self.symbolic.raw() else {
            return Vec::new(); // never: the simplicial form was asked for
        };
        let order = self.symbolic.perm().map(|perm| perm.arrays().0);
        let columns = pattern.col_ptr();
        // A column of L holds its pivot in the place of the unit diagonal.
        (0..pattern.ncols()).map(|j| (order.map_or(j, |order| order[j]), self.values[columns[j]])).collect()
    }

    /// A^-1 b.
    pub(crate) fn solve(&self, b: MatRef<'_, f64>) -> Mat<f64> {
        let mut x = Mat::from_fn(b.nrows(), b.ncols(), |i, j| self.scale[i] * b[(i, j)]);
        let mut memory = MemBuffer::new(self.symbolic.solve_in_place_scratch::<f64>(b.ncols(), Par::Seq));
        LdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            x.as_mut(),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        for j in 0..x.ncols() {
            for (i, scale) in self.scale.iter().enumerate() {
                x[(i, j)] *= scale;
            }
        }
        x
    }
}

fn scaled(a: SparseColMatRef<'_, usize, f64>, scale: &[f64]) -> Sparse {
    let mut values = Vec::with_capacity(a.val().len());
    for j in 0..a.ncols() {
        for (i, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
            values.push(scale[i] * value * scale[j]);
        }
    }
    Sparse::new(a.symbolic().to_owned().expect("memory for a copy of the pattern"), values)
}
