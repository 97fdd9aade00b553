//! What a search is given beside the measurements that it fits.

use crate::data::Dataset;
use crate::load_model::LoadModel;
use crate::rules::Rules;
use maneuver::effects::{Active, Effect};
use std::sync::Arc;

/// See the module.
#[derive(Debug)]
pub struct Setting<'a> {
    /// The data, with the rules by which they were read and are decided on.
    pub data: &'a Dataset,
    /// The wing in them.
    pub model: &'a dyn LoadModel,
    /// Model-form variants of the same wing: how far apart they are is a measure of how right either can be.
    pub variants: Vec<&'a dyn LoadModel>,
    /// The library.
    pub library: &'a [Arc<dyn Effect>],
    /// Calibrated parameters that stay uncertain, each at one standard deviation.
    pub uncertain: &'a [Active],
    /// How uncertain the corrections' directions are, as a share of what they are before any data: one if the campaign's own
    /// static points determine them, less if they were found with others.
    pub open_corrections: f64,
}

impl Setting<'_> {
    /// What decides.
    pub fn rules(&self) -> &Rules {
        &self.data.rules
    }
}
