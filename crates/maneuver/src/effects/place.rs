//! What effects see and change on their way through a simulation.

use crate::rig::Actuator;
use crate::rom::Zones;
use crate::smoothing::Smooth;
use aero::Flow;

/// Airspeed that effects which depend on dynamic pressure are referred to, m/s.
pub(super) const REFERENCE_V_M_S: f64 = 30.0;

/// Where and when.
#[derive(Debug, Clone, Copy)]
pub struct Place<'a> {
    /// The flow; at rest the airspeed is zero.
    pub flow: Flow,
    /// Zones of the wing.
    pub zones: &'a Zones,
    /// Names of the controls.
    pub controls: &'a [String],
    /// Time step, s.
    pub time_step_s: f64,
    /// Samples are separate static points, not a history.
    pub steady: bool,
    /// Clock time of the first sample, h.
    pub clock_h: f64,
    /// The servos.
    pub actuator: Actuator,
    /// Gravity, m/s².
    pub gravity_m_s2: f64,
    /// y of the balance, m.
    pub balance_y_m: f64,
    /// Height of the outermost zone in the first mode, and that mode's stiffness, (rad/s)²; zero for a rigid wing.
    pub outer_shape: f64,
    /// See above.
    pub first_stiffness: f64,
}

impl Place<'_> {
    /// Dynamic pressure over that at 30 m/s.
    pub fn q_over_reference(&self) -> f64 {
        (self.flow.v_m_s / REFERENCE_V_M_S).powi(2)
    }

    /// Dynamic pressure, Pa.
    pub fn q_pa(&self) -> f64 {
        self.flow.dynamic_pressure_pa()
    }
}

/// What drives the wing, sample by sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    /// Angle of attack of the balance with derivatives, rad; derivatives are zero at static points.
    pub alpha: Smooth,
    /// Additional angle of the stream alone, rad.
    pub incidence_rad: Vec<f64>,
    /// Commanded deflections, behind the servos those of the surfaces, in the wing's order, rad.
    pub controls_rad: Vec<Vec<f64>>,
}

impl Inputs {
    /// Turns the stream by an angle (rad), where there is one.
    pub(super) fn incline(&mut self, place: &Place<'_>, angle_rad: f64) {
        if place.flow.v_m_s > 0.0 {
            self.incidence_rad.iter_mut().for_each(|value| *value += angle_rad);
        }
    }

    /// Every deflection of every control surface, rad.
    pub(super) fn deflections(&mut self) -> impl Iterator<Item = &mut f64> {
        self.controls_rad.iter_mut().flatten()
    }
}

/// What an effect looks at of the zones: each output of a run that is asked for takes a transform of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each asks for one of a state's fields")]
pub struct Needs {
    /// [`WingState::lift_n`].
    pub lift: bool,
    /// [`WingState::height_m`].
    pub height: bool,
    /// [`WingState::outer_height_m`].
    pub outer_height: bool,
    /// [`WingState::twist_rad`].
    pub twist: bool,
}

impl Needs {
    /// Nothing.
    pub const NONE: Self = Self { lift: false, height: false, outer_height: false, twist: false };
    /// The lift of every zone.
    pub const LIFT: Self = Self { lift: true, ..Self::NONE };
    /// The height of the outermost zone.
    pub const OUTER_HEIGHT: Self = Self { outer_height: true, ..Self::NONE };

    /// What both look at.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            lift: self.lift || other.lift,
            height: self.height || other.height,
            outer_height: self.outer_height || other.outer_height,
            twist: self.twist || other.twist,
        }
    }
}

/// What the wing did.
#[derive(Debug, Clone, Copy)]
pub struct WingState<'a> {
    /// What drove it.
    pub inputs: &'a Inputs,
    /// Fz, Mx, My, N and N m, before any effect on the balance.
    pub loads: &'a [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_m: &'a [f64],
    /// Lift of every zone, N; empty unless asked for.
    pub lift_n: &'a [Vec<f64>],
    /// Height of every zone above its wind-off place at alpha = 0, m; empty unless asked for.
    pub height_m: &'a [Vec<f64>],
    /// That of the outermost zone, m; empty unless asked for.
    pub outer_height_m: &'a [f64],
    /// Elastic twist of every zone, nose up, rad; empty unless asked for.
    pub twist_rad: &'a [Vec<f64>],
}

impl WingState<'_> {
    /// Number of samples.
    pub fn len(&self) -> usize {
        self.inputs.alpha.value.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Forces beyond the linear wing's.
#[derive(Debug, Clone, PartialEq)]
pub struct Forces {
    /// Lift added in every zone, N.
    pub lift_n: Vec<Vec<f64>>,
    /// Force on the first modes (modal).
    pub modal: Vec<Vec<f64>>,
}

impl Forces {
    /// None.
    pub fn none(zones: usize, samples: usize) -> Self {
        Self {
            lift_n: vec![vec![0.0; samples]; zones],
            modal: vec![vec![0.0; samples]; crate::rom::Drive::DRIVEN_MODES],
        }
    }

    /// All of them, sample by sample.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> {
        self.lift_n.iter().chain(&self.modal).flatten().copied()
    }

    /// Adds to the force on the first mode by the height of the outermost zone (m), which stands for the tip: `force` gives
    /// from it a height (m) times the mode's stiffness. Nothing for a rigid wing.
    pub(super) fn push_first_mode(
        &mut self,
        place: &Place<'_>,
        state: &WingState<'_>,
        force: impl Fn(f64) -> f64,
    ) {
        if place.outer_shape == 0.0 {
            return;
        }
        for (modal, z) in self.modal[0].iter_mut().zip(state.outer_height_m) {
            *modal += force(*z) / place.outer_shape;
        }
    }
}

/// What the balance shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    /// Fz, Mx, My, N and N m.
    pub balance: [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_m: Vec<f64>,
}

impl Loads {
    /// Adds to each channel's readings what `added` makes of the channel's parameter, the sample's number and the reading.
    pub(super) fn add_to_readings(&mut self, p: &[f64], added: impl Fn(f64, usize, f64) -> f64) {
        for (channel, p) in self.balance.iter_mut().zip(p) {
            for (i, value) in channel.iter_mut().enumerate() {
                *value += added(*p, i, *value);
            }
        }
    }
}

#[cfg(test)]
mod tests;
