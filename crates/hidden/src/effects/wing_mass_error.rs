//! A distributed mass that is wrong, more so towards the tip (the obvious form: one factor).

use super::{Kind, Parameter, Sign};
use crate::physics::Ends;

pub(super) const KIND: Kind = Kind {
    name: "wing_mass_error",
    parameters: &[Parameter::size("dm_over_m", 0.01, 0.25, Sign::Either)],
    physics: |p, _, _, physics| {
        physics.mass.add(Ends { root: 0.85 * p[0], tip: 1.15 * p[0] });
    },
    ..Kind::NONE
};
