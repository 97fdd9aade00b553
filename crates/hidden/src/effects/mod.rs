//! The effects that are hidden, one a file, each in another form than the obvious one.
//!
//! An effect acts where it acts in the tunnel: on the structure and the air of an airspeed ([`Kind::physics`]), between
//! command and servo, between servo and air, on separated flow, on the balance, in the data acquisition. Sizes of zero change nothing.

use crate::flown::{At, Flown};
use crate::physics::Physics;
use crate::separation::Separation;
use crate::strips::Strips;

mod filters;

/// What a wing is to an effect.
#[derive(Debug, Clone, Copy)]
pub struct WingView<'a> {
    /// Strips of the wing.
    pub strips: &'a Strips,
    /// Natural frequencies of the unchanged structure, rad/s.
    pub omega_rad_s: &'a [f64],
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

/// A kind of effect: how it is drawn, and what it changes on the way from the wing to the record. Functions get the values of
/// the parameters, in their order; values of zero change nothing.
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
    /// Changes the wing at an airspeed (as the campaign says it), m/s.
    pub physics: fn(&[f64], WingView<'_>, f64, &mut Physics),
    /// Changes the commanded deflection of a control (by its index) on its way to the servo, rad.
    pub command: fn(&[f64], &At<'_>, usize, &mut [f64]),
    /// Changes the deflection that the servo gives, rad.
    pub deflection: fn(&[f64], &At<'_>, usize, &mut [f64]),
    /// The flow that separates, if this effect is one.
    pub separation: fn(&[f64]) -> Option<Separation>,
    /// Whether loads and displacements of the zones are needed.
    pub needs_zones: fn(&[f64]) -> bool,
    /// Changes what reaches the balance.
    pub balance: fn(&[f64], &At<'_>, &mut Flown),
    /// Changes what the angle sensor says, degrees.
    pub reading: fn(&[f64], &mut [f64]),
    /// Changes what the balance and the data acquisition make of it.
    pub sensor: fn(&[f64], &At<'_>, &mut Flown),
}

impl Kind {
    /// Changes nothing; of a kind that a library knows.
    const NONE: Self = Self {
        name: "",
        in_library: true,
        compared: None,
        parameters: &[],
        physics: |_, _, _, _| (),
        command: |_, _, _, _| (),
        deflection: |_, _, _, _| (),
        separation: |_| None,
        needs_zones: |_| false,
        balance: |_, _, _| (),
        reading: |_, _| (),
        sensor: |_, _, _| (),
    };
}

/// An effect with the values of its parameters.
#[derive(Debug, Clone)]
pub struct Effect {
    /// What it is.
    pub kind: &'static Kind,
    /// Values of its parameters, in their order.
    pub values: Vec<f64>,
}

/// Names the files of the kinds, once.
macro_rules! kinds {
    ($($file:ident),* $(,)?) => {
        $(mod $file;)*

        /// All kinds.
        pub const KINDS: &[Kind] = &[$($file::KIND),*];
    };
}

kinds![
    ac_shift,
    act_lag,
    act_rate,
    added_mass,
    aero_lag,
    alpha_encoder,
    alpha_offset,
    backlash,
    balance_creep,
    balance_nonlin,
    bend_stiff,
    cable_stiffness,
    camber,
    crosstalk,
    ctl_alpha_interaction,
    ctl_asym,
    ctl_compliance,
    ctl_saturation,
    ctl_scale,
    damping,
    daq_filter,
    delay,
    delta_offset,
    drift,
    flow_upwash_gradient,
    friction,
    gain,
    inplane_force,
    joiner_inertia,
    large_deflection,
    lift_slope,
    mx_alpha_squared,
    q_error,
    re_dependence,
    shedding_tone,
    stall,
    tip_loss,
    tip_mass,
    tors_stiff,
    wing_mass_error,
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
