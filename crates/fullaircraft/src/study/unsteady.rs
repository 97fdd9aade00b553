//! What a study says of modes and of unsteady air, for flutter and gusts alike.

use super::fault::Fault;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How half an aircraft moves.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Motion {
    /// Both halves alike; the set `spc` holds what is in the plane of symmetry accordingly.
    #[default]
    Symmetric,
    /// One against the other.
    Antisymmetric,
}

/// Modes and unsteady air, which flutter and gusts have in common.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Unsteady {
    /// Reduced frequencies, omega times the reference chord over twice the airspeed, at which air forces are computed (MKAERO1); none
    /// where the decks have MKAERO cards.
    #[serde(default)]
    pub reduced_frequencies: Vec<f64>,
    /// Number of modes from the slowest on, rigid ones included; without it and `up_to_hz` those of the decks' only EIGRL or EIGR, else ten.
    #[serde(default)]
    pub modes: Option<u32>,
    /// Highest natural frequency.
    #[serde(default)]
    pub up_to_hz: Option<f64>,
    /// Frequencies (Hz, rising) and the structural damping g there, twice the share of critical damping; of one point everywhere.
    #[serde(default)]
    pub damping: Vec<(f64, f64)>,
    /// How half an aircraft moves.
    #[serde(default)]
    pub motion: Motion,
}

impl Unsteady {
    /// What is wrong with it, if anything is.
    pub(super) fn fault(&self) -> Option<Fault> {
        let is_none = |k: &&f64| !(**k >= 0.0 && k.is_finite());
        if let Some(k) = self.reduced_frequencies.iter().find(is_none) {
            let message = format!("{k} where a reduced frequency of zero or more is expected");
            return Some(Fault::new("reduced_frequencies", message));
        }
        if self.modes == Some(0) {
            return Some(Fault::new("modes", "no modes: one or more move the air"));
        }
        if let Some(hz) = self.up_to_hz.filter(|hz| !(*hz > 0.0 && hz.is_finite())) {
            return Some(Fault::new("up_to_hz", format!("{hz} where a frequency above zero is expected")));
        }
        if self.damping.iter().any(|(hz, g)| !hz.is_finite() || !g.is_finite())
            || self.damping.windows(2).any(|pair| pair[0].0 >= pair[1].0)
        {
            return Some(Fault::new("unsteady.damping", "the frequencies of the damping do not rise"));
        }
        None
    }
}
