//! Sizes of what is hidden, larger and smaller.

use crate::effects::{Role, kind};
use crate::plan::Hidden;

/// The sizes of effects times a factor.
pub(crate) fn scaled(hidden: &[Hidden], factor: f64) -> Vec<Hidden> {
    let one = |hidden: &Hidden| {
        let mut scaled = hidden.clone();
        if let Some(kind) = kind(&hidden.name) {
            let sizes = kind.parameters.iter().zip(&mut scaled.values);
            sizes
                .filter(|(parameter, _)| parameter.role == Role::Size)
                .for_each(|(_, value)| *value *= factor);
        }
        scaled
    };
    hidden.iter().map(one).collect()
}
