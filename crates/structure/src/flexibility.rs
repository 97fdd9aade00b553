//! Displacements under loads: the stiffness factorised once, and which motions have no stiffness if it cannot be.

use crate::factor::{Factor, analysed};
use crate::sparse;
use crate::system::System;
use faer::{Mat, MatRef};
use rayon::prelude::*;
use std::fmt;
use std::sync::Arc;

/// The structure can move without any force (free-free, or a mechanism): which degrees of freedom have no stiffness.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SingularStructure {
    /// Grid and component (1 to 6) at which each loose motion was found; holding all of them makes the structure
    /// stable. Any other grid that takes part in the same motion could be named as well.
    pub loose: Vec<(u32, u8)>,
}

impl fmt::Display for SingularStructure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 12;
        write!(f, "the structure is free to move, {} motion(s) meet no stiffness: ", self.loose.len())?;
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

/// The factorised stiffness of a structure, each part that hangs together for itself: two wings held at the root know nothing
/// of each other.
#[derive(Debug)]
pub struct Flexibility {
    parts: Vec<Part>,
}

/// Free motions that hang together, ascending, and the factor of their stiffness.
#[derive(Debug)]
struct Part {
    dofs: Vec<usize>,
    factor: Factor,
}

impl Flexibility {
    /// Factorises the stiffness of the free motions.
    ///
    /// # Errors
    /// If the structure can move without force.
    pub fn new(system: &System) -> Result<Self, SingularStructure> {
        let k = system.stiffness();
        let components = sparse::components(k.symbolic());
        let whole = components.len() == 1;
        let part = |dofs: Vec<usize>| {
            let factor = if whole {
                Factor::held(system.analysis(), k)
            } else {
                let block = sparse::block(k, &dofs);
                Factor::held(&Arc::new(analysed(block.symbolic())), block.as_ref())
            };
            Part { dofs, factor }
        };
        let parts: Vec<Part> = components.into_par_iter().map(part).collect();
        let loose: Vec<usize> =
            parts.iter().flat_map(|part| part.factor.loose.iter().map(|at| part.dofs[*at])).collect();
        if loose.is_empty() {
            return Ok(Self { parts });
        }
        Err(SingularStructure::at(system, &loose))
    }

    /// Displacements (f-set; m, rad) under loads (f-set; N, Nm), one load case a column.
    ///
    /// # Panics
    /// If `loads_f` has not one row a free degree of freedom.
    pub fn displacements(&self, loads_f: MatRef<'_, f64>) -> Mat<f64> {
        let mut displaced = Mat::zeros(loads_f.nrows(), loads_f.ncols());
        for Part { dofs, factor } in &self.parts {
            let is_loaded = |j: &usize| dofs.iter().any(|dof| loads_f[(*dof, *j)] != 0.0);
            let loaded: Vec<usize> = (0..loads_f.ncols()).filter(is_loaded).collect();
            let own = Mat::from_fn(dofs.len(), loaded.len(), |i, j| loads_f[(dofs[i], loaded[j])]);
            let own = factor.solve(own.as_ref());
            for (j, column) in loaded.iter().enumerate() {
                for (i, dof) in dofs.iter().enumerate() {
                    displaced[(*dof, *column)] = own[(i, j)];
                }
            }
        }
        displaced
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
