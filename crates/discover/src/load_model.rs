//! What a search asks of a model: the loads of a campaign's points and runs with effects.
//!
//! [`crate::simulator::Simulator`] flies the wing; a test may answer with columns that it knows.

use maneuver::effects::{Active, Flown, LinearFlight, Model};
use std::sync::{Arc, OnceLock};

/// Linear parts at every airspeed, and the first flights with them, from which flights with a little more take what is the same.
#[derive(Debug, Clone, Default)]
pub struct Models {
    pub(crate) parts: Vec<Arc<Model>>,
    /// By place among [`crate::data::Dataset::stimuli`].
    pub(crate) flights: Arc<[OnceLock<LinearFlight>]>,
}

/// See the module.
pub trait LoadModel: std::fmt::Debug + Sync {
    /// Linear parts for effects, those of `before` where they serve.
    fn models(&self, effects: &[Active], before: Option<&Models>) -> Models;

    /// Flies what is wanted of [`crate::data::Dataset::stimuli`] with linear parts made for the same effects.
    fn fly(&self, models: &Models, effects: &[Active], wanted: &[usize]) -> Vec<Flown>;

    /// Both steps.
    fn flown(&self, effects: &[Active], before: Option<&Models>, wanted: &[usize]) -> Vec<Flown> {
        self.fly(&self.models(effects, before), effects, wanted)
    }
}
