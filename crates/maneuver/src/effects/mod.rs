//! Effects: what a wing in a tunnel may do that a panel model with corrections does not. One a file, in `library`.
//!
//! Each is a term of the simulation of static points and of runs alike, with parameters in physical units, bounds and
//! what physics demands of them together. All parameters zero change nothing, bit for bit. An effect may act in six
//! places, in this order:
//! 1. [`Effect::inputs`]: what the angle sensor and the servos are given of angle and commands;
//! 2. [`Effect::servos`]: the servos, which turn by the commands;
//! 3. [`Effect::surfaces`]: what the control surfaces make of the servos' angles;
//! 4. [`Effect::change`], [`Effect::constants`]: the linear wing (air, structure, masses) and what acts on it at rest;
//! 5. [`Effect::forces`]: forces that depend on the state (stall, hysteresis), iterated with the wing's answer;
//! 6. [`Effect::loads`]: what reaches the balance and what its amplifiers make of it.
//!
//! What is physical about an effect stands in its file, and nowhere else: also which test
//! knows it, and how well by the wing's file ([`Parameter::calibrated`], [`Known`]), what becomes of it in flight ([`Effect::flight`]), what it may not stand beside
//! ([`Effect::excludes_deflection_correction`]) and what looks like it ([`Spec::rivals`]).

mod active;
mod beside;
mod declaration;
mod effect;
mod flight;
mod flight_air;
mod library;
mod linear_flight;
mod model;
mod of_wing;
mod place;
mod prelude;
mod separation;
mod signal;
mod spec;
mod travel;

pub use active::Active;
pub use beside::Beside;
pub use effect::Effect;
pub use flight::{Flown, fly, fly_beside, fly_first};
pub use flight_air::{Flight, FlightAir};
pub use library::{library, library_with};
pub use linear_flight::LinearFlight;
pub use model::{Model, Stimulus};
pub use of_wing::{of_wing, without};
pub use place::{Forces, Inputs, Loads, Needs, Place, WingState};
pub use spec::{Calibrated, Calibration, Known, Parameter, Side, Spec, Stage};
pub use travel::{Carried, acting_deflection, carry};
