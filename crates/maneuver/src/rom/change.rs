//! Changes of a rig's air, structure and masses that keep it linear.

/// A mass that is fixed to the wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMass {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Distance from the root over the span, 0 to 1; it moves with the zone there.
    pub y_norm: f64,
    /// Distance aft of the quarter chord, in chords.
    pub aft_over_c: f64,
}

/// See the module; [`Change::none`] changes nothing. Factors are given as what is added to one.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// Added to the factor of the air's forces in each zone.
    pub zone_force: Vec<f64>,
    /// Lift acts so many chords further aft, by zone.
    pub zone_aft_over_c: Vec<f64>,
    /// Added to the factor of all forces of the air: dynamic pressure.
    pub pressure: f64,
    /// Added to the factor of the forces by angle of attack, by the modes' motion, and their rates.
    pub lift_slope: f64,
    /// Added to the factor of the wake's lag distances.
    pub lag: f64,
    /// Added to the factor of the unsteady part: all that air does beyond the steady answer to the momentary incidence.
    pub unsteady: f64,
    /// Added to the factor of apparent mass.
    pub apparent_mass: f64,
    /// Added to the factors of stiffness in bending and torsion.
    pub bending: f64,
    /// Of torsion.
    pub torsion: f64,
    /// Added to the factor of structural damping.
    pub damping: f64,
    /// Added to the factor of the wing's mass.
    pub mass: f64,
    /// Masses on the wing.
    pub points: Vec<PointMass>,
    /// Angle of attack per N m of My and per N of Fz (compliant balance, walls), rad.
    pub incidence_by_my: f64,
    /// Of Fz.
    pub incidence_by_fz: f64,
}

impl Change {
    /// Nothing changed, for a number of zones.
    pub fn none(zones: usize) -> Self {
        Self {
            zone_force: vec![0.0; zones],
            zone_aft_over_c: vec![0.0; zones],
            pressure: 0.0,
            lift_slope: 0.0,
            lag: 0.0,
            unsteady: 0.0,
            apparent_mass: 0.0,
            bending: 0.0,
            torsion: 0.0,
            damping: 0.0,
            mass: 0.0,
            points: Vec::new(),
            incidence_by_my: 0.0,
            incidence_by_fz: 0.0,
        }
    }

    /// Whether zones differ from each other or from one.
    pub(crate) fn by_zone(&self) -> bool {
        self.zone_force.iter().chain(&self.zone_aft_over_c).any(|value| *value != 0.0)
    }
}
