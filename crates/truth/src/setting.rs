//! What a true wing, and what is hidden in a case, change about the wing as drawn.

use crate::beam::Extra;
use crate::profile::Profile;

/// A loss of lift beyond an angle, strip by strip, that comes late.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stall {
    /// Angle beyond which incidence is lost, rad.
    pub angle_rad: f64,
    /// Share of the incidence beyond it that is lost.
    pub share: f64,
    /// Angle over which the loss begins, rad.
    pub knee_rad: f64,
    /// Time constant in chords travelled.
    pub chords: f64,
}

/// See the module. Factors are one and all else zero for the wing as drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Factor of the bending stiffness.
    pub bending: Profile,
    /// Factor of the torsional stiffness.
    pub torsion: Profile,
    /// Factor of the distributed mass and inertia.
    pub mass: Profile,
    /// How much further aft the distributed mass is, share of the chord.
    pub mass_aft_over_c: Profile,
    /// How much further aft and outward masses of the drawing are, m.
    pub lumps_moved_m: (f64, f64),
    /// Masses that are in no drawing.
    pub extras: Vec<Extra>,
    /// Damping of a mode over critical, by mode; the last holds for those beyond.
    pub damping: Vec<f64>,
    /// How damping grows: its relative change for an amplitude at the tip of a hundredth of the half span.
    pub damping_growth: f64,
    /// Play of the root in pitch, rad, which the moment takes up.
    pub slack_rad: f64,
    /// Factor of the sections' lift slope.
    pub slope: Profile,
    /// Shift of the sections' angle of zero lift, rad.
    pub zero_rad: Profile,
    /// Factor of the lift of strips, after the lattice.
    pub lift: Profile,
    /// Factor of the apparent mass of strips.
    pub apparent: Profile,
    /// How much further aft the lift of strips acts, share of the chord.
    pub aft_over_c: Profile,
    /// Incidence of the stream, rad.
    pub incidence_rad: Profile,
    /// Moment coefficient added to sections.
    pub moment: Profile,
    /// Factor of the incidence by a flap, by control.
    pub flap: Vec<f64>,
    /// Interference of the tunnel's walls: incidence at mid-span by the wing's lift coefficient, rad.
    pub wall_rad: f64,
    /// How much slower than the stream the wake drifts.
    pub wake_slower: f64,
    /// Airspeed over the one that is said.
    pub airspeed: f64,
    /// Flow that separates.
    pub stall: Option<Stall>,
}

impl Setting {
    /// The wing as drawn.
    pub fn drawn(damping_ratio: f64, controls: usize) -> Self {
        let (one, none) = (Profile::even(1.0), Profile::even(0.0));
        Self {
            bending: one.clone(),
            torsion: one.clone(),
            mass: one.clone(),
            mass_aft_over_c: none.clone(),
            lumps_moved_m: (0.0, 0.0),
            extras: Vec::new(),
            damping: vec![damping_ratio],
            damping_growth: 0.0,
            slack_rad: 0.0,
            slope: one.clone(),
            zero_rad: none.clone(),
            lift: one.clone(),
            apparent: one,
            aft_over_c: none.clone(),
            incidence_rad: none.clone(),
            moment: none,
            flap: vec![1.0; controls],
            wall_rad: 0.0,
            wake_slower: 0.0,
            airspeed: 1.0,
            stall: None,
        }
    }

    /// Damping of a mode over critical.
    pub(crate) fn damping_of(&self, mode: usize) -> f64 {
        self.damping.get(mode).or(self.damping.last()).copied().unwrap_or_default()
    }
}
