//! Families of twins: effects that a campaign of the benchmark cannot tell apart.

use nastran::{InputError, ron_file};
use serde::Deserialize;
use std::path::Path;

/// See the module; a frozen file.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Families {
    /// Day on which they were frozen.
    pub frozen: String,
    /// Groups of names; an effect in none is a family of its own.
    pub groups: Vec<Vec<String>>,
}

impl Families {
    /// The groups that the benchmark is scored with.
    ///
    /// # Errors
    /// A name that no effect has, or one in two groups.
    pub fn frozen() -> Result<Self, InputError> {
        let path = Path::new("families.ron");
        let families: Self = ron_file::parse("families.ron", include_str!("families.ron"))?;
        let mut seen: Vec<&String> = Vec::new();
        for name in families.groups.iter().flatten() {
            if crate::effects::kind(name).is_none() || seen.contains(&name) {
                return Err(InputError::in_file(path, format!("{name} is no effect, or in two groups"))
                    .with_help("list every effect once, by its name in the list of effects"));
            }
            seen.push(name);
        }
        Ok(families)
    }

    /// Whether two names are one effect or twins.
    pub fn are_kin(&self, one: &str, other: &str) -> bool {
        let both = |group: &Vec<String>| group.iter().any(|n| n == one) && group.iter().any(|n| n == other);
        one == other || self.groups.iter().any(both)
    }
}
