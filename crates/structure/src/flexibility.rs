//! Displacements under loads: the stiffness factorised once, and what is loose if it cannot be.

use crate::factor::Factor;
use crate::system::System;
use faer::{Mat, MatRef};
use std::fmt;

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
        let factor = Factor::held(system.analysis(), system.stiffness());
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
