//! Which of three ways computes modes.

use crate::factor;

/// Structures of more than [`factor::SMALL`] motions are searched by block Lanczos, if no more than this part of the modes
/// is asked for.
const FEW: usize = 8;

/// Structures of no more motions that are held, if only by a shift, have all their modes computed at once, if more than that part is asked for:
/// a second for 600 motions, half a minute for the most.
const ALL: usize = 1500;

/// How modes are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    /// Few of many: block Lanczos.
    Lanczos,
    /// All: Jacobi rotations.
    Rotations,
    /// Subspace iteration.
    Sweeps,
}

impl Way {
    /// For `count` modes of `n` motions; `is_held` by the structure itself or by a shift, not by springs of ours.
    pub(super) fn of(n: usize, count: usize, shift: f64, is_held: bool) -> Self {
        match FEW * count <= n {
            true if n > factor::SMALL && shift == 0.0 => Self::Lanczos,
            false if n <= ALL && is_held => Self::Rotations,
            _ => Self::Sweeps,
        }
    }
}
