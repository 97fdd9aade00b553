//! One motion of a grid, as scalar elements and equations name it.

/// One motion of a grid: (grid, component 1 to 6); component 0 is the motion of a scalar point.
pub type Motion = (u32, u8);

/// Whether a motion keeps its sign in the mirror y = 0: that along y and rotations about x and z do not, which matters
/// where one card joins several motions.
pub(crate) fn keeps_sign((_, component): Motion) -> bool {
    matches!(component, 0 | 1 | 3 | 5)
}
