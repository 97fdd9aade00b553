//! Leading-edge suction and drag on the bent wing: from the lift coefficients of the zones (the obvious form: from
//! the angle of attack).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};
use std::f64::consts::TAU;

pub(super) const KIND: Kind = Kind {
    name: "inplane_force",
    in_library: true,
    compared: None,
    parameters: &[
        Parameter::size("k_s", 0.15, 1.2, Sign::Plus),
        Parameter::shape("cd0", 0.003, 0.02, Sign::Plus),
    ],
    make: |values| Box::new(InplaneForce { suction: values[0], drag: values[1] }),
};

#[derive(Debug)]
struct InplaneForce {
    suction: f64,
    drag: f64,
}

impl Effect for InplaneForce {
    fn needs_zones(&self) -> bool {
        self.suction != 0.0
    }

    fn balance(&self, at: &At<'_>, flown: &mut Flown) {
        let (Some(zones), true) = (&flown.zones, self.suction != 0.0) else { return };
        for (zone, area_m2) in zones.area_m2.iter().enumerate() {
            let pressed = (at.q_pa * area_m2).max(1e-9);
            for (i, my) in flown.loads[2].iter_mut().enumerate() {
                let cl = zones.lift_n[zone][i] / pressed;
                let aft_n = pressed * (self.drag * (1.0 + 0.3 * cl * cl) - self.suction * cl * cl / TAU);
                *my += aft_n * zones.height_m[zone][i];
            }
        }
    }
}
