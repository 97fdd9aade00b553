//! An effect with values.

use super::effect::Effect;
use super::spec::Parameter;
use std::sync::Arc;

/// See the module.
#[derive(Debug, Clone)]
pub struct Active {
    /// The effect.
    pub effect: Arc<dyn Effect>,
    /// Values of its parameters, in their order and units.
    pub values: Vec<f64>,
}

impl Active {
    /// The effect with values brought into their bounds and to what physics allows.
    pub fn new(effect: Arc<dyn Effect>, values: &[f64]) -> Self {
        let mut active = Self { values: values.to_vec(), effect };
        active.project();
        active
    }

    /// The parameters.
    pub fn parameters(&self) -> Vec<Parameter> {
        self.effect.parameters()
    }

    /// Whether it does nothing.
    pub fn is_zero(&self) -> bool {
        self.values.iter().all(|value| *value == 0.0)
    }

    fn project(&mut self) {
        for (value, parameter) in self.values.iter_mut().zip(self.effect.parameters()) {
            *value = value.clamp(parameter.lower, parameter.upper);
        }
        self.effect.constrain(&mut self.values);
    }
}
