//! Displacements under loads: the stiffness factorised once, and what is loose if it cannot be.
//!
//! The matrix is scaled to a unit diagonal and factorised as L D L^T with a fill-reducing order (faer, simplicial).
//! Pivot k is the energy x^T A x of the motion x = L^-T e_k, in which degree of freedom k moves by one and those
//! eliminated before it follow freely. Rounding the entries of A alone changes that energy by up to
//! eps |x|^T |A| |x|; a pivot that is not well above this cannot be told from zero, and its motion is loose. It is held
//! where it was found, so that the elimination goes on and names every further one.
//!
//! This file is the seam to faer's sparse factorisation; `sturm.rs` and `modes.rs` use `Factor`.

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
use faer::{Conj, Mat, MatRef, Par, Side, Spec};
use std::fmt;

/// Scaled pivots up to this one are held at once.
const LOOSE: f64 = 1e-14;

/// Scaled pivots above this one are beyond doubt.
const SUSPECT: f64 = 1e-4;

/// A pivot must exceed the effect of rounding the entries by this factor.
const MARGIN: f64 = 4.0;

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
    scaled: Sparse,
    /// Loose degrees of freedom, which were held ([`Factor::held`] only).
    pub(crate) loose: Vec<usize>,
}

impl Factor {
    /// Of a positive semidefinite matrix; what is loose is held and listed.
    pub(crate) fn held(a: SparseColMatRef<'_, usize, f64>) -> Self {
        let mut springs = Vec::new();
        loop {
            let mut factor = Self::with_springs(a, &springs);
            // One at a time: behind a loose pivot the others mean nothing.
            let next = factor.doubtful().into_iter().find(|dof| !factor.loose.contains(dof));
            let Some(dof) = next.filter(|dof| !springs.contains(dof)) else {
                factor.loose.extend(springs);
                return factor;
            };
            springs.push(dof);
        }
    }

    /// With springs to the ground at some degrees of freedom, as stiff as what they hold.
    fn with_springs(a: SparseColMatRef<'_, usize, f64>, springs: &[usize]) -> Self {
        let regularization = LdltRegularization {
            dynamic_regularization_signs: Some(&vec![1; a.ncols()]),
            dynamic_regularization_delta: HELD,
            dynamic_regularization_epsilon: LOOSE,
        };
        let mut factor = Self::new(a, &sparse::diagonal(a), springs, regularization)
            .expect("a positive pivot is put in the place of every other, and entries are finite");
        let loose = factor.pivots().into_iter().filter(|(_, pivot)| *pivot == HELD).map(|(dof, _)| dof);
        factor.loose = loose.collect();
        factor
    }

    /// Of an indefinite matrix, without pivoting; `None` if a pivot is exactly zero. `size` gives the scale of
    /// each degree of freedom.
    pub(crate) fn indefinite(a: SparseColMatRef<'_, usize, f64>, size: &[f64]) -> Option<Self> {
        Self::new(a, size, &[], LdltRegularization::default())
    }

    fn new(
        a: SparseColMatRef<'_, usize, f64>,
        size: &[f64],
        springs: &[usize],
        regularization: LdltRegularization<'_, f64>,
    ) -> Option<Self> {
        let scale: Vec<f64> = size.iter().map(|d| if *d > 0.0 { 1.0 / d.sqrt() } else { 1.0 }).collect();
        let scaled = scaled(a, &scale, springs);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic =
            factorize_symbolic_cholesky(scaled.symbolic(), Side::Lower, SymmetricOrdering::Amd, params)
                .expect("memory for the pattern of the factor");
        let mut values = vec![0.0; symbolic.len_val()];
        let mut memory =
            MemBuffer::new(symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default()));
        symbolic
            .factorize_numeric_ldlt(
                &mut values,
                scaled.as_ref(),
                Side::Lower,
                regularization,
                Par::Seq,
                MemStack::new(&mut memory),
                Spec::default(),
            )
            .ok()?;
        Some(Self { symbolic, values, scale, scaled, loose: Vec::new() })
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

    /// Degrees of freedom whose pivots cannot be told from zero, in the order of elimination.
    pub(crate) fn doubtful(&self) -> Vec<usize> {
        let pivots = self.pivots().into_iter().enumerate();
        let doubtful = pivots.filter(|(k, (_, d))| d.abs() < SUSPECT && d.abs() < self.rounding(*k));
        doubtful.map(|(_, (dof, _))| dof).collect()
    }

    /// What rounding may have done to pivot k: eps |x|^T |A| |x| with L^T x = e_k, times [`MARGIN`].
    fn rounding(&self, k: usize) -> f64 {
        let SymbolicCholeskyRaw::Simplicial(pattern) = self.symbolic.raw() else {
            return 0.0; // never: the simplicial form was asked for
        };
        let (columns, rows) = (pattern.col_ptr(), pattern.row_idx());
        let mut x = vec![0.0; pattern.ncols()];
        x[k] = 1.0;
        for j in (0..k).rev() {
            let below = columns[j] + 1..columns[j + 1];
            x[j] = -below.map(|at| self.values[at] * x[rows[at]]).sum::<f64>();
        }
        let mut motion = vec![0.0; x.len()];
        let order = self.symbolic.perm().map(|perm| perm.arrays().0);
        for (j, value) in x.iter().enumerate() {
            motion[order.map_or(j, |order| order[j])] = value.abs();
        }
        let mut energy = 0.0;
        for j in 0..motion.len() {
            for (i, value) in self.scaled.row_idx_of_col(j).zip(self.scaled.val_of_col(j)) {
                energy += motion[i] * value.abs() * motion[j];
            }
        }
        MARGIN * f64::EPSILON * energy
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

fn scaled(a: SparseColMatRef<'_, usize, f64>, scale: &[f64], springs: &[usize]) -> Sparse {
    let mut values = Vec::with_capacity(a.val().len());
    for j in 0..a.ncols() {
        for (i, value) in a.row_idx_of_col(j).zip(a.val_of_col(j)) {
            let spring = if i == j && springs.contains(&i) { 1.0 } else { 0.0 };
            values.push(scale[i] * value * scale[j] + spring);
        }
    }
    Sparse::new(a.symbolic().to_owned().expect("memory for a copy of the pattern"), values)
}
