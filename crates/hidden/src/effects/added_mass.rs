//! Another apparent mass, more so inboard (the obvious form: one factor).

use super::{Effect, Kind, Parameter, Sign, WingView};
use crate::physics::Physics;

pub(super) const KIND: Kind = Kind {
    name: "added_mass",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("dam", 0.06, 0.9, Sign::Either)],
    make: |values| Box::new(AddedMass { change: values[0] }),
};

#[derive(Debug)]
struct AddedMass {
    change: f64,
}

impl Effect for AddedMass {
    fn physics(&self, wing: WingView<'_>, _v_m_s: f64, physics: &mut Physics) {
        for (factor, eta) in physics.apparent_mass.iter_mut().zip(&wing.strips.eta) {
            *factor *= 1.0 + self.change * (1.06 - 0.12 * eta);
        }
    }
}
