//! A rolling moment with the square of the angle of attack, which no library has.

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "mx_alpha_squared",
    in_library: false,
    compared: None,
    parameters: &[Parameter::size("k_m3", 0.05, 0.8, Sign::Either)],
    make: |values| Box::new(MxAlphaSquared { volume_m3: values[0] }),
};

#[derive(Debug)]
struct MxAlphaSquared {
    volume_m3: f64,
}

impl Effect for MxAlphaSquared {
    fn balance(&self, at: &At<'_>, flown: &mut Flown) {
        for (mx, alpha) in flown.loads[1].iter_mut().zip(at.alpha_rad) {
            *mx += self.volume_m3 * at.q_pa * alpha * alpha;
        }
    }
}
