//! Inputs and outputs of a [`ReducedOrderModel`](super::ReducedOrderModel), as columns and rows of its responses.

use super::{BALANCE, ReducedOrderModel};

/// Where drives stand among the columns of a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Drive {
    controls: usize,
    zones: usize,
}

impl Drive {
    /// Pitch of the root with everything it brings but gravity, per rad.
    pub const PITCH: usize = 0;
    /// Angle of attack of the air alone, per rad.
    pub const INCIDENCE: usize = 1;
    /// Gravity aft, per m/s².
    pub const G_SIN: usize = 2;
    /// Gravity down, per m/s².
    pub const G_COS: usize = 3;
    /// First control surface's deflection, behind its servo, per rad.
    pub const CONTROLS: usize = 4;
    /// How many modes may be driven by forces of their own.
    pub const DRIVEN_MODES: usize = 2;

    /// First zone's additional lift, per N.
    pub fn lifts(self) -> usize {
        Self::CONTROLS + self.controls
    }

    /// Force on the first mode, per N (modal).
    pub fn modal(self) -> usize {
        self.lifts() + self.zones
    }

    /// Number of drives, those of lift and modes included or not.
    pub fn len(self, everything: bool) -> usize {
        if everything { self.modal() + Self::DRIVEN_MODES } else { self.lifts() }
    }

    /// Never true.
    pub fn is_empty(self) -> bool {
        false
    }
}

/// Where outputs stand among the rows of a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outputs {
    zones: usize,
}

impl Outputs {
    /// Height of the tip, m; Fz, Mx, My come before it.
    pub const TIP: usize = BALANCE;

    /// Lift of the first zone, N.
    pub fn lifts(self) -> usize {
        BALANCE + 1
    }

    /// Height of the first zone, m.
    pub fn heights(self) -> usize {
        self.lifts() + self.zones
    }

    /// Twist of the first zone, nose up, rad.
    pub fn twists(self) -> usize {
        self.heights() + self.zones
    }

    /// Rows of the balance with the tip, of the zones' lifts, heights and twists.
    pub fn kinds(self) -> [std::ops::Range<usize>; 4] {
        [
            0..self.lifts(),
            self.lifts()..self.heights(),
            self.heights()..self.twists(),
            self.twists()..self.len(true),
        ]
    }

    /// Number of outputs, those of zones included or not.
    pub fn len(self, everything: bool) -> usize {
        if everything { self.twists() + self.zones } else { BALANCE + 1 }
    }

    /// Never true.
    pub fn is_empty(self) -> bool {
        false
    }
}

/// What acts on the wing at rest beside angle of attack, gravity and controls.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Constants {
    /// Pitching moment coefficient added everywhere.
    pub moment_coefficient: f64,
    /// Incidence growing along the span, rad/m.
    pub upwash_rad_m: f64,
}

impl ReducedOrderModel {
    /// Where drives stand.
    pub fn drive(&self) -> Drive {
        Drive { controls: self.controls.len(), zones: self.zones.len() }
    }

    /// Where outputs stand.
    pub fn outputs(&self) -> Outputs {
        Outputs { zones: self.zones.len() }
    }
}
