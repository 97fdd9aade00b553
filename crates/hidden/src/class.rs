//! What kinds of cases there are, and how many of each in a list.

use schemars::JsonSchema;
use serde::de::IntoDeserializer;
use serde::{Deserialize, Serialize};

/// What kind of case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// Nothing hidden.
    Null,
    /// One effect of any size.
    Single,
    /// One effect, scaled to a small detectability.
    Weak,
    /// Two effects.
    Pair,
    /// An effect that no library has.
    OutOfLibrary,
    /// An effect that is to be removed from the library.
    LeftOut,
    /// One of two that are easily taken for each other.
    LookAlike,
    /// Data at fault.
    Defect,
    /// Joiner and ailerons, as measured wings have them: each alone and both together, in turn.
    Paper,
    /// Joiner and ailerons together; in no list of several classes.
    PaperPair,
}

impl Class {
    /// Whether its effects have the sizes of measured wings.
    pub fn is_of_paper(self) -> bool {
        matches!(self, Self::Paper | Self::PaperPair)
    }
}

impl std::str::FromStr for Class {
    type Err = String;

    /// By the name that results have.
    fn from_str(name: &str) -> Result<Self, String> {
        let name: serde::de::value::StrDeserializer<'_, serde::de::value::Error> = name.into_deserializer();
        Self::deserialize(name).map_err(|error| error.to_string())
    }
}

/// Shares of the classes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Mix(pub Vec<(Class, f64)>);

impl Default for Mix {
    /// A third nulls.
    fn default() -> Self {
        Self(vec![
            (Class::Null, 34.0),
            (Class::Single, 30.0),
            (Class::Weak, 9.0),
            (Class::Pair, 8.0),
            (Class::LeftOut, 6.0),
            (Class::OutOfLibrary, 4.0),
            (Class::LookAlike, 4.0),
            (Class::Defect, 3.0),
            (Class::Paper, 2.0),
        ])
    }
}

impl Mix {
    /// One class alone.
    pub fn only(class: Class) -> Self {
        Self(vec![(class, 1.0)])
    }

    /// Classes of the first `count` cases, each with its number within the class: always the class that is furthest behind
    /// its share, so that a shorter list is the beginning of a longer one.
    pub(crate) fn classes(&self, count: usize) -> Vec<(Class, usize)> {
        let whole: f64 = self.0.iter().map(|(_, share)| share).sum();
        let mut given = vec![0_usize; self.0.len()];
        (1..=count)
            .filter_map(|so_far| {
                let behind = |i: usize| self.0[i].1 / whole * so_far as f64 - given[i] as f64;
                let next = (0..self.0.len()).reduce(|a, b| if behind(b) > behind(a) { b } else { a })?;
                given[next] += 1;
                Some((self.0[next].0, given[next] - 1))
            })
            .collect()
    }
}
