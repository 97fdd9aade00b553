//! Whether deflections of the wing are small.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What the places and directions of boxes and elements are taken from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum Geometry {
    /// The undeformed wing: deflections are small.
    #[default]
    Linear,
    /// The bent wing, in the commands that can (`statics`, `flutter`, `calibrate`, static cases of `tunnel`, steady points of `fullaircraft`); the others say that they take deflections as small.
    Nonlinear,
}

impl Geometry {
    /// Whether a file need not say it.
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "the signature serde calls")]
    pub(super) fn is_default(&self) -> bool {
        *self == Self::Linear
    }
}
