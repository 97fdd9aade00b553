//! A rigid body between balance and wing: inertia in pitch acceleration, and its weight in the tilting axes with sine and
//! cosine (the obvious form: linear in the angle).

use super::{Kind, Parameter, Sign};
use coupling::GRAVITY_M_S2;

pub(super) const KIND: Kind = Kind {
    name: "joiner_inertia",
    compared: Some(|values| {
        let joiner = Joiner::new(values[0], values[1], values[2]);
        let (mx, mz) = (joiner.aft_kg_m, joiner.up_kg_m);
        vec![("Iyy_kg_m2", joiner.inertia_kg_m2), ("mx_kg_m", mx), ("mz_kg_m", mz)]
    }),
    parameters: &[
        Parameter::size("Iyy_kg_m2", 0.01, 0.25, Sign::Plus),
        // lever of the mass over its radius of inertia; below one, or the body is impossible
        Parameter::shape("lever_share", 0.05, 0.7, Sign::Either),
        Parameter::shape("height_share", 0.05, 0.5, Sign::Either),
    ],
    balance: |p, at, flown| {
        let joiner = Joiner::new(p[0], p[1], p[2]);
        for (i, alpha) in at.alpha_rad.iter().enumerate() {
            let second = at.alpha_second[i];
            flown.loads[0][i] += joiner.aft_kg_m * second;
            // what is aft weighs nose up, less so as it tilts; what is above pulls aft as the nose rises
            let weight = joiner.aft_kg_m * (alpha.cos() - 1.0) + joiner.up_kg_m * alpha.sin();
            flown.loads[2][i] += -joiner.inertia_kg_m2 * second + GRAVITY_M_S2 * weight;
        }
    },
    ..Kind::NONE
};

/// Mass of the body, kg.
const MASS_KG: f64 = 4.0;

#[derive(Debug)]
pub(super) struct Joiner {
    inertia_kg_m2: f64,
    aft_kg_m: f64,
    up_kg_m: f64,
}

impl Joiner {
    fn new(inertia_kg_m2: f64, lever_share: f64, height_share: f64) -> Self {
        let radius_m = (inertia_kg_m2 / MASS_KG).max(0.0).sqrt();
        Self {
            inertia_kg_m2,
            aft_kg_m: MASS_KG * radius_m * lever_share,
            up_kg_m: MASS_KG * radius_m * height_share,
        }
    }
}
