//! Another bending stiffness, more so outboard (the obvious form: one factor).

use super::{Kind, Parameter, Sign};
use crate::physics::Ends;

pub(super) const KIND: Kind = Kind {
    name: "bend_stiff",
    parameters: &[Parameter::size("dEI", 0.02, 0.45, Sign::Either)],
    physics: |p, _, _, physics| {
        physics.bending.add(Ends { root: 0.92 * p[0], tip: 1.16 * p[0] });
    },
    ..Kind::NONE
};
