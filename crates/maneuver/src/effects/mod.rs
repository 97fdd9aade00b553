//! Effects: what a wing in a tunnel may do that a panel model with corrections does not. One a file.
//!
//! Each is a term of the simulation of static points and of runs alike, with parameters in physical units, bounds and
//! what physics demands of them together. All parameters zero change nothing, bit for bit. An effect may act in five
//! places, in this order:
//! 1. [`Effect::inputs`]: what the angle sensor and the servos make of angle and commands;
//! 2. [`Effect::change`], [`Effect::constants`]: the linear wing (air, structure, masses) and what acts on it at rest;
//! 3. [`Effect::forces`]: forces that depend on the state (stall, hysteresis), iterated with the wing's answer;
//! 4. [`Effect::loads`]: what reaches the balance and what its amplifiers make of it.

mod active;
mod beside;
mod each;
mod flight;
mod library;
mod of_wing;
mod place;
mod signal;
mod spec;
mod travel;

pub use active::Active;
pub use beside::Beside;
pub use flight::{Flown, Model, Stimulus, fly};
pub use library::library;
pub use of_wing::{of_wing, without};
pub use place::{Forces, Inputs, Loads, Place, Seen};
pub use spec::{Parameter, Side, Spec, Stage};
pub use travel::{Carried, acting_deflection, carry};

use crate::rom::{Change, Constants};

/// See the module. `p` are values of [`Effect::parameters`], in their order and units.
pub trait Effect: std::fmt::Debug + Send + Sync {
    /// Name, side, rivals.
    fn spec(&self) -> &'static Spec;

    /// The parameters.
    fn parameters(&self) -> Vec<Parameter>;

    /// The form, where an effect has several: empty for the usual one.
    fn form(&self) -> &'static str {
        ""
    }

    /// Values from which a fit may begin, where small ones say nothing (an angle at which something sets in); none: from
    /// zero.
    fn starts(&self) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// Moves parameters (within their bounds already) to the nearest that physics allows together.
    fn constrain(&self, _p: &mut [f64]) {}

    /// Whether values are what the name says: a table may also take those of another effect.
    fn is_itself(&self, _p: &[f64]) -> bool {
        true
    }

    /// See the module.
    fn inputs(&self, _p: &[f64], _place: &Place<'_>, _inputs: &mut Inputs) {}

    /// See the module.
    fn change(&self, _p: &[f64], _place: &Place<'_>, _change: &mut Change) {}

    /// See the module.
    fn constants(&self, _p: &[f64], _place: &Place<'_>, _constants: &mut Constants) {}

    /// Whether lifts and heights of zones are needed in [`Effect::forces`] or [`Effect::loads`].
    fn needs_zones(&self) -> bool {
        false
    }

    /// See the module.
    fn forces(&self, _p: &[f64], _place: &Place<'_>, _seen: &Seen<'_>, _forces: &mut Forces) {}

    /// See the module.
    fn loads(&self, _p: &[f64], _place: &Place<'_>, _seen: &Seen<'_>, _loads: &mut Loads) {}

    /// Where on the way from the wing to the record [`Self::loads`] acts.
    fn stage(&self) -> Stage {
        Stage::Load
    }
}
