//! What results depend on beside the case: each input by name with a fingerprint, and the program's version.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::fingerprint::Fingerprint;

/// Name of the program among the inputs.
const PROGRAM: &str = "program";

/// Inputs by name, each with a fingerprint; the program is one of them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Inputs(BTreeMap<String, String>);

impl Default for Inputs {
    fn default() -> Self {
        Self(BTreeMap::from([(PROGRAM.to_owned(), crate::version::VERSION.to_owned())]))
    }
}

impl Inputs {
    /// With one more input, as text.
    #[must_use]
    pub fn with(mut self, name: &str, text: &str) -> Self {
        self.0.insert(name.to_owned(), Fingerprint::default().with(text.as_bytes()).to_string());
        self
    }

    /// Names of what differs from others.
    pub(super) fn differs(&self, others: &Self) -> Vec<String> {
        let names = self.0.keys().chain(others.0.keys().filter(|name| !self.0.contains_key(*name)));
        names.filter(|name| self.0.get(*name) != others.0.get(*name)).cloned().collect()
    }
}

impl From<&str> for Inputs {
    fn from(text: &str) -> Self {
        Self::default().with("inputs", text)
    }
}

impl From<&String> for Inputs {
    fn from(text: &String) -> Self {
        Self::from(text.as_str())
    }
}
