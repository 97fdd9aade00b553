//! A bent wing's shorter arm and tilted lift, with the arc's own length (the obvious form: half the square of the
//! slope).

use super::{Kind, Parameter, Sign};
use crate::strips::ZONES;

pub(super) const KIND: Kind = Kind {
    name: "large_deflection",
    parameters: &[Parameter::size("scale", 0.3, 2.0, Sign::Plus)],
    needs_zones: |p| p[0] != 0.0,
    balance: |p, _, flown| {
        let (Some(zones), true) = (&flown.zones, p[0] != 0.0) else { return };
        for i in 0..flown.tip_z_m.len() {
            let (mut shorter_m, mut below) = (0.0, (0.0, 0.0));
            for zone in 0..ZONES {
                let here = (zones.y_m[zone], zones.height_m[zone][i]);
                let along = here.0 - below.0;
                let slope = ((here.1 - below.1) / along).clamp(-0.99, 0.99);
                // the arc keeps its length: its cosine is what of it lies along the span
                let level = (1.0 - slope * slope).sqrt();
                shorter_m += along * (1.0 - level);
                let lift = zones.lift_n[zone][i];
                flown.loads[0][i] -= p[0] * lift * (1.0 - level);
                // the lift leans inward with the wing and pushes at its height
                let raised = here.1 * slope;
                flown.loads[1][i] -= p[0] * lift * (shorter_m * level + here.0 * (1.0 - level) - raised);
                below = here;
            }
        }
    },
    ..Kind::NONE
};
