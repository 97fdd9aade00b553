//! Cables across the balance that pull back, stiffening with the angle (the obvious form: a spring).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::{At, Flown};

pub(super) const KIND: Kind = Kind {
    name: "cable_stiffness",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("k_c_Nm_per_rad", 0.5, 20.0, Sign::Plus)],
    make: |values| Box::new(CableStiffness { spring_nm_rad: values[0] }),
};

#[derive(Debug)]
struct CableStiffness {
    spring_nm_rad: f64,
}

impl Effect for CableStiffness {
    fn balance(&self, at: &At<'_>, flown: &mut Flown) {
        for (my, alpha) in flown.loads[2].iter_mut().zip(at.alpha_rad) {
            *my -= self.spring_nm_rad * alpha * (1.0 + 2.0 * alpha * alpha);
        }
    }
}
