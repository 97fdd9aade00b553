//! The effects that are hidden, one a file, each in another form than the obvious one.
//!
//! An [`Effect`] acts where it acts in the tunnel: on the structure and the air of an airspeed ([`Effect::physics`]), between
//! command and servo, between servo and air, on separated flow, on the balance, in the data acquisition. Sizes of zero change nothing.

use crate::flown::{At, Flown};
use crate::physics::Physics;
use crate::separation::Separation;
use crate::strips::Strips;
use std::fmt::Debug;

mod ac_shift;
mod joiner_inertia;

/// What a wing is to an effect.
#[derive(Debug, Clone, Copy)]
pub struct WingView<'a> {
    /// Strips of the wing.
    pub strips: &'a Strips,
    /// Natural frequencies of the unchanged structure, rad/s.
    pub omega_rad_s: &'a [f64],
}

/// An effect with its parameters.
pub trait Effect: Debug + Send + Sync {
    /// Changes the wing at an airspeed (as the campaign says it), m/s.
    fn physics(&self, wing: WingView<'_>, v_m_s: f64, physics: &mut Physics) {
        let _ = (wing, v_m_s, physics);
    }

    /// Changes the commanded deflection of a control on its way to the servo, rad.
    fn command(&self, at: &At<'_>, control: usize, delta: &mut [f64]) {
        let _ = (at, control, delta);
    }

    /// Changes the deflection that the servo gives, rad.
    fn deflection(&self, at: &At<'_>, control: usize, delta: &mut [f64]) {
        let _ = (at, control, delta);
    }

    /// The flow that separates, if this effect is one.
    fn separation(&self) -> Option<Separation> {
        None
    }

    /// Whether loads and displacements of the zones are needed.
    fn needs_zones(&self) -> bool {
        false
    }

    /// Changes what reaches the balance.
    fn balance(&self, at: &At<'_>, flown: &mut Flown) {
        let _ = (at, flown);
    }

    /// Changes what the balance and the data acquisition make of it.
    fn sensor(&self, at: &At<'_>, flown: &mut Flown) {
        let _ = (at, flown);
    }
}

/// Signs that a parameter may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Positive.
    Plus,
    /// Negative.
    Minus,
    /// Either, half and half.
    Either,
}

/// A parameter as it is drawn: the modulus log-uniform between two ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Name with unit.
    pub name: &'static str,
    /// Smallest modulus.
    pub low: f64,
    /// Largest modulus.
    pub high: f64,
    /// Sign.
    pub sign: Sign,
    /// Whether it is a size: zero means no effect, and weak cases scale it. Others are a shape.
    pub size: bool,
}

impl Parameter {
    /// A size.
    pub(crate) const fn size(name: &'static str, low: f64, high: f64, sign: Sign) -> Self {
        Self { name, low, high, sign, size: true }
    }

    /// A shape.
    pub(crate) const fn shape(name: &'static str, low: f64, high: f64, sign: Sign) -> Self {
        Self { name, low, high, sign, size: false }
    }
}

/// A kind of effect.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// Name, as in the list of effects.
    pub name: &'static str,
    /// Whether a library may be expected to know it.
    pub in_library: bool,
    /// How its parameters are drawn.
    pub parameters: &'static [Parameter],
    /// Builds it from its parameters, in their order.
    pub make: fn(&[f64]) -> Box<dyn Effect>,
}

/// All kinds.
pub const KINDS: &[Kind] = &[ac_shift::KIND, joiner_inertia::KIND];

/// The kind with a name.
pub fn kind(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.name == name)
}
