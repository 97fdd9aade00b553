//! Steady maneuvers of the wing and its image: they alone carry an aircraft at a load factor.

use super::GRAVITY_M_S2;
use super::coupled::Coupled;

/// Angle beyond which nothing is looked for, rad: sections are straight lines, and no wing is one there.
const MOST_RAD: f64 = 0.7;
/// Steps of the secant rule; one is enough where the wing is linear.
const STEPS: usize = 30;
/// The lift is found when it is off by less than this share of the weight.
const FOUND: f64 = 1e-9;

/// The wing in a steady maneuver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steady {
    /// Angle of the root against the flow, rad.
    pub alpha_rad: f64,
    /// Height of the tip over the plane of the root, m.
    pub tip_z_m: f64,
}

impl Coupled<'_> {
    /// Wing and image carry twice `half_mass_kg` at a load factor `n`: the lift of one is `n g half_mass_kg`, and all masses of the
    /// wing are pulled down by `n g`. Lift is along z and the air does not turn with the pitch rate (small angles). None where no angle
    /// within 0.7 rad has that lift.
    pub fn steady(&self, half_mass_kg: f64, load_factor: f64) -> Option<Steady> {
        let pull = load_factor * GRAVITY_M_S2;
        let asked_n = half_mass_kg * pull;
        let strips = &self.rig.lattice.strips;
        let at = |alpha_rad: f64| {
            let rest = self.pulled(alpha_rad, &[], pull);
            let lifts = strips.iter().zip(rest.lift_n.iter()).filter(|(strip, _)| strip.metric);
            (lifts.map(|(_, lift_n)| lift_n).sum::<f64>() - asked_n, rest)
        };
        let (mut before, mut alpha_rad) = (0.0, 0.05);
        let mut missed_before = at(before).0;
        for _ in 0..STEPS {
            let (missed_n, rest) = at(alpha_rad);
            if missed_n.abs() < FOUND * half_mass_kg * GRAVITY_M_S2 {
                let tip_z_m = rest.tip_z_m + self.structure.tip.dot(&self.structure.sag);
                return Some(Steady { alpha_rad, tip_z_m });
            }
            let step = missed_n * (alpha_rad - before) / (missed_n - missed_before);
            (before, missed_before) = (alpha_rad, missed_n);
            alpha_rad -= step;
            if !step.is_finite() || alpha_rad.abs() > MOST_RAD {
                return None;
            }
        }
        None
    }
}
