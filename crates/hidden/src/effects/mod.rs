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
mod act_lag;
mod act_rate;
mod added_mass;
mod aero_lag;
mod alpha_encoder;
mod alpha_offset;
mod backlash;
mod balance_creep;
mod balance_nonlin;
mod bend_stiff;
mod cable_stiffness;
mod camber;
mod crosstalk;
mod ctl_alpha_interaction;
mod ctl_asym;
mod ctl_compliance;
mod ctl_saturation;
mod ctl_scale;
mod damping;
mod daq_filter;
mod delay;
mod delta_offset;
mod drift;
mod filters;
mod flow_upwash_gradient;
mod friction;
mod gain;
mod inplane_force;
mod joiner_inertia;
mod large_deflection;
mod lift_slope;
mod mx_alpha_squared;
mod q_error;
mod re_dependence;
mod shedding_tone;
mod stall;
mod tip_loss;
mod tip_mass;
mod tors_stiff;
mod wing_mass_error;

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

    /// Changes what the angle sensor says, degrees.
    fn reading(&self, alpha_deg: &mut [f64]) {
        let _ = alpha_deg;
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
    /// What it is.
    pub role: Role,
}

/// What a parameter is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A size: zero means no effect, and weak cases scale it.
    Size,
    /// A shape.
    Shape,
    /// One of so many, from zero.
    Choice(usize),
}

impl Parameter {
    /// A size.
    pub(crate) const fn size(name: &'static str, low: f64, high: f64, sign: Sign) -> Self {
        Self { name, low, high, sign, role: Role::Size }
    }

    /// A shape.
    pub(crate) const fn shape(name: &'static str, low: f64, high: f64, sign: Sign) -> Self {
        Self { name, low, high, sign, role: Role::Shape }
    }

    /// One of `count`.
    pub(crate) const fn choice(name: &'static str, count: usize) -> Self {
        Self { name, low: 1.0, high: 1.0, sign: Sign::Plus, role: Role::Choice(count) }
    }
}

/// Names with unit and values that an estimate may be compared with, from the values of the parameters.
pub type Compared = fn(&[f64]) -> Vec<(&'static str, f64)>;

/// A kind of effect.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// Name, as in the list of effects.
    pub name: &'static str,
    /// Whether a library may be expected to know it.
    pub in_library: bool,
    /// Parameters with which an estimate may be compared, by name with unit, if they are not the sizes themselves.
    pub compared: Option<Compared>,
    /// How its parameters are drawn.
    pub parameters: &'static [Parameter],
    /// Builds it from its parameters, in their order.
    pub make: fn(&[f64]) -> Box<dyn Effect>,
}

/// All kinds.
pub const KINDS: &[Kind] = &[
    ac_shift::KIND,
    act_lag::KIND,
    act_rate::KIND,
    added_mass::KIND,
    aero_lag::KIND,
    alpha_encoder::KIND,
    alpha_offset::KIND,
    backlash::KIND,
    balance_creep::KIND,
    balance_nonlin::KIND,
    bend_stiff::KIND,
    cable_stiffness::KIND,
    camber::KIND,
    crosstalk::KIND,
    ctl_alpha_interaction::KIND,
    ctl_asym::KIND,
    ctl_compliance::KIND,
    ctl_saturation::KIND,
    ctl_scale::KIND,
    damping::KIND,
    daq_filter::KIND,
    delay::KIND,
    delta_offset::KIND,
    drift::KIND,
    flow_upwash_gradient::KIND,
    friction::KIND,
    gain::KIND,
    inplane_force::KIND,
    joiner_inertia::KIND,
    large_deflection::KIND,
    lift_slope::KIND,
    mx_alpha_squared::KIND,
    q_error::KIND,
    re_dependence::KIND,
    shedding_tone::KIND,
    stall::KIND,
    tip_loss::KIND,
    tip_mass::KIND,
    tors_stiff::KIND,
    wing_mass_error::KIND,
];

/// The kind with a name.
pub fn kind(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.name == name)
}

/// A drawn choice as an index.
fn chosen(value: f64, count: usize) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a choice is a small whole number"
    )]
    let index = value.max(0.0) as usize;
    index.min(count - 1)
}
