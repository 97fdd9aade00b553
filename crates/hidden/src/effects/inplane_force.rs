//! Leading-edge suction and drag on the bent wing: from the lift coefficients of the zones (the obvious form: from
//! the angle of attack).

use super::{Kind, Parameter, Sign};
use std::f64::consts::TAU;

pub(super) const KIND: Kind = Kind {
    name: "inplane_force",
    parameters: &[
        Parameter::size("k_s", 0.15, 1.2, Sign::Plus),
        Parameter::shape("cd0", 0.003, 0.02, Sign::Plus),
    ],
    needs_zones: |p| {
        let suction = p[0];
        suction != 0.0
    },
    balance: |p, at, flown| {
        let (suction, drag) = (p[0], p[1]);
        let (Some(zones), true) = (&flown.zones, suction != 0.0) else { return };
        for (zone, area_m2) in zones.area_m2.iter().enumerate() {
            let pressed = (at.q_pa * area_m2).max(1e-9);
            for (i, my) in flown.loads[2].iter_mut().enumerate() {
                let cl = zones.lift_n[zone][i] / pressed;
                let aft_n = pressed * (drag * (1.0 + 0.3 * cl * cl) - suction * cl * cl / TAU);
                *my += aft_n * zones.height_m[zone][i];
            }
        }
    },
    ..Kind::NONE
};
