//! Everything about the true wing that a case may change, as numbers: what jitter and effects edit before an airspeed's
//! linear system is assembled.

use crate::air::LAGS;
use crate::modal::ModalStructure;
use crate::strips::Strips;

/// A relative change at root and tip, linear between.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ends {
    /// At the root.
    pub root: f64,
    /// At the tip.
    pub tip: f64,
}

impl Ends {
    /// The same everywhere.
    pub fn everywhere(value: f64) -> Self {
        Self { root: value, tip: value }
    }

    /// Adds another change.
    pub fn add(&mut self, other: Self) {
        self.root += other.root;
        self.tip += other.tip;
    }
}

/// A mass on the wing without inertia of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMass {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Place along the span, share of the half span.
    pub eta: f64,
    /// Place along the chord, 0 at the leading edge.
    pub x_over_c: f64,
}

/// See the module. Neutral: factors one, offsets zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Physics {
    /// Relative change of EI.
    pub bending: Ends,
    /// Relative change of GJ.
    pub torsion: Ends,
    /// Relative change of the distributed mass.
    pub mass: Ends,
    /// Modal damping as a share of critical, one a mode.
    pub damping: Vec<f64>,
    /// Masses that are added.
    pub point_masses: Vec<PointMass>,
    /// Factor of every strip's loads but for its apparent mass.
    pub lift: Vec<f64>,
    /// Shift of the point where a strip's lift acts, aft, share of the chord.
    pub centre_aft_over_c: Vec<f64>,
    /// Lift coefficient added to a strip.
    pub lift_offset: Vec<f64>,
    /// Moment coefficient (nose up) added to a strip.
    pub moment_offset: Vec<f64>,
    /// Incidence added to a strip, to which the whole lattice answers, rad.
    pub incidence_rad: Vec<f64>,
    /// Factor of the loads by every control's deflection.
    pub flap: Vec<f64>,
    /// Factor of a strip's apparent mass.
    pub apparent_mass: Vec<f64>,
    /// Factor of what a strip's lags add.
    pub lag_amplitude: Vec<f64>,
    /// Factor of all that air does beyond the steady answer to the momentary incidence.
    pub unsteady: f64,
    /// How much further aft the loads of every control's deflection act, share of the chord.
    pub flap_aft_over_c: Vec<f64>,
    /// Shift of the distributed mass, aft, share of the chord.
    pub mass_aft_over_c: f64,
    /// Factor of every lag's rate.
    pub lag_rate: Vec<f64>,
    /// Factor of the airspeed that acts, where the campaign says another.
    pub airspeed: f64,
}

impl Physics {
    /// As the lattice and the beam are.
    pub(crate) fn neutral(
        structure: &ModalStructure,
        strips: &Strips,
        controls: usize,
        damping: f64,
    ) -> Self {
        let count = strips.len();
        Self {
            bending: Ends::default(),
            torsion: Ends::default(),
            mass: Ends::default(),
            damping: vec![damping; structure.omega_rad_s.len()],
            point_masses: Vec::new(),
            lift: vec![1.0; count],
            centre_aft_over_c: vec![0.0; count],
            lift_offset: vec![0.0; count],
            moment_offset: vec![0.0; count],
            incidence_rad: vec![0.0; count],
            flap: vec![1.0; controls],
            apparent_mass: vec![1.0; count],
            lag_amplitude: vec![1.0; count],
            unsteady: 1.0,
            flap_aft_over_c: vec![0.0; controls],
            mass_aft_over_c: 0.0,
            lag_rate: vec![1.0; LAGS],
            airspeed: 1.0,
        }
    }
}
